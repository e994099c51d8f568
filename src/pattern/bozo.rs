use super::{Pattern, Setting, keyed};
use crate::color::Color;
use crate::math::Vec3;
use crate::math::noise::{noise, vector_noise};

/// Plain noise.
#[derive(Clone, Copy, Debug)]
pub struct Bozo;

impl Pattern for Bozo {
    fn value(&self, p: Vec3, setting: &Setting) -> f64 {
        noise(p, setting.noise)
    }

    fn colors(&self) -> Vec<(f32, Color)> {
        keyed(&[
            (0.4, [1.0, 1.0, 1.0]),
            (0.4, [0.0, 1.0, 0.0]),
            (0.6, [0.0, 1.0, 0.0]),
            (0.6, [0.0, 0.0, 1.0]),
            (0.8, [0.0, 0.0, 1.0]),
            (0.8, [1.0, 0.0, 0.0]),
        ])
    }
}

/// Plain noise again, in black and white by default.
#[derive(Clone, Copy, Debug)]
pub struct Spotted;

impl Pattern for Spotted {
    fn value(&self, p: Vec3, setting: &Setting) -> f64 {
        noise(p, setting.noise)
    }
}

/// Plain noise once more; in normals, vector noise.
#[derive(Clone, Copy, Debug)]
pub struct Bumps;

impl Pattern for Bumps {
    fn value(&self, p: Vec3, setting: &Setting) -> f64 {
        noise(p, setting.noise)
    }

    fn perturb(&self, n: Vec3, amount: f64, p: Vec3, _setting: &Setting) -> Option<Vec3> {
        Some(n + amount * vector_noise(p))
    }
}
