//! Measured patterns, pigments and normals, read through the real grammar.

use super::read;
use crate::material::Pigment;
use crate::math::{Vec2, Vec3};
use crate::pattern::{Context, Incidence, NoiseGenerator};
use std::collections::BTreeMap;

pub(super) const CONTEXT: Context = Context { noise: NoiseGenerator::RangeCorrected, waves: 10, hit: None };

/// The description in a row's first field, which may be quoted, and the numbers in the others.
fn row(line: &str) -> (&str, Vec<f64>) {
    let (text, rest) = match line.strip_prefix('"') {
        Some(quoted) => quoted.split_once("\",").unwrap(),
        None => line.split_once(',').unwrap(),
    };
    (text, rest.split(',').map(|f| f.parse().unwrap()).collect())
}

pub(super) fn rows(table: &str) -> impl Iterator<Item = (&str, Vec<f64>)> {
    table.lines().filter(|l| !l.starts_with('#')).map(row)
}

fn pigment(text: &str) -> Pigment {
    read(&format!("pigment {{ {text} }}"), |p| p.pigment_statement()).as_ref().clone()
}

/// Fails with the worst row of each description that does not agree.
pub(super) fn report(bad: BTreeMap<String, (usize, String)>) {
    let lines: Vec<String> =
        bad.iter().map(|(text, (count, worst))| format!("{text}: {count} rows, {worst}")).collect();
    assert!(lines.is_empty(), "{} descriptions differ:\n{}", lines.len(), lines.join("\n"));
}

pub(super) fn note(bad: &mut BTreeMap<String, (usize, String)>, text: &str, why: String) {
    bad.entry(text.to_owned()).or_insert((0, why)).0 += 1;
}

/// Points of the table that lie on outlines of tilings, where either tile may have them.
fn on_outline(p: Vec3) -> bool {
    [Vec3::ZERO, Vec3::new(-1.0, -2.0, 3.0), Vec3::new(1.5, 0.5, -0.5)].contains(&p)
}

#[test]
fn patterns_are_as_measured() {
    let mut seen: BTreeMap<String, Pigment> = BTreeMap::new();
    let (mut bad, mut count) = (BTreeMap::new(), 0);
    for (text, v) in rows(include_str!("../../../tests/data/2-patterns-oracle.csv")) {
        let p = seen.entry(text.to_owned()).or_insert_with(|| pigment(text));
        let at = Vec3::new(v[0], v[1], v[2]);
        let got = p.signal.value(p.signal.warp(at), &CONTEXT);
        if text.starts_with("tiling") && on_outline(at) {
            continue;
        }
        count += 1;
        // Some were read through a pigment, in single precision.
        let single = ["tiling", "pavement", "mandel 20 exterior 7", "mandel 20 exterior 8"];
        let tolerance = if single.iter().any(|s| text.starts_with(s)) { 4e-6 } else { 1e-9 };
        if (got - v[3]).abs() > tolerance {
            note(&mut bad, text, format!("{got} not {} at {at}", v[3]));
        }
    }
    println!("{count} rows");
    report(bad);
}

#[test]
fn pavements_are_as_measured() {
    let table = include_str!("../../../tests/data/2-tiling-pavement-oracle.csv");
    let columns: Vec<(&str, Vec<f64>)> = rows(table).collect();
    let [(_, xs), (_, zs), ..] = &columns[..] else { panic!("the table starts with x and z") };
    let (mut bad, mut count) = (BTreeMap::new(), 0);
    for (text, values) in columns.iter().filter(|(text, _)| text.starts_with("pavement")) {
        let p = pigment(text);
        for ((&x, &z), &want) in xs.iter().zip(zs).zip(values) {
            let at = Vec3::new(x, 0.0, z);
            let got = p.signal.value(p.signal.warp(at), &CONTEXT);
            count += 1;
            if (got - want).abs() > 4e-6 {
                note(&mut bad, text, format!("{got} not {want} at {at}"));
            }
        }
    }
    println!("{count} values");
    assert_eq!(count, 48 * 150);
    report(bad);
}

#[test]
fn pigments_are_as_measured() {
    let (mut bad, mut count) = (BTreeMap::new(), 0);
    for (text, v) in rows(include_str!("../../../tests/data/2-pigment-oracle.csv")) {
        let at = Vec3::new(v[0], v[1], v[2]);
        let got = pigment(text).color(at, &CONTEXT).unwrap().components();
        count += 1;
        if got.iter().zip(&v[3..]).any(|(a, b)| (f64::from(*a) - b).abs() > 1e-5) {
            note(&mut bad, text, format!("{got:?} not {:?} at {at}", &v[3..]));
        }
    }
    println!("{count} rows");
    report(bad);
}

#[test]
fn normals_are_as_measured() {
    let (mut bad, mut count) = (BTreeMap::new(), 0);
    for (text, v) in rows(include_str!("../../../tests/data/2-normal-oracle.csv")) {
        let normal = read(&format!("normal {{ {text} }}"), |p| p.normal_statement());
        let at = Vec3::new(v[0], v[1], 0.0);
        let n = normal.perturb(Vec3::new(0.0, 0.0, -1.0), at, &CONTEXT);
        let lights = [Vec3::new(1.0, 0.2, -2.0), Vec3::new(-1.0, 0.7, -2.0), Vec3::new(0.0, -1.0, -2.0)];
        let got = lights.map(|l| n.dot(l.normalize()).max(0.0));
        count += 1;
        if got.iter().zip(&v[2..]).any(|(a, b)| (a - b).abs() > 3e-5) {
            note(&mut bad, text, format!("{got:?} not {:?} at {at}", &v[2..]));
        }
    }
    println!("{count} rows");
    report(bad);
}

#[test]
fn slope_and_angle_patterns_ask_the_surface() {
    let hit = Incidence {
        point: Vec3::new(1.0, 2.0, 3.0),
        normal: Vec3::new(0.0, 1.0, 0.0),
        direction: Vec3::new(0.0, -1.0, 0.0),
        uv: Vec2::ZERO,
    };
    let value = |text: &str, hit: &Incidence| {
        let p = pigment(text);
        let context = Context { hit: Some(hit), ..CONTEXT };
        p.signal.value(p.signal.warp(hit.point), &context)
    };
    assert!((value("aoi", &hit) - 1.0).abs() < 1e-12);
    assert!((value("slope y", &hit) - 1.0).abs() < 1e-9);
    assert!((value("slope -y", &hit)).abs() < 1e-9);
    assert!((value("slope x", &hit) - 0.5).abs() < 1e-12);
    assert!((value("slope { x, 0.25, 0.75 }", &hit) - 0.5).abs() < 1e-12);
    assert_eq!(pigment("slope x").signal.value(hit.point, &CONTEXT), 0.0);
}
