//! What each setting costs in time, and what error it leaves: the trade, measured on a scene.
//!
//! [`sweep`] renders a converged reference and then the scene over a grid of settings, [`front`] tells which
//! of them are beaten by none, [`report`] draws the result. The scene is a [`Subject`] and time is a
//! [`Stopwatch`], so that all of this is tested on known pictures and an invented clock.

pub mod front;
mod grid;
pub mod report;
pub mod sweep;

pub use grid::{Axes, Axis, RadiosityAxes, grid};

use crate::picture::light::Light;
use crate::picture::{Encoding, Picture};
use crate::render::Method;
use crate::render::adaptive::Clock;
use crate::trace::Overrides;
use serde::Serialize;
use serde::ser::{SerializeMap, Serializer};
use std::fmt::Write;

/// How pixels are sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sampling {
    /// One sample in the middle of each pixel.
    Centre,
    /// Methods 1 and 2.
    Fixed { method: Method, threshold: f32, depth: u32 },
    /// Until the picture is expected to have this RMSE in light.
    Adaptive { max_error: f64 },
}

/// One way to render the scene. What is `None` is left as the scene has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Knobs {
    pub sampling: Sampling,
    pub overrides: Overrides,
}

impl Knobs {
    pub fn new(sampling: Sampling) -> Self {
        Self { sampling, overrides: Overrides::default() }
    }

    /// The options of `glint render` that stand for them.
    pub fn words(&self) -> Vec<String> {
        let mut words = match self.sampling {
            Sampling::Centre => Vec::new(),
            Sampling::Fixed { method, threshold, depth } => vec![
                format!("-A={threshold}"),
                format!("--aa-method={}", method.number()),
                format!("--aa-depth={depth}"),
            ],
            Sampling::Adaptive { max_error } => vec![format!("--max-error={max_error}")],
        };
        words.extend(self.replaced().map(|(what, value)| format!("--{}={value}", what.replace('_', "-"))));
        words
    }

    /// For people.
    pub fn name(&self) -> String {
        let mut name = match self.sampling {
            Sampling::Centre => "no anti-aliasing".to_owned(),
            Sampling::Fixed { method, threshold, depth } => {
                format!("method {}, threshold {threshold}, depth {depth}", method.number())
            }
            Sampling::Adaptive { max_error } => format!("adaptive, error {max_error}"),
        };
        for (what, value) in self.replaced() {
            let _ = write!(name, ", {} {value}", what.replace('_', " "));
        }
        name
    }

    /// What replaces words of the scene, by its name.
    fn replaced(&self) -> impl Iterator<Item = (&'static str, f64)> {
        let o = &self.overrides;
        // As written, not as single precision has it.
        let bailout = o.adc_bailout.map(|b| b.to_string().parse().unwrap_or(f64::from(b)));
        let all = [
            ("trace_level", o.max_trace_level.map(f64::from)),
            ("adc_bailout", bailout),
            ("area_samples", o.area_samples.map(f64::from)),
            ("radiosity_count", o.radiosity_count.map(f64::from)),
            ("radiosity_error_bound", o.radiosity_error_bound),
            ("radiosity_recursion", o.radiosity_recursion.map(f64::from)),
            ("pretrace_end", o.pretrace_end),
            ("photon_spacing", o.photon_spacing),
            ("photon_gather", o.photon_gather.map(f64::from)),
            ("media_samples", o.media_samples.map(f64::from)),
            ("media_intervals", o.media_intervals.map(f64::from)),
        ];
        all.into_iter().filter_map(|(what, value)| Some((what, value?)))
    }
}

impl Serialize for Knobs {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        match self.sampling {
            Sampling::Centre => map.serialize_entry("aa_method", "none")?,
            Sampling::Fixed { method, threshold, depth } => {
                map.serialize_entry("aa_method", &method.number().to_string())?;
                map.serialize_entry("threshold", &threshold)?;
                map.serialize_entry("depth", &depth)?;
            }
            Sampling::Adaptive { max_error } => {
                map.serialize_entry("aa_method", "adaptive")?;
                map.serialize_entry("max_error", &max_error)?;
            }
        }
        for (what, value) in self.replaced() {
            map.serialize_entry(what, &value)?;
        }
        map.end()
    }
}

/// Width and height of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Size {
    pub width: u32,
    pub height: u32,
}

impl Size {
    pub fn pixels(&self) -> f64 {
        f64::from(self.width) * f64::from(self.height)
    }
}

/// A picture that stands for the truth.
#[derive(Clone, Debug)]
pub struct Reference {
    pub picture: Picture,
    pub samples: u64,
    /// RMSE in light that it is expected to have.
    pub rmse: f64,
}

/// A scene that can be rendered in different ways.
pub trait Subject {
    /// Gets ready for pictures of that size, so that it takes no time later.
    fn prepare(&self, size: Size) -> Result<(), String>;

    /// The picture, or `None` if it was not finished when the clock said `until`.
    fn render(&self, size: Size, knobs: &Knobs, until: f64) -> Option<Picture>;

    /// The scene as it is meant, sampled until its error is expected to be `target` or the clock says
    /// `until`; with random numbers that no other picture has. `None` if not even one sample a pixel was
    /// possible.
    fn reference(&self, size: Size, target: f64, until: f64) -> Option<Reference>;

    /// How the pictures' values relate to light.
    fn light(&self) -> &Light;

    /// How the pictures become files.
    fn encoding(&self) -> Encoding;

    /// The command line that renders with these knobs.
    fn command(&self, size: Size, knobs: &Knobs) -> String;
}

/// A clock that also tells what the processors did.
pub trait Stopwatch: Clock {
    /// CPU seconds of all threads.
    fn cpu_seconds(&self) -> f64;
}

#[cfg(test)]
mod tests;
