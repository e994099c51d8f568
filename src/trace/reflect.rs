//! How much a layer reflects, and where to.
//!
//! Plain reflection grows from `min` to `max` with `(1 - c)^falloff`, c being the cosine between the ray
//! and the normal; fresnel reflection follows the unpolarised dielectric formula for the relative index n.
//!
//! Reference: M. Born, E. Wolf, "Principles of Optics", section 1.5.

use super::highlight::metallic_tint;
use crate::color::Rgb;
use crate::material::Reflection;
use crate::math::Vec3;

/// Closer than this to 0 or 1 a share counts as equal to it.
const NEAR: f64 = 1e-10;

/// The share of light reflected, per component, at cosine `c`; `color` is the layer's pigment. `index` is
/// asked for fresnel reflection only.
#[inline]
pub(super) fn reflectivity(r: &Reflection, c: f64, color: Rgb, index: impl FnOnce() -> f64) -> Rgb {
    if r.min == Rgb::ZERO && r.max == Rgb::ZERO {
        return Rgb::ZERO;
    }
    let k = if r.fresnel { fresnel_mix(r, c, index()) } else { plain_mix(r, c) };
    if r.metallic == 0.0 { k } else { k * metallic_tint(r.metallic, c, color) }
}

#[inline]
fn plain_mix(r: &Reflection, c: f64) -> Rgb {
    if r.min == r.max {
        return r.min;
    }
    let grazing = (1.0 - c).max(0.0);
    let q = if r.falloff == 1.0 { grazing } else { grazing.powf(f64::from(r.falloff)) };
    if q.abs() < NEAR {
        r.min
    } else if (q - 1.0).abs() < NEAR {
        r.max
    } else {
        q as f32 * r.max + (1.0 - q) as f32 * r.min
    }
}

fn fresnel_mix(r: &Reflection, c: f64, index: f64) -> Rgb {
    match fresnel(index, c) {
        None => r.max,
        Some(q) => q as f32 * r.max + (1.0 - q) as f32 * r.min,
    }
}

/// The unpolarised reflectance of a dielectric with relative index `n`; `None` where all is reflected.
pub(super) fn fresnel(n: f64, c: f64) -> Option<f64> {
    let g2 = n * n + c * c - 1.0;
    if g2 <= 0.0 {
        return None;
    }
    let g = g2.sqrt();
    let across = (g - c) / (g + c);
    let along = (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
    Some((0.5 * across * across * (1.0 + along * along)).clamp(0.0, 1.0))
}

/// The direction of a ray along `v` mirrored at the shading normal `n`, kept on the viewer's side of the
/// surface, whose geometric normal towards the viewer is `facing`. All unit vectors.
#[inline]
pub(super) fn mirrored(v: Vec3, n: Vec3, facing: Vec3) -> Vec3 {
    let mirror = |v: Vec3, n: Vec3| v - 2.0 * v.dot(n) * n;
    let r = mirror(v, n);
    let r = if r.dot(facing) >= 0.0 {
        r
    } else if r.dot(n) < 0.0 {
        mirror(v, facing)
    } else {
        mirror(r, facing)
    };
    r.normalize()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn glass() -> Reflection {
        Reflection { max: Rgb::ONE, fresnel: true, ..Reflection::default() }
    }

    #[test]
    fn straight_on_glass_reflects_four_percent() {
        let k = reflectivity(&glass(), 1.0, Rgb::ONE, || 1.5);
        assert!((k.x - 0.04).abs() < 1e-6, "{k}");
    }

    #[test]
    fn total_reflection_gives_max() {
        assert_eq!(reflectivity(&glass(), 0.3, Rgb::ONE, || 1.0 / 1.5), Rgb::ONE);
    }

    #[test]
    fn plain_reflection_between_min_and_max() {
        let r =
            Reflection { min: Rgb::splat(0.2), max: Rgb::splat(1.0), falloff: 2.0, ..Reflection::default() };
        let k = reflectivity(&r, 0.5, Rgb::ONE, || unreachable!());
        assert!((k.x - (0.25 + 0.75 * 0.2)).abs() < 1e-6, "{k}");
        assert_eq!(reflectivity(&r, 1.0, Rgb::ONE, || unreachable!()), r.min);
    }

    #[test]
    fn mirrored_ray_stays_outside() {
        let v = Vec3::new(0.96, -0.28, 0.0);
        let r = mirrored(v, Vec3::Y, Vec3::Y);
        assert!((r - Vec3::new(0.96, 0.28, 0.0)).length() < 1e-12);
        // A bump that turns the normal ahead would send the ray below the surface.
        let bumped = Vec3::new(0.6, 0.8, 0.0);
        assert!(mirrored(v, bumped, Vec3::Y).y >= 0.0);
    }
}
