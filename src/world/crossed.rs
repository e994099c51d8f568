//! All surfaces that let light through on the way to a lamp, found in the one walk that looks for opaque ones.
//!
//! Shapes whose crossings are plain give them all at once; of the others the nearest is known. Where crossings come
//! close to each other, and behind what is not known, the way is left to be followed surface by surface.

use super::geometry::{Found, Geometry, Item, Solid};
use super::hit::{Hit, Obstacle, RayClass};
use super::intersection::margin;
use super::probe::Probe;
use super::{Blocker, World};
use crate::math::{Range, Ray};

/// What a shadow ray crosses, in order.
#[derive(Debug, Default)]
pub struct Crossed {
    found: Vec<Found>,
    /// Whether there is nothing behind the last of them.
    complete: bool,
}

/// What comes next on a ray.
#[derive(Debug)]
pub enum Next {
    Hit(Hit),
    Nothing,
    Unknown,
}

impl Crossed {
    /// Nothing is known.
    pub fn forget(&mut self) {
        self.found.clear();
        self.complete = false;
    }

    /// Before a walk: nothing has been left out yet.
    pub(super) fn begin(&mut self) {
        self.found.clear();
        self.complete = true;
    }

    /// Takes all crossings of a root that shadow rays see; false if its nearest has to be asked for.
    #[inline]
    pub(super) fn take(&mut self, geometry: &Geometry, item: &Item, ray: &Ray, range: Range) -> bool {
        if item.hidden & RayClass::Filtered.bit() != 0 {
            return true;
        }
        let before = self.found.len();
        let plain = match item.solid {
            Solid::Leaf(leaf) => geometry.chord(item.solid, ray, range).is_some_and(|(chord, length)| {
                let [enter, leave] = [chord.span.enter, chord.span.leave]
                    .map(|(t, part)| Found::on_part(t / length, leaf, t, part));
                let met = enter.t <= leave.t;
                self.found.extend([enter, leave].into_iter().filter(|f| met && range.contains(f.t)));
                true
            }),
            Solid::Compound(i) => geometry.compounds[i as usize].plain_crossings(
                geometry,
                &Probe::new(ray),
                range,
                &mut self.found,
            ),
        };
        if !plain {
            self.found.truncate(before);
        }
        plain
    }

    /// Puts crossings in order; `other` is the nearest of what is not plain. The nearest of all, or `None` if that is
    /// in doubt.
    pub(super) fn settle(&mut self, ray: &Ray, other: Option<Found>) -> Option<Obstacle<Found>> {
        if let Some(other) = other {
            self.found.push(other);
        }
        self.found.sort_unstable_by(|a, b| a.t.total_cmp(&b.t));
        let size = ray.origin.abs().max_element();
        let is_close = |pair: &[Found]| !(pair[1].t - pair[0].t > margin(size, pair[1].t));
        if let Some(i) = self.found.windows(2).position(is_close) {
            if i == 0 {
                return None;
            }
            self.found.truncate(i);
            self.complete = false;
        }
        if let Some(other) = other
            && let Some(i) = self.found.iter().position(|f| f.t == other.t)
        {
            self.found.truncate(i + 1);
            self.complete = false;
        }
        Some(self.found.first().map_or(Obstacle::None, |&first| Obstacle::Filter(first)))
    }
}

impl World {
    /// As [`World::obstacle`], and what else the ray crosses.
    pub fn obstacle_and_all(
        &self,
        ray: &Ray,
        range: Range,
        last: &mut Blocker,
        crossed: &mut Crossed,
    ) -> Obstacle<Hit> {
        self.as_hit(ray, self.geometry.obstacle_and_all(ray, range, &mut last.0, crossed))
    }

    /// Crossing `i` on the ray for which they were found.
    pub fn crossing(&self, ray: &Ray, crossed: &Crossed, i: usize) -> Next {
        match crossed.found.get(i) {
            Some(found) => Next::Hit(self.hit(ray, found)),
            None if crossed.complete => Next::Nothing,
            None => Next::Unknown,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::flatten::Flattened;
    use super::super::geometry::NONE;
    use super::super::tests::{csg, shape};
    use super::super::{Accel, RayClass};
    use super::*;
    use crate::math::Vec3;
    use crate::scene::CsgOp;
    use crate::shape::{Cuboid, Plane, Sphere};
    use std::sync::Arc;

    /// Shells, a box, a plane, twins, and a merge, whose crossings are not plain; all let light through.
    fn geometry() -> Geometry {
        let ball = |x: f64, r: f64| shape(Sphere::new(Vec3::X * x, r));
        let cube = shape(Cuboid::new(Vec3::splat(-0.5), Vec3::splat(0.3)));
        let objects = [
            csg(CsgOp::Difference, &[&ball(0.0, 2.0), &ball(0.0, 1.5)]),
            csg(CsgOp::Difference, &[&ball(0.2, 1.8), &ball(0.1, 1.4), &cube]),
            csg(CsgOp::Merge, &[&ball(2.0, 0.5), &ball(2.4, 0.5)]),
            cube,
            ball(-3.0, 0.4),
            ball(-3.0, 0.4),
            shape(Plane::new(Vec3::Y, -0.7).expect("a plane")),
        ];
        let mut geometry = Flattened::new(&objects.map(Arc::new), Accel::ByScene).geometry;
        for item in geometry.finite.iter_mut().chain(&mut geometry.infinite) {
            (item.shades, item.hidden) = (false, 0);
        }
        geometry
    }

    #[test]
    fn all_is_what_is_met_one_by_one() {
        let (geometry, mut random) = (geometry(), crate::math::bvh::tests::Random::new(5));
        let (mut crossed, mut complete, mut known) = (Crossed::default(), 0, 0);
        for i in 0..3000 {
            let (origin, towards) = (random.vector(5.0), random.vector(3.0));
            let ray = Ray::new(origin, (towards - origin).normalize_or(Vec3::X));
            let range = Range::new(0.0, if i % 2 == 0 { f64::INFINITY } else { 5.0 * random.unit() });
            let mut from = range;
            let all: Vec<Found> = std::iter::from_fn(|| {
                let found = geometry.nearest(&ray, from, RayClass::Filtered)?;
                from.min = found.t.next_up();
                Some(found)
            })
            .collect();
            let same = |a: &Found, b: &Found| {
                (a.leaf, a.crossing.part) == (b.leaf, b.crossing.part) && (a.t - b.t).abs() < 1e-12
            };
            match geometry.obstacle_and_all(&ray, range, &mut NONE.clone(), &mut crossed) {
                Obstacle::Filter(first) => assert!(same(&first, &all[0]), "{ray:?}"),
                other => assert!(all.is_empty() && matches!(other, Obstacle::None), "{ray:?}"),
            }
            assert!(crossed.found.iter().zip(&all).all(|(a, b)| same(a, b)), "{ray:?} {crossed:?} {all:?}");
            assert!(crossed.found.len() <= all.len());
            if crossed.complete {
                assert_eq!(crossed.found.len(), all.len(), "{ray:?}");
            }
            complete += usize::from(crossed.complete && all.len() > 2);
            known += crossed.found.len();
        }
        assert!(complete > 500 && known > 5000, "{complete} {known}");
    }
}
