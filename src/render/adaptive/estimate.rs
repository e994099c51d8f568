//! What error a pixel's mean still has, in light (squared, summed over red, green and blue).
//!
//! A pixel's own samples may agree by chance, so they are not asked alone: a prior from the eight
//! neighbours stands beside them with the weight of [`PRIOR_WEIGHT`] samples. The prior is the larger of
//!
//! * what is left of the nine means when the plane through them is taken away (edges between pixels), and
//! * the variance inside the neighbours (features thinner than a pixel that some of them have met).
//!
//! Both are exact for no picture; what they are worth is found out by [`super::calibration`]. The variance
//! of one sample becomes that of the mean of n by [`Convergence`].

use super::convergence::{Convergence, LEVELS, level};
use super::lift::lift;
use super::tally::{Samples, Tally};
use crate::color::Rgb;
use crate::picture::light::Light;
use glam::Vec3A;
use rayon::prelude::*;

/// How many samples the neighbours' testimony is worth.
const PRIOR_WEIGHT: f32 = 1.5;
/// Between the residual of a plane through nine pixels and the variance inside the middle one, at edges of
/// random place and direction.
const RESIDUAL_TO_VARIANCE: f32 = 0.75;
/// A pixel's linear shading adds slope²/12 to the variance of its samples, but nothing to its mean's error.
const SLOPE_TO_VARIANCE: f32 = 1.0 / 12.0;
/// Where colours are curved, lifting a pixel is off by this share of what it adds (squared).
const LIFT_TO_ERROR: f32 = 0.36;
/// However steep: this share of the samples' variance is left.
const LEAST_SHARE: f32 = 0.1;
/// Neighbours in flat surroundings differ by less, in each channel of light.
pub const ALIKE: f32 = 1.0 / 1024.0;

/// Change of light per pixel along x and y, for each channel.
type Slope = [Vec3A; 2];

/// What is known of one pixel's error.
#[derive(Clone, Copy, Debug, Default)]
pub struct Expected {
    /// Squared error of the mean, summed over the channels, as samples and neighbours tell,
    pub plain: f32,
    /// with what is known of the place ([`super::locality`]),
    pub local: f32,
    /// and with what is known of its class ([`super::calibration`]).
    pub variance: f32,
}

/// What a pixel's surroundings say of it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Around {
    /// What is left of the means when a plane is taken away, per degree of freedom, over the channels.
    residual: f32,
    /// Variance inside the neighbours.
    within: f32,
    /// How light changes, so far as neighbours agree on it.
    slope: Slope,
    /// What is added to the pixel's mean ([`super::lift`]).
    pub lift: Rgb,
}

/// One pixel as its neighbours see it.
#[derive(Clone, Copy, Debug, Default)]
struct Seen {
    light: Vec3A,
    /// Sum over the channels of the variance of a sample, times its degrees of freedom.
    spread: f32,
    /// Degrees of freedom: one less than samples.
    freedom: f32,
    /// Whether there is any.
    sampled: bool,
}

/// All pixels with their surroundings, kept up to date.
#[derive(Clone, Debug)]
pub struct Survey {
    width: usize,
    seen: Vec<Seen>,
    pub around: Vec<Around>,
    /// Pixels that have got samples since the last look.
    changed: Vec<bool>,
}

impl Survey {
    pub fn new(tally: &Tally) -> Self {
        let n = tally.pixels.len();
        Self {
            width: tally.width(),
            seen: vec![Seen::default(); n],
            around: vec![Around::default(); n],
            changed: vec![true; n],
        }
    }

    /// Pixel `i` has got samples.
    pub fn touch(&mut self, i: usize) {
        self.changed[i] = true;
    }

    /// Which pixels have got samples since the last look.
    pub fn changed(&mut self) -> &mut [bool] {
        &mut self.changed
    }

    /// Looks at what has changed, and gives the expected errors of all pixels.
    pub fn look(&mut self, tally: &Tally, light: &Light, convergence: &Convergence) -> Vec<Expected> {
        let (changed, width) = (&self.changed, self.width.max(1));
        let rows = self.seen.par_chunks_mut(width).zip(tally.pixels.par_chunks(width));
        rows.zip(changed.par_chunks(width)).for_each(|((seen, pixels), changed)| {
            for ((seen, samples), _) in seen.iter_mut().zip(pixels).zip(changed).filter(|(_, c)| **c) {
                *seen = Seen::new(samples, light);
            }
        });
        let view = View { seen: &self.seen, width: self.width };
        let gain = convergence.gain();
        let mut expected = vec![Expected::default(); self.seen.len()];
        let stale = near(changed, width);
        let rows = self.around.par_chunks_mut(width).zip(expected.par_chunks_mut(width)).enumerate();
        rows.for_each(|(y, (around, expected))| {
            let samples = &tally.pixels[y * width..][..width];
            let stale = &stale[y * width..][..width];
            let row = around.iter_mut().zip(expected).zip(samples.iter().zip(stale)).enumerate();
            for (x, ((around, expected), (samples, stale))) in row {
                if samples.count == 0 {
                    continue;
                }
                if *stale {
                    *around = Around { lift: lift(tally, x, y), ..view.around(x, y) };
                }
                let plain = around.expected(samples, light, &gain);
                *expected = Expected { plain, local: plain, variance: plain };
            }
        });
        self.changed.fill(false);
        expected
    }

    /// For each pixel of one sample whose neighbours are all alike: by how much (squared) it stands out.
    pub fn surprises(&self) -> impl Iterator<Item = f32> {
        let view = View { seen: &self.seen, width: self.width };
        let (width, height) = (self.width, self.seen.len() / self.width.max(1));
        let inner = (1..height.saturating_sub(1))
            .flat_map(move |y| (1..width.saturating_sub(1)).map(move |x| (x, y)));
        inner.filter_map(move |(x, y)| view.surprise(x, y))
    }
}

impl Seen {
    fn new(samples: &Samples, light: &Light) -> Self {
        let freedom = samples.count.saturating_sub(1) as f32;
        Self {
            light: light.pixel(&samples.pixel()).into(),
            spread: variance_of_mean(samples, light, 1.0) * freedom,
            freedom,
            sampled: samples.count > 0,
        }
    }

    fn is_like(&self, other: &Seen) -> bool {
        (self.light - other.light).abs().cmplt(Vec3A::splat(ALIKE)).all()
    }
}

/// Which pixels are marked or have a neighbour that is.
fn near(marked: &[bool], width: usize) -> Vec<bool> {
    let mut rows = marked.to_vec();
    for (row, marked) in rows.chunks_mut(width).zip(marked.chunks(width)) {
        let n = row.len();
        row[1..].iter_mut().zip(&marked[..n - 1]).for_each(|(r, m)| *r |= m);
        row[..n - 1].iter_mut().zip(&marked[1..]).for_each(|(r, m)| *r |= m);
    }
    let mut all = rows.clone();
    let n = all.len();
    all[width.min(n)..].iter_mut().zip(&rows[..n - width.min(n)]).for_each(|(a, r)| *a |= r);
    all[..n - width.min(n)].iter_mut().zip(&rows[width.min(n)..]).for_each(|(a, r)| *a |= r);
    all
}

/// The variance in light of a mean whose working variance is `gain` times that of a sample.
fn variance_of_mean(samples: &Samples, light: &Light, gain: f32) -> f32 {
    if samples.count < 2 {
        return 0.0;
    }
    let mut sum = 0.0;
    for k in 0..3 {
        if samples.spread[k] > 0.0 {
            let sigma = (samples.spread[k] / (samples.count - 1) as f32 * gain).sqrt();
            let half = 0.5 * (light.of(samples.mean[k] + sigma) - light.of(samples.mean[k] - sigma));
            sum += half * half;
        }
    }
    sum
}

/// The pixels as they see each other.
#[derive(Clone, Copy)]
struct View<'a> {
    seen: &'a [Seen],
    width: usize,
}

impl View<'_> {
    /// A pixel and those around it, row by row.
    fn neighbours(self, x: usize, y: usize) -> impl Iterator<Item = usize> {
        let (width, height) = (self.width, self.seen.len() / self.width);
        let columns = x.saturating_sub(1)..(x + 2).min(width);
        (y.saturating_sub(1)..(y + 2).min(height))
            .flat_map(move |yy| columns.clone().map(move |xx| yy * width + xx))
    }

    fn around(self, x: usize, y: usize) -> Around {
        let own = &self.seen[y * self.width + x];
        let mut sums = Sums { spread: -own.spread, freedom: -own.freedom, ..Sums::default() };
        let height = self.seen.len() / self.width;
        let columns = x.saturating_sub(1)..(x + 2).min(self.width);
        for yy in y.saturating_sub(1)..(y + 2).min(height) {
            let down = yy as f32 - y as f32;
            let row = &self.seen[yy * self.width..][..self.width][columns.clone()];
            for (k, s) in row.iter().enumerate() {
                let right = (columns.start + k) as f32 - x as f32;
                sums.add(s, own.light, right, down);
            }
        }
        let within = if sums.freedom > 0.5 { (sums.spread / sums.freedom).max(0.0) } else { 0.0 };
        if sums.vv == Vec3A::ZERO {
            return Around { within, ..Around::default() };
        }
        let (residual, slope) = sums.plane();
        Around { residual, within, slope, ..Around::default() }
    }

    fn surprise(self, x: usize, y: usize) -> Option<f32> {
        let own = y * self.width + x;
        let first = &self.seen[own - self.width - 1];
        let alike =
            self.neighbours(x, y).all(|i| self.seen[i].sampled && (i == own || self.seen[i].is_like(first)));
        let own = &self.seen[own];
        (own.freedom == 0.0 && alike).then(|| own.light.distance_squared(first.light))
    }
}

/// What a plane through pixels is worked out from: places relative to the middle one's centre, values to its.
#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    spread: f32,
    freedom: f32,
    n: f32,
    x: f32,
    y: f32,
    xx: f32,
    xy: f32,
    yy: f32,
    v: Vec3A,
    xv: Vec3A,
    yv: Vec3A,
    vv: Vec3A,
}

impl Sums {
    #[inline(always)]
    fn add(&mut self, s: &Seen, base: Vec3A, x: f32, y: f32) {
        let v = s.light - base;
        self.spread += s.spread;
        self.freedom += s.freedom;
        self.n += 1.0;
        (self.x, self.y) = (self.x + x, self.y + y);
        (self.xx, self.xy, self.yy) = (self.xx + x * x, self.xy + x * y, self.yy + y * y);
        (self.v, self.xv) = (self.v + v, self.xv + x * v);
        (self.yv, self.vv) = (self.yv + y * v, self.vv + v * v);
    }

    /// The plane nearest to the pixels: mean squared residual over the channels, and slopes, made smaller the less
    /// the plane explains.
    fn plane(&self) -> (f32, Slope) {
        let n = self.n;
        let (xx, xy) = (self.xx - self.x * self.x / n, self.xy - self.x * self.y / n);
        let yy = self.yy - self.y * self.y / n;
        let det = xx * yy - xy * xy;
        if n < 4.0 || det <= 1e-3 * xx * yy {
            return (0.0, Slope::default());
        }
        let (xv, yv) = (self.xv - self.x * self.v / n, self.yv - self.y * self.v / n);
        let vv = self.vv - self.v * self.v / n;
        let (gx, gy) = ((xv * yy - yv * xy) / det, (yv * xx - xv * xy) / det);
        let explained = (gx * xv + gy * yv).max(Vec3A::splat(f32::MIN_POSITIVE));
        let left = (vv - explained).max(Vec3A::ZERO) / (n - 3.0);
        let share = (Vec3A::ONE - 2.0 * left / explained).max(Vec3A::ZERO);
        (left.element_sum(), [gx * share, gy * share])
    }
}

impl Around {
    fn expected(&self, samples: &Samples, light: &Light, gain: &[f32; LEVELS]) -> f32 {
        let gain = gain[level(samples.count)];
        let prior = (RESIDUAL_TO_VARIANCE * self.residual).max(self.within) * gain;
        let freedom = samples.count.saturating_sub(1) as f32;
        let raw = variance_of_mean(samples, light, gain);
        let slope = self.slope[0].length_squared() + self.slope[1].length_squared();
        let own = (raw - SLOPE_TO_VARIANCE * slope * gain).max(LEAST_SHARE * raw);
        let curved = LIFT_TO_ERROR * self.lift.length_squared();
        (PRIOR_WEIGHT * prior + freedom * own) / (PRIOR_WEIGHT + freedom) + curved
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::{Gamma, Rgb};
    use crate::picture::Pixel;
    use crate::render::Region;

    /// One sample in the centre of each pixel.
    fn look(width: u32, height: u32, color: impl Fn(u32, u32) -> f32) -> (Survey, Vec<Expected>) {
        let mut tally = Tally::new(Region::whole(width, height));
        for i in 0..tally.pixels.len() {
            let (x, y) = tally.place(i);
            tally.pixels[i] = Samples::of([Pixel::new(Rgb::splat(color(x, y)), 0.0)].into_iter());
        }
        let mut survey = Survey::new(&tally);
        let light = Light::new(Gamma::Power(1.0));
        let expected = survey.look(&tally, &light, &Convergence::default());
        (survey, expected)
    }

    #[test]
    fn a_plane_is_no_error() {
        let (survey, expected) = look(7, 5, |x, y| 0.2 + 0.05 * x as f32 - 0.03 * y as f32);
        assert!(expected.iter().all(|e| e.plain < 1e-8), "{expected:?}");
        for around in &survey.around {
            assert!((around.slope[0] - Vec3A::splat(0.05)).abs().max_element() < 1e-5, "{around:?}");
            assert!((around.slope[1] + Vec3A::splat(0.03)).abs().max_element() < 1e-5, "{around:?}");
        }
        assert_eq!(survey.surprises().count(), 0);
    }

    /// An edge between columns 3 and 4 makes both suspect, and no other.
    #[test]
    fn an_edge_makes_its_neighbours_suspect() {
        let (_, expected) = look(8, 5, |x, _| if x < 4 { 0.0 } else { 1.0 });
        for (i, e) in expected.iter().enumerate() {
            assert_eq!(e.plain > 0.02, (3..5).contains(&(i % 8)), "{i} {e:?}");
        }
    }

    #[test]
    fn neighbours_of_what_is_marked_are_near() {
        let mut marked = vec![false; 35];
        marked[2 * 7 + 6] = true;
        marked[0] = true;
        let found: Vec<usize> = (0..35).filter(|&i| near(&marked, 7)[i]).collect();
        assert_eq!(found, [0, 1, 7, 8, 12, 13, 19, 20, 26, 27]);
    }

    /// A speck in flat surroundings surprises once; its neighbours are not in flat surroundings.
    #[test]
    fn a_speck_is_a_surprise() {
        let (survey, _) = look(9, 9, |x, y| if (x, y) == (4, 4) { 0.5 } else { 0.25 });
        let surprises: Vec<f32> = survey.surprises().collect();
        assert_eq!(surprises.len(), 49 - 8);
        assert_eq!(surprises.iter().filter(|s| **s > 0.0).count(), 1);
        assert!((surprises.iter().sum::<f32>() - 3.0 * 0.0625).abs() < 1e-6);
    }
}
