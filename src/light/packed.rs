//! One stored photon in twenty bytes: place, energy with a shared exponent, and the direction that it came
//! from as two angles.
//!
//! With `m = u 2^e` the largest component of the energy (1/2 <= u < 1), a component `c` is kept as
//! `trunc(c 2^(8-e))` and the exponent as `e + 250`. The direction's elevation and azimuth are kept in
//! steps of `pi/127`.
//!
//! Reference: G. Ward, "Real Pixels", Graphics Gems II, 1991.

use crate::color::Rgb;
use crate::math::Vec3;
use std::f64::consts::PI;
use std::sync::LazyLock;

/// A photon as the map keeps it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PackedPhoton {
    pub place: [f32; 3],
    /// Red, green, blue, exponent.
    pub energy: [u8; 4],
    /// The axis that the map splits at this photon: 0 to 2.
    pub axis: u8,
    pub elevation: i8,
    pub azimuth: i8,
}

/// Energies below are none.
const NO_ENERGY: f32 = 1e-32;

const EXPONENT_SHIFT: i32 = 250;

/// Steps of half a turn.
const STEPS: f64 = 127.0;

impl PackedPhoton {
    /// A photon at `place` that came from `towards`, a unit vector.
    pub fn new(place: Vec3, energy: Rgb, towards: Vec3) -> Self {
        let flat = towards.x.hypot(towards.z);
        let elevation = flat.min(1.0).acos().copysign(towards.y);
        let azimuth = if flat > 0.0 { (towards.x / flat).clamp(-1.0, 1.0).acos() } else { 0.0 };
        let step = |angle: f64| (angle * STEPS / PI) as i8;
        Self {
            place: place.as_vec3().to_array(),
            energy: packed_energy(energy),
            axis: 0,
            elevation: step(elevation),
            azimuth: step(azimuth.copysign(towards.z)),
        }
    }

    pub fn energy(&self) -> Rgb {
        let [r, g, b, exponent] = self.energy;
        if exponent == 0 {
            return Rgb::ZERO;
        }
        // The power of two, by its bits.
        let power = i64::from(exponent) - i64::from(EXPONENT_SHIFT) - 8;
        let unit = f64::from_bits(((power + 1023) as u64) << 52) as f32;
        Rgb::new(f32::from(r), f32::from(g), f32::from(b)) * unit
    }

    /// The direction that it came from.
    pub fn towards(&self) -> Vec3 {
        Turns::get().towards(self)
    }

    pub fn point(&self) -> Vec3 {
        glam::Vec3::from_array(self.place).as_dvec3()
    }
}

/// Sine and cosine of every step.
#[derive(Debug)]
pub struct Turns([(f64, f64); 256]);

impl Turns {
    pub fn get() -> &'static Self {
        static TURNS: LazyLock<Turns> = LazyLock::new(|| {
            Turns(std::array::from_fn(|i| (f64::from(i as u8 as i8) * PI / STEPS).sin_cos()))
        });
        &TURNS
    }

    /// The direction that a photon came from.
    #[inline]
    pub fn towards(&self, photon: &PackedPhoton) -> Vec3 {
        let (sin_elevation, cos_elevation) = self.0[usize::from(photon.elevation as u8)];
        let (sin, cos) = self.0[usize::from(photon.azimuth as u8)];
        Vec3::new(cos_elevation * cos, sin_elevation, cos_elevation * sin)
    }
}

fn packed_energy(energy: Rgb) -> [u8; 4] {
    let most = energy.max_element();
    if !(most >= NO_ENERGY) {
        return [0; 4];
    }
    // The exponent of a number in 1/2..1 times a power of two.
    let exponent = ((most.to_bits() >> 23) & 0xff) as i32 - 126;
    let scale = ((8 - exponent) as f32).exp2();
    let [r, g, b] = (energy * scale).to_array().map(|c| c as u8);
    [r, g, b, (exponent + EXPONENT_SHIFT) as u8]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn energy_comes_back_within_a_step() {
        for energy in [Rgb::new(0.7, 0.2, 0.01), Rgb::new(3e-9, 1e-9, 0.0), Rgb::splat(12.5)] {
            let back = PackedPhoton::new(Vec3::ZERO, energy, Vec3::Y).energy();
            let step = energy.max_element() / 128.0;
            assert!((energy - back).abs().max_element() <= step, "{energy} {back}");
        }
        assert_eq!(PackedPhoton::new(Vec3::ZERO, Rgb::ZERO, Vec3::Y).energy(), Rgb::ZERO);
    }

    #[test]
    fn directions_come_back_within_two_steps() {
        for d in [Vec3::new(2.0, 1.0, -2.0) / 3.0, Vec3::new(-0.6, -0.8, 0.0), Vec3::Y, Vec3::NEG_Z] {
            let back = PackedPhoton::new(Vec3::ONE, Rgb::ONE, d).towards();
            assert!((back.length() - 1.0).abs() < 1e-12 && back.dot(d) > (2.0 * PI / STEPS).cos(), "{d}");
        }
    }
}
