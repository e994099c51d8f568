use super::oriented;
use crate::math::Vec3;

/// Spreads the xy plane over all of space.
///
/// | parameter | default | meaning |
/// |---|---|---|
/// | orientation | z | normal of the plane |
/// | offset | 0 | the third coordinate |
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Planar {
    orientation: Vec3,
    offset: f64,
}

impl Planar {
    /// `orientation` need not have unit length.
    pub fn new(orientation: Vec3, offset: f64) -> Self {
        Self { orientation: orientation.normalize_or(Vec3::Z), offset }
    }

    #[inline]
    pub fn apply(&self, p: Vec3) -> Vec3 {
        oriented(self.orientation, (p.x, p.y, self.offset))
    }
}
