//! What `glint golden check` found, as one page that needs nothing else.

use super::check::Finding;
use crate::picture::embed::{escaped, png_address};
use std::fmt::Write;

/// The page: complaints first, with their pictures side by side, then all scenes.
pub fn page(findings: &[Finding]) -> String {
    let wrong: Vec<_> = findings.iter().filter(|f| f.said.is_err()).collect();
    let mut html = String::from(HEAD);
    let _ = writeln!(
        html,
        "<h1>Golden pictures</h1><p>{} looked at, <b>{} complaints</b></p>",
        findings.len(),
        wrong.len()
    );
    if !wrong.is_empty() {
        html.push_str("<table><tr><th>scene</th><th>complaint</th><th>stored</th><th>now</th>");
        html.push_str("<th>difference × 8</th></tr>\n");
        wrong.iter().for_each(|finding| write_complaint(&mut html, finding));
        html.push_str("</table>\n");
    }
    html.push_str("<details><summary>All that was looked at</summary><table>\n");
    for finding in findings {
        let (word, Ok(said) | Err(said)) =
            (if finding.said.is_ok() { "ok" } else { "failed" }, &finding.said);
        let cells = [word, &escaped(&finding.name), &escaped(said)].map(|c| format!("<td>{c}</td>"));
        let _ = writeln!(html, "<tr class=\"{word}\">{}</tr>", cells.concat());
    }
    html.push_str("</table></details></body></html>\n");
    html
}

fn write_complaint(html: &mut String, finding: &Finding) {
    let said = finding.said.as_ref().err().map_or("", String::as_str);
    let _ = write!(html, "<tr><td>{}</td><td>{}</td>", escaped(&finding.name), escaped(said));
    for png in finding.pictures.iter().flatten() {
        let _ = write!(html, "<td><img src=\"{}\"></td>", png_address(png));
    }
    html.push_str("</tr>\n");
}

const HEAD: &str = r#"<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Glint's golden pictures</title><style>
body { font: 14px/1.4 system-ui, sans-serif; margin: 1.5em; color: #222; background: #fafafa }
table { border-collapse: collapse } th, td { padding: 4px 8px; border-bottom: 1px solid #ddd; text-align: left; vertical-align: top }
img { display: block; image-rendering: pixelated } td:nth-child(2) { max-width: 26em }
.failed td:first-child { background: #f2a5a5 } .ok td:first-child { background: #b7e4b0 }
</style></head><body>
"#;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_stands_alone() {
        let good = Finding { name: "a.pov".into(), said: Ok("golden equal".into()), pictures: None };
        let pictures = Some([vec![1, 2, 3], vec![4], vec![5]]);
        let bad = Finding { name: "<b>.pov".into(), said: Err("differs".into()), pictures };
        let html = page(&[good, bad]);
        for part in ["&lt;b&gt;.pov", "base64,AQID", "1 complaints", "golden equal", "differs"] {
            assert!(html.contains(part), "{part}");
        }
        assert_eq!(html.matches("<img").count(), 3);
        assert!(!html.contains("http"), "nothing is fetched");
    }
}
