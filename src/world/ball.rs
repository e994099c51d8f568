//! Spheres side by side, so that a ray that misses one touches nothing else of it.

use super::geometry::Found;
use super::placement::Placement;
use crate::math::{EPSILON, Range, Ray, Vec3};
use crate::shape::{Crossing, Shape, sphere_span};

/// A sphere in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ball {
    center: Vec3,
    /// NaN for what is no sphere.
    radius: f64,
    leaf: u32,
    /// Whether this is the shape itself: it stands in world space. Else it is a little too large.
    exact: bool,
}

/// What a ray has to do with a ball.
pub(super) enum Met {
    Nothing,
    /// The nearest crossing inside the range, its upper end taken in.
    Sphere(Found),
    /// Ask the shape.
    Perhaps,
}

/// Relative room for the roundings of the way into world space.
const ROOM: f64 = 64.0 * EPSILON;

impl Ball {
    pub const NONE: Ball = Ball { center: Vec3::ZERO, radius: f64::NAN, leaf: 0, exact: false };

    /// `None` unless `shape`, that of a leaf, is a sphere in the world too.
    pub fn new(shape: &dyn Shape, place: Option<&Placement>, leaf: u32) -> Option<Ball> {
        let (center, radius) = shape.sphere()?;
        let Some(place) = place else { return Some(Ball { center, radius, leaf, exact: true }) };
        let (center, radius) = (place.transform.point(center), radius / place.even_scale()?);
        let radius = radius * (1.0 + ROOM) + ROOM * center.abs().max_element();
        (center.is_finite() && radius.is_finite()).then_some(Ball { center, radius, leaf, exact: false })
    }

    #[inline]
    pub fn meet(&self, ray: &Ray, range: Range) -> Met {
        if !self.exact {
            let ruled_out = !self.radius.is_nan() && !self.may_be_met(ray, range);
            return if ruled_out { Met::Nothing } else { Met::Perhaps };
        }
        let Some((near, far)) = sphere_span(ray.origin - self.center, ray.dir, self.radius) else {
            return Met::Nothing;
        };
        let t = if near > range.min { near } else { far };
        if t > range.min && t <= range.max {
            Met::Sphere(Found { t, leaf: self.leaf, crossing: Crossing::new(t) })
        } else {
            Met::Nothing
        }
    }

    /// False only if the ray has no point inside `range` that lies in the sphere.
    #[inline]
    fn may_be_met(&self, ray: &Ray, range: Range) -> bool {
        let to = self.center - ray.origin;
        let along = to.dot(ray.dir);
        let beside = to - along * ray.dir;
        // Roundings of the difference are bounded by the two places' sizes: the center's is in the radius.
        let slack = ROOM * (along.abs() + self.radius);
        let reach = self.radius + slack;
        let chord2 = reach * reach - beside.length_squared();
        if chord2 < 0.0 {
            return false;
        }
        let half = chord2.sqrt() + slack;
        along - half < range.max && along + half > range.min
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Transform;
    use crate::shape::Sphere;
    use proptest::prelude::*;

    fn vector(size: f64) -> impl Strategy<Value = Vec3> {
        (-size..size, -size..size, -size..size).prop_map(|(x, y, z)| Vec3::new(x, y, z))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]
        /// Rays near the edge, from near and far: what the sphere itself meets is never ruled out.
        #[test]
        fn no_hit_is_ruled_out(
            center in vector(10.0), radius in -3.0..1.0f64, size in -3.0..3.0f64, turn in vector(360.0),
            shift in vector(1e3), side in vector(1.0), edge in -12.0..0.0f64, far in -2.0..6.0f64, inward: bool,
        ) {
            prop_assume!(side.length() > 0.1);
            let sphere = Sphere::new(center, 10f64.powf(radius));
            let t = Transform::scale(Vec3::splat(10f64.powf(size)))
                .then(&Transform::rotate(turn))
                .then(&Transform::translate(shift));
            let place = Placement::new(t);
            let ball = Ball::new(&sphere, Some(&place), 0).expect("a sphere");
            let (c, r) = (t.point(center), 10f64.powf(radius + size));
            let side = side.normalize();
            let along = side.any_orthonormal_vector();
            let offset = if inward { 1.0 - 10f64.powf(edge) } else { 1.0 };
            let origin = c + offset * r * side - 10f64.powf(far) * r * along;
            let ray = Ray::new(origin, along);
            let (local, length) = place.inverse_ray(&ray);
            if let Some(hit) = sphere.nearest(&local, Range::FORWARD) {
                let t = hit.t / length;
                prop_assert!(ball.may_be_met(&ray, Range::FORWARD));
                prop_assert!(ball.may_be_met(&ray, Range::new(0.0, t.next_up())));
            }
        }
    }

    #[test]
    fn misses_are_mostly_seen() {
        let nowhere = Placement::new(Transform::translate(Vec3::ZERO));
        let ball = Ball::new(&Sphere::new(Vec3::ZERO, 1.0), Some(&nowhere), 0).expect("a sphere");
        let to = |origin, dir| Ray::new(origin, dir);
        assert!(ball.may_be_met(&to(Vec3::new(-5.0, 0.9, 0.0), Vec3::X), Range::FORWARD));
        assert!(!ball.may_be_met(&to(Vec3::new(-5.0, 1.1, 0.0), Vec3::X), Range::FORWARD));
        assert!(!ball.may_be_met(&to(Vec3::new(5.0, 0.0, 0.0), Vec3::X), Range::FORWARD));
        assert!(!ball.may_be_met(&to(Vec3::new(-5.0, 0.0, 0.0), Vec3::X), Range::new(0.0, 3.9)));
        assert!(ball.may_be_met(&to(Vec3::new(-5.0, 0.0, 0.0), Vec3::X), Range::new(0.0, 4.1)));
    }

    proptest! {
        /// What stands in world space is met where the shape says.
        #[test]
        fn a_sphere_in_the_world_is_met_as_the_shape_is(
            center in vector(3.0), radius in 0.1..3.0f64, origin in vector(5.0), dir in vector(1.0), end in 0.0..9.0f64,
        ) {
            prop_assume!(dir.length() > 0.1);
            let sphere = Sphere::new(center, -radius);
            let ball = Ball::new(&sphere, None, 7).expect("a sphere");
            let ray = Ray::new(origin, dir.normalize());
            for max in [end, f64::INFINITY] {
                let expected = sphere.nearest(&ray, Range::new(0.0, max));
                match ball.meet(&ray, Range::new(0.0, max)) {
                    Met::Sphere(found) => prop_assert_eq!((Some(found.crossing), found.leaf), (expected, 7)),
                    Met::Nothing => prop_assert_eq!(expected, None),
                    Met::Perhaps => prop_assert!(false, "the shape was not asked"),
                }
            }
        }
    }
}
