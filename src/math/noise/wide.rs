//! The sums of [`lattice`](super::lattice) and [`gradient`](super::gradient) with vectors of four doubles: the
//! same operations in the same order, so the same bits.
//!
//! Lanes 1, 2, 3 of a place are x, y, z. A corner's offset and gradient are four doubles side by side, which
//! meet their four factors at once.

use super::coefficients::COEFFICIENTS;
use super::{LARGEST, NoiseGenerator, ROUND, gradient, lattice};
use crate::math::Vec3;
use std::arch::x86_64::*;

/// Whether the processor has what this file is compiled for.
#[inline]
pub(super) fn is_available() -> bool {
    std::arch::is_x86_feature_detected!("avx2")
}

#[target_feature(enable = "avx2")]
#[inline]
fn place(x: f64, y: f64, z: f64) -> __m256d {
    _mm256_setr_pd(0.0, x, y, z)
}

/// The low bits of the floors, of x, y and z; and the fractions.
#[target_feature(enable = "avx2")]
#[inline]
fn split(v: __m256d) -> ([u32; 3], __m256d) {
    let v = _mm256_max_pd(v, _mm256_set1_pd(-LARGEST));
    let v = _mm256_min_pd(v, _mm256_set1_pd(LARGEST));
    let round = _mm256_set1_pd(ROUND);
    let sum = _mm256_add_pd(_mm256_sub_pd(v, _mm256_set1_pd(0.5)), round);
    let bits = _mm256_castpd_si256(sum);
    let (low, high) = (_mm256_castsi256_si128(bits), _mm256_extracti128_si256::<1>(bits));
    let x = _mm_extract_epi32::<2>(low) as u32;
    let (y, z) = (_mm_cvtsi128_si32(high) as u32, _mm_extract_epi32::<2>(high) as u32);
    ([x, y, z], _mm256_sub_pd(v, _mm256_sub_pd(sum, round)))
}

#[target_feature(enable = "avx2")]
#[inline]
fn fade(f: __m256d) -> __m256d {
    let slope = _mm256_sub_pd(_mm256_set1_pd(3.0), _mm256_mul_pd(_mm256_set1_pd(2.0), f));
    _mm256_mul_pd(_mm256_mul_pd(f, f), slope)
}

/// Offset and gradient of component `o` of the noise, at the corner with hash `place`.
#[target_feature(enable = "avx2")]
#[inline]
fn coefficients(place: u8, o: usize) -> __m256d {
    let at = usize::from(place) + 4 * o;
    _mm256_setr_pd(COEFFICIENTS[at], COEFFICIENTS[at + 1], COEFFICIENTS[at + 2], COEFFICIENTS[at + 3])
}

/// The weights of the corners: lane `2 i + j` of vector `k` is that of corner (i, j, k).
#[target_feature(enable = "avx2")]
#[inline]
fn weights(f: __m256d) -> [__m256d; 2] {
    let s = fade(f);
    let rest = _mm256_sub_pd(_mm256_set1_pd(1.0), s);
    // (1 - sx, sx) and (1 - sy, sy), as (_, x, y, z) lanes.
    let (low, high) = (_mm256_unpacklo_pd(rest, s), _mm256_unpackhi_pd(rest, s));
    let x = _mm256_permute4x64_pd::<0b01_01_00_00>(high);
    let y = _mm256_permute4x64_pd::<0b11_10_11_10>(low);
    let xy = _mm256_mul_pd(x, y);
    let z = [_mm256_permute4x64_pd::<0b11_11_11_11>(rest), _mm256_permute4x64_pd::<0b11_11_11_11>(s)];
    [_mm256_mul_pd(xy, z[0]), _mm256_mul_pd(xy, z[1])]
}

/// `N` components of lattice noise: each is the sum of a vector's lanes, see [`across`].
///
/// Whoever calls it has a `COPY` of its own, which the compiler then puts in its place.
#[target_feature(enable = "avx2")]
#[inline]
fn sums<const N: usize, const COPY: u8>(p: __m256d) -> [__m256d; N] {
    let (cell, f) = split(p);
    let places = lattice::places(cell);
    let near = _mm256_blend_pd::<1>(f, _mm256_set1_pd(0.5));
    let far = _mm256_sub_pd(near, _mm256_setr_pd(0.0, 1.0, 1.0, 1.0));
    let [w0, w1] = weights(f);
    let mut sums = [[_mm256_setzero_pd(); 2]; N];
    macro_rules! corner {
        ($c:literal, $lane:literal, $mask:literal) => {
            let w = _mm256_permute4x64_pd::<$lane>(if $c & 1 == 0 { w0 } else { w1 });
            let factors = _mm256_mul_pd(w, _mm256_blend_pd::<$mask>(near, far));
            for (o, sum) in sums.iter_mut().enumerate() {
                let term = _mm256_mul_pd(factors, coefficients(places[$c], o));
                sum[$c & 1] = _mm256_add_pd(sum[$c & 1], term);
            }
        };
    }
    corner!(0, 0b00_00_00_00, 0b0000);
    corner!(1, 0b00_00_00_00, 0b1000);
    corner!(2, 0b01_01_01_01, 0b0100);
    corner!(3, 0b01_01_01_01, 0b1100);
    corner!(4, 0b10_10_10_10, 0b0010);
    corner!(5, 0b10_10_10_10, 0b1010);
    corner!(6, 0b11_11_11_11, 0b0110);
    corner!(7, 0b11_11_11_11, 0b1110);
    // A closure would not be compiled into what calls it.
    let mut out = [_mm256_setzero_pd(); N];
    for (out, [even, odd]) in out.iter_mut().zip(sums) {
        *out = _mm256_add_pd(even, odd);
    }
    out
}

/// Lanes 0 and 2, and lanes 1 and 3; then both.
#[target_feature(enable = "avx2")]
#[inline]
fn across(v: __m256d) -> f64 {
    let pair = _mm_add_pd(_mm256_castpd256_pd128(v), _mm256_extractf128_pd::<1>(v));
    _mm_cvtsd_f64(_mm_add_sd(pair, _mm_unpackhi_pd(pair, pair)))
}

/// The same of three vectors; the fourth lane means nothing.
#[target_feature(enable = "avx2")]
#[inline]
fn each_across([a, b, c]: [__m256d; 3]) -> __m256d {
    // Lanes 0, and lanes 2, of a and b; and so on.
    let (even, odd) = (_mm256_unpacklo_pd(a, b), _mm256_unpackhi_pd(a, b));
    let (even_c, odd_c) = (_mm256_unpacklo_pd(c, c), _mm256_unpackhi_pd(c, c));
    let even = _mm256_add_pd(
        _mm256_permute2f128_pd::<0x20>(even, even_c),
        _mm256_permute2f128_pd::<0x31>(even, even_c),
    );
    let odd =
        _mm256_add_pd(_mm256_permute2f128_pd::<0x20>(odd, odd_c), _mm256_permute2f128_pd::<0x31>(odd, odd_c));
    _mm256_add_pd(even, odd)
}

#[target_feature(enable = "avx2")]
#[inline]
fn vector(v: __m256d) -> Vec3 {
    let low = _mm256_castpd256_pd128(v);
    let z = _mm_cvtsd_f64(_mm256_extractf128_pd::<1>(v));
    Vec3::new(_mm_cvtsd_f64(low), _mm_cvtsd_f64(_mm_unpackhi_pd(low, low)), z)
}

/// The sum of gradient noise: lane `j` of a vector goes with column (j & 1, j >> 1). `COPY` as above.
#[target_feature(enable = "avx2")]
#[inline]
fn gradient_sum<const COPY: u8>(p: __m256d) -> f64 {
    let (cell, f) = split(_mm256_add_pd(p, _mm256_set1_pd(gradient::SHIFT)));
    let (low, high) = gradient::corners(cell);
    let shift = |x: f64, y: f64, z: f64| _mm256_sub_pd(f, _mm256_setr_pd(0.0, x, y, z));
    let dots = |corners: [&[f64; 4]; 4], z: f64| {
        let d = [shift(0.0, 0.0, z), shift(1.0, 0.0, z), shift(0.0, 1.0, z), shift(1.0, 1.0, z)];
        dots(corners, d)
    };
    let s = fade(f);
    let (sx, sy) = (_mm256_permute4x64_pd::<0b01_01_01_01>(s), _mm256_permute4x64_pd::<0b10_10_10_10>(s));
    let (low, high) = (dots(low, 0.0), dots(high, 1.0));
    // Columns (0, 1) and (2, 3) of the lower and the upper corners, then rows.
    let rows = lerp(sx, _mm256_unpacklo_pd(low, high), _mm256_unpackhi_pd(low, high));
    let (front, back) = (_mm256_castpd256_pd128(rows), _mm256_extractf128_pd::<1>(rows));
    let sy = _mm256_castpd256_pd128(sy);
    let ends = _mm_add_pd(front, _mm_mul_pd(sy, _mm_sub_pd(back, front)));
    let (a, b) = (_mm_cvtsd_f64(ends), _mm_cvtsd_f64(_mm_unpackhi_pd(ends, ends)));
    let sz = _mm_cvtsd_f64(_mm_unpackhi_pd(_mm256_extractf128_pd::<1>(s), _mm256_extractf128_pd::<1>(s)));
    a + sz * (b - a)
}

#[target_feature(enable = "avx2")]
#[inline]
fn lerp(t: __m256d, a: __m256d, b: __m256d) -> __m256d {
    _mm256_add_pd(a, _mm256_mul_pd(t, _mm256_sub_pd(b, a)))
}

/// Four gradients by four differences; the differences' lanes are (_, x, y, z), the gradients' (x, y, z, 0).
#[target_feature(enable = "avx2")]
#[inline]
fn dots(g: [&[f64; 4]; 4], d: [__m256d; 4]) -> __m256d {
    let product = |i: usize| {
        let g = _mm256_setr_pd(g[i][0], g[i][1], g[i][2], g[i][3]);
        _mm256_mul_pd(g, _mm256_permute4x64_pd::<0b00_11_10_01>(d[i]))
    };
    let m = [product(0), product(1), product(2), product(3)];
    let (x01, y01) = (_mm256_unpacklo_pd(m[0], m[1]), _mm256_unpackhi_pd(m[0], m[1]));
    let (x23, y23) = (_mm256_unpacklo_pd(m[2], m[3]), _mm256_unpackhi_pd(m[2], m[3]));
    let x = _mm256_permute2f128_pd::<0x20>(x01, x23);
    let y = _mm256_permute2f128_pd::<0x20>(y01, y23);
    let z = _mm256_permute2f128_pd::<0x31>(x01, x23);
    _mm256_add_pd(_mm256_add_pd(x, y), z)
}

/// See [`noise`](super::noise).
#[target_feature(enable = "avx2")]
pub(super) fn noise(x: f64, y: f64, z: f64, generator: NoiseGenerator) -> f64 {
    let p = place(x, y, z);
    let sum =
        if generator == NoiseGenerator::Perlin { gradient_sum::<0>(p) } else { across(sums::<1, 0>(p)[0]) };
    generator.level(sum)
}

/// See [`octaves`](super::octaves).
#[target_feature(enable = "avx2")]
pub(super) fn octaves(
    x: f64,
    y: f64,
    z: f64,
    first: f64,
    lambda: f64,
    generator: NoiseGenerator,
    out: &mut [f64],
) {
    let p = place(x, y, z);
    if generator == NoiseGenerator::Perlin {
        gradient_octaves(p, first, lambda, out);
    } else {
        lattice_octaves(p, first, lambda, out);
    }
    for value in out {
        *value = generator.level(*value);
    }
}

/// Sums of lattice noise at `p` scaled by `first`, and by `lambda` more each time.
#[target_feature(enable = "avx2")]
fn lattice_octaves(p: __m256d, first: f64, lambda: f64, out: &mut [f64]) {
    let mut scale = first;
    for value in out {
        let [sum] = sums::<1, 1>(_mm256_mul_pd(_mm256_set1_pd(scale), p));
        *value = across(sum);
        scale *= lambda;
    }
}

/// The same of gradient noise.
#[target_feature(enable = "avx2")]
fn gradient_octaves(p: __m256d, first: f64, lambda: f64, out: &mut [f64]) {
    let mut scale = first;
    for value in out {
        *value = gradient_sum::<1>(_mm256_mul_pd(_mm256_set1_pd(scale), p));
        scale *= lambda;
    }
}

/// See [`vector_noise`](super::vector_noise).
#[target_feature(enable = "avx2")]
pub(super) fn vector_noise(x: f64, y: f64, z: f64) -> Vec3 {
    vector(each_across(sums::<3, 0>(place(x, y, z))))
}

/// See [`vector_octaves`](super::vector_octaves).
#[target_feature(enable = "avx2")]
pub(super) fn vector_octaves(
    x: f64,
    y: f64,
    z: f64,
    [lambda, omega]: [f64; 2],
    count: usize,
    absolute: bool,
) -> Vec3 {
    let (p, mut scale, mut weight) = (place(x, y, z), 1.0, 1.0);
    let signs = if absolute { _mm256_set1_pd(-0.0) } else { _mm256_setzero_pd() };
    let mut sum = _mm256_setzero_pd();
    for _ in 0..count {
        let term = each_across(sums::<3, 1>(_mm256_mul_pd(_mm256_set1_pd(scale), p)));
        let term = _mm256_andnot_pd(signs, term);
        sum = _mm256_add_pd(sum, _mm256_mul_pd(_mm256_set1_pd(weight), term));
        scale *= lambda;
        weight *= omega;
    }
    vector(sum)
}

#[cfg(test)]
mod tests {
    use super::super::scalar;
    use super::*;
    use crate::math::random::Lcg;

    /// Places near and far, whole ones and ones that are no numbers.
    fn places() -> Vec<Vec3> {
        let mut random = Lcg::new(11);
        let mut part = || f64::from(random.draw()) / 32767.0 - 0.5;
        let mut places: Vec<Vec3> =
            (0..20_000).map(|i| Vec3::new(part(), part(), part()) * [3.0, 100.0, 1e5, 1e17][i % 4]).collect();
        places.extend((-20..20).map(|i| Vec3::new(f64::from(i), 0.5 * f64::from(i), 0.0)));
        let odd = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -0.0];
        places.extend(odd.iter().map(|&v| Vec3::new(v, 0.3, -v)));
        places
    }

    #[test]
    fn all_bits_are_those_of_the_scalar_path() {
        if !is_available() {
            return;
        }
        let bits = |v: Vec3| v.to_array().map(f64::to_bits);
        for p in places() {
            for generator in [1, 2, 3].map(|n| NoiseGenerator::from_number(n).unwrap()) {
                let (a, b) = (super::super::noise(p, generator), scalar::noise(p, generator));
                assert_eq!(a.to_bits(), b.to_bits(), "{p} {generator:?}: {a} {b}");
                let (mut a, mut b) = ([0.0; 7], [0.0; 7]);
                super::super::octaves(p, 4.0, 2.1, generator, &mut a);
                scalar::octaves(p, 4.0, 2.1, generator, &mut b);
                assert_eq!(a.map(f64::to_bits), b.map(f64::to_bits), "{p} {generator:?}");
            }
            assert_eq!(bits(super::super::vector_noise(p)), bits(scalar::vector_noise(p)), "{p}");
            for absolute in [false, true] {
                let a = super::super::vector_octaves(p, [1.9, 0.6], 7, absolute);
                let b = scalar::vector_octaves(p, [1.9, 0.6], 7, absolute);
                assert_eq!(bits(a), bits(b), "{p}");
            }
        }
    }
}
