use crate::math::{Aabb, Range, Ray, Vec3};
use glam::Vec3A;

/// A box in single precision, rounded outward.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reach {
    min: Vec3A,
    max: Vec3A,
}

impl Reach {
    pub fn new(b: &Aabb) -> Self {
        let round = |v: Vec3, up: bool| {
            Vec3A::from_array(v.to_array().map(|c| {
                let near = c as f32;
                let wrong = if up { f64::from(near) < c } else { f64::from(near) > c };
                match (wrong, up) {
                    (false, _) => near,
                    (true, true) => near.next_up(),
                    (true, false) => near.next_down(),
                }
            }))
        };
        Self { min: round(b.min, false), max: round(b.max, true) }
    }
}

/// A ray that is held against many boxes.
pub(super) struct Probe<'r> {
    pub ray: &'r Ray,
    origin: Vec3A,
    /// Reciprocals of the direction's components; infinite for 0, which the pad keeps from meeting another 0.
    inverse: Vec3A,
    /// Bound on the rounding of the origin and of its distance from a box that it is near to.
    pad: Vec3A,
}

/// Bound on the relative rounding of a distance in single precision.
const SLACK: f32 = 8.0 * f32::EPSILON;

impl<'r> Probe<'r> {
    #[inline]
    pub fn new(ray: &'r Ray) -> Self {
        let (origin, dir) = (ray.origin.as_vec3a(), ray.dir.as_vec3a());
        let pad = origin.abs() * (2.0 * f32::EPSILON) + f32::MIN_POSITIVE;
        Self { ray, origin, inverse: dir.recip(), pad }
    }

    /// A point well inside `range`.
    pub fn middle(&self, range: Range) -> Vec3 {
        match (range.min.is_finite(), range.max.is_finite()) {
            (true, true) => self.ray.at(0.5 * (range.min + range.max)),
            (true, false) => self.ray.at(range.min + self.far()),
            (false, true) => self.ray.at(range.max - self.far()),
            (false, false) => self.ray.origin,
        }
    }

    /// A step that rounding does not swallow.
    fn far(&self) -> f64 {
        1.0 + self.ray.origin.abs().max_element()
    }

    /// Whether the ray may meet a box; true when in doubt.
    #[inline]
    pub fn meets(&self, b: &Reach, range: Range) -> bool {
        let (near, far) = self.ends(b, range);
        near <= far
    }

    /// The part of `range` in which the ray may be in a box.
    #[inline]
    pub fn within(&self, b: &Reach, range: Range) -> Option<Range> {
        let (near, far) = self.ends(b, range);
        let (near, far) = (f64::from(near).max(range.min), f64::from(far).min(range.max));
        (near <= far).then(|| Range::new(near, far))
    }

    #[inline]
    fn ends(&self, b: &Reach, range: Range) -> (f32, f32) {
        let u = (b.min - self.pad - self.origin) * self.inverse;
        let v = (b.max + self.pad - self.origin) * self.inverse;
        let near = u.min(v).max_element().max(range.min as f32);
        let far = u.max(v).min_element().min(range.max as f32);
        (near - near.abs() * SLACK, far + far.abs() * SLACK)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn vector(size: f64) -> impl Strategy<Value = Vec3> {
        (-size..size, -size..size, -size..size).prop_map(|(x, y, z)| Vec3::new(x, y, z))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]
        /// A ray through a point of a box meets it, from near and far, along axes too.
        #[test]
        fn no_box_is_lost(
            center in vector(1.0), half in vector(1.0), at in vector(1.0), d in vector(1.0),
            axis in 0..4usize, far in -3.0..6.0f64, size in -12.0..12.0f64, shift in vector(1e3),
        ) {
            let d = match axis { 0 => Vec3::X, 1 => -Vec3::Y, 2 => Vec3::Z, _ => d };
            prop_assume!(d.length() > 0.1);
            let scale = 10f64.powf(size);
            let (center, half) = ((center + shift) * scale, half.abs() * scale);
            let b = Aabb { min: center - half, max: center + half };
            let p = center + at * half;
            let distance = 10f64.powf(far) * scale;
            let p = if axis == 3 { p } else { Vec3::select(at.cmpgt(Vec3::ZERO), b.max, b.min) };
            let ray = Ray::new(p - distance * d.normalize(), d.normalize());
            let slack = 1e-9 * (distance + scale);
            let reach = Reach::new(&b);
            prop_assert!(Probe::new(&ray).meets(&reach, Range::FORWARD));
            prop_assert!(Probe::new(&ray).meets(&reach, Range::new(0.0, distance + slack)));
        }
    }

    #[test]
    fn misses_are_seen() {
        let reach = Reach::new(&Aabb { min: Vec3::ZERO, max: Vec3::ONE });
        let meets = |o: [f64; 3], d: [f64; 3], max: f64| {
            Probe::new(&Ray::new(o.into(), d.into())).meets(&reach, Range::new(0.0, max))
        };
        assert!(meets([0.5, 0.5, -3.0], [0.0, 0.0, 1.0], 9.0));
        assert!(!meets([0.5, 0.5, -3.0], [0.0, 0.0, 1.0], 2.9));
        assert!(!meets([0.5, 1.5, -3.0], [0.0, 0.0, 1.0], 9.0));
        assert!(!meets([0.5, 0.5, -3.0], [0.0, 0.0, -1.0], 9.0));
        let everything = Reach::new(&Aabb::INFINITE);
        assert!(Probe::new(&Ray::new(Vec3::ZERO, Vec3::X)).meets(&everything, Range::FORWARD));
    }
}
