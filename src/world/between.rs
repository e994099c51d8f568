//! The objects that may stand between one place and a box of lamps: found once, for many shadow rays.

use super::accel::Finite;
use super::geometry::{Geometry, Item};
use super::hit::RayClass;
use super::probe::{Probe, Reach};
use crate::math::{AnyHit, Range, Ray, Shaft};
use std::cell::{Cell, OnceCell};

/// More objects are better sought ray by ray.
const MOST: usize = 8;

/// What shadow rays that stay in one [`Shaft`] may meet; kept to be filled again.
#[derive(Debug, Default)]
pub struct Between {
    /// Places in `Geometry::finite`, and boxes around those that take longer than their boxes.
    finite: Vec<(u32, Option<Reach>)>,
    pub(super) infinite: Vec<Item>,
    /// Which of the finite ones stopped the last ray: neighbouring rays are mostly stopped by the same.
    first: Cell<usize>,
}

impl Between {
    /// Whether nothing stands in the way of any ray.
    pub fn is_empty(&self) -> bool {
        self.finite.is_empty() && self.infinite.is_empty()
    }
}

/// The finite objects, all of them: they have been chosen already.
impl AnyHit for Between {
    #[inline]
    fn any(&self, ray: &Ray, range: Range, mut visit: impl FnMut(u32) -> bool) -> bool {
        let probe = OnceCell::new();
        let meets = |reach: &Reach| probe.get_or_init(|| Probe::new(ray)).meets(reach, range);
        let mut i = self.first.get();
        for _ in 0..self.finite.len() {
            i = if i < self.finite.len() { i } else { 0 };
            let (place, reach) = &self.finite[i];
            if reach.as_ref().is_none_or(meets) && visit(*place) {
                self.first.set(i);
                return true;
            }
            i += 1;
        }
        false
    }
}

impl Geometry {
    /// See [`World::stands_between`](super::World::stands_between).
    pub fn stands_between(&self, shaft: &Shaft, between: &mut Between) -> bool {
        between.finite.clear();
        between.infinite.clear();
        let matters = |item: &Item| item.shades || item.hidden & RayClass::Filtered.bit() == 0;
        let beside = |item: &Item| self.half_space(item).is_some_and(|(n, d)| shaft.is_beside(n, d));
        between.infinite.extend(self.infinite.iter().filter(|item| matters(item) && !beside(item)));
        let finite = &mut between.finite;
        let mut take = |place: u32| {
            let item = &self.finite[place as usize];
            let bounds = &self.root_bounds[item.root as usize];
            if matters(item) && shaft.meets(bounds) {
                finite.push((place, item.is_slow().then(|| Reach::new(bounds))));
            }
            finite.len() <= MOST
        };
        match &self.search {
            Finite::Tree(tree) => tree.in_shaft(shaft, &mut take),
            Finite::List(_) if self.finite.len() <= MOST => {
                (0..self.finite.len() as u32).for_each(|place| {
                    take(place);
                });
            }
            Finite::List(_) | Finite::Grid(_) => return false,
        }
        finite.len() <= MOST
    }
}
