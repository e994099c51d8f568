use super::{Character, EDGE, Pattern, Setting, listed};
use crate::color::Color;
use crate::math::{Vec3, floor_of, is_odd};

/// Unit cubes of two kinds in turn.
#[derive(Clone, Copy, Debug)]
pub struct Checker;

impl Pattern for Checker {
    fn value(&self, p: Vec3, _setting: &Setting) -> f64 {
        let cell = floor_of(p + Vec3::splat(EDGE));
        f64::from(is_odd(cell.x + cell.y + cell.z))
    }

    fn character(&self) -> Character {
        Character::list(2)
    }

    fn colors(&self) -> Vec<(f32, Color)> {
        listed(&[[0.0, 0.0, 1.0], [0.0, 1.0, 0.0]])
    }
}
