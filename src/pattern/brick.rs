use super::{Character, EDGE, Modifier, Pattern, Setting, listed};
use crate::color::Color;
use crate::math::Vec3;
use std::sync::Arc;

/// Rows of bricks with mortar between them: 0 in the mortar, 1 in the bricks.
///
/// | parameter | default | meaning |
/// |---|---|---|
/// | brick_size | <8, 3, 4.5> | one brick with its mortar |
/// | mortar | 0.5 | thickness, in single precision |
#[derive(Clone, Copy, Debug)]
pub struct Brick {
    size: Vec3,
    mortar: f64,
}

impl Default for Brick {
    fn default() -> Self {
        Self::new(Vec3::new(8.0, 3.0, 4.5), 0.5)
    }
}

impl Brick {
    pub fn new(size: Vec3, mortar: f64) -> Self {
        Self { size, mortar: f64::from((mortar - 2.0 * EDGE) as f32) }
    }
}

/// The fractional part by truncation, with 1 added if it is negative.
fn fraction(t: f64) -> f64 {
    let f = t - t.trunc();
    if f < 0.0 { f + 1.0 } else { f }
}

impl Pattern for Brick {
    fn value(&self, p: Vec3, _setting: &Setting) -> f64 {
        let q = (p + Vec3::splat(EDGE + self.mortar)) / self.size;
        let mortar = self.mortar / self.size;
        if fraction(q.y) <= mortar.y {
            return 0.0;
        }
        // Every second row is shifted by half a brick.
        let (x, z) = if fraction(0.5 * q.y) <= 0.5 { (q.x, q.z + 0.5) } else { (q.x + 0.5, q.z) };
        if fraction(x) <= mortar.x || fraction(z) <= mortar.z { 0.0 } else { 1.0 }
    }

    fn character(&self) -> Character {
        Character::list(2)
    }

    fn colors(&self) -> Vec<(f32, Color)> {
        listed(&[[0.5, 0.5, 0.5], [0.6, 0.15, 0.15]])
    }

    fn modified(&self, modifier: Modifier) -> Option<Arc<dyn Pattern>> {
        match modifier {
            Modifier::BrickSize(size) => Some(Arc::new(Self { size, ..*self })),
            Modifier::Mortar(mortar) => Some(Arc::new(Self::new(self.size, mortar))),
            _ => None,
        }
    }
}
