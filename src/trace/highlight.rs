//! Highlights: phong around the mirrored direction, specular around the half-way vector; tinted on metals.

use crate::color::Rgb;
use crate::material::Finish;
use crate::math::Vec3;
use std::f64::consts::FRAC_PI_2;

/// Below this cosine a phong highlight of size 60 or more is left out.
const FAINT: f64 = 0.0008;

/// Highlights weaker than e to this power are left out.
const NOTHING: f64 = -25.0;

/// Whole exponents below this one are quicker by squaring; single precision does not tell the difference.
const MANY: u32 = 1 << 12;

/// `c^exponent` for a cosine, or 0 where it is next to nothing: `ln c <= c - 1` tells.
#[inline]
fn lobe(c: f64, exponent: f64) -> f32 {
    if exponent * (c - 1.0) < NOTHING {
        return 0.0;
    }
    let whole = exponent as u32;
    if whole < MANY && f64::from(whole) == exponent {
        return power(c, whole) as f32;
    }
    c.powf(exponent) as f32
}

/// `c^n` by squaring: sizes and roughnesses are mostly round numbers.
#[inline]
fn power(mut c: f64, mut n: u32) -> f64 {
    let mut product = if n & 1 == 1 { c } else { 1.0 };
    while n > 1 {
        n >>= 1;
        c *= c;
        if n & 1 == 1 {
            product *= c;
        }
    }
    product
}

/// The strength of both highlights for the ray direction `v`, shading normal `n` and light direction `l`.
#[inline]
pub(super) fn strength(finish: &Finish, v: Vec3, n: Vec3, l: Vec3) -> f32 {
    let mut sum = 0.0;
    if finish.phong > 0.0 {
        sum += finish.phong * phong(f64::from(finish.phong_size), v, n, l);
    }
    if finish.specular > 0.0 {
        sum += finish.specular * specular(f64::from(finish.specular_exponent), v, n, l);
    }
    sum
}

#[inline]
fn phong(size: f64, v: Vec3, n: Vec3, l: Vec3) -> f32 {
    let c = (v - 2.0 * v.dot(n) * n).dot(l);
    if c > 0.0 && (size < 60.0 || c > FAINT) { lobe(c, size) } else { 0.0 }
}

#[inline]
fn specular(exponent: f64, v: Vec3, n: Vec3, l: Vec3) -> f32 {
    let half = l - v;
    let length = half.length();
    if length == 0.0 {
        return 0.0;
    }
    let c = half.dot(n) / length;
    if c > 0.0 { lobe(c, exponent) } else { 0.0 }
}

/// What a metal does to a highlight's or a reflection's colour, at cosine `c` from the normal: it takes on
/// the pigment's colour, less so towards grazing light.
pub(super) fn metallic_tint(metallic: f32, c: f64, pigment: Rgb) -> Rgb {
    let x = c.clamp(-1.0, 1.0).acos() / FRAC_PI_2;
    let grazing = (0.014567225 / ((x - 1.12) * (x - 1.12)) - 0.011612903).clamp(0.0, 1.0) as f32;
    Rgb::ONE + metallic * (1.0 - grazing) * (pigment - Rgb::ONE)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_are_full_in_the_middle() {
        let finish = Finish { phong: 0.4, specular: 0.3, ..Finish::default() };
        let s = strength(&finish, -Vec3::Y, Vec3::Y, Vec3::Y);
        assert!((s - 0.7).abs() < 1e-6);
    }

    #[test]
    fn exponents() {
        let l = Vec3::new(0.6, 0.8, 0.0);
        assert!((phong(2.0, -Vec3::Y, Vec3::Y, l) - 0.64).abs() < 1e-6);
        // The half-way vector's cosine squared is (1 + 0.8) / 2.
        assert!((specular(4.0, -Vec3::Y, Vec3::Y, l) - 0.81).abs() < 1e-6);
    }

    #[test]
    fn what_is_left_out_is_next_to_nothing() {
        for exponent in [0.0, 0.5, 1.0, 2.0, 3.0, 40.0, 90.5, 1000.0, 1023.0, 4095.0, 5000.0] {
            for i in 1..=1000 {
                let c = f64::from(i) / 1000.0;
                assert!(
                    (f64::from(lobe(c, exponent)) - c.powf(exponent)).abs() < 1e-7 * c.powf(exponent) + 2e-11
                );
            }
        }
    }

    #[test]
    fn metal_keeps_its_colour_straight_on() {
        let tint = metallic_tint(1.0, 1.0, Rgb::new(0.8, 0.5, 0.2));
        assert!((tint - Rgb::new(0.8, 0.5, 0.2)).length() < 1e-3, "{tint}");
        assert!((metallic_tint(1.0, 0.0, Rgb::ZERO) - Rgb::ONE).length() < 1e-3);
    }
}
