//! Spheres side by side, so that a ray that misses one touches nothing else of it.

use super::placement::Placement;
use crate::math::{EPSILON, Range, Ray, Vec3};
use crate::shape::{Place, Shape, place_on_sphere, sphere_span};

/// A sphere in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(32))]
pub(super) struct Ball {
    center: Vec3,
    /// Negative if the ball is a little too large, so that the shape itself is to be asked; NaN for what is no
    /// sphere.
    radius: f64,
}

/// What a ray has to do with a ball.
pub(super) enum Met {
    Nothing,
    /// The nearest crossing inside the range, its upper end taken in, is at this distance.
    Sphere(f64),
    /// Ask the shape.
    Perhaps,
}

/// Relative room for the roundings of the way into world space.
const ROOM: f64 = 64.0 * EPSILON;
/// Spheres smaller than this part of their coordinates are asked in their own space.
const SMALL: f64 = 1e-5;

impl Ball {
    pub const NONE: Ball = Ball { center: Vec3::ZERO, radius: f64::NAN };

    /// `None` unless `shape` is a sphere in the world too. Of a placed sphere only distances are measured here: what is
    /// hit is found in its own space.
    pub fn new(shape: &dyn Shape, place: Option<&Placement>) -> Option<Ball> {
        let (center, radius) = shape.sphere()?;
        let Some(place) = place else { return Some(Ball { center, radius }) };
        let units = place.even_scale()?;
        let there = place.transform.forward.translation.abs() + center.abs() / units;
        let ball = Ball { center: place.transform.point(center), radius: radius / units };
        if !(ball.center.is_finite() && ball.radius.is_finite()) {
            return None;
        }
        Some(if ball.radius > SMALL * there.max_element() { ball } else { ball.loose() })
    }

    /// The same, a little too large.
    fn loose(self) -> Ball {
        let radius = self.radius * (1.0 + ROOM) + ROOM * self.center.abs().max_element();
        Ball { radius: -radius, ..self }
    }

    #[inline(always)]
    pub fn meet(&self, ray: &Ray, range: Range) -> Met {
        if self.radius.is_nan() || self.radius < 0.0 {
            return self.maybe_meet(ray, range);
        }
        let Some((near, far)) = sphere_span(ray.origin - self.center, ray.dir, self.radius) else {
            return Met::Nothing;
        };
        let t = if near > range.min { near } else { far };
        if t > range.min && t <= range.max { Met::Sphere(t) } else { Met::Nothing }
    }

    /// The crossing at distance `t`, as the shape would place it, if it stands in the world as it was made.
    #[inline]
    pub fn at(&self, ray: &Ray, t: f64) -> Place {
        place_on_sphere(self.center, self.radius, ray, t)
    }

    #[inline(never)]
    fn maybe_meet(&self, ray: &Ray, range: Range) -> Met {
        let ruled_out = !self.radius.is_nan() && !self.may_be_met(ray, range);
        if ruled_out { Met::Nothing } else { Met::Perhaps }
    }

    /// False only if the ray has no point inside `range` that lies in the sphere.
    fn may_be_met(&self, ray: &Ray, range: Range) -> bool {
        let to = self.center - ray.origin;
        let along = to.dot(ray.dir);
        let beside = to - along * ray.dir;
        // Roundings of the difference are bounded by the two places' sizes: the center's is in the radius.
        let radius = self.radius.abs();
        let slack = ROOM * (along.abs() + radius);
        let reach = radius + slack;
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
    use crate::math::strategy::vector;
    use crate::shape::{Crossing, Sphere};
    use proptest::prelude::*;

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
            let ball = loose(&sphere, &place);
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

    /// A ball that only rules out.
    fn loose(sphere: &Sphere, place: &Placement) -> Ball {
        let ball = Ball::new(sphere, Some(place)).expect("a sphere");
        if ball.radius < 0.0 { ball } else { ball.loose() }
    }

    /// Their normals would be the wrong way round.
    #[test]
    fn spheres_turned_inside_out_are_no_balls() {
        assert_eq!(Ball::new(&Sphere::new(Vec3::ONE, -1.0), None), None);
    }

    #[test]
    fn misses_are_mostly_seen() {
        let nowhere = Placement::new(Transform::translate(Vec3::ZERO));
        let ball = loose(&Sphere::new(Vec3::ZERO, 1.0), &nowhere);
        let to = |origin, dir| Ray::new(origin, dir);
        assert!(ball.may_be_met(&to(Vec3::new(-5.0, 0.9, 0.0), Vec3::X), Range::FORWARD));
        assert!(!ball.may_be_met(&to(Vec3::new(-5.0, 1.1, 0.0), Vec3::X), Range::FORWARD));
        assert!(!ball.may_be_met(&to(Vec3::new(5.0, 0.0, 0.0), Vec3::X), Range::FORWARD));
        assert!(!ball.may_be_met(&to(Vec3::new(-5.0, 0.0, 0.0), Vec3::X), Range::new(0.0, 3.9)));
        assert!(ball.may_be_met(&to(Vec3::new(-5.0, 0.0, 0.0), Vec3::X), Range::new(0.0, 4.1)));
    }

    proptest! {
        /// Distances to a placed sphere are those that are found in its own space, but for roundings.
        #[test]
        fn a_placed_sphere_is_met_where_the_shape_says(
            center in vector(3.0), radius in 0.01..3.0f64, size in -3.0..3.0f64, turn in vector(360.0),
            shift in vector(100.0), side in vector(1.0), aim in vector(1.5), far in 0.5..1e3f64,
        ) {
            prop_assume!(side.length() > 0.1);
            let sphere = Sphere::new(center, radius);
            let t = Transform::scale(Vec3::splat(10f64.powf(size)))
                .then(&Transform::rotate(turn))
                .then(&Transform::translate(shift));
            let place = Placement::new(t);
            let ball = Ball::new(&sphere, Some(&place)).expect("a sphere");
            let target = t.point(center + radius * aim);
            let dir = side.normalize();
            let ray = Ray::new(target - far * dir, dir);
            let (local, length) = place.inverse_ray(&ray);
            let expected = sphere.nearest(&local, Range::FORWARD);
            let scale = shift.length() + far + (center.length() + radius) * 10f64.powf(size);
            match (ball.meet(&ray, Range::FORWARD), expected) {
                (Met::Sphere(found), Some(crossing)) => {
                    // Grazing rays meet less exactly.
                    let steep = ((found * dir + ray.origin).distance(ball.center) / ball.radius).min(1.0);
                    let normal = (ray.at(found) - ball.center) / ball.radius;
                    let room = 1e-13 * scale / (steep * normal.dot(dir).abs()).max(1e-3);
                    prop_assert!((found - crossing.t / length).abs() <= room, "{} {}", found, crossing.t / length);
                }
                (Met::Nothing, Some(c)) => {
                    let p = local.at(c.t) - center;
                    prop_assert!((p / radius).dot(local.dir).abs() < 1e-3 || c.t / length < 1e-12 * scale);
                }
                (Met::Sphere(found), None) => {
                    let normal = (ray.at(found) - ball.center) / ball.radius;
                    prop_assert!(normal.dot(dir).abs() < 1e-3 || found < 1e-12 * scale);
                }
                (Met::Perhaps, _) => prop_assert!(radius * 10f64.powf(size) < 1e-4 * scale),
                (Met::Nothing, None) => {}
            }
        }
    }

    proptest! {
        /// What stands in world space is met where the shape says.
        #[test]
        fn a_sphere_in_the_world_is_met_as_the_shape_is(
            center in vector(3.0), radius in 0.1..3.0f64, origin in vector(5.0), dir in vector(1.0), end in 0.0..9.0f64,
        ) {
            prop_assume!(dir.length() > 0.1);
            let sphere = Sphere::new(center, radius);
            let ball = Ball::new(&sphere, None).expect("a sphere");
            let ray = Ray::new(origin, dir.normalize());
            for max in [end, f64::INFINITY] {
                let expected = sphere.nearest(&ray, Range::new(0.0, max));
                match ball.meet(&ray, Range::new(0.0, max)) {
                    Met::Sphere(found) => {
                        prop_assert_eq!(Some(Crossing::new(found)), expected);
                        let (here, there) = (ball.at(&ray, found), sphere.at(&ray, &Crossing::new(found)));
                        prop_assert_eq!((here.point, here.error), (there.point, there.error));
                        prop_assert_eq!((here.normal, here.face), (there.normal, there.face));
                    }
                    Met::Nothing => prop_assert_eq!(expected, None),
                    Met::Perhaps => prop_assert!(false, "the shape was not asked"),
                }
            }
        }
    }
}
