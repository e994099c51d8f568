use crate::color::{Gamma, Rgb};
use crate::light::PhotonFile;
use crate::pattern::NoiseGenerator;
use std::path::PathBuf;
use std::sync::Arc;

/// `global_settings`, and what the language version decides for the picture.
#[derive(Clone, Debug)]
pub struct Globals {
    pub adc_bailout: f32,
    pub ambient_light: Rgb,
    pub max_trace_level: u32,
    pub irid_wavelength: Rgb,
    pub noise_generator: NoiseGenerator,
    pub number_of_waves: usize,
    pub mm_per_unit: f64,
    pub gamma: Gamma,
    /// Effective version at the end of the text, times 100: 362 where none was declared.
    pub effective_version: u32,
    pub radiosity: Option<RadiositySettings>,
    /// Radiosity importance of objects that say nothing about it.
    pub importance: f32,
    pub photons: Option<PhotonSettings>,
    pub subsurface: Option<SubsurfaceSettings>,
}

impl Default for Globals {
    fn default() -> Self {
        Self {
            adc_bailout: 1.0 / 255.0,
            ambient_light: Rgb::ONE,
            max_trace_level: 5,
            irid_wavelength: Rgb::new(0.70, 0.52, 0.48),
            noise_generator: NoiseGenerator::RangeCorrected,
            number_of_waves: 10,
            mm_per_unit: 10.0,
            gamma: Gamma::Unmanaged,
            effective_version: 362,
            radiosity: None,
            importance: 1.0,
            photons: None,
            subsurface: None,
        }
    }
}

/// `radiosity{}`: diffuse light between surfaces from a cache of gathered samples.
#[derive(Clone, Debug, PartialEq)]
pub struct RadiositySettings {
    /// Rays of a gather, and how many directions there are before they repeat.
    pub count: u32,
    pub pool: u32,
    pub error_bound: f64,
    pub low_error_factor: f64,
    pub nearest_count: u32,
    /// Above 0: pretrace stops where this much weight is found.
    pub adaptive_count: u32,
    /// Fractions of the distance to the eye.
    pub minimum_reuse: f64,
    pub maximum_reuse: f64,
    pub recursion_limit: u32,
    pub pretrace_start: f64,
    pub pretrace_end: f64,
    pub brightness: f32,
    pub gray_threshold: f32,
    pub adc_bailout: f32,
    /// Brightest colour that a gather ray may bring; none if not above 0.
    pub max_sample: f32,
    pub always_sample: bool,
    pub normal: bool,
    pub media: bool,
    pub subsurface: bool,
}

impl Default for RadiositySettings {
    fn default() -> Self {
        Self {
            count: 35,
            pool: 1600,
            error_bound: 1.8,
            low_error_factor: 0.5,
            nearest_count: 5,
            adaptive_count: 0,
            minimum_reuse: 0.015,
            maximum_reuse: 0.2,
            recursion_limit: 2,
            pretrace_start: 0.08,
            pretrace_end: 0.04,
            brightness: 1.0,
            gray_threshold: 0.0,
            adc_bailout: 0.01,
            max_sample: -1.0,
            always_sample: false,
            normal: false,
            media: false,
            subsurface: false,
        }
    }
}

/// Global `photons{}`.
#[derive(Clone, Debug, PartialEq)]
pub struct PhotonSettings {
    pub spacing: f64,
    /// Wanted number of photons; 0 if `spacing` decides.
    pub count: u32,
    pub gather_min: u32,
    /// 0 switches photons off.
    pub gather_max: u32,
    /// Radius on surfaces and in media with a multiplier each; a radius of 0 or less is chosen by itself.
    pub surface_radius: (f64, f64),
    pub media_radius: (f64, f64),
    pub expand_increase: f64,
    pub expand_min: u32,
    pub autostop: f64,
    pub jitter: f64,
    pub media_steps: u32,
    pub media_factor: f64,
    pub max_trace_level: Option<u32>,
    pub adc_bailout: Option<f32>,
    /// Maps that take the place of shooting.
    pub load: Option<Arc<PhotonFile>>,
    /// Where the maps are kept.
    pub save_file: Option<PathBuf>,
}

impl Default for PhotonSettings {
    fn default() -> Self {
        Self {
            spacing: 1.0,
            count: 0,
            gather_min: 20,
            gather_max: 100,
            surface_radius: (-1.0, 1.0),
            media_radius: (-1.0, 1.0),
            expand_increase: 0.2,
            expand_min: 35,
            autostop: 0.5,
            jitter: 0.4,
            media_steps: 0,
            media_factor: 1.0,
            max_trace_level: None,
            adc_bailout: None,
            load: None,
            save_file: None,
        }
    }
}

/// Global `subsurface{}`.
#[derive(Clone, Debug, PartialEq)]
pub struct SubsurfaceSettings {
    pub diffuse_samples: u32,
    pub single_samples: u32,
    pub radiosity: bool,
}

impl Default for SubsurfaceSettings {
    fn default() -> Self {
        Self { diffuse_samples: 50, single_samples: 50, radiosity: false }
    }
}

/// An object's `photons{}`. Switches that were not written are `None`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ObjectPhotons {
    /// Density of the photons shot at the object, if it is a target.
    pub target: Option<f32>,
    pub refraction: Option<bool>,
    pub reflection: Option<bool>,
    pub pass_through: bool,
    pub collect: bool,
}

impl Default for ObjectPhotons {
    fn default() -> Self {
        Self { target: None, refraction: None, reflection: None, pass_through: false, collect: true }
    }
}
