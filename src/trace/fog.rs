//! Fog over a stretch of a ray.
//!
//! Constant fog lets `exp(-d/distance)` through; ground fog the same with the mean density along the
//! stretch, which is 1 up to `offset` and `1/(h^2+1)` at h altitudes above it.

use super::path::Veil;
use crate::color::{Rgb, grey};
use crate::math::noise::NoiseGenerator;
use crate::math::{Ray, Vec3};
use crate::scene::Fog;

/// The veil of all fogs over the first `length` of `ray`. What one fog adds is not dimmed by the others.
pub(super) fn veil(fogs: &[Fog], ray: &Ray, length: f64, noise: NoiseGenerator) -> Veil {
    let mut all = Veil::NONE;
    for fog in fogs.iter().filter(|f| f.distance != 0.0) {
        let through = transmittance(fog, ray, length, noise);
        all.factor *= tint(fog, through);
        all.added += (1.0 - through) * fog.color.rgb;
    }
    all.clear = grey(all.factor);
    all
}

/// What the fogs leave of light that comes along the stretch.
pub(super) fn attenuation(fogs: &[Fog], ray: &Ray, length: f64, noise: NoiseGenerator) -> Rgb {
    let part = |fog: &Fog| tint(fog, transmittance(fog, ray, length, noise));
    fogs.iter().filter(|f| f.distance != 0.0).map(part).product()
}

fn tint(fog: &Fog, through: f32) -> Rgb {
    let filter = fog.color.filter;
    through * (Rgb::splat(1.0 - filter) + filter * fog.color.rgb)
}

fn transmittance(fog: &Fog, ray: &Ray, length: f64, noise: NoiseGenerator) -> f32 {
    let density = if fog.kind == 2 { mean_density(fog, ray, length) } else { 1.0 };
    let mut depth = length;
    if fog.turbulence.amount != Vec3::ZERO {
        let p = fog.turbulence.amount * ray.at(0.5 * length);
        let strength = fog.turbulence.scalar(p, noise) * fog.turbulence_depth;
        depth *= 1.0 - (-length / fog.distance).exp() * strength.min(1.0);
    }
    ((-density * depth / fog.distance).exp() as f32).max(fog.color.transmit)
}

/// Mean density of ground fog along the stretch.
fn mean_density(fog: &Fog, ray: &Ray, length: f64) -> f64 {
    // An altitude of 0 ends the fog sharply.
    let altitude = if fog.altitude == 0.0 { 1e-100 } else { fog.altitude };
    let height = |p: Vec3| (p.dot(fog.up) - fog.offset) / altitude;
    mean_between(height(ray.origin), height(ray.at(length)))
}

/// Mean of `1/(h^2+1)`, taken as 1 below 0, for heights between `s` and `e`.
fn mean_between(s: f64, e: f64) -> f64 {
    if s.max(0.0) == e.max(0.0) {
        return if s > 0.0 { 1.0 / (s * s + 1.0) } else { 1.0 };
    }
    match (s > 0.0, e > 0.0) {
        (false, false) => 1.0,
        (false, true) => (e.atan() - s) / (e - s),
        (true, false) => (s.atan() - e) / (s - e),
        // The difference of the arc tangents without cancellation for nearby heights.
        (true, true) => ((s - e) / (1.0 + s * e)).atan() / (s - e),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Simpson's rule on the density's definition.
    fn by_quadrature(s: f64, e: f64) -> f64 {
        let n = 20_000;
        let f = |i: i32| {
            let h = (s + (e - s) * f64::from(i) / f64::from(n)).max(0.0);
            1.0 / (h * h + 1.0)
        };
        (0..=n)
            .map(|i| {
                f(i) * if i == 0 || i == n {
                    1.0
                } else if i % 2 == 1 {
                    4.0
                } else {
                    2.0
                }
            })
            .sum::<f64>()
            / (3.0 * f64::from(n))
    }

    #[test]
    fn mean_density_is_the_integral() {
        for (s, e) in [(0.3, 2.5), (-1.0, 2.0), (3.0, -0.5), (4.0, 4.0 + 1e-9), (-2.0, -1.0)] {
            let (a, b) = (mean_between(s, e), by_quadrature(s, e));
            assert!((a - b).abs() < 1e-7, "{s} {e}: {a} {b}");
        }
    }
}
