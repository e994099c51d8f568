//! The world to a picture: blocks shared out over threads, anti-aliasing, progress.
//!
//! Every block depends on itself alone, and every sample on its place, so that the picture is the same
//! whatever the number of threads.

pub mod adaptive;
mod antialias;
mod block;
mod gathering;
mod grid;
mod indirect;
mod recursive;
mod sampler;
#[cfg(test)]
pub(crate) mod synthetic;

pub use antialias::{Antialias, Method};
pub use block::{Block, blocks};
pub use indirect::indirect;

use crate::picture::{Picture, Pixel};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Answers for places on the picture; one per thread.
pub trait Sampler {
    /// Random draws of the next sample depend on these numbers alone.
    fn seed(&mut self, x: u32, y: u32, sample: u32);

    /// The colour at a picture position; pixel (i, j) has its centre at (i, j).
    fn sample(&mut self, x: f64, y: f64) -> Pixel;

    /// A block of that number begins: what is kept from sample to sample depends on it alone.
    fn begin_block(&mut self, _serial: usize) {}

    /// Rays followed so far, for progress.
    fn rays(&self) -> u64;
}

/// Told about a render while it runs, from all threads.
pub trait Observer: Sync {
    /// Asked before every pixel; once true the render ends as it stands.
    fn cancelled(&self) -> bool {
        false
    }

    /// A block of so many pixels is finished, for which so many rays were followed.
    fn block_done(&self, _pixels: u64, _rays: u64) {}

    /// After so many samples the whole picture is expected to have this RMSE in light. Only adaptive
    /// rendering tells.
    fn surveyed(&self, _samples: u64, _rmse: f64) {}
}

/// Watches nothing.
pub struct Unobserved;

impl Observer for Unobserved {}

/// A rectangle of pixels: columns x0..x1, rows y0..y1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Region {
    pub x0: u32,
    pub y0: u32,
    pub x1: u32,
    pub y1: u32,
}

impl Region {
    pub fn whole(width: u32, height: u32) -> Self {
        Self { x0: 0, y0: 0, x1: width, y1: height }
    }

    pub fn width(&self) -> u32 {
        self.x1 - self.x0
    }

    pub fn height(&self) -> u32 {
        self.y1 - self.y0
    }

    pub fn pixels(&self) -> u64 {
        u64::from(self.width()) * u64::from(self.height())
    }
}

/// What is rendered, and how finely.
#[derive(Clone, Debug)]
pub struct Settings {
    pub region: Region,
    pub antialias: Option<Antialias>,
    /// Side of a block; anti-aliasing looks at neighbours inside one block.
    pub block_size: u32,
}

impl Settings {
    pub const BLOCK_SIZE: u32 = 32;

    pub fn new(width: u32, height: u32) -> Self {
        Self { region: Region::whole(width, height), antialias: None, block_size: Self::BLOCK_SIZE }
    }
}

/// Fills the picture's region; other threads may look at the picture meanwhile. Gives back the samplers,
/// one per thread of the pool, for what they counted.
pub fn render<S: Sampler + Send>(
    settings: &Settings,
    pool: &rayon::ThreadPool,
    picture: &Mutex<Picture>,
    observer: &dyn Observer,
    sampler: impl Fn() -> S + Sync,
) -> Vec<S> {
    let blocks = blocks(settings.region, settings.block_size);
    let next = AtomicUsize::new(0);
    pool.broadcast(|_| {
        let mut sampler = sampler();
        loop {
            let serial = next.fetch_add(1, Ordering::Relaxed);
            let Some(block) = blocks.get(serial) else { break };
            if observer.cancelled() {
                break;
            }
            let before = sampler.rays();
            sampler.begin_block(serial);
            let pixels = trace_block(settings, block, &mut sampler, observer);
            store(picture, block, &pixels);
            observer.block_done(block.region.pixels(), sampler.rays() - before);
        }
        sampler
    })
}

/// The pixels of one block, row by row.
fn trace_block<S: Sampler>(
    settings: &Settings,
    block: &Block,
    sampler: &mut S,
    observer: &dyn Observer,
) -> Vec<Pixel> {
    match &settings.antialias {
        None => centres(block, sampler, observer),
        Some(a) if a.method == Method::Grid => grid::trace(a, block, sampler, observer),
        Some(a) => recursive::trace(a, block, sampler, observer),
    }
}

/// One sample in the middle of each pixel.
fn centres<S: Sampler>(block: &Block, sampler: &mut S, observer: &dyn Observer) -> Vec<Pixel> {
    let mut pixels = block.unfinished();
    for (i, (x, y)) in block.places().enumerate() {
        if observer.cancelled() {
            break;
        }
        sampler.seed(x, y, 0);
        pixels[i] = sampler.sample(f64::from(x), f64::from(y));
    }
    pixels
}

fn store(picture: &Mutex<Picture>, block: &Block, pixels: &[Pixel]) {
    // A thread that panicked cannot have left a pixel half written.
    let mut picture = picture.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    for ((x, y), p) in block.places().zip(pixels) {
        picture.set(x, y, *p);
    }
}

#[cfg(test)]
mod tests;
