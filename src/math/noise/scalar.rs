//! Noise without vector instructions, one number after the other: what runs where the processor has none, and
//! what the others must equal to the bit.

use super::{NoiseGenerator, gradient, lattice};
use crate::math::Vec3;

/// See [`noise`](super::noise).
pub fn noise(p: Vec3, generator: NoiseGenerator) -> f64 {
    let sum = if generator == NoiseGenerator::Perlin { gradient::sum(p) } else { lattice::sum(p) };
    generator.level(sum)
}

/// See [`vector_noise`](super::vector_noise).
pub fn vector_noise(p: Vec3) -> Vec3 {
    lattice::vector_noise(p)
}

/// See [`octaves`](super::octaves).
pub fn octaves(p: Vec3, [first, lambda]: [f64; 2], generator: NoiseGenerator, out: &mut [f64]) {
    let mut scale = first;
    for value in out {
        *value = noise(scale * p, generator);
        scale *= lambda;
    }
}

/// See [`planar_octaves`](super::planar_octaves).
pub fn planar_octaves(p: Vec3, [lambda, omega]: [f64; 2], count: usize) -> [f64; 2] {
    let sum = vector_octaves(p, [lambda, omega], count, false);
    [sum.x, sum.y]
}

/// See [`vector_octaves`](super::vector_octaves).
pub fn vector_octaves(p: Vec3, [lambda, omega]: [f64; 2], count: usize, absolute: bool) -> Vec3 {
    let (mut sum, mut scale, mut weight) = (Vec3::ZERO, 1.0, 1.0);
    for _ in 0..count {
        let term = vector_noise(scale * p);
        sum += weight * if absolute { term.abs() } else { term };
        scale *= lambda;
        weight *= omega;
    }
    sum
}
