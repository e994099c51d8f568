use super::{Modifier, Pattern, Setting, keyed};
use crate::color::Color;
use crate::math::Vec3;
use std::f64::consts::PI;
use std::sync::Arc;

/// Bands along z, stirred by turbulence: `min(1, (1 + sin 2π(1.3u + 1.1z)) / 2) ^ 0.77`, where `u` is
/// `agate_turb` times scalar turbulence.
///
/// | parameter | default |
/// |---|---|
/// | agate_turb | 1 |
#[derive(Clone, Copy, Debug)]
pub struct Agate {
    pub turbulence: f64,
}

impl Default for Agate {
    fn default() -> Self {
        Self { turbulence: 1.0 }
    }
}

impl Pattern for Agate {
    fn value(&self, p: Vec3, setting: &Setting) -> f64 {
        let u = self.turbulence * setting.turbulence.scalar(p, setting.noise);
        let band = 0.5 * ((2.0 * PI * (1.3 * u + 1.1 * p.z)).sin() + 1.0);
        band.clamp(0.0, 1.0).powf(0.77)
    }

    fn colors(&self) -> Vec<(f32, Color)> {
        keyed(&[
            (0.0, [1.0, 1.0, 1.0]),
            (0.5, [0.95, 0.75, 0.5]),
            (0.5, [0.9, 0.7, 0.5]),
            (0.6, [0.9, 0.7, 0.4]),
            (0.6, [1.0, 0.7, 0.4]),
            (1.0, [0.6, 0.3, 0.0]),
        ])
    }

    fn modified(&self, modifier: Modifier) -> Option<Arc<dyn Pattern>> {
        match modifier {
            Modifier::AgateTurbulence(turbulence) => Some(Arc::new(Self { turbulence })),
            _ => None,
        }
    }
}
