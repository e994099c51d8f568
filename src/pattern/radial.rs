use super::{Pattern, Setting, keyed};
use crate::color::Color;
use crate::math::Vec3;
use std::f64::consts::PI;

/// The angle about the y axis, 0.25 ..= 1.25.
#[derive(Clone, Copy, Debug)]
pub struct Radial;

impl Pattern for Radial {
    fn value(&self, p: Vec3, _setting: &Setting) -> f64 {
        // The axis has no angle; the language gives it this width.
        if p.x.abs() < 0.001 && p.z.abs() < 0.001 { 0.25 } else { 0.25 + (p.x.atan2(p.z) + PI) / (2.0 * PI) }
    }

    fn colors(&self) -> Vec<(f32, Color)> {
        keyed(&[
            (0.0, [0.0, 1.0, 1.0]),
            (0.333, [1.0, 1.0, 0.0]),
            (0.666, [1.0, 0.0, 1.0]),
            (1.0, [0.0, 1.0, 1.0]),
        ])
    }
}
