//! What versions do to a scene: 3,100 pixels of 47 scenes by `#version`, by option and without either, and old
//! syntax from 2.0 on, as POV-Ray 3.7.0.10 answered.
#![cfg(unix)]

mod process;
mod table;

use process::*;
use std::collections::BTreeMap;
use std::path::Path;
use table::{Row, rows};

/// Rows of `version-oracle.csv` that Glint answers differently: scene, what the line before it or the options begin
/// with, the most that a value differs by, and why. A row that POV-Ray refuses differs by 256.
const VERSIONS: [(&str, &str, i32, &str); 3] = [
    ("media", "", 12, "samples are drawn at random"),
    ("nosemi", "", 256, "a missing semicolon is a warning"),
    ("default-tex", "#version 2.0;", 256, "no reason to refuse it was found"),
];

/// Rows of `old-syntax-oracle.csv` that Glint answers differently.
const OLD: [(&str, &str); 5] = [
    ("bare declare", "accepted with a warning"),
    ("texture{finish id}", "accepted in version 2.0, too"),
    ("0.05 number (crand) first in texture", "grain is drawn at random"),
    ("onion frequency", "the sphere lies on a step of the pattern: rounding decides"),
    ("srgb without assumed_gamma", "accepted: sRGB needs no assumed gamma here"),
];

fn data() -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/version-scenes").display().to_string()
}

/// The picture of a text, or `None` if it is refused.
fn render(
    folder: &Folder,
    name: &str,
    text: &[u8],
    size: (&str, &str),
    more: &str,
) -> Option<image::RgbaImage> {
    let scene = folder.path(&format!("{name}.pov"));
    std::fs::write(&scene, text).unwrap();
    let picture = folder.path(&format!("{name}.png"));
    let words = [
        format!("+I{}", scene.display()),
        format!("+O{}", picture.display()),
        format!("+W{}", size.0),
        format!("+H{}", size.1),
        format!("+L{}", data()),
        "+L/usr/share/povray-3.7/include".into(),
    ];
    let mut line: Vec<&str> = vec!["pov", "-A", "-D"];
    line.extend(words.iter().map(String::as_str));
    line.extend(more.split_whitespace());
    let done = folder.command(&line).env("POVINI", folder.path("none")).output().unwrap();
    (code(&done) == Some(0)).then(|| image::open(picture).unwrap().to_rgba8())
}

/// Runs `answer` for every number below `count`, on two threads.
fn wrong_ones(count: usize, answer: impl Fn(usize) -> Vec<String> + Sync) -> Vec<String> {
    let half = |odd: usize| (odd..count).step_by(2).flat_map(&answer).collect::<Vec<_>>();
    std::thread::scope(|scope| {
        let other = scope.spawn(|| half(1));
        [half(0), other.join().unwrap()].concat()
    })
}

#[test]
fn versions_change_what_they_change() {
    let folder = Folder::new("versions");
    let rows = rows("version-oracle.csv", "");
    assert_eq!(rows.len(), 3100);
    let mut scenes: BTreeMap<&[String], Vec<&Row>> = BTreeMap::new();
    for row in &rows {
        scenes.entry(&row.fields[..5]).or_default().push(row);
    }
    let scenes: Vec<_> = scenes.into_iter().collect();
    let wrong = wrong_ones(scenes.len(), |i| {
        let (scene, rows) = &scenes[i];
        let [name, header, options, width, height] = scene else { unreachable!() };
        let body = std::fs::read(Path::new(&data()).join(format!("{name}.pov"))).unwrap();
        let text = [header.as_bytes(), b"\n", &body].concat();
        let picture = render(&folder, &format!("v{i}"), &text, (width, height), options);
        let excuse = VERSIONS
            .iter()
            .find(|(n, start, ..)| name == n && (header.starts_with(start) || options.starts_with(start)));
        let allowed = excuse.map_or(1, |e| e.2);
        let far = rows.iter().filter(|row| distance(picture.as_ref(), row) > allowed);
        far.map(|row| format!("line {}: {:?}", row.number, row.fields)).collect()
    });
    assert!(wrong.is_empty(), "{} rows\n{}", wrong.len(), wrong.join("\n"));
}

/// By how much a pixel differs at most; 256 if one of the two was refused.
fn distance(picture: Option<&image::RgbaImage>, row: &Row) -> i32 {
    let number = |i: usize| row.fields.get(i).and_then(|f| f.parse::<i32>().ok());
    match (picture, number(5)) {
        (None, None) => 0,
        (Some(picture), Some(x)) => {
            let found = picture.get_pixel(x as u32, number(6).unwrap() as u32).0;
            (0..4).filter_map(|c| Some((number(7 + c)? - i32::from(found[c])).abs())).max().unwrap()
        }
        _ => 256,
    }
}

#[test]
fn old_syntax_is_read() {
    let folder = Folder::new("old-syntax");
    let rows = rows("old-syntax-oracle.csv", "");
    assert!(rows.len() > 700);
    let is_text = |row: &Row| row.fields[1].contains("timrom.ttf");
    let rows = table::without_missing_fonts(rows, "old-syntax-oracle.csv", is_text);
    let wrong = wrong_ones(rows.len(), |i| {
        let [what, snippet, header, result, pixels, ..] = &rows[i].fields[..] else { unreachable!() };
        if OLD.iter().any(|(known, _)| known == what) {
            return Vec::new();
        }
        let unless = |word: &str, text: &str| if snippet.contains(word) { "" } else { text }.to_owned();
        let text = [
            format!("{header}\n"),
            unless("global_settings", "global_settings{assumed_gamma 2.2}"),
            unless("camera", "camera{location <.2,.3,-3> direction 4*z right x up y look_at 0}"),
            unless("light_source", "light_source{<2,4,-10> rgb 1}"),
            unless("background", "background{rgb <.1,.2,.4>}"),
            snippet.clone(),
        ];
        let picture = render(&folder, &format!("o{i}"), text.concat().as_bytes(), ("2", "2"), "");
        let good = match picture {
            None => result.starts_with("error"),
            Some(picture) => !result.starts_with("error") && is_near(&picture, pixels),
        };
        if good { Vec::new() } else { vec![format!("line {}: {:?}", rows[i].number, rows[i].fields)] }
    });
    assert!(wrong.is_empty(), "{} rows\n{}", wrong.len(), wrong.join("\n"));
}

/// Whether the four pixels, `R/G/B` each, are these within 2.
fn is_near(picture: &image::RgbaImage, pixels: &str) -> bool {
    picture.pixels().zip(pixels.split_whitespace()).all(|(found, expected)| {
        let expected = expected.split('/').map(|v| v.parse::<i32>().unwrap());
        expected.zip(found.0).all(|(e, f)| (e - i32::from(f)).abs() <= 2)
    })
}
