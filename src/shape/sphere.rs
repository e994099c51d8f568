//! Sphere: `|p - center| = |radius|`.
//!
//! | parameter | unit | meaning |
//! |---|---|---|
//! | center | length | |
//! | radius | length | a negative radius turns the normal inward and changes nothing else |
//!
//! Numerical care: the discriminant is taken from the point of the line closest to the center, so a small
//! sphere far away is as sharp as one close by; roots are formed without cancellation, so the sign of each
//! is the sign of the constant term. A ray that touches the sphere misses it.
//!
//! Reference: E. Haines et al., "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems, 2019.

use super::{Chord, Crossing, Place, Shape, Span, rounding};
use crate::math::{Aabb, Range, Ray, Vec2, Vec3};
use std::f64::consts::PI;

#[derive(Clone, Debug, PartialEq)]
pub struct Sphere {
    center: Vec3,
    radius: f64,
}

impl Sphere {
    pub fn new(center: Vec3, radius: f64) -> Self {
        Self { center, radius }
    }
}

/// Both ends of a line inside the sphere of radius `radius` about the origin, if it enters.
#[inline]
pub(crate) fn sphere_span(oc: Vec3, dir: Vec3, radius: f64) -> Option<(f64, f64)> {
    let along = oc.dot(dir);
    let closest = oc - along * dir;
    let half_chord2 = radius * radius - closest.length_squared();
    if half_chord2.is_nan() || half_chord2 <= 0.0 {
        return None;
    }
    let q = -(along + half_chord2.sqrt().copysign(along));
    let product = oc.length_squared() - radius * radius;
    let other = product / q;
    Some(if q < other { (q, other) } else { (other, q) })
}

/// Where the ray is on a sphere of positive radius, with the normal outward.
#[inline]
pub(crate) fn place_on_sphere(center: Vec3, radius: f64, ray: &Ray, t: f64) -> Place {
    let out = (ray.at(t) - center).normalize_or(Vec3::X);
    Place {
        point: center + radius * out,
        error: rounding(center.abs().max_element() + radius),
        normal: out,
        face: None,
    }
}

/// Angle about the y axis as a fraction of a turn: 0 at +x, growing towards +z; 0 on the axis.
pub(super) fn turn_about_y(p: Vec3) -> f64 {
    let turn = p.z.atan2(p.x) / (2.0 * PI);
    if turn < 0.0 { turn + 1.0 } else { turn }
}

impl Shape for Sphere {
    fn bounds(&self) -> Aabb {
        let r = Vec3::splat(self.radius.abs());
        Aabb { min: self.center - r, max: self.center + r }
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        if let Some((t0, t1)) = sphere_span(ray.origin - self.center, ray.dir, self.radius) {
            out.extend([t0, t1].into_iter().filter(|&t| range.contains(t)).map(Crossing::new));
        }
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let (t0, t1) = sphere_span(ray.origin - self.center, ray.dir, self.radius)?;
        [t0, t1].into_iter().find(|&t| range.contains(t)).map(Crossing::new)
    }

    fn chord(&self, ray: &Ray, _range: Range) -> Option<Chord> {
        let span = sphere_span(ray.origin - self.center, ray.dir, self.radius);
        Some(Chord::within(span.map(|(t0, t1)| Span::new(t0, t1, 0))))
    }

    fn contains(&self, p: Vec3) -> bool {
        p.distance_squared(self.center) < self.radius * self.radius
    }

    fn normal(&self, p: Vec3, _crossing: &Crossing) -> Vec3 {
        let out = (p - self.center).normalize_or(Vec3::X);
        if self.radius < 0.0 { -out } else { out }
    }

    fn locate(&self, ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        let at = self.at(ray, crossing);
        (at.point, at.error)
    }

    fn at(&self, ray: &Ray, crossing: &Crossing) -> Place {
        let at = place_on_sphere(self.center, self.radius.abs(), ray, crossing.t);
        Place { normal: if self.radius < 0.0 { -at.normal } else { at.normal }, ..at }
    }

    fn uv(&self, p: Vec3, _crossing: &Crossing) -> Option<Vec2> {
        let q = (p - self.center) / self.radius.abs();
        Some(Vec2::new(turn_about_y(q), 0.5 + q.y.clamp(-1.0, 1.0).asin() / PI))
    }

    fn sphere(&self) -> Option<(Vec3, f64)> {
        (self.radius > 0.0).then_some((self.center, self.radius))
    }

    fn kind(&self) -> &'static str {
        "sphere"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tangent_misses() {
        let s = Sphere::new(Vec3::ZERO, 1.0);
        let ray = |x| Ray::new(Vec3::new(x, 0.0, -3.0), Vec3::Z);
        assert!(s.nearest(&ray(1.0), Range::FORWARD).is_none());
        assert!(s.nearest(&ray(0.999999999), Range::FORWARD).is_some());
    }

    #[test]
    fn a_place_is_what_its_parts_are() {
        for radius in [2.0, -2.0] {
            let s = Sphere::new(Vec3::new(1.0, 2.0, 3.0), radius);
            for i in 0..20 {
                let ray =
                    Ray::new(Vec3::new(1.3, 2.0, -4.0), Vec3::new(0.01 * f64::from(i), 0.1, 1.0).normalize());
                let crossing = s.nearest(&ray, Range::FORWARD).expect("a hit");
                let (at, (point, error)) = (s.at(&ray, &crossing), s.locate(&ray, &crossing));
                assert_eq!((at.point, at.error, at.face), (point, error, None));
                assert!(at.normal.distance(s.normal(point, &crossing)) < 1e-15);
                assert!(at.normal.dot(ray.dir) * radius < 0.0);
            }
        }
    }

    #[test]
    fn far_away_it_keeps_its_size() {
        let s = Sphere::new(Vec3::new(1e7, 0.5, 0.0), 0.75);
        let ray = Ray::new(Vec3::new(0.0, 1.0, 0.25), Vec3::X);
        let hit = s.nearest(&ray, Range::FORWARD).unwrap();
        let expected = 1e7 - (0.75f64.powi(2) - 0.5f64.powi(2) - 0.25f64.powi(2)).sqrt();
        assert!((hit.t - expected).abs() < 4e-9, "{} {expected}", hit.t);
    }

    #[test]
    fn the_seam_is_at_plus_x() {
        let s = Sphere::new(Vec3::new(1.0, 2.0, 3.0), 2.0);
        let uv = |d: Vec3| s.uv(Vec3::new(1.0, 2.0, 3.0) + 2.0 * d, &Crossing::new(0.0)).unwrap();
        assert_eq!(uv(Vec3::X), Vec2::new(0.0, 0.5));
        assert_eq!(uv(Vec3::Z), Vec2::new(0.25, 0.5));
        assert_eq!(uv(Vec3::NEG_Z), Vec2::new(0.75, 0.5));
        assert_eq!(uv(Vec3::Y), Vec2::new(0.0, 1.0));
    }
}
