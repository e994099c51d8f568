use super::triangle;
use crate::math::floor;
use std::f64::consts::PI;

/// The shape that a wave gives to each period of a pattern.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Wave {
    #[default]
    Ramp,
    Triangle,
    Sine,
    Scallop,
    Cubic,
    Poly(f64),
}

impl Wave {
    #[inline]
    pub fn shape(self, v: f64) -> f64 {
        match self {
            Wave::Ramp => v,
            Wave::Triangle => triangle(v),
            Wave::Sine => 0.5 * (1.0 + (2.0 * PI * (v - floor(v))).sin()),
            Wave::Scallop => {
                let half = 0.5 * v;
                (2.0 * PI * (half - floor(half))).sin().abs()
            }
            Wave::Cubic => v * v * (3.0 - 2.0 * v),
            Wave::Poly(exponent) => v.powf(exponent),
        }
    }
}
