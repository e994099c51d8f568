use super::{NoiseGenerator, Pattern, Setting};
use crate::math::Vec3;
use crate::math::noise::{octaves, vector_octaves};

/// Ten octaves of noise.
#[derive(Clone, Copy, Debug)]
pub struct Wrinkles;

impl Pattern for Wrinkles {
    fn value(&self, p: Vec3, setting: &Setting) -> f64 {
        let original = setting.noise == NoiseGenerator::Original;
        let mut noise = [0.0; 10];
        octaves(p, 1.0, 2.0, setting.noise, &mut noise);
        let (mut sum, mut weight) = (0.0, 1.0);
        for n in noise {
            let n = if original { n } else { (2.0 * n - 0.5).clamp(0.0, 1.0) };
            sum += n * weight;
            weight *= 0.5;
        }
        0.5 * sum
    }

    fn perturb(&self, n: Vec3, amount: f64, p: Vec3, _setting: &Setting) -> Option<Vec3> {
        let mut noise = [Vec3::ZERO; 10];
        vector_octaves(p, 2.0, &mut noise);
        let (mut sum, mut weight) = (Vec3::ZERO, 1.0);
        for d in noise {
            sum += d.abs() * weight;
            weight *= 0.5;
        }
        Some(n + amount * sum)
    }
}
