use super::{NoiseGenerator, Pattern, Setting};
use crate::math::Vec3;
use crate::math::noise::{noise, vector_noise};

/// Ten octaves of noise.
#[derive(Clone, Copy, Debug)]
pub struct Wrinkles;

impl Pattern for Wrinkles {
    fn value(&self, p: Vec3, setting: &Setting) -> f64 {
        let original = setting.noise == NoiseGenerator::Original;
        let (mut sum, mut frequency) = (0.0, 1.0);
        for _ in 0..10 {
            let n = noise(frequency * p, setting.noise);
            let n = if original { n } else { (2.0 * n - 0.5).clamp(0.0, 1.0) };
            sum += n / frequency;
            frequency *= 2.0;
        }
        0.5 * sum
    }

    fn perturb(&self, n: Vec3, amount: f64, p: Vec3, _setting: &Setting) -> Option<Vec3> {
        let (mut sum, mut frequency) = (Vec3::ZERO, 1.0);
        for _ in 0..10 {
            sum += vector_noise(frequency * p).abs() / frequency;
            frequency *= 2.0;
        }
        Some(n + amount * sum)
    }
}
