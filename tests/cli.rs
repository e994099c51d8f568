//! The program as a process: exit codes, streams, files.

mod process;

use process::*;
use serde_json::Value;
use std::io::Write;
use std::process::Stdio;

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

/// The four parts are the whole process, nearly.
fn assert_accounted(report: &Value) {
    let seconds = |field: &str| report[field].as_f64().unwrap_or_else(|| panic!("{field}"));
    let parts = ["parse_cpu_s", "prepare_cpu_s", "trace_cpu_s", "write_cpu_s"];
    let sum: f64 = parts.iter().map(|f| seconds(f)).sum();
    let process = seconds("process_cpu_s");
    assert!(sum >= 0.97 * process && sum <= 1.001 * process, "{report}");
}

#[test]
fn json_has_the_promised_names() {
    let folder = Folder::new("json");
    folder.write("a.pov", SPHERE);
    folder.write("b.pov", SPHERE);
    let tiny = folder.glint(&["render", "a.pov", "-W1", "-H1", "--json", "-o", "tiny.png"]);
    assert_accounted(&serde_json::from_slice(&tiny.stdout).unwrap());
    let done = folder.glint(&["render", "a.pov", "b.pov", "-W200", "-H150", "-A", "--json"]);
    assert_eq!(code(&done), Some(0), "{}", stderr(&done));
    let reports: Vec<Value> = stdout(&done).lines().map(|l| serde_json::from_str(l).unwrap()).collect();
    assert_eq!(reports.len(), 2);
    for (report, name) in reports.iter().zip(["a", "b"]) {
        assert_eq!(report["scene"], format!("{name}.pov"));
        assert_eq!(report["output"], format!("{name}.png"));
        assert_eq!((&report["width"], &report["height"]), (&200.into(), &150.into()));
        assert_accounted(report);
        assert!(report["wall_s"].as_f64().unwrap() > 0.0);
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
    for line in
        [&["pov", "a.pov", "--json"][..], &["pov", "a.pov", "-W", "20"], &["+Ia.pov", "-A0.3", "--alpha"]]
    {
        let done = folder.glint(line);
        assert_eq!(code(&done), Some(2), "{line:?}");
        assert!(stderr(&done).contains("In Glint's syntax: glint render a.pov -"), "{}", stderr(&done));
    }
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

/// The second picture begins with what the first one found, and gathers less.
#[test]
fn radiosity_is_kept_in_a_file() {
    let folder = Folder::new("radiosity");
    folder.write(
        "a.pov",
        "#version 3.7; global_settings { assumed_gamma 1 radiosity { count 20 recursion_limit 1 } }
        camera { location <0, 1, -4> look_at <0, 0.5, 0> } plane { y, 0 pigment { rgb 0.8 } }
        sphere { y, 0.8 pigment { rgb <0.3, 0.5, 0.8> } finish { emission 1 } }",
    );
    let run = |words: &[&str]| {
        let common = ["render", "a.pov", "-W32", "-H24", "-q", "--save-radiosity", "kept.rca"];
        let done = folder.glint(&[&common, words].concat());
        assert_eq!(code(&done), Some(0), "{}", stderr(&done));
        std::fs::read_to_string(folder.path("kept.rca")).unwrap()
    };
    let load = ["--load-radiosity", "kept.rca"];
    let first = run(&load);
    let second = run(&load);
    let (all, more) = (first.lines().count(), second.lines().count() - first.lines().count());
    assert!(all > 50 && more < all / 2, "{all} samples, then {more}");
    folder.write("kept.rca", "C1 2 3\n");
    let done = folder.glint(&["render", "a.pov", "-W8", "-H6", "--load-radiosity", "kept.rca"]);
    assert_eq!(code(&done), Some(3));
    assert!(stderr(&done).contains("line 1 is no sample of radiosity"), "{}", stderr(&done));
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
    assert_eq!(code(&folder.glint(&["compare", "a.png", "b.png", "--diff", "d.jpg"])), Some(2));
    assert!(!folder.path("d.jpg").exists());
    let words = folder.glint(&["compare", "a.png", "a.png"]);
    let words = String::from_utf8_lossy(&words.stdout).into_owned();
    assert!(words.contains("PSNR in light       infinite (the pictures are equal) (RMSE 0.00000"), "{words}");
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

#[test]
fn includes_are_explained() {
    let folder = Folder::new("includes");
    folder.write("own.inc", "#declare A = 1;\n");
    folder.write(
        "scene.pov",
        "#version 3.7;\n#include \"own.inc\"\n#include \"colors.inc\"\nsphere { 0, A pigment { Red } }\n",
    );
    let said = folder.glint(&["check", "--explain-includes", "--includes", "embedded", "scene.pov"]);
    let text = String::from_utf8(said.stdout).unwrap();
    assert!(
        text.contains("  own.inc: own.inc\n") && text.contains("  colors.inc: embedded in Glint\n"),
        "{text}"
    );
}

#[test]
fn limits_and_strictness_are_options() {
    let folder = Folder::new("limits");
    folder.write("loop.pov", "#while (1) #end\n");
    let said = folder.glint(&["check", "--limit", "passes=100", "loop.pov"]);
    assert!(String::from_utf8_lossy(&said.stderr).contains("more than 100 passes"));
    folder.write("new.pov", "#version 3.8;\nsphere { 0, 1 }\n");
    assert!(folder.glint(&["check", "new.pov"]).status.success());
    assert!(!folder.glint(&["check", "--strict=reference", "new.pov"]).status.success());
}

/// A picture of a type that is not decoded is black wherever it stands: one warning, one entry, and the render goes on.
#[test]
fn what_is_not_rendered_yet_is_said_once() {
    let folder = Folder::new("unsupported");
    let uses = [
        "plane { y, 0 pigment { image_map { iff \"a.iff\" gamma 1 map_type 1 filter 3, 0.5 transmit all 0.1 } } }",
        "plane { y, 1 normal { bump_map { iff \"b.iff\" interpolate 2 bump_size 2 } } }",
        "plane { y, 2 pigment { image_pattern { iff \"c.iff\" premultiplied on use_alpha } } }",
        "plane { y, 3 texture { material_map { iff \"d.iff\" texture { pigment { rgb 1 } } } } }",
        "height_field { iff \"e.iff\" smooth water_level 0.1 }",
    ];
    for (i, text) in uses.iter().enumerate().chain([(uses.len(), &uses.concat().as_str())]) {
        let name = format!("{i}.pov");
        folder.write(&name, &format!("#version 3.7; global_settings {{ assumed_gamma 1 }} {text}"));
        let done = folder.glint(&["render", "--json", "-W8", "-H6", &name]);
        assert_eq!(code(&done), Some(0), "{text}: {}", stderr(&done));
        let report: Value = serde_json::from_str(&stdout(&done)).unwrap();
        assert_eq!(report["unsupported"], serde_json::json!(["an image of type `iff`"]), "{text}");
        let said = "an image of type `iff` is not rendered yet: it is read and left out";
        assert_eq!(report["warnings"].to_string().matches(said).count(), 1, "{text}: {report}");
        assert!(folder.path(&format!("{i}.png")).is_file());
        let done = folder.glint(&["check", "--strict", &name]);
        assert_eq!(code(&done), Some(1), "{text}");
        assert!(stderr(&done).contains("not rendered yet: an image of type `iff` (an error with --strict)"));
    }
    folder.write("wrong.pov", "plane { y, 0 pigment { image_map { iff \"a.iff\" wrong } } }");
    assert_eq!(code(&folder.glint(&["check", "wrong.pov"])), Some(1));
}

/// Names in capitals find the files that are carried along, with the warning that installed ones get.
#[test]
fn carried_files_are_found_in_capitals() {
    let folder = Folder::new("capitals");
    for name in ["COLORS.INC", "Colors", "cOLORS.Inc"] {
        folder.write("s.pov", &format!("#version 3.7; #include \"{name}\" #declare C = Red;"));
        let done = folder.glint(&["check", "--includes", "embedded", "s.pov"]);
        assert_eq!(code(&done), Some(0), "{}", stderr(&done));
        let said =
            format!("`{name}` is taken to be <embedded>/colors.inc: capitals and small letters differ");
        assert!(stderr(&done).contains(&said), "{}", stderr(&done));
        let done = folder.glint(&["check", "--strict=reference", "--includes", "embedded", "s.pov"]);
        assert_eq!(code(&done), Some(1), "{name}");
    }
    folder.write("s.pov", "#version 3.7; #include \"colors.inc\" #declare C = Red;");
    let done = folder.glint(&["check", "--strict=reference", "--includes", "embedded", "s.pov"]);
    assert_eq!(code(&done), Some(0), "{}", stderr(&done));
}

/// The name of a file that is carried along, or that lies where it was looked for.
#[test]
fn misspelt_file_names_are_answered() {
    let folder = Folder::new("misspelt");
    folder.write("leaves.inc", "");
    for (name, near) in [("colrs.inc", "colors.inc"), ("laeves.inc", "leaves.inc")] {
        folder.write("s.pov", &format!("#include \"{name}\""));
        let done = folder.glint(&["check", "--includes", "embedded", "s.pov"]);
        assert!(stderr(&done).contains(&format!("did you mean `{near}`?")), "{}", stderr(&done));
    }
    folder.write("s.pov", "#include \"nothing_like_it.inc\"");
    assert!(!stderr(&folder.glint(&["check", "s.pov"])).contains("did you mean"));
}
