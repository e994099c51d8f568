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
