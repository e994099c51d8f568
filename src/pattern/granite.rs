use super::{NoiseGenerator, Pattern, Setting};
use crate::math::Vec3;
use crate::math::noise::noise;

/// Six octaves of noise folded at its middle.
#[derive(Clone, Copy, Debug)]
pub struct Granite;

impl Pattern for Granite {
    fn value(&self, p: Vec3, setting: &Setting) -> f64 {
        let original = setting.noise == NoiseGenerator::Original;
        let (mut sum, mut frequency) = (0.0, 1.0);
        for _ in 0..6 {
            let n = noise(4.0 * frequency * p, setting.noise);
            let folded = if original { (0.5 - n).abs() } else { (1.0 - 2.0 * n).abs().min(0.5) };
            sum += folded / frequency;
            frequency *= 2.0;
        }
        sum
    }
}
