//! Which pixels get more samples next.
//!
//! Every pixel could be doubled again and again; each doubling takes some expected error away for some rays.
//! All of them are sorted by what they gain per ray. Those that would have to be carried out to reach the
//! target, or to spend [`STEP`] of the samples that there are, are the plan; of each pixel's the first one is
//! carried out, and then pixels are looked at again.

use super::calibration::{BINS, Calibration, bin};
use super::convergence::{Convergence, LEVELS, following, level, next_level, step};
use super::estimate::Expected;
use super::gaps::{Gaps, KINDS};
use super::sequence::mix;
use super::tally::{Samples, Tally};

/// A plan's share of new samples over those that there are.
const STEP: f64 = 0.8;
/// Rounds are not made smaller than this share of the samples that there are.
const LEAST_STEP: f64 = 0.03;
/// A plan aims at a little less than the target, so that it need not be mended afterwards.
const AIM: f64 = 0.97;
/// Pixels of which less than this share of the mean error is expected are not looked at.
const LEAST_ERROR: f32 = 1e-4;
/// The share of the samples that there are which goes to pixels picked by chance, in each round.
const AUDIT_SHARE: f64 = 0.03;
/// The same while there are gaps,
const GAP_AUDIT_SHARE: f64 = 0.06;
/// but so many at least.
const GAP_AUDITS_LEAST: f64 = 500.0;
/// The first sample of a gap takes at least this share of its error away.
const LEAST_FIRST_GAIN: f32 = 0.3;
/// A class is audited until so many members are measured, whatever they showed,
const AUDIT_LEAST: f64 = 200.0;
/// one of gaps until so many are,
const GAP_AUDIT_LEAST: f64 = 80.0;
/// and until the uncertainty of its error is below this share of the picture's.
const AUDIT_PRECISION: f64 = 0.1;
/// The most samples that a pixel can be given.
const MAX_COUNT: u32 = 1 << 20;

/// Levels of pixels, and behind them kinds of gaps.
const CLASSES: usize = LEVELS + KINDS;

/// A pixel whose samples are to be brought to a number.
#[derive(Clone, Copy, Debug)]
pub struct Task {
    pub pixel: u32,
    pub from: u32,
    pub to: u32,
    /// Squared errors that are expected before they are held against measured ones.
    pub plain: f32,
    pub local: f32,
}

impl Task {
    pub fn first(pixel: u32, to: u32) -> Self {
        Self { pixel, from: 0, to, plain: 0.0, local: 0.0 }
    }

    fn doubling(pixel: usize, samples: &Samples, e: &Expected) -> Self {
        let (from, to) = (samples.count, following(samples.count));
        Self { pixel: pixel as u32, from, to, plain: e.plain, local: e.local }
    }
}

/// What a plan is made from.
pub struct Planner<'a> {
    pub tally: &'a Tally,
    /// All pixels in the order in which rays follow each other best.
    pub order: &'a [u32],
    pub expected: &'a [Expected],
    pub calibration: &'a Calibration,
    pub gaps: &'a Gaps,
    pub convergence: &'a Convergence,
    /// Samples of the whole picture so far, and its expected squared error.
    pub samples: u64,
    pub total: f64,
    pub round: u32,
    /// Whether the round may end before all its tasks are done: those that gain most come first.
    pub is_limited: bool,
}

impl Planner<'_> {
    /// The next round's tasks, those first that gain most. `target` is the squared error to be reached.
    pub fn tasks(&self, target: Option<f64>) -> Vec<Task> {
        let mut ladder = Ladder::new();
        let least = LEAST_ERROR * (self.total / self.expected.len() as f64) as f32;
        let mut rungs = vec![(Ladder::RUNGS - 1) as u8; self.expected.len()];
        for ((rung, e), samples) in rungs.iter_mut().zip(self.expected).zip(&self.tally.pixels) {
            if e.variance >= least {
                *rung = ladder.add(e, samples, self.convergence) as u8;
            }
        }
        ladder.climb(self.convergence);
        let lowest = ladder.cut(self.samples as f64, target.map(|t| self.total - AIM * t)) as u8;
        let is_chosen = |i: usize| rungs[i] <= lowest && self.tally.pixels[i].count < MAX_COUNT;
        // Sorted by counting: rung by rung, and in order on each. If all are done anyway, rays of one place had
        // better follow each other.
        let rung = |i: usize| if self.is_limited { usize::from(rungs[i]) } else { 0 };
        let mut next = [0usize; Ladder::RUNGS + 1];
        (0..rungs.len()).filter(|&i| is_chosen(i)).for_each(|i| next[rung(i) + 1] += 1);
        for rung in 0..Ladder::RUNGS {
            next[rung + 1] += next[rung];
        }
        let mut tasks = vec![Task::first(0, 0); next[Ladder::RUNGS]];
        let mut rest: Vec<usize> = Vec::new();
        for i in self.order.iter().map(|&i| i as usize) {
            if is_chosen(i) {
                let place = &mut next[rung(i)];
                tasks[*place] = Task::doubling(i, &self.tally.pixels[i], &self.expected[i]);
                *place += 1;
            } else {
                rest.push(i);
            }
        }
        if !tasks.is_empty() {
            self.audit(&rest, &mut tasks);
        }
        tasks
    }

    /// The class that pixel `i` belongs to; gaps' stand behind all levels.
    fn class(&self, i: usize) -> (usize, usize) {
        let e = &self.expected[i];
        match self.tally.pixels[i].count {
            0 => (LEVELS + usize::from(self.gaps.is_wide(i)), bin(e.plain)),
            count => (level(count), bin(e.local)),
        }
    }

    /// Adds pixels picked by chance from classes about which too little is known.
    fn audit(&self, rest: &[usize], tasks: &mut Vec<Task>) {
        let mut members = [[0f64; BINS]; CLASSES];
        for &i in rest {
            let (level, bin) = self.class(i);
            members[level][bin] += 1.0;
        }
        let chances = self.chances(&members);
        for &i in rest {
            let (level, bin) = self.class(i);
            let chance = chances[level][bin];
            let samples = &self.tally.pixels[i];
            let draw = || f64::from(mix(mix(i as u32 ^ 0x5BD1_E995) ^ self.round)) / 4_294_967_296.0;
            if chance > 0.0 && samples.count < MAX_COUNT && draw() < chance {
                tasks.push(Task::doubling(i, samples, &self.expected[i]));
            }
        }
    }

    /// How likely a member of each class is picked.
    fn chances(&self, members: &[[f64; BINS]; CLASSES]) -> [[f64; BINS]; CLASSES] {
        let mut chances = [[0f64; BINS]; CLASSES];
        let mut cost = 0.0;
        for l in 0..CLASSES {
            for b in 0..BINS {
                let n = members[l][b];
                if n == 0.0 {
                    continue;
                }
                let is_gap = l >= LEVELS;
                let class =
                    if is_gap { self.gaps.class(l - LEVELS, b) } else { self.calibration.class(l, b) };
                let uncertain = n * class.deviation() / (AUDIT_PRECISION * self.total.max(f64::MIN_POSITIVE));
                let least = if is_gap { GAP_AUDIT_LEAST } else { AUDIT_LEAST };
                let wanted = uncertain.powi(2).max(least.min(n / 8.0)) - class.count();
                chances[l][b] = (wanted / n).clamp(0.0, 0.5);
                cost += chances[l][b] * n * if is_gap { 1.0 } else { step(l) };
            }
        }
        let samples = self.samples as f64;
        let allowed = match members[LEVELS..].iter().flatten().any(|&n| n > 0.0) {
            true => (GAP_AUDIT_SHARE * samples).max(GAP_AUDITS_LEAST),
            false => AUDIT_SHARE * samples,
        };
        let scale = (allowed / cost.max(1.0)).min(1.0);
        chances.map(|row| row.map(|c| c * scale))
    }
}

/// Error that doubling takes away, per ray; of a gap, that which its first sample takes away.
#[inline]
fn gain(e: &Expected, samples: &Samples, convergence: &Convergence) -> f32 {
    let rays_per_sample = (samples.rays / samples.count.max(1) as f32).max(1.0);
    match samples.count {
        0 => first_gain(e) / rays_per_sample,
        count => {
            let samples = (following(count) - count) as f32;
            e.variance * (1.0 - convergence.ratio[level(count)]) / (samples * rays_per_sample)
        }
    }
}

/// Error that the first sample of a gap takes away.
fn first_gain(e: &Expected) -> f32 {
    (e.variance - e.local).max(LEAST_FIRST_GAIN * e.variance)
}

/// Doublings of all pixels by what they gain: rungs a quarter of an octave apart, the best first.
struct Ladder {
    /// By level and rung of the first doubling of a pixel: how many there are, and their errors.
    first: Vec<(f64, f64)>,
    samples: Vec<f64>,
    variance: Vec<f64>,
}

impl Ladder {
    const RUNGS: usize = 256;
    const PER_OCTAVE: f32 = 4.0;

    fn new() -> Self {
        Self {
            first: vec![(0.0, 0.0); LEVELS * Self::RUNGS],
            samples: vec![0.0; Self::RUNGS],
            variance: vec![0.0; Self::RUNGS],
        }
    }

    /// A gain of 4 or more is on the first rung, and a gain below 2^-61 on the last. Quarters of an octave
    /// are told by the two highest bits of the fraction.
    #[inline]
    fn rung(gain: f32) -> usize {
        const HIGHEST: u32 = (4.0f32.to_bits()) >> 21;
        HIGHEST.saturating_sub(gain.max(f32::MIN_POSITIVE).to_bits() >> 21).min(Self::RUNGS as u32 - 1)
            as usize
    }

    /// The first doubling of one pixel; its rung.
    #[inline]
    fn add(&mut self, e: &Expected, samples: &Samples, convergence: &Convergence) -> usize {
        let own = Self::rung(gain(e, samples, convergence));
        let mut rung = own;
        let mut variance = e.variance;
        if samples.count == 0 {
            let first = first_gain(e);
            self.samples[rung] += 1.0;
            self.variance[rung] += f64::from(first);
            variance -= first;
            let next = Expected { variance, ..*e };
            rung = rung.max(Self::rung(gain(&next, &Samples { count: 1, ..*samples }, convergence)));
        }
        let entry = &mut self.first[level(samples.count) * Self::RUNGS + rung];
        entry.0 += 1.0;
        entry.1 += f64::from(variance);
        own
    }

    /// All further doublings.
    fn climb(&mut self, convergence: &Convergence) {
        let ratio = |level: usize| f64::from(convergence.ratio[level]);
        for l in 0..LEVELS {
            for r in 0..Self::RUNGS - 1 {
                let (pixels, mut variance) = self.first[l * Self::RUNGS + r];
                if pixels == 0.0 {
                    continue;
                }
                let mut below = 0.0;
                let mut k = l;
                while k < level(MAX_COUNT) {
                    let rung = r + (below * f64::from(Self::PER_OCTAVE)).round() as usize;
                    if rung >= Self::RUNGS - 1 {
                        break;
                    }
                    self.samples[rung] += pixels * step(k);
                    self.variance[rung] += variance * (1.0 - ratio(k));
                    // The next step has this share of the error to take away, for more samples.
                    variance *= ratio(k);
                    let next = next_level(k);
                    let samples = step(next) / step(k);
                    below -= (ratio(k) * (1.0 - ratio(next)) / (1.0 - ratio(k)) / samples).log2();
                    k = next;
                }
            }
        }
    }

    /// The last rung that is carried out when `spent` samples have been taken and `excess` squared error has
    /// to go.
    fn cut(&self, spent: f64, excess: Option<f64>) -> usize {
        let (mut samples, mut variance) = (0.0, 0.0);
        for rung in 0..Self::RUNGS - 1 {
            samples += self.samples[rung];
            variance += self.variance[rung];
            let enough = samples >= LEAST_STEP * spent && excess.is_some_and(|e| variance >= e);
            if enough || samples >= STEP * spent {
                return rung;
            }
        }
        Self::RUNGS - 2
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn samples(count: u32) -> Samples {
        Samples { count, rays: count as f32, ..Samples::default() }
    }

    fn of(variance: f32) -> Expected {
        Expected { plain: variance, local: variance, variance }
    }

    /// With the preset convergence three more samples take 70 % of the error of one away, four more 62 % of what is
    /// left: 0.7 / 3 = 0.23 a sample, then 0.3 * 0.62 / 4 = 0.05.
    #[test]
    fn the_ladder_holds_all_doublings_of_a_pixel() {
        let mut ladder = Ladder::new();
        let convergence = Convergence::default();
        ladder.add(&of(1.0), &samples(1), &convergence);
        ladder.climb(&convergence);
        let first = Ladder::rung(0.7 / 3.0);
        let second = Ladder::rung(0.3 * 0.62 / 4.0);
        assert!(first < second);
        assert_eq!(ladder.samples[first], 3.0);
        assert!((ladder.variance[first] - 0.7).abs() < 1e-6);
        let next = (first + 1..Ladder::RUNGS).find(|&r| ladder.samples[r] > 0.0).unwrap();
        assert!(next.abs_diff(second) <= 1, "{next} {second}");
        assert_eq!(ladder.samples[next], 4.0);
        assert!((ladder.variance[next] - 0.3 * 0.62).abs() < 1e-6);
        assert_eq!(ladder.cut(10.0, Some(0.69)), first);
        assert_eq!(ladder.cut(10.0, Some(0.8)), next);
    }

    #[test]
    fn rungs_are_quarters_of_octaves() {
        assert_eq!([100.0, 4.0, 2.0, 1.0].map(Ladder::rung), [0, 0, 4, 8]);
        assert_eq!(Ladder::rung(0.0), Ladder::RUNGS - 1);
    }

    /// Of two equal pixels the one whose samples cost twice the rays is worth half.
    #[test]
    fn rays_are_what_samples_cost() {
        let convergence = Convergence::default();
        let dear = Samples { rays: 8.0, ..samples(4) };
        let cheap = gain(&of(0.1), &samples(4), &convergence);
        assert!((gain(&of(0.1), &dear, &convergence) * 2.0 - cheap).abs() < 1e-7);
    }
}
