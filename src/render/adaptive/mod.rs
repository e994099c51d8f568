//! Error-driven sampling: samples go where they take most error away for the rays that they cost.
//!
//! | step | rule |
//! |------|------|
//! | base | every pixel gets one sample, or a few; where that may be too many, every fourth (`gaps`) or sixteenth (`wide`) |
//! | survey | what error is each pixel's mean expected to have (`estimate`, `calibration`)? |
//! | plan | how far do samples have to be doubled, and where, to reach the target or to spend nearly as much again (`plan`)? |
//! | round | every pixel of the plan is doubled once; so are a few others, to hold expectations to account |
//!
//! Survey, plan and round repeat until the picture's expected error is below the target. A round's work
//! depends on earlier rounds alone, and a pixel's samples on pixel, seed and number alone, so that the
//! picture is the same whatever the number of threads. Work is begun in a fixed order: a render that time
//! ended after N samples is repeated by allowing N samples.
//!
//! The filter is the box of one pixel. Means of few samples are lifted towards their neighbours' (`lift`), which
//! know of the same edges.

mod calibration;
mod coarse;
mod convergence;
mod estimate;
mod gaps;
mod lift;
mod locality;
mod order;
mod plan;
mod sequence;
mod state;
mod tally;
mod wide;

pub use sequence::{Sequence, mix};

use super::{Observer, Region, Sampler};
use crate::picture::Picture;
use crate::picture::light::Light;
use state::State;
use std::sync::Mutex;

/// What is rendered, and how well.
#[derive(Clone, Debug)]
pub struct Adaptive {
    pub region: Region,
    pub light: Light,
    /// RMSE in light at which the picture is good enough.
    pub target: Option<f64>,
    /// Samples of the whole picture after which it ends.
    pub max_samples: Option<u64>,
    /// The clock's time at which it ends.
    pub deadline: Option<f64>,
    /// Samples that every pixel gets; rounded up to a power of two other than 2.
    pub base: u32,
    /// Whether pixels may go without any where those around them tell enough (`gaps`): then a base of 1 is for one
    /// pixel in four only.
    pub sparse: bool,
    /// Pictures with different seeds share no random numbers.
    pub seed: u32,
}

impl Adaptive {
    /// A target for those who name none: 40 dB, which most scenes reach in the time of method 1 or little more.
    pub const TARGET: f64 = 0.01;
    /// Samples a pixel after which those who name no target have enough: about what method 1 spends at most.
    pub const MOST_PER_PIXEL: f64 = 9.0;

    pub fn new(region: Region, light: Light) -> Self {
        Self {
            region,
            light,
            target: Some(Self::TARGET),
            max_samples: None,
            deadline: None,
            base: 1,
            sparse: false,
            seed: 0,
        }
    }

    fn has_gaps(&self) -> bool {
        self.sparse && self.base <= 1 && !self.is_limited()
    }

    /// Whether it may end before every pixel has a sample.
    fn is_limited(&self) -> bool {
        self.max_samples.is_some() || self.deadline.is_some()
    }
}

/// Tells the time.
pub trait Clock: Sync {
    /// Seconds since some moment in the past.
    fn seconds(&self) -> f64;
}

/// For renders without a deadline.
pub struct NoClock;

impl Clock for NoClock {
    fn seconds(&self) -> f64 {
        0.0
    }
}

/// Why a render ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ended {
    /// The target was reached, or no pixel can be improved.
    Converged,
    /// All samples were spent.
    Samples,
    /// Time was up.
    Time,
    /// The observer wanted no more.
    Cancelled,
}

/// What a render came to.
#[derive(Debug)]
pub struct Outcome<S> {
    pub samplers: Vec<S>,
    pub ended: Ended,
    pub samples: u64,
    pub rounds: u32,
    /// RMSE in light that the picture is expected to have; `None` if some pixels were never sampled and
    /// show their neighbours' colours.
    pub rmse: Option<f64>,
}

/// Fills the picture's region; other threads may look at the picture meanwhile.
pub fn render<S: Sampler + Send>(
    settings: &Adaptive,
    pool: &rayon::ThreadPool,
    picture: &Mutex<Picture>,
    observer: &dyn Observer,
    clock: &dyn Clock,
    sampler: impl Fn() -> S + Sync,
) -> Outcome<S> {
    let samplers = (0..pool.current_num_threads()).map(|_| Mutex::new(sampler())).collect();
    let mut state = State::new(settings, pool, picture, observer, clock, samplers);
    let (ended, rmse) = state.run();
    Outcome { ended, rmse, samples: state.samples(), rounds: state.rounds(), samplers: state.into_samplers() }
}

#[cfg(test)]
mod tests;
