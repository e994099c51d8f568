//! Dithering: the rounding of file values hidden in a pattern, or handed on to the neighbours.
//!
//! | method | what happens to the error |
//! |--------|---------------------------|
//! | Bayer 2, 3, 4 | nothing: an offset from a matrix is added to the encoded value before it is clipped |
//! | Floyd-Steinberg | 7/16 right, 3/16 below left, 5/16 below, 1/16 below right |
//! | diffusion 1 | all to the right, from the end of a row to the start of the next |
//! | diffusion 2 | 1/2 right, 1/4 below, 1/4 below right |
//!
//! Errors are differences of light and are added to the next pixel's light. As in the reference, what
//! Floyd-Steinberg and diffusion 2 hand to a row's first pixel is lost: that pixel gets again what the first
//! pixel of the row above got.

use super::{Encoding, Picture, Pixel};

#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Dither {
    #[default]
    None,
    /// With the side of the matrix, 2 to 4.
    Bayer(u8),
    FloydSteinberg,
    Diffusion1,
    Diffusion2,
}

/// Offsets in parts of m², by column and row.
const BAYER_2: [[f32; 2]; 2] = [[-1.0, 1.0], [2.0, 0.0]];
const BAYER_3: [[f32; 3]; 3] = [[-1.5, 2.5, -0.5], [1.5, -3.5, 4.5], [-2.5, 3.5, 0.5]];
const BAYER_4: [[f32; 4]; 4] =
    [[-7.0, 1.0, -5.0, 3.0], [5.0, -3.0, 7.0, -1.0], [-4.0, 4.0, -6.0, 2.0], [8.0, 0.0, 6.0, -2.0]];

/// The offset at a pixel, in steps of the file's values.
fn bayer(side: u8, x: usize, y: usize) -> f32 {
    match side {
        2 => BAYER_2[x % 2][y % 2] / 4.0,
        3 => BAYER_3[x % 3][y % 3] / 9.0,
        _ => BAYER_4[x % 4][y % 4] / 16.0,
    }
}

type Channels = [f32; 4];

/// Errors on their way to pixels that come later.
struct Carry {
    this_row: Vec<Channels>,
    next_row: Vec<Channels>,
    /// What the first pixel of the row above got.
    first: Channels,
}

/// Quantised channels of all pixels, four each; the fourth is alpha.
pub fn samples(picture: &Picture, encoding: &Encoding, method: Dither) -> Vec<[u16; 4]> {
    let width = picture.width as usize;
    let mut carry =
        Carry { this_row: vec![[0.0; 4]; width + 1], next_row: vec![[0.0; 4]; width + 1], first: [0.0; 4] };
    let mut out = Vec::with_capacity(picture.pixels.len());
    for y in 0..picture.height {
        for (x, &pixel) in picture.row(y).iter().enumerate() {
            out.push(match method {
                Dither::Bayer(side) => encoding.offset_pixel(pixel, bayer(side, x, y as usize)),
                _ => diffused(pixel, encoding, method, &mut carry, x),
            });
        }
        carry.next(method, width);
    }
    out
}

fn diffused(pixel: Pixel, encoding: &Encoding, method: Dither, carry: &mut Carry, x: usize) -> [u16; 4] {
    let repeats = x == 0 && matches!(method, Dither::FloydSteinberg | Dither::Diffusion2);
    let got = if repeats { carry.first } else { carry.this_row[x] };
    let light = encoding.light_channels(pixel);
    let wanted: Channels = std::array::from_fn(|c| light[c] + got[c]);
    let quantised = encoding.quantised_light(wanted);
    let shown = encoding.shown_light(quantised);
    let error: Channels = std::array::from_fn(|c| wanted[c].clamp(0.0, 1.0) - shown[c]);
    carry.hand_on(error, method, x);
    quantised
}

impl Carry {
    fn hand_on(&mut self, error: Channels, method: Dither, x: usize) {
        let add = |to: &mut Channels, share: f32| {
            for (t, e) in to.iter_mut().zip(error) {
                *t += e * share;
            }
        };
        match method {
            Dither::FloydSteinberg => {
                add(&mut self.this_row[x + 1], 7.0 / 16.0);
                if x > 0 {
                    add(&mut self.next_row[x - 1], 3.0 / 16.0);
                }
                add(&mut self.next_row[x], 5.0 / 16.0);
                add(&mut self.next_row[x + 1], 1.0 / 16.0);
            }
            Dither::Diffusion2 => {
                add(&mut self.this_row[x + 1], 0.5);
                add(&mut self.next_row[x], 0.25);
                add(&mut self.next_row[x + 1], 0.25);
            }
            Dither::Diffusion1 => self.this_row[x + 1] = error,
            Dither::None | Dither::Bayer(_) => {}
        }
    }

    /// Goes on to the next row.
    fn next(&mut self, method: Dither, width: usize) {
        let over_the_edge = self.this_row[width];
        self.first = self.this_row[0];
        std::mem::swap(&mut self.this_row, &mut self.next_row);
        self.next_row.fill([0.0; 4]);
        if method == Dither::Diffusion1 {
            self.this_row[0] = over_the_edge;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::{Gamma, Rgb};

    fn flat(value: f32, width: u32, height: u32) -> Picture {
        let mut picture = Picture::new(width, height);
        picture.pixels.fill(Pixel::new(Rgb::splat(value), 0.0));
        picture
    }

    /// The reference's matrices, which are brighter than the middle: by 1/8 for the smallest.
    #[test]
    fn matrices_are_added() {
        let e = Encoding::new(Gamma::Unmanaged);
        let all = samples(&flat(100.25 / 255.0, 2, 2), &e, Dither::Bayer(2));
        assert_eq!(all.iter().map(|s| s[0]).collect::<Vec<_>>(), [100, 101, 101, 100]);
        let mean = |side: u8| {
            let n = usize::from(side);
            (0..n * n).map(|i| bayer(side, i % n, i / n)).sum::<f32>() / (n * n) as f32
        };
        assert_eq!([mean(2), mean(3), mean(4)], [0.125, 0.5 / 9.0, 0.03125]);
    }

    /// The mean of a dithered flat picture is its value, between two steps.
    #[test]
    fn errors_are_not_lost() {
        let e = Encoding::new(Gamma::Unmanaged);
        for method in [Dither::FloydSteinberg, Dither::Diffusion1, Dither::Diffusion2] {
            let value = 100.25;
            let all = samples(&flat(value / 255.0, 64, 64), &e, method);
            let mean = all.iter().map(|s| f64::from(s[0])).sum::<f64>() / all.len() as f64;
            assert!((mean - f64::from(value)).abs() < 0.05, "{method:?}: {mean}");
            assert!(all.iter().all(|s| s[0] == 100 || s[0] == 101), "{method:?}");
        }
    }

    /// 1/4 of a step is carried along the row until it makes a step.
    #[test]
    fn diffusion_1_runs_from_row_to_row() {
        let e = Encoding::new(Gamma::Unmanaged);
        let all = samples(&flat(10.25 / 255.0, 3, 2), &e, Dither::Diffusion1);
        assert_eq!(all.iter().map(|s| s[0]).collect::<Vec<_>>(), [10, 11, 10, 10, 10, 11]);
    }

    #[test]
    fn whole_steps_stay() {
        let e = Encoding::new(Gamma::Power(1.0));
        let value = crate::color::linear_from_srgb(77.0 / 255.0) as f32;
        let all = samples(&flat(value, 8, 8), &e, Dither::FloydSteinberg);
        assert!(all.iter().all(|s| s[..3] == [77; 3] && s[3] == 255));
    }
}
