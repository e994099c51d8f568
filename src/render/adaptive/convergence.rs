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

/// The level of a pixel of one sample that gets a second one across an edge.
pub const ACROSS: usize = LEVELS - 1;

/// The level of a pixel, if it is near edges or not.
#[inline]
pub fn level_near(count: u32, edges: bool) -> usize {
    if edges && count <= 1 { ACROSS } else { level(count) }
}

/// How many samples a pixel of so many gets next at a level. A second one beside the first in the centre takes nothing
/// away but at edges.
#[inline]
pub fn following(count: u32, level: usize) -> u32 {
    match (count, level) {
        (0, _) => 1,
        (1, 0) => 4,
        (n, _) => n * 2,
    }
}

/// The level after `level`.
pub fn next_level(level: usize) -> usize {
    match level {
        ACROSS => 1,
        0 => 2,
        l => l + 1,
    }
}

/// Samples from a level to the next.
#[inline]
pub fn step(level: usize) -> f64 {
    match level {
        ACROSS => 1.0,
        0 => 3.0,
        l => 2f64.powi(l as i32),
    }
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

const fn table(across: f32, first: [f32; 5], rest: f32) -> [f32; LEVELS] {
    let mut all = [rest; LEVELS];
    all[ACROSS] = across;
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
    ratio: table(0.38, [0.30, 0.46, 0.42, 0.43, 0.75], 0.36),
    of_jump: table(0.075, [0.58, 0.24, 0.32, 0.35, 0.38], 0.39),
    jump: table(0.0, [0.0, 0.142, 0.13, 0.08, 0.29], 0.36),
};
/// Samples that have nothing to do with each other.
const NOISE: Kind = Kind {
    first: 0.38,
    ratio: table(0.52, [0.47, 0.56, 0.592, 0.585, 0.5], 0.5),
    of_jump: table(0.13, [0.58, 0.34, 0.419, 0.461, 0.5], 0.5),
    jump: table(0.0, [0.0, 0.421, 0.427, 0.464, 0.5], 0.5),
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
        gain[1] = self.first * self.ratio[ACROSS];
        gain[2] = self.first * self.ratio[0];
        for k in 3..ACROSS {
            gain[k] = gain[k - 1] * self.ratio[k - 1];
        }
        gain
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::Gamma;
    use crate::color::Rgb;
    use crate::picture::Pixel;
    use crate::picture::light::Light;
    use crate::render::Region;
    use crate::render::adaptive::estimate::Survey;
    use crate::render::adaptive::lift::lift;
    use crate::render::adaptive::tally::{Samples, Tally};
    use crate::render::adaptive::{Sequence, mix};

    /// What some of a pixel's samples come to, in a picture by formula.
    fn samples(
        color: &dyn Fn(f64, f64) -> f32,
        i: usize,
        sequence: Sequence,
        numbers: std::ops::Range<u32>,
    ) -> Samples {
        Samples::of(numbers.map(|k| {
            let (dx, dy) = sequence.offset(k);
            let (x, y) = ((i % SIDE) as f64 - 2.0 + dx, (i / SIDE) as f64 - 2.0 + dy);
            Pixel::new(Rgb::splat(color(x, y)), 0.0)
        }))
    }

    const SIDE: usize = 5;

    /// A picture by formula, with the middle pixel's integral.
    type Painted = (Box<dyn Fn(f64, f64) -> f32>, f64);
    /// Of what the middle pixel shows: squared error, squared difference to the samples that come next, and that
    /// between these samples' halves.
    type Shown = [f64; 3];

    /// Pictures of 5 by 5 pixels with as many samples in all, level by level from 1 sample to 16; across edges or not.
    fn measured(across: bool, painted: impl Fn(u32) -> Painted) -> Vec<(usize, Shown)> {
        const TRIALS: u32 = 8000;
        let mut sums: Vec<(usize, Shown)> = Vec::new();
        for t in 0..TRIALS {
            let (color, truth) = painted(t);
            for (k, (level, shown)) in converging(across, t, &*color, truth).into_iter().enumerate() {
                if sums.len() <= k {
                    sums.push((level, Shown::default()));
                }
                (0..3).for_each(|i| sums[k].1[i] += shown[i] / f64::from(TRIALS));
            }
        }
        sums
    }

    fn converging(
        across: bool,
        seed: u32,
        color: &dyn Fn(f64, f64) -> f32,
        truth: f64,
    ) -> Vec<(usize, Shown)> {
        let (middle, pixels) = (SIDE * SIDE / 2, 0..SIDE * SIDE);
        let mut tally = Tally::new(Region::whole(SIDE as u32, SIDE as u32));
        let sequence = |i: usize| Sequence::new((i % SIDE) as u32, (i / SIDE) as u32, seed);
        for i in pixels.clone() {
            tally.pixels[i] = samples(color, i, sequence(i), 0..1);
        }
        let mut survey = Survey::new(&tally);
        survey.look(&tally, &Light::new(Gamma::Power(1.0)), &Convergence::default());
        let heading = |i: usize| if across { survey.heading(i) } else { None };
        let sequences: Vec<Sequence> = pixels.clone().map(|i| sequence(i).across(heading(i))).collect();
        let (mut found, mut count, mut level) = (Vec::new(), 1, level_near(1, across));
        while count <= 16 {
            let next = following(count, level);
            let part = |i: usize, numbers| samples(color, i, sequences[i], numbers);
            let shown = f64::from(tally.pixels[middle].mean[0] + lift(&tally, SIDE / 2, SIDE / 2).x);
            let half = count + (next - count) / 2;
            let (a, b) = (part(middle, count..half), part(middle, half..next));
            let jump = (shown - f64::from(a.join(&b).mean[0])).powi(2);
            found.push((level, [(shown - truth).powi(2), jump, f64::from(a.mean[0] - b.mean[0]).powi(2)]));
            for i in pixels.clone() {
                let (old, new) = (tally.pixels[i], part(i, count..next));
                tally.pixels[i] = if next == 2 { old.with_second(&new) } else { old.join(&new) };
            }
            (count, level) = (next, next_level(level));
        }
        found
    }

    /// Its integral over a pixel in the origin.
    fn truth((a, b, c): (f64, f64, f64)) -> f64 {
        let side = 40;
        let middle = |i: i32| (f64::from(i) + 0.5) / f64::from(side) - 0.5;
        let inside = (0..side * side).filter(|i| a * middle(i % side) + b * middle(i / side) < c);
        0.5 * inside.count() as f64 / f64::from(side * side)
    }

    /// Holds what was measured against presets: ratios may be off by a factor.
    fn check(name: &str, found: &[(usize, Shown)], preset: &Convergence, factor: f64) {
        for (k, &(level, [error, jump, halves])) in found.iter().enumerate().take(found.len() - 1) {
            let ratio = found[k + 1].1[0] / error;
            let line = format!(
                "{name}, level {level}: error {error:.6}, of jump {:.3}, jump {:.3}, ratio {ratio:.3}",
                error / jump,
                jump / halves
            );
            println!("{line}");
            let told = f64::from(preset.error_from_jump(level, jump as f32)) / error;
            assert!((1.0 / 1.2..1.2).contains(&told), "{line}");
            let told = f64::from(preset.ratio[level]) / ratio;
            assert!((1.0 / factor..factor).contains(&told), "{line}");
        }
    }

    fn line(t: u32) -> Painted {
        let (sin, cos) = (f64::from(t) * 2.399_963).sin_cos();
        let line = (cos, sin, 3.2 * (f64::from(t % 997) / 997.0 - 0.5));
        let color = move |x: f64, y: f64| if line.0 * x + line.1 * y < line.2 { 0.5 } else { 0.0 };
        (Box::new(color), truth(line))
    }

    /// The preset values, measured: lines of random place and direction near a pixel, all pixels with as many samples.
    #[test]
    fn edges_converge_as_preset() {
        check("edges", &measured(false, line), &Convergence::default(), 1.2);
        // Scenes' edges are curved and end, and their samples lie elsewhere: what four take away is more there.
        let across = measured(true, line);
        check("across edges", &across, &Convergence::default(), 1.5);
        // A second sample across the edge is worth more than half of what three take away that know nothing of it.
        let preset = Convergence::default();
        assert!(
            1.0 - preset.ratio[ACROSS] > 0.5 * (1.0 - preset.ratio[0])
                && across[1].1[0] < 0.4 * across[0].1[0]
        );
    }

    /// The same for samples that have nothing to do with each other.
    #[test]
    fn noise_converges_as_preset() {
        let noise = |t: u32| -> Painted {
            let color = move |x: f64, y: f64| {
                let draw = mix(mix(mix(t) ^ (x * 1e6) as i32 as u32) ^ (y * 1e6) as i32 as u32);
                0.25 + 0.5 * (f64::from(draw) / 4_294_967_296.0) as f32
            };
            (Box::new(color), 0.5)
        };
        check("noise", &measured(false, noise), &Convergence::of(&[1.0; LEVELS]), 1.2);
    }

    #[test]
    fn levels_are_doublings_but_for_the_first() {
        assert_eq!([0, 1, 2, 4, 8, 1 << 20, u32::MAX].map(level), [0, 0, 1, 2, 3, 20, 23]);
        for (edges, counts) in [(false, vec![4, 8, 16, 32]), (true, vec![2, 4, 8, 16, 32])] {
            let (mut count, mut at) = (1, level_near(1, edges));
            for expected in counts {
                assert_eq!(following(count, at) - count, step(at) as u32);
                (count, at) = (following(count, at), next_level(at));
                assert_eq!((count, at), (expected, level(expected)));
            }
        }
        let (gain, preset) = (Convergence::default().gain(), Convergence::default());
        assert!((gain[3] - preset.first * preset.ratio[0] * preset.ratio[2]).abs() < 1e-6);
        assert!((gain[1] - preset.first * preset.ratio[ACROSS]).abs() < 1e-6);
    }
}
