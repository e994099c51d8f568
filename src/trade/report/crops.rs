//! Where pictures differ most, side by side.

use super::super::sweep::{Measurement, Row};
use crate::color::Rgb;
use crate::picture::embed::{escaped, png_address};
use crate::picture::{Encoding, Picture, png};
use std::fmt::Write;

/// Side of a crop.
const SIDE: u32 = 40;
/// How many places are shown.
const PLACES: usize = 3;
/// How many pictures are shown beside the reference.
const PICTURES: usize = 6;

/// The pictures at the places at which they differ most.
pub fn section(m: &Measurement, encoding: &Encoding) -> String {
    let rows = shown(m);
    let encoding = Encoding { bits: 8, alpha: false, ..*encoding };
    let mut html = String::from("<h2>Where they differ most</h2>\n");
    for (x, y) in places(m) {
        let _ = write!(
            html,
            "<h3>Around column {}, row {}</h3><div class=\"crops\">",
            x + SIDE / 2,
            y + SIDE / 2
        );
        figure(&mut html, &cut(&m.reference_picture, x, y), "reference", &encoding);
        for row in &rows {
            let caption = format!("{}: {:.3} CPU s", row.name, row.cpu_s);
            figure(&mut html, &cut(&row.picture, x, y), &caption, &encoding);
        }
        html.push_str("</div>\n");
    }
    html
}

fn figure(html: &mut String, picture: &Picture, caption: &str, encoding: &Encoding) {
    let Ok(bytes) = png::encode(picture, encoding) else { return };
    let _ = write!(
        html,
        "<figure><img src=\"{}\" alt=\"\"><figcaption>{}</figcaption></figure>",
        png_address(&bytes),
        escaped(caption)
    );
}

/// The front by time, thinned out; the knee is always among them.
fn shown(m: &Measurement) -> Vec<&Row> {
    let mut front: Vec<usize> = (0..m.rows.len()).filter(|&i| m.rows[i].on_front).collect();
    front.sort_by(|&a, &b| m.rows[a].cpu_s.total_cmp(&m.rows[b].cpu_s));
    while front.len() > PICTURES {
        // Ends and knee stay; of the others the one nearest to its neighbour in error goes.
        let step = |k: usize| m.rows[front[k]].rmse / m.rows[front[k - 1]].rmse.max(1e-12);
        let free = (1..front.len() - 1).filter(|&k| Some(front[k]) != m.knee);
        let Some(k) = free.max_by(|&a, &b| step(a).total_cmp(&step(b))) else { break };
        front.remove(k);
    }
    front.into_iter().map(|i| &m.rows[i]).collect()
}

/// Corners of the squares with the largest differences over all rows; they do not overlap.
fn places(m: &Measurement) -> Vec<(u32, u32)> {
    let (width, height) = (m.size.width, m.size.height);
    let (columns, lines) = (width.div_ceil(SIDE), height.div_ceil(SIDE));
    let mut squares: Vec<(f64, (u32, u32))> = Vec::new();
    for line in 0..lines {
        for column in 0..columns {
            let x = (column * SIDE).min(width.saturating_sub(SIDE));
            let y = (line * SIDE).min(height.saturating_sub(SIDE));
            squares.push((m.rows.iter().map(|r| difference(m, r, x, y)).sum(), (x, y)));
        }
    }
    squares.sort_by(|a, b| b.0.total_cmp(&a.0));
    squares.into_iter().take(PLACES).map(|s| s.1).collect()
}

fn difference(m: &Measurement, row: &Row, x: u32, y: u32) -> f64 {
    let clipped = |p: &Picture, x, y| p.get(x, y).rgb.clamp(Rgb::ZERO, Rgb::ONE);
    let mut sum = 0.0;
    for yy in y..(y + SIDE).min(m.size.height) {
        for xx in x..(x + SIDE).min(m.size.width) {
            let d = clipped(&row.picture, xx, yy) - clipped(&m.reference_picture, xx, yy);
            sum += f64::from(d.length_squared());
        }
    }
    sum
}

fn cut(picture: &Picture, x: u32, y: u32) -> Picture {
    let (width, height) = (SIDE.min(picture.width - x), SIDE.min(picture.height - y));
    let mut part = Picture::new(width, height);
    for yy in 0..height {
        for xx in 0..width {
            part.set(xx, yy, picture.get(x + xx, y + yy));
        }
    }
    part
}
