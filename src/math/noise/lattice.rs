//! The lattice sum: at each corner of a unit cell an offset and a gradient chosen by a hash, faded together.

use super::coefficients::COEFFICIENTS;
use super::{fade, split};
use crate::math::Vec3;
use crate::math::random::Lcg;

/// A shuffle of 0..4096.
static HASH: [u16; 4096] = shuffled();

/// The low bytes of [`HASH`].
static LOW_HASH: [u8; 4096] = low_bytes();

const fn shuffled() -> [u16; 4096] {
    let mut table = [0; 4096];
    let mut i = 0;
    while i < 4096 {
        table[i] = i as u16;
        i += 1;
    }
    let mut random = Lcg::new(0);
    while i > 0 {
        i -= 1;
        let j = (random.draw() % 4096) as usize;
        (table[i], table[j]) = (table[j], table[i]);
    }
    table
}

const fn low_bytes() -> [u8; 4096] {
    let mut low = [0; 4096];
    let mut i = 0;
    while i < 4096 {
        low[i] = HASH[i] as u8;
        i += 1;
    }
    low
}

#[inline(always)]
fn hash(i: u32) -> u32 {
    u32::from(HASH[(i & 4095) as usize])
}

/// The hash of a whole number, 0 ..= 4095.
#[inline]
pub fn hash1(a: i64) -> usize {
    hash(a as u32) as usize
}

/// The hash of a pair of whole numbers, 0 ..= 4095.
#[inline]
pub fn hash2(a: i64, b: i64) -> usize {
    hash(hash(a as u32) ^ (b as u32 & 4095)) as usize
}

/// The hash of the lattice cell (a, b, c), 0 ..= 4095.
#[inline]
pub fn hash3(a: i64, b: i64, c: i64) -> usize {
    hash(hash2(a, b) as u32 ^ (c as u32 & 4095)) as usize
}

/// A unit cell of the lattice with a point in it.
struct Cell {
    places: [u8; 8],
    /// The point relative to the lowest corner.
    f: [f64; 3],
}

/// Places of the coefficients of a cell's corners; bit 0 of the index goes with z, bit 1 with y, bit 2 with x.
#[inline(always)]
pub(super) fn places([ix, iy, iz]: [u32; 3]) -> [u8; 8] {
    const SHIFT: u32 = 10000;
    let ends = |i: u32| [i.wrapping_add(SHIFT) & 4095, i.wrapping_add(SHIFT + 1) & 4095];
    // SAFETY: an index is the exclusive or of numbers below 4096, as the table's entries are, thus below 4096.
    #[allow(unsafe_code)]
    let hash = |i: u32| u32::from(unsafe { *HASH.get_unchecked(i as usize) });
    // SAFETY: the same.
    #[allow(unsafe_code)]
    let low = |i: u32| unsafe { *LOW_HASH.get_unchecked(i as usize) };
    let (x, y, z) = (ends(ix), ends(iy), ends(iz));
    let (h0, h1) = (hash(x[0]), hash(x[1]));
    let rows = [hash(h0 ^ y[0]), hash(h0 ^ y[1]), hash(h1 ^ y[0]), hash(h1 ^ y[1])];
    let mut places = [0; 8];
    // A closure handed on would not be compiled into vector code.
    for (pair, row) in places.as_chunks_mut::<2>().0.iter_mut().zip(rows) {
        *pair = [low(row ^ z[0]), low(row ^ z[1])];
    }
    places
}

impl Cell {
    #[inline(always)]
    fn at(p: Vec3) -> Self {
        let ((ix, fx), (iy, fy), (iz, fz)) = (split(p.x), split(p.y), split(p.z));
        Self { places: places([ix, iy, iz]), f: [fx, fy, fz] }
    }

    /// Sum over the corners of `N` consecutive components of the noise: lower and upper corners by z apart.
    #[inline(always)]
    fn sum<const N: usize>(&self) -> [f64; N] {
        let [fx, fy, fz] = self.f;
        let (sx, sy, sz) = (fade(fx), fade(fy), fade(fz));
        let (x, y, z) = ([fx, fx - 1.0], [fy, fy - 1.0], [fz, fz - 1.0]);
        let (wx, wy, wz) = ([1.0 - sx, sx], [1.0 - sy, sy], [1.0 - sz, sz]);
        let mut sums = [[[0.0; 4]; 2]; N];
        for c in 0..8 {
            let (i, j, k) = (c >> 2, (c >> 1) & 1, c & 1);
            let w = wx[i] * wy[j] * wz[k];
            let factors = [w * 0.5, w * x[i], w * y[j], w * z[k]];
            let place = usize::from(self.places[c]);
            for (o, sum) in sums.iter_mut().enumerate() {
                for (t, s) in sum[k].iter_mut().enumerate() {
                    *s += factors[t] * COEFFICIENTS[place + 4 * o + t];
                }
            }
        }
        sums.map(|[low, high]| {
            let s: [f64; 4] = std::array::from_fn(|t| low[t] + high[t]);
            (s[0] + s[2]) + (s[1] + s[3])
        })
    }
}

/// The first component alone, about -1 ..= 1.
#[inline(always)]
pub(super) fn sum(p: Vec3) -> f64 {
    Cell::at(p).sum::<1>()[0]
}

/// Three components of noise at once, each about -1 ..= 1.
#[inline(always)]
pub(super) fn vector_noise(p: Vec3) -> Vec3 {
    Vec3::from_array(Cell::at(p).sum::<3>())
}

/// The linear forms at the corners of the cell around a point: offset and gradient. Bit 0 of the index goes
/// with z, bit 1 with y, bit 2 with x.
pub(super) fn forms(p: Vec3) -> [[f64; 4]; 8] {
    Cell::at(p).places.map(|place| {
        let [offset, x, y, z] = std::array::from_fn(|i| COEFFICIENTS[usize::from(place) + i]);
        [0.5 * offset, x, y, z]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hash_starts_as_measured() {
        assert_eq!(HASH[..5], [2291, 2574, 3654, 1557, 1196]);
        let mut sorted = HASH;
        sorted.sort_unstable();
        assert!(sorted.iter().enumerate().all(|(i, &h)| i == usize::from(h)));
    }

    #[test]
    fn cells_repeat_every_4096() {
        assert_eq!(hash3(-1, 7, 4096), hash3(4095, 7 - 4096, 0));
    }
}
