use super::{Character, Modifier, Pattern, Setting};
use crate::math::{Vec3, floor};
use std::sync::Arc;

/// Unit cubes that bulge.
///
/// | parameter | default | meaning |
/// |---|---|---|
/// | control0 | 1 | slope at the middle of a cube, in single precision |
/// | control1 | 1 | slope at its rim |
#[derive(Clone, Copy, Debug)]
pub struct Quilted {
    pub control0: f64,
    pub control1: f64,
}

impl Default for Quilted {
    fn default() -> Self {
        Self { control0: 1.0, control1: 1.0 }
    }
}

impl Quilted {
    /// The place relative to the middle of its cube.
    fn offset(p: Vec3) -> Vec3 {
        // Below 0 cubes own their upper faces' lower neighbours: -1 counts to the cube -2 .. -1.
        let cube = |t: f64| if t >= 0.0 { floor(t) } else { -floor(-t) - 1.0 };
        p - Vec3::new(cube(p.x), cube(p.y), cube(p.z)) - Vec3::splat(0.5)
    }

    /// A cubic curve over the distance from the middle.
    fn curve(&self, r: f64) -> f64 {
        let s = 1.0 - r;
        1.154700538 * (r * r * r + 3.0 * r * s * s * self.control0 + 3.0 * r * r * s * self.control1)
    }
}

impl Pattern for Quilted {
    fn value(&self, p: Vec3, _setting: &Setting) -> f64 {
        let d = Self::offset(p);
        self.curve(d.length()) * d.abs().element_sum() / 3.0
    }

    fn character(&self) -> Character {
        Character::APERIODIC
    }

    fn perturb(&self, n: Vec3, amount: f64, p: Vec3, _setting: &Setting) -> Option<Vec3> {
        let d = Self::offset(p);
        Some(n + amount * self.curve(d.length()) * d)
    }

    fn modified(&self, modifier: Modifier) -> Option<Arc<dyn Pattern>> {
        match modifier {
            Modifier::Control0(control0) => Some(Arc::new(Self { control0, ..*self })),
            Modifier::Control1(control1) => Some(Arc::new(Self { control1, ..*self })),
            _ => None,
        }
    }
}
