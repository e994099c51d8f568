use super::{Character, Pattern, Setting, listed};
use crate::color::Color;
use crate::math::{Vec3, floor, is_odd};

/// Unit squares in the xz plane, of four kinds.
#[derive(Clone, Copy, Debug)]
pub struct Square;

impl Pattern for Square {
    fn value(&self, p: Vec3, _setting: &Setting) -> f64 {
        let odd = |v: f64| is_odd(floor(v));
        match (odd(p.x), odd(p.z)) {
            (false, false) => 0.0,
            (false, true) => 1.0,
            (true, true) => 2.0,
            (true, false) => 3.0,
        }
    }

    fn character(&self) -> Character {
        Character::list(4)
    }

    fn colors(&self) -> Vec<(f32, Color)> {
        listed(&[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 1.0, 0.0]])
    }
}
