//! Where one sample for sixteen pixels is enough to begin with.
//!
//! One pixel of every square of [`SPACING`] pixels is sampled first. Between them light is taken to be straight; how
//! straight it is, second differences at a square's corners tell. Squares where it is not get the samples that gaps
//! ([`super::gaps`]) lie between before anything else is looked at; the others are left wide.

use super::gaps;
use super::order;
use super::plan::Task;
use super::tally::Tally;
use crate::picture::light::Light;
use glam::Vec3A;

/// Every so many pixels along both sides one is sampled first.
pub const SPACING: usize = 4;
/// Squared error of the pixels in a square over the largest squared second difference at its corners, over the
/// channels: 0.02 to 0.04 for differences of 0.03 to 1, measured over six scenes.
const CURVATURE_TO_ERROR: f32 = 0.028;
/// A square is left wide if less than this share of the error that is aimed at is expected of its pixels.
const WIDE_BELOW: f32 = 0.3;

/// The pixels that are sampled first.
#[derive(Clone, Debug, Default)]
pub struct Wide {
    columns: usize,
    rows: usize,
    lights: Vec<Vec3A>,
    /// Squared error expected of a pixel in the square to the right of and below each; of squares that are not left
    /// wide, infinite.
    errors: Vec<f32>,
}

impl Wide {
    /// `aim` is the squared error of a pixel that is aimed at, over its channels.
    pub fn new(tally: &Tally, light: &Light, aim: f32) -> Self {
        let (columns, rows) = (tally.width().div_ceil(SPACING), tally.height().div_ceil(SPACING));
        let sampled = |i: usize| i / columns * SPACING * tally.width() + i % columns * SPACING;
        let lights = (0..columns * rows).map(|i| light.pixel(&tally.pixels[sampled(i)].pixel()).into());
        let mut wide = Self { columns, rows, lights: lights.collect(), errors: Vec::new() };
        wide.errors = wide.expected(WIDE_BELOW * aim);
        wide
    }

    fn expected(&self, most: f32) -> Vec<f32> {
        let curvatures: Vec<f32> = (0..self.lights.len()).map(|i| self.curvature(i)).collect();
        let mut errors = vec![f32::INFINITY; self.lights.len()];
        for y in 0..self.rows.saturating_sub(1) {
            for x in 0..self.columns.saturating_sub(1) {
                let own = y * self.columns + x;
                let below = own + self.columns;
                let upper = curvatures[own].max(curvatures[own + 1]);
                let error = CURVATURE_TO_ERROR * upper.max(curvatures[below]).max(curvatures[below + 1]);
                if error < most {
                    errors[own] = error;
                }
            }
        }
        errors
    }

    /// Squared second differences; where the picture ends on both sides nothing is known of them.
    fn curvature(&self, i: usize) -> f32 {
        let (x, y) = (i % self.columns, i / self.columns);
        let along = |step: usize, at: usize, size: usize| match at {
            _ if size < 3 => f32::INFINITY,
            0 => 0.0,
            _ if at + 1 == size => 0.0,
            _ => (self.lights[i - step] - 2.0 * self.lights[i] + self.lights[i + step]).length_squared(),
        };
        along(1, x, self.columns) + along(self.columns, y, self.rows)
    }

    /// The error expected of pixels around a place, if they are left wide.
    #[inline]
    pub fn error(&self, x: usize, y: usize) -> Option<f32> {
        self.errors.get(y / SPACING * self.columns + x / SPACING).copied().filter(|e| e.is_finite())
    }

    /// Whether any square is left wide.
    pub fn is_any(&self) -> bool {
        self.errors.iter().any(|e| e.is_finite())
    }

    /// The samples between which gaps lie, of squares that are not left wide.
    pub fn tasks(&self, tally: &Tally) -> Vec<Task> {
        let width = tally.width();
        let between = order::spaced(width, tally.height(), gaps::SPACING).into_iter();
        let is_wanted = |&pixel: &u32| {
            let (x, y) = (pixel as usize % width, pixel as usize / width);
            let (on_column, on_row) = (x % SPACING == 0, y % SPACING == 0);
            let is_wide = |x: usize, y: usize| self.error(x, y).is_some();
            let beside = (on_column && !is_wide(x.saturating_sub(1), y))
                || (on_row && !is_wide(x, y.saturating_sub(1)));
            !(on_column && on_row) && (beside || !is_wide(x, y))
        };
        between.filter(is_wanted).map(|pixel| Task::first(pixel, 1)).collect()
    }

    /// Sampled pixels among others that are all alike, in each channel to `alike`: by how much (squared) they stand
    /// out.
    pub fn surprises(&self, alike: f32) -> Vec<f32> {
        let mut found = Vec::new();
        for y in 1..self.rows.saturating_sub(1) {
            for x in 1..self.columns.saturating_sub(1) {
                let own = y * self.columns + x;
                let (above, below) = (own - self.columns, own + self.columns);
                let first = self.lights[above - 1];
                let is_alike = |i: usize| (self.lights[i] - first).abs().cmplt(Vec3A::splat(alike)).all();
                let flat = (above - 1..above + 2).all(is_alike)
                    && is_alike(own - 1)
                    && is_alike(own + 1)
                    && (below - 1..below + 2).all(is_alike);
                if flat {
                    found.push(self.lights[own].distance_squared(first));
                }
            }
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::{Gamma, Rgb};
    use crate::picture::Pixel;
    use crate::render::Region;
    use crate::render::adaptive::tally::Samples;

    fn wide(width: u32, height: u32, color: impl Fn(usize, usize) -> f32) -> (Tally, Wide) {
        let mut tally = Tally::new(Region::whole(width, height));
        for i in 0..tally.pixels.len() {
            let (x, y) = (i % width as usize, i / width as usize);
            if x % SPACING == 0 && y % SPACING == 0 {
                tally.pixels[i] = Samples::of([Pixel::new(Rgb::splat(color(x, y)), 0.0)].into_iter());
            }
        }
        let wide = Wide::new(&tally, &Light::new(Gamma::Power(1.0)), 3e-4);
        (tally, wide)
    }

    /// On a plane of light only what lies beyond the last samples is looked at closer.
    #[test]
    fn planes_are_left_wide() {
        let (tally, wide) = wide(18, 14, |x, y| 0.02 * x as f32 + 0.01 * y as f32);
        assert!(wide.error(15, 11).is_some_and(|e| e < 1e-9));
        assert_eq!((wide.error(16, 0), wide.error(0, 12)), (None, None));
        let tasks: Vec<u32> = wide.tasks(&tally).iter().map(|t| t.pixel).collect();
        assert!(tasks.iter().all(|p| p % 18 == 16 || p / 18 >= 12), "{tasks:?}");
        assert_eq!(tasks.len(), 3 + 4);
    }

    /// An edge between columns 7 and 8: the squares beside it and those next to them are not left wide.
    #[test]
    fn edges_are_looked_at_closer() {
        let (tally, wide) = wide(33, 17, |x, _| if x < 8 { 0.0 } else { 0.5 });
        let widths: Vec<bool> = (0..8).map(|k| wide.error(4 * k, 0).is_some()).collect();
        assert_eq!(widths, [false, false, false, true, true, true, true, true]);
        let tasks = wide.tasks(&tally);
        let inside = tasks.iter().filter(|t| t.pixel % 33 < 32 && t.pixel / 33 < 16);
        assert!(inside.clone().all(|t| t.pixel % 33 <= 12));
        assert_eq!(inside.count(), 7 * 8 - 4 * 4);
    }

    #[test]
    fn small_pictures_are_not_left_wide() {
        let (tally, wide) = wide(5, 3, |_, _| 0.5);
        assert_eq!(wide.tasks(&tally).len(), 3 * 2 - 2);
        assert!(wide.surprises(0.1).is_empty());
    }

    #[test]
    fn what_stands_out_is_a_surprise() {
        let (_, wide) = wide(33, 33, |x, y| if (x, y) == (16, 16) { 0.5 } else { 0.25 });
        let surprises = wide.surprises(1e-3);
        assert_eq!(surprises.len(), 49 - 8);
        assert!((surprises.iter().sum::<f32>() - 3.0 * 0.0625).abs() < 1e-6);
    }
}
