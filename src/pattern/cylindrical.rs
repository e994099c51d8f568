use super::{Pattern, Setting, falloff};
use crate::math::Vec3;

/// 1 on the y axis, falling to 0 at distance 1 from it.
#[derive(Clone, Copy, Debug)]
pub struct Cylindrical;

impl Pattern for Cylindrical {
    fn value(&self, p: Vec3, _setting: &Setting) -> f64 {
        falloff((p.x * p.x + p.z * p.z).sqrt())
    }
}
