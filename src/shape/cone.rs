//! Cone: a disc whose radius changes linearly along an axis.
//!
//! `|across(p)| = radius(height)`, `radius(h) = base_radius + slope h`, `0 <= h <= length`.
//!
//! | parameter | unit | meaning |
//! |---|---|---|
//! | base, cap | length | the axis' ends, not equal |
//! | base_radius, cap_radius | length | radii there; of different sign, the cone passes through its apex |
//! | open | – | leaves the two discs at the ends out; the inside stays |
//!
//! Numerical care: as for the cylinder, intervals are intersected, so rims have no gaps. Equal radii need
//! no case of their own: the quadratic's leading coefficient may be 0 or anything near it. At the apex the
//! normal is the axis, pointing away from the wider end.

use super::cylinder::{direction_and_length, end_span};
use super::span::Span;
use super::{COINCIDENT, Chord, Crossing, Shape, rounding};
use crate::math::{Aabb, Range, Ray, Vec3};

const WALL: u32 = 0;
const BASE: u32 = 1;
const CAP: u32 = 2;

#[derive(Clone, Debug, PartialEq)]
pub struct Cone {
    base: Vec3,
    /// Unit vector from base to cap.
    axis: Vec3,
    length: f64,
    base_radius: f64,
    cap_radius: f64,
    /// Change of the radius per unit of height.
    slope: f64,
    open: bool,
}

/// At most two parts of a line, the first one in the first place.
type Pieces = [Option<Span>; 2];

const NOTHING: Pieces = [None, None];

impl Cone {
    /// `None` if the ends coincide.
    pub fn new(base: Vec3, base_radius: f64, cap: Vec3, cap_radius: f64, open: bool) -> Option<Self> {
        let (axis, length) = direction_and_length(cap - base)?;
        let slope = (cap_radius - base_radius) / length;
        Some(Self { base, axis, length, base_radius, cap_radius, slope, open })
    }

    /// The parts of a line that are inside, in order.
    fn pieces(&self, ray: &Ray) -> Pieces {
        let oc = ray.origin - self.base;
        let (height, climb) = (oc.dot(self.axis), ray.dir.dot(self.axis));
        let walls = self.wall(oc, ray.dir, height, climb);
        if walls[0].is_none() {
            return NOTHING;
        }
        let Some(ends) = end_span(height, climb, self.length) else { return NOTHING };
        walls.map(|wall| {
            let wall = wall?;
            // A line through the apex may touch the wall; one that grazes a rim misses.
            let touches = wall.enter.0 == wall.leave.0;
            let span = if self.open { ends.intersection(wall) } else { wall.intersection(ends) };
            (span.enter.0 < span.leave.0 || (touches && !span.is_empty())).then_some(span)
        })
    }

    /// Where a line is inside the endless double cone: `a t² + 2 b t + c <= 0`.
    #[inline]
    fn wall(&self, oc: Vec3, dir: Vec3, height: f64, climb: f64) -> Pieces {
        let (across, sideways) = (oc - height * self.axis, dir - climb * self.axis);
        let (radius, growth) = (self.base_radius + self.slope * height, self.slope * climb);
        let a = sideways.length_squared() - growth * growth;
        let b = across.dot(sideways) - radius * growth;
        let c = across.length_squared() - radius * radius;
        let disc = b * b - a * c;
        if disc < 0.0 || disc.is_nan() {
            // A line steeper than the cone always passes through it; any other misses it.
            return if a < 0.0 { [Some(Span::line(WALL)), None] } else { NOTHING };
        }
        let q = -(b + disc.sqrt().copysign(b));
        if q == 0.0 {
            let always = c <= 0.0 && a <= 0.0;
            return if always { [Some(Span::line(WALL)), None] } else { Self::touch(a, b) };
        }
        let (t0, t1) = (q / a, c / q);
        let (t0, t1) = if t0 < t1 { (t0, t1) } else { (t1, t0) };
        if a > 0.0 {
            return [Some(Span::new(t0, t1, WALL)), None];
        }
        let (before, behind) = (f64::NEG_INFINITY, f64::INFINITY);
        if a == 0.0 {
            let t = c / q;
            let span = if b > 0.0 { Span::new(before, t, WALL) } else { Span::new(t, behind, WALL) };
            return [Some(span), None];
        }
        [Some(Span::new(before, t0, WALL)), Some(Span::new(t1, behind, WALL))]
    }

    /// A line through the apex that meets the cone nowhere else.
    fn touch(a: f64, b: f64) -> Pieces {
        if a > 0.0 { [Some(Span::new(-b / a, -b / a, WALL)), None] } else { NOTHING }
    }

    /// The crossings inside `range`, in order.
    #[inline]
    fn ends(&self, ray: &Ray, range: Range) -> impl Iterator<Item = Crossing> {
        let shown = |c: &Crossing| !(self.open && c.part != WALL);
        self.pieces(ray).into_iter().flatten().flat_map(move |span| span.ends(range, None)).filter(shown)
    }
}

impl Shape for Cone {
    fn bounds(&self) -> Aabb {
        let cap = self.base + self.length * self.axis;
        let across = (Vec3::ONE - self.axis * self.axis).max(Vec3::ZERO).map(f64::sqrt);
        let disc =
            |center: Vec3, r: f64| Aabb { min: center - r.abs() * across, max: center + r.abs() * across };
        disc(self.base, self.base_radius).union(disc(cap, self.cap_radius))
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        out.extend(self.ends(ray, range));
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        self.ends(ray, range).next()
    }

    fn chord(&self, ray: &Ray, _range: Range) -> Option<Chord> {
        if self.open || self.base_radius * self.cap_radius < 0.0 {
            return None;
        }
        // Two parts touch at the apex.
        let [first, second] = self.pieces(ray);
        let joined = |a: Span, b: Span| Span { enter: a.enter, leave: b.leave };
        Some(Chord::within(first.zip(second).map(|(a, b)| joined(a, b)).or(first).or(second)))
    }

    fn contains(&self, p: Vec3) -> bool {
        let q = p - self.base;
        let height = q.dot(self.axis);
        let across = (q - height * self.axis).length();
        let size = self.length + self.base_radius.abs().max(self.cap_radius.abs());
        let margin = COINCIDENT * size + rounding(p.abs().max_element());
        // With its ends on, the surface is outside; without them, inside.
        let margin = if self.open { margin } else { -margin };
        let radius = (self.base_radius + self.slope * height).abs();
        across < radius + margin && height > -margin && height < self.length + margin
    }

    fn normal(&self, p: Vec3, crossing: &Crossing) -> Vec3 {
        match crossing.part {
            BASE => -self.axis,
            CAP => self.axis,
            _ => {
                let q = p - self.base;
                let height = q.dot(self.axis);
                let across = (q - height * self.axis).normalize_or_zero();
                let slope =
                    if self.base_radius + self.slope * height < 0.0 { -self.slope } else { self.slope };
                (across - slope * self.axis).normalize_or(self.axis)
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
            _ => {
                let radius = (self.base_radius + self.slope * height).abs();
                self.base + height * self.axis + across.normalize_or_zero() * radius
            }
        };
        let size = self.length + self.base_radius.abs().max(self.cap_radius.abs());
        (p, rounding(2.0 * (self.base.abs().max_element() + size)))
    }

    fn kind(&self) -> &'static str {
        "cone"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hit(c: &Cone, o: [f64; 3], d: [f64; 3]) -> Option<(Vec3, Vec3)> {
        let ray = Ray::new(Vec3::from(o), Vec3::from(d).normalize());
        c.nearest(&ray, Range::FORWARD).map(|x| (ray.at(x.t), c.normal(c.locate(&ray, &x).0, &x)))
    }

    #[test]
    fn apex_and_rim() {
        let c = Cone::new(Vec3::ZERO, 1.0, 2.0 * Vec3::Y, 0.0, false).unwrap();
        assert_eq!(hit(&c, [0.0, 3.0, 0.0], [0.0, -1.0, 0.0]).unwrap().1, Vec3::Y);
        assert!(hit(&c, [0.0, 2.0, -3.0], [0.0, 0.0, 1.0]).unwrap().1.is_finite());
        assert!(hit(&c, [1.0, -1.0, 0.0], [0.0, 1.0, 0.0]).is_none());
        assert!(hit(&c, [0.999999, -1.0, 0.0], [0.0, 1.0, 0.0]).is_some());
        let (p, n) = hit(&c, [0.0, 0.0, -3.0], [0.0, 0.0, 1.0]).unwrap();
        assert!(p.distance(Vec3::NEG_Z) < 1e-15);
        assert!(n.distance(Vec3::new(0.0, 0.2f64.sqrt(), -0.8f64.sqrt())) < 1e-15);
    }

    #[test]
    fn radii_of_different_sign_make_two_nappes() {
        let c = Cone::new(Vec3::ZERO, -0.5, 2.0 * Vec3::Y, 1.0, false).unwrap();
        let (p, n) = hit(&c, [0.0, 0.2, -3.0], [0.0, 0.0, 1.0]).unwrap();
        assert!((p.z + 0.35).abs() < 1e-12 && n.distance(Vec3::new(0.0, 0.6, -0.8)) < 1e-12);
        let (p, n) = hit(&c, [0.0, 1.2, -3.0], [0.0, 0.0, 1.0]).unwrap();
        assert!((p.z + 0.4).abs() < 1e-12 && n.distance(Vec3::new(0.0, -0.6, -0.8)) < 1e-12);
    }
}
