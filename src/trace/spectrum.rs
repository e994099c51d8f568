//! The colour of a band of wavelengths, for dispersion.
//!
//! A cumulative table from 375 to 740 nanometres: the colour of a band is the difference of its ends,
//! scaled so that the mean over all bands of the visible range is nearly white.

use crate::color::Rgb;

/// The visible range that dispersion splits, in nanometres.
const FIRST: f64 = 380.0;
pub(super) const WIDTH: f64 = 350.0;
/// The wavelength that is bent by the plain index of refraction.
pub(super) const MIDDLE: f64 = 555.0;

/// The middle wavelength and colour of each of `count` bands.
pub(super) fn bands(count: u32) -> impl Iterator<Item = (f64, Rgb)> {
    let width = WIDTH / f64::from(count);
    (0..count).map(move |b| {
        let wavelength = FIRST + width * (f64::from(b) + 0.5);
        (wavelength, hue(wavelength, width))
    })
}

/// The colour of the band of `width` around `wavelength`.
fn hue(wavelength: f64, width: f64) -> Rgb {
    (cumulative(wavelength + 0.5 * width) - cumulative(wavelength - 0.5 * width)) * (WIDTH / width) as f32
}

fn cumulative(wavelength: f64) -> Rgb {
    let x = ((wavelength - START) / STEP).clamp(0.0, (TABLE.len() - 1) as f64);
    let i = (x as usize).min(TABLE.len() - 2);
    let row = |i: usize| Rgb::from_array(TABLE[i]);
    row(i).lerp(row(i + 1), (x - i as f64) as f32)
}

const START: f64 = 375.0;
const STEP: f64 = 5.0;

#[rustfmt::skip]
const TABLE: [[f32; 3]; 74] = [
    [0.0000, 0.0000, 0.0000], [0.0009, 0.0000, 0.0038], [0.0029, 0.0000, 0.0113],
    [0.0058, 0.0000, 0.0222], [0.0094, 0.0000, 0.0363], [0.0135, 0.0000, 0.0534],
    [0.0178, 0.0000, 0.0734], [0.0223, 0.0000, 0.0960], [0.0267, 0.0000, 0.1210],
    [0.0308, 0.0000, 0.1482], [0.0344, 0.0000, 0.1775], [0.0374, 0.0000, 0.2085],
    [0.0394, 0.0000, 0.2412], [0.0404, 0.0000, 0.2753], [0.0404, 0.0000, 0.3106],
    [0.0404, 0.0000, 0.3470], [0.0404, 0.0000, 0.3841], [0.0404, 0.0000, 0.4219],
    [0.0404, 0.0000, 0.4600], [0.0404, 0.0000, 0.4984], [0.0404, 0.0000, 0.5368],
    [0.0404, 0.0000, 0.5750], [0.0404, 0.0000, 0.6128], [0.0404, 0.0000, 0.6500],
    [0.0404, 0.0000, 0.6864], [0.0404, 0.0045, 0.7218], [0.0404, 0.0131, 0.7560],
    [0.0404, 0.0256, 0.7888], [0.0404, 0.0417, 0.8200], [0.0404, 0.0612, 0.8494],
    [0.0404, 0.0839, 0.8768], [0.0404, 0.1095, 0.9020], [0.0404, 0.1378, 0.9248],
    [0.0404, 0.1684, 0.9449], [0.0404, 0.2013, 0.9623], [0.0404, 0.2360, 0.9767],
    [0.0404, 0.2724, 0.9878], [0.0404, 0.3102, 0.9956], [0.0404, 0.3492, 0.9997],
    [0.0404, 0.3891, 1.0000], [0.0429, 0.4297, 1.0000], [0.0502, 0.4707, 1.0000],
    [0.0620, 0.5119, 1.0000], [0.0780, 0.5530, 1.0000], [0.0979, 0.5937, 1.0000],
    [0.1215, 0.6340, 1.0000], [0.1483, 0.6733, 1.0000], [0.1781, 0.7117, 1.0000],
    [0.2105, 0.7487, 1.0000], [0.2454, 0.7841, 1.0000], [0.2823, 0.8178, 1.0000],
    [0.3210, 0.8494, 1.0000], [0.3611, 0.8786, 1.0000], [0.4024, 0.9054, 1.0000],
    [0.4446, 0.9293, 1.0000], [0.4873, 0.9501, 1.0000], [0.5302, 0.9677, 1.0000],
    [0.5731, 0.9817, 1.0000], [0.6155, 0.9919, 1.0000], [0.6573, 0.9981, 1.0000],
    [0.6982, 1.0000, 1.0000], [0.7377, 1.0000, 1.0000], [0.7756, 1.0000, 1.0000],
    [0.8116, 1.0000, 1.0000], [0.8454, 1.0000, 1.0000], [0.8767, 1.0000, 1.0000],
    [0.9052, 1.0000, 1.0000], [0.9306, 1.0000, 1.0000], [0.9525, 1.0000, 1.0000],
    [0.9707, 1.0000, 1.0000], [0.9849, 1.0000, 1.0000], [0.9947, 1.0000, 1.0000],
    [0.9998, 1.0000, 1.0000], [1.0000, 1.0000, 1.0000],
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seven_bands_make_the_measured_white() {
        let mean = bands(7).map(|(_, hue)| hue).sum::<Rgb>() / 7.0;
        assert!((mean - Rgb::new(0.9938, 1.0, 0.9962)).length() < 2e-4, "{mean}");
    }
}
