use super::{Pattern, Setting};
use crate::math::Vec3;
use crate::math::field::Field;
use std::sync::Arc;

/// A function of space; values above 1 wrap around.
#[derive(Clone, Debug)]
pub struct Function(pub Arc<dyn Field>);

impl Pattern for Function {
    fn value(&self, p: Vec3, _setting: &Setting) -> f64 {
        let v = self.0.value(p);
        if v > 1.0 { v % 1.0 } else { v }
    }

    fn depth(&self) -> u32 {
        1 + self.0.depth()
    }
}
