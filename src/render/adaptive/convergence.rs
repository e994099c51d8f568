//! How fast means come near the truth: variance falls like n^-1 for noise, n^-3/2 at edges and n^-3 where
//! colours are smooth. Which of them a picture has is measured while it is made
//! ([`super::calibration::Calibration::convergence`]).
//!
//! What a pixel shows is its mean lifted towards its neighbours ([`super::lift`]); errors are those of what is shown.

/// Number of doublings that are told apart.
pub const LEVELS: usize = 24;

/// The level of a pixel with 2^level samples.
#[inline]
pub fn level(count: u32) -> usize {
    (count.max(1).ilog2() as usize).min(LEVELS - 1)
}

/// How many samples a pixel gets next: 1, 4, 8, 16 and so on. A second one beside the first in the centre would
/// take nothing away.
#[inline]
pub fn following(count: u32) -> u32 {
    match count {
        0 => 1,
        1 => 4,
        n => n * 2,
    }
}

/// The level after `level`.
pub fn next_level(level: usize) -> usize {
    if level == 0 { 2 } else { (level + 1).min(LEVELS - 1) }
}

/// Samples from a level to the next.
#[inline]
pub fn step(level: usize) -> f64 {
    if level == 0 { 3.0 } else { 2f64.powi(level as i32) }
}

/// One kind of difficulty: measured over pixels that have it.
struct Kind {
    /// Squared error of what one sample shows over the variance of a sample.
    first: f32,
    /// Of the next level's error over that of a level.
    ratio: [f32; LEVELS],
    /// Of a level's error over the squared difference to the samples that come next.
    of_jump: [f32; LEVELS],
    /// Of that difference over that of the halves of the samples that come next.
    jump: [f32; LEVELS],
}

const fn table(first: [f32; 5], rest: f32) -> [f32; LEVELS] {
    let mut all = [rest; LEVELS];
    let mut i = 0;
    while i < first.len() {
        all[i] = first[i];
        i += 1;
    }
    all
}

/// Edges of random place and direction near a pixel.
const EDGE: Kind = Kind {
    first: 0.19,
    ratio: table([0.30, 0.30, 0.38, 0.39, 0.75], 0.36),
    of_jump: table([0.58, 0.24, 0.333, 0.344, 0.347], 0.39),
    jump: table([0.0, 0.277, 0.103, 0.054, 0.31], 0.36),
};
/// Samples that have nothing to do with each other.
const NOISE: Kind = Kind {
    first: 0.38,
    ratio: table([0.47, 0.80, 0.592, 0.585, 0.5], 0.5),
    of_jump: table([0.58, 0.31, 0.419, 0.461, 0.5], 0.5),
    jump: table([0.0, 0.37, 0.427, 0.464, 0.5], 0.5),
};

/// By how much errors fall with each step.
#[derive(Clone, Debug)]
pub struct Convergence {
    first: f32,
    /// Squared error at the next level over that at a level.
    pub ratio: [f32; LEVELS],
    of_jump: [f32; LEVELS],
}

impl Default for Convergence {
    fn default() -> Self {
        Self::of(&[0.0; LEVELS])
    }
}

impl Convergence {
    /// Between edges (0) and noise (1), level by level; below 0 it is smooth.
    pub fn of(noise: &[f32; LEVELS]) -> Self {
        let between = |level: usize, a: f32, b: f32| a + noise[level] * (b - a);
        Self {
            first: between(0, EDGE.first, NOISE.first),
            ratio: std::array::from_fn(|l| between(l, EDGE.ratio[l], NOISE.ratio[l]).max(0.1)),
            of_jump: std::array::from_fn(|l| between(l, EDGE.of_jump[l], NOISE.of_jump[l])),
        }
    }

    /// Where between edges (0) and noise (1) a picture is in which jumps are so many times the jumps of new halves.
    pub fn noise(level: usize, jump_ratio: f64) -> f64 {
        let (edge, noise) = (f64::from(EDGE.jump[level]), f64::from(NOISE.jump[level]));
        let place = ((jump_ratio - edge) / (noise - edge)).clamp(-0.7, 1.2);
        // Edges are finished first: what is left of a mixture is noise.
        if place > 0.0 { place.sqrt() } else { place }
    }

    /// The squared error of what a pixel of 2^level samples shows, where the mean of those that come next is off by
    /// the root of `jump`.
    pub fn error_from_jump(&self, level: usize, jump: f32) -> f32 {
        jump * self.of_jump[level]
    }

    /// Squared error of what a pixel of 2^k samples shows over the variance of a sample.
    pub fn gain(&self) -> [f32; LEVELS] {
        let mut gain = [self.first; LEVELS];
        for k in 2..LEVELS {
            gain[k] = if k == 2 { self.first * self.ratio[0] } else { gain[k - 1] * self.ratio[k - 1] };
        }
        gain
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::Rgb;
    use crate::picture::Pixel;
    use crate::render::Region;
    use crate::render::adaptive::Sequence;
    use crate::render::adaptive::lift::lift;
    use crate::render::adaptive::tally::{Samples, Tally};

    /// The mean over some of a pixel's samples of what is 1/2 on one side of a line.
    fn samples(
        line: (f64, f64, f64),
        pixel: (u32, u32),
        trial: u32,
        numbers: std::ops::Range<u32>,
    ) -> Samples {
        let sequence = Sequence::new(pixel.0, pixel.1, trial);
        Samples::of(numbers.map(|i| {
            let (dx, dy) = sequence.offset(i);
            let (x, y) = (f64::from(pixel.0) - 1.0 + dx, f64::from(pixel.1) - 1.0 + dy);
            Pixel::new(Rgb::splat(if line.0 * x + line.1 * y < line.2 { 0.5 } else { 0.0 }), 0.0)
        }))
    }

    /// Its integral over a pixel in the origin.
    fn truth((a, b, c): (f64, f64, f64)) -> f64 {
        let side = 40;
        let middle = |i: i32| (f64::from(i) + 0.5) / f64::from(side) - 0.5;
        let inside = (0..side * side).filter(|i| a * middle(i % side) + b * middle(i / side) < c);
        0.5 * inside.count() as f64 / f64::from(side * side)
    }

    /// The preset values, measured: lines of random place and direction near a pixel, all pixels with as many samples.
    #[test]
    fn edges_converge_as_preset() {
        let (mut errors, mut jumps) = ([0.0f64; 4], [0.0f64; 4]);
        for t in 0..12_000u32 {
            let (sin, cos) = (f64::from(t) * 2.399_963).sin_cos();
            let line = (cos, sin, 3.2 * (f64::from(t % 997) / 997.0 - 0.5));
            let truth = truth(line);
            for k in [0, 2, 3] {
                let count = 1 << k;
                let mut tally = Tally::new(Region::whole(3, 3));
                for i in 0..9 {
                    tally.pixels[i] = samples(line, tally.place(i), t, 0..count);
                }
                let shown = f64::from(tally.pixels[4].mean[0] + lift(&tally, 1, 1).x);
                let next = f64::from(samples(line, (1, 1), t, count..following(count)).mean[0]);
                errors[k] += (shown - truth).powi(2);
                jumps[k] += (shown - next).powi(2);
            }
        }
        let preset = Convergence::default();
        for k in [0, 2, 3] {
            let told = f64::from(preset.error_from_jump(k, jumps[k] as f32));
            assert!((told / errors[k] - 1.0).abs() < 0.15, "{k}: {}", told / errors[k]);
        }
        for (k, next) in [(0, 2), (2, 3)] {
            let ratio = errors[next] / errors[k];
            assert!(
                (ratio / f64::from(preset.ratio[k]) - 1.0).abs() < 0.15,
                "{k}: {ratio} {errors:?} {jumps:?}"
            );
        }
    }

    #[test]
    fn levels_are_doublings_but_for_the_first() {
        assert_eq!([0, 1, 4, 8, 1 << 20, u32::MAX].map(level), [0, 0, 2, 3, 20, 23]);
        let mut count = 1;
        for expected in [4, 8, 16, 32] {
            assert_eq!(following(count) - count, step(level(count)) as u32);
            assert_eq!(level(following(count)), next_level(level(count)));
            count = following(count);
            assert_eq!(count, expected);
        }
        let gain = Convergence::default().gain();
        assert!((gain[3] - 0.19 * 0.3 * 0.38).abs() < 1e-6);
    }
}
