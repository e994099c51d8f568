//! What the author said, as plain data.
//!
//! When you hold a [`Scene`], macros have run, names are resolved, angles are radians, colours are in the
//! working space, defaults are filled in. Transformations still sit where they were written.

mod object;

pub use object::{Body, CsgOp, Flags, LightSource, Object};

pub use crate::color::Gamma;

use crate::camera::Camera;
use crate::color::{Color, Rgb};
use crate::material::{Attached, Media, Pigment};
use crate::math::{Transform, Vec3};
use crate::pattern::NoiseGenerator;
use std::sync::Arc;

/// A whole scene.
#[derive(Debug)]
pub struct Scene {
    pub globals: Globals,
    pub camera: Camera,
    pub objects: Vec<Arc<Object>>,
    pub background: Color,
    /// Whether a `background` statement was given.
    pub has_background: bool,
    pub sky_sphere: Option<SkySphere>,
    pub fogs: Vec<Fog>,
    pub rainbows: Vec<Rainbow>,
    /// Atmospheric media.
    pub media: Vec<Attached<Media>>,
}

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
}

#[derive(Clone, Debug)]
pub struct SkySphere {
    /// In order of declaration; the last is on top.
    pub pigments: Vec<Arc<Pigment>>,
    pub emission: Rgb,
    pub transform: Transform,
}

#[derive(Clone, Debug)]
pub struct Fog {
    pub kind: u32,
    pub color: Color,
    pub distance: f64,
    pub offset: f64,
    pub altitude: f64,
    pub up: Vec3,
    pub turbulence: Option<FogTurbulence>,
}

#[derive(Clone, Debug)]
pub struct FogTurbulence {
    pub amount: Vec3,
    pub depth: f64,
    pub octaves: u32,
    pub omega: f64,
    pub lambda: f64,
}

/// Angles in radians.
#[derive(Clone, Debug)]
pub struct Rainbow {
    pub angle: f64,
    pub width: f64,
    pub direction: Vec3,
    pub up: Vec3,
    pub distance: f64,
    pub jitter: f64,
    pub arc_angle: Option<f64>,
    pub falloff_angle: Option<f64>,
    /// Colours by position 0..1 across the bow.
    pub colors: Vec<(f32, Color)>,
}
