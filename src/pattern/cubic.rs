use super::{Character, Pattern, Setting, listed};
use crate::color::Color;
use crate::math::Vec3;

/// Six pyramids that meet at the origin, in the order +x, +y, +z, -x, -y, -z.
#[derive(Clone, Copy, Debug)]
pub struct Cubic;

/// Which pyramid holds `p`; the first one on shared faces.
pub(super) fn pyramid(p: Vec3) -> usize {
    let a = p.abs();
    if p.x >= 0.0 && p.x >= a.y && p.x >= a.z {
        0
    } else if p.y >= 0.0 && p.y >= a.x && p.y >= a.z {
        1
    } else if p.z >= 0.0 && p.z >= a.x && p.z >= a.y {
        2
    } else if p.x < 0.0 && p.x <= -a.y && p.x <= -a.z {
        3
    } else if p.y < 0.0 && p.y <= -a.x && p.y <= -a.z {
        4
    } else {
        5
    }
}

impl Pattern for Cubic {
    fn value(&self, p: Vec3, _setting: &Setting) -> f64 {
        pyramid(p) as f64
    }

    fn character(&self) -> Character {
        Character::list(6)
    }

    fn colors(&self) -> Vec<(f32, Color)> {
        listed(&[
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, 0.0, 1.0],
            [1.0, 1.0, 0.0],
            [0.0, 1.0, 1.0],
            [1.0, 0.0, 1.0],
        ])
    }
}
