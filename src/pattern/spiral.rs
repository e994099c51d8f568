use super::{Character, Pattern, Setting, Wave, triangle};
use crate::math::Vec3;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Spiral arms around the z axis: `z + r + arms φ/2π`, displaced by scalar turbulence. `spiral2` adds rings.
#[derive(Clone, Copy, Debug)]
pub struct Spiral {
    arms: f64,
    /// Whether this is `spiral2`.
    double: bool,
}

impl Spiral {
    /// `spiral1`; the number of arms is cut to a whole number.
    pub fn single(arms: f64) -> Self {
        Self { arms: arms.trunc(), double: false }
    }

    /// `spiral2`.
    pub fn double(arms: f64) -> Self {
        Self { arms: arms.trunc(), double: true }
    }
}

impl Pattern for Spiral {
    fn value(&self, p: Vec3, setting: &Setting) -> f64 {
        let r = p.x.hypot(p.y);
        let phi = if r == 0.0 {
            0.0
        } else if p.x >= 0.0 {
            FRAC_PI_2 + (p.y / r).asin()
        } else {
            3.0 * FRAC_PI_2 - (p.y / r).asin()
        };
        let amount = setting.turbulence.amount.x;
        let shift = if amount == 0.0 { 0.0 } else { amount * setting.turbulence.scalar(p, setting.noise) };
        let single = p.z + r + self.arms * phi / TAU + shift;
        if self.double { triangle(r) + triangle(single) } else { single }
    }

    fn character(&self) -> Character {
        Character { wave: Some(Wave::Triangle), ..Character::SMOOTH }
    }
}
