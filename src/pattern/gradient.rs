use super::{Pattern, Setting};
use crate::math::Vec3;

/// Distance along a direction, wrapped at 1.
#[derive(Clone, Copy, Debug)]
pub struct Gradient {
    direction: Vec3,
}

impl Gradient {
    /// `direction` need not have unit length.
    pub fn new(direction: Vec3) -> Self {
        Self { direction: direction.normalize_or_zero() }
    }
}

impl Pattern for Gradient {
    fn value(&self, p: Vec3, _setting: &Setting) -> f64 {
        let v = p.dot(self.direction);
        if v > 1.0 { v % 1.0 } else { v }
    }
}
