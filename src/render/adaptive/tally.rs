//! What has been found out about every pixel.

use crate::color::Rgb;
use crate::picture::Pixel;
use crate::render::Region;

/// Samples of one pixel, summed up.
#[derive(Clone, Copy, Debug, Default)]
pub struct Samples {
    pub count: u32,
    /// Of red, green, blue and transmit.
    pub mean: [f32; 4],
    /// Sums of squared deviations from the mean, per channel.
    pub spread: [f32; 4],
    /// Rays followed for them.
    pub rays: f32,
}

impl Samples {
    /// Sums up; sums are kept in double precision relative to the first sample.
    pub fn of(mut samples: impl Iterator<Item = Pixel>) -> Self {
        let Some(first) = samples.next().map(channels) else { return Self::default() };
        let (mut sum, mut squares, mut count) = ([0.0f64; 4], [0.0f64; 4], 1u32);
        for sample in samples {
            let c = channels(sample);
            for k in 0..4 {
                let d = f64::from(c[k] - first[k]);
                sum[k] += d;
                squares[k] += d * d;
            }
            count += 1;
        }
        let n = f64::from(count);
        let mean = std::array::from_fn(|k| (f64::from(first[k]) + sum[k] / n) as f32);
        let spread = std::array::from_fn(|k| (squares[k] - sum[k] * sum[k] / n).max(0.0) as f32);
        Self { count, mean, spread, rays: 0.0 }
    }

    /// The samples of both.
    ///
    /// Reference: T. F. Chan, G. H. Golub, R. J. LeVeque, "Algorithms for computing the sample variance",
    /// The American Statistician 37 (1983).
    pub fn join(&self, other: &Samples) -> Samples {
        if self.count == 0 {
            return *other;
        }
        let (a, b) = (f64::from(self.count), f64::from(other.count));
        let mut joined = Samples { count: self.count + other.count, ..*self };
        for k in 0..4 {
            let d = f64::from(other.mean[k]) - f64::from(self.mean[k]);
            joined.mean[k] = (f64::from(self.mean[k]) + d * b / (a + b)) as f32;
            let spread = f64::from(self.spread[k]) + f64::from(other.spread[k]) + d * d * a * b / (a + b);
            joined.spread[k] = spread as f32;
        }
        joined.rays += other.rays;
        joined
    }

    #[inline]
    pub fn pixel(&self) -> Pixel {
        let [r, g, b, transmit] = self.mean;
        Pixel::new(Rgb::new(r, g, b), transmit)
    }
}

fn channels(p: Pixel) -> [f32; 4] {
    [p.rgb.x, p.rgb.y, p.rgb.z, p.transmit]
}

/// The pixels of a region, row by row.
#[derive(Clone, Debug)]
pub struct Tally {
    pub region: Region,
    pub pixels: Vec<Samples>,
}

impl Tally {
    pub fn new(region: Region) -> Self {
        Self { region, pixels: vec![Samples::default(); region.pixels() as usize] }
    }

    pub fn width(&self) -> usize {
        self.region.width() as usize
    }

    pub fn height(&self) -> usize {
        self.region.height() as usize
    }

    /// The picture position of pixel `i`.
    pub fn place(&self, i: usize) -> (u32, u32) {
        let (row, column) = (i / self.width(), i % self.width());
        (self.region.x0 + column as u32, self.region.y0 + row as u32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pixels() -> Vec<Pixel> {
        (0..7).map(|i| Pixel::new(Rgb::new(i as f32, 100.0 + (i * i) as f32, -1.0), 0.25)).collect()
    }

    /// 0 to 6: mean 3, squared deviations 9 4 1 0 1 4 9. Squares: mean 13, deviations' squares
    /// 169 144 81 16 9 144 529.
    #[test]
    fn mean_and_spread_are_those_of_the_list() {
        let s = Samples::of(pixels().into_iter());
        assert_eq!((s.count, s.mean, s.spread), (7, [3.0, 113.0, -1.0, 0.25], [28.0, 1092.0, 0.0, 0.0]));
    }

    #[test]
    fn joined_parts_are_the_whole() {
        let whole = Samples::of(pixels().into_iter());
        for cut in 0..7 {
            let (a, b) = (pixels()[..cut].to_vec(), pixels()[cut..].to_vec());
            let joined = Samples::of(a.into_iter()).join(&Samples::of(b.into_iter()));
            assert_eq!(joined.count, 7);
            for k in 0..4 {
                assert!((joined.mean[k] - whole.mean[k]).abs() < 1e-5, "{cut} {joined:?}");
                assert!((joined.spread[k] - whole.spread[k]).abs() < 1e-3, "{cut} {joined:?}");
            }
        }
    }

    #[test]
    fn places_count_from_the_region() {
        let tally = Tally::new(Region { x0: 3, y0: 5, x1: 7, y1: 8 });
        assert_eq!((tally.place(0), tally.place(4), tally.place(11)), ((3, 5), (3, 6), (6, 7)));
    }
}
