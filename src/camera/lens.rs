//! Depth of field: rays from points all over the lens that meet again in the sharp plane.
//!
//! Places on the lens (of diameter 1) come from fixed hexagonal grids, larger numbers from a Halton
//! sequence with one point per cell of a square grid; places on the picture and the lens are shaken by
//! hashes of the picture position. After each batch the variance of the mean decides whether more follow.
//!
//! | parameter | default | meaning |
//! |---|---|---|
//! | aperture | 0 | diameter of the lens |
//! | blur_samples | 0 | fewest and most rays |
//! | confidence | 0.9 | probability of stopping rightly |
//! | variance | 0.0001 | variance of the mean that is good enough |
//! | focal_point | | a point of the sharp plane |

use super::{Blur, Camera, View};
use crate::color::grey;
use crate::math::jitter::jitter;
use crate::math::noise::hash1;
use crate::math::{Ray, Vec3, chi_square};
use crate::pattern::Context;
use std::f64::consts::{PI, TAU};

/// A camera's lens, prepared.
#[derive(Clone, Debug)]
pub struct Lens {
    points: Vec<(f64, f64)>,
    /// Numbers of rays after which the variance is looked at.
    batches: Vec<usize>,
    /// The variance that is small enough, by number of rays less 1.
    thresholds: Vec<f32>,
    min_samples: usize,
    /// How far places on the lens are shaken.
    shake: f64,
    /// Half the aperture along both axes of the lens.
    across: Vec3,
    upward: Vec3,
    /// Lengthens directions to the sharp plane.
    focus: f64,
}

impl Lens {
    /// `None` if everything is sharp.
    pub fn new(camera: &Camera, context: &Context) -> Option<Lens> {
        let blur = &camera.blur;
        if !blur.is_on() {
            return None;
        }
        let n = blur.max_samples as usize;
        let across = camera.up.cross(camera.direction).normalize_or(Vec3::X);
        let upward = camera.direction.cross(across).normalize_or(Vec3::Y);
        let (points, first): (_, &[usize]) = match &blur.bokeh {
            Some(_) => (bokeh_points(blur, n, context), &[]),
            None => disc_points(n),
        };
        Some(Lens {
            points,
            batches: batches(n, first),
            thresholds: thresholds(blur, n),
            min_samples: blur.min_samples as usize,
            shake: shake(n, blur.bokeh.is_some()),
            across: 0.5 * blur.aperture * across,
            upward: 0.5 * blur.aperture * upward,
            focus: blur.focal_distance / camera.direction.length(),
        })
    }

    /// Numbers of rays after which to ask whether they are enough; the last is the end.
    pub fn batches(&self) -> &[usize] {
        &self.batches
    }

    /// Whether `n` rays are enough, with the sums of each channel and of its squares.
    pub fn is_enough(&self, n: usize, sums: &[f32; 4], squares: &[f32; 4]) -> bool {
        let count = n as f32;
        n >= self.min_samples
            && (0..4).all(|i| {
                let mean = sums[i] / count;
                (squares[i] / count - mean * mean) / count < self.thresholds[n - 1]
            })
    }

    /// Ray number `k` through (x, y) of a picture of `size` pixels; y runs down.
    pub fn ray(
        &self,
        camera: &Camera,
        k: usize,
        (x, y): (f64, f64),
        size: (f64, f64),
        context: &Context,
    ) -> Option<Ray> {
        // Positions whose pixels have their centres at whole numbers.
        let (px, py) = (x - 0.5, y - 0.5);
        let (dx, dy) = shift_in_pixel(k, px, py);
        let view = camera.view((x + dx) / size.0 - 0.5, 0.5 - (y + dy) / size.1)?;
        let (jx, jy) = jitter(px + dx + 0.5, py + dy - 0.5);
        let place = self.points[k];
        let q =
            (place.0 + 2.0 * self.shake * jx) * self.across - (place.1 + 2.0 * self.shake * jy) * self.upward;
        let direction = self.focus * self.towards(camera, &view, context) - q;
        let direction = direction.normalize();
        direction.is_finite().then(|| Ray::new(camera.location + q, direction))
    }

    /// The view's direction, perturbed by the camera's normal.
    fn towards(&self, camera: &Camera, view: &View, context: &Context) -> Vec3 {
        let Some(normal) = &camera.normal else { return view.direction };
        let at = Vec3::new(view.at.0, view.at.1, 0.0);
        normal.perturb(view.direction.normalize(), at, context) * view.direction.length()
    }
}

/// Where inside its pixel ray `k` goes through the picture: one of 16 x 16 cells, shaken.
fn shift_in_pixel(k: usize, px: f64, py: f64) -> (f64, f64) {
    let seed = (313.0 * px + 11.0) as i64 + (311.0 * py + 17.0) as i64 + k as i64;
    let cell = |i: i64| f64::from(2 * (hash1(i) as u32 % 16) + 1) / 32.0 - 0.5;
    let (dx, dy) = (cell(seed), cell(seed + 1));
    let (jx, jy) = jitter(dx, dy);
    (dx + (jx - 0.5) / 16.0, dy + (jy - 0.5) / 16.0)
}

fn shake(n: usize, bokeh: bool) -> f64 {
    match n {
        7 if !bokeh => 0.144338,
        19 if !bokeh => 0.096225,
        37 if !bokeh => 0.0721688,
        _ => 0.5 / (n as f64).sqrt(),
    }
}

/// Ends of batches: `first` sizes, then fours.
fn batches(n: usize, first: &[usize]) -> Vec<usize> {
    let mut ends = Vec::new();
    let mut sizes = first.iter().copied().chain(std::iter::repeat(4));
    let mut end = 0;
    while end < n {
        end = (end + sizes.next().unwrap_or(4)).min(n);
        ends.push(end);
    }
    ends
}

fn thresholds(blur: &Blur, n: usize) -> Vec<f32> {
    if n == 1 {
        return vec![0.0];
    }
    let last = chi_square::quantile(n as u32 - 1, blur.confidence);
    let quantile = |k: u32| chi_square::quantile(k, blur.confidence) / last;
    (1..=n as u32).map(|k| (blur.variance * quantile(k)) as f32).collect()
}

/// `n` places on a disc of diameter 1, and the sizes of the first batches.
fn disc_points(n: usize) -> (Vec<(f64, f64)>, &'static [usize]) {
    let (grid, first): (&[(f64, f64)], &'static [usize]) = match n {
        0..7 => (&GRID_4, &[]),
        7..19 => (&GRID_7, &[7]),
        19..37 => (&GRID_19, &[7, 6, 6]),
        _ => (&GRID_37, &[7, 6, 6, 4, 4, 4, 4, 2]),
    };
    let mut points = grid[..grid.len().min(n)].to_vec();
    fill(&mut points, n);
    (points, first)
}

/// Adds places up to `n`, at most one in each cell of a square grid while candidates last.
fn fill(points: &mut Vec<(f64, f64)>, n: usize) {
    let side = 2 * (n as f64 / PI).sqrt().ceil() as usize + 1;
    let cell = |(x, y): (f64, f64)| {
        let index = |v: f64| (((v + 0.5) * side as f64) as usize).min(side - 1);
        index(y) * side + index(x)
    };
    let mut taken = vec![false; side * side];
    points.iter().for_each(|&p| taken[cell(p)] = true);
    let mut left = 10 * n;
    let mut candidates = (1u32..).map(|i| {
        let (radius, angle) = (0.5 * halton(i, 2).sqrt(), TAU * halton(i, 3));
        (radius * angle.cos(), radius * angle.sin())
    });
    while points.len() < n {
        let Some(p) = candidates.next() else { return };
        left = left.saturating_sub(1);
        if taken[cell(p)] && left > n - points.len() {
            continue;
        }
        taken[cell(p)] = true;
        points.push(p);
    }
}

/// Places in the unit square, as dense as the pigment is bright.
fn bokeh_points(blur: &Blur, n: usize, context: &Context) -> Vec<(f64, f64)> {
    let brightness = |x: f64, y: f64| {
        let color = blur.bokeh.as_ref().and_then(|p| p.color(Vec3::new(x, y, 0.0), context));
        color.map_or(0.0, |c| f64::from(grey(c.rgb)))
    };
    let mut points = Vec::with_capacity(n);
    for i in 1..=MOST_CANDIDATES.max(n as u32) {
        let (x, y) = (halton(i, 2), halton(i, 3));
        let needed = MOST_CANDIDATES.saturating_sub(i) < (n - points.len()) as u32;
        if needed || brightness(x, y) > halton(i, 5) {
            points.push((x - 0.5, y - 0.5));
            if points.len() == n {
                break;
            }
        }
    }
    points.resize(n, (0.0, 0.0));
    points
}

/// After so many candidates a dark opening takes what comes.
const MOST_CANDIDATES: u32 = 1_000_000;

/// The radical inverse of `i`: its digits in base `b` mirrored at the point.
fn halton(mut i: u32, b: u32) -> f64 {
    let (mut value, mut digit) = (0.0, 1.0);
    while i > 0 {
        digit /= f64::from(b);
        value += f64::from(i % b) * digit;
        i /= b;
    }
    value
}

#[rustfmt::skip]
const GRID_4: [(f64, f64); 4] = [
    (-0.25, 0.25), (0.25, 0.25), (-0.25, -0.25), (0.25, -0.25),
];

#[rustfmt::skip]
const GRID_7: [(f64, f64); 7] = [
    (-0.288675, 0.000000), (0.000000, 0.000000), (0.288675, 0.000000), (-0.144338, 0.250000),
    (-0.144338, -0.250000), (0.144338, 0.250000), (0.144338, -0.250000),
];

#[rustfmt::skip]
const GRID_19: [(f64, f64); 19] = [
    (-0.192450, 0.333333), (-0.192450, -0.333333), (0.192450, 0.333333), (0.192450, -0.333333),
    (0.384900, 0.000000), (-0.384900, 0.000000), (0.000000, 0.000000), (0.000000, 0.333333),
    (0.000000, -0.333333), (-0.288675, 0.166667), (-0.288675, -0.166667), (0.288675, 0.166667),
    (0.288675, -0.166667), (-0.096225, 0.166667), (-0.096225, -0.166667), (0.096225, 0.166667),
    (0.096225, -0.166667), (-0.192450, 0.000000), (0.192450, 0.000000),
];

#[rustfmt::skip]
const GRID_37: [(f64, f64); 37] = [
    (0.000000, 0.000000), (-0.216506, 0.375000), (0.216506, -0.375000), (-0.216506, -0.375000),
    (0.216506, 0.375000), (-0.433013, 0.000000), (0.433013, 0.000000), (-0.144338, 0.250000),
    (0.144338, -0.250000), (-0.144338, -0.250000), (0.144338, 0.250000), (-0.288675, 0.000000),
    (0.288675, 0.000000), (-0.072169, 0.125000), (0.072169, -0.125000), (-0.072169, -0.125000),
    (0.072169, 0.125000), (-0.144338, 0.000000), (0.144338, 0.000000), (-0.360844, 0.125000),
    (-0.360844, -0.125000), (0.360844, 0.125000), (0.360844, -0.125000), (-0.288675, 0.250000),
    (-0.288675, -0.250000), (0.288675, 0.250000), (0.288675, -0.250000), (-0.072169, 0.375000),
    (-0.072169, -0.375000), (0.072169, 0.375000), (0.072169, -0.375000), (-0.216506, 0.125000),
    (-0.216506, -0.125000), (0.216506, 0.125000), (0.216506, -0.125000), (0.000000, 0.250000),
    (0.000000, -0.250000),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn batches_end_with_the_last_ray() {
        assert_eq!(batches(10, &[7]), [7, 10]);
        assert_eq!(batches(6, &[]), [4, 6]);
        assert_eq!(batches(20, &[7, 6, 6]), [7, 13, 19, 20]);
    }

    #[test]
    fn places_lie_on_the_lens() {
        for n in [1, 4, 6, 7, 18, 19, 36, 37, 100, 400] {
            let (points, _) = disc_points(n);
            assert_eq!(points.len(), n);
            assert!(points.iter().all(|p| p.0.hypot(p.1) <= 0.5 + 1e-9), "{n}");
        }
    }

    #[test]
    fn the_sharp_plane_stays_sharp() {
        let mut camera =
            Camera { direction: 2.0 * Vec3::Z, location: Vec3::new(1.0, 2.0, 3.0), ..Camera::default() };
        camera.blur = Blur { aperture: 0.8, max_samples: 19, focal_distance: 7.0, ..Blur::default() };
        let context = Context { noise: Default::default(), waves: 10, hit: None };
        let lens = Lens::new(&camera, &context).unwrap();
        for k in 0..19 {
            let (dx, dy) = shift_in_pixel(k, 30.0, 20.0);
            let sharp = camera.ray(30.5 + dx, 20.5 + dy, (80.0, 60.0), &context).unwrap();
            let ray = lens.ray(&camera, k, (30.5, 20.5), (80.0, 60.0), &context).unwrap();
            let plane = |r: Ray| r.at((10.0 - r.origin.z) / r.dir.z);
            assert!((plane(ray) - plane(sharp)).length() < 1e-9);
        }
    }

    #[test]
    fn radical_inverses() {
        assert_eq!(halton(6, 2), 0.375);
        assert!((halton(5, 3) - (2.0 / 3.0 + 1.0 / 9.0)).abs() < 1e-15);
    }
}
