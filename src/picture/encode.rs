//! Working values to file values: transfer curve, alpha, clipping, quantising.
//!
//! Working value -> light -> file value -> clip to 0..1 -> floor(value * max + 1/2). Where working curve and
//! file curve are the same they cancel without rounding. Files with an alpha channel hold colours that are
//! not premultiplied: the working colour is divided by its coverage first; a colour that is brighter than
//! its coverage raises the coverage instead of being clipped.

use super::{Picture, Pixel};
use crate::color::{Gamma, Rgb, grey, srgb_from_linear};

/// The curve of the values in a file.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub enum FileGamma {
    #[default]
    Srgb,
    /// File value = light ^ (1/g).
    Power(f64),
}

/// How working values become file values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Encoding {
    pub working: Gamma,
    pub file: FileGamma,
    /// Bits of a channel, 5 to 16.
    pub bits: u8,
    pub alpha: bool,
}

impl Encoding {
    pub fn new(working: Gamma) -> Self {
        Self { working, file: FileGamma::default(), bits: 8, alpha: false }
    }

    /// Channels of a pixel in the file.
    pub fn channels(&self) -> usize {
        if self.alpha { 4 } else { 3 }
    }

    /// The largest quantised value.
    pub fn max(&self) -> u16 {
        ((1u32 << self.bits) - 1) as u16
    }

    /// The file value of a working value, not clipped.
    fn curve(&self, c: f32) -> f64 {
        let c = f64::from(c);
        match (self.working, self.file) {
            (Gamma::Unmanaged, _) => c,
            (Gamma::Srgb, FileGamma::Srgb) => c,
            (Gamma::Power(w), FileGamma::Power(f)) if w == f => c,
            (working, FileGamma::Srgb) => srgb_from_linear(working.decode(c)),
            (working, FileGamma::Power(f)) => working.decode(c).max(0.0).powf(1.0 / f),
        }
    }

    fn quantise(&self, value: f64) -> u16 {
        let max = f64::from(self.max());
        // `clamp` keeps NaN and the cast makes it 0.
        (value.clamp(0.0, 1.0) * max + 0.5).floor() as u16
    }

    /// The quantised channels of one pixel; the fourth is alpha.
    pub fn pixel(&self, p: Pixel) -> [u16; 4] {
        let (rgb, alpha) = if self.alpha { unmultiplied(p) } else { (p.rgb, 1.0) };
        let [r, g, b] = rgb.to_array().map(|c| self.quantise(self.curve(c)));
        [r, g, b, self.quantise(f64::from(alpha))]
    }

    /// All quantised channels, row by row, three or four a pixel.
    pub fn samples(&self, picture: &Picture) -> Vec<u16> {
        let n = self.channels();
        let mut out = Vec::with_capacity(picture.pixels.len() * n);
        for p in &picture.pixels {
            out.extend_from_slice(&self.pixel(*p)[..n]);
        }
        out
    }

    /// Light of a working colour, for files that hold light. Without gamma handling the working values are
    /// what a viewer expects in a file, so they are taken as sRGB values.
    pub fn light(&self, rgb: Rgb) -> Rgb {
        let decode = |c: f32| match self.working {
            Gamma::Unmanaged => Gamma::Srgb.decode(f64::from(c)) as f32,
            working => working.decode(f64::from(c)) as f32,
        };
        Rgb::from_array(rgb.to_array().map(decode))
    }
}

/// Colour and coverage of a premultiplied pixel.
fn unmultiplied(p: Pixel) -> (Rgb, f32) {
    /// Stands for a coverage of nothing.
    const NO_COVERAGE: f32 = 1e-6;
    let mut alpha = 1.0 - p.transmit;
    let bright = grey(p.rgb);
    if bright > alpha {
        alpha = bright.min(1.0);
    }
    (p.rgb / if alpha == 0.0 { NO_COVERAGE } else { alpha }, alpha)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file_value(working: Gamma, file: FileGamma, bits: u8, c: f32) -> u16 {
        let e = Encoding { file, bits, ..Encoding::new(working) };
        e.pixel(Pixel::new(Rgb::splat(c), 0.0))[0]
    }

    /// The reference's values for the working value 5.5/64.
    #[test]
    fn curves_give_the_reference_values() {
        let c = 5.5 / 64.0;
        assert_eq!(file_value(Gamma::Power(1.0), FileGamma::Srgb, 8, c), 83);
        assert_eq!(file_value(Gamma::Unmanaged, FileGamma::Srgb, 8, c), 22);
        assert_eq!(file_value(Gamma::Power(2.2), FileGamma::Srgb, 8, c), 14);
        assert_eq!(file_value(Gamma::Power(1.0), FileGamma::Power(2.2), 8, c), 84);
        assert_eq!(file_value(Gamma::Power(1.0), FileGamma::Srgb, 16, c), 21263);
    }

    /// Greys of the version table: .1 .4 .75.
    #[test]
    fn greys_by_version_and_gamma() {
        let greys = |working| [0.1, 0.4, 0.75].map(|c| file_value(working, FileGamma::Srgb, 8, c));
        assert_eq!(greys(Gamma::Unmanaged), [26, 102, 191]);
        assert_eq!(greys(Gamma::Power(1.0)), [89, 170, 225]);
        assert_eq!(greys(Gamma::Power(2.2)), [19, 102, 193]);
    }

    #[test]
    fn values_out_of_range_are_clipped() {
        let all = |c| file_value(Gamma::Power(1.0), FileGamma::Srgb, 8, c);
        assert_eq!([all(-1.0), all(2.0), all(f32::INFINITY), all(f32::NAN)], [0, 255, 255, 0]);
    }

    #[test]
    fn equal_curves_cancel_without_rounding() {
        for i in 0..=255u16 {
            let c = f32::from(i) / 255.0;
            assert_eq!(file_value(Gamma::Srgb, FileGamma::Srgb, 8, c), i);
            assert_eq!(file_value(Gamma::Power(2.2), FileGamma::Power(2.2), 8, c), i);
        }
    }

    /// `rgbt <1, .5, .25, .4>` over nothing: the working colour is premultiplied.
    #[test]
    fn alpha_files_hold_colours_that_are_not_premultiplied() {
        let e = Encoding { alpha: true, ..Encoding::new(Gamma::Power(1.0)) };
        let p = Pixel::new(Rgb::new(1.0, 0.5, 0.25) * 0.6, 0.4);
        assert_eq!(e.pixel(p), [255, 188, 137, 153]);
        assert_eq!(e.pixel(Pixel::NONE), [0, 0, 0, 0]);
        // A highlight on clear glass raises the coverage.
        assert_eq!(e.pixel(Pixel::new(Rgb::splat(0.5), 1.0)), [255, 255, 255, 128]);
    }
}
