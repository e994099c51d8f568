//! Everything that was asked for, the same for all scenes of a batch.

use super::accuracy::Accuracy;
use super::radiosity::RadiosityFiles;
use crate::cli::args::{AaMethod, Accelerator, Corners, Gi, OverrideArgs, PictureArgs, RenderArgs};
use crate::cli::exit::Failure;
use crate::cli::streams::Streams;
use crate::color::Gamma;
use crate::picture::{Dither, Encoding, FileGamma, Pixel};
use crate::render::{Antialias, Method, Region, Settings};
use crate::trace::{self, Overrides};
use crate::world::Accel;
use std::sync::Mutex;

/// The size of a picture that nobody asked for otherwise.
const DEFAULT_SIZE: (u32, u32) = (640, 480);

/// Reflections nest by recursion, up to a documented limit.
const TRACE_STACK_BYTES: usize = 64 << 20;

pub struct Plan {
    pub width: u32,
    pub height: u32,
    pub region: Region,
    /// Methods 1 and 2; the scene's gamma comes with the scene.
    pub antialias: Option<Antialias>,
    /// Adaptive sampling.
    pub accuracy: Option<Accuracy>,
    pub block_size: u32,
    pub quality: u8,
    pub overrides: Overrides,
    pub accel: Accel,
    pub alpha: bool,
    pub bits: u8,
    pub grey: bool,
    /// What stands where nothing was traced.
    pub untraced: Pixel,
    pub file_gamma: FileGamma,
    pub dither: Dither,
    pub radiosity: RadiosityFiles,
    pub streams: Streams,
    pub partial: bool,
    pub pool: rayon::ThreadPool,
    /// The words of the command line.
    pub command: Vec<String>,
    /// CPU seconds of the process at the end of the scene before.
    pub counted: Mutex<f64>,
}

impl Plan {
    pub fn new(args: &RenderArgs) -> Result<Plan, Failure> {
        let p = &args.picture;
        let (width, height) = (p.width.unwrap_or(DEFAULT_SIZE.0), p.height.unwrap_or(DEFAULT_SIZE.1));
        Ok(Plan {
            width,
            height,
            region: region(args.region, width, height)?,
            antialias: antialias(p),
            accuracy: Accuracy::of(p, &args.accuracy)?,
            block_size: Settings::BLOCK_SIZE,
            quality: p.quality.min(9),
            overrides: overrides(&args.overrides),
            accel: accel(args.accel),
            alpha: args.alpha,
            bits: if args.bits == "16" { 16 } else { 8 },
            grey: false,
            untraced: Pixel::NONE,
            file_gamma: FileGamma::Srgb,
            dither: Dither::None,
            radiosity: RadiosityFiles {
                load: args.load_radiosity.clone(),
                save: args.save_radiosity.clone(),
            },
            streams: Streams::new(args.quiet),
            partial: args.partial,
            pool: pool(p.threads.map(usize::from))?,
            command: std::env::args_os().map(|w| w.to_string_lossy().into_owned()).collect(),
            counted: Mutex::new(0.0),
        })
    }

    pub fn encoding(&self, working: Gamma) -> Encoding {
        Encoding {
            working,
            file: self.file_gamma,
            bits: self.bits,
            alpha: self.alpha,
            grey: self.grey,
            dither: self.dither,
        }
    }

    pub fn settings(&self, working: Gamma) -> Settings {
        let antialias = self.antialias.clone().map(|a| Antialias { working, ..a });
        Settings { region: self.region, antialias, block_size: self.block_size }
    }

    pub fn trace_settings(&self) -> Result<trace::Settings, Failure> {
        Ok(trace::Settings {
            width: self.width,
            height: self.height,
            quality: self.quality,
            alpha: self.alpha,
            overrides: self.overrides,
            sparse_lamps: self.accuracy.is_some(),
            known_light: self.radiosity.read()?,
        })
    }
}

fn overrides(args: &OverrideArgs) -> Overrides {
    Overrides {
        max_trace_level: args.trace_level,
        adc_bailout: args.adc_bailout,
        area_samples: args.area_samples,
        radiosity_count: args.radiosity_count,
        radiosity_error_bound: args.radiosity_error_bound,
        radiosity_recursion: args.radiosity_recursion,
        pretrace_end: args.pretrace_end,
        photon_spacing: args.photon_spacing,
        photon_gather: args.photon_gather,
        media_samples: args.media_samples,
        media_intervals: args.media_intervals,
        reference: args.gi == Gi::Reference,
    }
}

/// What the scene's objects are to be kept in.
pub fn accel(asked: Option<Accelerator>) -> Accel {
    match asked {
        None => Accel::ByScene,
        Some(Accelerator::Bvh) => Accel::Bvh,
        Some(Accelerator::Grid) => Accel::Grid,
        Some(Accelerator::None) => Accel::None,
    }
}

/// Threads that trace; one per core if none are asked for.
pub fn pool(threads: Option<usize>) -> Result<rayon::ThreadPool, Failure> {
    let pool =
        rayon::ThreadPoolBuilder::new().num_threads(threads.unwrap_or(0)).stack_size(TRACE_STACK_BYTES);
    pool.build().map_err(|e| Failure::unavailable(format!("cannot start threads: {e}")))
}

fn antialias(p: &PictureArgs) -> Option<Antialias> {
    let method = if p.aa_method == Some(AaMethod::Recursive) { Method::Recursive } else { Method::Grid };
    p.antialias.map(|threshold| Antialias {
        threshold,
        depth: p.aa_depth,
        jitter: if p.jitter == "on" { 1.0 } else { 0.0 },
        ..Antialias::new(method, Gamma::Unmanaged)
    })
}

fn region(given: Option<Corners>, width: u32, height: u32) -> Result<Region, Failure> {
    let Some(Corners([x0, y0, x1, y1])) = given else { return Ok(Region::whole(width, height)) };
    if x0 >= x1 || y0 >= y1 || x1 > width || y1 > height {
        return Err(Failure::usage(format!(
            "--region {x0},{y0},{x1},{y1} is empty or leaves the picture of {width}x{height}: \
             columns run from x0 to x1-1, rows from y0 to y1-1"
        )));
    }
    Ok(Region { x0, y0, x1, y1 })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn regions_must_lie_in_the_picture() {
        assert_eq!(region(None, 4, 3).unwrap(), Region::whole(4, 3));
        let part = Region { x0: 1, y0: 0, x1: 4, y1: 3 };
        assert_eq!(region(Some(Corners([1, 0, 4, 3])), 4, 3).unwrap(), part);
        for wrong in [[2, 0, 2, 3], [0, 0, 5, 3], [0, 2, 4, 1]] {
            assert!(region(Some(Corners(wrong)), 4, 3).unwrap_err().message.contains("--region"));
        }
    }
}
