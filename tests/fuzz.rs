//! Scenes cut up, mixed and spoilt at random: reading and preparing them must neither panic, nor hang, nor take
//! all memory.
//!
//! `GLINT_FUZZ_SECONDS=1800 GLINT_FUZZ_SEEDS=DIR cargo test --release --test fuzz` looks longer (5 seconds is the
//! default), from the scenes in a folder too; GLINT_FUZZ_START=N begins with another random number. What is found
//! is left in target/fuzz, and becomes a case of tests/bad, written anew.

use glint::interp::{IncludeMode, Limits, Options, SceneSource, interpret};
use glint::world::World;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// No small scene may take longer under the limits below, in time of the processor.
const PATIENCE: Duration = Duration::from_secs(20);
/// Longer seeds are cut.
const LONGEST: usize = 20_000;

/// Words put in where nobody expects them.
const RUBBISH: &[&str] = &[
    "{",
    "}",
    "(",
    ")",
    "[",
    "]",
    "<",
    ">",
    "<0,0,0>",
    ";",
    ",",
    "#end",
    "#if (1)",
    "#else",
    "#while (1)",
    "#break",
    "#macro M(A)",
    "M(1)",
    "#declare A = A;",
    "#local",
    "#for (I, 0, 3)",
    "#include \"colors.inc\"",
    "0",
    "-1",
    "1e308",
    "1e-308",
    "4294967296",
    "-2147483649",
    "0/0",
    "1/0",
    "x",
    "rgb",
    "\"\"",
    "\"a\\",
    "/*",
    "//",
    "union {",
    "texture {",
    "pigment {",
    "function {",
    "array[3]",
    "array[1e9]",
    "#undef",
    "#version 3.1;",
    "#version 1.0;",
    "#default",
    "@",
    "\u{0}",
    "\u{ff}",
    "inverse",
    "matrix <0,0,0,0,0,0,0,0,0,0,0,0>",
    "scale 0",
    "scale 1e200",
    "sphere { 0, 1 }",
];

struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn below(&mut self, n: usize) -> usize {
        (self.next() % n.max(1) as u64) as usize
    }
}

fn collect(folder: &Path, seeds: &mut Vec<Vec<u8>>) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    let mut paths: Vec<PathBuf> = entries.filter_map(|e| Some(e.ok()?.path())).collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            collect(&path, seeds);
        } else if path.extension().is_some_and(|e| e == "pov" || e == "inc" || e == "txt")
            && let Ok(mut text) = fs::read(&path)
        {
            text.truncate(LONGEST);
            seeds.push(text);
        }
    }
}

/// Of the whole process: others may be busy as well.
fn cpu_time() -> Duration {
    let t = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
    Duration::new(t.tv_sec as u64, t.tv_nsec as u32)
}

/// Bounds of the words and marks of a text.
fn words(text: &[u8]) -> Vec<(usize, usize)> {
    let is_letter = |b: u8| b.is_ascii_alphanumeric() || matches!(b, b'_' | b'.' | b'#');
    let (mut all, mut at) = (Vec::new(), 0);
    while at < text.len() {
        let start = at;
        at += 1;
        while is_letter(text[start]) && at < text.len() && is_letter(text[at]) {
            at += 1;
        }
        if !text[start].is_ascii_whitespace() {
            all.push((start, at));
        }
    }
    all
}

/// One change of a text.
fn spoil(text: &mut Vec<u8>, other: &[u8], random: &mut Random) {
    let marks = words(text);
    if marks.is_empty() {
        return;
    }
    let from = random.below(marks.len());
    let to = (from + 1 + random.below(12)).min(marks.len());
    let (start, end) = (marks[from].0, marks[to - 1].1);
    match random.below(7) {
        0 => drop(text.drain(start..end)),
        1 => {
            let piece = text[start..end].to_vec();
            let at = marks[random.below(marks.len())].0;
            text.splice(at..at, piece);
        }
        2 => {
            let word = RUBBISH[random.below(RUBBISH.len())];
            text.splice(start..marks[from].1, format!(" {word} ").bytes());
        }
        3 => {
            let word = RUBBISH[random.below(RUBBISH.len())];
            text.splice(start..start, format!(" {word} ").bytes());
        }
        4 => {
            let pieces = words(other);
            if !pieces.is_empty() {
                let first = random.below(pieces.len());
                let last = (first + random.below(40)).min(pieces.len() - 1);
                text.splice(start..start, other[pieces[first].0..pieces[last].1].iter().copied());
            }
        }
        5 => text.truncate(end),
        _ => text[start] = random.next() as u8,
    }
}

fn options(root: &Path) -> Options {
    let limits = Limits {
        passes: 20_000,
        array_elements: 100_000,
        kept_tokens: 100_000,
        seconds: 5.0,
        memory: Some(3 << 30),
        ..Limits::default()
    };
    let library_paths = ["data/images", "language", "bad"].map(|f| root.join("tests").join(f)).to_vec();
    Options { library_paths, includes: IncludeMode::Embedded, limits, ..Options::default() }
}

#[test]
fn spoilt_scenes_are_survived() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let number =
        |name: &str, usual: u64| std::env::var(name).ok().and_then(|v| v.parse().ok()).unwrap_or(usual);
    let time = Duration::from_secs(number("GLINT_FUZZ_SECONDS", 5));
    let mut random = Random(number("GLINT_FUZZ_START", 1).wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1);
    let mut seeds = Vec::new();
    collect(&root.join("tests"), &mut seeds);
    collect(&root.join("scenes"), &mut seeds);
    if let Some(more) = std::env::var_os("GLINT_FUZZ_SEEDS") {
        collect(Path::new(&more), &mut seeds);
    }
    assert!(seeds.len() > 200);
    // Spoilt scenes write files where they stand.
    let place = root.join("target/fuzz/work");
    fs::create_dir_all(&place).unwrap();
    std::env::set_current_dir(&place).unwrap();
    let (start, mut count, mut found) = (Instant::now(), 0, Vec::new());
    while start.elapsed() < time {
        let mut text = seeds[random.below(seeds.len())].clone();
        for _ in 0..1 + random.below(6) {
            let other = &seeds[random.below(seeds.len())];
            spoil(&mut text, other, &mut random);
        }
        fs::write("../now.pov", &text).unwrap();
        let source = SceneSource::Text { name: "scene".into(), text: text.clone() };
        let begun = cpu_time();
        let read = catch_unwind(AssertUnwindSafe(|| {
            interpret(source, &options(root)).scene.map(World::prepare).is_ok()
        }));
        let took = cpu_time() - begun;
        if read.is_err() || took > PATIENCE {
            let name = root.join(format!("target/fuzz/found-{count}.pov"));
            fs::write(&name, &text).unwrap();
            found.push(format!("{} ({:?}, panicked: {})", name.display(), took, read.is_err()));
        }
        count += 1;
    }
    println!("{count} scenes in {:?}", start.elapsed());
    assert!(found.is_empty(), "{found:#?}");
}
