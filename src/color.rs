//! Linear colour with the two kinds of transparency that the scene language has.

use std::ops::{Add, Mul};

/// Red, green, blue; single precision, as the language stores colours. All three are worked on at once.
pub type Rgb = glam::Vec3A;

/// Weights of red, green and blue in a grey value, everywhere in the language.
pub const GREY_WEIGHTS: Rgb = Rgb::new(0.297, 0.589, 0.114);

/// The grey value of a colour.
#[inline]
pub fn grey(c: Rgb) -> f32 {
    c.dot(GREY_WEIGHTS)
}

/// A colour with `filter` (tinted) and `transmit` (untinted) transparency.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Color {
    pub rgb: Rgb,
    pub filter: f32,
    pub transmit: f32,
}

impl Color {
    pub const BLACK: Color = Color { rgb: Rgb::ZERO, filter: 0.0, transmit: 0.0 };
    pub const WHITE: Color = Color { rgb: Rgb::ONE, filter: 0.0, transmit: 0.0 };

    #[inline]
    pub const fn rgb(r: f32, g: f32, b: f32) -> Self {
        Self { rgb: Rgb::new(r, g, b), filter: 0.0, transmit: 0.0 }
    }

    #[inline]
    pub const fn new(r: f32, g: f32, b: f32, filter: f32, transmit: f32) -> Self {
        Self { rgb: Rgb::new(r, g, b), filter, transmit }
    }

    /// The five components red, green, blue, filter, transmit.
    pub fn components(&self) -> [f32; 5] {
        [self.rgb.x, self.rgb.y, self.rgb.z, self.filter, self.transmit]
    }

    pub fn from_components(c: [f32; 5]) -> Self {
        Self::new(c[0], c[1], c[2], c[3], c[4])
    }

    /// Whether light passes through at all.
    #[inline]
    pub fn is_transparent(&self) -> bool {
        self.filter != 0.0 || self.transmit != 0.0
    }

    /// What the surface does to light that passes through.
    #[inline]
    pub fn transmittance(&self) -> Rgb {
        self.rgb * self.filter + Rgb::splat(self.transmit)
    }

    /// On the way to another colour, bit for bit as the reference goes it in a map: only the share is in double
    /// precision.
    #[inline]
    pub fn toward(self, other: Self, t: f64) -> Self {
        let step = |a: f32, b: f32| a + (f64::from(b - a) * t) as f32;
        Color {
            rgb: Rgb::new(
                step(self.rgb.x, other.rgb.x),
                step(self.rgb.y, other.rgb.y),
                step(self.rgb.z, other.rgb.z),
            ),
            filter: step(self.filter, other.filter),
            transmit: step(self.transmit, other.transmit),
        }
    }
}

impl Add for Color {
    type Output = Color;
    #[inline]
    fn add(self, o: Color) -> Color {
        Color { rgb: self.rgb + o.rgb, filter: self.filter + o.filter, transmit: self.transmit + o.transmit }
    }
}

impl Mul<f32> for Color {
    type Output = Color;
    #[inline]
    fn mul(self, k: f32) -> Color {
        Color { rgb: self.rgb * k, filter: self.filter * k, transmit: self.transmit * k }
    }
}

/// How working colours relate to light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Gamma {
    /// Scenes before 3.7 without `assumed_gamma`: file values are working values.
    Unmanaged,
    /// Light = working value ^ g.
    Power(f64),
    /// `assumed_gamma srgb`.
    Srgb,
}

impl Gamma {
    /// Powers this near to 1 are taken for 1.
    const NEUTRAL: f64 = 0.01;

    /// Whether working values are proportional to light, or are taken to be.
    pub fn is_linear(self) -> bool {
        match self {
            Gamma::Unmanaged => true,
            Gamma::Power(g) => (g - 1.0).abs() <= Self::NEUTRAL,
            Gamma::Srgb => false,
        }
    }

    /// The light of a working value; negative values are dark.
    pub fn decode(self, working: f64) -> f64 {
        match self {
            Gamma::Srgb => linear_from_srgb(working),
            Gamma::Power(g) if !self.is_linear() => working.max(0.0).powf(g),
            Gamma::Power(_) | Gamma::Unmanaged => working,
        }
    }

    /// The working value of light.
    pub fn encode(self, light: f64) -> f64 {
        match self {
            Gamma::Srgb => srgb_from_linear(light),
            Gamma::Power(g) if !self.is_linear() => light.max(0.0).powf(1.0 / g),
            Gamma::Power(_) | Gamma::Unmanaged => light,
        }
    }
}

/// The sRGB transfer curve (IEC 61966-2-1).
pub fn srgb_from_linear(c: f64) -> f64 {
    if c <= 0.0031308 { 12.92 * c } else { 1.055 * c.powf(1.0 / 2.4) - 0.055 }
}

/// The inverse of [`srgb_from_linear`].
pub fn linear_from_srgb(c: f64) -> f64 {
    if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn transfer_curves_undo_each_other() {
        for gamma in [Gamma::Unmanaged, Gamma::Power(2.2), Gamma::Power(1.005), Gamma::Srgb] {
            for i in 0..=100 {
                let c = i as f64 / 100.0;
                assert!((gamma.encode(gamma.decode(c)) - c).abs() < 1e-6, "{gamma:?} {c}");
            }
        }
        assert!((linear_from_srgb(0.5) - 0.214041).abs() < 1e-6);
    }
}
