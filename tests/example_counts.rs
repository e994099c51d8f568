//! POV-Ray's example scenes are read where they are installed, and have its own counts of objects.

mod process;

use process::*;
use std::collections::HashMap;
use std::path::Path;

const TABLE: &str = include_str!("data/example-counts.csv");

/// Where the examples may be.
const FOLDERS: [&str; 2] = ["/usr/share/doc/povray/examples", "/usr/share/doc/povray-examples/examples"];

/// A line of the table.
struct Row<'a> {
    scene: &'a str,
    /// POV-Ray's counts of finite and infinite objects and light sources.
    reference: [u64; 3],
    /// Where Glint's differ, with the reason.
    ours: Option<([u64; 3], &'a str)>,
}

fn rows() -> Vec<Row<'static>> {
    let lines = TABLE.lines().filter(|line| !line.starts_with('#'));
    lines
        .map(|line| {
            let cells: Vec<&str> = line.splitn(8, ',').collect();
            let counts = |from: usize| [0, 1, 2].map(|i| cells[from + i].parse().expect(line));
            let ours = (cells.len() > 4).then(|| (counts(4), cells[7]));
            Row { scene: cells[0], reference: counts(1), ours }
        })
        .collect()
}

/// Few scenes differ, each for a reason that docs/LANGUAGE.md tells.
#[test]
fn differences_are_few_and_explained() {
    let rows = rows();
    assert_eq!(rows.len(), 376);
    let page = include_str!("../docs/LANGUAGE.md");
    let differing: Vec<&Row> = rows.iter().filter(|row| row.ours.is_some()).collect();
    assert!(differing.len() <= 8, "{} scenes differ", differing.len());
    for row in differing {
        let (ours, why) = row.ours.unwrap();
        let name = Path::new(row.scene).file_stem().unwrap().to_str().unwrap();
        assert!(ours != row.reference && !why.is_empty(), "{}", row.scene);
        assert!(page.contains(name), "docs/LANGUAGE.md does not name {name}");
    }
}

#[test]
fn examples_have_the_counts_of_the_reference() {
    let Some(examples) = FOLDERS.iter().map(Path::new).find(|f| f.is_dir()) else {
        let required = std::env::var_os("GLINT_REQUIRE_POVRAY").is_some();
        assert!(!required, "POV-Ray's example scenes are not installed (package povray-examples)");
        println!("skipped: POV-Ray's example scenes are not installed");
        return;
    };
    // Some scenes write files where the work is done.
    let folder = Folder::new("example-counts");
    let rows = rows();
    let scenes: Vec<String> = rows.iter().map(|row| examples.join(row.scene).display().to_string()).collect();
    let mut words = vec!["check", "--json", "-q", "-W4", "-H3"];
    words.extend(scenes.iter().map(String::as_str));
    let done = folder.glint(&words);
    let mut found: HashMap<String, [u64; 3]> = HashMap::new();
    for line in stdout(&done).lines() {
        let report: serde_json::Value = serde_json::from_str(line).unwrap();
        let count = |name: &str| report[name].as_u64();
        let counts = [count("finite_objects"), count("infinite_objects"), count("light_sources")];
        if let [Some(finite), Some(infinite), Some(lights)] = counts {
            found.insert(report["scene"].as_str().unwrap().to_owned(), [finite, infinite, lights]);
        }
    }
    let mut wrong = Vec::new();
    for (row, path) in rows.iter().zip(&scenes) {
        let expected = row.ours.map_or(row.reference, |(ours, _)| ours);
        match found.get(path) {
            Some(counts) if *counts == expected => {}
            other => wrong.push(format!("{}: {other:?}, expected {expected:?}", row.scene)),
        }
    }
    assert!(wrong.is_empty(), "{} scenes\n{}\n{}", wrong.len(), wrong.join("\n"), stderr(&done));
}
