//! Pixels between sampled ones, where a picture may have fewer samples than pixels.
//!
//! At first one pixel of every square of [`SPACING`] pixels is sampled. The others show what lies between the four
//! around them. How wrong that is is told by how much those four differ, and is held to account like any other
//! expectation ([`super::calibration`]): gaps picked by chance are sampled, and what turns up corrects what is
//! expected of their class, of those among sampled pixels that are all alike as well.

use super::calibration::{Calibration, Class, FLOOR, Factors, Measured};
use super::estimate::ALIKE;
use super::tally::{Samples, Tally};
use crate::picture::light::Light;
use glam::Vec3A;

/// Every so many pixels along both sides one is sampled first.
pub const SPACING: usize = 2;
/// The error that is expected of a gap before any was measured, over the squared difference of the pixels around it.
const DIFFERENCE_TO_ERROR: f32 = 0.1;
/// Between pixels that are alike, but next to others that are not, this share of the error is expected that is
/// expected there.
const NEXT_TO_ERROR: f32 = 1.0 / 32.0;
/// A measured difference counts for at least this share of itself when the sample's own error is taken away.
const LEAST_SHARE: f32 = 0.7;

/// Squared error of a sample in the centre over that of what a pixel with such a sample shows.
const LIFTED_TO_SAMPLE: f32 = 2.0;

/// So much of what a sample shows of something smaller than a pixel is the sample's own error.
const OWN_SHARE: f32 = 0.65;

#[derive(Clone, Debug, Default)]
pub struct Gaps {
    /// Light of the pixels that are sampled first, row by row.
    lights: Vec<Vec3A>,
    /// Error that is expected at first of the gaps to the right of and below each of them.
    errors: Vec<f32>,
    /// The same with what is expected next to errors.
    spread: Vec<f32>,
    calibration: Calibration,
}

impl Gaps {
    /// The sampled pixels that a gap lies between, twice the same where it lies between two.
    pub fn corners((width, height): (usize, usize), x: usize, y: usize) -> [usize; 4] {
        let (x0, y0) = (x - x % SPACING, y - y % SPACING);
        let next = |low: usize, at: usize, size: usize| {
            if at > low && low + SPACING < size { low + SPACING } else { low }
        };
        let (x1, y1) = (next(x0, x, width), next(y0, y, height));
        [y0 * width + x0, y0 * width + x1, y1 * width + x0, y1 * width + x1]
    }

    /// Gives gaps the colours that lie between those around them, and what a sample of them may cost. `changed`
    /// tells which pixels have got samples since; gaps whose colours change are added.
    pub fn fill(&mut self, tally: &mut Tally, light: &Light, changed: &mut [bool]) {
        let (width, height) = (tally.width(), tally.height());
        let (columns, rows) = (width.div_ceil(SPACING), height.div_ceil(SPACING));
        self.lights.resize(columns * rows, Vec3A::ZERO);
        self.errors.resize(columns * rows, 0.0);
        for y in 0..rows {
            for x in 0..columns {
                let i = y * SPACING * width + x * SPACING;
                if changed[i] {
                    self.lights[y * columns + x] = light.pixel(&tally.pixels[i].pixel()).into();
                }
            }
        }
        for y in 0..rows {
            for x in 0..columns {
                let (right, below) = ((x + 1).min(columns - 1), (y + 1).min(rows - 1));
                let places = [(x, y), (right, y), (x, below), (right, below)];
                if places.iter().all(|(x, y)| !changed[y * SPACING * width + x * SPACING]) {
                    continue;
                }
                let lights = places.map(|(x, y)| self.lights[y * columns + x]);
                let most = lights.into_iter().fold(Vec3A::NEG_INFINITY, Vec3A::max);
                let least = lights.into_iter().fold(Vec3A::INFINITY, Vec3A::min);
                self.errors[y * columns + x] = DIFFERENCE_TO_ERROR * (most - least).length_squared();
                for (dx, dy) in [(1, 0), (0, 1), (1, 1)] {
                    let (px, py) = (x * SPACING + dx, y * SPACING + dy);
                    let i = py * width + px;
                    if px < width && py < height && tally.pixels[i].count == 0 {
                        tally.pixels[i] = Self::between(tally, px, py);
                        changed[i] = true;
                    }
                }
            }
        }
        self.spread_errors(columns);
    }

    /// Sampled pixels among others that are all alike tell how often there is something small that the others do not
    /// know of: what they show counts for gaps in such places.
    pub fn learn_from_flat_places(&mut self, width: usize) {
        let columns = width.div_ceil(SPACING);
        let rows = self.lights.len() / columns.max(1);
        for y in 1..rows.saturating_sub(1) {
            for x in 1..columns.saturating_sub(1) {
                let own = y * columns + x;
                let first = self.lights[own - columns - 1];
                let alike = |i: usize| (self.lights[i] - first).abs().cmplt(Vec3A::splat(ALIKE)).all();
                let flat = (own - columns - 1..own - columns + 2).all(alike)
                    && alike(own - 1)
                    && alike(own + 1)
                    && (own + columns - 1..own + columns + 2).all(alike);
                if flat {
                    let jump = self.lights[own].distance_squared(first);
                    self.record(FLOOR, jump, OWN_SHARE / LIFTED_TO_SAMPLE * jump);
                }
            }
        }
    }

    /// Lets errors be expected next to where they are.
    fn spread_errors(&mut self, columns: usize) {
        let rows = self.errors.len() / columns;
        let mut wide = vec![0.0f32; self.errors.len()];
        for (wide, errors) in wide.chunks_mut(columns).zip(self.errors.chunks(columns)) {
            for x in 0..columns {
                let near = &errors[x.saturating_sub(1)..(x + 2).min(columns)];
                wide[x] = near.iter().fold(0.0, |a: f32, e| a.max(*e));
            }
        }
        self.spread.resize(self.errors.len(), 0.0);
        for (i, spread) in self.spread.iter_mut().enumerate() {
            let (x, y) = (i % columns, i / columns);
            let near = (y.saturating_sub(1)..(y + 2).min(rows)).map(|y| wide[y * columns + x]);
            *spread = self.errors[i].max(NEXT_TO_ERROR * near.fold(0.0, f32::max));
        }
    }

    fn between(tally: &Tally, x: usize, y: usize) -> Samples {
        let corners = Self::corners((tally.width(), tally.height()), x, y).map(|k| &tally.pixels[k]);
        let mean = |of: &dyn Fn(&Samples) -> f32| 0.25 * corners.iter().map(|s| of(s)).sum::<f32>();
        Samples {
            count: 0,
            mean: std::array::from_fn(|k| mean(&|s| s.mean[k])),
            rays: mean(&|s| s.rays / s.count.max(1) as f32),
            ..Samples::default()
        }
    }

    /// The squared error that is expected of a gap at first.
    pub fn error(&self, width: usize, x: usize, y: usize) -> f32 {
        self.spread[y / SPACING * width.div_ceil(SPACING) + x / SPACING].max(FLOOR)
    }

    /// A gap of which `expected` was expected has been sampled: it was off by the root of `jump`, in which the
    /// sample's `own` error is, less what lifting takes away.
    pub fn record(&mut self, expected: f32, jump: f32, own: f32) {
        let error = (jump - LIFTED_TO_SAMPLE * own).max(LEAST_SHARE * jump);
        self.calibration.record(&Measured { level: 0, expected, error, jump, half_jump: 0.0 });
    }

    pub fn factors(&self) -> Factors {
        self.calibration.factors()
    }

    pub fn class(&self, bin: usize) -> &Class {
        self.calibration.class(0, bin)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::{Gamma, Rgb};
    use crate::picture::Pixel;
    use crate::render::Region;

    /// On a plane of light nothing is wrong inside; the last column and row show their neighbours.
    #[test]
    fn gaps_lie_between_their_neighbours() {
        let mut tally = Tally::new(Region::whole(7, 6));
        let value = |i: usize| 0.1 * (i % 7) as f32 + 0.02 * (i / 7) as f32;
        let sampled = |i: usize| (i % 7).is_multiple_of(SPACING) && (i / 7).is_multiple_of(SPACING);
        for i in (0..42).filter(|&i| sampled(i)) {
            tally.pixels[i] = Samples::of([Pixel::new(Rgb::splat(value(i)), 0.0)].into_iter());
        }
        let light = Light::new(Gamma::Power(1.0));
        let mut gaps = Gaps::default();
        let mut changed = vec![true; 42];
        gaps.fill(&mut tally, &light, &mut changed);
        for i in (0..42).filter(|&i| !sampled(i)) {
            let found = &tally.pixels[i];
            let there = if i / 7 == 5 { value(i - 7) } else { value(i) };
            assert!((found.mean[1] - there).abs() < 1e-6 && found.count == 0, "{i}: {found:?}");
            let (along, down): (f32, f32) =
                (if i % 7 == 6 { 0.0 } else { 0.2 }, if i / 7 >= 4 { 0.0 } else { 0.04 });
            let of = |difference: f32| DIFFERENCE_TO_ERROR * 3.0 * difference.powi(2);
            let expected = of(along + down).max(NEXT_TO_ERROR * of(0.24));
            assert!((gaps.error(7, i % 7, i / 7) - expected).abs() < 1e-6, "{i}");
        }
        // Only the gaps around a pixel that changed are looked at again.
        let mut changed = vec![false; 42];
        changed[2 * 7 + 2] = true;
        gaps.fill(&mut tally, &light, &mut changed);
        assert_eq!(changed.iter().filter(|c| **c).count(), 1 + 4 * 3);
    }

    #[test]
    fn what_turned_up_corrects_what_is_expected() {
        let mut gaps = Gaps::default();
        for i in 0..1000 {
            gaps.record(0.0, if i % 100 == 0 { 0.5 } else { 0.0 }, 0.001);
        }
        let expected = gaps.factors().corrected(0, 0.0);
        assert!((expected / 0.005 - 1.0).abs() < 0.05, "{expected}");
    }
}
