//! Camera rays against measured ones.

use glint::camera::Camera;
use glint::interp::{Options, SceneSource, interpret};
use glint::math::Vec3;
use glint::pattern::Context;
use std::fs;

/// One row of a table: the camera's text, the picture, the pixel, and the measured numbers.
struct Row {
    name: String,
    text: String,
    size: (f64, f64),
    pixel: (f64, f64),
    numbers: Vec<Option<f64>>,
}

fn rows(table: &str) -> Vec<Row> {
    let path = format!("{}/tests/data/{table}", env!("CARGO_MANIFEST_DIR"));
    let text = fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"));
    text.lines().filter(|l| !l.starts_with('#') && !l.starts_with("name,")).map(row).collect()
}

fn row(line: &str) -> Row {
    let (name, rest) = line.split_once(',').unwrap();
    // A text with commas stands in quotation marks.
    let (text, rest) = match rest.strip_prefix('"') {
        Some(quoted) => quoted.split_once("\",").unwrap(),
        None => rest.split_once(',').unwrap(),
    };
    let f: Vec<Option<f64>> = rest.split(',').map(|v| v.parse().ok()).collect();
    let number = |i: usize| f[i].unwrap();
    Row {
        name: name.to_owned(),
        text: text.to_owned(),
        size: (number(0), number(1)),
        pixel: (number(2), number(3)),
        numbers: f[4..].to_vec(),
    }
}

fn camera(row: &Row) -> Camera {
    let text = format!("#version 3.7; global_settings {{ assumed_gamma 1 }} {}", row.text);
    let source = SceneSource::Text { name: row.name.clone(), text: text.into_bytes() };
    let options =
        Options { image_width: row.size.0 as u32, image_height: row.size.1 as u32, ..Options::default() };
    interpret(source, &options).scene.unwrap_or_else(|e| panic!("{}: {}", row.name, e.message)).camera
}

fn ray(row: &Row) -> Option<glint::math::Ray> {
    let context = Context { noise: Default::default(), waves: 10, hit: None };
    camera(row).ray(row.pixel.0 + 0.5, row.pixel.1 + 0.5, row.size, &context)
}

#[test]
fn directions() {
    let rows = rows("4-camera-oracle.csv");
    assert_eq!(rows.len(), 720);
    let mut failures = Vec::new();
    for row in &rows {
        let expected = (row.numbers[3] == Some(1.0))
            .then(|| Vec3::from_array([0, 1, 2].map(|i| row.numbers[i].unwrap())));
        let got = ray(row).map(|r| r.dir);
        let agrees = match (expected, got) {
            (None, None) => true,
            (Some(a), Some(b)) => (a - b).abs().max_element() < 2e-4,
            _ => false,
        };
        if !agrees {
            failures.push(format!("{} {:?}: {expected:?}, got {got:?}", row.name, row.pixel));
        }
    }
    assert!(failures.is_empty(), "{} of {}\n{}", failures.len(), rows.len(), failures.join("\n"));
}

#[test]
fn places_on_a_plane() {
    let rows = rows("4-camera-plane-oracle.csv");
    assert_eq!(rows.len(), 288);
    for row in &rows {
        let ray = ray(row).unwrap();
        let p = ray.at(-ray.origin.z / ray.dir.z);
        let expected = Vec3::new(row.numbers[0].unwrap(), row.numbers[1].unwrap(), p.z);
        assert!(
            (p - expected).abs().max_element() < 5e-4,
            "{} {:?}: {expected}, got {p}",
            row.name,
            row.pixel
        );
    }
}
