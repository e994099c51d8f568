//! Colours of tiny scenes against measured ones, through the whole pipeline.
//!
//! `3-oracle-classes.csv` says how each scene is to be compared: `closed` scenes row by row, `sampled` ones
//! (random draws) by their mean over the picture, `tolerance` ones not at all: they show a built-in
//! tolerance of the reference that Glint does not have, and stand in `deviations.csv`.

use glint::interp::interpret_str;
use glint::trace::{Settings, Tracer};
use glint::world::World;
use std::collections::BTreeMap;
use std::fs;

/// Rounding of 16-bit values and of single precision along the way.
const TOLERANCE: f64 = 2.5e-5;

/// Renderings of a sampled scene that are averaged.
const SAMPLES: u32 = 64;

struct Row {
    x: u32,
    y: u32,
    color: [f64; 3],
    alpha: Option<f64>,
}

struct Oracle {
    width: u32,
    height: u32,
    rows: Vec<Row>,
}

fn data(name: &str) -> String {
    let path = format!("{}/tests/data/{name}", env!("CARGO_MANIFEST_DIR"));
    fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"))
}

fn oracles() -> BTreeMap<String, Oracle> {
    let mut all: BTreeMap<String, Oracle> = BTreeMap::new();
    for line in data("3-oracle.csv").lines().skip(2) {
        let f: Vec<&str> = line.splitn(10, ',').collect();
        let number = |i: usize| f[i].parse::<f64>().unwrap();
        let (width, height) = (number(1) as u32, number(2) as u32);
        let oracle = all.entry(f[0].to_owned()).or_insert(Oracle { width, height, rows: Vec::new() });
        let color = [number(5), number(6), number(7)];
        oracle.rows.push(Row { x: number(3) as u32, y: number(4) as u32, color, alpha: f[8].parse().ok() });
    }
    all
}

fn classes() -> BTreeMap<String, String> {
    let rows = data("3-oracle-classes.csv");
    let fields = rows.lines().skip(2).map(|l| l.split(',').collect::<Vec<_>>());
    fields.map(|f| (f[0].to_owned(), f[1].to_owned())).collect()
}

/// Colours and alphas in the order of the oracle's rows, as a 16-bit file keeps them.
fn rendered(name: &str, oracle: &Oracle, sample: u32) -> Result<Vec<([f64; 3], f64)>, String> {
    let outcome = interpret_str(&data(&format!("3-oracle-scenes/{name}.pov")));
    let scene = outcome.scene.map_err(|e| format!("{name}: {}", e.message))?;
    let world = World::prepare(scene);
    let settings = Settings {
        width: oracle.width,
        height: oracle.height,
        alpha: oracle.rows[0].alpha.is_some(),
        ..Settings::default()
    };
    let mut tracer = Tracer::new(&world, &settings);
    let mut pixel = |row: &Row| {
        tracer.seed(row.x, row.y, sample);
        let seen = tracer.pixel(f64::from(row.x) + 0.5, f64::from(row.y) + 0.5);
        let stored = |c: f32| (f64::from(c.clamp(0.0, 1.0)) * 65535.0).round() / 65535.0;
        (seen.rgb.to_array().map(stored), 1.0 - f64::from(seen.transmit))
    };
    Ok(oracle.rows.iter().map(&mut pixel).collect())
}

/// Runs `f` on a thread whose stack fits deep recursion.
fn on_big_stack(f: impl FnOnce() + Send + 'static) {
    let thread = std::thread::Builder::new().stack_size(256 << 20).spawn(f).unwrap();
    if let Err(panic) = thread.join() {
        std::panic::resume_unwind(panic);
    }
}

#[test]
fn closed_scenes_agree_row_by_row() {
    on_big_stack(|| {
        let classes = classes();
        let (mut passed, mut failures) = (BTreeMap::<String, (u32, u32)>::new(), Vec::new());
        for (name, oracle) in &oracles() {
            if classes[name] != "closed" {
                continue;
            }
            let group = name.split('-').next().unwrap_or(name).to_owned();
            let pixels = match rendered(name, oracle, 0) {
                Ok(pixels) => pixels,
                Err(error) => {
                    failures.push(error);
                    continue;
                }
            };
            for (row, (color, alpha)) in oracle.rows.iter().zip(&pixels) {
                let off = (0..3).map(|i| (row.color[i] - color[i]).abs()).fold(0.0, f64::max);
                let off = off.max(row.alpha.map_or(0.0, |a| (a - alpha).abs()));
                let count = passed.entry(group.clone()).or_default();
                count.1 += 1;
                if off <= TOLERANCE {
                    count.0 += 1;
                } else {
                    failures.push(format!("{name} ({}, {}): {:?}, got {color:?}", row.x, row.y, row.color));
                }
            }
        }
        println!("{passed:?}");
        assert!(failures.is_empty(), "{passed:?}\n{}", failures.join("\n"));
    });
}

#[test]
fn sampled_scenes_agree_in_the_mean() {
    on_big_stack(|| {
        let (classes, mut failures) = (classes(), Vec::new());
        for (name, oracle) in &oracles() {
            if classes[name] != "sampled" {
                continue;
            }
            let samples: Vec<_> = (0..SAMPLES).map(|i| rendered(name, oracle, i).unwrap()).collect();
            let n = oracle.rows.len() as f64;
            for i in 0..3 {
                let expected = oracle.rows.iter().map(|r| r.color[i]).sum::<f64>() / n;
                let drawn = samples.iter().flatten().map(|p| p.0[i]);
                let mean = drawn.clone().sum::<f64>() / (n * f64::from(SAMPLES));
                let variance = drawn.map(|c| (c - mean).powi(2)).sum::<f64>() / (n * f64::from(SAMPLES));
                // Four standard errors of the measured mean.
                if (mean - expected).abs() >= 4.0 * (variance / n).sqrt() + 1e-3 {
                    failures.push(format!("{name}: {expected}, got {mean}"));
                }
            }
        }
        assert!(failures.is_empty(), "{}", failures.join("\n"));
    });
}

/// Rows that show a built-in tolerance of the reference stand in `deviations.csv` with Glint's own value.
#[test]
fn deviations_are_as_noted() {
    on_big_stack(|| {
        let (classes, noted) = (classes(), deviations());
        let mut seen = Vec::new();
        for (name, oracle) in &oracles() {
            if classes[name] != "tolerance" {
                continue;
            }
            for (row, (color, _)) in oracle.rows.iter().zip(rendered(name, oracle, 0).unwrap()) {
                let text = |c: [f64; 3]| format!("{:.6} {:.6} {:.6}", c[0], c[1], c[2]);
                if (0..3).any(|i| (row.color[i] - color[i]).abs() > TOLERANCE) {
                    let place = format!("{name} {} {}", row.x, row.y);
                    seen.push(format!("3-oracle.csv,{place},{},{}", text(row.color), text(color)));
                }
            }
        }
        assert_eq!(seen, noted, "\n{}", seen.join("\n"));
    });
}

/// The rows of `deviations.csv` that belong to `3-oracle.csv`, without their reasons.
fn deviations() -> Vec<String> {
    let path = format!("{}/tests/deviations.csv", env!("CARGO_MANIFEST_DIR"));
    let all = fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"));
    let ours = all.lines().filter(|l| l.starts_with("3-oracle.csv,"));
    ours.filter_map(|l| l.rsplit_once(',').map(|(row, _)| row.to_owned())).collect()
}
