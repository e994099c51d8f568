use super::{Pattern, Setting, falloff};
use crate::math::Vec3;

/// 1 at the origin, falling to 0 at the faces of the cube -1 ..= 1.
#[derive(Clone, Copy, Debug)]
pub struct Boxed;

impl Pattern for Boxed {
    fn value(&self, p: Vec3, _setting: &Setting) -> f64 {
        falloff(p.abs().max_element())
    }
}
