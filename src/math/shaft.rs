//! All segments from one place to anywhere in a box.

use super::{Aabb, Vec3};

/// The region that segments from `start` to the points of a box run through, and a little more: a box around
/// all that is a part `t` of the way there, for each `t` from 0 to 1.
#[derive(Clone, Copy, Debug)]
pub struct Shaft {
    pub start: Vec3,
    /// Around the whole ways.
    pub way: Aabb,
}

/// Room for roundings, relative to the coordinates.
const ROOM: f64 = 1e-12;

impl Shaft {
    pub fn new(start: Vec3, ends: &Aabb) -> Shaft {
        Shaft { start, way: Aabb { min: ends.min - start, max: ends.max - start } }
    }

    /// The largest coordinate.
    pub fn size(&self) -> f64 {
        let way = self.way.min.abs().max(self.way.max.abs());
        (self.start.abs() + way).max_element()
    }

    /// Whether a segment may meet the box; true when in doubt.
    pub fn meets(&self, b: &Aabb) -> bool {
        let pad = ROOM * self.size();
        let (mut from, mut to) = (0.0, 1.0);
        for axis in 0..3 {
            let start = self.start[axis];
            // The least of the ways is to be below the box's top, the greatest above its bottom.
            let below = (b.max[axis] - start + pad, self.way.min[axis]);
            let above = (start - b.min[axis] + pad, -self.way.max[axis]);
            for (room, step) in [below, above] {
                // `t * step <= room`
                if step > 0.0 {
                    to = f64::min(to, room / step);
                } else if step < 0.0 {
                    from = f64::max(from, room / step);
                } else if room < 0.0 {
                    return false;
                }
            }
        }
        from <= to * (1.0 + ROOM)
    }

    /// Whether all of it lies where `normal · p > distance`, or all where it is less.
    pub fn is_beside(&self, normal: Vec3, distance: f64) -> bool {
        let start = normal.dot(self.start) - distance;
        let half = 0.5 * (self.way.max - self.way.min);
        let middle = start + normal.dot(self.way.min + half);
        let spread = normal.abs().dot(half);
        let room = ROOM * (self.size() + distance.abs());
        // The start may lie very near: rays leave a plane's points from just beside it.
        (start > 0.0 && middle - spread > room) || (start < 0.0 && middle + spread < -room)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::strategy::vector;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]
        /// A box that holds a point of some segment is met.
        #[test]
        fn what_a_segment_passes_is_met(
            start in vector(5.0), a in vector(5.0), b in vector(5.0), share in vector(1.0), t in 0.0..1.0f64,
            room in vector(1.0), flat in 0..4usize, n in vector(1.0),
        ) {
            let mut ends = Aabb::new(a, b);
            if flat < 3 {
                ends.max[flat] = ends.min[flat];
            }
            let shaft = Shaft::new(start, &ends);
            let end = ends.min + (0.5 * share + 0.5) * (ends.max - ends.min);
            let p = start + t * (end - start);
            prop_assert!(shaft.meets(&Aabb::new(p - room, p + room)));
            prop_assert!(shaft.meets(&Aabb::new(p, p)));
            prop_assert!(!shaft.is_beside(n, n.dot(p)));
        }
    }

    #[test]
    fn what_lies_beside_is_mostly_seen() {
        let shaft = Shaft::new(Vec3::ZERO, &Aabb::new(Vec3::new(-1.0, 9.0, -1.0), Vec3::new(1.0, 9.0, 1.0)));
        let at = |x: f64, y: f64| Aabb::new(Vec3::new(x, y, 0.0), Vec3::new(x + 0.2, y + 0.2, 0.2));
        assert!(shaft.meets(&at(0.4, 4.5)) && shaft.meets(&at(-0.1, 0.0)) && shaft.meets(&at(0.9, 8.9)));
        assert!(!shaft.meets(&at(0.6, 4.5)) && !shaft.meets(&at(0.0, 9.1)) && !shaft.meets(&at(0.0, -0.3)));
        assert!(shaft.is_beside(Vec3::Y, -1e-15) && !shaft.is_beside(Vec3::Y, 0.5));
        assert!(
            shaft.is_beside(Vec3::Y, 10.0) && shaft.is_beside(Vec3::X, 1.5) && !shaft.is_beside(Vec3::X, 0.5)
        );
    }
}
