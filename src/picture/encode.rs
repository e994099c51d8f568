//! Working values to file values: transfer curve, alpha, clipping, quantising.
//!
//! Working value -> light -> file value -> clip to 0..1 -> floor(value * max + 1/2). Where working curve and
//! file curve are the same they cancel without rounding. Files with an alpha channel hold colours that are
//! not premultiplied: the working colour is divided by its coverage first; a colour that is brighter than
//! its coverage raises the coverage instead of being clipped.

use super::dither::{self, Dither};
use super::{Picture, Pixel};
use crate::color::{Gamma, Rgb, grey, linear_from_srgb, srgb_from_linear};

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
    /// One grey value instead of three colours.
    pub grey: bool,
    pub dither: Dither,
}

impl Encoding {
    pub fn new(working: Gamma) -> Self {
        Self { working, file: FileGamma::default(), bits: 8, alpha: false, grey: false, dither: Dither::None }
    }

    /// How many values a pixel has in the file.
    fn channels(&self) -> usize {
        (if self.grey { 1 } else { 3 }) + usize::from(self.alpha)
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
            (working, _) => self.file_value(working.decode(c)),
        }
    }

    /// In single precision, as the reference: it decides where a value lies half-way between two steps.
    fn quantise(&self, value: f32) -> u16 {
        let max = f32::from(self.max());
        // `clamp` keeps NaN and the cast makes it 0.
        (value.clamp(0.0, 1.0) * max + 0.5).floor() as u16
    }

    /// The quantised channels of one pixel; the fourth is alpha.
    pub fn pixel(&self, p: Pixel) -> [u16; 4] {
        let (rgb, alpha) = self.split(p);
        let [r, g, b] = rgb.to_array().map(|c| self.quantise(self.curve(c) as f32));
        [r, g, b, self.quantise(alpha)]
    }

    /// The same with something added to each encoded value, in steps of the file's values.
    pub(super) fn offset_pixel(&self, p: Pixel, steps: f32) -> [u16; 4] {
        let (rgb, alpha) = self.split(p);
        let offset = steps / f32::from(self.max());
        let [r, g, b] = rgb.to_array().map(|c| self.quantise(self.curve(c) as f32 + offset));
        [r, g, b, self.quantise(alpha + offset)]
    }

    /// Light of the three colours, and alpha.
    pub(super) fn light_channels(&self, p: Pixel) -> [f32; 4] {
        let (rgb, alpha) = self.split(p);
        let [r, g, b] = rgb.to_array().map(|c| self.working.decode(f64::from(c)) as f32);
        [r, g, b, alpha]
    }

    pub(super) fn quantised_light(&self, [r, g, b, alpha]: [f32; 4]) -> [u16; 4] {
        let file = |c: f32| self.quantise(self.file_value(f64::from(c)) as f32);
        [file(r), file(g), file(b), self.quantise(alpha)]
    }

    /// The light that quantised values stand for.
    pub(super) fn shown_light(&self, [r, g, b, alpha]: [u16; 4]) -> [f32; 4] {
        let share = |q: u16| f64::from(q) / f64::from(self.max());
        let light = |q: u16| match (self.working, self.file) {
            (Gamma::Unmanaged, _) => share(q),
            (_, FileGamma::Srgb) => linear_from_srgb(share(q)),
            (_, FileGamma::Power(f)) => share(q).powf(f),
        };
        [light(r) as f32, light(g) as f32, light(b) as f32, share(alpha) as f32]
    }

    /// The file value of light.
    fn file_value(&self, light: f64) -> f64 {
        match (self.working, self.file) {
            (Gamma::Unmanaged, _) => light,
            (_, FileGamma::Srgb) => srgb_from_linear(light),
            (_, FileGamma::Power(f)) => light.max(0.0).powf(1.0 / f),
        }
    }

    /// Colour and alpha as they are encoded.
    fn split(&self, p: Pixel) -> (Rgb, f32) {
        if self.alpha { unmultiplied(p) } else { (p.rgb, 1.0) }
    }

    /// The picture with the grey value of its working colours in all channels.
    fn in_grey(picture: &Picture) -> Picture {
        let pixels = picture.pixels.iter().map(|p| Pixel::new(Rgb::splat(grey(p.rgb)), p.transmit));
        Picture { pixels: pixels.collect(), ..*picture }
    }

    /// All quantised channels, row by row.
    pub fn samples(&self, picture: &Picture) -> Vec<u16> {
        let mut out = Vec::with_capacity(picture.pixels.len() * self.channels());
        self.each(picture, |channels| out.extend_from_slice(channels));
        out
    }

    /// Hands out the quantised channels of each pixel, row by row.
    pub(super) fn each(&self, picture: &Picture, put: impl FnMut(&[u16])) {
        if self.grey { self.each_of(&Encoding::in_grey(picture), put) } else { self.each_of(picture, put) }
    }

    fn each_of(&self, picture: &Picture, mut put: impl FnMut(&[u16])) {
        let mut put = |[r, g, b, alpha]: [u16; 4]| {
            let channels = if self.grey { [r, alpha, 0, 0] } else { [r, g, b, alpha] };
            put(&channels[..self.channels()]);
        };
        if self.dither != Dither::None {
            return dither::samples(picture, self, self.dither).into_iter().for_each(put);
        }
        let worth = self.bits <= Steps::MAX_BITS && picture.pixels.len() > Steps::WORTH && !self.alpha;
        let steps = worth.then(|| Steps::of(self));
        let quantised = |p: Pixel| match &steps {
            Some(steps) => [p.rgb.x, p.rgb.y, p.rgb.z, 1.0].map(|c| steps.at(c)),
            None => self.pixel(p),
        };
        // Backgrounds, and what has not been traced yet, are long runs of one pixel.
        let mut last = (Pixel::NONE, quantised(Pixel::NONE));
        for &p in &picture.pixels {
            if p != last.0 {
                last = (p, quantised(p));
            }
            put(last.1);
        }
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

/// Where an encoding's quantised value goes up: the same answers without a power for every channel.
struct Steps {
    /// The smallest working value of each quantised value from 1 on.
    thresholds: Vec<f32>,
    /// The quantised value of i / [`Steps::CELLS`].
    start: Vec<u16>,
}

impl Steps {
    const MAX_BITS: u8 = 8;
    /// From so many pixels on the table pays.
    const WORTH: usize = 10_000;
    const CELLS: usize = 4096;

    fn of(encoding: &Encoding) -> Steps {
        let value = |c: f32| encoding.quantise(encoding.curve(c) as f32);
        let thresholds: Vec<f32> = (1..=encoding.max()).map(|k| threshold(|c| value(c) >= k)).collect();
        let start = (0..=Steps::CELLS).map(|i| value(i as f32 / Steps::CELLS as f32)).collect();
        Steps { thresholds, start }
    }

    fn at(&self, c: f32) -> u16 {
        // A value that is no number is 0, as the cast has it.
        let cell = (c.clamp(0.0, 1.0) * Steps::CELLS as f32) as usize;
        let mut k = self.start[cell];
        while self.thresholds.get(usize::from(k)).is_some_and(|&t| c >= t) {
            k += 1;
        }
        k
    }
}

/// The smallest positive number at which something that stays true becomes true, by halving: positive
/// numbers are in the order of their bits.
fn threshold(reached: impl Fn(f32) -> bool) -> f32 {
    let (mut low, mut high) = (0, f32::INFINITY.to_bits());
    while low < high {
        let middle = low + (high - low) / 2;
        if reached(f32::from_bits(middle)) { high = middle } else { low = middle + 1 }
    }
    f32::from_bits(high)
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
    fn the_table_gives_the_same_answers() {
        let noise = |i: u32| f32::from_bits(0x3f80_0000 | i.wrapping_mul(2_654_435_761) >> 9) * 1.3 - 1.5;
        let special = [f32::NAN, f32::INFINITY, -0.0, 1e-30, 1.0];
        for (working, file) in [
            (Gamma::Power(1.0), FileGamma::Srgb),
            (Gamma::Power(2.2), FileGamma::Srgb),
            (Gamma::Unmanaged, FileGamma::Srgb),
            (Gamma::Srgb, FileGamma::Power(1.8)),
        ] {
            for bits in [5, 8] {
                let e = Encoding { file, bits, ..Encoding::new(working) };
                let steps = Steps::of(&e);
                let on_edges = steps.thresholds.iter().flat_map(|&t| [t, t.next_down()]);
                for c in on_edges.chain((0..20_000).map(noise)).chain(special) {
                    assert_eq!(steps.at(c), e.pixel(Pixel::new(Rgb::splat(c), 0.0))[0], "{e:?} {c}");
                }
            }
        }
    }

    /// Not a number differs from itself, and the two zeros are one value.
    #[test]
    fn runs_of_a_pixel_are_quantised_like_single_ones() {
        let mut picture = Picture::new(8, 2);
        for (x, c) in [0.0, -0.0, f32::NAN, f32::NAN, 0.5, 0.5, 0.25].into_iter().enumerate() {
            picture.set(x as u32, 1, Pixel::new(Rgb::splat(c), 0.0));
        }
        for (grey, alpha) in [(false, false), (false, true), (true, false), (true, true)] {
            let e = Encoding { grey, alpha, ..Encoding::new(Gamma::Power(1.0)) };
            let single = picture.pixels.iter().flat_map(|&p| {
                let [r, g, b, a] = e.pixel(p);
                let channels = if grey { vec![r] } else { vec![r, g, b] };
                channels.into_iter().chain(alpha.then_some(a))
            });
            assert_eq!(e.samples(&picture), single.collect::<Vec<_>>());
        }
    }

    #[test]
    fn values_out_of_range_are_clipped() {
        let all = |c| file_value(Gamma::Power(1.0), FileGamma::Srgb, 8, c);
        assert_eq!([all(-1.0), all(2.0), all(f32::INFINITY), all(f32::NAN)], [0, 255, 255, 0]);
    }

    /// 0.7 of 255 is 178.5 - 3e-6, and 178.5 in single precision.
    #[test]
    fn ties_are_decided_in_single_precision() {
        let e = Encoding { alpha: true, ..Encoding::new(Gamma::Unmanaged) };
        assert_eq!(e.pixel(Pixel::new(Rgb::ZERO, 0.3))[3], 179);
    }

    #[test]
    fn equal_curves_cancel_without_rounding() {
        for i in 0..=255u16 {
            let c = f32::from(i) / 255.0;
            assert_eq!(file_value(Gamma::Srgb, FileGamma::Srgb, 8, c), i);
            assert_eq!(file_value(Gamma::Power(2.2), FileGamma::Power(2.2), 8, c), i);
        }
    }

    /// As measured: the reference takes the grey value before any curve.
    #[test]
    fn grey_is_of_working_values() {
        let mut picture = Picture::new(1, 1);
        picture.set(0, 0, Pixel::new(Rgb::new(0.2, 0.5, 0.8), 0.0));
        let grey_of = |working, file| {
            let e = Encoding { grey: true, bits: 16, file, ..Encoding::new(working) };
            e.samples(&picture)
        };
        let expected = (0.297 * 0.2 + 0.589 * 0.5 + 0.114 * 0.8) * 65535.0_f64;
        assert_eq!(grey_of(Gamma::Srgb, FileGamma::Srgb), [expected.round() as u16]);
        assert_eq!(grey_of(Gamma::Power(1.0), FileGamma::Power(1.0)), [expected.round() as u16]);
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
