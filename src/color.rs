//! Linear colour with the two kinds of transparency that the scene language has.

use std::ops::{Add, Mul};

/// Red, green, blue; single precision, as the language stores colours.
pub type Rgb = glam::Vec3;

/// Weights of red, green and blue in a grey value, everywhere in the language.
pub const GREY_WEIGHTS: Rgb = Rgb::new(0.297, 0.589, 0.114);

/// The grey value of a colour.
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

    pub const fn rgb(r: f32, g: f32, b: f32) -> Self {
        Self { rgb: Rgb::new(r, g, b), filter: 0.0, transmit: 0.0 }
    }

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
    pub fn is_transparent(&self) -> bool {
        self.filter != 0.0 || self.transmit != 0.0
    }

    /// What the surface does to light that passes through.
    pub fn transmittance(&self) -> Rgb {
        self.rgb * self.filter + Rgb::splat(self.transmit)
    }

    pub fn lerp(self, other: Self, t: f32) -> Self {
        self * (1.0 - t) + other * t
    }
}

impl Add for Color {
    type Output = Color;
    fn add(self, o: Color) -> Color {
        Color { rgb: self.rgb + o.rgb, filter: self.filter + o.filter, transmit: self.transmit + o.transmit }
    }
}

impl Mul<f32> for Color {
    type Output = Color;
    fn mul(self, k: f32) -> Color {
        Color { rgb: self.rgb * k, filter: self.filter * k, transmit: self.transmit * k }
    }
}
