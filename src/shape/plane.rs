//! Plane: `normal · p = distance`; the solid is the half space that the normal points away from.
//!
//! | parameter | unit | meaning |
//! |---|---|---|
//! | normal | – | made unit length |
//! | distance | length | along the unit normal |
//!
//! Numerical care: a ray counts as parallel only when rounding alone could have tilted it. The half space
//! is closed, and so is the one that `inverse` gives.

use super::{COINCIDENT, Chord, Crossing, Place, Shape, Span, rounding};
use crate::math::{Aabb, EPSILON, Range, Ray, Vec3};
use std::sync::Arc;

#[derive(Clone, Debug, PartialEq)]
pub struct Plane {
    normal: Vec3,
    distance: f64,
}

/// Rays whose direction is perpendicular to a normal up to this many roundings run along the surface.
const PARALLEL: f64 = 4.0 * EPSILON;

/// Distance at which a ray meets the plane through `point`.
pub(super) fn meet(ray: &Ray, normal: Vec3, point: Vec3) -> Option<f64> {
    let speed = normal.dot(ray.dir);
    (speed.abs() > PARALLEL).then(|| normal.dot(point - ray.origin) / speed)
}

impl Plane {
    /// `None` if `normal` has no direction.
    pub fn new(normal: Vec3, distance: f64) -> Option<Self> {
        Some(Self { normal: normal.try_normalize()?, distance })
    }

    /// The one that [`Shape::half_space`] tells of.
    pub(crate) fn of_half_space((normal, distance): (Vec3, f64)) -> Self {
        Self { normal, distance }
    }

    /// How far along the ray it is; no number inside any range if the ray runs along it.
    #[inline]
    pub(crate) fn along(&self, ray: &Ray) -> f64 {
        let speed = self.normal.dot(ray.dir);
        if speed.abs() > PARALLEL { -self.height(ray.origin) / speed } else { f64::NAN }
    }

    #[inline]
    fn height(&self, p: Vec3) -> f64 {
        self.normal.dot(p) - self.distance
    }

    fn scale(&self, p: Vec3) -> f64 {
        self.normal.abs().dot(p.abs()) + self.distance.abs()
    }
}

impl Shape for Plane {
    fn bounds(&self) -> Aabb {
        Aabb::INFINITE
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        out.extend(self.nearest(ray, range));
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let t = self.along(ray);
        range.contains(t).then(|| Crossing::new(t))
    }

    fn chord(&self, ray: &Ray, _range: Range) -> Option<Chord> {
        let speed = self.normal.dot(ray.dir);
        if speed.abs() <= PARALLEL {
            return Some(if self.contains(ray.origin) { Chord::INSIDE } else { Chord::OUTSIDE });
        }
        let t = -self.height(ray.origin) / speed;
        let (enter, leave) = if speed < 0.0 { (t, f64::INFINITY) } else { (f64::NEG_INFINITY, t) };
        Some(Chord::within(Some(Span::new(enter, leave, 0))))
    }

    fn contains(&self, p: Vec3) -> bool {
        let height = self.height(p);
        height <= 0.0 || height <= COINCIDENT * self.scale(p)
    }

    fn inverse(&self) -> Option<Arc<dyn Shape>> {
        Some(Arc::new(Plane { normal: -self.normal, distance: -self.distance }))
    }

    fn normal(&self, _p: Vec3, _crossing: &Crossing) -> Vec3 {
        self.normal
    }

    fn locate(&self, ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        let p = ray.at(crossing.t);
        (p - self.height(p) * self.normal, rounding(self.scale(p)))
    }

    fn at(&self, ray: &Ray, crossing: &Crossing) -> Place {
        let (point, error) = self.locate(ray, crossing);
        Place { point, error, normal: self.normal, face: None }
    }

    fn half_space(&self) -> Option<(Vec3, f64)> {
        Some((self.normal, self.distance))
    }

    fn kind(&self) -> &'static str {
        "plane"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_hit_from_both_sides_and_far_away() {
        let p = Plane::new(Vec3::new(0.0, 2.0, 0.0), 0.5).unwrap();
        let ray = Ray::new(Vec3::new(0.0, 1.0, 0.0), Vec3::new(1.0, -1e-9, 0.0).normalize());
        assert!((p.nearest(&ray, Range::FORWARD).unwrap().t - 5e8).abs() < 1.0);
        let below = Ray::new(Vec3::ZERO, Vec3::Y);
        assert_eq!(p.nearest(&below, Range::FORWARD).unwrap().t, 0.5);
        assert!(p.nearest(&Ray::new(Vec3::ZERO, Vec3::X), Range::FORWARD).is_none());
    }

    #[test]
    fn both_half_spaces_contain_the_plane() {
        let p = Plane::new(Vec3::new(1.0, 2.0, 3.0), 0.5).unwrap();
        let on = 0.5 * Vec3::new(1.0, 2.0, 3.0).normalize();
        assert!(p.contains(on) && p.inverse().unwrap().contains(on));
        assert!(!p.contains(2.0 * on) && p.inverse().unwrap().contains(2.0 * on));
    }
}
