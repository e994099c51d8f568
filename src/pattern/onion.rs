use super::{Pattern, Setting};
use crate::math::Vec3;

/// Distance from the origin, wrapped at 1.
#[derive(Clone, Copy, Debug)]
pub struct Onion;

impl Pattern for Onion {
    fn value(&self, p: Vec3, _setting: &Setting) -> f64 {
        p.length() % 1.0
    }
}
