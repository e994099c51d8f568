//! What error a pixel's mean still has, in light (squared, summed over red, green and blue).
//!
//! A pixel's own samples may agree by chance, so they are not asked alone: a prior from the eight
//! neighbours stands beside them with the weight of [`PRIOR_WEIGHT`] samples. The prior is the larger of
//!
//! * what is left of the nine means when the plane through them is taken away (edges between pixels), and
//! * the variance inside the neighbours (features thinner than a pixel that some of them have met).
//!
//! Both are exact for no picture; what they are worth is found out by [`super::calibration`].
//!
//! The variance of one sample becomes that of the mean of n by [`Convergence`], which is measured while the
//! picture is made: n^-1 for noise, n^-3/2 at edges, n^-3 where colours are smooth.

use super::tally::{Samples, Tally};
use crate::picture::light::Light;
use rayon::prelude::*;

/// How many samples the neighbours' testimony is worth.
const PRIOR_WEIGHT: f32 = 1.5;
/// Between the residual of a plane through nine pixels and the variance inside the middle one, at edges of
/// random place and direction.
const RESIDUAL_TO_VARIANCE: f32 = 0.75;
/// A pixel's linear shading adds slope²/12 to the variance of its samples, but nothing to its mean's error.
const SLOPE_TO_VARIANCE: f32 = 1.0 / 12.0;
/// However steep: this share of the samples' variance is left.
const LEAST_SHARE: f32 = 0.1;

/// Neighbours in flat surroundings differ by less, in each channel of light.
const ALIKE: f32 = 1.0 / 1024.0;

/// Number of doublings that are told apart.
pub const LEVELS: usize = 24;

/// The level of a pixel with 2^level samples.
pub fn level(count: u32) -> usize {
    (count.max(1).ilog2() as usize).min(LEVELS - 1)
}

/// By how much the variance of a mean falls with each doubling of its samples.
#[derive(Clone, Debug)]
pub struct Convergence {
    /// Variance of the mean of 2^(k+1) samples over that of 2^k.
    pub ratio: [f32; LEVELS],
}

impl Default for Convergence {
    /// Edges of random place and direction through a pixel.
    fn default() -> Self {
        let mut ratio = [0.36; LEVELS];
        ratio[..4].copy_from_slice(&[0.29, 0.31, 0.33, 0.35]);
        Self { ratio }
    }
}

impl Convergence {
    /// The squared error of a mean of 2^level samples, where the mean of as many new ones is off by the root
    /// of `jump`. Of independent halves it would be half the jump; stratified together they repel each other.
    pub fn error_from_jump(&self, level: usize, jump: f32) -> f32 {
        jump / (4.0 - 4.0 * self.ratio[level])
    }

    /// Variance of the mean of 2^k samples over that of one.
    pub fn gain(&self) -> [f32; LEVELS] {
        let mut gain = [1.0; LEVELS];
        for k in 1..LEVELS {
            gain[k] = gain[k - 1] * self.ratio[k - 1];
        }
        gain
    }
}

/// One pixel as its neighbours see it.
#[derive(Clone, Copy, Debug, Default)]
struct Seen {
    light: [f32; 3],
    /// Where the samples' mean place is, relative to the pixel's centre.
    at: [f32; 2],
    /// Sum over the channels of the variance of a sample, times its degrees of freedom.
    spread: f32,
    /// Degrees of freedom: one less than samples.
    freedom: f32,
}

/// What is known of one pixel's error.
#[derive(Clone, Copy, Debug, Default)]
pub struct Expected {
    /// Squared error of the mean, summed over the channels, as samples and neighbours tell,
    pub plain: f32,
    /// with what is known of the place ([`super::locality`]),
    pub local: f32,
    /// and with what is known of its class ([`super::calibration`]).
    pub variance: f32,
    /// How light changes along x and y, per channel, so far as neighbours agree on it.
    pub slope: Slope,
    /// Of a pixel with one sample in flat surroundings: by how much (squared) that sample stands out.
    pub surprise: Option<f32>,
}

/// Change of light per pixel along x and y, for each channel.
pub type Slope = [[f32; 2]; 3];

/// The expected errors of all pixels, row by row. `offset` tells where the only sample of a pixel lies.
pub fn survey(
    tally: &Tally,
    light: &Light,
    convergence: &Convergence,
    offset: impl Fn(usize) -> (f64, f64) + Sync,
) -> Vec<Expected> {
    let seen = |(i, s): (usize, &Samples)| see(s, light, || offset(i));
    let seen: Vec<Seen> = tally.pixels.par_iter().enumerate().map(seen).collect();
    let gain = convergence.gain();
    let (width, height) = (tally.width(), tally.height());
    let mut expected = vec![Expected::default(); seen.len()];
    expected.par_chunks_mut(width.max(1)).enumerate().for_each(|(y, row)| {
        for (x, e) in row.iter_mut().enumerate() {
            let samples = &tally.pixels[y * width + x];
            *e = Around::of(&seen, x, y, width, height).expected(samples, light, gain[level(samples.count)]);
            e.surprise = surprise(&seen, x, y, width, height);
        }
    });
    expected
}

fn see(samples: &Samples, light: &Light, offset: impl Fn() -> (f64, f64)) -> Seen {
    let at = if samples.count == 1 { offset() } else { (0.0, 0.0) };
    let freedom = samples.count.saturating_sub(1) as f32;
    Seen {
        light: light.pixel(&samples.pixel()),
        at: [at.0 as f32, at.1 as f32],
        spread: variance_of_mean(samples, light, 1.0) * freedom,
        freedom,
    }
}

/// The variance in light of a mean whose working variance is `gain` times that of a sample.
fn variance_of_mean(samples: &Samples, light: &Light, gain: f32) -> f32 {
    if samples.count < 2 {
        return 0.0;
    }
    let mut sum = 0.0;
    for k in 0..3 {
        let sigma = (samples.spread[k] / (samples.count - 1) as f32 * gain).sqrt();
        let half = 0.5 * (light.of(samples.mean[k] + sigma) - light.of(samples.mean[k] - sigma));
        sum += half * half;
    }
    sum
}

/// A pixel with its neighbours, nine or fewer.
struct Around {
    /// What is left of the means when a plane is taken away, per degree of freedom, over the channels.
    residual: f32,
    slope: Slope,
    /// Variance inside the neighbours.
    within: f32,
}

impl Around {
    fn of(seen: &[Seen], x: usize, y: usize, width: usize, height: usize) -> Self {
        let mut near: smallvec::SmallVec<[(f32, f32, &Seen); 9]> = smallvec::SmallVec::new();
        let (mut spread, mut freedom) = (0.0, 0.0);
        for yy in y.saturating_sub(1)..(y + 2).min(height) {
            for xx in x.saturating_sub(1)..(x + 2).min(width) {
                let s = &seen[yy * width + xx];
                let (dx, dy) = (xx as f32 - x as f32, yy as f32 - y as f32);
                near.push((dx + s.at[0], dy + s.at[1], s));
                if (xx, yy) != (x, y) {
                    spread += s.spread;
                    freedom += s.freedom;
                }
            }
        }
        let (residual, slope) = plane(&near);
        Self { residual, slope, within: if freedom > 0.0 { spread / freedom } else { 0.0 } }
    }

    fn expected(&self, samples: &Samples, light: &Light, gain: f32) -> Expected {
        let prior = (RESIDUAL_TO_VARIANCE * self.residual).max(self.within) * gain;
        let freedom = samples.count.saturating_sub(1) as f32;
        let slope: f32 = self.slope.iter().flatten().map(|g| g * g).sum();
        let raw = variance_of_mean(samples, light, gain);
        let own = (raw - SLOPE_TO_VARIANCE * slope * gain).max(LEAST_SHARE * raw);
        let variance = (PRIOR_WEIGHT * prior + freedom * own) / (PRIOR_WEIGHT + freedom);
        Expected { plain: variance, local: variance, variance, slope: self.slope, surprise: None }
    }
}

/// By how much a pixel's light stands out (squared) from neighbours that are all alike.
fn surprise(seen: &[Seen], x: usize, y: usize, width: usize, height: usize) -> Option<f32> {
    let own = &seen[y * width + x];
    if own.freedom > 0.0 || x == 0 || y == 0 || x + 1 == width || y + 1 == height {
        return None;
    }
    let first = &seen[(y - 1) * width + x - 1];
    for yy in y - 1..y + 2 {
        for xx in x - 1..x + 2 {
            let s = &seen[yy * width + xx];
            let same = (0..3).all(|k| (s.light[k] - first.light[k]).abs() < ALIKE);
            if (xx, yy) != (x, y) && !same {
                return None;
            }
        }
    }
    Some((0..3).map(|k| (own.light[k] - first.light[k]).powi(2)).sum())
}

/// The plane nearest to the points: mean squared residual over the channels, and slopes, made smaller the
/// less the plane explains.
fn plane(near: &[(f32, f32, &Seen)]) -> (f32, Slope) {
    let n = near.len() as f32;
    let first = near[0].2.light;
    if n < 4.0 || near.iter().all(|p| p.2.light == first) {
        return (0.0, [[0.0; 2]; 3]);
    }
    let mean = |f: &dyn Fn(&(f32, f32, &Seen)) -> f32| near.iter().map(f).sum::<f32>() / n;
    let (mx, my) = (mean(&|p| p.0), mean(&|p| p.1));
    let sum =
        |f: &dyn Fn(f32, f32, &Seen) -> f32| -> f32 { near.iter().map(|p| f(p.0 - mx, p.1 - my, p.2)).sum() };
    let (xx, xy, yy) = (sum(&|x, _, _| x * x), sum(&|x, y, _| x * y), sum(&|_, y, _| y * y));
    let det = xx * yy - xy * xy;
    if det <= 1e-3 * xx * yy {
        return (0.0, [[0.0; 2]; 3]);
    }
    let (mut residual, mut slope) = (0.0, [[0.0; 2]; 3]);
    for (k, slope) in slope.iter_mut().enumerate() {
        let mv = mean(&|p| p.2.light[k]);
        let (xv, yv) = (sum(&|x, _, s| x * (s.light[k] - mv)), sum(&|_, y, s| y * (s.light[k] - mv)));
        let vv = sum(&|_, _, s| (s.light[k] - mv).powi(2));
        let (gx, gy) = ((xv * yy - yv * xy) / det, (yv * xx - xv * xy) / det);
        let explained = gx * xv + gy * yv;
        let left = (vv - explained).max(0.0) / (n - 3.0);
        residual += left;
        let share = if explained > 0.0 { (1.0 - 2.0 * left / explained).max(0.0) } else { 0.0 };
        *slope = [gx * share, gy * share];
    }
    (residual, slope)
}
