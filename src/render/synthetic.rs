//! Pictures known at every place, for tests: what a sampler sees without a scene.

use super::Sampler;
use super::adaptive::mix;
use crate::color::Rgb;
use crate::picture::{Picture, Pixel};

/// A grey picture by formula; `z` is a number in 0..1 that is drawn anew for every sample.
pub type Formula = fn(x: f64, y: f64, z: f64) -> f64;

/// Samples a formula.
pub struct Painted {
    formula: Formula,
    rays: u64,
    draw: u32,
}

impl Painted {
    pub fn new(formula: Formula) -> Self {
        Self { formula, rays: 0, draw: 0 }
    }
}

impl Sampler for Painted {
    fn seed(&mut self, x: u32, y: u32, sample: u32) {
        self.draw = mix(mix(mix(x ^ 0xA511_E9B3) ^ y) ^ sample);
    }

    fn sample(&mut self, x: f64, y: f64) -> Pixel {
        self.rays += 1;
        let z = f64::from(self.draw) / 4_294_967_296.0;
        Pixel::new(Rgb::splat((self.formula)(x, y, z) as f32), 0.0)
    }

    fn rays(&self) -> u64 {
        self.rays
    }
}

/// The mean of a formula over x0..x1 and over all draws, at one y.
pub type RowMean = fn(x0: f64, x1: f64, y: f64) -> f64;

/// A picture with its truth.
#[derive(Clone, Copy)]
pub struct Painting {
    pub name: &'static str,
    pub formula: Formula,
    /// Exact means, for pictures on which evenly spaced places would not do.
    row_mean: Option<RowMean>,
}

impl Painting {
    /// Every pixel's integral: `side` rows in each with as many places, or four times as many with exact
    /// means.
    pub fn truth(&self, width: u32, height: u32, side: u32) -> Picture {
        let mut picture = Picture::new(width, height);
        let rows = if self.row_mean.is_some() { 4 * side } else { side };
        for y in 0..height {
            for x in 0..width {
                let left = f64::from(x) - 0.5;
                let row = |y: f64| match self.row_mean {
                    Some(mean) => mean(left, left + 1.0, y),
                    None => midpoints(left, side, |x| (self.formula)(x, y, 0.5)),
                };
                let mean = midpoints(f64::from(y) - 0.5, rows, row);
                picture.set(x, y, Pixel::new(Rgb::splat(mean as f32), 0.0));
            }
        }
        picture
    }
}

/// The mean of `f` over `from` to `from + 1`, by the midpoint rule.
fn midpoints(from: f64, count: u32, f: impl Fn(f64) -> f64) -> f64 {
    let n = f64::from(count);
    (0..count).map(|i| f(from + (f64::from(i) + 0.5) / n)).sum::<f64>() / n
}

/// A checkered plane that runs to the horizon at y = 20.3, seen from above; a sky that brightens upwards.
pub fn horizon(x: f64, y: f64, _: f64) -> f64 {
    let below = y - 20.3;
    if below <= 0.0 {
        return 0.5 + below / 100.0;
    }
    let depth = 60.0 / below;
    let across = (x - 47.2) * depth / 60.0;
    let odd = ((depth * 1.3 + 0.7).floor() + (across * 1.3 + 0.2).floor()).rem_euclid(2.0);
    if odd == 1.0 { 0.9 } else { 0.1 }
}

fn horizon_row(x0: f64, x1: f64, y: f64) -> f64 {
    let below = y - 20.3;
    if below <= 0.0 {
        return 0.5 + below / 100.0;
    }
    let depth = 60.0 / below;
    let place = |x: f64| (x - 47.2) * depth / 60.0 * 1.3 + 0.2;
    // The length of odd cells in 0..u.
    let odd = |u: f64| (u / 2.0).floor() + (u.rem_euclid(2.0) - 1.0).max(0.0);
    let share = (odd(place(x1)) - odd(place(x0))) / (place(x1) - place(x0));
    let share = if (depth * 1.3 + 0.7).floor().rem_euclid(2.0) == 1.0 { 1.0 - share } else { share };
    0.1 + 0.8 * share
}

/// Balls on balls, each lit from the upper left with a small bright spot, one size smaller at every level.
pub fn balls(x: f64, y: f64, _: f64) -> f64 {
    let mut color = 0.2 + 0.002 * y;
    let mut radius = 24.0;
    for level in 0..5 {
        let cell = radius * 2.3;
        let shift = f64::from(level) * 7.3;
        let center = |v: f64| ((v + shift) / cell).floor() * cell + cell / 2.0 - shift;
        let (dx, dy) = ((x - center(x)) / radius, (y - center(y)) / radius);
        let rr = dx * dx + dy * dy;
        if rr < 1.0 {
            let nz = (1.0 - rr).sqrt();
            let light = (0.6 * nz - 0.5 * dx - 0.6 * dy).max(0.0);
            color = 0.05 + 0.15 * f64::from(level) + 0.5 * light + 3.0 * light.powi(40);
            if level < 4 && rr < 0.3 {
                radius *= 0.45;
                continue;
            }
            break;
        }
        radius *= 0.45;
    }
    color
}

/// Dark wires from 0.05 to 0.5 pixels wide on a light ground.
pub fn wires(x: f64, y: f64, _: f64) -> f64 {
    let wire = (0..14).any(|i| {
        let i = f64::from(i);
        let (dir, width) = (0.2 + i * 0.37, 0.05 + 0.035 * i);
        let (sin, cos) = f64::sin_cos(dir);
        ((x - 48.0 - 3.0 * i) * sin + (y - 36.0 + 2.0 * i) * cos).abs() < width / 2.0
    });
    if wire { 0.05 } else { 0.7 }
}

/// A shadow with a wide soft border whose every sample is lit or not, by draw.
pub fn penumbra(x: f64, y: f64, z: f64) -> f64 {
    let lit = ((x - 30.0 + 0.3 * y) / 35.0).clamp(0.0, 1.0);
    if z < lit { 0.8 } else { 0.15 }
}

fn penumbra_row(x0: f64, x1: f64, y: f64) -> f64 {
    let place = |x: f64| (x - 30.0 + 0.3 * y) / 35.0;
    // The integral of the lit share from 0.
    let lit = |u: f64| if u < 1.0 { 0.5 * u.max(0.0).powi(2) } else { u - 0.5 };
    0.15 + 0.65 * (lit(place(x1)) - lit(place(x0))) / (place(x1) - place(x0))
}

/// Smooth waves; nothing is thinner than four pixels.
pub fn waves(x: f64, y: f64, _: f64) -> f64 {
    0.5 + 0.2 * (x * 0.7 + 0.3 * y).sin() + 0.2 * (y * 0.9 - 0.2 * x + 1.0).sin()
}

/// Flat shapes with straight borders and sharp corners.
pub fn shapes(x: f64, y: f64, _: f64) -> f64 {
    let mut color = 0.9;
    for i in 0..9 {
        let i = f64::from(i);
        let (cx, cy) = (10.0 + (i * 37.7) % 80.0, 8.0 + (i * 23.1) % 56.0);
        let (sin, cos) = f64::sin_cos(i * 1.3 + 0.4);
        let (u, v) = ((x - cx) * cos + (y - cy) * sin, (y - cy) * cos - (x - cx) * sin);
        if u.abs() < 9.0 && v.abs() < 2.0 + i {
            color = 0.08 * i + 0.05;
        }
    }
    color
}

/// Bright specks of 0.06 square pixels, one in about 30 pixels.
pub fn specks(x: f64, y: f64, _: f64) -> f64 {
    let (cx, cy) = ((x / 5.37).floor(), (y / 5.61).floor());
    let h = mix((cx as i64 as u32) ^ mix(cy as i64 as u32));
    let at = |bits: u32, size: f64| (f64::from(bits & 0xFFFF) / 65536.0 * 0.9 + 0.05) * size;
    let (px, py) = (cx * 5.37 + at(h, 5.37), cy * 5.61 + at(h >> 16, 5.61));
    if (x - px).abs() < 0.125 && (y - py).abs() < 0.12 { 1.0 } else { 0.2 }
}

/// A light thing of 40 times white on a dark ground.
pub fn glare(x: f64, y: f64, _: f64) -> f64 {
    let d = ((x - 40.3).powi(2) + (y - 30.1).powi(2)).sqrt();
    if d < 9.7 { 40.0 } else { 0.02 + 2.0 / (1.0 + (d - 9.7).powi(2)) }
}

/// Several of these side by side, meeting at borders of pixels.
pub fn medley(x: f64, y: f64, z: f64) -> f64 {
    match (x < 31.5, x < 63.5, y < 35.5) {
        (true, _, true) => shapes(x, y, z),
        (_, true, true) => horizon(x, y + 10.0, z),
        (_, _, true) => wires(x, y, z),
        (true, _, _) => penumbra(x, y, z),
        (_, true, _) => waves(x, y, z),
        (_, _, _) => balls(x, y, z),
    }
}

fn medley_row(x0: f64, x1: f64, y: f64) -> f64 {
    match (x1 < 31.6, x1 < 63.6, y < 35.5) {
        (false, true, true) => horizon_row(x0, x1, y + 10.0),
        (true, _, false) => penumbra_row(x0, x1, y),
        _ => {
            (0..48).map(|i| medley(x0 + (f64::from(i) + 0.5) / 48.0 * (x1 - x0), y, 0.5)).sum::<f64>() / 48.0
        }
    }
}

const fn painting(name: &'static str, formula: Formula, row_mean: Option<RowMean>) -> Painting {
    Painting { name, formula, row_mean }
}

pub const HORIZON: Painting = painting("horizon", horizon, Some(horizon_row));
pub const BALLS: Painting = painting("balls", balls, None);
pub const WIRES: Painting = painting("wires", wires, None);
pub const PENUMBRA: Painting = painting("penumbra", penumbra, Some(penumbra_row));
pub const WAVES: Painting = painting("waves", waves, None);
pub const SHAPES: Painting = painting("shapes", shapes, None);
pub const SPECKS: Painting = painting("specks", specks, None);
pub const GLARE: Painting = painting("glare", glare, None);
pub const MEDLEY: Painting = painting("medley", medley, Some(medley_row));

/// Every picture of this page.
pub const ALL: &[Painting] = &[HORIZON, BALLS, WIRES, PENUMBRA, WAVES, SHAPES, SPECKS, GLARE, MEDLEY];
