//! Errors in light: what a picture is measured by when time is traded for accuracy.
//!
//! Working values become light and are clipped to 0..1, so that it does not matter by how much a highlight
//! exceeds what a file can hold. RMSE is taken over red, green and blue; PSNR is -20 log10 RMSE.

use super::load::Values;
use super::{Encoding, Picture, Pixel};
use crate::color::{Gamma, Rgb, linear_from_srgb};
use serde::Serialize;

/// Working values to light, clipped to 0..1.
#[derive(Clone, Debug)]
pub struct Light {
    /// Light at working values of 0 to 1; `None` if they are the same.
    table: Option<Vec<f32>>,
}

impl Light {
    /// Steps of the table. Between its entries light is a straight line, off by less than 1e-6.
    const STEPS: usize = 4096;

    pub fn new(working: Gamma) -> Self {
        let encoding = Encoding::new(working);
        let light = |i: usize| encoding.light(Rgb::splat(i as f32 / Self::STEPS as f32)).x;
        let straight = (light(Self::STEPS / 2) - 0.5).abs() < 1e-6;
        Self { table: (!straight).then(|| (0..=Self::STEPS).map(light).collect()) }
    }

    /// The light of one channel. What is not a number is dark.
    #[inline]
    pub fn of(&self, working: f32) -> f32 {
        let c = if working > 0.0 { working.min(1.0) } else { 0.0 };
        let Some(table) = &self.table else { return c };
        let place = c * Self::STEPS as f32;
        let i = (place as usize).min(Self::STEPS - 1);
        table[i] + (place - i as f32) * (table[i + 1] - table[i])
    }

    #[inline]
    pub fn pixel(&self, pixel: &Pixel) -> [f32; 3] {
        pixel.rgb.to_array().map(|c| self.of(c))
    }
}

/// How far two pictures of the same size are apart in light.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct LightError {
    pub rmse: f64,
    /// `None` for equal pictures.
    pub psnr_db: Option<f64>,
    /// The largest RMSE among squares of [`TILE`] pixels.
    pub worst_tile_rmse: f64,
}

/// Side of the squares whose worst is reported.
pub const TILE: u32 = 16;

/// Decibels of an RMSE; `None` for 0.
pub fn decibels(rmse: f64) -> Option<f64> {
    (rmse > 0.0).then(|| -20.0 * rmse.log10())
}

/// The RMSE that decibels stand for.
pub fn rmse_from_decibels(db: f64) -> f64 {
    10f64.powf(-db / 20.0)
}

/// The measures. Both pictures have the same size.
pub fn compare(a: &Picture, b: &Picture, light: &Light) -> LightError {
    assert_eq!((a.width, a.height), (b.width, b.height), "pictures of one size are compared");
    measure(a.width, a.height, |i| squared_distance(light, &a.pixels[i], &b.pixels[i]))
}

/// The same for pictures from files. Both have the same size.
pub fn compare_values(a: &Values, b: &Values) -> LightError {
    assert_eq!((a.width, a.height), (b.width, b.height), "pictures of one size are compared");
    let light = |v: f32| linear_from_srgb(f64::from(v / 255.0).clamp(0.0, 1.0));
    measure(a.width, a.height, |i| {
        (0..3).map(|k| (light(a.pixels[i][k]) - light(b.pixels[i][k])).powi(2)).sum()
    })
}

/// `squared` gives the squared distance of pixel number i, over its channels.
fn measure(width: u32, height: u32, squared: impl Fn(usize) -> f64) -> LightError {
    let columns = width.div_ceil(TILE).max(1) as usize;
    let mut tiles = vec![(0.0f64, 0u32); columns * height.div_ceil(TILE).max(1) as usize];
    for y in 0..height {
        for x in 0..width {
            let tile = &mut tiles[(y / TILE) as usize * columns + (x / TILE) as usize];
            tile.0 += squared(y as usize * width as usize + x as usize);
            tile.1 += 1;
        }
    }
    let sum: f64 = tiles.iter().map(|t| t.0).sum();
    let rmse = (sum / (3.0 * f64::from(width) * f64::from(height)).max(1.0)).sqrt();
    let worst = tiles.iter().map(|t| t.0 / f64::from(3 * t.1.max(1))).fold(0.0, f64::max);
    LightError { rmse, psnr_db: decibels(rmse), worst_tile_rmse: worst.sqrt() }
}

fn squared_distance(light: &Light, p: &Pixel, q: &Pixel) -> f64 {
    light.pixel(p).iter().zip(light.pixel(q)).map(|(a, b)| f64::from(a - b).powi(2)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flat(width: u32, height: u32, value: f32) -> Picture {
        let pixel = Pixel::new(Rgb::splat(value), 0.0);
        Picture { width, height, pixels: vec![pixel; (width * height) as usize] }
    }

    #[test]
    fn the_table_follows_the_curves() {
        for working in [Gamma::Unmanaged, Gamma::Srgb, Gamma::Power(2.2), Gamma::Power(1.0)] {
            let (light, encoding) = (Light::new(working), Encoding::new(working));
            for i in 0..=1000 {
                let c = i as f32 / 1000.0;
                let exact = encoding.light(Rgb::splat(c)).x;
                assert!((light.of(c) - exact).abs() < 1e-6, "{working:?} {c}");
            }
            assert_eq!([-1.0, f32::NAN, 7.0].map(|c| light.of(c)), [0.0, 0.0, 1.0]);
        }
    }

    /// One pixel in a corner of a 20x20 picture is off by 0.3 in one of its channels: it stands alone in
    /// the last tile of 4x4 pixels.
    #[test]
    fn the_worst_tile_holds_the_error() {
        let a = flat(20, 20, 0.5);
        let mut b = a.clone();
        b.pixels[399].rgb.y = 0.8;
        let e = compare(&a, &b, &Light::new(Gamma::Power(1.0)));
        assert!((e.rmse - (0.09f64 / 1200.0).sqrt()).abs() < 1e-7, "{e:?}");
        assert!((e.worst_tile_rmse - (0.09f64 / 48.0).sqrt()).abs() < 1e-7, "{e:?}");
        assert!((e.psnr_db.unwrap() - 10.0 * (1200.0f64 / 0.09).log10()).abs() < 1e-5, "{e:?}");
    }

    #[test]
    fn light_above_white_is_white() {
        let e = compare(&flat(3, 3, 1.5), &flat(3, 3, 40.0), &Light::new(Gamma::Unmanaged));
        assert_eq!(e, LightError { rmse: 0.0, psnr_db: None, worst_tile_rmse: 0.0 });
    }

    #[test]
    fn decibels_and_rmse_are_two_names() {
        assert!((rmse_from_decibels(40.0) - 0.01).abs() < 1e-12);
        assert!((decibels(0.01).unwrap() - 40.0).abs() < 1e-12);
    }
}
