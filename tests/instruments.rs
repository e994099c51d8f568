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
