use super::{Pattern, Setting, falloff};
use crate::math::Vec3;

/// 1 on the xz plane, falling to 0 at distance 1 from it.
#[derive(Clone, Copy, Debug)]
pub struct Planar;

impl Pattern for Planar {
    fn value(&self, p: Vec3, _setting: &Setting) -> f64 {
        falloff(p.y.abs())
    }
}
