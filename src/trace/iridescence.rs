//! Thin-film interference: light is brightened or dimmed by `1 + irid cos(2 pi film (a + b) / wavelength)`,
//! a and b being the cosines of the light's and the eye's directions with the normal.

use crate::color::Rgb;
use crate::material::Finish;
use crate::math::Vec3;
use crate::math::noise::{NoiseGenerator, Turbulence};
use std::f64::consts::TAU;

const TURBULENCE: Turbulence = Turbulence { amount: Vec3::ONE, octaves: 5, omega: 0.5, lambda: 2.0 };

/// The film's thickness at a point of the world.
pub(super) fn film(finish: &Finish, p: Vec3, noise: NoiseGenerator) -> f64 {
    let thickness = f64::from(finish.irid_thickness);
    if finish.irid_turbulence == 0.0 {
        return thickness;
    }
    thickness * (1.0 + f64::from(finish.irid_turbulence) * (2.0 * TURBULENCE.scalar(p, noise) - 1.0))
}

/// The factor for each component; `cosines` is the sum of both absolute cosines.
pub(super) fn factor(irid: f32, film: f64, cosines: f64, wavelength: Rgb) -> Rgb {
    let phase = TAU * film * cosines;
    let part = |lambda: f32| 1.0 + irid * (phase / f64::from(lambda)).cos() as f32;
    Rgb::new(part(wavelength.x), part(wavelength.y), part(wavelength.z))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_waves_brighten_half_waves_dim() {
        let f = factor(0.25, 0.5, 2.0, Rgb::new(1.0, 0.5, 2.0));
        assert!((f - Rgb::new(1.25, 1.25, 0.75)).length() < 1e-6, "{f}");
    }
}
