//! POV-Ray's command line: what it makes of hundreds of lines, and Glint under its name.
#![cfg(unix)]

mod process;

use process::*;
use std::collections::BTreeSet;
use std::path::Path;
use std::process::{Command, Output, Stdio};

/// Small, and different by clock and by a declared number.
const SMALL: &str = "
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at 0 }
light_source { <3, 5, -4> rgb 1 }
#ifdef (Level) background { rgb Level } #else background { rgb clock/20 } #end
sphere { 0, 1 pigment { rgb <1, 0.2, 0.1> } }
";

/// A row of the table: a command line, POV-Ray's files, and Glint's files.
struct Row {
    line: String,
    /// What stands in `x.ini`.
    ini: String,
    povray: String,
    glint: String,
}

fn rows() -> Vec<Row> {
    let text = include_str!("data/povray-command-lines.txt");
    let row = |line: &str| {
        let fields: Vec<_> = line.trim_start_matches('!').split('|').map(|f| f.trim().to_owned()).collect();
        assert_eq!(fields.len(), if line.starts_with('!') { 4 } else { 2 }, "{line}");
        let glint = if line.starts_with('!') { &fields[2] } else { &fields[1] };
        Row { line: fields[0].clone(), ini: String::new(), povray: fields[1].clone(), glint: glint.clone() }
    };
    text.lines().filter(|l| !l.starts_with('#') && !l.is_empty()).map(row).collect()
}

/// The cases of `povray-ini.txt`.
fn ini_rows() -> Vec<Row> {
    let text = include_str!("data/povray-ini.txt");
    let row = |case: &str| {
        let (head, rest) = case.split_once('\n').unwrap();
        let (ini, made) = rest.split_once("---\n").unwrap_or_else(|| panic!("{case}"));
        let section = head.split_once(" | ").map_or("", |(_, section)| section);
        let mut made = made.lines();
        let povray = made.next().unwrap().replace("\\n", "\n");
        let glint = made.next().filter(|l| l.starts_with('!'));
        let glint = glint.map_or(povray.clone(), |l| l[1..].split('|').next().unwrap().trim().to_owned());
        let ini = format!("Input_File_Name=a.pov\nWidth=8\nHeight=6\n{}", ini.replace("\\r", "\r"));
        Row { line: format!("x.ini{section} -D"), ini, povray, glint }
    };
    text.split("=== ").skip(1).map(row).collect()
}

/// The folder that the command lines of the table speak of.
fn stage(name: &str) -> Folder {
    let folder = Folder::new(name);
    for sub in ["out", "dir.d", "lib", "sub"] {
        std::fs::create_dir(folder.path(sub)).unwrap();
    }
    for scene in ["a.pov", "sub/b.pov", "c.txt", "d.v2.pov", "noext", "lib/l.pov"] {
        folder.write(scene, SMALL);
    }
    let sections = "[Big]\nWidth=16\n[anim]\nFinal_Frame=3\n[out]\nOutput_File_Name=o\n";
    folder.write("all.ini", &format!("; comment\nInput_File_Name=a.pov\n+W8 +H6\n{sections}"));
    folder.write("lib/inlib.ini", "+Ia +W8 +H6\n");
    folder
}

/// What a command line left: `error`, or its files with what they are.
fn left(line: &str, ini: &str, number: usize, run: impl Fn(&Folder, &[&str]) -> Output) -> String {
    // Tests run side by side, with the same numbers.
    let folder = stage(&format!("line-{number}-{:?}", std::thread::current().id()));
    // Not for other lines: POV-Ray would look for it behind a quotation mark, as in `Declare=Level="x"`.
    if line.starts_with("x.ini") {
        folder.write("x.ini", ini);
    }
    let words: Vec<_> = line.split(' ').collect();
    // Once before, so that what belongs to the stage is there.
    let before: BTreeSet<_> =
        files(&folder.0).into_iter().chain(["empty.ini", "povray"].map(String::from)).collect();
    let done = run(&folder, &words);
    if code(&done) != Some(0) {
        return "error".into();
    }
    let mut found = Vec::new();
    // Text is what POV-Ray says, or draws in letters.
    if !done.stdout.is_empty() && kind(&done.stdout) != "text" {
        found.push(format!("- {}", kind(&done.stdout)));
    }
    for name in files(&folder.0).into_iter().filter(|f| !before.contains(f)) {
        found.push(format!("{name} {}", kind(&std::fs::read(folder.path(&name)).unwrap())));
    }
    if found.is_empty() { "nothing".into() } else { found.join("; ") }
}

/// All files below a folder, in order.
fn files(root: &Path) -> Vec<String> {
    let mut open = vec![root.to_owned()];
    let mut found = Vec::new();
    while let Some(folder) = open.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            match path.is_dir() {
                true => open.push(path),
                false => found.push(path.strip_prefix(root).unwrap().to_string_lossy().into_owned()),
            }
        }
    }
    found.sort();
    found
}

/// What a file is, by its first bytes.
fn kind(b: &[u8]) -> String {
    let be = |at: usize| u32::from_be_bytes(b[at..at + 4].try_into().unwrap());
    let le = |at: usize| u16::from_le_bytes(b[at..at + 2].try_into().unwrap());
    match b {
        [0x89, b'P', ..] => format!("png {}x{} bits {} color {}", be(16), be(20), b[24], b[25]),
        [b'P', b'5' | b'6', ..] => {
            let header = String::from_utf8_lossy(&b[..b.len().min(600)]).into_owned();
            let lines = header.lines().filter(|l| !l.starts_with('#'));
            lines.take(3).collect::<Vec<_>>().join(" ")
        }
        [b'B', b'M', ..] => format!("bmp {}x{} {}", le(18), le(22), le(28)),
        [0xff, 0xd8, ..] => "jpeg".into(),
        [0x76, 0x2f, 0x31, 1, ..] => "exr".into(),
        [b'#', b'?', ..] => "hdr".into(),
        [_, 0, 2 | 10, ..] => format!("tga type {} {}x{} {}", b[2], le(12), le(14), b[16]),
        _ => "text".into(),
    }
}

/// Runs all rows, two at a time, and lists those that left something else.
fn differing(
    rows: &[Row],
    expected: impl Fn(&Row) -> &str + Sync,
    run: impl Fn(&Folder, &[&str]) -> Output + Sync,
) -> Vec<String> {
    let half = |odd: usize| {
        let mine = rows.iter().enumerate().filter(move |(i, _)| i % 2 == odd);
        let wrong = mine.filter_map(|(i, row)| {
            let got = left(&row.line, &row.ini, i, &run);
            (got != expected(row)).then(|| {
                format!("{} {:?}\n  expected {}\n  got      {got}", row.line, row.ini, expected(row))
            })
        });
        wrong.collect::<Vec<_>>()
    };
    std::thread::scope(|scope| {
        let other = scope.spawn(|| half(1));
        [half(0), other.join().unwrap()].concat()
    })
}

#[test]
fn command_lines_leave_the_files_of_the_table() {
    let rows = rows();
    assert!(rows.len() > 250);
    let wrong = differing(&rows, |row| &row.glint, as_povray);
    assert!(wrong.is_empty(), "{} lines\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn ini_files_mean_what_the_table_says() {
    let rows = ini_rows();
    assert!(rows.len() > 250);
    let wrong = differing(&rows, |row| &row.glint, as_povray);
    assert!(wrong.is_empty(), "{} lines\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn the_table_is_what_povray_does() {
    if !povray() {
        return;
    }
    let all: Vec<Row> = rows().into_iter().chain(ini_rows()).filter(|row| row.povray != "-").collect();
    let wrong = differing(&all, |row| &row.povray, reference);
    assert!(wrong.is_empty(), "{} lines\n{}", wrong.len(), wrong.join("\n"));
}

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

/// As measured: what a scene prints, its warnings and its error go to their own files, and consoles are silent alone.
#[test]
fn streams_go_where_options_send_them() {
    let folder = stage("streams");
    let text =
        format!("#version 3.7; \n\n#debug \"said\\n\"\n#warning \"warned\"\n{SMALL}\n#error \"stopped\"");
    folder.write("s.pov", &text);
    let streams = [("D", "said"), ("W", "warned"), ("F", "stopped")];
    for (letter, told) in streams {
        let line = ["+Is", "+W4", "+H3", "-D", &format!("-G{letter}{letter}.txt"), "+GAall.txt"];
        let done = as_povray(&folder, &line[..5]);
        assert_eq!(code(&done), Some(1));
        for (_, word) in streams {
            assert_eq!(stderr(&done).contains(word), word != told, "{word} of -G{letter}: {}", stderr(&done));
        }
        let file = std::fs::read_to_string(folder.path(&format!("{letter}.txt"))).unwrap();
        let told_alone = streams.iter().filter(|(_, word)| file.contains(word)).count();
        assert!(file.contains(told) && told_alone == 1, "{file}");
        as_povray(&folder, &line);
        let all = std::fs::read_to_string(folder.path("all.txt")).unwrap();
        assert!(streams.iter().all(|(_, word)| all.contains(word)), "{all}");
    }
    folder.write("kept.txt", "before\n");
    as_povray(&folder, &["+Ia", "+W4", "+H3", "-D", "+GSkept.txt", "Append_File=on"]);
    let kept = std::fs::read_to_string(folder.path("kept.txt")).unwrap();
    assert!(kept.starts_with("before\n") && kept.contains("a.png"), "{kept}");
    let silent = as_povray(&folder, &["+Is", "+W4", "+H3", "-D", "-GA"]);
    assert_eq!((code(&silent), stderr(&silent)), (Some(1), String::new()));
    let section = as_povray(&folder, &["all.ini[none]", "-D"]);
    assert!(stderr(&section).contains("has no section [none]"), "{}", stderr(&section));
}

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

/// The pictures of ten frames from an INI file, compared with POV-Ray's one by one.
#[test]
fn an_animation_is_the_reference_frame_by_frame() {
    if !povray() {
        return;
    }
    let ini = "Input_File_Name=move.pov\n+W80 +H60 -D -A\nInitial_Frame=1\nFinal_Frame=10\n\
               Initial_Clock=0.5\nFinal_Clock=2\n[Loop]\nCyclic_Animation=on\nSubset_Start_Frame=8\n";
    let scene = "#version 3.7; global_settings { assumed_gamma 1 }\n\
        camera { location <0, 2, -6> look_at 0 } light_source { <3, 5, -4> rgb 1 }\n\
        plane { y, -1 pigment { checker rgb 1 rgb 0.2 } }\n\
        sphere { <sin(6*clock), 0, 0>, 1 pigment { rgb <frame_number/final_frame, 0.2, clock_delta> } }\n";
    for (section, frames) in [("", 10), ("[loop]", 3)] {
        let [ours, theirs] = ["glint", "povray"].map(|name| Folder::new(&format!("animation-{name}")));
        for folder in [&ours, &theirs] {
            folder.write("move.ini", ini);
            folder.write("move.pov", scene);
        }
        let word = format!("move.ini{section}");
        let done = as_povray(&ours, &[&word]);
        assert_eq!(code(&done), Some(0), "{}", stderr(&done));
        assert!(stderr(&done).contains(&format!("[{frames}/{frames}] ")), "a line for each frame");
        assert_eq!(code(&reference(&theirs, &[&word])), Some(0));
        let pictures = |folder: &Folder| {
            files(&folder.0).into_iter().filter(|f| f.ends_with(".png")).collect::<Vec<_>>()
        };
        assert_eq!(pictures(&ours), pictures(&theirs));
        assert_eq!(pictures(&ours).len(), frames);
        for name in pictures(&ours) {
            let psnr = psnr(&ours.path(&name), &theirs.path(&name));
            assert!(psnr >= 38.0, "{name}: {psnr} dB");
        }
    }
}

fn psnr(a: &Path, b: &Path) -> f64 {
    let done =
        Command::new(env!("CARGO_BIN_EXE_glint")).arg("compare").args([a, b]).arg("--json").output().unwrap();
    let report: serde_json::Value = serde_json::from_slice(&done.stdout).unwrap();
    if report["psnr_db"].is_null() { f64::INFINITY } else { report["psnr_db"].as_f64().unwrap() }
}

#[test]
fn finished_frames_are_skipped() {
    let folder = stage("resume");
    assert_eq!(code(&as_povray(&folder, &["all[anim]"])), Some(0));
    std::fs::remove_file(folder.path("a2.png")).unwrap();
    std::fs::write(folder.path("a3.png"), b"half a pict").unwrap();
    folder.write("a1.unfinished.png", "from an earlier try");
    let first = std::fs::read(folder.path("a1.png")).unwrap();
    for switch in ["--resume", "+C"] {
        let done = as_povray(&folder, &["all[anim]", switch]);
        assert_eq!(code(&done), Some(0));
        assert!(stderr(&done).contains("[1/3] a1.png is there already"), "{}", stderr(&done));
        assert_eq!(stderr(&done).contains("-> a2.png"), switch == "--resume");
        assert_eq!(stderr(&done).contains("-> a3.png"), switch == "--resume");
    }
    assert_eq!(std::fs::read(folder.path("a1.png")).unwrap(), first);
    let done = as_povray(&folder, &["all[anim]", "+W10", "+C"]);
    assert!(!stderr(&done).contains("already"), "another size");
    assert!(!folder.path("a1.unfinished.png").exists(), "the finished frame takes its place");
}

/// An interrupted frame is kept apart, so that it is not taken for a finished one.
#[test]
fn an_interrupted_frame_keeps_another_name() {
    let folder = Folder::new("unfinished");
    folder.write("slow.pov", SLOW);
    folder.write("slow.ini", "Input_File_Name=slow.pov\nFinal_Frame=2\n+W800 +H600\n");
    let child = folder.command(&["slow.ini"]).stderr(Stdio::piped()).spawn().unwrap();
    std::thread::sleep(std::time::Duration::from_millis(1500));
    let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(sent.success());
    let done = child.wait_with_output().unwrap();
    assert_eq!(code(&done), Some(130), "{}", stderr(&done));
    assert_eq!(folder.names(), ["slow.ini", "slow.pov", "slow1.unfinished.png"], "{}", stderr(&done));
}

/// vapory from PyPI, unchanged, with a link named `povray` before everything else on the PATH.
#[test]
fn vapory_renders_to_a_file_and_to_an_array() {
    if !needed("python3", "GLINT_REQUIRE_PYTHON") {
        return;
    }
    let folder = Folder::new("vapory");
    folder.write("draw.py", VAPORY);
    let python = |program: &str, args: &[&str]| {
        let path = format!("{}:{}", folder.0.display(), std::env::var("PATH").unwrap_or_default());
        let mut command = Command::new(program);
        command.current_dir(&folder.0).args(args).env("PATH", path).env_remove("POVINI");
        command.stdin(Stdio::null()).output().unwrap()
    };
    let venv = python("python3", &["-m", "venv", "venv"]);
    let installed = venv
        .status
        .success()
        .then(|| python("venv/bin/python", &["-m", "pip", "install", "--quiet", "vapory", "numpy"]));
    if !installed.as_ref().is_some_and(|o| o.status.success()) {
        let said = stderr(installed.as_ref().unwrap_or(&venv));
        assert!(std::env::var_os("GLINT_REQUIRE_PYTHON").is_none(), "vapory cannot be installed: {said}");
        eprintln!("skipped: vapory cannot be installed");
        return;
    }
    // The link is there from here on.
    assert_eq!(code(&as_povray(&folder, &["--version"])), Some(0));
    let done = python("venv/bin/python", &["draw.py", "file.png"]);
    assert_eq!(code(&done), Some(0), "{}\n{}", stdout(&done), stderr(&done));
    let said = stdout(&done);
    assert_eq!(said.lines().last(), Some("(90, 120, 3) uint8 wrong scene refused"), "{said}");
    assert!(said.contains("did you mean `pigment`?"), "vapory shows what Glint says: {said}");
    assert_eq!(png_header(&std::fs::read(folder.path("file.png")).unwrap()), (120, 90, false, 8));
    assert_eq!(
        image::open(folder.path("file.png")).unwrap().to_rgb8().into_raw(),
        std::fs::read(folder.path("array")).unwrap(),
        "the array is the picture"
    );
    if povray() {
        std::fs::remove_file(folder.path("povray")).unwrap();
        let done = python("venv/bin/python", &["draw.py", "theirs.png"]);
        assert_eq!(code(&done), Some(0), "{}", stderr(&done));
        let psnr = psnr(&folder.path("file.png"), &folder.path("theirs.png"));
        assert!(psnr >= 38.0, "{psnr} dB");
    }
}

const VAPORY: &str = "
import sys
from vapory import *
camera = Camera('location', [0, 2, -3], 'look_at', [0, 1, 2])
light = LightSource([2, 4, -3], 'color', [1, 1, 1])
sphere = Sphere([0, 1, 2], 2, Texture(Pigment('color', [1, 0, 1]), Finish('phong', 0.8, 'reflection', 0.2)))
floor = Plane([0, 1, 0], -1, Texture(Pigment('checker', 'color', 0.2, 'color', 1)))
scene = Scene(camera, objects=[light, sphere, floor], included=['colors.inc'])
scene.render(sys.argv[1], width=120, height=90, antialiasing=0.3)
array = scene.render(width=120, height=90, antialiasing=0.3)
open('array', 'wb').write(array.tobytes())
try:
    Scene(camera, objects=[Sphere([0, 1, 2], 2, 'pigmet { rgb 1 }')]).render('wrong.png', width=4, height=4)
except IOError as error:
    print(array.shape, array.dtype, 'wrong scene refused')
";
