//! Passing through a surface: which interiors the ray is in afterwards, and how it bends.
//!
//! Entering or leaving is decided by the list of interiors alone: a ray that meets a surface of an interior
//! that it is in leaves it. Relative index `r = n_from / n_to`; with `c` the cosine of the incoming ray and
//! `k = 1 + r^2 (c^2 - 1)` the new direction is `r v + (r c - sqrt k) n`, and all is reflected for k < 0.

use super::path::{Interiors, copied};
use super::spectrum;
use crate::color::Rgb;
use crate::material::Interior;
use crate::math::Vec3;
use crate::world::{InteriorId, World};

/// Closer than this to 1 a ratio bends nothing.
const NEAR: f64 = 1e-10;

/// The change of interiors at a surface.
#[derive(Clone, Debug)]
pub(super) struct Passage {
    /// Interiors after the surface.
    pub inside: Interiors,
    /// Index of refraction before, divided by that after.
    pub ratio: f64,
    /// The same for dispersion; 1 for none.
    pub dispersion: f64,
    pub dispersion_samples: u32,
    /// Whether the surface's interior is left.
    pub leaves: bool,
}

impl Passage {
    /// At a surface of interior `x`, for a ray inside of `before`.
    pub fn new(world: &World, before: &Interiors, x: InteriorId) -> Self {
        let own = world.interior(x);
        let (index, spread) = optics(own);
        let mut inside = copied(before);
        let place = before.iter().position(|&i| i == x);
        match place {
            Some(i) => {
                inside.remove(i);
            }
            None => inside.push(x),
        }
        let mut samples = own.dispersion_samples;
        let (ratio, dispersion) = match place {
            None => {
                let (from, from_spread) = before.last().map_or((1.0, 1.0), |&i| optics(world.interior(i)));
                (from / index, from_spread / spread)
            }
            Some(_) if before.last() == Some(&x) => {
                let next = inside.last().map(|&i| world.interior(i));
                let (to, to_spread) = next.map_or((1.0, 1.0), optics);
                samples = samples.max(next.map_or(0, |n| n.dispersion_samples));
                (index / to, spread / to_spread)
            }
            Some(_) => (1.0, 1.0),
        };
        Self { inside, ratio, dispersion, dispersion_samples: samples.max(2), leaves: place.is_some() }
    }

    pub fn is_straight(&self) -> bool {
        (self.ratio - 1.0).abs() < NEAR && !self.disperses()
    }

    /// The ratio for light of a wavelength in nanometres.
    pub fn ratio_at(&self, wavelength: f64) -> f64 {
        self.ratio * self.dispersion.powf((spectrum::MIDDLE - wavelength) / spectrum::WIDTH)
    }

    pub fn disperses(&self) -> bool {
        (self.dispersion - 1.0).abs() >= NEAR
    }
}

/// Index of refraction and dispersion; an index of 0 means neither.
fn optics(interior: &Interior) -> (f64, f64) {
    if interior.ior == 0.0 { (1.0, 1.0) } else { (f64::from(interior.ior), f64::from(interior.dispersion)) }
}

/// The index of interior `x` relative to what the ray comes from, for fresnel reflection.
pub(super) fn relative_index(world: &World, before: &Interiors, x: InteriorId) -> f64 {
    let own = optics(world.interior(x)).0;
    let last = before.last().map_or(1.0, |&i| optics(world.interior(i)).0);
    if !before.contains(&x) {
        own / last
    } else if before.len() == 1 {
        1.0 / own
    } else {
        last / own
    }
}

/// The refracted direction of a ray along `v` for unit normal `n` on either side; `None` if all is
/// reflected.
pub(super) fn bent(v: Vec3, n: Vec3, ratio: f64) -> Option<Vec3> {
    let (n, c) = if v.dot(n) > 0.0 { (-n, v.dot(n)) } else { (n, -v.dot(n)) };
    let k = 1.0 + ratio * ratio * (c * c - 1.0);
    (k >= 0.0).then(|| (ratio * v + (ratio * c - k.sqrt()) * n).normalize())
}

/// What an interior takes from light that has gone `distance` through it.
pub(super) fn faded(interior: &Interior, distance: f64) -> Rgb {
    let ratio = distance / interior.fade_distance;
    if interior.fade_power >= 1000.0 {
        let part = |c: f32| ((f64::from(c) - 1.0) * ratio).exp() as f32;
        let c = interior.fade_color;
        return Rgb::new(part(c.x), part(c.y), part(c.z));
    }
    let share = (1.0 / (1.0 + ratio.powf(interior.fade_power))) as f32;
    interior.fade_color + (Rgb::ONE - interior.fade_color) * share
}

/// Whether an interior fades light at all.
pub(super) fn fades(interior: &Interior) -> bool {
    interior.fade_distance != 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn snell() {
        let v = Vec3::new(0.6, -0.8, 0.0);
        let t = bent(v, Vec3::Y, 1.0 / 1.5).unwrap();
        assert!((t.x - 0.4).abs() < 1e-12 && t.y < 0.0, "{t}");
        assert_eq!(bent(v, -Vec3::Y, 1.0 / 1.5), Some(t));
        assert_eq!(bent(Vec3::new(0.8, -0.6, 0.0), Vec3::Y, 1.5), None);
    }

    #[test]
    fn fading_by_power_and_by_exponent() {
        let mut interior = Interior {
            fade_distance: 2.0,
            fade_power: 1.0,
            fade_color: Rgb::new(0.5, 0.0, 1.0),
            ..Interior::default()
        };
        assert!((faded(&interior, 6.0) - Rgb::new(0.625, 0.25, 1.0)).length() < 1e-6);
        interior.fade_power = 1000.0;
        let expected = Rgb::new((-1.5f32).exp(), (-3f32).exp(), 1.0);
        assert!((faded(&interior, 6.0) - expected).length() < 1e-6);
    }
}
