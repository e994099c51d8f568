use super::{Character, Pattern, Setting, Wave, keyed};
use crate::color::Color;
use crate::math::Vec3;

/// Bands along x, displaced by scalar turbulence.
#[derive(Clone, Copy, Debug)]
pub struct Marble;

impl Pattern for Marble {
    fn value(&self, p: Vec3, setting: &Setting) -> f64 {
        let amount = setting.turbulence.amount.x;
        if amount == 0.0 { p.x } else { p.x + amount * setting.turbulence.scalar(p, setting.noise) }
    }

    fn character(&self) -> Character {
        Character { wave: Some(Wave::Triangle), absorbs_turbulence: true, ..Character::SMOOTH }
    }

    fn colors(&self) -> Vec<(f32, Color)> {
        keyed(&[(0.0, [0.9, 0.8, 0.8]), (0.9, [0.9, 0.08, 0.08]), (0.9, [0.0, 0.0, 0.0])])
    }
}
