//! The report as one file that needs nothing else.

use super::row::{Row, Status, Summary};
use crate::cli::compare::decibels;
use crate::picture::embed::{escaped, png_address};
use std::fmt::Write;

/// The page: a summary and a sortable table with the pictures side by side.
pub fn page(rows: &[Row], summary: &Summary, min_psnr: f64) -> String {
    let mut html = String::from(HEAD);
    let chips = Status::ALL.iter().map(|s| (s.name(), summary.by_status[s.name()]));
    let chips: String = chips.map(|(s, n)| format!("<span class=\"chip {s}\">{n} {s}</span> ")).collect();
    let _ = write!(
        html,
        "<h1>Cross-check</h1><p>{} scenes, a match from {min_psnr} dB on: {chips}</p>",
        rows.len()
    );
    if let Some(ratio) = summary.ratio_geometric_mean {
        let _ = write!(
            html,
            "<p>CPU seconds, Glint over POV-Ray: {ratio:.3} (geometric mean of {} matching scenes)</p>",
            summary.ratio_scenes
        );
    }
    html.push_str(TABLE_HEAD);
    for row in rows {
        write_row(&mut html, row);
    }
    html.push_str(TAIL);
    html
}

fn write_row(html: &mut String, row: &Row) {
    let number = |v: Option<f64>, digits: usize| v.map_or("-".into(), |v| format!("{v:.digits$}"));
    let psnr = if row.off_by_8_share.is_some() { decibels(row.psnr_db) } else { "-".into() };
    let notes: Vec<_> = row.message.iter().chain(&row.unsupported).map(|n| escaped(n)).collect();
    let status = row.status;
    let _ = write!(
        html,
        "<tr><td>{}</td><td><span class=\"chip {status}\">{status}</span></td><td>{psnr}</td><td>{}</td>\
         <td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>",
        escaped(&row.scene),
        number(row.off_by_8_share.map(|s| s * 100.0), 2),
        number(row.glint_parse_cpu_s.zip(row.glint_prepare_cpu_s).map(|(a, b)| a + b), 3),
        number(row.glint_trace_cpu_s, 3),
        number(row.povray_parse_cpu_s, 3),
        number(row.povray_trace_cpu_s, 3),
        number(row.ratio, 2),
        notes.join("<br>"),
    );
    for picture in &row.pictures {
        match picture {
            Some(png) => {
                let _ = write!(html, "<td><img src=\"{}\"></td>", png_address(png));
            }
            None => html.push_str("<td></td>"),
        }
    }
    html.push_str("</tr>\n");
}

const HEAD: &str = r#"<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Glint cross-check</title><style>
body { font: 14px/1.4 system-ui, sans-serif; margin: 1.5em; color: #222; background: #fafafa }
table { border-collapse: collapse } th, td { padding: 4px 8px; border-bottom: 1px solid #ddd; text-align: left; vertical-align: top }
th { cursor: pointer; position: sticky; top: 0; background: #eee } td:nth-child(n+3):nth-child(-n+9) { text-align: right; font-variant-numeric: tabular-nums }
img { display: block; image-rendering: pixelated } td:nth-child(10) { max-width: 22em }
.chip { padding: 1px 6px; border-radius: 6px; background: #ccc; white-space: nowrap }
.match { background: #b7e4b0 } .close { background: #fbe7a1 } .differs { background: #f7c29b }
.error, .timeout, .crash { background: #f2a5a5 } .reference_failed { background: #ccc }
</style></head><body>
"#;

const TABLE_HEAD: &str = "<table><thead><tr><th>scene</th><th>status</th><th>PSNR dB</th><th>off by 8, %</th>\
<th>Glint parse s</th><th>Glint trace s</th><th>POV-Ray parse s</th><th>POV-Ray trace s</th><th>ratio</th>\
<th>notes</th><th>POV-Ray</th><th>Glint</th><th>difference × 8</th></tr></thead><tbody>\n";

const TAIL: &str = r#"</tbody></table><script>
const body = document.querySelector('tbody');
document.querySelectorAll('th').forEach((th, column) => th.addEventListener('click', () => {
  const down = th.dataset.down = th.dataset.down === '1' ? '' : '1';
  const key = row => row.cells[column].textContent;
  const value = text => text === 'equal' ? Infinity : parseFloat(text);
  const compare = (a, b) => {
    const [x, y] = [value(key(a)), value(key(b))];
    const numbers = !Number.isNaN(x) && !Number.isNaN(y) && column > 1;
    return numbers ? (x === y ? 0 : x - y) : key(a).localeCompare(key(b));
  };
  const rows = [...body.rows].sort(compare);
  (down ? rows : rows.reverse()).forEach(row => body.append(row));
}));
</script></body></html>
"#;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_stands_alone() {
        let mut row = Row::new("<a>.pov".into());
        row.pictures[0] = Some(vec![1, 2, 3]);
        row.message = Some("x < y".into());
        let html = page(&[row.clone()], &Summary::of(&[row]), 38.0);
        for part in
            ["&lt;a&gt;.pov", "data:image/png;base64,AQID", "x &lt; y", "1 reference_failed", "<script>"]
        {
            assert!(html.contains(part), "{part}");
        }
        assert!(!html.contains("http"), "nothing is fetched");
    }
}
