//! Speed for accuracy: limits of error and time, `glint trade`, and its report in a browser.
//!
//! The browser is Chromium (`chromium`, or what CHROMIUM names). Without it its test says so and passes, unless
//! GLINT_REQUIRE_CHROMIUM is set.

mod process;

use process::*;
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

const LIT: &str = "
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 }
light_source { <3, 5, -4> rgb 1 area_light x, z, 3, 3 }
plane { y, -1 pigment { checker rgb 1 rgb 0.2 } }
sphere { 0, 1 pigment { rgb <1, 0.2, 0.1> } finish { reflection 0.3 } }
";

/// A script that a copy of the page gets: it clicks headings and writes down what it finds.
const PROBE: &str = r#"<pre id="found"></pre><script>
const heads = [...document.querySelectorAll('#rows th')];
const column = k => [...document.querySelectorAll('#rows tbody tr')].map(r => r.cells[k].textContent);
const found = {};
found.points = document.querySelectorAll('#plot circle.point').length;
found.rows = column(0).length;
found.plotHeight = document.querySelector('#plot').getBoundingClientRect().height;
found.loaded = [...document.images].every(i => i.complete && i.naturalWidth > 0);
found.pictures = document.images.length;
heads[1].click(); found.up = column(1).map(Number);
heads[1].click(); found.down = column(1).map(Number);
heads[0].click(); found.names = column(0);
found.fetched = performance.getEntriesByType('resource').map(e => e.name).filter(n => !n.startsWith('data:'));
document.querySelector('#found').textContent = JSON.stringify(found);
</script></body>"#;

fn chromium() -> Option<PathBuf> {
    let name = std::env::var("CHROMIUM").unwrap_or_else(|_| "chromium".into());
    let works = Command::new(&name).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    if works.is_ok_and(|s| s.success()) {
        return Some(name.into());
    }
    assert!(std::env::var_os("GLINT_REQUIRE_CHROMIUM").is_none(), "{name} is missing");
    println!("skipped: {name} is not installed");
    None
}

/// The page's elements after its scripts have run.
fn dom(chromium: &Path, folder: &Path, page: &Path) -> String {
    let output = Command::new(chromium)
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--virtual-time-budget=5000", "--dump-dom"])
        .arg("--host-resolver-rules=MAP * ~NOTFOUND")
        .arg(format!("--user-data-dir={}", folder.join("profile").display()))
        .arg(format!("file://{}", page.display()))
        .output()
        .unwrap();
    String::from_utf8_lossy(&output.stdout).into_owned()
}

#[test]
fn the_report_works_in_a_browser() {
    let Some(chromium) = chromium() else { return };
    let folder = std::env::temp_dir().join(format!("glint-report-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join("a.pov"), LIT).unwrap();
    let done = Command::new(env!("CARGO_BIN_EXE_glint"))
        .current_dir(&folder)
        .args(["trade", "a.pov", "-W96", "-H72", "--budget=15s", "--report=trade.html", "--json", "-q"])
        .output()
        .unwrap();
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let json: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
    let rows = json["rows"].as_array().unwrap().len();
    let page = std::fs::read_to_string(folder.join("trade.html")).unwrap();
    let probed = folder.join("probed.html");
    std::fs::write(&probed, page.replace("</body>", PROBE)).unwrap();
    let dom = dom(&chromium, &folder, &probed);
    let found = dom.split("<pre id=\"found\">").nth(1).and_then(|t| t.split("</pre>").next());
    let found: serde_json::Value = serde_json::from_str(found.unwrap()).unwrap();
    assert_eq!((&found["points"], &found["rows"]), (&rows.into(), &rows.into()), "{found}");
    assert!(found["plotHeight"].as_f64().unwrap() > 300.0, "{found}");
    assert!(found["pictures"].as_u64().unwrap() >= 4 && found["loaded"] == true, "{found}");
    let numbers = |name: &str| -> Vec<f64> {
        found[name].as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect()
    };
    let (up, down) = (numbers("up"), numbers("down"));
    assert!(up.is_sorted() && down.iter().rev().is_sorted() && up.first() < up.last(), "{found}");
    let names = found["names"].as_array().unwrap();
    assert!(names.first().unwrap().as_str() < names.last().unwrap().as_str(), "{found}");
    assert_eq!(found["fetched"].as_array().unwrap().len(), 0, "{found}");
    let _ = std::fs::remove_dir_all(&folder);
}

/// A converged render says so; one that time ended says how to make the same picture again.
#[test]
fn limits_of_error_and_time_are_kept() {
    let folder = Folder::new("accuracy");
    folder.write("a.pov", SPHERE);
    let report = |args: &[&str]| -> Value {
        let done = folder.glint(&[&["render", "a.pov", "-q", "--json"], args].concat());
        assert_eq!(code(&done), Some(0), "{}", stderr(&done));
        serde_json::from_str(&stdout(&done)).unwrap()
    };
    let good = report(&["-W80", "-H60", "--max-error=40dB"]);
    assert_eq!(good["adaptive"]["ended"], "converged");
    assert!(good["adaptive"]["rmse_estimate"].as_f64().unwrap() <= 0.01);
    assert!(good["adaptive"]["repeat"].is_null());
    let timed = report(&["-W1200", "-H900", "--time-limit=2s", "-o", "timed.png"]);
    assert_eq!(timed["adaptive"]["ended"], "time");
    let samples = format!("--max-samples={}", timed["adaptive"]["samples"]);
    assert!(timed["adaptive"]["repeat"].as_str().unwrap().ends_with(&samples), "{timed}");
    report(&["-W1200", "-H900", &samples, "-o", "again.png"]);
    let bytes = |name: &str| std::fs::read(folder.path(name)).unwrap();
    assert!(bytes("timed.png") == bytes("again.png"));
}

/// Every row of a trade is what its command makes.
#[test]
fn the_trade_has_the_promised_names() {
    let folder = Folder::new("trade");
    folder.write("a.pov", SPHERE);
    let cache = ["--cache", "kept"];
    let args =
        ["trade", "a.pov", "-W64", "-H48", "--budget=20s", "--settings=aa,trace-level", "--json", "-q"];
    let done = folder.glint(&[&args[..], &cache].concat());
    assert_eq!(code(&done), Some(0), "{}", stderr(&done));
    let trade: Value = serde_json::from_str(&stdout(&done)).unwrap();
    assert_eq!(trade["scene"], "a.pov");
    assert!(trade["wall_s"].as_f64().unwrap() < 1.2 * 20.0);
    let number = |v: &Value| v.as_f64().unwrap_or_else(|| panic!("{v}"));
    assert!(number(&trade["reference"]["samples"]) > 64.0 * 48.0);
    assert!(number(&trade["reference"]["rmse_estimate"]) > 0.0);
    let rows = trade["rows"].as_array().unwrap();
    for row in rows {
        for name in ["cpu_s", "wall_s", "rmse", "psnr_db", "perceptual", "worst_tile_rmse"] {
            assert!(number(&row[name]) > 0.0, "{name}: {row}");
        }
        assert!(row["settings"].is_object() && row["on_front"].is_boolean());
    }
    assert!(rows.iter().any(|r| r["settings"]["trace_level"] == 1.0));
    let knee = &rows[trade["knee"].as_u64().unwrap() as usize];
    assert_eq!(knee["on_front"], true);
    // Two rows' pictures are as far apart as their commands' pictures.
    let words = |row: &Value| -> Vec<String> {
        row["command"].as_str().unwrap().split(' ').skip(1).map(str::to_owned).collect()
    };
    let picture = |row: &Value, name: &str| {
        let words = words(row);
        let mut words: Vec<&str> = words.iter().map(String::as_str).collect();
        words.extend(["-q", "--bits", "16", "-o", name]);
        assert_eq!(code(&folder.glint(&words)), Some(0));
    };
    let finest = rows.iter().min_by(|a, b| number(&a["rmse"]).total_cmp(&number(&b["rmse"]))).unwrap();
    picture(&rows[0], "rough.png");
    picture(finest, "fine.png");
    let compared = folder.glint(&["compare", "rough.png", "fine.png", "--json"]);
    let compared: Value = serde_json::from_str(&stdout(&compared)).unwrap();
    let ratio = number(&compared["light"]["rmse"]) / number(&rows[0]["rmse"]);
    assert!((0.9..1.1).contains(&ratio), "{ratio}");
    assert_eq!(std::fs::read_dir(folder.path("kept")).unwrap().count(), 1);
}
