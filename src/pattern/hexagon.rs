use super::{Character, Pattern, Setting, listed};
use crate::color::Color;
use crate::math::{Vec3, floor};

/// Hexagons of side 1 in the xz plane, of three kinds.
#[derive(Clone, Copy, Debug)]
pub struct Hexagon;

/// Steps of half a side along x, and of half a height along z, in which the pattern repeats after six.
const HALF_SIDE: f64 = 0.5;
const HALF_HEIGHT: f64 = 0.866025404;

impl Pattern for Hexagon {
    fn value(&self, p: Vec3, _setting: &Setting) -> f64 {
        let z = if p.z < 0.0 { 6.0 * HALF_HEIGHT - p.z.abs() } else { p.z };
        let reduced = |v: f64| v - 6.0 * floor(v / 6.0);
        let (a, b) = (reduced(p.x.abs() / HALF_SIDE), reduced(z / HALF_HEIGHT));
        let (column, row) = (floor(a), floor(b));
        let (i, j) = ((column as usize).min(5), (row as usize).min(5));
        match i {
            0 | 5 => [0.0, 1.0, 1.0, 2.0, 2.0, 0.0][j],
            2 | 3 => [2.0, 2.0, 0.0, 0.0, 1.0, 1.0][j],
            _ => {
                // Columns that slanted sides cross.
                let (u, w) = (a - column, b - row);
                let u = if (i + j) % 2 == 1 { 1.0 - u } else { u };
                let u = if u == 0.0 { 0.0001 } else { u };
                if w / u < 1.0 { [0.0, 2.0, 1.0][j % 3] } else { [2.0, 1.0, 0.0][j % 3] }
            }
        }
    }

    fn character(&self) -> Character {
        Character::list(3)
    }

    fn colors(&self) -> Vec<(f32, Color)> {
        listed(&[[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]])
    }
}
