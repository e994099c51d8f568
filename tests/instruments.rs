//! The commands that compare: `crosscheck` and `golden`.

mod process;

use process::*;
use serde_json::Value;
use std::path::{Path, PathBuf};

/// A stand-in for POV-Ray: writes a given picture and the statistics.
#[cfg(unix)]
fn fake_povray(folder: &Folder, picture: &Path) -> PathBuf {
    use std::os::unix::fs::PermissionsExt;
    let text = format!(
        "#!/bin/sh\necho run >> {0}\nfor w in \"$@\"; do case $w in\n\
         --version) echo 'POV-Ray 3.7.test' >&2; exit 0;;\n\
         +Ibad.pov) echo 'Parse Error: no' >&2; exit 1;;\n\
         +O*) cp {1} \"${{w#+O}}\";;\nesac; done\n\
         echo '  Parse Time:       0 hours' >&2\necho ' using 1 thread(s) with 0.250 CPU-seconds total' >&2\n\
         echo '  Trace Time:       0 hours' >&2\necho ' using 1 thread(s) with 1.500 CPU-seconds total' >&2\n",
        folder.path("runs").display(),
        picture.display()
    );
    let program = folder.write("povray.sh", &text);
    std::fs::set_permissions(&program, std::fs::Permissions::from_mode(0o755)).unwrap();
    program
}

#[cfg(unix)]
#[test]
fn crosscheck_compares_with_the_other_program() {
    let folder = Folder::new("crosscheck");
    std::fs::create_dir(folder.path("s")).unwrap();
    folder.write("s/a.pov", SPHERE);
    folder.write("s/bad.pov", SPHERE);
    folder.write("s/wrong.pov", "sphere {");
    let done = folder.glint(&["render", "s/a.pov", "-W160", "-H120", "-q", "-o", "reference.png"]);
    assert_eq!(code(&done), Some(0), "{}", stderr(&done));
    let povray = fake_povray(&folder, &folder.path("reference.png"));
    let args = [
        "crosscheck",
        "s",
        "--povray",
        povray.to_str().unwrap(),
        "--cache",
        "cache",
        "--report",
        "r.html",
        "--json",
        "--min-match",
        "1",
    ];
    let done = folder.glint(&args);
    assert_eq!(code(&done), Some(0), "{}", stderr(&done));
    let report: Value = serde_json::from_slice(&done.stdout).unwrap();
    let rows = report["scenes"].as_array().unwrap();
    let statuses: Vec<_> = rows.iter().map(|r| r["status"].as_str().unwrap()).collect();
    assert_eq!(statuses, ["match", "reference_failed", "error"]);
    assert_eq!((&rows[0]["scene"], &rows[0]["psnr_db"]), (&"a.pov".into(), &Value::Null));
    assert_eq!((&rows[0]["povray_parse_cpu_s"], &rows[0]["povray_trace_cpu_s"]), (&0.25.into(), &1.5.into()));
    assert!(rows[0]["glint_trace_cpu_s"].as_f64().unwrap() > 0.0);
    assert_eq!((&report["summary"]["match"], &report["summary"]["error"]), (&1.into(), &1.into()));
    assert!(std::fs::read_to_string(folder.path("r.html")).unwrap().contains("data:image/png;base64,"));
    let runs = || std::fs::read_to_string(folder.path("runs")).unwrap().lines().count();
    let before = runs();
    let done = folder.glint(&[&args[..args.len() - 1], &["2"]].concat());
    assert_eq!(code(&done), Some(1), "one match is fewer than two");
    assert_eq!(runs() - before, 1, "only the version is asked for again");
}

/// A project of two scenes: the pictures that Glint makes are blessed, and a change is found.
#[test]
fn golden_pictures_are_blessed_and_checked() {
    let folder = Folder::new("golden");
    for sub in ["scenes", "tests/scenes/shape", "reference-images/povray/scenes"] {
        std::fs::create_dir_all(folder.path(sub)).unwrap();
    }
    folder.write("scenes/ball.pov", &format!("//! no reference: for the test\n{SPHERE}"));
    folder.write("tests/scenes/shape/ball.pov", &format!("//! no reference: for the test\n{SPHERE}"));
    let check = || folder.glint(&["golden", "check"]);
    assert_eq!(code(&check()), Some(1), "there are no pictures yet");
    let blessed = folder.glint(&["golden", "bless"]);
    assert_eq!(code(&blessed), Some(1), "nobody blesses by accident");
    assert!(!stdout(&blessed).contains("FAILED"), "{}", stdout(&blessed));
    let size = |name| {
        let (w, h, ..) = png_header(&std::fs::read(folder.path(name)).unwrap());
        (w, h)
    };
    assert_eq!(size("reference-images/glint/scenes/ball.png"), (320, 240));
    assert_eq!(size("reference-images/glint/tests/scenes/shape/ball.png"), (160, 120));
    assert_eq!(code(&check()), Some(0), "{}", stdout(&check()));
    folder.write(
        "tests/scenes/shape/ball.pov",
        &format!("//! no reference: for the test\n{SPHERE} background {{ rgb 1 }}"),
    );
    let changed = check();
    assert_eq!(code(&changed), Some(1));
    assert!(
        stdout(&changed).contains("FAILED  tests/scenes/shape/ball.pov: differs"),
        "{}",
        stdout(&changed)
    );
    assert!(folder.path("target/golden/tests/scenes/shape/ball.difference.png").is_file());
    assert_eq!(code(&folder.glint(&["golden", "bless", "shape/ball"])), Some(1));
    assert_eq!(code(&check()), Some(0));
    std::fs::remove_file(folder.path("scenes/ball.pov")).unwrap();
    let orphan = check();
    assert_eq!(code(&orphan), Some(1));
    assert!(stdout(&orphan).contains("no scene owns this picture"));
    assert_eq!(code(&folder.glint(&["golden", "check", "nothing"])), Some(2));
}

/// Somebody else's scenes: a folder of their own, no pictures by POV-Ray, tolerances with reasons, a page
/// that shows what changed.
#[test]
fn golden_serves_other_projects() {
    let folder = Folder::new("golden-elsewhere");
    std::fs::create_dir_all(folder.path("art/inc")).unwrap();
    folder.write(
        "art/inc/ball.inc",
        "sphere { 0, 1 pigment { rgb <1, Level, 0> } finish { ambient 1 diffuse 0 } }",
    );
    let scene = "#version 3.7; global_settings { assumed_gamma srgb } camera { location -3*z look_at 0 }\n";
    let options = "//! options: -W 40 -H 30 -L inc -D Level=0.5\n";
    let text = |golden: &str, level: &str| {
        format!("{options}{golden}{scene}#declare Level = Level + {level};\n#include \"ball.inc\"\n")
    };
    folder.write("art/ball.pov", &text("", "0"));
    let golden = |words: &[&str]| {
        folder.glint(&[&["golden"], words, &["--root", ".", "--scenes", "art", "--keep", "kept"]].concat())
    };
    assert_eq!(code(&golden(&["bless"])), Some(1));
    let header = png_header(&std::fs::read(folder.path("reference-images/glint/art/ball.png")).unwrap());
    assert_eq!(header, (40, 30, false, 8));
    let done = golden(&["check", "--report", "good.html"]);
    assert_eq!(code(&done), Some(0), "{}", stdout(&done));
    let page = |name: &str| std::fs::read_to_string(folder.path(name)).unwrap();
    assert!(page("good.html").contains("<b>0 complaints</b>"));
    // 5 of 255 brighter in one channel: too far, and within a tolerance that the scene gives a reason for.
    folder.write("art/ball.pov", &text("", "0.02"));
    let done = golden(&["check", "--report", "bad.html"]);
    assert_eq!(code(&done), Some(1));
    assert!(stdout(&done).contains("largest difference 5 of 255"), "{}", stdout(&done));
    assert_eq!(page("bad.html").matches("<img src=\"data:image/png;base64,").count(), 3);
    assert!(folder.path("kept/art/ball.difference.png").is_file());
    folder.write("art/ball.pov", &text("//! golden: 5 of 255, because the test says so\n", "0.02"));
    let done = golden(&["check"]);
    assert_eq!(code(&done), Some(0), "{}", stdout(&done));
}
