//! How far two pictures are apart.
//!
//! All measures are of 8-bit file values. Where either picture lets something show through, alpha is
//! compared as a fourth channel and colours are premultiplied.

use super::load::Values;
use serde::Serialize;

/// Pixels that differ by more than this many steps in any channel are counted.
pub const VISIBLE_STEPS: f32 = 8.0;

/// Measures of a pair of pictures.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Difference {
    /// 10 log10(255² / mean squared difference) in decibels; `None` when the pictures are equal.
    pub psnr_db: Option<f64>,
    /// Root of the mean squared difference, in steps of 1/255.
    pub rmse: f64,
    /// The largest difference of a channel, in steps of 1/255.
    pub max_abs: f64,
    /// The share (0 to 1) of pixels with a channel that is off by more than 8/255.
    pub off_by_8_share: f64,
}

impl Difference {
    /// Whether the pictures are at least as near as `min_psnr` decibels.
    pub fn reaches(&self, min_psnr: f64) -> bool {
        self.psnr_db.is_none_or(|db| db >= min_psnr)
    }
}

/// The measures, or the sizes' mismatch as a message.
pub fn compare(a: &Values, b: &Values) -> Result<Difference, String> {
    check_sizes(a, b)?;
    let channels = if a.has_alpha() || b.has_alpha() { 4 } else { 3 };
    let (mut squares, mut max, mut off) = (0.0f64, 0.0f32, 0usize);
    for (p, q) in a.pixels.iter().zip(&b.pixels) {
        let mut worst = 0.0f32;
        for c in 0..channels {
            let d = (p[c] - q[c]).abs();
            squares += f64::from(d) * f64::from(d);
            worst = worst.max(d);
        }
        max = max.max(worst);
        off += usize::from(worst > VISIBLE_STEPS);
    }
    let n = a.pixels.len().max(1);
    let mse = squares / (n * channels) as f64;
    Ok(Difference {
        psnr_db: (mse > 0.0).then(|| 10.0 * (255.0f64 * 255.0 / mse).log10()),
        rmse: mse.sqrt(),
        max_abs: f64::from(max),
        off_by_8_share: off as f64 / n as f64,
    })
}

fn check_sizes(a: &Values, b: &Values) -> Result<(), String> {
    if (a.width, a.height) == (b.width, b.height) {
        return Ok(());
    }
    Err(format!("the pictures differ in size: {}x{} and {}x{}", a.width, a.height, b.width, b.height))
}

/// Structural similarity of brightness with a chroma term, 1 for equal pictures; `None` where a picture is
/// too small for it.
pub fn perceptual(a: &Values, b: &Values) -> Option<f64> {
    let score = image_compare::rgb_hybrid_compare(&rgb8(a), &rgb8(b)).ok()?.score;
    score.is_finite().then_some(score)
}

fn rgb8(values: &Values) -> image::RgbImage {
    let bytes = values.pixels.iter().flat_map(|p| [p[0], p[1], p[2]].map(|c| c.round() as u8)).collect();
    image::RgbImage::from_raw(values.width, values.height, bytes).expect("as many pixels as the size says")
}

/// How much a difference is brightened where it is shown.
pub const GAIN: f32 = 8.0;

/// A picture of the absolute differences, brightened [`GAIN`] times, as 8-bit red, green, blue.
pub fn difference_image(a: &Values, b: &Values) -> Result<image::RgbImage, String> {
    check_sizes(a, b)?;
    let step = |p: f32, q: f32| ((p - q).abs() * GAIN).min(255.0).round() as u8;
    let pixels = a.pixels.iter().zip(&b.pixels);
    let bytes = pixels.flat_map(|(p, q)| {
        let hidden = step(p[3], q[3]);
        [0, 1, 2].map(|c| step(p[c], q[c]).max(hidden))
    });
    Ok(image::RgbImage::from_raw(a.width, a.height, bytes.collect()).expect("sizes were compared"))
}

/// The bytes of an 8-bit PNG.
pub fn png_bytes(image: &image::RgbImage) -> Result<Vec<u8>, String> {
    let mut out = std::io::Cursor::new(Vec::new());
    image.write_to(&mut out, image::ImageFormat::Png).map_err(|e| e.to_string())?;
    Ok(out.into_inner())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flat(width: u32, height: u32, value: [f32; 4]) -> Values {
        Values { width, height, pixels: vec![value; (width * height) as usize] }
    }

    #[test]
    fn equal_pictures_have_no_psnr() {
        let a = flat(4, 4, [1.0, 2.0, 3.0, 255.0]);
        let d = compare(&a, &a).unwrap();
        assert_eq!(d, Difference { psnr_db: None, rmse: 0.0, max_abs: 0.0, off_by_8_share: 0.0 });
        assert!(d.reaches(99.0));
    }

    /// One channel of one pixel in ten is off by 30: MSE = 900 / 30 = 30.
    #[test]
    fn one_spot_is_measured() {
        let a = flat(5, 2, [10.0, 20.0, 30.0, 255.0]);
        let mut b = a.clone();
        b.pixels[7][1] += 30.0;
        let d = compare(&a, &b).unwrap();
        assert!((d.psnr_db.unwrap() - 10.0 * (65025.0f64 / 30.0).log10()).abs() < 1e-9);
        assert!((d.rmse - 30f64.sqrt()).abs() < 1e-9);
        assert_eq!((d.max_abs, d.off_by_8_share), (30.0, 0.1));
        assert!(d.reaches(33.0) && !d.reaches(34.0));
    }

    #[test]
    fn eight_steps_are_not_more_than_eight() {
        let a = flat(2, 1, [100.0, 100.0, 100.0, 255.0]);
        let mut b = a.clone();
        b.pixels[0][0] = 108.0;
        b.pixels[1][2] = 91.0;
        assert_eq!(compare(&a, &b).unwrap().off_by_8_share, 0.5);
    }

    #[test]
    fn alpha_counts_where_there_is_any() {
        let a = flat(1, 1, [0.0, 0.0, 0.0, 255.0]);
        let b = flat(1, 1, [0.0, 0.0, 0.0, 155.0]);
        assert_eq!(compare(&a, &b).unwrap().rmse, 50.0);
    }

    #[test]
    fn sizes_must_be_equal() {
        let error = compare(&flat(2, 1, [0.0; 4]), &flat(1, 2, [0.0; 4])).unwrap_err();
        assert_eq!(error, "the pictures differ in size: 2x1 and 1x2");
    }

    #[test]
    fn the_difference_is_brightened() {
        let a = flat(1, 1, [10.0, 20.0, 30.0, 255.0]);
        let b = flat(1, 1, [12.0, 20.0, 130.0, 255.0]);
        assert_eq!(difference_image(&a, &b).unwrap().get_pixel(0, 0).0, [16, 0, 255]);
    }

    #[test]
    fn perceptual_measure_falls_with_structure() {
        let mut a = flat(32, 32, [128.0, 128.0, 128.0, 255.0]);
        for (i, p) in a.pixels.iter_mut().enumerate() {
            p[0] = (i * 7 % 256) as f32;
        }
        let mut b = a.clone();
        b.pixels.reverse();
        assert!(perceptual(&a, &a).unwrap() > 0.999);
        assert!(perceptual(&a, &b).unwrap() < 0.9);
    }
}
