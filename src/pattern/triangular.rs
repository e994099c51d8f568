use super::{Character, Cubic, Pattern, Setting};
use crate::color::Color;
use crate::math::Vec3;

/// Triangles of side 1 in the xz plane, of six kinds.
#[derive(Clone, Copy, Debug)]
pub struct Triangular;

impl Pattern for Triangular {
    fn value(&self, p: Vec3, _setting: &Setting) -> f64 {
        const ROOT_3: f64 = 1.7320508075688772;
        let (mut x, mut z) = (p.x.rem_euclid(3.0), p.z.rem_euclid(ROOT_3));
        let a = (x as i64).min(2);
        x -= a as f64;
        let upper = z >= ROOT_3 / 2.0;
        if upper {
            z = ROOT_3 - z;
        }
        let k = if x == 0.0 {
            1
        } else {
            match (z / x < ROOT_3, z / (1.0 - x) < ROOT_3) {
                (true, true) => 0,
                (false, true) => 1,
                (true, false) => 3,
                // Above the apex, which only rounding reaches.
                (false, false) => 1,
            }
        };
        let kind = if k % 2 == 1 { (k + 2 * a) % 6 } else { (6 + k - 2 * a) % 6 };
        (if upper { 5 - kind } else { kind }) as f64
    }

    fn character(&self) -> Character {
        Character::list(6)
    }

    fn colors(&self) -> Vec<(f32, Color)> {
        Cubic.colors()
    }
}
