//! [`Walk::passed`] with four parts of a block in one register, and [`Parts::of_cells`] with eight heights: the same
//! operations, so the same bits.

use super::blocks::{Block, CellRows, PARTS, Parts, Passed, Planes, SIDE, Walk};
use crate::math::Range;
use std::arch::x86_64::*;

/// Where the ray is in each of four slabs across an axis: from, to.
#[target_feature(enable = "avx2")]
#[inline]
fn slabs(walk: &Walk, axis: usize, planes: &Planes) -> (__m256d, __m256d) {
    let all = |v: f64| _mm256_set1_pd(v);
    let (origin, inverse, slack) = (all(walk.origin[axis]), all(walk.inverse[axis]), all(walk.slack[axis]));
    let plane = |k: __m256d| {
        _mm256_min_pd(_mm256_add_pd(all(planes.first), _mm256_mul_pd(k, all(planes.step))), all(planes.last))
    };
    let low = plane(_mm256_setr_pd(0.0, 1.0, 2.0, 3.0));
    let high = plane(_mm256_setr_pd(1.0, 2.0, 3.0, 4.0));
    let below = _mm256_mul_pd(_mm256_sub_pd(_mm256_sub_pd(low, slack), origin), inverse);
    let above = _mm256_mul_pd(_mm256_sub_pd(_mm256_add_pd(high, slack), origin), inverse);
    if walk.inverse[axis] >= 0.0 { (below, above) } else { (above, below) }
}

/// Four heights.
#[target_feature(enable = "avx2")]
#[inline]
fn heights(row: &[u16]) -> __m256d {
    let at = |k: usize| i32::from(row[k]);
    _mm256_cvtepi32_pd(_mm_setr_epi32(at(0), at(1), at(2), at(3)))
}

/// See [`Walk::passed`].
#[target_feature(enable = "avx2")]
#[inline]
pub(super) fn passed(walk: &Walk, block: &Block, range: Range, parts: &Parts) -> Passed {
    let all = |v: f64| _mm256_set1_pd(v);
    let [x, z] = walk.planes(block);
    let (x, z) = (slabs(walk, 0, &x), slabs(walk, 2, &z));
    let (from, to) = (_mm256_max_pd(z.0, all(range.min)), _mm256_min_pd(z.1, all(range.max)));
    let (origin, dir, slack) = (all(walk.origin.y), all(walk.dir.y), all(walk.slack.y));
    let mut passed = Passed { set: 0, near: [0.0; PARTS] };
    for (row, near_there) in passed.near.as_chunks_mut::<SIDE>().0.iter_mut().enumerate() {
        let lane = |v: __m256d| all(numbers(v)[row]);
        let near = _mm256_max_pd(x.0, lane(from));
        let far = _mm256_min_pd(x.1, lane(to));
        let beside = _mm256_or_pd(
            _mm256_cmp_pd::<_CMP_GT_OQ>(near, far),
            _mm256_cmp_pd::<_CMP_EQ_OQ>(near, all(f64::INFINITY)),
        );
        let (a, b) = (_mm256_mul_pd(near, dir), _mm256_mul_pd(far, dir));
        let low = _mm256_sub_pd(_mm256_add_pd(origin, _mm256_min_pd(a, b)), slack);
        let high = _mm256_add_pd(_mm256_add_pd(origin, _mm256_max_pd(a, b)), slack);
        let over = _mm256_or_pd(
            _mm256_cmp_pd::<_CMP_GT_OQ>(low, heights(&parts.greatest[SIDE * row..])),
            _mm256_cmp_pd::<_CMP_LT_OQ>(high, heights(&parts.least[SIDE * row..])),
        );
        let out = _mm256_movemask_pd(_mm256_or_pd(beside, over)) as u32;
        passed.set |= (out ^ 0xf) << (SIDE * row);
        *near_there = numbers(near);
    }
    passed.set &= walk.there(block);
    passed
}

#[target_feature(enable = "avx2")]
#[inline]
fn numbers(v: __m256d) -> [f64; SIDE] {
    let mut numbers = [0.0; SIDE];
    // SAFETY: four doubles are written to a list of four; stores need no alignment.
    #[allow(unsafe_code)]
    unsafe {
        _mm256_storeu_pd(numbers.as_mut_ptr(), v);
    }
    numbers
}

/// See [`Parts::of_cells`].
#[target_feature(enable = "avx2")]
#[inline]
pub(super) fn of_cells(rows: CellRows) -> Parts {
    let mut parts = Parts { least: [0; PARTS], greatest: [0; PARTS] };
    let pairs = rows.map(|row| {
        // SAFETY: eight heights are read from a list of eight; loads need no alignment.
        #[allow(unsafe_code)]
        let row = unsafe { _mm_loadu_si128(row.as_ptr().cast()) };
        let next = _mm_srli_si128::<2>(row);
        (_mm_min_epu16(row, next), _mm_max_epu16(row, next))
    });
    for (row, two) in pairs.windows(2).enumerate() {
        let put = |parts: &mut [u16; PARTS], v: __m128i| {
            // SAFETY: four heights are written to four places; stores need no alignment.
            #[allow(unsafe_code)]
            unsafe {
                _mm_storel_epi64(parts[SIDE * row..][..SIDE].as_mut_ptr().cast(), v);
            }
        };
        put(&mut parts.least, _mm_min_epu16(two[0].0, two[1].0));
        put(&mut parts.greatest, _mm_max_epu16(two[0].1, two[1].1));
    }
    parts
}
