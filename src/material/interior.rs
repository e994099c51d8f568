use crate::color::Rgb;
use crate::math::Transform;
use std::sync::Arc;

/// What fills an object.
#[derive(Clone, Debug)]
pub struct Interior {
    /// Index of refraction; single precision as the language keeps it. 1 by default.
    pub ior: f32,
    pub dispersion: f32,
    pub dispersion_samples: u32,
    pub caustics: f32,
    pub fade_distance: f64,
    pub fade_power: f64,
    pub fade_color: Rgb,
    pub media: Vec<Arc<Media>>,
}

impl Default for Interior {
    fn default() -> Self {
        Self {
            ior: 1.0,
            dispersion: 1.0,
            dispersion_samples: 7,
            caustics: 0.0,
            fade_distance: 0.0,
            fade_power: 0.0,
            fade_color: Rgb::ZERO,
            media: Vec::new(),
        }
    }
}

/// A participating medium.
#[derive(Clone, Debug)]
pub struct Media {
    pub intervals: u32,
    pub samples: (u32, u32),
    pub method: u32,
    pub jitter: f32,
    pub aa_threshold: f32,
    pub aa_level: u32,
    pub collect: bool,
    pub absorption: Rgb,
    pub emission: Rgb,
    pub scattering: Rgb,
    pub scattering_type: u32,
    pub eccentricity: f32,
    pub extinction: f32,
    pub confidence: f32,
    pub variance: f32,
    pub ratio: f32,
    /// Each density is a pigment whose colour multiplies the coefficients.
    pub densities: Vec<Arc<super::Pigment>>,
    /// Density space to the space of the interior.
    pub transform: Transform,
}

impl Media {
    /// What a medium is before anything is said about it, by syntax version times 100.
    pub fn new(version: u32) -> Self {
        let (intervals, samples, method) = if version < 350 { (10, (1, 1), 1) } else { (1, (10, 10), 3) };
        Self {
            intervals,
            samples,
            method,
            jitter: 0.0,
            aa_threshold: 0.1,
            aa_level: 3,
            collect: true,
            absorption: Rgb::ZERO,
            emission: Rgb::ZERO,
            scattering: Rgb::ZERO,
            scattering_type: 1,
            eccentricity: 0.0,
            extinction: 1.0,
            confidence: 0.9,
            variance: 1.0 / 128.0,
            ratio: 0.9,
            densities: Vec::new(),
            transform: Transform::IDENTITY,
        }
    }
}
