use crate::math::{Vec3, floor, is_odd};

/// Tiles of one width along one axis.
///
/// | parameter | default | meaning |
/// |---|---|---|
/// | width | | along the axis, in single precision; may be negative |
/// | offset | 0 | added once per tile |
/// | flip | none | axes mirrored in every second tile |
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Repeat {
    pub axis: usize,
    pub width: f64,
    pub offset: Vec3,
    pub flip: [bool; 3],
}

impl Repeat {
    #[inline]
    pub fn apply(&self, mut p: Vec3) -> Vec3 {
        let tile = floor(p[self.axis] / self.width);
        p[self.axis] -= tile * self.width;
        if is_odd(tile) {
            for axis in 0..3 {
                if self.flip[axis] {
                    p[axis] = -p[axis];
                }
            }
            if self.flip[self.axis] {
                p[self.axis] += self.width;
            }
        }
        p + tile * self.offset
    }
}
