use super::{Pattern, Setting};
use crate::math::Vec3;
use std::f64::consts::PI;

/// The angle between the surface normal and the ray: 1 where the surface faces the ray, 0.5 where it is
/// grazed. 0 away from surfaces.
#[derive(Clone, Copy, Debug)]
pub struct Aoi;

impl Pattern for Aoi {
    fn asks_hit(&self) -> bool {
        true
    }

    fn value(&self, _p: Vec3, setting: &Setting) -> f64 {
        match setting.context.hit {
            Some(hit) => hit.normal.dot(hit.direction).clamp(-1.0, 1.0).acos() / PI,
            None => 0.0,
        }
    }
}
