use super::{NoiseGenerator, Pattern, Setting};
use crate::math::Vec3;
use crate::math::noise::octaves;

/// Six octaves of noise folded at its middle.
#[derive(Clone, Copy, Debug)]
pub struct Granite;

impl Pattern for Granite {
    fn value(&self, p: Vec3, setting: &Setting) -> f64 {
        let original = setting.noise == NoiseGenerator::Original;
        let mut noise = [0.0; 6];
        octaves(p, 4.0, 2.0, setting.noise, &mut noise);
        let (mut sum, mut weight) = (0.0, 1.0);
        for &n in &noise {
            let folded = if original { (0.5 - n).abs() } else { (1.0 - 2.0 * n).abs().min(0.5) };
            sum += folded * weight;
            weight *= 0.5;
        }
        sum
    }
}
