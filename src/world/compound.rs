//! Combinations of solids (CSG) and clipped objects.
//!
//! A crossing of one child is kept or dropped by what the others say about its point. A point that lies
//! on another child's surface counts as inside it (closed sets): the other child's crossing of the same ray
//! at the same distance tells, so no test of "how close is close" is asked of the shapes.
//!
//! Boxes save most questions: one around each child's surface, which a ray must meet to cross it, and one
//! outside of which the child's answer to "do you contain this point" is known.

use super::convex::Glance;
use super::geometry::{Found, Geometry, Solid};
use super::intersection::tie_tolerance;
use super::probe::{AT_ONCE, Octet, Probe, Reach};
use super::scratch::Lists;
use crate::math::bvh::Bvh;
use crate::math::{Aabb, Range, Ray, Vec3};
use smallvec::SmallVec;

/// So many boxes are better tested all at once than one by one.
const SEVERAL: usize = 2;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Op {
    Union,
    Merge,
    Intersection,
}

/// Where a solid can be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Extent {
    /// Around all its surfaces.
    pub surface: Aabb,
    /// Outside of this box `outside` is the answer to whether it contains a point.
    pub hull: Aabb,
    pub outside: bool,
}

impl Extent {
    /// Combines the extents of children.
    pub fn combined(op: Op, children: &[Child]) -> Extent {
        let surface = children.iter().fold(Aabb::EMPTY, |a, c| a.union(c.extent.surface));
        // One child with this answer decides for all.
        let decisive = op != Op::Intersection;
        let mut hulls = children.iter().filter(|c| c.extent.outside == decisive).map(|c| c.extent.hull);
        let Some(first) = hulls.next() else {
            let hull = children.iter().fold(Aabb::EMPTY, |a, c| a.union(c.extent.hull));
            return Extent { surface, hull, outside: !decisive };
        };
        let hull = hulls.fold(first, Aabb::intersection);
        let surface = if decisive { surface } else { surface.intersection(hull) };
        Extent { surface, hull, outside: decisive }
    }

    /// The part that lies in all clips.
    pub fn clipped(self, clips: &[Child]) -> Extent {
        let reach = Reach::new(&self.surface);
        let whole = Child { solid: Solid::Leaf(0), reach, extent: self, tight: false };
        let all: Vec<Child> = std::iter::once(whole).chain(clips.iter().copied()).collect();
        let both = Self::combined(Op::Intersection, &all);
        Extent { surface: self.surface.intersection(both.surface), ..both }
    }
}

/// A solid in a combination.
#[derive(Clone, Copy, Debug)]
pub(super) struct Child {
    pub solid: Solid,
    /// A ray that misses this box crosses none of the child's surfaces.
    pub reach: Reach,
    pub extent: Extent,
    /// Whether a ray that misses the box is outside as the hull has it, or inside, all along; of clips, whether
    /// the box is finite.
    pub tight: bool,
}

impl Child {
    pub fn contains(&self, geometry: &Geometry, p: Vec3) -> bool {
        if self.extent.hull.contains(p) { geometry.contains(self.solid, p) } else { self.extent.outside }
    }
}

/// Children combined; inversion has been worked into the leaves.
#[derive(Debug)]
pub(super) struct Compound {
    pub op: Op,
    pub children: Vec<Child>,
    /// Over the children's bounds, when there are many and all are finite.
    pub tree: Option<Bvh>,
    /// The children's boxes side by side, of unions and merges of several.
    pub octets: Vec<Octet>,
    /// Only what all of these contain is kept.
    pub clips: Vec<Child>,
    /// A ray that misses one of these, and does not start in it, misses everything.
    pub gates: Vec<Solid>,
    /// Around an intersection with members that are not bounded: what they are asked about is cut to this.
    pub around: Option<Reach>,
}

impl Compound {
    /// An empty union.
    pub fn nothing() -> Self {
        let (children, clips, gates) = (Vec::new(), Vec::new(), Vec::new());
        Self { op: Op::Union, children, tree: None, clips, gates, octets: Vec::new(), around: None }
    }

    /// Notes where all of an intersection lies.
    pub fn enclose(&mut self, extent: &Extent) {
        if self.op != Op::Intersection && self.tree.is_none() && self.children.len() >= SEVERAL {
            self.octets = Octet::list(self.children.iter().map(|c| c.reach));
        }
        let unbounded = self.children.iter().any(|c| !c.extent.surface.is_finite());
        if self.op == Op::Intersection && unbounded && !extent.outside && extent.hull.is_finite() {
            self.around = Some(Reach::new(&extent.hull));
        }
    }

    /// The part of `range` where there may be anything of an intersection.
    pub fn within(&self, probe: &Probe, range: Range) -> Option<Range> {
        match &self.around {
            Some(around) => probe.within(around, range),
            None => Some(range),
        }
    }

    /// Whether the ray meets or starts in all gates.
    fn opens(&self, geometry: &Geometry, ray: &Ray) -> bool {
        self.gates.iter().all(|&g| geometry.contains(g, ray.origin) || geometry.meets(g, ray, Range::FORWARD))
    }

    /// The nearest crossing inside `range`; of equal ones that of the last child.
    pub fn nearest(
        &self,
        geometry: &Geometry,
        probe: &Probe,
        range: Range,
        lists: &mut Lists,
    ) -> Option<Found> {
        if !self.gates.is_empty() && !self.opens(geometry, probe.ray) {
            return None;
        }
        match self.op {
            Op::Union if self.clips.is_empty() => {
                self.nearest_of_union(geometry, probe, range, lists).map(|(found, _)| found)
            }
            Op::Union => self.nearest_clipped(geometry, probe, range, lists),
            Op::Merge => self.nearest_of_merge(geometry, probe, range, lists),
            Op::Intersection => {
                let range = self.within(probe, range)?;
                match self.glance(geometry, probe, range) {
                    Glance::Nothing => return None,
                    Glance::Nearest(found) => return Some(found),
                    Glance::Unsure => {}
                }
                let candidates = self.candidates(geometry, probe, range, lists)?;
                self.nearest_kept(geometry, probe, candidates, lists)
            }
        }
    }

    /// Whether there is any crossing inside `range`: the first one found will do.
    pub fn is_met(&self, geometry: &Geometry, probe: &Probe, range: Range, lists: &mut Lists) -> bool {
        match self.op {
            Op::Intersection if self.gates.is_empty() => {
                let Some(range) = self.within(probe, range) else { return false };
                match self.glance(geometry, probe, range) {
                    Glance::Nothing => return false,
                    Glance::Nearest(_) => return true,
                    Glance::Unsure => {}
                }
                let candidates = self.candidates(geometry, probe, range, lists);
                candidates.is_some_and(|c| self.any_kept(geometry, probe, c, lists))
            }
            Op::Union if self.clips.is_empty() && self.gates.is_empty() => match &self.tree {
                Some(tree) => tree.any(probe.ray, range, |i| {
                    geometry.is_met(self.children[i as usize].solid, probe, range, lists)
                }),
                None => {
                    let mut met = false;
                    self.each_met(probe, range, |i, max| {
                        met = met || geometry.is_met(self.children[i].solid, probe, range, lists);
                        if met { f64::NEG_INFINITY } else { max }
                    });
                    met
                }
            },
            _ => self.nearest(geometry, probe, range, lists).is_some(),
        }
    }

    /// The nearest crossing of any child, and whose it is.
    fn nearest_of_union(
        &self,
        geometry: &Geometry,
        probe: &Probe,
        range: Range,
        lists: &mut Lists,
    ) -> Option<(Found, usize)> {
        let mut best: Option<(Found, usize)> = None;
        let mut visit = |i: usize, max: f64| {
            let limit = if best.is_some_and(|(_, b)| i > b) { max.next_up() } else { max };
            let within = Range::new(range.min, limit);
            match geometry.nearest_with(self.children[i].solid, probe, within, lists) {
                Some(found) => {
                    best = Some((found, i));
                    found.t.min(max)
                }
                None => max,
            }
        };
        if let Some(tree) = &self.tree {
            tree.traverse(probe.ray, range, |i, max| visit(i as usize, max));
        } else {
            self.each_met(probe, range, visit);
        }
        best
    }

    /// The nearest crossing of a child that lies in no other child: mostly the very nearest one.
    fn nearest_of_merge(
        &self,
        geometry: &Geometry,
        probe: &Probe,
        range: Range,
        lists: &mut Lists,
    ) -> Option<Found> {
        let (found, child) = self.nearest_of_union(geometry, probe, range, lists)?;
        let stays = |f: &Found| self.is_unclipped(geometry, probe.ray.at(f.t));
        if self.is_outermost(geometry, probe, &found, child, lists) && stays(&found) {
            return Some(found);
        }
        let first = lists.found.len();
        self.crossings_of_merge(geometry, probe, range, lists);
        let kept = lists.found[first..].iter().copied().filter(stays);
        let nearest = kept.reduce(|best, f| if f.t <= best.t { f } else { best });
        lists.found.truncate(first);
        nearest
    }

    /// Whether a merge keeps the crossing of one child.
    fn is_outermost(
        &self,
        geometry: &Geometry,
        probe: &Probe,
        found: &Found,
        child: usize,
        lists: &mut Lists,
    ) -> bool {
        let p = probe.ray.at(found.t);
        let tolerance = tie_tolerance(probe.ray, found.t);
        let about = Range::new((found.t - tolerance).next_down(), (found.t + tolerance).next_up());
        let mut swallows = |o: usize| {
            let other = &self.children[o];
            if o == child || !other.extent.hull.contains(p) {
                return o != child && other.extent.outside;
            }
            match geometry.nearest_with(other.solid, probe, about, lists) {
                Some(tied) => child < o || !same_side(geometry, probe.ray, found, &tied),
                None => geometry.contains(other.solid, p),
            }
        };
        match &self.tree {
            Some(tree) => !tree.any_at(p, |o| swallows(o as usize)),
            None => !(0..self.children.len()).any(swallows),
        }
    }

    fn nearest_clipped(
        &self,
        geometry: &Geometry,
        probe: &Probe,
        range: Range,
        lists: &mut Lists,
    ) -> Option<Found> {
        // Single shapes are asked as quickly as clips.
        let slow = self.children.iter().any(|c| matches!(c.solid, Solid::Compound(_)));
        let range = if slow { self.unclipped(geometry, probe, range)? } else { range };
        let first = lists.found.len();
        self.each_child(probe, range, |i| {
            geometry.crossings(self.children[i].solid, probe, range, lists);
        });
        let mut best: Option<Found> = None;
        for found in &lists.found[first..] {
            if best.is_none_or(|b| found.t <= b.t) && self.is_unclipped(geometry, probe.ray.at(found.t)) {
                best = Some(*found);
            }
        }
        lists.found.truncate(first);
        best
    }

    /// Appends every crossing inside `range`, children in order.
    pub fn crossings(&self, geometry: &Geometry, probe: &Probe, range: Range, lists: &mut Lists) {
        if !self.gates.is_empty() && !self.opens(geometry, probe.ray) {
            return;
        }
        let first = lists.found.len();
        match self.op {
            Op::Union => self.each_child(probe, range, |i| {
                geometry.crossings(self.children[i].solid, probe, range, lists);
            }),
            Op::Merge => self.crossings_of_merge(geometry, probe, range, lists),
            Op::Intersection => {
                let Some(range) = self.within(probe, range) else { return };
                if let Some(candidates) = self.candidates(geometry, probe, range, lists) {
                    self.keep(geometry, probe, candidates, lists);
                }
                return;
            }
        }
        if !self.clips.is_empty() {
            retain_from(&mut lists.found, first, |f| self.is_unclipped(geometry, probe.ray.at(f.t)));
        }
    }

    fn crossings_of_merge(&self, geometry: &Geometry, probe: &Probe, range: Range, lists: &mut Lists) {
        let first = lists.found.len();
        let mut owners: SmallVec<[u32; 16]> = SmallVec::new();
        self.each_child(probe, range, |i| {
            geometry.crossings(self.children[i].solid, probe, range, lists);
            (first + owners.len()..lists.found.len()).for_each(|_| owners.push(i as u32));
        });
        let mut kept = first;
        for (i, &owner) in owners.iter().enumerate() {
            let found = lists.found[first + i];
            if self.is_outermost(geometry, probe, &found, owner as usize, lists) {
                lists.found[kept] = found;
                kept += 1;
            }
        }
        lists.found.truncate(kept);
    }

    pub fn contains(&self, geometry: &Geometry, p: Vec3) -> bool {
        if !self.is_unclipped(geometry, p) {
            return false;
        }
        match self.op {
            Op::Intersection => self.children.iter().all(|c| c.contains(geometry, p)),
            Op::Union | Op::Merge => match &self.tree {
                Some(tree) => tree.any_at(p, |i| geometry.contains(self.children[i as usize].solid, p)),
                None => self.children.iter().any(|c| c.contains(geometry, p)),
            },
        }
    }

    /// Takes in what `child` is made of, where the crossings stay the same; else `child` itself.
    pub fn absorb(&mut self, geometry: &Geometry, child: Child) {
        let Solid::Compound(i) = child.solid else { return self.children.push(child) };
        let inner = &geometry.compounds[i as usize];
        let alike = inner.op == self.op || inner.children.len() == 1;
        let fits = match self.op {
            Op::Union => alike && inner.clips.is_empty(),
            Op::Intersection => alike,
            Op::Merge => false,
        };
        if fits && inner.gates.is_empty() {
            self.children.extend_from_slice(&inner.children);
            self.clips.extend_from_slice(&inner.clips);
        } else {
            self.children.push(child);
        }
    }

    pub fn is_unclipped(&self, geometry: &Geometry, p: Vec3) -> bool {
        self.clips.iter().all(|c| c.contains(geometry, p))
    }

    /// The children whose surfaces the ray may meet, in order.
    fn each_child(&self, probe: &Probe, range: Range, mut visit: impl FnMut(usize)) {
        if let Some(tree) = &self.tree {
            let mut met: SmallVec<[u32; 32]> = SmallVec::new();
            tree.traverse(probe.ray, range, |i, max| {
                met.push(i);
                max
            });
            met.sort_unstable();
            met.into_iter().for_each(|i| visit(i as usize));
            return;
        }
        self.each_met(probe, range, |i, max| {
            visit(i);
            max
        });
    }

    /// Calls `visit(child, max)` with each child whose box the ray may meet inside `range`, in order; it
    /// returns the new `max`.
    #[inline]
    fn each_met(&self, probe: &Probe, range: Range, mut visit: impl FnMut(usize, f64) -> f64) {
        let mut max = range.max;
        if self.octets.is_empty() {
            for (i, child) in self.children.iter().enumerate() {
                if probe.meets(&child.reach, Range::new(range.min, max)) {
                    max = visit(i, max);
                }
            }
            return;
        }
        for (k, octet) in self.octets.iter().enumerate() {
            let (mut mask, near) = probe.meets_each(octet, Range::new(range.min, max));
            while mask != 0 {
                let i = mask.trailing_zeros() as usize;
                mask &= mask - 1;
                if f64::from(near[i]) <= max {
                    max = visit(AT_ONCE * k + i, max);
                }
            }
        }
    }
}

/// Keeps what `keep` says of the list from place `first` on.
fn retain_from(list: &mut Vec<Found>, first: usize, mut keep: impl FnMut(&Found) -> bool) {
    let mut kept = first;
    for i in first..list.len() {
        if keep(&list[i]) {
            list[kept] = list[i];
            kept += 1;
        }
    }
    list.truncate(kept);
}

/// Whether two crossings at one point face the same way.
fn same_side(geometry: &Geometry, ray: &Ray, a: &Found, b: &Found) -> bool {
    geometry.locate(ray, a).normal.dot(geometry.locate(ray, b).normal) > 0.0
}
