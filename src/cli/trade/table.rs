//! The measurement for people.

use crate::picture::light::decibels;
use crate::trade::sweep::{Measurement, Row};
use std::fmt::Write;

pub fn text(scene: &str, m: &Measurement) -> String {
    let r = &m.reference;
    let quality = decibels(r.rmse_estimate).map_or("exact".into(), |db| format!("{db:.1} dB"));
    let mut text = format!(
        "{scene}: {}x{} pixels{}, held against {:.0} samples a pixel expected to be off by {:.5} ({quality})\n\n",
        m.size.width,
        m.size.height,
        if m.reduced { " (smaller than asked for, to fit the budget)" } else { "" },
        r.samples as f64 / m.size.pixels(),
        r.rmse_estimate,
    );
    let widest = m.rows.iter().map(|r| r.name.len()).max().unwrap_or(0);
    let _ = writeln!(
        text,
        "  {:widest$}    CPU s   wall s     RMSE  PSNR dB  perceptual  worst tile",
        "settings"
    );
    let mut order: Vec<usize> = (0..m.rows.len()).collect();
    order.sort_by(|&a, &b| m.rows[a].cpu_s.total_cmp(&m.rows[b].cpu_s));
    for i in order {
        let mark = match (m.knee == Some(i), m.rows[i].on_front) {
            (true, _) => '>',
            (_, true) => '*',
            _ => ' ',
        };
        write_row(&mut text, &m.rows[i], mark, widest);
    }
    text.push_str(
        "\n* beaten by no other in time and error; > the knee: from here on more time buys clearly less\n",
    );
    if let Some(knee) = m.knee {
        let _ = writeln!(text, "\n{}", m.rows[knee].command);
    }
    text.push_str("\nEvery row's command:\n");
    for row in &m.rows {
        let _ = writeln!(text, "  {}", row.command);
    }
    if !m.left_out.is_empty() {
        let _ = writeln!(text, "\nNot tried for want of time: {}", m.left_out.join("; "));
    }
    text
}

fn write_row(text: &mut String, row: &Row, mark: char, widest: usize) {
    let psnr = row.psnr_db.map_or("equal".into(), |db| format!("{db:.2}"));
    let perceptual = row.perceptual.map_or("-".into(), |p| format!("{p:.4}"));
    let _ = writeln!(
        text,
        "{mark} {:widest$} {:8.3} {:8.3} {:8.5} {psnr:>8} {perceptual:>11} {:11.5}",
        row.name, row.cpu_s, row.wall_s, row.rmse, row.worst_tile_rmse
    );
}
