//! What the author said, as plain data.
//!
//! When you hold a [`Scene`], macros have run, names are resolved, angles are radians, colours are in the
//! working space, defaults are filled in. Transformations still sit where they were written.

mod counts;
mod globals;
mod object;

pub use counts::Counts;
pub use globals::{Globals, ObjectPhotons, PhotonSettings, RadiositySettings, SubsurfaceSettings};
pub use object::{Body, CsgOp, Flags, LightSource, Object};

pub use crate::color::Gamma;

use crate::camera::Camera;
use crate::color::{Color, Rgb};
use crate::material::{Attached, Media, Pigment};
use crate::math::noise::Turbulence;
use crate::math::{Transform, Vec3};
use crate::pattern::ColorMap;
use std::sync::Arc;

/// A whole scene.
#[derive(Debug)]
pub struct Scene {
    pub globals: Globals,
    pub camera: Camera,
    pub objects: Vec<Arc<Object>>,
    pub background: Background,
    pub sky_sphere: Option<SkySphere>,
    pub fogs: Vec<Fog>,
    pub rainbows: Vec<Rainbow>,
    /// Atmospheric media.
    pub media: Vec<Attached<Media>>,
}

/// What rays see that leave the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Background {
    /// No statement: black, and nothing at all in a picture with alpha.
    None,
    /// Read under a version before 3.7: opaque, but nothing at all in a picture with alpha.
    Opaque(Rgb),
    /// Since 3.7: as transparent as its colour says.
    Translucent(Color),
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
    /// Shakes the distance; off while its amount is zero.
    pub turbulence: Turbulence,
    pub turbulence_depth: f64,
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
    pub colors: ColorMap,
}
