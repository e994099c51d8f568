//! Wrong scenes, each with the exact diagnostic that it gets.
//!
//! A file of tests/bad holds one theme, case by case:
//!
//! ```text
//! === NAME [| LIMIT=N …] [| strict]
//! the scene; [[text*N]] stands for the text N times, [[bytes]] for rubbish
//! ---
//! LINE:COLUMN MESSAGE
//!   hint: …
//!   in …: the calls that led there
//! ```
//!
//! `GLINT_BLESS=1 cargo test --test bad` writes what comes now in place of what was expected, and fails if
//! that is not the same.

use glint::interp::{IncludeMode, Options, SceneSource, interpret};
use glint::source::{Diagnostic, Files, Span};
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// No wrong scene keeps its reader waiting.
const PATIENCE: Duration = Duration::from_secs(30);

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bad")
}

struct Case {
    heading: String,
    text: String,
    expected: String,
}

impl Case {
    fn name(&self) -> &str {
        self.heading.split(" | ").next().unwrap()
    }

    fn options(&self) -> Options {
        let library_paths = vec![folder(), folder().with_file_name("data").join("images")];
        let mut options = Options { library_paths, includes: IncludeMode::Embedded, ..Options::default() };
        for word in self.heading.split(" | ").skip(1).flat_map(str::split_whitespace) {
            match word.split_once('=') {
                Some((name, value)) => assert!(options.limits.set(name, value.parse().unwrap()), "{word}"),
                None => options.strict = word == "strict",
            }
        }
        options
    }
}

fn cases(path: &Path) -> Vec<Case> {
    let text = fs::read_to_string(path).unwrap();
    let parts = text.strip_prefix("=== ").expect("a case begins the file").split("\n=== ");
    parts
        .map(|part| {
            let (heading, rest) = part.split_once('\n').unwrap();
            let (text, expected) = rest.split_once("\n---\n").unwrap_or((rest, ""));
            Case {
                heading: heading.into(),
                text: text.trim_end().into(),
                expected: expected.trim_end().into(),
            }
        })
        .collect()
}

/// The scene with its repetitions carried out.
fn expanded(text: &str) -> Vec<u8> {
    let (mut out, mut rest) = (Vec::new(), text);
    while let Some((before, after)) = rest.split_once("[[") {
        let (inside, behind) = after.split_once("]]").unwrap();
        out.extend(before.bytes());
        match inside.rsplit_once('*') {
            Some((piece, count)) => out.extend(piece.repeat(count.parse().unwrap()).bytes()),
            None => out.extend(rubbish()),
        }
        rest = behind;
    }
    out.extend(rest.bytes());
    out
}

/// The same bytes each time.
fn rubbish() -> impl Iterator<Item = u8> {
    let mut state = 12345u32;
    (0..4096).map(move |_| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 24) as u8
    })
}

/// `LINE:COLUMN` in the scene, with the file's name before it elsewhere.
fn place(span: Option<Span>, files: &Files) -> String {
    let Some(span) = span else { return "nowhere".into() };
    let before = &files.text(span.file)[..span.start as usize];
    let line = before.iter().filter(|b| **b == b'\n').count() + 1;
    let column = before.len() - before.iter().rposition(|b| *b == b'\n').map_or(0, |at| at + 1) + 1;
    let name = Path::new(files.name(span.file)).file_name().unwrap().to_string_lossy().into_owned();
    if name == "scene" { format!("{line}:{column}") } else { format!("{name}:{line}:{column}") }
}

fn shown(diagnostic: &Diagnostic, files: &Files) -> String {
    let mut text = format!("{} {}", place(diagnostic.span, files), diagnostic.message);
    if let Some(hint) = &diagnostic.hint {
        write!(text, "\n  hint: {hint}").unwrap();
    }
    for label in diagnostic.labels.iter().chain(diagnostic.trace.iter().take(3)) {
        write!(text, "\n  {} {}", place(Some(label.span), files), label.message).unwrap();
    }
    // Folders differ from machine to machine.
    let here = folder().display().to_string();
    let text = text.lines().map(str::trim_end).collect::<Vec<_>>().join("\n");
    text.trim_end()
        .replace(&here, "tests/bad")
        .replace(&here.replace("/bad", "/data/images"), "tests/data/images")
}

fn diagnose(case: &Case) -> String {
    let source = SceneSource::Text { name: "scene".into(), text: expanded(&case.text) };
    if std::env::var_os("GLINT_BLESS").is_some() {
        eprintln!("{}", case.heading);
    }
    let start = Instant::now();
    let outcome = interpret(source, &case.options());
    let said = match &outcome.scene {
        Err(error) => shown(error, &outcome.files),
        Ok(_) => {
            let warnings: Vec<String> = outcome.warnings.iter().map(|w| w.message.clone()).collect();
            format!("accepted: {}", warnings.join("; "))
        }
    };
    assert!(start.elapsed() < PATIENCE, "{}: took {:?}", case.heading, start.elapsed());
    said
}

fn themes() -> Vec<PathBuf> {
    let mut all: Vec<PathBuf> = fs::read_dir(folder()).unwrap().map(|e| e.unwrap().path()).collect();
    let is_theme = |p: &PathBuf| {
        p.extension().is_some_and(|e| e == "txt") && fs::read_to_string(p).unwrap().starts_with("=== ")
    };
    all.retain(is_theme);
    all.sort();
    all
}

#[test]
fn every_wrong_scene_gets_its_diagnostic() {
    fs::create_dir_all("target").unwrap();
    let bless = std::env::var_os("GLINT_BLESS").is_some();
    let (mut wrong, mut count) = (Vec::new(), 0);
    for theme in themes() {
        let mut blessed = String::new();
        for case in cases(&theme) {
            let found = diagnose(&case);
            count += 1;
            if found != case.expected {
                wrong.push(format!(
                    "{}: {}\nexpected: {}\nfound:    {found}",
                    theme.file_stem().unwrap().to_string_lossy(),
                    case.name(),
                    case.expected
                ));
            }
            writeln!(blessed, "=== {}\n{}\n---\n{found}\n", case.heading, case.text).unwrap();
        }
        if bless {
            fs::write(&theme, blessed.trim_end().to_owned() + "\n").unwrap();
        }
    }
    assert!(count >= 300, "only {count} cases");
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

#[test]
fn no_wrong_scene_is_expected_to_be_accepted() {
    let all = themes().into_iter().flat_map(|theme| cases(&theme));
    let accepted: Vec<String> =
        all.filter(|c| c.expected.starts_with("accepted")).map(|c| c.name().to_owned()).collect();
    assert!(accepted.is_empty(), "{accepted:?}");
}

/// Texts of errors in the program, their variable parts cut out, and where they stand.
fn messages() -> Vec<(String, Vec<String>)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = vec![root.join("syntax/lexer.rs")];
    let mut folders = vec![root.join("interp")];
    while let Some(folder) = folders.pop() {
        for path in fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()) {
            match path.is_dir() {
                true if !path.ends_with("tests") => folders.push(path),
                false if path.extension().is_some_and(|e| e == "rs") => files.push(path),
                _ => {}
            }
        }
    }
    files.sort();
    files.iter().flat_map(|path| messages_in(path)).collect()
}

/// String literals that follow `Diagnostic::error(`, `unexpected(` or `demand(` closely.
fn messages_in(path: &Path) -> Vec<(String, Vec<String>)> {
    let text = fs::read_to_string(path).unwrap();
    let code = text.split("#[cfg(test)]").next().unwrap();
    let code: String =
        code.lines().filter(|l| !l.trim_start().starts_with("//")).collect::<Vec<_>>().join(" ");
    let name = path.file_name().unwrap().to_string_lossy().into_owned();
    let mut found = Vec::new();
    for call in ["Diagnostic::error(", "unexpected(", "unexpected_token(", ".demand("] {
        for (at, _) in code.match_indices(call) {
            let rest = &code[at + call.len()..];
            let end = rest.find(");").unwrap_or(rest.len()).min(160);
            let rest = rest.get(..end).unwrap_or_default();
            if let Some((before, literal)) = rest.split_once('"')
                && !before.contains("with_")
                && let Some((literal, _)) = literal.split_once('"')
            {
                found.push((format!("{name}: {literal}"), fixed_parts(literal)));
            }
        }
    }
    found
}

/// What stands between the `{…}` of a format.
fn fixed_parts(format: &str) -> Vec<String> {
    let text = format.replace("{{", "\u{1}").replace("}}", "\u{2}").replace("\\\\", "\\");
    let parts = text.split('{').enumerate().map(|(i, part)| match part.split_once('}') {
        Some((_, after)) if i > 0 => after.to_owned(),
        _ => part.to_owned(),
    });
    parts.map(|part| part.replace('\u{1}', "{").replace('\u{2}', "}")).filter(|p| p.len() > 1).collect()
}

/// Errors that no scene of this folder can meet, and why.
const NOT_MET: &[(&str, &str)] = &[
    (
        "algebraic.rs: as many coefficients as the order asks for",
        "the list is read to the number that the order asks for",
    ),
    ("declare.rs: what this name stood for is gone", "a macro's parameter outlives no variable"),
    ("mod.rs: a function or a spline", "only functions and splines are called"),
    ("parser.rs: an identifier", "an identifier was seen before it is taken"),
    (
        "macros.rs: cannot pass this name to a macro: it has no value",
        "names without a value are read as expressions",
    ),
    ("camera.rs: `mesh` or `mesh2`", "an object that is no mesh is told before"),
    ("text.rs: cannot read the font `{}`: {e}", "the file was found, and vanished or may not be read"),
    ("textfile.rs: cannot write `{}`: {why}", "the disk is full"),
];

/// Every error that the reader of scenes has is met by a wrong scene.
#[test]
fn every_error_is_met() {
    let expected: Vec<String> = themes().iter().flat_map(|theme| cases(theme)).map(|c| c.expected).collect();
    let is_met = |parts: &[String]| {
        expected.iter().any(|text| {
            let mut rest = text.as_str();
            parts.iter().all(|part| match rest.find(part.as_str()) {
                Some(at) => {
                    rest = &rest[at + part.len()..];
                    true
                }
                None => false,
            })
        })
    };
    let mut all = messages();
    assert!(all.len() > 150, "only {} messages were found", all.len());
    all.retain(|(_, parts)| !is_met(parts));
    let left: Vec<&String> = all
        .iter()
        .map(|(message, _)| message)
        .filter(|m| NOT_MET.iter().all(|(known, _)| m != known))
        .collect();
    assert!(left.is_empty(), "no wrong scene meets\n{left:#?}");
}
