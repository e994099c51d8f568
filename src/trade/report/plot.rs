//! Time against error, both logarithmic, as SVG.

use super::super::Sampling;
use super::super::sweep::{Measurement, Row};
use crate::picture::embed::escaped;
use crate::render::Method;
use std::fmt::Write;

const WIDTH: f64 = 900.0;
const HEIGHT: f64 = 520.0;
const LEFT: f64 = 70.0;
const RIGHT: f64 = 20.0;
const TOP: f64 = 40.0;
const BOTTOM: f64 = 55.0;

/// Colours that people with colour blindness tell apart (Okabe and Ito, 2008).
const KINDS: [(&str, &str); 4] = [
    ("adaptive", "#0072b2"),
    ("method 1", "#d55e00"),
    ("method 2", "#009e73"),
    ("no anti-aliasing", "#555555"),
];

fn kind(row: &Row) -> usize {
    match row.settings.sampling {
        Sampling::Adaptive { .. } => 0,
        Sampling::Fixed { method: Method::Grid, .. } => 1,
        Sampling::Fixed { method: Method::Recursive, .. } => 2,
        Sampling::Centre => 3,
    }
}

/// A logarithmic axis.
struct Scale {
    low: f64,
    high: f64,
    from: f64,
    to: f64,
}

impl Scale {
    /// Holds all values with some room.
    fn new(values: impl Iterator<Item = f64>, from: f64, to: f64) -> Self {
        let (low, high) =
            values.filter(|v| *v > 0.0).fold((f64::INFINITY, 0.0f64), |(l, h), v| (l.min(v), h.max(v)));
        let (low, high) = if low.is_finite() { (low, high) } else { (0.1, 1.0) };
        Self { low: low / 1.25, high: high * 1.25, from, to }
    }

    fn place(&self, v: f64) -> f64 {
        let share = (v.max(self.low) / self.low).ln() / (self.high / self.low).ln();
        self.from + share * (self.to - self.from)
    }

    /// 1, 2 and 5 of every decade; of wide axes 1 alone.
    fn ticks(&self) -> Vec<f64> {
        let digits: &[f64] = if self.high / self.low > 2000.0 { &[1.0] } else { &[1.0, 2.0, 5.0] };
        let decades = self.low.log10().floor() as i32..=self.high.log10().ceil() as i32;
        let all = decades.flat_map(|d| digits.iter().map(move |m| m * 10f64.powi(d)));
        all.filter(|t| (self.low..=self.high).contains(t)).collect()
    }
}

pub fn svg(m: &Measurement) -> String {
    let x = Scale::new(m.rows.iter().map(|r| r.cpu_s), LEFT, WIDTH - RIGHT);
    let y = Scale::new(m.rows.iter().map(|r| r.rmse), HEIGHT - BOTTOM, TOP);
    let mut svg = format!(
        "<h2>Time against error</h2>\n<svg id=\"plot\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" width=\"{WIDTH}\" \
         height=\"{HEIGHT}\" role=\"img\" aria-label=\"CPU seconds against RMSE\" font-size=\"12\" \
         font-family=\"system-ui, sans-serif\">\n"
    );
    axes(&mut svg, &x, &y);
    front_line(&mut svg, m, &x, &y);
    for (i, row) in m.rows.iter().enumerate() {
        point(&mut svg, row, m.knee == Some(i), (x.place(row.cpu_s), y.place(row.rmse)));
    }
    legend(&mut svg);
    svg.push_str("</svg>\n");
    svg
}

fn axes(svg: &mut String, x: &Scale, y: &Scale) {
    let (bottom, right) = (HEIGHT - BOTTOM, WIDTH - RIGHT);
    for t in x.ticks() {
        let p = x.place(t);
        let _ = write!(
            svg,
            "<line x1=\"{p:.1}\" y1=\"{TOP}\" x2=\"{p:.1}\" y2=\"{bottom}\" stroke=\"#eee\"/>\
             <text x=\"{p:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{t}</text>",
            bottom + 18.0
        );
    }
    for t in y.ticks() {
        let p = y.place(t);
        let label = format!("{} ({:.0} dB)", trimmed(t), -20.0 * t.log10());
        let _ = write!(
            svg,
            "<line x1=\"{LEFT}\" y1=\"{p:.1}\" x2=\"{right}\" y2=\"{p:.1}\" stroke=\"#eee\"/>\
             <text x=\"{}\" y=\"{:.1}\">{label}</text>",
            LEFT + 4.0,
            p - 3.0
        );
    }
    let _ = writeln!(
        svg,
        "<rect x=\"{LEFT}\" y=\"{TOP}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#999\"/>\
         <text x=\"{}\" y=\"{}\" text-anchor=\"middle\">CPU seconds</text>\
         <text x=\"24\" y=\"{}\" text-anchor=\"middle\" transform=\"rotate(-90 24 {2})\">RMSE in light</text>",
        right - LEFT,
        bottom - TOP,
        (LEFT + right) / 2.0,
        HEIGHT - 12.0,
        (TOP + bottom) / 2.0,
    );
}

/// A tick without needless zeros or an exponent.
fn trimmed(v: f64) -> String {
    let text = format!("{v:.7}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn front_line(svg: &mut String, m: &Measurement, x: &Scale, y: &Scale) {
    let mut front: Vec<&Row> = m.rows.iter().filter(|r| r.on_front).collect();
    front.sort_by(|a, b| a.cpu_s.total_cmp(&b.cpu_s));
    let points: Vec<String> =
        front.iter().map(|r| format!("{:.1},{:.1}", x.place(r.cpu_s), y.place(r.rmse))).collect();
    let _ = writeln!(
        svg,
        "<polyline points=\"{}\" fill=\"none\" stroke=\"#2a7ab8\" stroke-width=\"1.5\" stroke-dasharray=\"5 4\"/>",
        points.join(" ")
    );
}

fn point(svg: &mut String, row: &Row, is_knee: bool, (x, y): (f64, f64)) {
    let color = KINDS[kind(row)].1;
    let title = escaped(&format!("{}: {:.3} CPU s, RMSE {:.5}", row.name, row.cpu_s, row.rmse));
    if is_knee {
        let _ = write!(
            svg,
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"11\" fill=\"none\" stroke=\"#4c8f1d\" stroke-width=\"2.5\"/>\
             <text x=\"{:.1}\" y=\"{:.1}\" fill=\"#4c8f1d\">knee</text>",
            x + 14.0,
            y + 4.0
        );
    }
    let fill = if row.on_front { color } else { "#fff" };
    let _ = writeln!(
        svg,
        "<circle class=\"point\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"5\" fill=\"{fill}\" stroke=\"{color}\" \
         stroke-width=\"2\"><title>{title}</title></circle>"
    );
}

fn legend(svg: &mut String) {
    for (i, (name, color)) in KINDS.iter().enumerate() {
        let x = LEFT + 10.0 + 150.0 * i as f64;
        let _ = write!(
            svg,
            "<circle cx=\"{x}\" cy=\"22\" r=\"5\" fill=\"{color}\"/><text x=\"{}\" y=\"26\">{name}</text>",
            x + 10.0
        );
    }
    let x = LEFT + 10.0 + 150.0 * KINDS.len() as f64;
    let _ = writeln!(svg, "<text x=\"{x}\" y=\"26\" fill=\"#666\">filled: beaten by none</text>");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_hold_their_values_between_ticks() {
        let scale = Scale::new([0.02, 0.9].into_iter(), 0.0, 100.0);
        assert!(scale.place(0.02) > 0.0 && scale.place(0.9) < 100.0);
        let ticks: Vec<String> = scale.ticks().into_iter().map(trimmed).collect();
        assert_eq!(ticks, ["0.02", "0.05", "0.1", "0.2", "0.5", "1"]);
        assert_eq!(Scale::new([1e-4, 10.0].into_iter(), 0.0, 1.0).ticks().len(), 6);
        assert!(Scale::new(std::iter::empty(), 0.0, 1.0).place(0.0).is_finite());
    }
}
