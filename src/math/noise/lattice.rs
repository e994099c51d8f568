//! The lattice sum: at each corner of a unit cell an offset and a gradient chosen by a hash, faded together.

use super::cell::{Form, blended};
use super::coefficients::COEFFICIENTS;
use super::split;
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
    let ([x0, x1], [y0, y1], [z0, z1]) = (ends(ix), ends(iy), ends(iz));
    let (h0, h1) = (hash(x0), hash(x1));
    let (a, b, c, d) = (hash(h0 ^ y0), hash(h0 ^ y1), hash(h1 ^ y0), hash(h1 ^ y1));
    [low(a ^ z0), low(a ^ z1), low(b ^ z0), low(b ^ z1), low(c ^ z0), low(c ^ z1), low(d ^ z0), low(d ^ z1)]
}

/// The form of component `o` of the noise at the corner with a place.
#[inline(always)]
fn form(place: u8, o: usize) -> Form {
    let at = usize::from(place) + 4 * o;
    [0.5 * COEFFICIENTS[at], COEFFICIENTS[at + 1], COEFFICIENTS[at + 2], COEFFICIENTS[at + 3]]
}

/// Component `o` at a place in the cell whose corners have these places.
#[inline(always)]
fn component(places: &[u8; 8], f: [f64; 3], o: usize) -> f64 {
    blended(|corner| form(places[corner], o), f)
}

/// The first component alone, about -1 ..= 1.
#[inline(always)]
pub(super) fn sum(p: Vec3) -> f64 {
    let ((ix, fx), (iy, fy), (iz, fz)) = (split(p.x), split(p.y), split(p.z));
    component(&places([ix, iy, iz]), [fx, fy, fz], 0)
}

/// Three components of noise at once, each about -1 ..= 1.
#[inline(always)]
pub(super) fn vector_noise(p: Vec3) -> Vec3 {
    let ((ix, fx), (iy, fy), (iz, fz)) = (split(p.x), split(p.y), split(p.z));
    let (places, f) = (places([ix, iy, iz]), [fx, fy, fz]);
    Vec3::new(component(&places, f, 0), component(&places, f, 1), component(&places, f, 2))
}

/// The linear forms at the corners of the cell around a point: offset and gradient.
pub(super) fn forms(p: Vec3) -> [Form; 8] {
    places(p.to_array().map(|v| split(v).0)).map(|place| form(place, 0))
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
