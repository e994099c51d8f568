//! Anti-aliasing method 1: pixels that differ from their left or upper neighbour are divided by a fixed
//! grid, and so is that neighbour.
//!
//! | step | rule |
//! |------|------|
//! | before | the row above the block and the column left of it get one sample each and stay as they are |
//! | compare | with the neighbours' colours as they are by then, averaged or not |
//! | divide | (centre + n² samples) / (n² + 1), shaken by up to 1/n |
//!
//! Pixels are not compared with neighbours to the right or below, nor across blocks.

use super::antialias::{Antialias, Seen};
use super::{Block, Observer, Region, Sampler};
use crate::math::jitter::jitter;
use crate::picture::Pixel;

/// The pixels of one block, row by row.
pub(super) fn trace<S: Sampler>(
    settings: &Antialias,
    block: &Block,
    sampler: &mut S,
    observer: &dyn Observer,
) -> Vec<Pixel> {
    let mut grid = Grid::new(settings, block.region, sampler);
    let r = block.region;
    for x in r.x0..r.x1 {
        grid.border(i64::from(x), i64::from(r.y0) - 1);
    }
    'rows: for y in r.y0..r.y1 {
        grid.border(i64::from(r.x0) - 1, i64::from(y));
        for x in r.x0..r.x1 {
            if observer.cancelled() {
                break 'rows;
            }
            grid.pixel(i64::from(x), i64::from(y));
        }
    }
    let at = |(x, y)| grid.cells[grid.index(i64::from(x), i64::from(y))].seen.pixel;
    block.places().map(at).collect()
}

/// The block with a border row above and a border column to its left.
struct Grid<'a, S> {
    settings: &'a Antialias,
    sampler: &'a mut S,
    region: Region,
    cells: Vec<Cell>,
}

#[derive(Clone, Copy)]
struct Cell {
    seen: Seen,
    /// Whether the pixel has been divided, or must not be.
    done: bool,
}

impl<'a, S: Sampler> Grid<'a, S> {
    fn new(settings: &'a Antialias, region: Region, sampler: &'a mut S) -> Self {
        let n = (region.width() as usize + 1) * (region.height() as usize + 1);
        let cell = Cell { seen: settings.seen(Pixel::NONE), done: false };
        Self { settings, sampler, region, cells: vec![cell; n] }
    }

    fn index(&self, x: i64, y: i64) -> usize {
        let column = (x - (i64::from(self.region.x0) - 1)) as usize;
        let row = (y - (i64::from(self.region.y0) - 1)) as usize;
        row * (self.region.width() as usize + 1) + column
    }

    fn sample(&mut self, x: i64, y: i64, place: (f64, f64), number: u32) -> Pixel {
        self.sampler.seed(x as u32, y as u32, number);
        self.sampler.sample(place.0, place.1)
    }

    /// One sample in the centre of the pixel.
    fn centre(&mut self, x: i64, y: i64, done: bool) {
        let pixel = self.sample(x, y, (x as f64, y as f64), 0);
        let i = self.index(x, y);
        self.cells[i] = Cell { seen: self.settings.seen(pixel), done };
    }

    fn border(&mut self, x: i64, y: i64) {
        self.centre(x, y, true);
    }

    fn pixel(&mut self, x: i64, y: i64) {
        self.centre(x, y, false);
        let cell = |x, y| &self.cells[self.index(x, y)].seen;
        let left = self.settings.differ(cell(x - 1, y), cell(x, y));
        let top = self.settings.differ(cell(x, y - 1), cell(x, y));
        if left {
            self.divide(x - 1, y);
        }
        if top {
            self.divide(x, y - 1);
        }
        if left || top {
            self.divide(x, y);
        }
    }

    /// Replaces a pixel by the mean of its centre and n² samples, once.
    fn divide(&mut self, x: i64, y: i64) {
        let i = self.index(x, y);
        if self.cells[i].done {
            return;
        }
        let n = self.settings.depth;
        let (side, shake) = (f64::from(n), self.settings.jitter / f64::from(n));
        let first = -(0.5 - 0.5 / side);
        let mut sum = self.cells[i].seen.pixel;
        for k in 0..n * n {
            let offset = |j: u32| first + f64::from(j) / side;
            let at = shaken((x as f64 + offset(k % n), y as f64 + offset(k / n)), shake);
            sum = sum + self.sample(x, y, at, k + 1);
        }
        let mean = sum * (1.0 / (n * n + 1) as f32);
        self.cells[i] = Cell { seen: self.settings.seen(mean), done: true };
    }
}

/// A place moved by its own jitter.
pub(super) fn shaken(place: (f64, f64), amount: f64) -> (f64, f64) {
    if amount == 0.0 {
        return place;
    }
    let (jx, jy) = jitter(place.0, place.1);
    (place.0 + amount * jx, place.1 + amount * jy)
}
