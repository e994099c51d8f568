//! Anti-aliasing method 2: a pixel is the mean of its corners; where they differ, of its quarters.
//!
//! With depth L a pixel is a grid of S+1 by S+1 places, S = 2^L, and is divided L-1 times at most. The four
//! corners are shared with the neighbours inside a block and not shaken; the other places belong to one
//! pixel and are shaken by up to 1/(S+1). No sample is taken in the middle of a pixel that is not divided.

use super::antialias::{Antialias, Seen};
use super::grid::shaken;
use super::{Block, Observer, Region, Sampler};
use crate::picture::Pixel;

/// The pixels of one block, row by row.
pub(super) fn trace<S: Sampler>(
    settings: &Antialias,
    block: &Block,
    sampler: &mut S,
    observer: &dyn Observer,
) -> Vec<Pixel> {
    let mut pixels = block.unfinished();
    let side = (1usize << settings.depth) + 1;
    let mut tracer = Recursion {
        settings,
        sampler,
        corners: Corners::new(block.region),
        places: vec![None; side * side],
        side,
        pixel: (0, 0),
    };
    for (i, (x, y)) in block.places().enumerate() {
        if observer.cancelled() {
            break;
        }
        pixels[i] = tracer.trace_pixel(x, y);
    }
    pixels
}

/// Samples at the corners of the block's pixels, as far as they are known.
struct Corners {
    region: Region,
    seen: Vec<Option<Seen>>,
}

impl Corners {
    fn new(region: Region) -> Self {
        let n = (region.width() as usize + 1) * (region.height() as usize + 1);
        Self { region, seen: vec![None; n] }
    }

    /// The place of the upper left corner of pixel (x, y).
    fn index(&self, x: u32, y: u32) -> usize {
        (y - self.region.y0) as usize * (self.region.width() as usize + 1) + (x - self.region.x0) as usize
    }
}

struct Recursion<'a, S> {
    settings: &'a Antialias,
    sampler: &'a mut S,
    corners: Corners,
    /// Samples of the current pixel's grid.
    places: Vec<Option<Seen>>,
    /// Places along a side of the grid.
    side: usize,
    pixel: (u32, u32),
}

/// A square of the current pixel's grid.
#[derive(Clone, Copy)]
struct Square {
    x: usize,
    y: usize,
    size: usize,
}

impl<S: Sampler> Recursion<'_, S> {
    fn trace_pixel(&mut self, x: u32, y: u32) -> Pixel {
        self.pixel = (x, y);
        self.places.fill(None);
        let last = self.side - 1;
        for (column, row) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            let seen = self.corner(x + column, y + row);
            self.places[row as usize * last * self.side + column as usize * last] = Some(seen);
        }
        self.mean(Square { x: 0, y: 0, size: last }, self.settings.depth - 1)
    }

    /// The sample at the upper left corner of pixel (x, y).
    fn corner(&mut self, x: u32, y: u32) -> Seen {
        let i = self.corners.index(x, y);
        if let Some(seen) = self.corners.seen[i] {
            return seen;
        }
        self.sampler.seed(x, y, 0);
        let pixel = self.sampler.sample(f64::from(x) - 0.5, f64::from(y) - 0.5);
        let seen = self.settings.seen(pixel);
        self.corners.seen[i] = Some(seen);
        seen
    }

    /// The sample at a place of the current pixel's grid.
    fn place(&mut self, column: usize, row: usize) -> Seen {
        let i = row * self.side + column;
        if let Some(seen) = self.places[i] {
            return seen;
        }
        let (x, y) = self.pixel;
        let at = |pixel: u32, place: usize| f64::from(pixel) - 0.5 + place as f64 / (self.side - 1) as f64;
        let shake = self.settings.jitter / self.side as f64;
        let (px, py) = shaken((at(x, column), at(y, row)), shake);
        self.sampler.seed(x, y, i as u32);
        let seen = self.settings.seen(self.sampler.sample(px, py));
        self.places[i] = Some(seen);
        seen
    }

    fn mean(&mut self, square: Square, level: u32) -> Pixel {
        let Square { x, y, size } = square;
        let corners = [(0, 0), (size, 0), (0, size), (size, size)].map(|(i, j)| self.place(x + i, y + j));
        if level == 0 || !self.any_differ(&corners) {
            return mean_of(corners.map(|c| c.pixel));
        }
        let half = size / 2;
        let quarters = [(0, 0), (half, 0), (0, half), (half, half)];
        mean_of(quarters.map(|(i, j)| self.mean(Square { x: x + i, y: y + j, size: half }, level - 1)))
    }

    fn any_differ(&self, c: &[Seen; 4]) -> bool {
        let pairs = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];
        pairs.iter().any(|&(i, j)| self.settings.differ(&c[i], &c[j]))
    }
}

fn mean_of(pixels: [Pixel; 4]) -> Pixel {
    let [a, b, c, d] = pixels;
    (a + b + c + d) * 0.25
}
