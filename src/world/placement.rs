use crate::math::{EPSILON, Ray, Transform, Vec3};
use glam::{DAffine3, DMat3};

/// Where a shape stands, prepared for rays.
#[derive(Debug)]
pub(super) struct Placement {
    pub transform: Transform,
    way: Way,
}

/// How directions get into the shape's space.
#[derive(Debug)]
enum Way {
    /// Only moved: as they are.
    Moved,
    /// Turned, mirrored and evenly scaled: all get the same length, which `turn` takes out.
    Similar {
        turn: DMat3,
        length: f64,
    },
    General,
}

/// Columns whose lengths and angles differ by no more than this many roundings are those of a turn.
const SAME: f64 = 16.0 * EPSILON;

impl Placement {
    pub fn new(transform: Transform) -> Self {
        Self { transform, way: Way::of(&transform.inverse.matrix3) }
    }

    /// See [`Transform::inverse_ray`]. Inlined: a ray that is returned through memory is read back before its
    /// parts have arrived there.
    #[inline(always)]
    pub fn inverse_ray(&self, ray: &Ray) -> (Ray, f64) {
        match &self.way {
            Way::Moved => (Ray::new(ray.origin + self.transform.inverse.translation, ray.dir), 1.0),
            Way::Similar { turn, length } => {
                (Ray::new(self.transform.inverse_point(ray.origin), *turn * ray.dir), *length)
            }
            Way::General => self.transform.inverse_ray(ray),
        }
    }

    #[inline]
    pub fn inverse_point(&self, p: Vec3) -> Vec3 {
        match self.way {
            Way::Moved => p + self.transform.inverse.translation,
            _ => self.transform.inverse_point(p),
        }
    }

    /// A unit normal of the shape in the world, at unit length.
    #[inline]
    pub fn normal(&self, n: Vec3) -> Vec3 {
        match &self.way {
            Way::Moved => n,
            Way::Similar { turn, .. } => {
                Vec3::new(turn.x_axis.dot(n), turn.y_axis.dot(n), turn.z_axis.dot(n))
            }
            Way::General => self.transform.normal(n).normalize_or(n),
        }
    }

    /// A point of the shape in the world, and a bound on its distance from the true surface along the unit
    /// normal `face` there: the shape's own, `error`, the rounding of the way back to the shape's space seen
    /// through the transform, and the rounding of the world point.
    #[inline]
    pub fn point(&self, local: Vec3, error: f64, face: Vec3) -> (Vec3, f64) {
        let t = &self.transform;
        let size = |v: Vec3| v.abs().max_element();
        let even = |point: Vec3, length: f64| {
            let shift = 2.0 * t.forward.translation.abs().element_sum();
            error / length + ROUNDING * (3.0 * (size(point) + size(local) / length) + shift)
        };
        match &self.way {
            Way::Moved => {
                let point = local + t.forward.translation;
                (point, even(point, 1.0))
            }
            Way::Similar { length, .. } => {
                let point = t.point(local);
                (point, even(point, *length))
            }
            Way::General => {
                let point = t.point(local);
                let inward = t.forward.matrix3.transpose() * face;
                let back = inward.abs().dot(rounding(&t.inverse, point));
                let there = face.abs().dot(rounding(&t.forward, local));
                (point, inward.length() * error + back + there)
            }
        }
    }

    /// How many units of the shape's space one of the world is, if that is the same in all directions.
    pub fn even_scale(&self) -> Option<f64> {
        match self.way {
            Way::Moved => Some(1.0),
            Way::Similar { length, .. } => Some(length),
            Way::General => None,
        }
    }
}

/// Bound on the relative rounding of one component of an affine map.
const ROUNDING: f64 = 8.0 * EPSILON;

/// Bound on the rounding of `m * p`, per component.
fn rounding(m: &DAffine3, p: Vec3) -> Vec3 {
    let a = m.matrix3;
    let reach = a.x_axis.abs() * p.x.abs() + a.y_axis.abs() * p.y.abs() + a.z_axis.abs() * p.z.abs();
    (reach + m.translation.abs()) * ROUNDING
}

impl Way {
    fn of(m: &DMat3) -> Way {
        if *m == DMat3::IDENTITY {
            return Way::Moved;
        }
        let length = exact_length(m);
        let turn = DMat3::from_cols(m.x_axis / length, m.y_axis / length, m.z_axis / length);
        let even = [turn.x_axis, turn.y_axis, turn.z_axis].iter().all(|c| (c.length() - 1.0).abs() <= SAME);
        let square = [(turn.x_axis, turn.y_axis), (turn.y_axis, turn.z_axis), (turn.z_axis, turn.x_axis)];
        if even && square.iter().all(|(a, b)| a.dot(*b).abs() <= SAME) {
            Way::Similar { turn, length }
        } else {
            Way::General
        }
    }
}

/// The length of a column, without rounding if one lies along an axis or the length is 1: a box turned about
/// y and set on a plane has its lower face exactly in the plane, and keeps it there.
fn exact_length(m: &DMat3) -> f64 {
    let along_an_axis = |c: &Vec3| (c.x == 0.0) as u8 + (c.y == 0.0) as u8 + (c.z == 0.0) as u8 == 2;
    let columns = [m.x_axis, m.y_axis, m.z_axis];
    match columns.iter().find(|&c| along_an_axis(c)) {
        Some(c) => c.abs().max_element(),
        None if (m.x_axis.length() - 1.0).abs() <= SAME => 1.0,
        None => m.x_axis.length(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::strategy::vector;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn every_way_leads_where_the_transform_leads(
            turn in vector(360.0), size in 0.01..100.0f64, uneven in 0..3, shift in vector(10.0),
            o in vector(10.0), d in vector(1.0),
        ) {
            prop_assume!(d.length() > 0.1);
            let scale = size * if uneven == 0 { Vec3::new(1.0, 2.0, 1.0) } else { Vec3::ONE };
            let t = Transform::scale(scale).then(&Transform::rotate(turn)).then(&Transform::translate(shift));
            let place = Placement::new(t);
            prop_assert_eq!(place.even_scale().is_some(), uneven != 0);
            let ray = Ray::new(o, d.normalize());
            let ((a, la), (b, lb)) = (t.inverse_ray(&ray), place.inverse_ray(&ray));
            prop_assert!((la - lb).abs() <= 1e-14 * la);
            prop_assert!(a.dir.distance(b.dir) <= 1e-14);
            prop_assert!((b.dir.length() - 1.0).abs() <= 1e-14);
            prop_assert_eq!(a.origin, b.origin);
            let (p, n) = (place.point(o, 0.0, ray.dir).0, place.normal(ray.dir));
            prop_assert!(p.distance(t.point(o)) <= 1e-14 * (1.0 + p.length()));
            prop_assert!(n.distance(t.normal(ray.dir).normalize()) <= 1e-14);
        }
    }

    #[test]
    fn faces_that_lie_along_an_axis_stay_there() {
        for (size, angle) in [(1.0, 40.0), (0.3, -17.0), (7.0, 123.4)] {
            let t = Transform::scale(Vec3::splat(size)).then(&Transform::rotate(angle * Vec3::Y));
            let ray = Ray::new(Vec3::new(0.3, 5.0, -2.0), Vec3::new(0.2, -0.7, 0.4).normalize());
            assert_eq!(Placement::new(t).inverse_ray(&ray).0.dir.y, ray.dir.y, "{size} {angle}");
        }
    }

    #[test]
    fn what_is_only_moved_keeps_its_direction() {
        let place = Placement::new(Transform::translate(Vec3::new(1.0, 2.0, 3.0)));
        let ray = Ray::new(Vec3::ZERO, Vec3::Y);
        assert_eq!(place.inverse_ray(&ray), (Ray::new(Vec3::new(-1.0, -2.0, -3.0), Vec3::Y), 1.0));
    }
}
