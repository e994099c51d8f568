use super::{NoiseGenerator, octaves, planar_octaves, vector_octaves};
use crate::math::Vec3;

/// Root of the mean square of a component of vector noise.
const NOISE_DEVIATION: f64 = 0.3;

/// The largest number of octaves.
const MOST_OCTAVES: usize = 10;

/// A sum of noise at growing frequencies (`lambda` per octave) and falling weights (`omega` per octave).
///
/// | parameter | default | meaning |
/// |---|---|---|
/// | amount | 0 | how far points are displaced along each axis |
/// | octaves | 6 | terms, 1 ..= 10 |
/// | omega | 0.5 | weight of each octave relative to the one before |
/// | lambda | 2 | frequency of each octave relative to the one before |
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turbulence {
    pub amount: Vec3,
    pub octaves: u32,
    pub omega: f64,
    pub lambda: f64,
}

impl Default for Turbulence {
    fn default() -> Self {
        Self { amount: Vec3::ZERO, octaves: 6, omega: 0.5, lambda: 2.0 }
    }
}

impl Turbulence {
    /// Displaces `p`.
    #[inline]
    pub fn displace(&self, p: Vec3) -> Vec3 {
        if self.amount == Vec3::ZERO { p } else { p + self.amount * self.vector(p) }
    }

    /// The sum of vector noise, `amount` left aside.
    #[inline]
    pub fn vector(&self, p: Vec3) -> Vec3 {
        vector_octaves(p, [self.lambda, self.omega], self.count(), false)
    }

    /// Its components x and y.
    #[inline]
    pub fn planar(&self, p: Vec3) -> [f64; 2] {
        planar_octaves(p, [self.lambda, self.omega], self.count())
    }

    /// How far points are mostly displaced: the root of the mean square.
    pub fn shift(&self) -> f64 {
        let weights = (0..self.count()).map(|k| self.omega.powi(k as i32).powi(2)).sum::<f64>();
        self.amount.length() * NOISE_DEVIATION * weights.sqrt()
    }

    /// The sum of scalar noise, `amount` left aside.
    pub fn scalar(&self, p: Vec3, generator: NoiseGenerator) -> f64 {
        let original = generator == NoiseGenerator::Original;
        let term = |n: f64| if original { n } else { 2.0 * n - 0.5 };
        let mut terms = [0.0; MOST_OCTAVES];
        let terms = &mut terms[..self.count()];
        octaves(p, 1.0, self.lambda, generator, terms);
        // Only the first octave is clamped.
        let (mut sum, mut weight) = (term(terms[0]).clamp(0.0, 1.0), 1.0);
        for &n in &terms[1..] {
            weight *= self.omega;
            sum += weight * term(n);
        }
        sum
    }

    fn count(&self) -> usize {
        (self.octaves as usize).clamp(1, MOST_OCTAVES)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_mostly_displaced_as_far_as_said() {
        let turbulence = Turbulence { amount: Vec3::new(1.0, 2.0, 0.5), ..Turbulence::default() };
        let places = (0..3000).map(|i| Vec3::new(0.37, 0.91, -0.53) * f64::from(i));
        let square: f64 = places.map(|p| (turbulence.displace(p) - p).length_squared()).sum();
        let shift = (square / 3000.0).sqrt();
        assert!((shift - turbulence.shift()).abs() < 0.2 * shift, "{shift} {}", turbulence.shift());
    }
}
