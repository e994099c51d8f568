//! Crackle: distances to the nearest of the random points that fill space, one in each unit cell.
//!
//! With `d1 <= d2 <= d3` the distances to the three nearest points, the value is `form . (d1, d2, d3)`, clamped
//! to 0..=1. Distances are `(Σ|δ|^metric + offset^metric) ^ (1/metric)`.
//!
//! | parameter | default | meaning |
//! |---|---|---|
//! | form | <-1, 1, 0> | weights of the three distances |
//! | metric | 2 | exponent; 1 gives octahedra, 2 spheres |
//! | offset | 0 | distance in a fourth dimension |
//! | solid | off | the value is the noise at the nearest point |
//!
//! The inner 27 cells are looked at first, the nine of each outer side only if they come nearer than the
//! third nearest point so far; four distances at a time for the metrics 1/2, 1, 3/2, ... 4.
//!
//! Reference: S. Worley, "A Cellular Texture Basis Function", SIGGRAPH 1996.

use super::lattice_points::{GROUPS, Neighbourhood};
use super::{EDGE, Modifier, Pattern, Setting};
use crate::math::Vec3;
use crate::math::noise::noise;
use std::sync::Arc;

#[derive(Clone, Copy, Debug)]
pub struct Crackle {
    pub form: Vec3,
    pub metric: f64,
    pub offset: f64,
    pub solid: bool,
}

impl Default for Crackle {
    fn default() -> Self {
        Self { form: Vec3::new(-1.0, 1.0, 0.0), metric: 2.0, offset: 0.0, solid: false }
    }
}

impl Crackle {
    fn power(&self, d: f64) -> f64 {
        if self.metric == 2.0 {
            d * d
        } else if self.metric == 1.0 {
            d.abs()
        } else {
            d.abs().powf(self.metric)
        }
    }

    fn root(&self, s: f64) -> f64 {
        match 2.0 * self.metric {
            4.0 => s.sqrt(),
            2.0 => s,
            1.0 => s * s,
            6.0 => s.cbrt(),
            8.0 => s.sqrt().sqrt(),
            _ => s.powf(1.0 / self.metric),
        }
    }

    /// The three smallest power sums of distances.
    fn least(&self, p: Vec3) -> [f64; 3] {
        let halves = 2.0 * self.metric;
        #[cfg(target_arch = "x86_64")]
        if halves == 4.0 && std::arch::is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has just been seen to have what `least_wide` is compiled for.
            #[allow(unsafe_code)]
            return Neighbourhood::around(cell(p), |cells| unsafe { least_wide(cells, p) });
        }
        Neighbourhood::around(cell(p), |cells| match halves {
            4.0 => least(cells, p, |d| d * d),
            2.0 => least(cells, p, f64::abs),
            1.0 => least(cells, p, |d| d.abs().sqrt()),
            3.0 => least(cells, p, |d| d.abs() * d.abs().sqrt()),
            5.0 => least(cells, p, |d| d * d * d.abs().sqrt()),
            6.0 => least(cells, p, |d| d * d * d.abs()),
            7.0 => least(cells, p, |d| d * d * d.abs() * d.abs().sqrt()),
            8.0 => least(cells, p, |d| (d * d) * (d * d)),
            _ => self.least_of_any(cells, p),
        })
    }

    /// The same for any metric, one cell after the other.
    fn least_of_any(&self, cells: &mut Neighbourhood, p: Vec3) -> [f64; 3] {
        let gaps = self.gaps(p - cell(p));
        let mut s = [f64::INFINITY; 3];
        for group in 0..GROUPS {
            if group > 0 && self.metric > 0.0 && self.power(cells.gap(group, p)) >= s[2] {
                continue;
            }
            let places = cells.group(group);
            for (offset, point) in cells.points(places) {
                let [gx, gy, gz] = offset.map(|o| (o + 2) as usize);
                if gaps[0][gx] + gaps[1][gy] + gaps[2][gz] < s[2] {
                    let delta = point - p;
                    insert(&mut s, self.power(delta.x) + self.power(delta.y) + self.power(delta.z));
                }
            }
        }
        s
    }

    /// For each axis and each cell offset along it, the least power of the distance to the cell; none where
    /// the metric does not grow with distance.
    fn gaps(&self, f: Vec3) -> [[f64; 5]; 3] {
        f.to_array().map(|f| {
            let gaps = [1.0 + f, f, 0.0, 1.0 - f, 2.0 - f];
            if self.metric > 0.0 { gaps.map(|g| self.power(g.max(0.0))) } else { [f64::NEG_INFINITY; 5] }
        })
    }

    /// The nearest point.
    fn nearest(&self, p: Vec3) -> Vec3 {
        Neighbourhood::around(cell(p), |cells| {
            let (mut least, mut at) = (f64::INFINITY, p);
            for group in 0..GROUPS {
                if group > 0 && self.metric > 0.0 && self.power(cells.gap(group, p)) >= least {
                    continue;
                }
                let places = cells.group(group);
                for (_, point) in cells.points(places) {
                    let delta = point - p;
                    let sum = self.power(delta.x) + self.power(delta.y) + self.power(delta.z);
                    if sum < least {
                        (least, at) = (sum, point);
                    }
                }
            }
            at
        })
    }
}

/// The lowest corner of the cell around a point.
fn cell(p: Vec3) -> Vec3 {
    (p - Vec3::splat(EDGE)).floor()
}

fn lower(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

fn upper(a: f64, b: f64) -> f64 {
    if a < b { b } else { a }
}

/// Puts a number among the three smallest.
#[inline(always)]
fn insert(s: &mut [f64; 3], v: f64) {
    s[2] = lower(s[2], upper(s[1], v));
    s[1] = lower(s[1], upper(s[0], v));
    s[0] = lower(s[0], v);
}

/// The three smallest sums, for a power that grows with distance.
#[inline(always)]
fn least(cells: &mut Neighbourhood, p: Vec3, power: impl Fn(f64) -> f64 + Copy) -> [f64; 3] {
    let places = cells.group(0);
    let mut s = least_in(cells, places, p, power);
    for group in 1..GROUPS {
        if power(cells.gap(group, p)) < s[2] {
            let places = cells.group(group);
            least_in(cells, places, p, power).into_iter().for_each(|v| insert(&mut s, v));
        }
    }
    s
}

/// [`least`] for squares, four at once: the same operations in the same order, so the same bits.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn least_wide(cells: &mut Neighbourhood, p: Vec3) -> [f64; 3] {
    least(cells, p, |d| d * d)
}

/// The three smallest sums in some places: four lists side by side, then one.
#[inline(always)]
fn least_in(
    cells: &Neighbourhood,
    places: std::ops::Range<usize>,
    p: Vec3,
    power: impl Fn(f64) -> f64 + Copy,
) -> [f64; 3] {
    let mut s = [[f64::INFINITY; 4]; 3];
    for [x, y, z] in cells.fours(places) {
        let sums: [f64; 4] =
            std::array::from_fn(|i| power(x[i] - p.x) + power(y[i] - p.y) + power(z[i] - p.z));
        for i in 0..4 {
            s[2][i] = lower(s[2][i], upper(s[1][i], sums[i]));
            s[1][i] = lower(s[1][i], upper(s[0][i], sums[i]));
            s[0][i] = lower(s[0][i], sums[i]);
        }
    }
    let mut all = s.map(|list| list[0]);
    for list in 1..4 {
        s.iter().for_each(|s| insert(&mut all, s[list]));
    }
    all
}

impl Pattern for Crackle {
    fn value(&self, p: Vec3, setting: &Setting) -> f64 {
        if self.solid {
            return noise(self.nearest(p), setting.noise);
        }
        let sums = self.least(p);
        let lift = if self.offset != 0.0 { self.offset.powf(self.metric) } else { 0.0 };
        let mut value = 0.0;
        for (weight, sum) in self.form.to_array().into_iter().zip(sums) {
            if weight != 0.0 {
                value += weight * self.root(sum + lift);
            }
        }
        value.clamp(0.0, 1.0)
    }

    fn modified(&self, modifier: Modifier) -> Option<Arc<dyn Pattern>> {
        let mut changed = *self;
        match modifier {
            Modifier::Form(form) => changed.form = form,
            Modifier::Metric(metric) => changed.metric = metric,
            Modifier::Offset(offset) => changed.offset = offset,
            Modifier::Solid(solid) => changed.solid = solid,
            _ => return None,
        }
        Some(Arc::new(changed))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[cfg(target_arch = "x86_64")]
    fn wide_sums_are_the_plain_ones() {
        if !std::arch::is_x86_feature_detected!("avx2") {
            println!("skipped: no AVX2");
            return;
        }
        for i in 0..300 {
            let t = f64::from(i);
            let p = Vec3::new((t * 0.71).sin() * 40.0, t * 0.13 - 2.0, (t * 0.37).cos() * 3.0);
            let plain = Neighbourhood::around(cell(p), |cells| least(cells, p, |d| d * d));
            assert_eq!(Crackle::default().least(p).map(f64::to_bits), plain.map(f64::to_bits), "{p}");
        }
    }

    #[test]
    fn roots_by_other_means_are_the_same() {
        for metric in [0.5, 1.0, 2.0, 3.0, 4.0, 2.5] {
            let crackle = Crackle { metric, ..Crackle::default() };
            for i in 0..50 {
                let s = f64::from(i) * 0.09;
                assert!((crackle.root(s) - s.powf(1.0 / metric)).abs() <= 1e-14 * (1.0 + s), "{s} {metric}");
            }
        }
    }

    #[test]
    fn leaving_cells_out_changes_nothing() {
        for metric in [0.5, 0.7, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 5.0] {
            let crackle = Crackle { metric, ..Crackle::default() };
            for i in 0..300 {
                let t = f64::from(i);
                let p = Vec3::new((t * 0.37).sin() * 4.0, t * 0.013 - 2.0, (t * 0.73).cos() * 3.0);
                let power = |q: Vec3| (q - p).to_array().map(|d| crackle.power(d)).iter().sum::<f64>();
                let mut all: Vec<f64> =
                    Neighbourhood::around(cell(p), |cells| cells.all().map(|(_, q)| power(q)).collect());
                all.sort_by(f64::total_cmp);
                let found = crackle.least(p);
                assert!(found.iter().zip(&all).all(|(a, b)| (a - b).abs() < 1e-14), "{p} metric {metric}");
                assert_eq!(power(crackle.nearest(p)), all[0], "{p} metric {metric}");
            }
        }
    }
}
