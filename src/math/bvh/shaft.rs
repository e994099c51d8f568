//! The tree's boxes that a [`Shaft`] runs through.

use super::{Bvh, LEAF, Node, WIDTH, leaf_places};
use crate::math::Shaft;
use smallvec::SmallVec;

/// Stands for a step of 0, and is a step outward.
const NO_STEP: f32 = 1e-30;
/// Bound on the relative rounding of a quotient, on both sides.
const SLACK: f32 = 8.0 * f32::EPSILON;

/// Conditions `t * step <= room` for one side of a box each, in the tree's coordinates.
struct Sides {
    /// Of the sides above, then of those below, where coordinates count downward.
    start: [f32; 6],
    inverse: [f32; 6],
    pad: f32,
}

impl Sides {
    fn new(bvh: &Bvh, shaft: &Shaft) -> Sides {
        let start = (shaft.start - bvh.center) * bvh.scale;
        let (least, greatest) = (shaft.way.min * bvh.scale, shaft.way.max * bvh.scale);
        let reach = (bvh.bounds.min - bvh.center).abs().max((bvh.bounds.max - bvh.center).abs()) * bvh.scale;
        let size =
            start.abs().max_element() + reach.max_element() + least.abs().max(greatest.abs()).max_element();
        let inverse = |step: f64| {
            let step = step as f32;
            1.0 / if step.abs() < NO_STEP { -NO_STEP } else { step }
        };
        let mut sides = Sides { start: [0.0; 6], inverse: [0.0; 6], pad: 8.0 * f32::EPSILON * size as f32 };
        for axis in 0..3 {
            (sides.start[axis], sides.start[axis + 3]) = (start[axis] as f32, -start[axis] as f32);
            (sides.inverse[axis], sides.inverse[axis + 3]) = (inverse(least[axis]), inverse(-greatest[axis]));
        }
        sides
    }

    /// A bit for each child that the shaft may meet.
    fn mask(&self, node: &Node) -> u32 {
        let (mut from, mut to) = ([0f32; WIDTH], [1f32; WIDTH]);
        for side in 0..6 {
            let (start, inverse) = (self.start[side] - self.pad, self.inverse[side]);
            // Sides above are in the last three rows.
            let (row, sign) =
                if side < 3 { (&node.bounds[side + 3], 1.0) } else { (&node.bounds[side - 3], -1.0) };
            for i in 0..WIDTH {
                let t = (sign * row[i] - start) * inverse;
                if inverse > 0.0 {
                    to[i] = if t < to[i] { t } else { to[i] };
                } else {
                    from[i] = if t > from[i] { t } else { from[i] };
                }
            }
        }
        let mut mask = 0;
        for i in 0..WIDTH {
            mask |= u32::from(from[i] <= to[i] * (1.0 + SLACK)) << i;
        }
        mask
    }
}

impl Bvh {
    /// Calls `visit` with every primitive whose box the shaft may meet, until it returns false.
    pub fn in_shaft(&self, shaft: &Shaft, mut visit: impl FnMut(u32) -> bool) {
        if self.nodes.is_empty() {
            return;
        }
        let sides = Sides::new(self, shaft);
        let mut stack: SmallVec<[u32; 128]> = smallvec::smallvec![0];
        while let Some(entry) = stack.pop() {
            if entry & LEAF != 0 {
                if !leaf_places(entry).all(|i| visit(self.primitive(i))) {
                    return;
                }
                continue;
            }
            let node = &self.nodes[entry as usize];
            let mut mask = sides.mask(node);
            while mask != 0 {
                stack.push(node.child[mask.trailing_zeros() as usize]);
                mask &= mask - 1;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Bvh, Quality, tests::Random};
    use crate::math::{Aabb, Shaft, Vec3};

    /// Every box that the shaft meets is named, and few others are.
    #[test]
    fn no_box_is_passed_over() {
        let mut random = Random::new(11);
        for size in [1.0, 1e-6, 1e6] {
            let boxes: Vec<Aabb> = (0..300).map(|_| random.aabb(size, 0.1 * size)).collect();
            let bvh = Bvh::build(&boxes, Quality::Best);
            let (mut met, mut named) = (0, 0);
            for i in 0..400 {
                let mut ends = Aabb::new(random.vector(2.0 * size), random.vector(2.0 * size));
                let middle = 0.5 * (ends.min + ends.max);
                let part = 0.1 * f64::from(i % 5);
                ends = Aabb {
                    min: middle + part * (ends.min - middle),
                    max: middle + part * (ends.max - middle),
                };
                if i % 7 == 0 {
                    ends.max[i as usize % 3] = ends.min[i as usize % 3];
                }
                let far = if i % 2 == 0 { 1.0 } else { 50.0 };
                let shaft = Shaft::new(random.vector(far * size) + Vec3::splat(0.1 * size), &ends);
                let mut seen = vec![false; boxes.len()];
                bvh.in_shaft(&shaft, |k| {
                    seen[k as usize] = true;
                    true
                });
                for (b, seen) in boxes.iter().zip(&seen) {
                    assert!(*seen || !shaft.meets(b), "{b:?} {shaft:?}");
                    met += usize::from(shaft.meets(b));
                    named += usize::from(*seen);
                }
            }
            assert!(met > 1000 && named < met + met / 50 + 10, "{met} {named}");
        }
    }
}
