//! Leaves and their combinations, and how rays and points meet them.

use super::compound::{Compound, meets};
use super::hit::{InteriorId, RayClass};
use crate::math::bvh::{Bvh, Quality};
use crate::math::{Aabb, EPSILON, Range, Ray, Transform, Vec3};
use crate::shape::{Crossing, Shape};
use std::sync::Arc;

/// No surface, no cutaway: an index that is never given out.
pub(super) const NONE: u32 = u32::MAX;

/// One shape where it stands.
#[derive(Debug)]
pub(super) struct Leaf {
    pub shape: Arc<dyn Shape>,
    /// Takes the shape's space to the world; `None` if they are the same.
    pub transform: Option<Box<Transform>>,
    pub surface: u32,
    pub interior_surface: u32,
    /// First of the parts' surfaces in `World::part_surfaces`.
    pub parts: u32,
    /// Index into `World::shadings`.
    pub shading: u32,
    /// The compound whose children's textures show where this leaf cuts it.
    pub cutaway: u32,
    pub interior: InteriorId,
    /// Inside and outside are exchanged.
    pub inverted: bool,
}

/// A leaf or a combination, by number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Solid {
    Leaf(u32),
    Compound(u32),
}

/// A top-level object: what the tree holds.
#[derive(Debug)]
pub(super) struct Root {
    pub solid: Solid,
    pub interior: InteriorId,
    /// A bit per [`RayClass`] that does not see it.
    pub hidden: u8,
    /// Blocks light wherever it is hit.
    pub opaque: bool,
}

/// A crossing of some leaf.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    /// World distance.
    pub t: f64,
    pub leaf: u32,
    /// As the shape reported it, `t` in its own units.
    pub crossing: Crossing,
}

/// All geometry of a world, or of one object that a scene asks about while it is read.
#[derive(Debug, Default)]
pub(super) struct Geometry {
    pub leaves: Vec<Leaf>,
    pub compounds: Vec<Compound>,
    pub roots: Vec<Root>,
    /// Bounds of each root.
    pub root_bounds: Vec<Aabb>,
    /// Over the finite roots, by place in `finite`; `None` when they are too few.
    pub tree: Option<Bvh>,
    pub finite: Vec<u32>,
    pub infinite: Vec<u32>,
}

/// With so few finite roots a tree costs more than it saves.
const TREE_FROM: usize = 4;

impl Geometry {
    /// Sorts the roots into finite and infinite ones and builds the tree.
    pub fn finish(&mut self) {
        for (i, b) in self.root_bounds.iter().enumerate() {
            if b.is_empty() {
                continue;
            }
            if b.is_finite() { self.finite.push(i as u32) } else { self.infinite.push(i as u32) }
        }
        if self.finite.len() < TREE_FROM {
            return;
        }
        let boxes: Vec<Aabb> = self.finite.iter().map(|&i| self.root_bounds[i as usize]).collect();
        let mut tree = Bvh::build(&boxes, Quality::Best);
        self.finite = tree.order().iter().map(|&i| self.finite[i as usize]).collect();
        tree.take_order();
        self.tree = Some(tree);
    }

    /// The nearest crossing among the roots that `class` sees. Of equal distances the root that the scene
    /// names first counts.
    pub fn nearest(&self, ray: &Ray, range: Range, class: RayClass) -> Option<Found> {
        let mut best: Option<Found> = None;
        let mut best_root = NONE;
        let bit = class.bit();
        let mut visit = |index: u32, max: f64| {
            let root = &self.roots[index as usize];
            if root.hidden & bit != 0 {
                return max;
            }
            let limit = if index < best_root { max.next_up() } else { max };
            match self.nearest_of(root.solid, ray, Range::new(range.min, limit)) {
                Some(found) => {
                    best = Some(found);
                    best_root = index;
                    found.t.min(max)
                }
                None => max,
            }
        };
        let mut max = range.max;
        for &i in &self.infinite {
            max = visit(i, max);
        }
        self.visit_finite(ray, Range::new(range.min, max), visit);
        best
    }

    /// Whether an opaque root that casts shadows lies inside `range`. `last` remembers which one did, and is
    /// asked first: neighbouring rays are mostly stopped by the same object.
    pub fn blocked(&self, ray: &Ray, range: Range, last: &mut u32) -> bool {
        let stops = |index: u32| {
            let root = &self.roots[index as usize];
            root.opaque && root.hidden & RayClass::Shadow.bit() == 0 && self.meets(root.solid, ray, range)
        };
        if *last != NONE && stops(*last) {
            return true;
        }
        let mut found = |index: u32| {
            let stopped = index != *last && stops(index);
            if stopped {
                *last = index;
            }
            stopped
        };
        if self.infinite.iter().any(|&i| found(i)) {
            return true;
        }
        match &self.tree {
            Some(tree) => tree.any(ray, range, |place| found(self.finite[place as usize])),
            None => self.finite.iter().any(|&i| self.may_meet(i, ray, range) && found(i)),
        }
    }

    /// Calls `visit` with the roots whose bounds the ray may meet.
    #[inline]
    fn visit_finite(&self, ray: &Ray, range: Range, mut visit: impl FnMut(u32, f64) -> f64) {
        if let Some(tree) = &self.tree {
            tree.traverse(ray, range, |place, max| visit(self.finite[place as usize], max));
            return;
        }
        let mut max = range.max;
        for &i in &self.finite {
            if self.may_meet(i, ray, Range::new(range.min, max)) {
                max = visit(i, max);
            }
            if max <= range.min {
                return;
            }
        }
    }

    /// Whether root `i` is worth asking without a tree: a combination takes longer than its box.
    fn may_meet(&self, i: u32, ray: &Ray, range: Range) -> bool {
        matches!(self.roots[i as usize].solid, Solid::Leaf(_))
            || meets(&self.root_bounds[i as usize], ray, range)
    }

    /// The roots that contain `p`, in scene order.
    pub fn roots_at(&self, p: Vec3) -> Vec<u32> {
        let mut found: Vec<u32> = self
            .infinite
            .iter()
            .copied()
            .filter(|&i| self.contains(self.roots[i as usize].solid, p))
            .collect();
        let mut test = |i: u32| {
            if self.contains(self.roots[i as usize].solid, p) {
                found.push(i);
            }
        };
        match &self.tree {
            Some(tree) => {
                tree.any_at(p, |place| {
                    test(self.finite[place as usize]);
                    false
                });
            }
            None => self.finite.iter().for_each(|&i| test(i)),
        }
        found.sort_unstable();
        found
    }

    #[inline]
    pub fn nearest_of(&self, solid: Solid, ray: &Ray, range: Range) -> Option<Found> {
        match solid {
            Solid::Leaf(i) => self.nearest_of_leaf(i, ray, range),
            Solid::Compound(i) => self.compounds[i as usize].nearest(self, ray, range),
        }
    }

    /// Whether there is any crossing inside `range`.
    pub fn meets(&self, solid: Solid, ray: &Ray, range: Range) -> bool {
        self.nearest_of(solid, ray, range).is_some()
    }

    #[inline]
    fn nearest_of_leaf(&self, index: u32, ray: &Ray, range: Range) -> Option<Found> {
        let leaf = &self.leaves[index as usize];
        match &leaf.transform {
            None => {
                let crossing = leaf.shape.nearest(ray, range)?;
                Some(Found { t: crossing.t, leaf: index, crossing })
            }
            Some(transform) => {
                let (local, length) = transform.inverse_ray(ray);
                let crossing = leaf.shape.nearest(&local, range.scaled(length))?;
                Some(Found { t: crossing.t / length, leaf: index, crossing })
            }
        }
    }

    /// Appends every crossing inside `range`, children in order.
    pub fn crossings(&self, solid: Solid, ray: &Ray, range: Range, out: &mut Vec<Found>) {
        match solid {
            Solid::Leaf(i) => self.crossings_of_leaf(i, ray, range, out),
            Solid::Compound(i) => self.compounds[i as usize].crossings(self, ray, range, out),
        }
    }

    fn crossings_of_leaf(&self, index: u32, ray: &Ray, range: Range, out: &mut Vec<Found>) {
        let leaf = &self.leaves[index as usize];
        super::scratch::with_crossings(|list| match &leaf.transform {
            None => {
                leaf.shape.crossings(ray, range, list);
                out.extend(list.iter().map(|&crossing| Found { t: crossing.t, leaf: index, crossing }));
            }
            Some(transform) => {
                let (local, length) = transform.inverse_ray(ray);
                leaf.shape.crossings(&local, range.scaled(length), list);
                let found = |&crossing: &Crossing| Found { t: crossing.t / length, leaf: index, crossing };
                out.extend(list.iter().map(found));
            }
        });
    }

    pub fn contains(&self, solid: Solid, p: Vec3) -> bool {
        match solid {
            Solid::Leaf(i) => {
                let leaf = &self.leaves[i as usize];
                let local = leaf.transform.as_ref().map_or(p, |t| t.inverse_point(p));
                leaf.shape.contains(local) != leaf.inverted
            }
            Solid::Compound(i) => self.compounds[i as usize].contains(self, p),
        }
    }

    /// World point, error bound, local point and unit world normal of a crossing.
    pub fn locate(&self, ray: &Ray, found: &Found) -> Located {
        let leaf = &self.leaves[found.leaf as usize];
        let sign = if leaf.inverted { -1.0 } else { 1.0 };
        let Some(t) = &leaf.transform else {
            let (point, error) = leaf.shape.locate(ray, &found.crossing);
            let normal = sign * leaf.shape.normal(point, &found.crossing);
            let face = leaf.shape.face_normal(point, &found.crossing).map_or(normal, |f| sign * f);
            return Located { point, error, local: point, normal, face };
        };
        let (local_ray, _) = t.inverse_ray(ray);
        let (local, local_error) = leaf.shape.locate(&local_ray, &found.crossing);
        let point = t.point(local);
        let raw = leaf.shape.normal(local, &found.crossing);
        let normal = (sign * t.normal(raw)).normalize_or(raw);
        // Errors as far as they lie along the surface's normal: the shape's own and the rounding of the way back to
        // object space, seen through the transform, and the rounding of the world point.
        let face = match leaf.shape.face_normal(local, &found.crossing) {
            Some(f) => (sign * t.normal(f)).normalize_or(f),
            None => normal,
        };
        let inward = t.forward.matrix3.transpose() * face;
        let back = rounding(&t.inverse, point);
        let error = inward.length() * local_error
            + inward.abs().dot(back)
            + face.abs().dot(rounding(&t.forward, local));
        Located { point, error, local, normal, face }
    }
}

/// Where a crossing is.
pub(super) struct Located {
    pub point: Vec3,
    pub error: f64,
    pub local: Vec3,
    pub normal: Vec3,
    pub face: Vec3,
}

/// Bound on the rounding of `m * p`, per component.
fn rounding(m: &glam::DAffine3, p: Vec3) -> Vec3 {
    let a = m.matrix3;
    let reach = a.x_axis.abs() * p.x.abs() + a.y_axis.abs() * p.y.abs() + a.z_axis.abs() * p.z.abs();
    (reach + m.translation.abs()) * (8.0 * EPSILON)
}
