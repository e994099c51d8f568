//! Every message about a mistake has a mistake that provokes it.

mod process;

use process::*;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Stdio;

const TABLE: &str = include_str!("data/messages.txt");

/// Messages that no command line provokes on a sound machine, and why.
const NOT_PROVOKED: &[(&str, &str)] = &[
    (": an internal error ended the work (a bug in Glint)", "there is no known bug of this kind"),
    ("cannot start a thread:", "the system has no threads left"),
    ("cannot start threads:", "the system has no threads left"),
    ("current folder:", "the current folder was removed"),
    ("this program's own file:", "the program was removed while it runs"),
];

/// The folder that the table speaks of.
fn stage(name: &str) -> Folder {
    let folder = Folder::new(name);
    for sub in ["void", "project/scenes", "project/reference-images/glint/scenes"] {
        std::fs::create_dir_all(folder.path(sub)).unwrap();
    }
    std::fs::create_dir_all(folder.path("project/reference-images/povray/scenes")).unwrap();
    for scene in ["a.pov", "b.pov"] {
        folder.write(scene, SPHERE);
    }
    folder.write("bad.pov", "sphere { 0, 1 pigmet { rgb 1 } }");
    let save = "global_settings { assumed_gamma 1 photons { count 10 save_file \"none/x.ph\" } }";
    folder.write("photons.pov", &format!("#version 3.7; {save} {SPHERE}"));
    folder.write("iff.pov", "plane { y, 0 pigment { image_map { iff \"im.iff\" } } }");
    folder.write("loop.ini", "loop.ini\n");
    folder.write("minus.ini", "-\n");
    folder.write("quote.ini", "Output_File_Name=\"o\n");
    folder.write("wrong.ini", "Width=8\nBogus=1\n");
    folder.write("list.txt", "a.pov\n");
    let picture = |name: &str, side: u32, value: u8| {
        image::RgbImage::from_pixel(side, side, image::Rgb([value; 3])).save(folder.path(name)).unwrap();
    };
    picture("white.png", 16, 255);
    picture("black.png", 16, 0);
    picture("small.png", 4, 0);
    let options = "//! options: -W 16 -H 16\n";
    for scene in ["new", "changed", "far"] {
        folder.write(&format!("project/scenes/{scene}.pov"), &format!("{options}{SPHERE}"));
    }
    folder.write("project/scenes/header.pov", &format!("//! option: -A\n{SPHERE}"));
    folder.glint(&["golden", "bless", "far", "--root", "project"]);
    picture("project/reference-images/glint/scenes/changed.png", 16, 255);
    picture("project/reference-images/povray/scenes/far.png", 16, 255);
    folder
}

#[test]
fn every_mistake_is_answered() {
    let mut wrong = Vec::new();
    for line in TABLE.lines().filter(|l| !l.starts_with('#')) {
        let [words, exit, said] = line.splitn(3, " | ").collect::<Vec<_>>().try_into().expect(line);
        // Some of them change the folder.
        let folder = stage("messages");
        let mut command = folder.command(&words.split(' ').collect::<Vec<_>>());
        let done = command.env("POVINI", folder.path("none")).env("HOME", &folder.0).output().unwrap();
        let all = stderr(&done) + &stdout(&done);
        if code(&done) != exit.parse().ok() || !all.contains(said) {
            wrong.push(format!("{line}\n  exit {:?}\n{all}", code(&done)));
        }
    }
    assert!(wrong.is_empty(), "{} lines\n{}", wrong.len(), wrong.join("\n"));
}

#[cfg(target_os = "linux")]
#[test]
fn streams_that_fail_are_named() {
    let folder = stage("streams-fail");
    let full = || Stdio::from(std::fs::File::options().write(true).open("/dev/full").unwrap());
    let done = folder.command(&["check", "a.pov"]).stdout(full()).output().unwrap();
    assert_eq!(code(&done), Some(3));
    assert!(stderr(&done).contains("standard output: No space left"), "{}", stderr(&done));
    let done = folder.command(&["a.pov", "-o", "-", "-W8", "-H6"]).stdout(full()).output().unwrap();
    assert_eq!(code(&done), Some(3));
    assert!(stderr(&done).contains("-: No space left"), "{}", stderr(&done));
    let no_file = Stdio::from(std::fs::File::open(&folder.0).unwrap());
    let done = folder.command(&["-", "-W8", "-H6"]).stdin(no_file).output().unwrap();
    assert_eq!(code(&done), Some(3));
    assert!(stderr(&done).contains("standard input: Is a directory"), "{}", stderr(&done));
}

/// A reader that goes away (`glint … | head`) is no error.
#[cfg(unix)]
#[test]
fn a_closed_pipe_is_no_error() {
    let folder = stage("pipe");
    let mut child = folder.command(&["check", "a.pov"]).stdout(Stdio::piped()).spawn().unwrap();
    drop(child.stdout.take());
    assert_eq!(child.wait().unwrap().code(), Some(0));
}

/// The texts of the messages in the sources are looked for in the table and in the unit tests.
#[test]
fn no_message_is_without_a_test() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let (mut messages, mut tested) = (BTreeSet::new(), TABLE.to_owned());
    for file in sources(&root.join("tests")) {
        tested.push_str(&std::fs::read_to_string(file).unwrap());
    }
    for file in sources(&root.join("src/cli")).into_iter().chain(sources(&root.join("src/picture"))) {
        let text = std::fs::read_to_string(&file).unwrap();
        let (program, tests) = text.split_once("#[cfg(test)]").unwrap_or((&text, ""));
        tested.push_str(tests);
        messages.extend(literals(program).into_iter().map(|m| (m, file.clone())));
    }
    assert!(messages.len() > 50, "{messages:?}");
    for (reason, _) in NOT_PROVOKED {
        assert!(messages.iter().any(|(m, _)| m.contains(reason)), "nobody says `{reason}`");
    }
    let untested: Vec<_> = messages.iter().filter(|(m, _)| !tested.contains(m)).collect();
    assert!(untested.is_empty(), "messages without a line in tests/data/messages.txt: {untested:#?}");
}

fn sources(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path());
    let (folders, files): (Vec<_>, Vec<_>) = entries.partition(|p| p.is_dir());
    let here = files.into_iter().filter(|p| p.extension().is_some_and(|e| e == "rs"));
    here.chain(folders.iter().flat_map(|f| sources(f))).collect()
}

/// The longest unchanging part of each text that a failure is made of.
fn literals(program: &str) -> Vec<String> {
    const MAKERS: [&str; 4] =
        ["Failure::usage(", "Failure::failed(", "Failure::unavailable(", "Err(format!("];
    let mut found = Vec::new();
    for maker in MAKERS {
        for (at, _) in program.match_indices(maker) {
            let rest = &program[at + maker.len()..];
            let quote =
                rest.find('"').filter(|&q| rest[..q].trim().trim_start_matches("format!(").trim().is_empty());
            let Some(quote) = quote else { continue };
            found.extend(longest_part(&rest[quote + 1..]));
        }
    }
    found
}

fn longest_part(literal: &str) -> Option<String> {
    let mut parts = vec![String::new()];
    let mut chars = literal.chars().peekable();
    while let Some(c) = chars.next() {
        match c {
            '"' => break,
            '{' => {
                chars.by_ref().find(|&c| c == '}');
                parts.push(String::new());
            }
            // A text that goes on in the next line.
            '\\' if chars.peek() == Some(&'\n') => while chars.next_if(|c| c.is_whitespace()).is_some() {},
            '\\' => {
                chars.next();
                parts.push(String::new());
            }
            c => parts.last_mut()?.push(c),
        }
    }
    let longest = parts.into_iter().max_by_key(String::len)?.trim().to_owned();
    (longest.len() > 3).then_some(longest)
}
