//! The program as a process: exit codes, streams, files.

use serde_json::Value;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

const SPHERE: &str = "
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 }
light_source { <3, 5, -4> rgb 1 }
plane { y, -1 pigment { checker rgb 1 rgb 0.2 } }
sphere { 0, 1 pigment { rgb <1, 0.2, 0.1> } finish { reflection 0.3 } }
";

/// Slow enough to be stopped: half a million pixels of mirrors in mirrors.
const SLOW: &str = "
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 40 }
camera { location <0, 0.3, -1.9> look_at 0 }
#declare I = 0;
#while (I < 30)
  light_source { <2*cos(I), 1.5, 2*sin(I)> rgb 0.05 }
  sphere { <cos(I), 0, sin(I)>, 0.4 pigment { rgb 1 } finish { reflection 0.95 } }
  #declare I = I + 1;
#end
sphere { 0, 5 pigment { rgb 1 } finish { reflection 0.95 } }
";

/// A folder of one test, removed at its end.
struct Folder(PathBuf);

impl Folder {
    fn new(test: &str) -> Self {
        let path = std::env::temp_dir().join(format!("glint-cli-{test}-{}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    fn write(&self, name: &str, text: &str) -> PathBuf {
        let path = self.0.join(name);
        std::fs::write(&path, text).unwrap();
        path
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    fn glint(&self, args: &[&str]) -> Output {
        self.command(args).output().unwrap()
    }

    fn command(&self, args: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_glint"));
        command.current_dir(&self.0).args(args).stdin(Stdio::null());
        command
    }

    fn names(&self) -> Vec<String> {
        let mut names: Vec<_> = std::fs::read_dir(&self.0)
            .unwrap()
            .map(|e| e.unwrap().file_name().to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn code(output: &Output) -> Option<i32> {
    output.status.code()
}

fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn stdout(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// Width, height, and whether there is an alpha channel.
fn png_header(bytes: &[u8]) -> (u32, u32, bool, u8) {
    assert!(bytes.starts_with(b"\x89PNG\r\n\x1a\n"), "no PNG");
    let number = |at: usize| u32::from_be_bytes(bytes[at..at + 4].try_into().unwrap());
    (number(16), number(20), bytes[25] == 6, bytes[24])
}

#[test]
fn a_scene_becomes_a_picture_in_the_current_folder() {
    let folder = Folder::new("short");
    std::fs::create_dir(folder.path("sub")).unwrap();
    folder.write("sub/ball.pov", SPHERE);
    let done = folder.glint(&["sub/ball.pov", "-W", "40", "-H", "30"]);
    assert_eq!((code(&done), stdout(&done).as_str()), (Some(0), ""), "{}", stderr(&done));
    assert_eq!(folder.names(), ["ball.png", "sub"]);
    assert_eq!(png_header(&std::fs::read(folder.path("ball.png")).unwrap()), (40, 30, false, 8));
    assert!(stderr(&done).contains("ball.pov -> ball.png (40x30)"));
}

#[test]
fn options_reach_the_file() {
    let folder = Folder::new("options");
    folder.write("ball.pov", SPHERE);
    let done = folder.glint(&["render", "ball.pov", "-W40", "-H30", "--alpha", "--bits", "16", "-q"]);
    assert_eq!((code(&done), stderr(&done).as_str()), (Some(0), ""));
    assert_eq!(png_header(&std::fs::read(folder.path("ball.png")).unwrap()), (40, 30, true, 16));
    let done = folder.glint(&["render", "ball.pov", "-W40", "-H30", "-o", "sub/../ball.exr", "-q"]);
    assert_eq!(code(&done), Some(3), "the folder does not exist");
    let done = folder.glint(&["render", "ball.pov", "-W40", "-H30", "-o", "ball.exr", "-q"]);
    assert_eq!(code(&done), Some(0));
    assert!(std::fs::read(folder.path("ball.exr")).unwrap().starts_with(&[0x76, 0x2f, 0x31, 0x01]));
}

#[test]
fn standard_streams_carry_scene_and_picture() {
    let folder = Folder::new("streams");
    let mut command = folder.command(&["-", "-o", "-", "-W", "20", "-H", "10"]);
    let mut child =
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    child.stdin.take().unwrap().write_all(SPHERE.as_bytes()).unwrap();
    let done = child.wait_with_output().unwrap();
    assert_eq!(code(&done), Some(0), "{}", stderr(&done));
    assert_eq!(png_header(&done.stdout), (20, 10, false, 8));
    assert!(folder.names().is_empty());
}

#[test]
fn json_has_the_promised_names() {
    let folder = Folder::new("json");
    folder.write("a.pov", SPHERE);
    folder.write("b.pov", SPHERE);
    let done = folder.glint(&["render", "a.pov", "b.pov", "-W200", "-H150", "-A", "--json"]);
    assert_eq!(code(&done), Some(0), "{}", stderr(&done));
    let reports: Vec<Value> = stdout(&done).lines().map(|l| serde_json::from_str(l).unwrap()).collect();
    assert_eq!(reports.len(), 2);
    for (report, name) in reports.iter().zip(["a", "b"]) {
        assert_eq!(report["scene"], format!("{name}.pov"));
        assert_eq!(report["output"], format!("{name}.png"));
        assert_eq!((&report["width"], &report["height"]), (&200.into(), &150.into()));
        let seconds = |field: &str| report[field].as_f64().unwrap_or_else(|| panic!("{field}"));
        let parts: f64 =
            ["parse_cpu_s", "prepare_cpu_s", "trace_cpu_s", "write_cpu_s"].iter().map(|f| seconds(f)).sum();
        assert!(parts >= 0.97 * seconds("process_cpu_s"), "{report}");
        assert!(parts <= 1.001 * seconds("process_cpu_s"), "{report}");
        assert!(seconds("wall_s") > 0.0);
        assert!(report["camera_rays"].as_u64().unwrap() > 200 * 150);
        assert!(report["shadow_rays"].as_u64().unwrap() > 0);
        assert!(report["reflected_rays"].as_u64().unwrap() > 0);
        assert_eq!(report["refracted_rays"], 0);
        assert!(report["peak_rss_bytes"].as_u64().unwrap() > 1 << 20);
        assert!(report["warnings"].is_array() && report["unsupported"].is_array());
    }
}

#[test]
fn a_batch_goes_on_after_a_bad_scene() {
    let folder = Folder::new("batch");
    folder.write("bad.pov", "sphere { 0, 1 pigmet { rgb 1 } }\n");
    folder.write("good.pov", SPHERE);
    let done = folder.glint(&["render", "bad.pov", "good.pov", "-W20", "-H15", "--json"]);
    assert_eq!(code(&done), Some(1));
    assert_eq!(folder.names(), ["bad.pov", "good.png", "good.pov"]);
    let lines: Vec<Value> = stdout(&done).lines().map(|l| serde_json::from_str(l).unwrap()).collect();
    assert!(lines[0]["error"].as_str().unwrap().contains("bad.pov:1:"), "{}", lines[0]);
    assert_eq!(lines[1]["scene"], "good.pov");
    let text = stderr(&done);
    for part in ["error", "bad.pov:1:15", "sphere { 0, 1 pigmet { rgb 1 } }", "^^^^^^", "pigment"] {
        assert!(text.contains(part), "{part:?} is missing in\n{text}");
    }
}

#[test]
fn several_scenes_go_to_a_folder() {
    let folder = Folder::new("folder");
    folder.write("a.pov", SPHERE);
    folder.write("b.pov", SPHERE);
    std::fs::create_dir(folder.path("out")).unwrap();
    let done = folder.glint(&["render", "a.pov", "b.pov", "-W20", "-H15", "-q", "-o", "out"]);
    assert_eq!(code(&done), Some(0));
    assert!(folder.path("out/a.png").is_file() && folder.path("out/b.png").is_file());
    let done = folder.glint(&["render", "a.pov", "b.pov", "-o", "one.png"]);
    assert_eq!(code(&done), Some(2));
}

#[test]
fn wrong_command_lines_exit_with_2() {
    let folder = Folder::new("usage");
    folder.write("a.pov", SPHERE);
    for args in [
        &["render"][..],
        &["render", "a.pov", "--no-such-option"],
        &["render", "a.pov", "-o", "a.jpg"],
        &["render", "a.pov", "-W", "0"],
        &["render", "a.pov", "--quality", "12"],
        &["render", "a.pov", "--aa-depth", "10"],
        &["render", "a.pov", "--region", "0,0,700,10"],
        &["render", "a.pov", "-D", "novalue"],
        &["render", "a.pov", "--json", "-o", "-"],
        &["render", "a.pov", "+W320"],
        &["crosscheck", ".", ".", "--list", "x"],
    ] {
        let done = folder.glint(args);
        assert_eq!(code(&done), Some(2), "{args:?}: {}", stderr(&done));
        assert_eq!(stdout(&done), "", "{args:?}");
        assert!(!stderr(&done).is_empty());
    }
}

#[test]
fn mixed_syntaxes_show_the_translation() {
    let folder = Folder::new("mixed");
    let done = folder.glint(&["render", "a.pov", "+W320", "+H200", "--quality", "9"]);
    assert_eq!(code(&done), Some(2));
    assert!(stderr(&done).contains("glint render a.pov -W 320 -H 200 --quality 9"), "{}", stderr(&done));
}

#[test]
fn missing_files_exit_with_3() {
    let folder = Folder::new("missing");
    folder.write("a.pov", SPHERE);
    for args in [
        &["render", "none.pov"][..],
        &["render", "."],
        &["render", "a.pov", "-W8", "-H8", "-o", "none/a.png"],
        &["render", "a.pov", "-L", "none"],
        &["check", "none.pov"],
        &["compare", "none.png", "none.png"],
        &["crosscheck", "a.pov", "--povray", "./no-such-program"],
        &["crosscheck", "a.pov", "--reference", "none"],
        &["crosscheck", "none"],
    ] {
        let done = folder.glint(args);
        assert_eq!(code(&done), Some(3), "{args:?}: {}", stderr(&done));
    }
}

#[test]
fn help_and_version_go_to_stdout() {
    let folder = Folder::new("help");
    for args in [&["--help"][..], &["-h"], &["--version"], &["render", "--help"], &["help", "check"]] {
        let done = folder.glint(args);
        assert_eq!((code(&done), stderr(&done).as_str()), (Some(0), ""), "{args:?}");
        assert!(stdout(&done).contains("glint") || stdout(&done).contains("Usage"), "{args:?}");
    }
    let done = folder.glint(&["completions", "bash"]);
    assert!(stdout(&done).contains("_glint"));
}

#[test]
fn pictures_are_the_same_for_all_thread_counts() {
    let folder = Folder::new("threads");
    folder.write("a.pov", SPHERE);
    let picture = |threads: &str, method: &str| {
        let done = folder.glint(&[
            "render",
            "a.pov",
            "-W100",
            "-H75",
            "-A",
            "--aa-method",
            method,
            "--threads",
            threads,
            "-q",
        ]);
        assert_eq!(code(&done), Some(0), "{}", stderr(&done));
        std::fs::read(folder.path("a.png")).unwrap()
    };
    for method in ["1", "2"] {
        assert!(picture("1", method) == picture("3", method), "method {method}");
    }
}

#[test]
fn a_region_keeps_the_size() {
    let folder = Folder::new("region");
    folder.write("a.pov", "#version 3.7; global_settings { assumed_gamma 1 } background { rgb 1 }");
    let done = folder.glint(&["render", "a.pov", "-W8", "-H6", "--region", "2,1,5,4", "-q"]);
    assert_eq!(code(&done), Some(0), "{}", stderr(&done));
    let picture = image::open(folder.path("a.png")).unwrap().to_rgb8();
    assert_eq!(picture.dimensions(), (8, 6));
    for (x, y, p) in picture.enumerate_pixels() {
        let inside = (2..5).contains(&x) && (1..4).contains(&y);
        assert_eq!(p.0, [if inside { 255 } else { 0 }; 3], "{x} {y}");
    }
}

#[test]
fn declared_numbers_and_the_clock_reach_the_scene() {
    let folder = Folder::new("declare");
    let text = "#version 3.7; global_settings { assumed_gamma srgb } background { rgb <Level, clock, 0> }";
    folder.write("a.pov", text);
    let args = ["render", "a.pov", "-W1", "-H1", "-D", "Level=0.2", "--clock", "0.6", "-q"];
    let done = folder.glint(&args);
    assert_eq!(code(&done), Some(0), "{}", stderr(&done));
    assert_eq!(image::open(folder.path("a.png")).unwrap().to_rgb8().get_pixel(0, 0).0, [51, 153, 0]);
}

#[test]
fn compare_measures_and_judges() {
    let folder = Folder::new("compare");
    let picture = |name: &str, value: u8| {
        image::RgbImage::from_pixel(16, 16, image::Rgb([value; 3])).save(folder.path(name)).unwrap();
    };
    picture("a.png", 100);
    picture("b.png", 110);
    image::RgbImage::new(4, 4).save(folder.path("small.png")).unwrap();
    let json = |args: &[&str]| -> (Option<i32>, Value) {
        let done = folder.glint(args);
        (code(&done), serde_json::from_slice(&done.stdout).unwrap_or_default())
    };
    let (exit, equal) = json(&["compare", "a.png", "a.png", "--json", "--min-psnr", "99"]);
    assert_eq!((exit, &equal["psnr_db"], &equal["max_abs"]), (Some(0), &Value::Null, &0.0.into()));
    let (exit, differs) = json(&["compare", "a.png", "b.png", "--json", "--diff", "d.png"]);
    assert_eq!(exit, Some(0));
    assert!((differs["psnr_db"].as_f64().unwrap() - 28.1308).abs() < 1e-3);
    assert_eq!((&differs["rmse"], &differs["max_abs"]), (&10.0.into(), &10.0.into()));
    assert_eq!(differs["off_by_8_share"], 1.0);
    assert_eq!(image::open(folder.path("d.png")).unwrap().to_rgb8().get_pixel(3, 3).0, [80; 3]);
    assert_eq!(code(&folder.glint(&["compare", "a.png", "b.png", "--min-psnr", "28.2"])), Some(1));
    let sizes = folder.glint(&["compare", "a.png", "small.png"]);
    assert_eq!(code(&sizes), Some(1));
    assert!(stderr(&sizes).contains("16x16 and 4x4"));
}

#[test]
fn check_counts_and_draws_nothing() {
    let folder = Folder::new("check");
    folder.write("a.pov", SPHERE);
    let done = folder.glint(&["check", "a.pov", "--json"]);
    assert_eq!(code(&done), Some(0), "{}", stderr(&done));
    let report: Value = serde_json::from_slice(&done.stdout).unwrap();
    let counts = ["finite_objects", "infinite_objects", "light_sources"].map(|f| report[f].as_u64());
    assert_eq!(counts, [Some(1), Some(1), Some(1)]);
    assert!(report["warnings"].is_array() && report["unsupported"].is_array());
    assert_eq!(folder.names(), ["a.pov"]);
    let bad = folder.write("bad.pov", "sphere {");
    assert_eq!(code(&folder.glint(&["check", bad.to_str().unwrap()])), Some(1));
}

#[cfg(unix)]
fn interrupt(child: &std::process::Child) {
    let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
}

/// Waits until something is there, for half a minute at most.
fn until(condition: impl Fn() -> bool) {
    let started = Instant::now();
    while !condition() {
        assert!(started.elapsed() < Duration::from_secs(30), "it takes too long");
        std::thread::sleep(Duration::from_millis(20));
    }
}

/// Interrupts a process; how long it takes to end, and how it ends.
#[cfg(unix)]
fn stop(child: std::process::Child) -> (Duration, Output) {
    let stopped = Instant::now();
    interrupt(&child);
    let done = child.wait_with_output().unwrap();
    (stopped.elapsed(), done)
}

/// A machine that is busy with other tests may delay one try.
#[cfg(unix)]
fn stops_in_a_second(attempt: impl Fn() -> Duration) {
    let tries: Vec<_> = (0..3).map(|_| attempt()).take_while(|t| *t >= Duration::from_secs(1)).collect();
    assert!(tries.len() < 3, "{tries:?}");
}

#[cfg(unix)]
#[test]
fn ctrl_c_leaves_the_partial_picture() {
    stops_in_a_second(|| {
        let folder = Folder::new("interrupt");
        folder.write("slow.pov", SLOW);
        folder.write("next.pov", SPHERE);
        let args = ["render", "slow.pov", "next.pov", "-W", "800", "-H", "600", "--partial"];
        let child = folder.command(&args).stderr(Stdio::piped()).spawn().unwrap();
        let picture = folder.path("slow.png");
        until(|| picture.is_file());
        let size = png_header(&std::fs::read(&picture).unwrap());
        assert_eq!(size, (800, 600, false, 8), "the unfinished picture is whole as a file");
        let (took, done) = stop(child);
        assert_eq!(code(&done), Some(130));
        let text = stderr(&done);
        assert!(text.contains("interrupted") && text.contains("slow.png"), "{text}");
        let left = ["next.pov", "slow.png", "slow.pov"];
        assert_eq!(folder.names(), left, "the batch ends, no temporary file stays");
        took
    });
}

#[cfg(unix)]
#[test]
fn ctrl_c_stops_an_endless_scene_text() {
    stops_in_a_second(|| {
        let folder = Folder::new("endless");
        folder.write("a.pov", "#declare I = 0; #while (1) #declare I = I + 1; #end");
        let child = folder.command(&["render", "a.pov"]).stderr(Stdio::piped()).spawn().unwrap();
        std::thread::sleep(Duration::from_millis(700));
        let (took, done) = stop(child);
        assert_eq!(code(&done), Some(130), "{}", stderr(&done));
        took
    });
}

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

/// The program under the name of POV-Ray, without the user's own INI files.
#[cfg(unix)]
fn as_povray(folder: &Folder, args: &[&str]) -> Output {
    let link = folder.path("povray");
    if !link.exists() {
        std::os::unix::fs::symlink(env!("CARGO_BIN_EXE_glint"), &link).unwrap();
    }
    let ini = folder.write("empty.ini", "");
    Command::new(link)
        .current_dir(&folder.0)
        .args(args)
        .env("POVINI", ini)
        .stdin(Stdio::null())
        .output()
        .unwrap()
}

#[cfg(unix)]
#[test]
fn under_the_name_of_povray_letters_mean_what_they_mean_there() {
    let folder = Folder::new("povray");
    folder.write("a.pov", SPHERE);
    let done = as_povray(&folder, &["+Ia", "-Obig.tga", "+w40", "-H30", "-A", "-D", "+UA", "-GA"]);
    assert_eq!((code(&done), stderr(&done).as_str()), (Some(0), ""));
    assert_eq!(png_header(&std::fs::read(folder.path("big.tga.png")).unwrap()), (40, 30, true, 8));
    let done = as_povray(&folder, &["a.pov", "Width=12", "Height=10", "+FP", "+O-", "-GA"]);
    assert_eq!(code(&done), Some(0));
    assert!(done.stdout.starts_with(b"P6\n12 10\n255\n") && done.stdout.len() == 13 + 360);
    let done = as_povray(&folder, &["a.pov"]);
    assert_eq!(png_header(&std::fs::read(folder.path("a.png")).unwrap()), (160, 120, false, 8));
    assert_eq!(code(&done), Some(0));
    for (args, exit) in
        [(&["a.pov", "+Z"][..], 2), (&["a.pov", "Widht=3"], 2), (&["nosuch"], 3), (&["b.pov"], 3)]
    {
        assert_eq!(code(&as_povray(&folder, args)), Some(exit), "{args:?}");
    }
}

#[cfg(unix)]
#[test]
fn ini_files_and_frames() {
    let folder = Folder::new("frames");
    folder.write("a.pov", "#version 3.7; global_settings { assumed_gamma srgb } background { rgb clock }");
    folder.write("all.ini", "Input_File_Name=a.pov\n+W4 +H2 ; small\n[anim]\nFinal_Frame=11\n");
    let done = as_povray(&folder, &["all[anim]", "+SF10", "-D"]);
    assert_eq!(code(&done), Some(0), "{}", stderr(&done));
    assert_eq!(folder.names(), ["a.pov", "a10.png", "a11.png", "all.ini", "empty.ini", "povray"]);
    let shade = |name| image::open(folder.path(name)).unwrap().to_rgb8().get_pixel(3, 1).0;
    assert_eq!((shade("a10.png"), shade("a11.png")), ([230; 3], [255; 3]));
    let done =
        folder.command(&["+Ia.pov", "+W4", "+H2", "+Ob"]).env("POVINI", folder.path("empty.ini")).output();
    assert_eq!(code(&done.unwrap()), Some(0));
    assert!(folder.path("b.png").is_file());
}

#[test]
fn explain_says_what_was_built_and_what_was_left_out() {
    let folder = Folder::new("explain");
    folder.write("a.pov", SPHERE);
    let done = folder.glint(&["explain", "a.pov", "--json"]);
    assert_eq!(code(&done), Some(0), "{}", stderr(&done));
    let report: Value = serde_json::from_slice(&done.stdout).unwrap();
    assert_eq!(report["required"]["objects"], serde_json::json!({ "plane": 1, "sphere": 1 }));
    assert_eq!(report["required"]["lights"], serde_json::json!({ "point": 1 }));
    assert_eq!(report["required"]["pigments"]["checker"], 1);
    assert_eq!(report["required"]["reflecting_layers"], 1);
    assert_eq!(report["built"]["tree_nodes"], 0);
    let left_out: Vec<_> =
        report["left_out"].as_array().unwrap().iter().map(|l| l["what"].as_str().unwrap()).collect();
    assert!(left_out.contains(&"tree") && left_out.contains(&"media"), "{left_out:?}");
    assert!(!left_out.contains(&"reflected rays") && !left_out.contains(&"shadow rays"), "{left_out:?}");
    let done = folder.glint(&["explain", "a.pov"]);
    assert!(stdout(&done).contains("1 checker") && stdout(&done).contains("left out"));
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
