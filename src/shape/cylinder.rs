//! Cylinder: the points within `radius` of an axis, between two planes across it.
//!
//! | parameter | unit | meaning |
//! |---|---|---|
//! | base, cap | length | the axis' ends, not equal |
//! | radius | length | its sign means nothing |
//! | open | – | leaves the two discs at the ends out; the inside stays |
//!
//! Numerical care: a line is inside between the later of two entries (wall, ends) and the earlier of two
//! exits, so rims have no gaps. The wall's discriminant comes from the line's distance to the axis. A line
//! that touches the wall misses; on a rim the end disc shows, unless there is none.

use super::span::{Span, slab};
use super::{COINCIDENT, Chord, Crossing, Shape, rounding};
use crate::math::{Aabb, Range, Ray, Vec3};

/// Lines whose discriminant is negative by more than this share of its terms miss beyond any rounding.
const CLEAR: f64 = 64.0 * f64::EPSILON;

/// Part of the wall.
const WALL: u32 = 0;
/// Part of the end at `base`, then of the end at `cap`.
const BASE: u32 = 1;
const CAP: u32 = 2;

#[derive(Clone, Debug, PartialEq)]
pub struct Cylinder {
    base: Vec3,
    /// Unit vector from base to cap.
    axis: Vec3,
    length: f64,
    radius: f64,
    open: bool,
}

impl Cylinder {
    /// `None` if the ends coincide.
    pub fn new(base: Vec3, cap: Vec3, radius: f64, open: bool) -> Option<Self> {
        let (axis, length) = direction_and_length(cap - base)?;
        Some(Self { base, axis, length, radius: radius.abs(), open })
    }

    fn span(&self, ray: &Ray) -> Option<Span> {
        let oc = ray.origin - self.base;
        let (height, climb) = (oc.dot(self.axis), ray.dir.dot(self.axis));
        let wall = self.wall(oc - height * self.axis, ray.dir - climb * self.axis)?;
        let ends = end_span(height, climb, self.length)?;
        let span = if self.open { ends.intersection(wall) } else { wall.intersection(ends) };
        (!span.is_empty()).then_some(span)
    }

    /// Where a line is inside the endless cylinder; origin and direction are across the axis.
    fn wall(&self, origin: Vec3, dir: Vec3) -> Option<Span> {
        let a = dir.length_squared();
        let (far2, radius2) = (origin.length_squared(), self.radius * self.radius);
        let c = far2 - radius2;
        if a == 0.0 {
            return (c <= 0.0).then(|| Span::line(WALL));
        }
        let b = origin.dot(dir);
        if b * b < a * (c - CLEAR * (far2 + radius2)) {
            return None;
        }
        let closest = origin - (b / a) * dir;
        let half_chord2 = self.radius * self.radius - closest.length_squared();
        if half_chord2.is_nan() || half_chord2 <= 0.0 {
            return None;
        }
        let q = -(b + (a * half_chord2).sqrt().copysign(b));
        let (t0, t1) = (q / a, c / q);
        Some(Span::new(t0.min(t1), t0.max(t1), WALL))
    }

    fn skipped(&self, crossing: &Crossing) -> bool {
        self.open && crossing.part != WALL
    }
}

/// Unit direction and length of a vector; `None` if it has none.
pub(super) fn direction_and_length(v: Vec3) -> Option<(Vec3, f64)> {
    Some((v.try_normalize()?, v.length()))
}

/// Where a line is between the planes of the two ends.
pub(super) fn end_span(height: f64, climb: f64, length: f64) -> Option<Span> {
    let (t0, t1) = slab(height, climb, 0.0, length)?;
    let (first, second) = if climb > 0.0 { (BASE, CAP) } else { (CAP, BASE) };
    Some(Span { enter: (t0, first), leave: (t1, second) })
}

impl Shape for Cylinder {
    fn bounds(&self) -> Aabb {
        let cap = self.base + self.length * self.axis;
        let reach = self.radius * (Vec3::ONE - self.axis * self.axis).max(Vec3::ZERO).map(f64::sqrt);
        let b = Aabb::new(self.base, cap);
        Aabb { min: b.min - reach, max: b.max + reach }
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        if let Some(span) = self.span(ray) {
            out.extend(span.ends(range, None).filter(|c| !self.skipped(c)));
        }
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        self.span(ray)?.ends(range, None).find(|c| !self.skipped(c))
    }

    fn chord(&self, ray: &Ray, _range: Range) -> Option<Chord> {
        (!self.open).then(|| Chord::within(self.span(ray)))
    }

    fn contains(&self, p: Vec3) -> bool {
        let q = p - self.base;
        let height = q.dot(self.axis);
        let across = (q - height * self.axis).length();
        // With its ends on, the surface is outside; without them, inside.
        let margin = COINCIDENT * (self.length + self.radius) + rounding(p.abs().max_element());
        let margin = if self.open { margin } else { -margin };
        across < self.radius + margin && height > -margin && height < self.length + margin
    }

    fn normal(&self, p: Vec3, crossing: &Crossing) -> Vec3 {
        match crossing.part {
            BASE => -self.axis,
            CAP => self.axis,
            _ => {
                let q = p - self.base;
                (q - q.dot(self.axis) * self.axis).normalize_or(self.axis.any_orthonormal_vector())
            }
        }
    }

    fn locate(&self, ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        let q = ray.at(crossing.t) - self.base;
        let height = q.dot(self.axis);
        let across = q - height * self.axis;
        let p = match crossing.part {
            BASE => self.base + across,
            CAP => self.base + across + self.length * self.axis,
            _ => self.base + height * self.axis + across.normalize_or_zero() * self.radius,
        };
        (p, rounding(self.base.abs().max_element() + self.length + self.radius))
    }

    fn kind(&self) -> &'static str {
        "cylinder"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hit(open: bool, o: [f64; 3], d: [f64; 3]) -> Option<Vec3> {
        let c = Cylinder::new(Vec3::ZERO, 2.0 * Vec3::Y, 1.0, open).unwrap();
        let ray = Ray::new(Vec3::from(o), Vec3::from(d).normalize());
        c.nearest(&ray, Range::FORWARD).map(|x| c.normal(c.locate(&ray, &x).0, &x))
    }

    #[test]
    fn rims_show_the_end_disc() {
        assert_eq!(hit(false, [-3.0, 3.0, 0.0], [2.0, -1.0, 0.0]), Some(Vec3::Y));
        assert_eq!(hit(true, [-2.0, 3.0, 0.0], [1.0, -1.0, 0.0]), Some(Vec3::NEG_X));
        assert_eq!(hit(false, [0.0, 3.0, 1.0], [0.0, -1.0, 0.0]), Some(Vec3::Y));
        assert_eq!(hit(true, [0.5, 3.0, 0.0], [0.0, -1.0, 0.0]), None);
        assert_eq!(hit(false, [1.0, 1.0, -3.0], [0.0, 0.0, 1.0]), None);
        assert_eq!(hit(false, [0.0, 2.0, -3.0], [0.0, 0.0, 1.0]), Some(Vec3::NEG_Z));
    }

    #[test]
    fn the_ends_decide_whether_the_surface_is_inside() {
        for (open, inside) in [(false, false), (true, true)] {
            let c = Cylinder::new(Vec3::ZERO, 2.0 * Vec3::Y, 1.0, open).unwrap();
            assert_eq!(c.contains(Vec3::new(1.0, 1.0, 0.0)), inside);
            assert_eq!(c.contains(Vec3::new(0.5, 2.0, 0.0)), inside);
        }
    }
}
