//! Nanoseconds per evaluation of noise and of the patterns built on it, one line each.
//!
//! `cargo bench --bench pattern`

use glint::math::Vec3;
use glint::math::noise::{NoiseGenerator, Turbulence, noise, vector_noise};
use glint::pattern::{
    Agate, Bozo, Cells, Context, Crackle, Granite, Leopard, Marble, Pattern, Signal, Wood, Wrinkles,
};
use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

const ROUNDS: usize = 200_000;

/// Points along a line that crosses cells in no simple order, as neighbouring rays do.
fn points() -> Vec<Vec3> {
    (0..1024).map(|i| Vec3::new(0.017, -0.011, 0.013) * f64::from(i) + Vec3::new(3.3, -7.1, 0.4)).collect()
}

/// The best of five runs.
fn measure(name: &str, mut evaluate: impl FnMut(Vec3) -> f64) {
    let points = points();
    let mut best = f64::INFINITY;
    for _ in 0..5 {
        let start = Instant::now();
        let mut sum = 0.0;
        for i in 0..ROUNDS {
            sum += evaluate(points[i & 1023]);
        }
        black_box(sum);
        best = best.min(start.elapsed().as_secs_f64());
    }
    println!("{name:24} {:8.1} ns", best / ROUNDS as f64 * 1e9);
}

fn main() {
    for (name, generator) in [
        ("noise 1", NoiseGenerator::Original),
        ("noise 2", NoiseGenerator::RangeCorrected),
        ("noise 3", NoiseGenerator::Perlin),
    ] {
        measure(name, |p| noise(p, generator));
    }
    measure("vector noise", |p| vector_noise(p).x);
    let turbulence = Turbulence { amount: Vec3::splat(0.5), ..Turbulence::default() };
    measure("vector turbulence", |p| turbulence.vector(p).x);
    measure("scalar turbulence", |p| turbulence.scalar(p, NoiseGenerator::RangeCorrected));
    let context = Context { noise: NoiseGenerator::RangeCorrected, waves: 10, hit: None };
    let patterns: [(&str, Arc<dyn Pattern>); 9] = [
        ("agate", Arc::new(Agate::default())),
        ("bozo", Arc::new(Bozo)),
        ("cells", Arc::new(Cells)),
        ("crackle", Arc::new(Crackle::default())),
        ("granite", Arc::new(Granite)),
        ("leopard", Arc::new(Leopard)),
        ("marble", Arc::new(Marble)),
        ("wood", Arc::new(Wood)),
        ("wrinkles", Arc::new(Wrinkles)),
    ];
    for (name, pattern) in patterns {
        let mut signal = Signal::new(pattern);
        measure(name, |p| signal.value(signal.warp(p), &context));
        signal.turbulence = turbulence;
        measure(&format!("{name}, turbulent"), |p| signal.value(signal.warp(p), &context));
    }
}
