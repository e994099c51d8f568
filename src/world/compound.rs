//! Combinations of solids (CSG) and clipped objects.
//!
//! A crossing of one child is kept or dropped by what the others say about its point. A point that lies
//! on another child's surface counts as inside it (closed sets): the other child's crossing of the same ray
//! at the same distance tells, so no test of "how close is close" is asked of the shapes.

use super::geometry::{Found, Geometry, Solid};
use super::scratch::with_found;
use crate::math::bvh::Bvh;
use crate::math::{Aabb, EPSILON, Range, Ray, Vec3};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Op {
    Union,
    Merge,
    Intersection,
}

/// Children combined; inversion has been worked into the leaves.
#[derive(Debug)]
pub(super) struct Compound {
    pub op: Op,
    pub children: Vec<Solid>,
    pub child_bounds: Vec<Aabb>,
    /// Over the children's bounds, when there are many and all are finite.
    pub tree: Option<Bvh>,
    /// Only what all of these contain is kept.
    pub clips: Vec<Solid>,
    /// A ray that misses one of these, and does not start in it, misses everything.
    pub gates: Vec<Solid>,
}

/// A crossing and the child that it belongs to.
type Tagged = (Found, usize);

impl Compound {
    /// An empty union.
    pub fn nothing() -> Self {
        Self {
            op: Op::Union,
            children: Vec::new(),
            child_bounds: Vec::new(),
            tree: None,
            clips: Vec::new(),
            gates: Vec::new(),
        }
    }

    /// Whether the ray meets or starts in all gates.
    fn opens(&self, geometry: &Geometry, ray: &Ray) -> bool {
        self.gates.iter().all(|&g| geometry.contains(g, ray.origin) || geometry.meets(g, ray, Range::FORWARD))
    }

    pub fn nearest(&self, geometry: &Geometry, ray: &Ray, range: Range) -> Option<Found> {
        with_found(|list| {
            self.crossings(geometry, ray, range, list);
            list.iter().copied().reduce(|best, f| if f.t <= best.t { f } else { best })
        })
    }

    pub fn crossings(&self, geometry: &Geometry, ray: &Ray, range: Range, out: &mut Vec<Found>) {
        if !self.opens(geometry, ray) {
            return;
        }
        let first = out.len();
        match self.op {
            Op::Union => self.each_child(ray, range, |i| {
                geometry.crossings(self.children[i], ray, range, out);
            }),
            Op::Merge | Op::Intersection => self.combined(geometry, ray, range, out),
        }
        if !self.clips.is_empty() {
            self.clip(geometry, ray, first, out);
        }
    }

    pub fn contains(&self, geometry: &Geometry, p: Vec3) -> bool {
        if !self.clips.iter().all(|&c| geometry.contains(c, p)) {
            return false;
        }
        match self.op {
            Op::Intersection => self.children.iter().all(|&c| geometry.contains(c, p)),
            Op::Union | Op::Merge => match &self.tree {
                Some(tree) => tree.any_at(p, |i| geometry.contains(self.children[i as usize], p)),
                None => self.children.iter().any(|&c| geometry.contains(c, p)),
            },
        }
    }

    /// The children whose bounds the ray meets, in order.
    fn each_child(&self, ray: &Ray, range: Range, mut visit: impl FnMut(usize)) {
        if let Some(tree) = &self.tree {
            let mut met: smallvec::SmallVec<[u32; 32]> = smallvec::SmallVec::new();
            tree.traverse(ray, range, |i, max| {
                met.push(i);
                max
            });
            met.sort_unstable();
            met.into_iter().for_each(|i| visit(i as usize));
            return;
        }
        for (i, bounds) in self.child_bounds.iter().enumerate() {
            if meets(bounds, ray, range) {
                visit(i);
            }
        }
    }

    /// Merge and intersection: all children's crossings, then those that the other children let stand.
    fn combined(&self, geometry: &Geometry, ray: &Ray, range: Range, out: &mut Vec<Found>) {
        let mut tagged: smallvec::SmallVec<[Tagged; 16]> = smallvec::SmallVec::new();
        with_found(|list| {
            self.each_child(ray, range, |i| {
                list.clear();
                geometry.crossings(self.children[i], ray, range, list);
                tagged.extend(list.iter().map(|&f| (f, i)));
            });
        });
        for (found, child) in &tagged {
            if self.keeps(geometry, ray, found, *child, &tagged) {
                out.push(*found);
            }
        }
    }

    fn keeps(&self, geometry: &Geometry, ray: &Ray, found: &Found, child: usize, all: &[Tagged]) -> bool {
        let p = ray.at(found.t);
        let tolerance = tie_tolerance(ray, found.t);
        let tied = |other: usize| {
            all.iter().find(|(f, c)| *c == other && (f.t - found.t).abs() <= tolerance).map(|(f, _)| *f)
        };
        let others = || (0..self.children.len()).filter(|&o| o != child);
        match self.op {
            Op::Intersection => others().all(|o| geometry.contains(self.children[o], p) || tied(o).is_some()),
            Op::Merge if self.tree.is_none() => others().all(|o| match tied(o) {
                Some(f) => child > o && same_side(geometry, ray, found, &f),
                None => !geometry.contains(self.children[o], p),
            }),
            Op::Merge | Op::Union => {
                let tree_says = |o: usize| match tied(o) {
                    Some(f) => child < o || !same_side(geometry, ray, found, &f),
                    None => geometry.contains(self.children[o], p),
                };
                match &self.tree {
                    Some(tree) => !tree.any_at(p, |o| o as usize != child && tree_says(o as usize)),
                    None => true,
                }
            }
        }
    }

    fn clip(&self, geometry: &Geometry, ray: &Ray, first: usize, out: &mut Vec<Found>) {
        let mut kept = first;
        for i in first..out.len() {
            let p = ray.at(out[i].t);
            if self.clips.iter().all(|&c| geometry.contains(c, p)) {
                out[kept] = out[i];
                kept += 1;
            }
        }
        out.truncate(kept);
    }
}

/// Distances this close are the same point: a few roundings of everything that went into them.
fn tie_tolerance(ray: &Ray, t: f64) -> f64 {
    16.0 * EPSILON * (ray.origin.abs().max_element() + t.abs())
}

/// Whether two crossings at one point face the same way.
fn same_side(geometry: &Geometry, ray: &Ray, a: &Found, b: &Found) -> bool {
    geometry.locate(ray, a).normal.dot(geometry.locate(ray, b).normal) > 0.0
}

/// Whether a ray may meet a box; true when in doubt.
pub(super) fn meets(b: &Aabb, ray: &Ray, range: Range) -> bool {
    let (mut near, mut far) = (range.min, range.max);
    for axis in 0..3 {
        let (o, d) = (ray.origin[axis], ray.dir[axis]);
        if d == 0.0 {
            if o < b.min[axis] || o > b.max[axis] {
                return false;
            }
            continue;
        }
        let (u, v) = ((b.min[axis] - o) / d, (b.max[axis] - o) / d);
        near = near.max(u.min(v));
        far = far.min(u.max(v));
    }
    let slack = 8.0 * EPSILON * (near.abs().max(far.abs()) + ray.origin.abs().max_element());
    near <= far + slack
}
