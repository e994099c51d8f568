use super::placement::Placement;
use crate::math::{EPSILON, Range, Ray, Vec3};
use crate::shape::Shape;

/// A sphere in world space, a little too large: tells which rays need not be followed into the sphere's own
/// space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ball {
    center: Vec3,
    /// NaN for what is no sphere.
    radius: f64,
}

/// Relative room for the roundings of the way into world space.
const ROOM: f64 = 64.0 * EPSILON;

impl Ball {
    pub const NONE: Ball = Ball { center: Vec3::ZERO, radius: f64::NAN };

    /// `None` unless `shape` is a sphere in the world too.
    pub fn new(shape: &dyn Shape, place: Option<&Placement>) -> Option<Ball> {
        let (center, radius) = shape.sphere()?;
        let (center, radius) = match place {
            None => (center, radius),
            Some(place) => (place.transform.point(center), radius / place.even_scale()?),
        };
        let radius = radius * (1.0 + ROOM) + ROOM * center.abs().max_element();
        (center.is_finite() && radius.is_finite()).then_some(Ball { center, radius })
    }

    pub fn is_some(&self) -> bool {
        !self.radius.is_nan()
    }

    /// False only if the ray has no point inside `range` that lies in the sphere.
    #[inline]
    pub fn may_be_met(&self, ray: &Ray, range: Range) -> bool {
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
            let ball = Ball::new(&sphere, Some(&place)).expect("a sphere");
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
        let ball = Ball::new(&Sphere::new(Vec3::ZERO, 1.0), None).expect("a sphere");
        let to = |origin, dir| Ray::new(origin, dir);
        assert!(ball.may_be_met(&to(Vec3::new(-5.0, 0.9, 0.0), Vec3::X), Range::FORWARD));
        assert!(!ball.may_be_met(&to(Vec3::new(-5.0, 1.1, 0.0), Vec3::X), Range::FORWARD));
        assert!(!ball.may_be_met(&to(Vec3::new(5.0, 0.0, 0.0), Vec3::X), Range::FORWARD));
        assert!(!ball.may_be_met(&to(Vec3::new(-5.0, 0.0, 0.0), Vec3::X), Range::new(0.0, 3.9)));
        assert!(ball.may_be_met(&to(Vec3::new(-5.0, 0.0, 0.0), Vec3::X), Range::new(0.0, 4.1)));
    }
}
