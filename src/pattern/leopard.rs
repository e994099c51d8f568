use super::{Pattern, Setting};
use crate::math::Vec3;

/// `((sin x + sin y + sin z) / 3)²`.
#[derive(Clone, Copy, Debug)]
pub struct Leopard;

impl Pattern for Leopard {
    fn value(&self, p: Vec3, _setting: &Setting) -> f64 {
        let v = (p.x.sin() + p.y.sin() + p.z.sin()) / 3.0;
        v * v
    }
}
