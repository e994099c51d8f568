use super::{EDGE, Pattern, Setting};
use crate::math::noise::hash3;
use crate::math::random::{uniform, uniform_table};
use crate::math::{Vec3, floor_of};

/// Unit cubes, each with a random value.
#[derive(Clone, Copy, Debug)]
pub struct Cells;

impl Pattern for Cells {
    fn value(&self, p: Vec3, _setting: &Setting) -> f64 {
        let cell = floor_of(p + Vec3::splat(EDGE));
        uniform(uniform_table(), hash3(cell.x as i64, cell.y as i64, cell.z as i64))
    }
}
