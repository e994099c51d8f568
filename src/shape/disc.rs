//! Disc: a flat ring. For CSG it bounds the half space behind it, like an infinite plane.
//!
//! | parameter | unit | default | meaning |
//! |---|---|---|---|
//! | center | length | | |
//! | normal | – | | made unit length |
//! | radius | length | | the rim itself is not hit |
//! | hole | length | 0 | points nearer to the center are not hit |

use super::plane::meet;
use super::{COINCIDENT, Crossing, Shape, rounding};
use crate::math::{Aabb, Range, Ray, Vec3};

#[derive(Clone, Debug, PartialEq)]
pub struct Disc {
    center: Vec3,
    normal: Vec3,
    radius: f64,
    hole: f64,
}

impl Disc {
    /// `None` if `normal` has no direction.
    pub fn new(center: Vec3, normal: Vec3, radius: f64, hole: f64) -> Option<Self> {
        Some(Self { center, normal: normal.try_normalize()?, radius: radius.abs(), hole: hole.abs() })
    }
}

impl Shape for Disc {
    fn bounds(&self) -> Aabb {
        let reach = self.radius * (Vec3::ONE - self.normal * self.normal).max(Vec3::ZERO).map(f64::sqrt);
        let reach = reach + rounding(self.center.abs().max_element() + self.radius);
        Aabb { min: self.center - reach, max: self.center + reach }
    }

    fn inside_bounds(&self) -> Aabb {
        Aabb::INFINITE
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        out.extend(self.nearest(ray, range));
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let t = meet(ray, self.normal, self.center)?;
        let rho2 = ray.at(t).distance_squared(self.center);
        let hit = range.contains(t) && rho2 >= self.hole * self.hole && rho2 < self.radius * self.radius;
        hit.then(|| Crossing::new(t))
    }

    fn contains(&self, p: Vec3) -> bool {
        let q = p - self.center;
        let scale = self.normal.abs().dot(p.abs() + self.center.abs());
        self.normal.dot(q) < -COINCIDENT * scale
    }

    fn normal(&self, _p: Vec3, _crossing: &Crossing) -> Vec3 {
        self.normal
    }

    fn locate(&self, ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        let p = ray.at(crossing.t);
        let p = p - self.normal.dot(p - self.center) * self.normal;
        (p, rounding(self.center.abs().max_element() + self.radius))
    }

    fn kind(&self) -> &'static str {
        "disc"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hole_is_closed_and_the_rim_open() {
        let d = Disc::new(Vec3::ZERO, Vec3::Z, 1.0, 0.5).unwrap();
        let hit = |x: f64| d.nearest(&Ray::new(Vec3::new(x, 0.0, -3.0), Vec3::Z), Range::FORWARD).is_some();
        assert!(!hit(1.0) && hit(0.5) && !hit(0.4999) && hit(0.75));
    }

    #[test]
    fn behind_it_is_inside() {
        let d = Disc::new(Vec3::new(0.0, 0.5, 0.0), Vec3::Y, 0.25, 0.0).unwrap();
        assert!(d.contains(Vec3::new(9.0, 0.4, 7.0)));
        assert!(!d.contains(Vec3::new(0.0, 0.5, 0.0)));
    }
}
