//! Lattice noise and turbulence.
//!
//! Three scalar generators and one vector noise. Generators 1 and 2 and the vector noise share the lattice of
//! [`lattice`]; generator 3 is gradient noise ([`gradient`]). All are continuous; scalar values lie in 0..=1.
//!
//! Reference: K. Perlin, "An Image Synthesizer", SIGGRAPH 1985.

mod cell;
mod coefficients;
mod enclosure;
mod gradient;
mod lattice;
pub mod scalar;
mod turbulence;
#[cfg(target_arch = "x86_64")]
mod wide;

pub use enclosure::enclose;
pub use lattice::{hash1, hash2, hash3};
pub use turbulence::Turbulence;

use super::Vec3;

/// Which lattice noise a pattern uses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum NoiseGenerator {
    Original = 1,
    #[default]
    RangeCorrected = 2,
    Perlin = 3,
}

impl NoiseGenerator {
    /// The generator of a `noise_generator` number; `None` for 0 and for anything above 3.
    pub fn from_number(n: u32) -> Option<Self> {
        match n {
            1 => Some(Self::Original),
            2 => Some(Self::RangeCorrected),
            3 => Some(Self::Perlin),
            _ => None,
        }
    }
}

/// Calls the function of the name in `wide` with the cells that the thread keeps, where the processor has what it needs,
/// else that in `scalar`. The point goes there as three numbers: one that was just written to memory in parts would be
/// waited for when it is read as a whole.
macro_rules! fastest {
    ($cells:ident, $function:ident($p:ident $(, $argument:expr)*)) => {{
        #[cfg(target_arch = "x86_64")]
        if wide::is_available() {
            // SAFETY: the processor has just been seen to have what `wide` is compiled for.
            #[allow(unsafe_code)]
            return wide::$cells.with_borrow_mut(|cells| unsafe { wide::$function(cells, $p.x, $p.y, $p.z $(, $argument)*) });
        }
        scalar::$function($p $(, $argument)*)
    }};
}

/// Scalar noise at a point, 0 ..= 1.
#[inline]
pub fn noise(p: Vec3, generator: NoiseGenerator) -> f64 {
    fastest!(SCALAR, noise(p, generator))
}

/// Three components of noise at once, each about -1 ..= 1. The same for all generators.
#[inline]
pub fn vector_noise(p: Vec3) -> Vec3 {
    fastest!(VECTOR, vector_noise(p))
}

/// Scalar noise at `p` scaled by `first`, and by `lambda` more each time.
#[inline]
pub fn octaves(p: Vec3, first: f64, lambda: f64, generator: NoiseGenerator, out: &mut [f64]) {
    fastest!(SCALAR, octaves(p, [first, lambda], generator, out))
}

/// The sum of `count` octaves, at least one, of vector noise or of its absolute values: each at `p` scaled by `lambda`
/// more, with `omega` times the weight of the one before.
#[inline]
pub fn vector_octaves(p: Vec3, [lambda, omega]: [f64; 2], count: usize, absolute: bool) -> Vec3 {
    fastest!(VECTOR, vector_octaves(p, [lambda, omega], count, absolute))
}

/// The components x and y of [`vector_octaves`], without absolute values.
#[inline]
pub fn planar_octaves(p: Vec3, [lambda, omega]: [f64; 2], count: usize) -> [f64; 2] {
    fastest!(PLANAR, planar_octaves(p, [lambda, omega], count))
}

impl NoiseGenerator {
    /// The noise that a lattice's sum stands for.
    #[inline(always)]
    fn level(self, sum: f64) -> f64 {
        match self {
            Self::Original => clamp01(sum + 0.5),
            Self::RangeCorrected => clamp01((sum + 1.05242) * 0.48985582),
            Self::Perlin => clamp01(0.5 * (1.59 * sum + 0.985)),
        }
    }
}

#[inline]
fn clamp01(v: f64) -> f64 {
    v.clamp(0.0, 1.0)
}

/// The largest coordinate that is split into cell and fraction; doubles twice as large are whole numbers.
const LARGEST: f64 = 2_251_799_813_685_248.0;

/// 1.5 * 2^52: adding it rounds to a whole number, which then stands in the low bits of the double.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// Splits a coordinate into the low bits of its floor and the fraction. A whole number may count to the cell
/// below it, with a fraction of 1: all noise is continuous, and this saves a comparison.
#[inline(always)]
pub(crate) fn split(v: f64) -> (u32, f64) {
    let v = if v > -LARGEST { v } else { -LARGEST };
    let v = if v < LARGEST { v } else { LARGEST };
    let sum = (v - 0.5) + ROUND;
    (sum.to_bits() as u32, v - (sum - ROUND))
}

/// `3f^2 - 2f^3`: rises from 0 to 1 with no slope at either end.
#[inline(always)]
fn fade(f: f64) -> f64 {
    f * f * (3.0 - 2.0 * f)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(text: &str) -> impl Iterator<Item = Vec<f64>> {
        text.lines()
            .filter(|l| !l.starts_with('#'))
            .map(|l| l.split(',').map(|f| f.parse().unwrap()).collect())
    }

    #[test]
    fn scalar_noise_is_as_measured() {
        let mut count = 0;
        for row in rows(include_str!("../../../tests/data/2-noise-oracle.csv")) {
            let p = Vec3::new(row[0], row[1], row[2]);
            for n in 1..=3 {
                let got = noise(p, NoiseGenerator::from_number(n).unwrap());
                let want = row[2 + n as usize];
                assert!((got - want).abs() < 1e-12, "generator {n} at {p}: {got} not {want}");
                count += 1;
            }
        }
        assert_eq!(count, 630);
    }

    #[test]
    fn vector_noise_and_turbulence_are_as_measured() {
        let turbulence =
            Turbulence { amount: Vec3::X, octaves: 6, omega: f64::from(0.6_f32), lambda: f64::from(2.3_f32) };
        let mut count = 0;
        for row in rows(include_str!("../../../tests/data/2-vector-noise-oracle.csv")) {
            let p = Vec3::new(row[0], row[1], row[2]);
            let want = Vec3::new(row[3], row[4], row[5]);
            assert!(
                (vector_noise(p) - want).abs().max_element() < 1e-9,
                "at {p}: {} not {want}",
                vector_noise(p)
            );
            assert!((turbulence.vector(p).x - row[6]).abs() < 2e-9, "turbulence at {p}");
            count += 1;
        }
        assert_eq!(count, 50);
    }

    #[test]
    fn split_is_floor_and_fraction() {
        for v in [0.0, 0.5, -0.5, -1.0, 1e9 + 0.25, -1e9 - 0.25, 4096.5, -1e-20, 0.999999] {
            let (bits, f) = split(v);
            assert!((-1e-15..=1.0).contains(&f), "{v}: {f}");
            assert_eq!(bits, (v - f).round() as i64 as u32, "{v}");
        }
    }

    #[test]
    fn noise_is_continuous_across_cells() {
        for n in 1..=3 {
            let generator = NoiseGenerator::from_number(n).unwrap();
            for i in -5..5 {
                let p = Vec3::new(f64::from(i), 0.3, f64::from(i) * 0.7);
                let (before, after) = (p - Vec3::X * 1e-9, p + Vec3::X * 1e-9);
                assert!((noise(before, generator) - noise(after, generator)).abs() < 1e-8);
                assert!((noise(p, generator) - noise(after, generator)).abs() < 1e-8);
                assert!((vector_noise(p) - vector_noise(before)).length() < 1e-7);
            }
        }
    }

    #[test]
    fn huge_and_undefined_coordinates_stay_in_range() {
        for v in [1e17, -1e17, 1e300, f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
            for n in 1..=3 {
                let n = noise(Vec3::new(v, 0.5, -v), NoiseGenerator::from_number(n).unwrap());
                assert!((0.0..=1.0).contains(&n), "{v}: {n}");
            }
            assert!(vector_noise(Vec3::splat(v)).abs().max_element() < 3.0, "{v}");
        }
    }
}
