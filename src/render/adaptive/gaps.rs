//! Pixels between sampled ones, where a picture may have fewer samples than pixels.
//!
//! At first one pixel of every square of [`SPACING`] pixels is sampled, or of larger squares where light is straight
//! ([`super::wide`]). The others show what lies between those around them. How wrong that is is told by how much
//! these differ, and is held to account like any other expectation ([`super::calibration`]): gaps picked by chance
//! are sampled, and what turns up corrects what is expected of their class, of those among sampled pixels that are
//! all alike as well.

use super::calibration::{Calibration, Class, FLOOR, Measured};
use super::estimate::{ALIKE, Expected};
use super::plan::Task;
use super::tally::{Samples, Tally};
use super::wide::{self, Wide};
use crate::picture::light::Light;
use glam::{Vec3A, Vec4};

/// Every so many pixels along both sides one is sampled first.
pub const SPACING: usize = 2;
/// Kinds of gaps: between neighbours of neighbours, and in squares that were left wide.
pub const KINDS: usize = 2;
/// The error that is expected of a gap before any was measured, over the squared difference of the pixels that it lies
/// between,
const DIFFERENCE_TO_ERROR: f32 = 0.1;
/// over that of the others of its square, for which an edge may bulge,
const SQUARE_TO_ERROR: f32 = DIFFERENCE_TO_ERROR / 8.0;
/// and over that of the squares around.
const NEXT_TO_ERROR: f32 = DIFFERENCE_TO_ERROR / 32.0;
/// A measured difference counts for at least this share of itself when the sample's own error is taken away.
const LEAST_SHARE: f32 = 0.7;
/// Squared error of a sample in the centre over that of what a pixel with such a sample shows.
const LIFTED_TO_SAMPLE: f32 = 2.0;
/// So much of what a sample shows of something smaller than a pixel is the sample's own error.
const OWN_SHARE: f32 = 0.65;
/// In a square left wide a sample between two that are not there yet is put off as if it cost so much more.
const PUT_OFF: f32 = 8.0;

#[derive(Clone, Debug, Default)]
pub struct Gaps {
    wide: Wide,
    /// Which pixels lie in squares that were left wide.
    is_wide: Vec<bool>,
    /// Light of the pixels that gaps lie between, row by row.
    lights: Vec<Vec3A>,
    /// Squared differences in the squares to the right of and below each of them,
    differences: Vec<f32>,
    /// and the largest there and around.
    near: Vec<f32>,
    calibration: Calibration,
}

impl Gaps {
    /// The first look, when every [`wide::SPACING`]th pixel is sampled: what is to be sampled besides. `aim` is the
    /// squared error of a pixel that is aimed at, over its channels.
    pub fn begin(&mut self, tally: &Tally, light: &Light, aim: f32) -> Vec<Task> {
        self.wide = Wide::new(tally, light, aim);
        self.is_wide = Vec::with_capacity(tally.pixels.len());
        for y in 0..tally.height() {
            self.is_wide.extend((0..tally.width()).map(|x| self.wide.error(x, y).is_some()));
        }
        // Sampled pixels among others that are all alike tell how often there is something small that the others do
        // not know of.
        for jump in self.wide.surprises(ALIKE) {
            for kind in 0..KINDS {
                self.record(kind, FLOOR, jump, OWN_SHARE / LIFTED_TO_SAMPLE * jump);
            }
        }
        self.wide.tasks(tally)
    }

    /// Gives gaps the colours that lie between those around them, and what a sample of them may cost. `changed`
    /// tells which pixels have got samples since; gaps whose colours change are added.
    pub fn fill(&mut self, tally: &mut Tally, light: &Light, changed: &mut [bool]) {
        fill_between(tally, changed, wide::SPACING, 1.0);
        self.look(tally, light, changed);
        fill_between(tally, changed, SPACING, PUT_OFF);
    }

    /// Looks at the pixels that gaps lie between.
    fn look(&mut self, tally: &Tally, light: &Light, changed: &[bool]) {
        let grid = Grid::new(tally, SPACING);
        self.lights.resize(grid.columns * grid.rows, Vec3A::ZERO);
        self.differences.resize(grid.columns * grid.rows, 0.0);
        for y in 0..grid.rows {
            for x in 0..grid.columns {
                let i = grid.pixel(x, y);
                if changed[i] {
                    self.lights[y * grid.columns + x] = light.pixel(&tally.pixels[i].pixel()).into();
                }
            }
        }
        for y in 0..grid.rows {
            let row = y * grid.columns;
            let below = (y + 1).min(grid.rows - 1) * grid.columns;
            for x in 0..grid.columns {
                let right = (x + 1).min(grid.columns - 1);
                let (a, b) = (self.lights[row + x], self.lights[row + right]);
                let (c, d) = (self.lights[below + x], self.lights[below + right]);
                let most = a.max(b).max(c.max(d));
                let least = a.min(b).min(c.min(d));
                self.differences[row + x] = (most - least).length_squared();
            }
        }
        self.near = spread(&self.differences, grid.columns);
    }

    /// Gives gaps what is expected of them, where it is known of the others.
    pub fn expect(&self, tally: &Tally, expected: &mut [Expected]) {
        let factors = self.calibration.factors();
        let grid = Grid::new(tally, SPACING);
        // Where a sample is missing between which others lie, what it would be off by is known first.
        if self.wide.is_any() {
            let coarse = Grid::new(tally, wide::SPACING);
            coarse.each_gap(tally, |i, places, (dx, dy)| {
                let known = places.map(|i| expected[i].variance);
                let (x, y) = ((i % grid.width) / SPACING, i / grid.width / SPACING);
                let own = y * grid.columns + x;
                let wide = self.wide.error(i % grid.width, i / grid.width);
                let plain = self.plain(0.0, own).max(wide.unwrap_or(0.0));
                let variance = factors.corrected(1, plain);
                expected[i] = Expected { plain, local: between(&known, dx, dy), variance };
            });
        }
        for y in 0..grid.rows {
            for x in 0..grid.columns {
                let places = grid.corners(x, y);
                let own = y * grid.columns + x;
                let right = if x + 1 < grid.columns { own + 1 } else { own };
                let below = if y + 1 < grid.rows { own + grid.columns } else { own };
                let wide = self.wide.error(x * SPACING, y * SPACING);
                let kind = usize::from(wide.is_some());
                let of = |i: usize| match tally.pixels[i].count {
                    0 => expected[i].local,
                    _ => expected[i].variance,
                };
                let known = [of(places[0]), of(places[1]), of(places[2]), of(places[3])];
                let light = self.lights[own];
                for (dx, dy) in [(1, 0), (0, 1), (1, 1)] {
                    let Some(i) = grid.gap(x, y, dx, dy).filter(|&i| tally.pixels[i].count == 0) else {
                        continue;
                    };
                    let pair = match (dx, dy) {
                        (1, 0) => light.distance_squared(self.lights[right]),
                        (0, 1) => light.distance_squared(self.lights[below]),
                        _ => self.differences[own],
                    };
                    let plain = self.plain(pair, own).max(wide.unwrap_or(0.0));
                    let variance = factors.corrected(kind, plain);
                    expected[i] = Expected { plain, local: between(&known, dx, dy), variance };
                }
            }
        }
    }

    fn plain(&self, pair: f32, square: usize) -> f32 {
        let around = SQUARE_TO_ERROR * self.differences[square] + NEXT_TO_ERROR * self.near[square];
        (DIFFERENCE_TO_ERROR * pair + around).max(FLOOR)
    }

    /// A gap of which `expected` was expected has been sampled: it was off by the root of `jump`, in which the
    /// sample's `own` error is, less what lifting takes away.
    pub fn record(&mut self, kind: usize, expected: f32, jump: f32, own: f32) {
        let error = (jump - LIFTED_TO_SAMPLE * own).max(LEAST_SHARE * jump);
        self.calibration.record(&Measured { level: kind, expected, error, jump, half_jump: 0.0 });
    }

    /// Whether a pixel lies in a square that was left wide.
    pub fn is_wide(&self, pixel: usize) -> bool {
        self.is_wide.get(pixel).is_some_and(|w| *w)
    }

    pub fn class(&self, kind: usize, bin: usize) -> &Class {
        self.calibration.class(kind, bin)
    }
}

/// Every so many pixels along both sides one.
#[derive(Clone, Copy)]
struct Grid {
    spacing: usize,
    width: usize,
    height: usize,
    columns: usize,
    rows: usize,
}

impl Grid {
    fn new(tally: &Tally, spacing: usize) -> Self {
        let (width, height) = (tally.width(), tally.height());
        Self { spacing, width, height, columns: width.div_ceil(spacing), rows: height.div_ceil(spacing) }
    }

    #[inline(always)]
    fn pixel(&self, x: usize, y: usize) -> usize {
        (y * self.width + x) * self.spacing
    }

    /// The pixels of the grid that the gaps to the right of and below one lie between: itself, that to the right,
    /// that below and that across, or itself again where the grid ends.
    #[inline(always)]
    fn corners(&self, x: usize, y: usize) -> [usize; 4] {
        let (right, below) = ((x + 1).min(self.columns - 1), (y + 1).min(self.rows - 1));
        [self.pixel(x, y), self.pixel(right, y), self.pixel(x, below), self.pixel(right, below)]
    }

    /// The pixel half a spacing to the right or below, if it lies in the picture.
    #[inline(always)]
    fn gap(&self, x: usize, y: usize, dx: usize, dy: usize) -> Option<usize> {
        let half = self.spacing / 2;
        let (px, py) = (x * self.spacing + dx * half, y * self.spacing + dy * half);
        (px < self.width && py < self.height).then_some(py * self.width + px)
    }

    /// All gaps of a grid, with the pixels that they lie between.
    fn each_gap(&self, tally: &Tally, mut visit: impl FnMut(usize, [usize; 4], (usize, usize))) {
        for y in 0..self.rows {
            for x in 0..self.columns {
                for (dx, dy) in [(1, 0), (0, 1), (1, 1)] {
                    if let Some(i) = self.gap(x, y, dx, dy).filter(|&i| tally.pixels[i].count == 0) {
                        visit(i, self.corners(x, y), (dx, dy));
                    }
                }
            }
        }
    }
}

/// Gives the gaps of a grid their colours, where those around them changed.
fn fill_between(tally: &mut Tally, changed: &mut [bool], spacing: usize, put_off: f32) {
    let grid = Grid::new(tally, spacing);
    for y in 0..grid.rows {
        for x in 0..grid.columns {
            let [a, b, c, d] = grid.corners(x, y);
            if !(changed[a] || changed[b] || changed[c] || changed[d]) {
                continue;
            }
            let of = |i: usize| Corner::of(&tally.pixels[i]);
            let corners = [of(a), of(b), of(c), of(d)];
            for (dx, dy) in [(1, 0), (0, 1), (1, 1)] {
                if let Some(i) = grid.gap(x, y, dx, dy).filter(|&i| tally.pixels[i].count == 0) {
                    tally.pixels[i] = Corner::between(&corners, dx, dy, put_off);
                    changed[i] = true;
                }
            }
        }
    }
}

/// The largest of each value and those around it.
fn spread(values: &[f32], columns: usize) -> Vec<f32> {
    let mut wide = values.to_vec();
    for (wide, values) in wide.chunks_mut(columns).zip(values.chunks(columns)) {
        for x in 1..columns {
            wide[x] = wide[x].max(values[x - 1]);
            wide[x - 1] = wide[x - 1].max(values[x]);
        }
    }
    let mut all = wide.clone();
    for i in columns..all.len() {
        all[i] = all[i].max(wide[i - columns]);
        all[i - columns] = all[i - columns].max(wide[i]);
    }
    all
}

/// A pixel as the gaps around it see it.
#[derive(Clone, Copy)]
struct Corner {
    mean: Vec4,
    /// Rays for a sample.
    rays: f32,
    sampled: bool,
}

impl Corner {
    #[inline(always)]
    fn of(samples: &Samples) -> Self {
        let rays = samples.rays / samples.count.max(1) as f32;
        Self { mean: Vec4::from_array(samples.mean), rays, sampled: samples.count > 0 }
    }

    /// What a gap shows, and what a sample of it may cost.
    #[inline(always)]
    fn between([a, b, c, d]: &[Corner; 4], dx: usize, dy: usize, put_off: f32) -> Samples {
        let mean = between(&[a.mean, b.mean, c.mean, d.mean], dx, dy).to_array();
        let rays = between(&[a.rays, b.rays, c.rays, d.rays], dx, dy);
        let all = a.sampled && b.sampled && c.sampled && d.sampled;
        Samples { count: 0, mean, rays: if all { rays } else { put_off * rays }, ..Samples::default() }
    }
}

/// The mean of those corners of a square that a gap lies between: of two, or of four in the middle.
#[inline(always)]
fn between<V>(corners: &[V; 4], dx: usize, dy: usize) -> V
where
    V: Copy + std::ops::Add<Output = V> + std::ops::Mul<f32, Output = V>,
{
    let [own, right, below, across] = *corners;
    match (dx, dy) {
        (0, _) => (own + below) * 0.5,
        (_, 0) => (own + right) * 0.5,
        _ => ((own + right) + (below + across)) * 0.25,
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
        let known = |i: usize| if sampled(i) { 0.25 } else { 0.0 };
        let mut errors: Vec<Expected> =
            (0..42).map(|i| Expected { variance: known(i), ..Expected::default() }).collect();
        gaps.expect(&tally, &mut errors);
        for i in (0..42).filter(|&i| !sampled(i)) {
            let (x, y) = (i % 7, i / 7);
            let found = &tally.pixels[i];
            let there = if y == 5 { value(i - 7) } else { value(i) };
            assert!((found.mean[1] - there).abs() < 1e-6 && found.count == 0, "{i}: {found:?}");
            let along: f32 = if x == 6 { 0.0 } else { 0.2 };
            let down: f32 = if y >= 4 { 0.0 } else { 0.04 };
            let of = |difference: f32| 3.0 * difference.powi(2);
            let pair = of(if x % 2 == 1 { along } else { 0.0 } + if y % 2 == 1 { down } else { 0.0 });
            let expected =
                DIFFERENCE_TO_ERROR * pair + SQUARE_TO_ERROR * of(along + down) + NEXT_TO_ERROR * of(0.24);
            assert!((errors[i].plain - expected).abs() < 1e-6, "{i}");
            assert!((errors[i].local - 0.25).abs() < 1e-6, "{i}");
        }
        // Only the gaps around a pixel that changed are looked at again.
        let mut changed = vec![false; 42];
        changed[2 * 7 + 2] = true;
        gaps.fill(&mut tally, &light, &mut changed);
        assert_eq!(changed.iter().filter(|c| **c).count(), 1 + 4 * 3);
    }

    /// Squares that were left wide show a plane as well.
    #[test]
    fn wide_squares_are_filled() {
        let mut tally = Tally::new(Region::whole(17, 13));
        let value = |i: usize| 0.01 * (i % 17) as f32 + 0.02 * (i / 17) as f32;
        for i in (0..17 * 13).filter(|i| (i % 17) % 4 == 0 && (i / 17) % 4 == 0) {
            tally.pixels[i] = Samples::of([Pixel::new(Rgb::splat(value(i)), 0.0)].into_iter());
        }
        let light = Light::new(Gamma::Power(1.0));
        let mut gaps = Gaps::default();
        let tasks = gaps.begin(&tally, &light, 3e-4);
        assert!(tasks.iter().all(|t| t.pixel % 17 == 16 || t.pixel / 17 == 12));
        let mut changed = vec![true; 17 * 13];
        gaps.fill(&mut tally, &light, &mut changed);
        for i in 0..17 * 13 {
            assert!((tally.pixels[i].mean[0] - value(i)).abs() < 1e-6, "{i}");
        }
        assert!(gaps.is_wide(3) && !gaps.is_wide(16));
        let mut expected = vec![Expected { variance: 1e-4, ..Expected::default() }; 17 * 13];
        gaps.expect(&tally, &mut expected);
        assert!((expected[3].local - 1e-4).abs() < 1e-9, "{:?}", expected[3]);
    }

    #[test]
    fn what_turned_up_corrects_what_is_expected() {
        let mut gaps = Gaps::default();
        for i in 0..1000 {
            gaps.record(0, 0.0, if i % 100 == 0 { 0.5 } else { 0.0 }, 0.001);
        }
        let expected = gaps.calibration.factors().corrected(0, 0.0);
        assert!((expected / 0.005 - 1.0).abs() < 0.05, "{expected}");
    }
}
