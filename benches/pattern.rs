//! What noise and patterns cost: evaluations per second of noise, scalar and with vector instructions, then
//! nanoseconds of every pattern, warp and normal of `docs/patterns/list.txt`.
//!
//! `cargo bench --bench pattern`, with a word after `--` for the lines that contain it.

use glint::interp::interpret_str;
use glint::material::{Layer, PigmentKind, Texture};
use glint::math::noise::{self, NoiseGenerator, Turbulence, scalar};
use glint::math::{Vec2, Vec3};
use glint::pattern::{Context, Incidence};
use std::hint::black_box;
use std::time::Instant;

const ROUNDS: usize = 100_000;

/// Points along a line that crosses cells in no simple order, as neighbouring rays do.
fn points() -> Vec<Vec3> {
    (0..1024).map(|i| Vec3::new(0.017, -0.011, 0.013) * f64::from(i) + Vec3::new(3.3, -7.1, 0.4)).collect()
}

/// Seconds per evaluation: the best of seven runs.
fn seconds(mut evaluate: impl FnMut(Vec3) -> f64) -> f64 {
    let points = points();
    let mut best = f64::INFINITY;
    for _ in 0..7 {
        let start = Instant::now();
        let mut sum = 0.0;
        for i in 0..ROUNDS {
            sum += evaluate(points[i & 1023]);
        }
        black_box(sum);
        best = best.min(start.elapsed().as_secs_f64());
    }
    best / ROUNDS as f64
}

/// One line for the scalar path and the vector path of the same function.
fn compare(name: &str, per_call: usize, plain: impl FnMut(Vec3) -> f64, vector: impl FnMut(Vec3) -> f64) {
    let (plain, vector) = (seconds(plain), seconds(vector));
    let millions = |s: f64| per_call as f64 / s * 1e-6;
    println!(
        "{name:28} {:8.1} {:8.1} million/s   ratio of times {:.2}",
        millions(plain),
        millions(vector),
        vector / plain
    );
}

fn sum(v: Vec3) -> f64 {
    v.x + v.y + v.z
}

/// Noise evaluations per second and core.
fn noises(wanted: &dyn Fn(&str) -> bool) {
    println!("{:28} {:>8} {:>8}", "noise", "scalar", "vector");
    for number in 1..=3 {
        let generator = NoiseGenerator::from_number(number).unwrap();
        let name = format!("noise {number}");
        if wanted(&name) {
            compare(&name, 1, |p| scalar::noise(p, generator), |p| noise::noise(p, generator));
        }
        let name = format!("noise {number}, 10 octaves");
        if wanted(&name) {
            let (mut a, mut b) = ([0.0; 10], [0.0; 10]);
            let plain = |p| {
                scalar::octaves(p, [1.0, 2.1], generator, &mut a);
                a.iter().sum()
            };
            let vector = |p| {
                noise::octaves(p, 1.0, 2.1, generator, &mut b);
                b.iter().sum()
            };
            compare(&name, 10, plain, vector);
        }
    }
    if wanted("vector noise") {
        compare("vector noise", 1, |p| sum(scalar::vector_noise(p)), |p| sum(noise::vector_noise(p)));
    }
    if wanted("vector noise, 10 octaves") {
        let plain = |p| sum(scalar::vector_octaves(p, [2.1, 0.5], 10, false));
        let vector = |p| sum(noise::vector_octaves(p, [2.1, 0.5], 10, false));
        compare("vector noise, 10 octaves", 10, plain, vector);
    }
    let turbulence = Turbulence { amount: Vec3::splat(0.5), ..Turbulence::default() };
    if wanted("turbulence") {
        println!("{:28} {:8.1} ns", "turbulence, vector", seconds(|p| sum(turbulence.vector(p))) * 1e9);
        let scalar = |p| turbulence.scalar(p, NoiseGenerator::RangeCorrected);
        println!("{:28} {:8.1} ns", "turbulence, scalar", seconds(scalar) * 1e9);
    }
}

/// The layer that a plane with this pigment or normal has.
fn layer(kind: &str, text: &str) -> Layer {
    let what = if kind == "normal" { "normal" } else { "pigment" };
    let scene =
        format!("#version 3.7; global_settings {{ assumed_gamma 1 }} plane {{ z, 0 {what} {{ {text} }} }}");
    let outcome = interpret_str(&scene);
    let scene = outcome.scene.unwrap_or_else(|e| panic!("{text}: {e:?}"));
    match &*scene.objects[0].textures[0].value {
        Texture::Layers(layers) => layers[0].clone(),
        Texture::Patterned(_) => panic!("{text}: no plain texture"),
    }
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with('-')).collect();
    let wanted = |name: &str| words.is_empty() || words.iter().any(|w| name.contains(w.as_str()));
    noises(&wanted);
    let hit = Incidence { point: Vec3::ONE, normal: Vec3::Y, direction: -Vec3::Y, uv: Vec2::new(0.3, 0.4) };
    let context = Context { noise: NoiseGenerator::RangeCorrected, waves: 10, hit: Some(&hit) };
    println!("\n{:28} {:>8}", "pattern", "ns");
    let lines = include_str!("../docs/patterns/list.txt").lines().filter(|l| !l.starts_with('#'));
    for line in lines {
        let [kind, name, text] = *line.splitn(3, '|').map(str::trim).collect::<Vec<_>>() else {
            panic!("{line}");
        };
        let name = format!("{kind}: {name}");
        if !wanted(&name) {
            continue;
        }
        let layer = layer(kind, text);
        let pigment = &layer.pigment;
        let cost = match &layer.normal {
            Some(normal) => seconds(|p| sum(normal.perturb(Vec3::Y, p, &context))),
            None if matches!(pigment.kind, PigmentKind::Patterned) && kind != "map" => {
                seconds(|p| pigment.signal.value(pigment.signal.warp(p), &context))
            }
            None => seconds(|p| f64::from(pigment.color_or_clear(p, &context).rgb.x)),
        };
        println!("{name:40} {:8.1} ns", cost * 1e9);
    }
}
