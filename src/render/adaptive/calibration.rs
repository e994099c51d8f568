//! Expected errors held against measured ones.
//!
//! Whenever a pixel's samples are doubled, the difference between the old and the new half tells what the
//! old mean's error was. Pixels are sorted into classes by how many samples they had and by the error that
//! was expected of them; what a class's members showed on average corrects what is expected of its other
//! members. A few pixels of every class are doubled only for this, picked by chance, so that a class in
//! which nothing seems to be wrong is held to account as well.

use super::convergence::{Convergence, LEVELS};

/// Classes of expected errors: factors of 4 from 1 down.
pub const BINS: usize = 14;
/// No less than this is expected of any pixel, so that what turns up can be set against it.
pub const FLOOR: f32 = 1.0 / (1u32 << 28) as f32;
/// An expectation stands for so many measurements.
const TRUST: f64 = 6.0;
/// And in flat surroundings the measurements at half as many samples for up to so many.
const FLAT_TRUST: f64 = 2000.0;
/// A level's measured convergence replaces the preset one gradually: at so many measurements by half.
const CONVERGENCE_TRUST: f64 = 50.0;

/// What the doubling of one pixel has shown.
#[derive(Clone, Copy, Debug)]
pub struct Measured {
    pub level: usize,
    /// Squared error that was expected of the old half,
    pub expected: f32,
    /// and that which it had, by the squared difference between old and new half.
    pub error: f32,
    pub jump: f32,
    /// Squared difference between the new half's own halves; of a new half of one sample, 0.
    pub half_jump: f32,
}

/// Sums over the measured members of one class.
#[derive(Clone, Copy, Debug, Default)]
pub struct Class {
    count: f64,
    expected: f64,
    measured: f64,
    squares: f64,
}

impl Class {
    fn add(&mut self, expected: f32, measured: f32) {
        let measured = f64::from(measured);
        self.count += 1.0;
        self.expected += f64::from(expected.max(FLOOR));
        self.measured += measured;
        self.squares += measured * measured;
    }

    /// What expectations are to be multiplied by, if `before` was to be assumed as surely as `trust`
    /// measurements would make it.
    fn factor(&self, before: f64, trust: f64) -> f64 {
        let typical = if self.count > 0.0 { self.expected / self.count } else { 1.0 };
        (self.measured + trust * typical * before) / (self.expected + trust * typical)
    }

    /// Measured members.
    pub fn count(&self) -> f64 {
        self.count
    }

    /// Standard deviation of their squared errors.
    pub fn deviation(&self) -> f64 {
        let n = self.count.max(1.0);
        (self.squares / n - (self.measured / n).powi(2)).max(0.0).sqrt()
    }
}

#[derive(Clone, Debug, Default)]
pub struct Calibration {
    classes: [[Class; BINS]; LEVELS],
    /// Per level: measurements, and sums of jumps and of half jumps.
    jumps: [(f64, f64, f64); LEVELS],
}

/// The class of an expected squared error.
#[inline]
pub fn bin(expected: f32) -> usize {
    // The exponent of a single-precision number: 126 stands for 1/2 to 1.
    let exponent = expected.max(FLOOR).to_bits() >> 23;
    (126u32.saturating_sub(exponent) as usize / 2).min(BINS - 1)
}

impl Calibration {
    pub fn record(&mut self, m: &Measured) {
        let level = m.level.min(LEVELS - 1);
        self.classes[level][bin(m.expected)].add(m.expected, m.error);
        let jumps = &mut self.jumps[level];
        *jumps = (jumps.0 + 1.0, jumps.1 + f64::from(m.jump), jumps.2 + f64::from(m.half_jump));
    }

    /// Pixels of one sample whose neighbours are all alike tell how often there is something small that the
    /// neighbours do not know of, and what error it makes. What one pixel shows counts for others in flat
    /// surroundings, in which nothing has turned up.
    pub fn record_surprise(&mut self, error: f32) {
        self.classes[0][BINS - 1].add(FLOOR, error);
    }

    pub fn class(&self, level: usize, bin: usize) -> &Class {
        &self.classes[level][bin]
    }

    /// The convergence as it was measured, where it was.
    pub fn convergence(&self) -> Convergence {
        let mut noise = [0f32; LEVELS];
        for (level, noise) in noise.iter_mut().enumerate().skip(2) {
            let (count, jump, half) = self.jumps[level];
            if half > 0.0 {
                let weight = count / (count + CONVERGENCE_TRUST);
                *noise = (weight * Convergence::noise(level, jump / half)) as f32;
            }
        }
        // New samples of the first level have no equal halves.
        (noise[0], noise[1]) = (noise[2].max(0.0), noise[2].max(0.0));
        Convergence::of(&noise)
    }

    /// What expectations of each class are to be multiplied by.
    pub fn factors(&self) -> Factors {
        let mut factors = [[1.0f32; BINS]; LEVELS];
        let mut flat = (1.0f64, 0.0f64);
        for (row, classes) in factors.iter_mut().zip(&self.classes) {
            // A class without measurements goes by the next one of larger errors; half as far if these were less than
            // expected, which need not go on.
            let mut above: f64 = 1.0;
            for (factor, class) in row.iter_mut().zip(classes) {
                above = class.factor(if above < 1.0 { above.sqrt() } else { above }, TRUST);
                *factor = above as f32;
            }
            // In flat surroundings, by those with half as many samples: what is rare shows in many only.
            let class = &classes[BINS - 1];
            if flat.1 > 0.0 {
                row[BINS - 1] = class.factor(0.5 * flat.0, flat.1.min(FLAT_TRUST)) as f32;
            }
            flat = (f64::from(row[BINS - 1]), flat.1 + class.count);
        }
        Factors(factors)
    }
}

/// See [`Calibration::factors`].
#[derive(Clone, Debug)]
pub struct Factors([[f32; BINS]; LEVELS]);

impl Factors {
    #[inline]
    pub fn corrected(&self, level: usize, expected: f32) -> f32 {
        expected.max(FLOOR) * self.0[level][bin(expected)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn measured(expected: f32, jump: f32, half_jump: f32) -> Measured {
        Measured { level: 2, expected, error: jump / 2.0, jump, half_jump }
    }

    #[test]
    fn bins_are_factors_of_four() {
        assert_eq!([3.0, 0.9, 0.3, 0.24, 0.06, 0.0].map(bin), [0, 0, 0, 1, 2, BINS - 1]);
    }

    #[test]
    fn what_members_showed_corrects_the_others() {
        let mut calibration = Calibration::default();
        assert_eq!(calibration.factors().corrected(2, 0.01), 0.01);
        for _ in 0..10_000 {
            calibration.record(&measured(0.01, 0.06, 0.0));
        }
        let factors = calibration.factors();
        assert!((factors.corrected(2, 0.01) / 0.03 - 1.0).abs() < 0.01);
        // Another level knows nothing of it; smaller errors of the same level go by it.
        assert_eq!(factors.corrected(3, 0.01), 0.01);
        assert!((factors.corrected(2, 1e-5) / 3e-5 - 1.0).abs() < 0.01);
    }

    #[test]
    fn convergence_is_measured_where_it_can_be() {
        let mut calibration = Calibration::default();
        let preset = Convergence::default();
        assert_eq!(calibration.convergence().ratio, preset.ratio);
        for _ in 0..100_000 {
            calibration.record(&measured(0.01, 0.0427, 0.1));
        }
        let ratio = calibration.convergence().ratio;
        // As noise does. The first level, of which nothing else is known, goes by it, the next one does not.
        assert!((ratio[2] - 0.592).abs() < 0.001 && (ratio[0] - 0.47).abs() < 0.001, "{ratio:?}");
        assert_eq!(ratio[3], preset.ratio[3]);
    }

    /// One in a thousand flat places is not flat: the others are expected to be off accordingly.
    #[test]
    fn flat_places_are_held_to_account() {
        let mut calibration = Calibration::default();
        for i in 0..10_000 {
            calibration.record_surprise(if i % 1000 == 0 { 0.4 } else { 0.0 });
        }
        let expected = calibration.factors().corrected(0, 0.0);
        assert!((expected / 0.0004 - 1.0).abs() < 0.01, "{expected}");
    }
}
