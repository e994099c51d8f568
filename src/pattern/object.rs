use super::{Character, Pattern, Setting, listed};
use crate::color::Color;
use crate::math::Vec3;
use crate::math::field::Solid;
use std::sync::Arc;

/// 1 inside an object, 0 outside.
#[derive(Clone, Debug)]
pub struct InsideOut(pub Arc<dyn Solid>);

impl Pattern for InsideOut {
    fn value(&self, p: Vec3, _setting: &Setting) -> f64 {
        f64::from(self.0.contains(p))
    }

    fn depth(&self) -> u32 {
        1 + self.0.depth()
    }

    fn character(&self) -> Character {
        Character::list(2)
    }

    fn colors(&self) -> Vec<(f32, Color)> {
        listed(&[[0.0, 0.0, 1.0], [0.0, 1.0, 0.0]])
    }
}
