//! What a degenerate shape comes to: nothing is hit, nothing is inside.

use super::{Crossing, Shape};
use crate::math::{Aabb, Range, Ray, Vec3};

#[derive(Clone, Debug, PartialEq)]
pub struct Empty {
    /// The shape that was written.
    kind: &'static str,
}

impl Empty {
    pub fn new(kind: &'static str) -> Self {
        Self { kind }
    }
}

impl Shape for Empty {
    fn bounds(&self) -> Aabb {
        Aabb::EMPTY
    }

    fn crossings(&self, _ray: &Ray, _range: Range, _out: &mut Vec<Crossing>) {}

    fn contains(&self, _p: Vec3) -> bool {
        false
    }

    fn is_solid(&self) -> bool {
        false
    }

    fn normal(&self, _p: Vec3, _crossing: &Crossing) -> Vec3 {
        Vec3::Y
    }

    fn kind(&self) -> &'static str {
        self.kind
    }
}
