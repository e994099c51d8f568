//! [`cell`](super::cell) with vectors of four doubles: the same operations in the same order, so the same bits.
//!
//! Rays side by side ask about the same cells, and coarse octaves do so for a long way. Every thread keeps the forms of
//! the cells met last, so that mostly nothing but the cell itself is looked up. Four octaves' places are worked out at
//! once.

use super::coefficients::COEFFICIENTS;
use super::{LARGEST, NoiseGenerator, ROUND, gradient, lattice};
use crate::math::Vec3;
use std::arch::x86_64::*;
use std::cell::RefCell;

/// Whether the processor has what this file is compiled for.
#[inline]
pub(super) fn is_available() -> bool {
    std::arch::is_x86_feature_detected!("avx2")
}

/// The forms at the corners of a cell: offsets, and gradients by x, by y and by z. Of each, first those of the four
/// corners that are lower by x, then the upper ones; four stand in the order of their numbers.
#[derive(Clone, Copy)]
#[repr(align(64))]
struct Corners([[[f64; 4]; 2]; 4]);

/// The cells that a thread keeps, with `N` components of noise. Where one stands hangs on its key; 0 is none's. `PLACES`
/// is a power of two.
pub(super) struct Cells<const N: usize, const PLACES: usize> {
    keys: [u64; PLACES],
    corners: [[Corners; N]; PLACES],
}

pub(super) type ScalarCells = Cells<1, 128>;
pub(super) type PlanarCells = Cells<2, 64>;
pub(super) type VectorCells = Cells<3, 64>;

thread_local! {
    pub(super) static SCALAR: RefCell<ScalarCells> = const { RefCell::new(Cells::NONE) };
    pub(super) static PLANAR: RefCell<PlanarCells> = const { RefCell::new(Cells::NONE) };
    pub(super) static VECTOR: RefCell<VectorCells> = const { RefCell::new(Cells::NONE) };
}

/// Bits of a coordinate in a key: lattices repeat after 4096 cells or sooner.
const BITS: u32 = 12;
const MASK: u32 = (1 << BITS) - 1;
/// In every key.
const KNOWN: u64 = 1 << 63;
/// In keys of gradient noise.
const GRADIENT: u64 = 1 << 62;

const fn tag(gradient: bool) -> u64 {
    if gradient { KNOWN | GRADIENT } else { KNOWN }
}

impl<const N: usize, const PLACES: usize> Cells<N, PLACES> {
    const NONE: Self = Self { keys: [0; PLACES], corners: [[Corners([[[0.0; 4]; 2]; 4]); N]; PLACES] };

    /// The corners of the cell with a key.
    #[target_feature(enable = "avx2")]
    #[inline]
    fn at(&mut self, key: u64) -> &[Corners; N] {
        let hash = key.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> (64 - PLACES.trailing_zeros());
        let place = hash as usize % PLACES;
        let corners = &mut self.corners[place];
        if self.keys[place] != key {
            self.keys[place] = key;
            fill(corners, key);
        }
        corners
    }
}

#[target_feature(enable = "avx2")]
#[inline(never)]
fn fill<const N: usize>(components: &mut [Corners; N], key: u64) {
    let cell = [key as u32 & MASK, (key >> BITS) as u32 & MASK, (key >> (2 * BITS)) as u32 & MASK];
    if key & GRADIENT != 0 {
        let [a, b, c, d, e, f, g, h] = gradient::corners(cell);
        stand(&mut components[0], [load(a), load(b), load(c), load(d), load(e), load(f), load(g), load(h)]);
        return;
    }
    let [a, b, c, d, e, f, g, h] = lattice::places(cell);
    for (o, corners) in components.iter_mut().enumerate() {
        let forms =
            [form(a, o), form(b, o), form(c, o), form(d, o), form(e, o), form(f, o), form(g, o), form(h, o)];
        stand(corners, forms);
    }
}

/// Twice the offset, and the gradient, of component `o` at the corner with a place.
#[target_feature(enable = "avx2")]
#[inline]
fn form(place: u8, o: usize) -> __m256d {
    let at = usize::from(place) + 4 * o;
    _mm256_setr_pd(COEFFICIENTS[at], COEFFICIENTS[at + 1], COEFFICIENTS[at + 2], COEFFICIENTS[at + 3])
}

/// Puts the forms of eight corners side by side, with half of their offsets.
#[target_feature(enable = "avx2")]
#[inline]
fn stand(corners: &mut Corners, [a, b, c, d, e, f, g, h]: [__m256d; 8]) {
    let (mut lower, mut upper) = (transposed([a, b, c, d]), transposed([e, f, g, h]));
    let half = _mm256_set1_pd(0.5);
    (lower[0], upper[0]) = (_mm256_mul_pd(lower[0], half), _mm256_mul_pd(upper[0], half));
    for (i, ends) in corners.0.iter_mut().enumerate() {
        store(&mut ends[0], lower[i]);
        store(&mut ends[1], upper[i]);
    }
}

#[target_feature(enable = "avx2")]
#[inline]
fn transposed([a, b, c, d]: [__m256d; 4]) -> [__m256d; 4] {
    // Lanes 0 and 2, and lanes 1 and 3, of two rows.
    let (even, odd) = (_mm256_unpacklo_pd(a, b), _mm256_unpackhi_pd(a, b));
    let (even_2, odd_2) = (_mm256_unpacklo_pd(c, d), _mm256_unpackhi_pd(c, d));
    [
        _mm256_permute2f128_pd::<0x20>(even, even_2),
        _mm256_permute2f128_pd::<0x20>(odd, odd_2),
        _mm256_permute2f128_pd::<0x31>(even, even_2),
        _mm256_permute2f128_pd::<0x31>(odd, odd_2),
    ]
}

#[target_feature(enable = "avx2")]
#[inline]
fn load(from: &[f64; 4]) -> __m256d {
    _mm256_setr_pd(from[0], from[1], from[2], from[3])
}

#[target_feature(enable = "avx2")]
#[inline]
fn store(to: &mut [f64; 4], v: __m256d) {
    // SAFETY: there is room for four doubles.
    #[allow(unsafe_code)]
    unsafe {
        _mm256_storeu_pd(to.as_mut_ptr(), v)
    };
}

/// The floor in the low bits of each lane, and the fraction.
#[target_feature(enable = "avx2")]
#[inline]
fn split(v: __m256d) -> (__m256i, __m256d) {
    let v = _mm256_max_pd(v, _mm256_set1_pd(-LARGEST));
    let v = _mm256_min_pd(v, _mm256_set1_pd(LARGEST));
    let round = _mm256_set1_pd(ROUND);
    let sum = _mm256_add_pd(_mm256_sub_pd(v, _mm256_set1_pd(0.5)), round);
    (_mm256_castpd_si256(sum), _mm256_sub_pd(v, _mm256_sub_pd(sum, round)))
}

#[target_feature(enable = "avx2")]
#[inline]
fn fade(f: __m256d) -> __m256d {
    let slope = _mm256_sub_pd(_mm256_set1_pd(3.0), _mm256_mul_pd(_mm256_set1_pd(2.0), f));
    _mm256_mul_pd(_mm256_mul_pd(f, f), slope)
}

/// A place in a cell. Lanes go with the corners of one end by x: bit 0 with z, bit 1 with y.
struct Place {
    /// Counted from the lower and from the upper end.
    x: [__m256d; 2],
    y: __m256d,
    z: __m256d,
    /// The weights of the upper ends, in all lanes.
    weights: [__m256d; 3],
}

impl Place {
    /// With the same number in all lanes of each coordinate.
    #[target_feature(enable = "avx2")]
    #[inline]
    fn new([x, y, z]: [__m256d; 3], weights: [__m256d; 3]) -> Self {
        Self {
            x: [x, _mm256_sub_pd(x, _mm256_set1_pd(1.0))],
            y: _mm256_sub_pd(y, _mm256_setr_pd(0.0, 0.0, 1.0, 1.0)),
            z: _mm256_sub_pd(z, _mm256_setr_pd(0.0, 1.0, 0.0, 1.0)),
            weights,
        }
    }

    /// The values of the forms, faded along x.
    #[target_feature(enable = "avx2")]
    #[inline]
    fn rows(&self, Corners([offset, x, y, z]): &Corners) -> __m256d {
        let mut ends = self.x;
        for (i, end) in ends.iter_mut().enumerate() {
            let by_x = _mm256_add_pd(load(&offset[i]), _mm256_mul_pd(load(&x[i]), *end));
            let by_y = _mm256_mul_pd(load(&y[i]), self.y);
            *end = _mm256_add_pd(by_x, _mm256_add_pd(by_y, _mm256_mul_pd(load(&z[i]), self.z)));
        }
        between(self.weights[0], ends[0], ends[1])
    }

    /// One component of noise.
    #[target_feature(enable = "avx2")]
    #[inline]
    fn blended(&self, [corners]: &[Corners; 1]) -> f64 {
        let rows = self.rows(corners);
        let columns = between(self.weights[1], rows, _mm256_permute2f128_pd::<0x31>(rows, rows));
        _mm256_cvtsd_f64(between(self.weights[2], columns, _mm256_unpackhi_pd(columns, columns)))
    }

    /// Two or three components, in lanes 0, 2 and 1.
    #[target_feature(enable = "avx2")]
    #[inline]
    fn all_blended<const N: usize>(&self, corners: &[Corners; N]) -> __m256d {
        let (a, b) = (self.rows(&corners[0]), self.rows(&corners[1]));
        let (low, high) = (_mm256_permute2f128_pd::<0x20>(a, b), _mm256_permute2f128_pd::<0x31>(a, b));
        let ab = between(self.weights[1], low, high);
        let c = if N > 2 {
            let c = self.rows(&corners[2]);
            between(self.weights[1], c, _mm256_permute2f128_pd::<0x31>(c, c))
        } else {
            ab
        };
        between(self.weights[2], _mm256_unpacklo_pd(ab, c), _mm256_unpackhi_pd(ab, c))
    }
}

#[target_feature(enable = "avx2")]
#[inline]
fn between(t: __m256d, a: __m256d, b: __m256d) -> __m256d {
    _mm256_add_pd(a, _mm256_mul_pd(t, _mm256_sub_pd(b, a)))
}

/// The key of the cell around a point, and the place there.
#[target_feature(enable = "avx2")]
#[inline]
fn locate<const GRADIENT: bool>(x: f64, y: f64, z: f64) -> (u64, Place) {
    let p = _mm256_setr_pd(0.0, x, y, z);
    let (bits, f) = split(if GRADIENT { _mm256_add_pd(p, _mm256_set1_pd(gradient::SHIFT)) } else { p });
    let bits = _mm256_and_si256(bits, _mm256_set1_epi64x(i64::from(MASK)));
    let bits = _mm256_sllv_epi64(bits, _mm256_setr_epi64x(64, 0, BITS.into(), (2 * BITS).into()));
    let pair = _mm_or_si128(_mm256_castsi256_si128(bits), _mm256_extracti128_si256::<1>(bits));
    let key = _mm_cvtsi128_si64(_mm_or_si128(pair, _mm_unpackhi_epi64(pair, pair))) as u64;
    let s = fade(f);
    macro_rules! lanes {
        ($v:ident) => {
            [
                _mm256_permute4x64_pd::<0b01_01_01_01>($v),
                _mm256_permute4x64_pd::<0b10_10_10_10>($v),
                _mm256_permute4x64_pd::<0b11_11_11_11>($v),
            ]
        };
    }
    (key | tag(GRADIENT), Place::new(lanes!(f), lanes!(s)))
}

/// Four octaves: keys (as the bits of doubles), places in the cells, and weights of the upper ends.
#[derive(Default)]
#[repr(align(32))]
struct Four {
    keys: [f64; 4],
    f: [[f64; 4]; 3],
    weights: [[f64; 4]; 3],
}

impl Four {
    /// Octaves of `p` at four scales.
    #[target_feature(enable = "avx2")]
    #[inline]
    fn look<const GRADIENT: bool>(&mut self, p: [f64; 3], scales: __m256d) {
        let mut keys = _mm256_set1_epi64x(tag(GRADIENT) as i64);
        macro_rules! axis {
            ($axis:literal, $coordinate:expr, $shift:expr) => {
                let v = _mm256_mul_pd(scales, _mm256_set1_pd($coordinate));
                let v = if GRADIENT { _mm256_add_pd(v, _mm256_set1_pd(gradient::SHIFT)) } else { v };
                let (bits, f) = split(v);
                let bits = _mm256_and_si256(bits, _mm256_set1_epi64x(i64::from(MASK)));
                keys = _mm256_or_si256(keys, _mm256_slli_epi64::<{ $shift }>(bits));
                store(&mut self.f[$axis], f);
                store(&mut self.weights[$axis], fade(f));
            };
        }
        axis!(0, p[0], 0);
        axis!(1, p[1], BITS as i32);
        axis!(2, p[2], 2 * BITS as i32);
        store(&mut self.keys, _mm256_castsi256_pd(keys));
    }

    /// The key of an octave.
    #[inline(always)]
    fn key(&self, i: usize) -> u64 {
        self.keys[i].to_bits()
    }

    #[target_feature(enable = "avx2")]
    #[inline]
    fn place(&self, i: usize) -> Place {
        let ([x, y, z], [sx, sy, sz]) = (&self.f, &self.weights);
        Place::new(
            [_mm256_set1_pd(x[i]), _mm256_set1_pd(y[i]), _mm256_set1_pd(z[i])],
            [_mm256_set1_pd(sx[i]), _mm256_set1_pd(sy[i]), _mm256_set1_pd(sz[i])],
        )
    }
}

/// The next four scales, and the one after them.
#[target_feature(enable = "avx2")]
#[inline]
fn scales(first: f64, lambda: f64) -> (__m256d, f64) {
    let second = first * lambda;
    let third = second * lambda;
    let fourth = third * lambda;
    (_mm256_setr_pd(first, second, third, fourth), fourth * lambda)
}

/// See [`noise`](super::noise).
#[target_feature(enable = "avx2")]
pub(super) fn noise(cells: &mut ScalarCells, x: f64, y: f64, z: f64, generator: NoiseGenerator) -> f64 {
    let (key, place) =
        if generator == NoiseGenerator::Perlin { locate::<true>(x, y, z) } else { locate::<false>(x, y, z) };
    generator.level(place.blended(cells.at(key)))
}

/// See [`octaves`](super::octaves).
#[target_feature(enable = "avx2")]
pub(super) fn octaves(
    cells: &mut ScalarCells,
    x: f64,
    y: f64,
    z: f64,
    [first, lambda]: [f64; 2],
    generator: NoiseGenerator,
    out: &mut [f64],
) {
    let mut four = Four::default();
    let mut scale = first;
    for out in out.chunks_mut(4) {
        let (scales, next) = scales(scale, lambda);
        if generator == NoiseGenerator::Perlin {
            four.look::<true>([x, y, z], scales);
        } else {
            four.look::<false>([x, y, z], scales);
        }
        for (i, value) in out.iter_mut().enumerate() {
            let corners = cells.at(four.key(i));
            *value = generator.level(four.place(i).blended(corners));
        }
        scale = next;
    }
}

/// See [`vector_noise`](super::vector_noise).
#[target_feature(enable = "avx2")]
pub(super) fn vector_noise(cells: &mut VectorCells, x: f64, y: f64, z: f64) -> Vec3 {
    let (key, place) = locate::<false>(x, y, z);
    vector(place.all_blended(cells.at(key)))
}

/// See [`vector_octaves`](super::vector_octaves).
#[target_feature(enable = "avx2")]
pub(super) fn vector_octaves(
    cells: &mut VectorCells,
    x: f64,
    y: f64,
    z: f64,
    [lambda, omega]: [f64; 2],
    count: usize,
    absolute: bool,
) -> Vec3 {
    let signs = if absolute { _mm256_set1_pd(-0.0) } else { _mm256_setzero_pd() };
    vector(octave_sum(cells, [x, y, z], [lambda, omega], count, signs))
}

/// See [`planar_octaves`](super::planar_octaves).
#[target_feature(enable = "avx2")]
pub(super) fn planar_octaves(
    cells: &mut PlanarCells,
    x: f64,
    y: f64,
    z: f64,
    [lambda, omega]: [f64; 2],
    count: usize,
) -> [f64; 2] {
    let sum = octave_sum(cells, [x, y, z], [lambda, omega], count, _mm256_setzero_pd());
    [_mm256_cvtsd_f64(sum), _mm_cvtsd_f64(_mm256_extractf128_pd::<1>(sum))]
}

/// A sum of octaves, as [`Place::all_blended`] has them, without the bits `signs`.
#[target_feature(enable = "avx2")]
#[inline]
fn octave_sum<const N: usize, const PLACES: usize>(
    cells: &mut Cells<N, PLACES>,
    p: [f64; 3],
    [lambda, omega]: [f64; 2],
    count: usize,
    signs: __m256d,
) -> __m256d {
    let (mut scale, mut weight) = (1.0, 1.0);
    let (mut sum, mut four) = (_mm256_setzero_pd(), Four::default());
    for done in (0..count).step_by(4) {
        let (scales, next) = scales(scale, lambda);
        four.look::<false>(p, scales);
        for i in 0..(count - done).min(4) {
            let corners = cells.at(four.key(i));
            let term = _mm256_andnot_pd(signs, four.place(i).all_blended(corners));
            sum = _mm256_add_pd(sum, _mm256_mul_pd(_mm256_set1_pd(weight), term));
            weight *= omega;
        }
        scale = next;
    }
    sum
}

/// From lanes 0, 2 and 1.
#[target_feature(enable = "avx2")]
#[inline]
fn vector(v: __m256d) -> Vec3 {
    let (low, high) = (_mm256_castpd256_pd128(v), _mm256_extractf128_pd::<1>(v));
    Vec3::new(_mm_cvtsd_f64(low), _mm_cvtsd_f64(high), _mm_cvtsd_f64(_mm_unpackhi_pd(low, low)))
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
                scalar::octaves(p, [4.0, 2.1], generator, &mut b);
                assert_eq!(a.map(f64::to_bits), b.map(f64::to_bits), "{p} {generator:?}");
            }
            assert_eq!(bits(super::super::vector_noise(p)), bits(scalar::vector_noise(p)), "{p}");
            for absolute in [false, true] {
                let a = super::super::vector_octaves(p, [1.9, 0.6], 7, absolute);
                let b = scalar::vector_octaves(p, [1.9, 0.6], 7, absolute);
                assert_eq!(bits(a), bits(b), "{p}");
            }
            let a = super::super::planar_octaves(p, [1.9, 0.6], 7);
            let b = scalar::planar_octaves(p, [1.9, 0.6], 7);
            assert_eq!(a.map(f64::to_bits), b.map(f64::to_bits), "{p}");
        }
    }
}
