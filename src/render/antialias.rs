//! When two samples differ, and the colours that are compared.

use crate::color::Gamma;
use crate::picture::Pixel;

/// How a pixel is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Method 1: a fixed grid in pixels that differ from their left or upper neighbour.
    Grid,
    /// Method 2: quarters of quarters where corners differ.
    Recursive,
}

impl Method {
    /// What users call it.
    pub fn number(self) -> u8 {
        match self {
            Method::Grid => 1,
            Method::Recursive => 2,
        }
    }
}

/// Settings of anti-aliasing.
#[derive(Clone, Debug, PartialEq)]
pub struct Antialias {
    pub method: Method,
    /// Summed difference of red, green, blue and transmit from which on samples differ.
    pub threshold: f32,
    /// Samples along a side (method 1), or levels of division (method 2).
    pub depth: u32,
    /// 0 for none, 1 for the whole of a sample's cell.
    pub jitter: f64,
    /// Samples are compared after encoding with this gamma; none at 0.
    pub gamma: f64,
    /// How the scene's colours relate to light.
    pub working: Gamma,
}

impl Antialias {
    pub const THRESHOLD: f32 = 0.3;
    pub const DEPTH: u32 = 3;
    pub const MAX_DEPTH: u32 = 9;
    pub const GAMMA: f64 = 2.5;

    pub fn new(method: Method, working: Gamma) -> Self {
        Self {
            method,
            threshold: Self::THRESHOLD,
            depth: Self::DEPTH,
            jitter: 1.0,
            gamma: Self::GAMMA,
            working,
        }
    }

    /// A sample with the colour by which it is compared.
    pub(super) fn seen(&self, pixel: Pixel) -> Seen {
        let encode = |c: f32| match self.working {
            _ if self.gamma <= 0.0 => c,
            Gamma::Unmanaged => c.max(0.0).powf((1.0 / self.gamma) as f32),
            Gamma::Power(g) => c.max(0.0).powf((g / self.gamma) as f32),
            Gamma::Srgb => (Gamma::Srgb.decode(f64::from(c)).max(0.0) as f32).powf((1.0 / self.gamma) as f32),
        };
        Seen { pixel, encoded: pixel.rgb.to_array().map(encode) }
    }

    pub(super) fn differ(&self, a: &Seen, b: &Seen) -> bool {
        let colors = a.encoded.iter().zip(&b.encoded).map(|(p, q)| (p - q).abs()).sum::<f32>();
        colors + (a.pixel.transmit - b.pixel.transmit).abs() >= self.threshold
    }
}

/// A sample with its encoded red, green and blue.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen {
    pub pixel: Pixel,
    encoded: [f32; 3],
}
