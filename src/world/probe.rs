use crate::math::{Aabb, Range, Ray, Vec3};
use glam::Vec3A;
#[cfg(target_arch = "x86_64")]
use std::arch::x86_64::*;

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

/// How many boxes are tested at once.
pub(super) const AT_ONCE: usize = 8;

/// Up to eight boxes side by side.
#[derive(Clone, Debug)]
#[repr(C, align(32))]
pub(super) struct Octet {
    min: [[f32; AT_ONCE]; 3],
    max: [[f32; AT_ONCE]; 3],
    /// A bit for each place that is used.
    used: u32,
}

impl Octet {
    /// The boxes in order, eight by eight.
    pub fn list(boxes: impl Iterator<Item = Reach>) -> Vec<Octet> {
        let mut list: Vec<Octet> = Vec::new();
        for (i, b) in boxes.enumerate() {
            if i % AT_ONCE == 0 {
                list.push(Octet { min: [[0.0; AT_ONCE]; 3], max: [[0.0; AT_ONCE]; 3], used: 0 });
            }
            if let Some(octet) = list.last_mut() {
                octet.used |= 1 << (i % AT_ONCE);
                for axis in 0..3 {
                    (octet.min[axis][i % AT_ONCE], octet.max[axis][i % AT_ONCE]) = (b.min[axis], b.max[axis]);
                }
            }
        }
        list
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
    /// At least the largest of the origin's coordinates.
    size: f64,
}

/// Bound on the relative rounding of a distance in single precision.
const SLACK: f32 = 8.0 * f32::EPSILON;

impl<'r> Probe<'r> {
    #[inline]
    pub fn new(ray: &'r Ray) -> Self {
        let (origin, dir) = (ray.origin.as_vec3a(), ray.dir.as_vec3a());
        let pad = origin.abs() * (2.0 * f32::EPSILON) + f32::MIN_POSITIVE;
        let size = f64::from((origin.abs() + pad).max_element());
        Self { ray, origin, inverse: dir.recip(), pad, size }
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

    /// The largest of the origin's coordinates, or a little more.
    #[inline]
    pub fn size(&self) -> f64 {
        self.size
    }

    /// A step that rounding does not swallow.
    fn far(&self) -> f64 {
        1.0 + self.size
    }

    /// Whether the ray may meet a box; true when in doubt.
    #[inline]
    pub fn meets(&self, b: &Reach, range: Range) -> bool {
        let (near, far) = self.ends(b, range);
        near <= far
    }

    /// [`Probe::meets`] for eight boxes: a bit for each, and bounds on how near those are that it may meet.
    #[inline]
    pub fn meets_each(&self, octet: &Octet, range: Range) -> (u32, [f32; AT_ONCE]) {
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has just been seen to have what `each_wide` is compiled for.
            #[allow(unsafe_code)]
            return unsafe { self.each_wide(octet, range) };
        }
        self.each(octet, range)
    }

    /// [`Probe::each`] for eight singles at once: the same operations, so the same bits.
    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    fn each_wide(&self, octet: &Octet, range: Range) -> (u32, [f32; AT_ONCE]) {
        let all = |v: f32| _mm256_set1_ps(v);
        let (mut near, mut far) = (all(range.min as f32), all(range.max as f32));
        for axis in 0..3 {
            let (start, end) = (self.origin[axis] + self.pad[axis], self.origin[axis] - self.pad[axis]);
            let inverse = all(self.inverse[axis]);
            let u = _mm256_mul_ps(_mm256_sub_ps(eight(&octet.min[axis]), all(start)), inverse);
            let v = _mm256_mul_ps(_mm256_sub_ps(eight(&octet.max[axis]), all(end)), inverse);
            near = _mm256_max_ps(_mm256_min_ps(u, v), near);
            far = _mm256_min_ps(_mm256_max_ps(u, v), far);
        }
        let size = |v: __m256| _mm256_andnot_ps(all(-0.0), v);
        near = _mm256_sub_ps(near, _mm256_mul_ps(size(near), all(SLACK)));
        far = _mm256_add_ps(far, _mm256_mul_ps(size(far), all(SLACK)));
        let mask = _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(near, far)) as u32;
        let mut distances = [0.0; AT_ONCE];
        // SAFETY: eight singles are written to a list of eight; stores need no alignment.
        #[allow(unsafe_code)]
        unsafe {
            _mm256_storeu_ps(distances.as_mut_ptr(), near);
        }
        (mask & octet.used, distances)
    }

    fn each(&self, octet: &Octet, range: Range) -> (u32, [f32; AT_ONCE]) {
        let (mut near, mut far) = ([range.min as f32; AT_ONCE], [range.max as f32; AT_ONCE]);
        for axis in 0..3 {
            let (start, end) = (self.origin[axis] + self.pad[axis], self.origin[axis] - self.pad[axis]);
            let inverse = self.inverse[axis];
            for i in 0..AT_ONCE {
                let (u, v) = ((octet.min[axis][i] - start) * inverse, (octet.max[axis][i] - end) * inverse);
                near[i] = greater(lesser(u, v), near[i]);
                far[i] = lesser(greater(u, v), far[i]);
            }
        }
        let mut mask = 0;
        for i in 0..AT_ONCE {
            near[i] -= near[i].abs() * SLACK;
            far[i] += far[i].abs() * SLACK;
            mask |= u32::from(near[i] <= far[i]) << i;
        }
        (mask & octet.used, near)
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
        let near = greater(u.min(v).max_element(), range.min as f32);
        let far = lesser(u.max(v).min_element(), range.max as f32);
        (near - near.abs() * SLACK, far + far.abs() * SLACK)
    }
}

#[inline]
fn lesser(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

#[inline]
fn greater(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
#[inline]
fn eight(v: &[f32; AT_ONCE]) -> __m256 {
    _mm256_setr_ps(v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::strategy::vector;
    use proptest::prelude::*;

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
            let eight = Octet::list([reach, reach].into_iter());
            for range in [Range::FORWARD, Range::new(0.0, distance + slack)] {
                prop_assert!(Probe::new(&ray).meets(&reach, range));
                let (mask, near) = Probe::new(&ray).meets_each(&eight[0], range);
                prop_assert_eq!(mask, 3);
                prop_assert!(f64::from(near[1]) <= distance + slack);
            }
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

    proptest! {
        /// Eight at once are met as one by one, but for those that a rounding more or less decides.
        #[test]
        fn eight_boxes_are_met_as_each_is(o in vector(2.0), d in vector(1.0), seed in 0..1000u32) {
            prop_assume!(d.length() > 0.1);
            let at = |i: u32, k: u32| f64::from((seed * 31 + i * 17 + k * 7) % 29) / 10.0 - 1.4;
            let boxes: Vec<Aabb> =
                (0..11).map(|i| Aabb::new(Vec3::new(at(i, 1), at(i, 2), at(i, 3)), Vec3::splat(at(i, 4)))).collect();
            let grown = |b: &Aabb| Reach::new(&Aabb { min: b.min - 1e-4, max: b.max + 1e-4 });
            let ray = Ray::new(o, d.normalize());
            let probe = Probe::new(&ray);
            let octets = Octet::list(boxes.iter().map(Reach::new));
            prop_assert_eq!(octets.len(), 2);
            for (i, b) in boxes.iter().enumerate() {
                let (mask, near) = probe.meets_each(&octets[i / AT_ONCE], Range::FORWARD);
                let (same, as_near) = probe.each(&octets[i / AT_ONCE], Range::FORWARD);
                prop_assert_eq!((mask, near.map(f32::to_bits)), (same, as_near.map(f32::to_bits)));
                let met = mask >> (i % AT_ONCE) & 1 == 1;
                prop_assert!(met || !probe.meets(&Reach::new(b), Range::FORWARD));
                prop_assert!(!met || probe.meets(&grown(b), Range::FORWARD));
            }
            prop_assert_eq!(probe.meets_each(&octets[1], Range::FORWARD).0 >> 3, 0);
        }
    }
}
