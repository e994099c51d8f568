//! What stands in the way of light.

use super::accel::Finite;
use super::ball::Met;
use super::between::Between;
use super::crossed::Crossed;
use super::geometry::{Found, Geometry, Item, NONE, Nearest, Solid};
use super::hit::{Obstacle, RayClass};
use crate::math::{AnyHit, Range, Ray, Vec3};
use crate::shape::Plane;

impl Geometry {
    /// A plane's normal and distance in the world, if the item is one and stands as it was made.
    pub fn half_space(&self, item: &Item) -> Option<(Vec3, f64)> {
        let Solid::Leaf(i) = item.solid else { return None };
        let leaf = &self.leaves[i as usize];
        leaf.shape.half_space().filter(|_| leaf.place.is_none())
    }

    /// [`Geometry::obstacle`] for a ray in a shaft.
    pub fn obstacle_between(&self, between: &Between, ray: &Ray, range: Range) -> Obstacle<Found> {
        let mut nobody = NONE;
        self.obstacle_among(between, (&between.infinite, &[]), ray, range, &mut nobody, None)
    }

    /// What stands in the way of light inside `range`. `last` remembers which opaque finite object did by
    /// its place, and it is asked first: neighbouring rays are mostly stopped by the same object.
    pub fn obstacle(&self, ray: &Ray, range: Range, last: &mut u32) -> Obstacle<Found> {
        match &self.search {
            Finite::Tree(tree) => self.obstacle_past(tree, ray, range, last, None),
            _ => self.obstacle_treeless(ray, range, last, None),
        }
    }

    /// Whether no object lets light through or changes it: [`Geometry::is_stopped`] then says all.
    pub fn stops_or_passes(&self) -> bool {
        let seen = |item: &Item| item.hidden & RayClass::Filtered.bit() == 0;
        self.finite.iter().chain(&self.infinite).all(|item| item.shades || !seen(item))
    }

    /// Whether light is stopped inside `range`, by objects that stop all of it; `last` as for
    /// [`Geometry::obstacle`].
    #[inline]
    pub fn is_stopped(&self, ray: &Ray, range: Range, last: &mut u32) -> bool {
        if *last != NONE && self.is_met_at(*last, ray, range) {
            return true;
        }
        let by_plane = |(item, plane): (&Item, &Option<Plane>)| {
            item.shades
                && match plane {
                    Some(plane) => range.contains(plane.along(ray)),
                    None => self.meets(item.solid, ray, range),
                }
        };
        if self.infinite.iter().zip(&self.planes).any(by_plane) {
            return true;
        }
        match &self.search {
            Finite::Tree(tree) => self.is_stopped_by(tree, ray, range, last),
            Finite::Grid(grid) => self.is_stopped_by(grid, ray, range, last),
            Finite::List(list) => self.is_stopped_by(list, ray, range, last),
        }
    }

    /// Whether one of the finite objects but `last` stops light.
    #[inline(never)]
    fn is_stopped_by(&self, finite: &impl AnyHit, ray: &Ray, range: Range, last: &mut u32) -> bool {
        let skipped = *last;
        let mut stops = |place: u32, met: Option<bool>| {
            let item = &self.finite[place as usize];
            let stopped =
                item.shades && place != skipped && met.unwrap_or_else(|| self.meets(item.solid, ray, range));
            if stopped {
                *last = place;
            }
            stopped
        };
        if self.balls.is_empty() {
            return finite.any(ray, range, |place| stops(place, None));
        }
        finite.any(ray, range, |place| match self.balls[place as usize].meet(ray, range) {
            Met::Nothing => false,
            Met::Sphere(t) => t < range.max && stops(place, Some(true)),
            Met::Perhaps => stops(place, None),
        })
    }

    /// [`Geometry::obstacle`], and all that the ray crosses where nothing stops it. Apart, so that the short way stays short.
    #[inline(never)]
    pub fn obstacle_and_all(
        &self,
        ray: &Ray,
        range: Range,
        last: &mut u32,
        crossed: &mut Crossed,
    ) -> Obstacle<Found> {
        crossed.begin();
        let met = match &self.search {
            Finite::Tree(tree) => self.obstacle_past(tree, ray, range, last, Some(crossed)),
            _ => self.obstacle_treeless(ray, range, last, Some(crossed)),
        };
        let settled = match met {
            Obstacle::Opaque => return Obstacle::Opaque,
            Obstacle::Filter(other) => crossed.settle(ray, Some(other)),
            Obstacle::None => crossed.settle(ray, None),
        };
        settled.unwrap_or_else(|| {
            crossed.forget();
            self.obstacle(ray, range, last)
        })
    }

    #[inline(never)]
    fn obstacle_treeless(
        &self,
        ray: &Ray,
        range: Range,
        last: &mut u32,
        crossed: Option<&mut Crossed>,
    ) -> Obstacle<Found> {
        match &self.search {
            Finite::Tree(_) => Obstacle::None,
            Finite::Grid(grid) => self.obstacle_past(grid, ray, range, last, crossed),
            Finite::List(list) => self.obstacle_past(list, ray, range, last, crossed),
        }
    }

    /// The object that stopped the last ray, then all others.
    #[inline(always)]
    fn obstacle_past(
        &self,
        finite: &impl AnyHit,
        ray: &Ray,
        range: Range,
        last: &mut u32,
        crossed: Option<&mut Crossed>,
    ) -> Obstacle<Found> {
        if *last != NONE && self.is_met_at(*last, ray, range) {
            return Obstacle::Opaque;
        }
        self.obstacle_among(finite, (&self.infinite, &self.planes), ray, range, last, crossed)
    }

    /// Whether the finite object at a place is met.
    #[inline]
    fn is_met_at(&self, place: u32, ray: &Ray, range: Range) -> bool {
        let meets = || self.meets(self.finite[place as usize].solid, ray, range);
        match self.balls.get(place as usize).map(|ball| ball.meet(ray, range)) {
            Some(Met::Nothing) => false,
            Some(Met::Sphere(t)) => t < range.max,
            Some(Met::Perhaps) | None => meets(),
        }
    }

    /// `planes` says which of the infinite objects are planes, as far as that is known.
    ///
    /// Leaves the finite object `last` out, which has been asked, and notes another one there that stops the ray. What
    /// `crossed` takes is left out, too.
    #[inline(always)]
    fn obstacle_among(
        &self,
        finite: &impl AnyHit,
        (infinite, planes): (&[Item], &[Option<Plane>]),
        ray: &Ray,
        range: Range,
        last: &mut u32,
        mut crossed: Option<&mut Crossed>,
    ) -> Obstacle<Found> {
        let skipped = *last;
        let mut filter = Nearest::of(RayClass::Filtered);
        let mut max = range.max;
        // Whether it is met may be known already.
        let mut stops = |item: &Item, place: u32, met: Option<bool>| {
            if !item.shades {
                if let Some(crossed) = &mut crossed
                    && crossed.take(self, item, ray, range)
                {
                    return false;
                }
                max = self.nearer(&mut filter, item, ray, Range::new(range.min, max));
                return false;
            }
            let skips = place == skipped && place != NONE;
            let stopped = !skips && met.unwrap_or_else(|| self.meets(item.solid, ray, range));
            if stopped {
                *last = place;
            }
            stopped
        };
        let plane = |i: usize| planes.get(i)?.as_ref();
        let stopped = infinite.iter().enumerate().any(|(i, item)| match plane(i) {
            Some(plane) if item.shades => range.contains(plane.along(ray)),
            _ => stops(item, NONE, None),
        }) || if self.finite.is_empty() {
            false
        } else if self.balls.is_empty() {
            finite.any(ray, range, |place| stops(&self.finite[place as usize], place, None))
        } else {
            finite.any(ray, range, |place| {
                let met = match self.balls[place as usize].meet(ray, range) {
                    Met::Nothing => return false,
                    Met::Sphere(t) => Some(t < range.max),
                    Met::Perhaps => None,
                };
                stops(&self.finite[place as usize], place, met)
            })
        };
        if stopped {
            return Obstacle::Opaque;
        }
        match filter.found {
            Some(found) => Obstacle::Filter(found),
            None => Obstacle::None,
        }
    }
}
