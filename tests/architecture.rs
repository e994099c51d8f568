//! The rules of ARCHITECTURE.md that a program can check: data flows one way, and crates stay in their rooms.

use std::fs;
use std::path::{Path, PathBuf};

/// A room may use rooms before it, never after.
const RANKS: &[&str] = &[
    "math", "color", "source", "picture", "syntax", "function", "pattern", "material", "shape", "light",
    "camera", "scene", "world", "interp", "trace", "render", "trade", "cli",
];

/// Crates that only some paths below `src/` may name.
const CRATES: &[(&str, &[&str])] = &[
    ("clap", &["cli/"]),
    ("clap_complete", &["cli/"]),
    ("codespan_reporting", &["cli/"]),
    ("ctrlc", &["cli/"]),
    ("exr", &["picture/", "pattern/image/", "cli/output.rs"]),
    ("image_compare", &["picture/"]),
    ("indicatif", &["cli/"]),
    ("logos", &["syntax/"]),
    ("obvhs", &["math/bvh/"]),
    ("rayon", &["math/bvh/", "trace/photon/", "render/", "trade/", "cli/"]),
    ("serde_json", &["cli/"]),
    ("tobj", &["interp/"]),
    ("ttf_parser", &["shape/"]),
];

/// A line of code outside tests and comments.
struct Line {
    /// Below `src/`, with `/`.
    file: String,
    number: usize,
    text: String,
}

fn source_files(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            source_files(&path, files);
        } else if path.extension().is_some_and(|e| e == "rs") {
            files.push(path);
        }
    }
}

/// Everything up to a file's tests; files and folders of tests are left out.
fn code() -> Vec<Line> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    source_files(&root, &mut files);
    files.sort();
    let mut lines = Vec::new();
    for path in files {
        let file = path.strip_prefix(&root).unwrap().to_string_lossy().replace('\\', "/");
        if file.ends_with("/tests.rs") || file.contains("/tests/") || file.ends_with("conformance.rs") {
            continue;
        }
        let text = fs::read_to_string(&path).unwrap();
        let before_tests = text.lines().enumerate().take_while(|(_, l)| l.trim() != "#[cfg(test)]");
        lines.extend(before_tests.filter(|(_, l)| !l.trim_start().starts_with("//")).map(|(i, l)| Line {
            file: file.clone(),
            number: i + 1,
            text: l.to_owned(),
        }));
    }
    assert!(lines.len() > 5_000, "the sources were not found");
    lines
}

/// Whole words that follow `prefix` in the text.
fn words_after<'a>(text: &'a str, prefix: &str) -> Vec<&'a str> {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    text.match_indices(prefix)
        .filter(|(at, _)| !text[..*at].ends_with(is_word))
        .map(|(at, _)| text[at + prefix.len()..].split(|c| !is_word(c)).next().unwrap_or(""))
        .collect()
}

fn rank(room: &str) -> Option<usize> {
    RANKS.iter().position(|r| *r == room)
}

#[test]
fn every_room_has_a_rank() {
    for line in code() {
        let room = line.file.split(['/', '.']).next().unwrap();
        let known = rank(room).is_some() || ["lib", "main"].contains(&room);
        assert!(known, "src/{}: `{room}` has no place in the order of rooms", line.file);
    }
}

#[test]
fn rooms_use_only_rooms_before_them() {
    let mut wrong = Vec::new();
    for line in code() {
        let Some(own) = rank(line.file.split(['/', '.']).next().unwrap()) else { continue };
        // `use crate::{a::…, b::…}` is not written here: one room a line.
        for used in words_after(&line.text, "crate::") {
            if rank(used).is_some_and(|used| used > own) {
                wrong.push(format!("src/{}:{}: {}", line.file, line.number, line.text.trim()));
            }
        }
    }
    assert!(wrong.is_empty(), "rooms that look down the corridor:\n{}", wrong.join("\n"));
}

#[test]
fn crates_stay_in_their_rooms() {
    let mut wrong = Vec::new();
    for line in code() {
        for (name, places) in CRATES {
            let named = line.text.contains(&format!("{name}::")) && {
                let at = line.text.find(&format!("{name}::")).unwrap();
                !line.text[..at].ends_with(|c: char| c.is_alphanumeric() || "_:.".contains(c))
            };
            if named && !places.iter().any(|p| line.file.starts_with(p)) {
                wrong.push(format!("src/{}:{}: {}", line.file, line.number, line.text.trim()));
            }
        }
    }
    assert!(wrong.is_empty(), "crates outside their rooms:\n{}", wrong.join("\n"));
}

/// The order in ARCHITECTURE.md is the order tested here.
#[test]
fn the_page_tells_the_same_order() {
    let page = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("ARCHITECTURE.md")).unwrap();
    let rows = page.lines().filter_map(|l| l.strip_prefix("| `"));
    let first_cells = rows.filter_map(|l| l.split('|').next());
    let told: Vec<&str> = first_cells
        .flat_map(|cell| cell.split(['`', ',', ' ']))
        .filter(|word| rank(word).is_some())
        .collect();
    let present = |room: &&&str| {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
        root.join(room).is_dir() || root.join(format!("{room}.rs")).is_file()
    };
    let expected: Vec<&str> = RANKS.iter().filter(present).copied().collect();
    assert_eq!(told, expected);
}

/// Files with `unsafe` in them, tests aside, are those that ARCHITECTURE.md names: by the last parts of their paths.
#[test]
fn the_page_tells_where_unsafe_code_stands() {
    let page = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("ARCHITECTURE.md")).unwrap();
    let from = page.find("- `unsafe` stands in").expect("the list of files with unsafe code");
    let list = page[from..].split("\n- ").next().unwrap();
    let mut files: Vec<String> =
        code().into_iter().filter(|l| l.text.contains("allow(unsafe_code)")).map(|l| l.file).collect();
    files.dedup();
    for file in &files {
        assert!(list.contains(&format!("`{file}`")), "src/{file} is not on the list");
    }
    let told = list.matches(".rs`").count();
    assert_eq!(told, files.len(), "{files:?}");
    let words = ["ten", "eleven", "twelve", "thirteen", "fourteen", "fifteen"];
    assert!(list.contains(&format!("in {} files", words[files.len() - 10])), "{} files", files.len());
}
