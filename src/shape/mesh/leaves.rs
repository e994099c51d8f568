//! The faces of a tree's leaf, side by side: a ray is tested with all of them at once.

use super::wide as corner;
use crate::math::bvh::Bvh;
use crate::math::{Ray, Vec3};
use crate::shape::triangle::Shear;
use smallvec::SmallVec;
use std::ops::Range;

/// The most faces of a leaf.
pub const LANES: usize = 4;

/// Numbers of a face: three corners of three coordinates.
const NUMBERS: usize = 9;

/// The corners of all faces. Those of a leaf of `n` faces that begins with face `first` are nine rows of `n`
/// singles from `9 first` on: x, y and z of the first corners, then of the second and of the third.
#[derive(Debug)]
pub struct Leaves {
    rows: Vec<f32>,
    /// Of each face its place in the leaf, and from bit [`COUNT`] on the number of the leaf's faces.
    lanes: Vec<u8>,
}

/// See [`Leaves::lanes`].
const COUNT: u32 = 4;

/// What the corners' weights are proportional to, where a ray passes the faces of a leaf.
struct Passed {
    /// A bit for each face that the ray may pass.
    mask: u32,
    shares: [[f64; LANES]; 3],
}

/// How far away a ray passes a face, and what the corners' weights are proportional to there.
pub type Passage = (f64, Vec3);

impl Leaves {
    /// `leaves` hold every face from 0 to `count` once.
    pub fn new(
        leaves: impl Iterator<Item = Range<u32>>,
        count: usize,
        corners: impl Fn(u32) -> [[f32; 3]; 3],
    ) -> Leaves {
        // Rows are read four at a time: the last one goes on for a few numbers.
        let mut rows = vec![0.0; NUMBERS * count + LANES];
        let mut lanes = vec![0; count];
        for leaf in leaves {
            let (first, n) = (NUMBERS * leaf.start as usize, leaf.len());
            assert!(n <= LANES, "a leaf of {n} faces");
            for (lane, face) in leaf.clone().enumerate() {
                lanes[face as usize] = (n << COUNT | lane) as u8;
            }
            let faces: SmallVec<[[[f32; 3]; 3]; LANES]> = leaf.map(&corners).collect();
            for (row, numbers) in rows[first..][..NUMBERS * n].chunks_exact_mut(n).enumerate() {
                numbers.iter_mut().zip(&faces).for_each(|(number, face)| *number = face.as_flattened()[row]);
            }
        }
        Leaves { rows, lanes }
    }

    /// Tells the tree where the corners are, so that searches fetch them ahead.
    pub fn tell(&self, tree: &mut Bvh) {
        tree.set_rows(&self.rows, NUMBERS);
    }

    pub fn corners(&self, face: usize) -> [[f32; 3]; 3] {
        let (lane, n) = (self.lanes[face] as usize & ((1 << COUNT) - 1), self.lanes[face] as usize >> COUNT);
        let rows = &self.rows[NUMBERS * (face - lane) + lane..];
        [0, 3, 6].map(|row| [0, 1, 2].map(|axis| rows[(row + axis) * n]))
    }

    /// Calls `visit` with every face of the leaf that the ray passes, the distance, and what the corners' weights
    /// are proportional to.
    #[inline(always)]
    pub fn each_passed(
        &self,
        leaf: Range<u32>,
        ray: &Ray,
        shear: &Shear,
        mut visit: impl FnMut(u32, Passage),
    ) {
        let n = leaf.len();
        let rows = &self.rows[NUMBERS * leaf.start as usize..][..NUMBERS * n + LANES];
        let mut passed = passed(rows, n, ray, shear);
        while passed.mask != 0 {
            let lane = passed.mask.trailing_zeros() as usize % LANES;
            passed.mask &= passed.mask - 1;
            let shares = Vec3::from_array(passed.shares.map(|s| s[lane]));
            let sum = shares.element_sum();
            let [a, b, c] = [0, 3, 6].map(|row| {
                let number = |axis: usize| rows[(row + axis) * n + lane];
                corner([number(0), number(1), number(2)]) - ray.origin
            });
            if sum != 0.0
                && sum.is_finite()
                && let Some(t) = super::plane_distance(a, b, c, ray.dir)
            {
                visit(leaf.start + lane as u32, (t, shares));
            }
        }
    }

    /// What a search for the nearest face beyond `min` does with a leaf: keeps in `best` the nearest so far, and
    /// gives back its distance. Of equally near ones that with the least of `numbers` counts, whatever is visited first.
    #[inline(always)]
    pub fn nearer(
        &self,
        ray: &Ray,
        min: f64,
        numbers: &[u32],
        best: &mut Option<(u32, Passage)>,
    ) -> impl FnMut(Range<u32>, f64) -> f64 {
        let shear = Shear::new(ray.dir);
        move |leaf, mut max| {
            self.each_passed(leaf, ray, &shear, |face, hit| {
                let comes_first = |other: &(u32, Passage)| numbers[face as usize] < numbers[other.0 as usize];
                if hit.0 > min && (hit.0 < max || hit.0 == max && best.as_ref().is_some_and(comes_first)) {
                    *best = Some((face, hit));
                    max = hit.0;
                }
            });
            max
        }
    }

    pub fn heap_bytes(&self) -> usize {
        self.rows.capacity() * size_of::<f32>() + self.lanes.capacity()
    }
}

#[inline(always)]
fn passed(rows: &[f32], n: usize, ray: &Ray, shear: &Shear) -> Passed {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("avx2") {
        // SAFETY: the processor has just been seen to have AVX2.
        #[allow(unsafe_code)]
        return unsafe { passed_wide(rows, n, ray, shear) };
    }
    passed_plain(rows, n, ray, shear)
}

/// Face by face.
fn passed_plain(rows: &[f32], n: usize, ray: &Ray, shear: &Shear) -> Passed {
    let mut passed = Passed { mask: 0, shares: [[0.0; LANES]; 3] };
    for lane in 0..n {
        let at = |corner: usize| [0, 1, 2].map(|axis| rows[(3 * corner + axis) * n + lane]);
        if let Some(shares) = shear.shares_of([&at(0), &at(1), &at(2)], ray.origin.as_ref()) {
            passed.mask |= 1 << lane;
            (0..3).for_each(|k| passed.shares[k][lane] = shares[k]);
        }
    }
    passed
}

/// All faces at once, with the arithmetic of [`Shear::shares_of`]. Lanes from `n` on hold numbers of other rows.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
#[inline]
fn passed_wide(rows: &[f32], n: usize, ray: &Ray, shear: &Shear) -> Passed {
    use std::arch::x86_64::*;
    assert!(n <= LANES && rows.len() >= (NUMBERS - 1) * n + LANES);
    let origin: &[f64; 3] = ray.origin.as_ref();
    let [x, y, z] = shear.axes;
    let (slope_x, slope_y) = (_mm256_set1_pd(shear.slope.x), _mm256_set1_pd(shear.slope.y));
    let numbers = |corner: usize, axis: usize| {
        // SAFETY: a row begins at most at 8 n, from where on there are four singles, as has just been asserted.
        #[allow(unsafe_code)]
        let singles = unsafe { _mm_loadu_ps(rows.as_ptr().add((3 * corner + axis % 3) * n)) };
        _mm256_sub_pd(_mm256_cvtps_pd(singles), _mm256_set1_pd(origin[axis]))
    };
    let project = |corner: usize| {
        let depth = numbers(corner, z);
        (
            _mm256_sub_pd(numbers(corner, x), _mm256_mul_pd(slope_x, depth)),
            _mm256_sub_pd(numbers(corner, y), _mm256_mul_pd(slope_y, depth)),
        )
    };
    let across = |a: (__m256d, __m256d), b: (__m256d, __m256d)| {
        _mm256_sub_pd(_mm256_mul_pd(a.0, b.1), _mm256_mul_pd(a.1, b.0))
    };
    let (a, b, c) = (project(0), project(1), project(2));
    let (u, v, w) = (across(c, b), across(a, c), across(b, a));
    let zero = _mm256_setzero_pd();
    let least = _mm256_min_pd(_mm256_min_pd(u, v), w);
    let greatest = _mm256_max_pd(_mm256_max_pd(u, v), w);
    let beside =
        _mm256_and_pd(_mm256_cmp_pd::<_CMP_LT_OQ>(least, zero), _mm256_cmp_pd::<_CMP_GT_OQ>(greatest, zero));
    let mask = !(_mm256_movemask_pd(beside) as u32) & ((1 << n) - 1);
    let mut shares = [[0.0; LANES]; 3];
    for (row, value) in shares.iter_mut().zip([u, v, w]) {
        // SAFETY: a row holds four doubles; stores need no alignment.
        #[allow(unsafe_code)]
        unsafe {
            _mm256_storeu_pd(row.as_mut_ptr(), value);
        }
    }
    Passed { mask, shares }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::strategy::vector;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]
        /// Side by side and one by one the same is passed, corners and edges included.
        #[test]
        #[cfg(target_arch = "x86_64")]
        fn all_at_once_is_one_by_one(
            corners in proptest::collection::vec(proptest::array::uniform3(vector(1.0)), 1..=LANES),
            origin in vector(3.0), weights in vector(1.0), through in 0..4usize, kind in 0..3,
        ) {
            if !std::arch::is_x86_feature_detected!("avx2") {
                println!("skipped: no AVX2");
                return Ok(());
            }
            let n = corners.len();
            let singles: Vec<[[f32; 3]; 3]> =
                corners.iter().map(|face| face.map(|c| c.as_vec3().to_array())).collect();
            let leaves = Leaves::new(std::iter::once(0..n as u32), n, |i| singles[i as usize]);
            let [a, b, c] = singles[through % n].map(corner);
            let target = match kind {
                0 => a,
                1 => a + weights.x.abs() * (b - a),
                _ => (a + weights.x.abs() * (b - a)) + weights.y.abs() * (c - a),
            };
            let Some(dir) = (target - origin).try_normalize() else { return Ok(()) };
            let (ray, mut from_corner) = (Ray::new(origin, dir), Ray::new(origin, dir));
            from_corner.origin = target;
            for ray in [ray, from_corner] {
                let shear = Shear::new(ray.dir);
                let plain = passed_plain(&leaves.rows, n, &ray, &shear);
                // SAFETY: the processor has just been seen to have AVX2.
                #[allow(unsafe_code)]
                let wide = unsafe { passed_wide(&leaves.rows, n, &ray, &shear) };
                for lane in 0..n {
                    let share = |p: &Passed| p.shares.map(|s| s[lane]);
                    let sum: f64 = share(&wide).iter().sum();
                    let passes = wide.mask >> lane & 1 == 1 && sum != 0.0;
                    prop_assert_eq!(passes, plain.mask >> lane & 1 == 1);
                    if passes {
                        prop_assert_eq!(share(&plain), share(&wide));
                    }
                }
            }
        }
    }
}
