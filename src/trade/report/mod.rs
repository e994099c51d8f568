//! The measurement as one web page that needs nothing else: plot, table, pictures side by side.

mod crops;
mod plot;

use super::sweep::{Measurement, Row};
use crate::picture::Encoding;
use crate::picture::embed::escaped;
use crate::picture::light::decibels;
use std::fmt::Write;

/// The page about one scene.
pub fn page(scene: &str, measurement: &Measurement, encoding: &Encoding) -> String {
    let mut html = format!("{HEAD}<h1>Speed against accuracy: {}</h1>", escaped(scene));
    html.push_str(&summary(measurement));
    html.push_str(&plot::svg(measurement));
    html.push_str(&table(measurement));
    html.push_str(&crops::section(measurement, encoding));
    html.push_str(TAIL);
    html
}

fn summary(m: &Measurement) -> String {
    let r = &m.reference;
    let quality = decibels(r.rmse_estimate).map_or("exact".to_owned(), |db| format!("{db:.1} dB"));
    let mut html = format!(
        "<p>Pictures of {}x{} pixels, held against one of {} samples ({:.0} a pixel) that is expected to be \
         off by {:.5} ({quality}). Errors are RMSE in light clipped to 0..1.</p>",
        m.size.width,
        m.size.height,
        r.samples,
        r.samples as f64 / m.size.pixels(),
        r.rmse_estimate,
    );
    if m.reduced {
        html.push_str(
            "<p class=\"note\">These pictures are smaller than asked for, so that all of them fitted the \
             budget. A larger picture takes time in proportion to its pixels; its error is smaller, because \
             fewer of its pixels hold an edge. Which settings are better than others stays the same where \
             details are not much smaller than these pixels.</p>",
        );
    }
    if let Some(row) = m.knee.map(|k| &m.rows[k]) {
        let _ = write!(
            html,
            "<p>From <b>{}</b> on ({:.3} CPU s, error {:.5}) more time buys clearly less:<br><code>{}</code></p>",
            escaped(&row.name),
            row.cpu_s,
            row.rmse,
            escaped(&row.command)
        );
    }
    if !m.left_out.is_empty() {
        let names: Vec<String> = m.left_out.iter().map(|n| escaped(n)).collect();
        let _ = write!(html, "<p class=\"note\">Not tried for want of time: {}.</p>", names.join("; "));
    }
    html
}

fn table(m: &Measurement) -> String {
    let mut html = String::from(TABLE_HEAD);
    for (i, row) in m.rows.iter().enumerate() {
        write_row(&mut html, row, m.knee == Some(i));
    }
    html.push_str("</tbody></table>\n");
    html
}

fn write_row(html: &mut String, row: &Row, is_knee: bool) {
    let front = match (is_knee, row.on_front) {
        (true, _) => "knee",
        (_, true) => "front",
        _ => "",
    };
    let psnr = row.psnr_db.map_or("equal".into(), |db| format!("{db:.2}"));
    let perceptual = row.perceptual.map_or("-".into(), |p| format!("{p:.4}"));
    let _ = writeln!(
        html,
        "<tr class=\"{front}\"><td>{}</td><td>{:.4}</td><td>{:.4}</td><td>{:.5}</td><td>{psnr}</td>\
         <td>{perceptual}</td><td>{:.5}</td><td>{front}</td><td><code>{}</code></td></tr>",
        escaped(&row.name),
        row.cpu_s,
        row.wall_s,
        row.rmse,
        row.worst_tile_rmse,
        escaped(&row.command),
    );
}

const HEAD: &str = r#"<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'">
<title>Glint: speed against accuracy</title><style>
body { font: 14px/1.45 system-ui, sans-serif; margin: 1.5em auto; max-width: 1100px; padding: 0 1em; color: #222; background: #fafafa }
table { border-collapse: collapse; margin: 1em 0 } th, td { padding: 3px 9px; border-bottom: 1px solid #ddd; text-align: left }
th { cursor: pointer; position: sticky; top: 0; background: #eee; white-space: nowrap }
td:nth-child(n+2):nth-child(-n+7) { text-align: right; font-variant-numeric: tabular-nums }
tr.front td:first-child { border-left: 4px solid #2a7ab8 } tr.knee { background: #e4f0d8 } tr.knee td:first-child { border-left: 4px solid #4c8f1d }
code { font-size: 12px } .note { color: #666 } svg { background: #fff; border: 1px solid #ddd }
.crops { display: flex; flex-wrap: wrap; gap: 10px } figure { margin: 0; width: 200px } figcaption { font-size: 12px; color: #555 }
.crops img { width: 200px; image-rendering: pixelated; display: block; border: 1px solid #ccc }
</style></head><body>
"#;

const TABLE_HEAD: &str = "<h2>All settings</h2><p class=\"note\">A click on a heading sorts.</p>\
<table id=\"rows\"><thead><tr><th>settings</th><th>CPU s</th><th>wall s</th><th>RMSE</th><th>PSNR dB</th>\
<th>perceptual</th><th>worst tile</th><th>front</th><th>command</th></tr></thead><tbody>\n";

const TAIL: &str = r#"<script>
const body = document.querySelector('#rows tbody');
document.querySelectorAll('#rows th').forEach((th, column) => th.addEventListener('click', () => {
  const down = th.dataset.down = th.dataset.down === '1' ? '' : '1';
  const text = row => row.cells[column].textContent;
  const value = t => t === 'equal' ? Infinity : t === '-' ? -Infinity : parseFloat(t);
  const numbers = column > 0 && column < 7;
  const compare = (a, b) => numbers ? value(text(a)) - value(text(b)) || 0 : text(a).localeCompare(text(b));
  const rows = [...body.rows].sort(compare);
  (down ? rows : rows.reverse()).forEach(row => body.append(row));
}));
</script></body></html>
"#;
