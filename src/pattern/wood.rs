use super::{Character, Pattern, Setting, Wave, keyed};
use crate::color::Color;
use crate::math::Vec3;
use std::f64::consts::TAU;

/// Rings around the z axis, bent by turbulence.
#[derive(Clone, Copy, Debug)]
pub struct Wood;

impl Pattern for Wood {
    fn value(&self, p: Vec3, setting: &Setting) -> f64 {
        let amount = setting.turbulence.amount;
        if amount.x == 0.0 && amount.y == 0.0 {
            return p.x.hypot(p.y);
        }
        let [dx, dy] = setting.turbulence.planar(p);
        let x = p.x + (TAU * (p.x + dx) * amount.x).sin();
        let y = p.y + (TAU * (p.y + dy) * amount.y).sin();
        x.hypot(y)
    }

    fn character(&self) -> Character {
        Character { wave: Some(Wave::Triangle), absorbs_turbulence: true, ..Character::SMOOTH }
    }

    fn colors(&self) -> Vec<(f32, Color)> {
        keyed(&[(0.6, [0.666, 0.312, 0.2]), (0.6, [0.4, 0.1333, 0.066])])
    }
}
