//! A prepared world and a place on the picture to a colour: recursive ray tracing.

mod area;
mod dimming;
mod direct;
mod fog;
mod highlight;
mod iridescence;
mod layers;
mod light_choice;
mod light_row;
mod media;
mod media_sampling;
mod path;
pub mod photon;
mod plain;
mod radiosity;
mod rainbow;
mod random;
mod reflect;
mod refract;
mod shade;
mod shadow;
mod shared_dimming;
mod sights;
mod sky;
mod spectrum;
mod subsurface;
mod tracer;

pub use photon::{Photons, Shooting};
pub use radiosity::{Gathered, Lighting, Pretrace, Progress, Sample, Tile, file as radiosity_file};
pub use tracer::{Indirect, Tracer};

use crate::math::Vec3;
pub use crate::picture::Pixel;
use crate::scene::{PhotonSettings, RadiositySettings};
use std::sync::Arc;

/// What the caller decides about a picture, apart from the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    pub width: u32,
    pub height: u32,
    /// 0 (flat pigments) to 9 (everything).
    pub quality: u8,
    /// Whether the picture has an alpha channel.
    pub alpha: bool,
    pub overrides: Overrides,
    /// Whether each place gets samples until its noise is gone, so that a sample may leave to chance which
    /// lamps of an area light it tests.
    pub sparse_lamps: bool,
    /// Samples of radiosity that are known before the picture begins.
    pub known_light: Arc<Vec<Sample>>,
}

/// What replaces words of the scene; what is `None` stays as the scene has it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Overrides {
    pub max_trace_level: Option<u32>,
    pub adc_bailout: Option<f32>,
    /// Lamps of an area light that are tested for a point, picked by chance; no more than it has.
    pub area_samples: Option<u32>,
    /// Rays of a radiosity gather.
    pub radiosity_count: Option<u32>,
    pub radiosity_error_bound: Option<f64>,
    pub radiosity_recursion: Option<u32>,
    pub pretrace_end: Option<f64>,
    /// Times the scene's own spacing of photons.
    pub photon_spacing: Option<f64>,
    /// The most photons of a search.
    pub photon_gather: Option<u32>,
    /// The most samples that each interval of a medium gets.
    pub media_samples: Option<u32>,
    pub media_intervals: Option<u32>,
    /// Light by plain Monte Carlo, to hold the scene's own settings against.
    pub reference: bool,
}

impl Overrides {
    /// The scene's words about radiosity as they are replaced.
    fn radiosity(&self, own: &RadiositySettings) -> RadiositySettings {
        let mut settings = own.clone();
        settings.count = self.radiosity_count.unwrap_or(own.count).max(1);
        settings.error_bound = self.radiosity_error_bound.unwrap_or(own.error_bound);
        settings.recursion_limit = self.radiosity_recursion.unwrap_or(own.recursion_limit);
        settings.pretrace_end = self.pretrace_end.unwrap_or(own.pretrace_end);
        settings
    }

    /// The same for photons. Fewer wanted photons need fewer to be content with.
    fn photons(&self, own: &PhotonSettings) -> PhotonSettings {
        let mut settings = own.clone();
        if let Some(factor) = self.photon_spacing {
            settings.spacing *= factor;
            settings.count = (f64::from(settings.count) / (factor * factor)) as u32;
        }
        if let Some(most) = self.photon_gather.filter(|_| own.gather_max > 0) {
            settings.gather_min =
                (u64::from(own.gather_min) * u64::from(most) / u64::from(own.gather_max)) as u32;
            settings.gather_max = most;
        }
        settings
    }
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            width: 160,
            height: 120,
            quality: 9,
            alpha: false,
            overrides: Overrides::default(),
            sparse_lamps: false,
            known_light: Arc::default(),
        }
    }
}

/// Rays that one tracer has followed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    pub camera_rays: u64,
    pub shadow_rays: u64,
    pub reflected_rays: u64,
    pub refracted_rays: u64,
    /// Over hemispheres, for diffuse light between surfaces.
    pub gather_rays: u64,
    /// Shot from lights.
    pub photons: u64,
    /// Colours of surfaces that came out as no numbers, and were drawn black.
    pub not_numbers: u64,
}

/// Where a colour first came out as no number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NotNumber {
    /// The kind of shape.
    pub kind: &'static str,
    pub point: Vec3,
}

impl std::ops::AddAssign for Counters {
    fn add_assign(&mut self, o: Counters) {
        self.camera_rays += o.camera_rays;
        self.shadow_rays += o.shadow_rays;
        self.reflected_rays += o.reflected_rays;
        self.refracted_rays += o.refracted_rays;
        self.not_numbers += o.not_numbers;
        self.gather_rays += o.gather_rays;
        self.photons += o.photons;
    }
}
