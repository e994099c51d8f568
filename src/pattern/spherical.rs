use super::{Pattern, Setting, falloff};
use crate::math::Vec3;

/// 1 at the origin, falling to 0 at distance 1.
#[derive(Clone, Copy, Debug)]
pub struct Spherical;

impl Pattern for Spherical {
    fn value(&self, p: Vec3, _setting: &Setting) -> f64 {
        falloff(p.length())
    }
}
