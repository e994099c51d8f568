use super::{Pattern, Setting};
use crate::math::Vec3;
use crate::math::noise::{noise, vector_noise};

/// The cube of noise: mostly flat, with a few deep spots.
#[derive(Clone, Copy, Debug)]
pub struct Dents;

impl Pattern for Dents {
    fn value(&self, p: Vec3, setting: &Setting) -> f64 {
        let n = noise(p, setting.noise);
        n * n * n
    }

    fn perturb(&self, n: Vec3, amount: f64, p: Vec3, setting: &Setting) -> Option<Vec3> {
        Some(n + amount * self.value(p, setting) * vector_noise(p))
    }
}
