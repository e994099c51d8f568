//! Bounds of scalar noise and of its derivatives inside a box.
//!
//! In a unit cell the noise is an average of linear forms at its corners, with weights that depend on the
//! place. An average whose weights are known to lie between bounds is largest when all weight that is free
//! goes to the largest form.

use super::{NoiseGenerator, fade, gradient, lattice};
use crate::math::{Aabb, Vec3};

/// Two numbers with everything between them.
type Range = (f64, f64);

/// Most cells that are looked at one by one.
const MOST_CELLS: f64 = 8.0;

/// Room for rounding. Gradient noise rounds coordinates to about 2e-9.
const ROUNDING: f64 = 1e-8;

/// What scalar noise is made of.
struct Kind {
    forms: fn(Vec3) -> [[f64; 4]; 8],
    /// Where the lattice is moved.
    shift: f64,
    /// The noise is `scale * sum + offset`, kept within 0 .. 1.
    scale: f64,
    offset: f64,
    /// Bound on every derivative of the sum anywhere.
    steepest: f64,
}

impl Kind {
    fn of(generator: NoiseGenerator) -> Self {
        // The largest derivatives of sums of the worst corners that the tables have.
        let lattice = Kind { forms: lattice::forms, shift: 0.0, scale: 1.0, offset: 0.5, steepest: 4.0 };
        match generator {
            NoiseGenerator::Original => lattice,
            NoiseGenerator::RangeCorrected => {
                Kind { scale: 0.48985582, offset: 1.05242 * 0.48985582, ..lattice }
            }
            NoiseGenerator::Perlin => Kind {
                forms: gradient::forms,
                shift: gradient::SHIFT,
                scale: 0.795,
                offset: 0.4925,
                steepest: 2.25,
            },
        }
    }
}

/// The range of the noise inside a box, and the ranges of its derivatives by x, y and z.
pub fn enclose(b: &Aabb, generator: NoiseGenerator) -> (Range, [Range; 3]) {
    let kind = Kind::of(generator);
    let shift = Vec3::splat(kind.shift);
    let (low, high) = ((b.min + shift).floor(), (b.max + shift).floor());
    let counts = high - low + Vec3::ONE;
    let count = counts.x * counts.y * counts.z;
    let (value, slopes) = if count <= MOST_CELLS {
        in_cells(b, &kind, [low, high])
    } else {
        ((f64::NEG_INFINITY, f64::INFINITY), [(-kind.steepest, kind.steepest); 3])
    };
    let raw = (value.0 * kind.scale + kind.offset, value.1 * kind.scale + kind.offset);
    let cut = !(raw.0 > 0.0 && raw.1 < 1.0);
    let slopes = slopes.map(|(lo, hi)| {
        let (lo, hi) = (lo * kind.scale, hi * kind.scale);
        // Where the noise is cut off it is flat.
        if cut { (lo.min(0.0), hi.max(0.0)) } else { (lo, hi) }
    });
    ((raw.0.clamp(0.0, 1.0), raw.1.clamp(0.0, 1.0)), slopes)
}

fn in_cells(b: &Aabb, kind: &Kind, [low, high]: [Vec3; 2]) -> (Range, [Range; 3]) {
    let nothing = (f64::INFINITY, f64::NEG_INFINITY);
    let mut all = (nothing, [nothing; 3]);
    let mut cell = low;
    loop {
        let corner = cell - Vec3::splat(kind.shift);
        let part = Aabb { min: b.min.max(corner), max: b.max.min(corner + Vec3::ONE) };
        let (value, slopes) = in_cell(kind, &part, corner);
        all.0 = hull(all.0, value);
        all.1 = std::array::from_fn(|i| hull(all.1[i], slopes[i]));
        let Some(axis) = (0..3).find(|&i| cell[i] < high[i]) else { return all };
        cell[axis] += 1.0;
        for i in 0..axis {
            cell[i] = low[i];
        }
    }
}

/// Bounds inside one cell.
fn in_cell(kind: &Kind, part: &Aabb, corner: Vec3) -> (Range, [Range; 3]) {
    let forms = (kind.forms)(corner + 0.5);
    let places: [Range; 3] = std::array::from_fn(|i| {
        let range = [part.min[i] - corner[i], part.max[i] - corner[i]].map(|f| f.clamp(0.0, 1.0));
        (range[0], range[1])
    });
    // The least weights of the lower and the upper end of each axis.
    let weights = places.map(|(lo, hi)| [1.0 - fade(hi), fade(lo)]);
    let values: [Range; 8] = std::array::from_fn(|c| form_range(&forms[c], c, &places));
    let mut averages = Averages::NONE;
    for (c, &[_, x, y, z]) in forms.iter().enumerate() {
        let weight = weights[0][digit(c, 0)] * weights[1][digit(c, 1)] * weights[2][digit(c, 2)];
        averages.add([weight; 4], [values[c].0, x, y, z], [values[c].1, x, y, z]);
    }
    let [value, gradients @ ..] = averages.ranges();
    let steps = steps(&weights, &values);
    let slopes: [Range; 3] = std::array::from_fn(|axis| {
        let (steps, rise) = (steps[axis], fade_slope(places[axis]));
        let products = [rise.0 * steps.0, rise.1 * steps.0, rise.0 * steps.1, rise.1 * steps.1];
        let low = products.into_iter().fold(f64::INFINITY, lower);
        let high = products.into_iter().fold(f64::NEG_INFINITY, upper);
        (gradients[axis].0 + low - ROUNDING, gradients[axis].1 + high + ROUNDING)
    });
    let near = around_center(&forms, &places, &slopes);
    ((value.0.max(near.0) - ROUNDING, value.1.min(near.1) + ROUNDING), slopes)
}

/// The ranges of the differences between the two ends of each axis.
fn steps(weights: &[[f64; 2]; 3], values: &[Range; 8]) -> [Range; 4] {
    /// Corners at the lower end of each axis.
    const LOWER: [[usize; 3]; 4] = [[0, 0, 0], [1, 1, 2], [2, 4, 4], [3, 5, 6]];
    let mut averages = Averages::NONE;
    for lower in LOWER {
        let (mut weight, mut low, mut high) = ([0.0; 4], [0.0; 4], [0.0; 4]);
        for axis in 0..3 {
            let c = lower[axis];
            let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
            let opposite = values[c | 4 >> axis];
            weight[axis] = weights[a][digit(c, a)] * weights[b][digit(c, b)];
            (low[axis], high[axis]) = (opposite.0 - values[c].1, opposite.1 - values[c].0);
        }
        averages.add(weight, low, high);
    }
    averages.ranges()
}

/// The range that follows from the value at the center and the slopes.
fn around_center(forms: &[[f64; 4]; 8], places: &[Range; 3], slopes: &[Range; 3]) -> Range {
    let center = places.map(|(lo, hi)| 0.5 * (lo + hi));
    let weights = center.map(|f| [1.0 - fade(f), fade(f)]);
    let mut value = 0.0;
    for (c, form) in forms.iter().enumerate() {
        let weight = weights[0][digit(c, 0)] * weights[1][digit(c, 1)] * weights[2][digit(c, 2)];
        let terms: [f64; 3] = std::array::from_fn(|i| (center[i] - digit(c, i) as f64) * form[1 + i]);
        value += weight * (form[0] + terms[0] + terms[1] + terms[2]);
    }
    let reach: f64 =
        (0..3).map(|i| slopes[i].0.abs().max(slopes[i].1.abs()) * (places[i].1 - center[i])).sum();
    (value - reach, value + reach)
}

/// Whether a corner lies at the upper end of an axis: 1 or 0.
fn digit(corner: usize, axis: usize) -> usize {
    corner >> (2 - axis) & 1
}

/// A corner's form over a box of the cell.
fn form_range(form: &[f64; 4], corner: usize, places: &[Range; 3]) -> Range {
    let mut range = (form[0], form[0]);
    for axis in 0..3 {
        let at = digit(corner, axis) as f64;
        let (a, b) = ((places[axis].0 - at) * form[1 + axis], (places[axis].1 - at) * form[1 + axis]);
        range = (range.0 + lower(a, b), range.1 + upper(a, b));
    }
    range
}

/// The ranges of four averages, side by side, of values with weights of sum 1, both known to lie in ranges.
struct Averages {
    low: [f64; 4],
    high: [f64; 4],
    /// What the weights' lower ends leave.
    free: [f64; 4],
    /// The ends of all values.
    least: [f64; 4],
    most: [f64; 4],
}

impl Averages {
    const NONE: Self = Self {
        low: [0.0; 4],
        high: [0.0; 4],
        free: [1.0; 4],
        least: [f64::INFINITY; 4],
        most: [f64::NEG_INFINITY; 4],
    };

    /// Adds a value between `low` and `high` with at least this weight.
    #[inline(always)]
    fn add(&mut self, weight: [f64; 4], low: [f64; 4], high: [f64; 4]) {
        for i in 0..4 {
            self.low[i] += weight[i] * low[i];
            self.high[i] += weight[i] * high[i];
            self.free[i] -= weight[i];
            self.least[i] = lower(self.least[i], low[i]);
            self.most[i] = upper(self.most[i], high[i]);
        }
    }

    #[inline(always)]
    fn ranges(&self) -> [Range; 4] {
        std::array::from_fn(|i| {
            let free = f64::max(self.free[i], 0.0);
            (self.low[i] + free * self.least[i], self.high[i] + free * self.most[i])
        })
    }
}

/// One instruction, as nothing here is NaN.
#[inline(always)]
fn lower(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

#[inline(always)]
fn upper(a: f64, b: f64) -> f64 {
    if a < b { b } else { a }
}

/// The range of the fade's derivative `6 f (1 - f)`.
fn fade_slope((lo, hi): Range) -> Range {
    let (a, b) = (6.0 * lo * (1.0 - lo), 6.0 * hi * (1.0 - hi));
    (a.min(b), if lo <= 0.5 && hi >= 0.5 { 1.5 } else { a.max(b) })
}

fn hull(a: Range, b: Range) -> Range {
    (a.0.min(b.0), a.1.max(b.1))
}

#[cfg(test)]
mod tests {
    use super::super::noise;
    use super::*;
    use crate::math::random::Lcg;

    const ALL: [NoiseGenerator; 3] =
        [NoiseGenerator::Original, NoiseGenerator::RangeCorrected, NoiseGenerator::Perlin];

    fn part(random: &mut Lcg) -> f64 {
        f64::from(random.draw()) / 32767.0
    }

    #[test]
    fn noise_and_its_differences_stay_inside() {
        let mut random = Lcg::new(3);
        for round in 0..3000 {
            let generator = ALL[round % 3];
            let center = Vec3::from_array(std::array::from_fn(|_| 40.0 * part(&mut random) - 20.0));
            let size = [0.01, 0.1, 0.4, 1.5][round / 3 % 4];
            let b = Aabb { min: center - size, max: center + size };
            let (range, slopes) = enclose(&b, generator);
            for _ in 0..30 {
                let at = |random: &mut Lcg| b.min + b.size() * Vec3::from_array([0; 3].map(|_| part(random)));
                let p = at(&mut random);
                let value = noise(p, generator);
                assert!(range.0 <= value && value <= range.1, "{generator:?} {value} {range:?}");
                let mut q = p;
                let axis = random.draw() as usize % 3;
                q[axis] = at(&mut random)[axis];
                let length = q[axis] - p[axis];
                if length.abs() > 1e-3 {
                    let slope = (noise(q, generator) - value) / length;
                    let (lo, hi) = slopes[axis];
                    assert!(lo - 1e-5 <= slope && slope <= hi + 1e-5, "{generator:?} {slope} {lo} {hi}");
                }
            }
        }
    }

    #[test]
    fn small_boxes_have_narrow_ranges() {
        for generator in ALL {
            let b = Aabb { min: Vec3::new(0.3, 0.4, 0.2), max: Vec3::new(0.31, 0.41, 0.21) };
            let (range, slopes) = enclose(&b, generator);
            assert!(range.1 - range.0 < 0.05, "{range:?}");
            assert!(slopes.iter().all(|s| s.1 - s.0 < 0.3), "{slopes:?}");
        }
    }

    #[test]
    fn forms_make_up_the_noise() {
        for p in [Vec3::new(0.3, 0.7, 0.2), Vec3::new(-3.2, 17.9, 5.4)] {
            for (generator, shift) in
                [(NoiseGenerator::Original, 0.0), (NoiseGenerator::Perlin, gradient::SHIFT)]
            {
                let b = Aabb { min: p, max: p };
                let (range, _) = enclose(&b, generator);
                assert!((range.0 - noise(p, generator)).abs() < 1e-7, "{shift}: {range:?}");
            }
        }
    }
}
