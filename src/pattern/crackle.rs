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
//! third nearest point among these; four distances at a time for the metrics 1/2, 1, 3/2, ... 4. Where many
//! questions come from one small place, the few points that matter there are listed (`nook.rs`).
//!
//! Reference: S. Worley, "A Cellular Texture Basis Function", SIGGRAPH 1996.

use super::lattice_points::{GROUPS, Neighbourhood};
use super::nook::{self, Four};
use super::{EDGE, Modifier, Pattern, Setting};
use crate::math::noise::noise;
use crate::math::{Vec3, floor_of};
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
        match self.metric {
            2.0 => d * d,
            1.0 => d.abs(),
            1.5 => d.abs() * d.abs().sqrt(),
            3.0 => d.abs() * (d * d),
            4.0 => (d * d) * (d * d),
            metric => d.abs().powf(metric),
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
    #[inline]
    fn least(&self, p: Vec3) -> [f64; 3] {
        let halves = 2.0 * self.metric;
        #[cfg(target_arch = "x86_64")]
        if halves == 4.0 && wide::is_available() {
            return wide::least(p);
        }
        match halves {
            4.0 => least(p, 2.0, square),
            2.0 => least(p, 1.0, f64::abs),
            1.0 => least(p, 0.5, |d| d.abs().sqrt()),
            3.0 => least(p, 1.5, |d| d.abs() * d.abs().sqrt()),
            5.0 => least(p, 2.5, |d| d * d * d.abs().sqrt()),
            6.0 => least(p, 3.0, |d| d * d * d.abs()),
            7.0 => least(p, 3.5, |d| d * d * d.abs() * d.abs().sqrt()),
            8.0 => least(p, 4.0, |d| (d * d) * (d * d)),
            _ => self.least_of_any(p),
        }
    }

    /// The same for any metric.
    fn least_of_any(&self, p: Vec3) -> [f64; 3] {
        let power = |d| self.power(d);
        let known = if self.metric > 0.0 {
            nook::around(p, self.metric, power, |fours| least_of(fours, p, power))
        } else {
            None
        };
        known.unwrap_or_else(|| Neighbourhood::around(cell(p), |cells| self.least_one_by_one(cells, p)))
    }

    /// The same, one cell after the other.
    fn least_one_by_one(&self, cells: &mut Neighbourhood, p: Vec3) -> [f64; 3] {
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
        if self.metric == 2.0 {
            nearest(p, true, square)
        } else {
            nearest(p, self.metric > 0.0, |d| self.power(d))
        }
    }
}

/// The lowest corner of the cell around a point.
fn cell(p: Vec3) -> Vec3 {
    floor_of(p - Vec3::splat(EDGE))
}

fn lower(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

fn upper(a: f64, b: f64) -> f64 {
    if a < b { b } else { a }
}

/// Puts a number among the three smallest.
#[inline(always)]
pub(super) fn insert(s: &mut [f64; 3], v: f64) {
    s[2] = lower(s[2], upper(s[1], v));
    s[1] = lower(s[1], upper(s[0], v));
    s[0] = lower(s[0], v);
}

/// The three smallest sums, for a power that grows with distance.
#[inline(always)]
fn least(p: Vec3, metric: f64, power: impl Fn(f64) -> f64 + Copy) -> [f64; 3] {
    match nook::around(p, metric, power, |fours| least_of(fours, p, power)) {
        Some(sums) => sums,
        None => Neighbourhood::around(cell(p), |cells| least_around(cells, p, power)),
    }
}

#[inline(always)]
fn square(d: f64) -> f64 {
    d * d
}

/// [`least`] for squares, four at once: the same operations, so the same bits.
#[cfg(target_arch = "x86_64")]
mod wide {
    use super::*;
    use std::arch::x86_64::*;

    pub fn is_available() -> bool {
        std::arch::is_x86_feature_detected!("avx2")
    }

    /// Only where [`is_available`] holds.
    #[allow(unsafe_code)]
    pub fn least(p: Vec3) -> [f64; 3] {
        assert!(is_available());
        // SAFETY: the processor has just been seen to have what these are compiled for.
        match nook::around(p, 2.0, square, |fours| unsafe { least_of(fours, p) }) {
            Some(sums) => sums,
            None => Neighbourhood::around(cell(p), |cells| unsafe { least_around(cells, p) }),
        }
    }

    #[target_feature(enable = "avx2")]
    fn least_of(fours: &[Four], p: Vec3) -> [f64; 3] {
        let (mut lists, p) = (none(), splat(p));
        for [x, y, z] in fours {
            add(&mut lists, [x, y, z], p);
        }
        merged(&lists)
    }

    #[target_feature(enable = "avx2")]
    fn least_around(cells: &mut Neighbourhood, p: Vec3) -> [f64; 3] {
        let (mut lists, lanes) = (none(), splat(p));
        let places = cells.group(0);
        for four in cells.fours(places) {
            add(&mut lists, four, lanes);
        }
        let mut least = merged(&lists);
        for group in 1..GROUPS {
            if square(cells.gap(group, p)) < least[2] {
                let places = cells.group(group);
                for four in cells.fours(places) {
                    add(&mut lists, four, lanes);
                }
                least = merged(&lists);
            }
        }
        least
    }

    /// As [`Lists`](super::Lists).
    type Lists = [__m256d; 3];

    #[target_feature(enable = "avx2")]
    #[inline]
    fn none() -> Lists {
        [_mm256_set1_pd(f64::INFINITY); 3]
    }

    #[target_feature(enable = "avx2")]
    #[inline]
    fn splat(p: Vec3) -> [__m256d; 3] {
        [_mm256_set1_pd(p.x), _mm256_set1_pd(p.y), _mm256_set1_pd(p.z)]
    }

    #[target_feature(enable = "avx2")]
    #[inline]
    fn add(lists: &mut Lists, [x, y, z]: [&[f64; 4]; 3], p: [__m256d; 3]) {
        let [a, b, c] = *lists;
        let (x, y, z) = (square_of(x, p[0]), square_of(y, p[1]), square_of(z, p[2]));
        let sum = _mm256_add_pd(_mm256_add_pd(x, y), z);
        *lists = [
            _mm256_min_pd(a, sum),
            _mm256_min_pd(b, _mm256_max_pd(a, sum)),
            _mm256_min_pd(c, _mm256_max_pd(b, sum)),
        ];
    }

    #[target_feature(enable = "avx2")]
    #[inline]
    fn square_of(c: &[f64; 4], p: __m256d) -> __m256d {
        let d = _mm256_sub_pd(_mm256_setr_pd(c[0], c[1], c[2], c[3]), p);
        _mm256_mul_pd(d, d)
    }

    /// One list of all.
    #[target_feature(enable = "avx2")]
    #[inline]
    fn merged(lists: &Lists) -> [f64; 3] {
        let [a, b, c] = *lists;
        let low = [_mm256_castpd256_pd128(a), _mm256_castpd256_pd128(b), _mm256_castpd256_pd128(c)];
        let high =
            [_mm256_extractf128_pd::<1>(a), _mm256_extractf128_pd::<1>(b), _mm256_extractf128_pd::<1>(c)];
        let [a, b, c] = merge(low, high);
        let other = [_mm_unpackhi_pd(a, a), _mm_unpackhi_pd(b, b), _mm_unpackhi_pd(c, c)];
        let [a, b, c] = merge([a, b, c], other);
        [_mm_cvtsd_f64(a), _mm_cvtsd_f64(b), _mm_cvtsd_f64(c)]
    }

    /// As [`merge`](super::merge), two at once.
    #[target_feature(enable = "avx2")]
    #[inline]
    fn merge(a: [__m128d; 3], b: [__m128d; 3]) -> [__m128d; 3] {
        let crossed = _mm_min_pd(_mm_max_pd(a[1], b[0]), _mm_max_pd(a[0], b[1]));
        [
            _mm_min_pd(a[0], b[0]),
            _mm_min_pd(_mm_min_pd(a[1], b[1]), _mm_max_pd(a[0], b[0])),
            _mm_min_pd(_mm_min_pd(a[2], b[2]), crossed),
        ]
    }
}

/// The three smallest sums among all points around a cell.
#[inline(always)]
fn least_around(cells: &mut Neighbourhood, p: Vec3, power: impl Fn(f64) -> f64 + Copy) -> [f64; 3] {
    let mut lists = Lists::NONE;
    let places = cells.group(0);
    for four in cells.fours(places) {
        lists.add(four, p, power);
    }
    let mut least = lists.merged();
    for group in 1..GROUPS {
        if power(cells.gap(group, p)) < least[2] {
            let places = cells.group(group);
            for four in cells.fours(places) {
                lists.add(four, p, power);
            }
            least = lists.merged();
        }
    }
    least
}

/// The three smallest sums among some points.
#[inline(always)]
fn least_of(fours: &[Four], p: Vec3, power: impl Fn(f64) -> f64 + Copy) -> [f64; 3] {
    let mut lists = Lists::NONE;
    for [x, y, z] in fours {
        lists.add([x, y, z], p, power);
    }
    lists.merged()
}

/// The nearest point; `grows` says whether the power grows with distance.
#[inline(always)]
fn nearest(p: Vec3, grows: bool, power: impl Fn(f64) -> f64) -> Vec3 {
    Neighbourhood::around(cell(p), |cells| {
        let (mut least, mut at) = (f64::INFINITY, p);
        for group in 0..GROUPS {
            if group > 0 && grows && power(cells.gap(group, p)) >= least {
                continue;
            }
            let places = cells.group(group);
            for [x, y, z] in cells.fours(places) {
                for i in 0..4 {
                    let sum = power(x[i] - p.x) + power(y[i] - p.y) + power(z[i] - p.z);
                    // Empty places are infinitely far, which is near where powers fall with distance.
                    if sum < least && x[i] < f64::INFINITY {
                        (least, at) = (sum, Vec3::new(x[i], y[i], z[i]));
                    }
                }
            }
        }
        at
    })
}

/// Four lists of the three smallest sums, side by side: the smallest of all lists, the second ones, the third ones.
struct Lists([[f64; 4]; 3]);

impl Lists {
    const NONE: Self = Lists([[f64::INFINITY; 4]; 3]);

    /// Adds a point to each list.
    #[inline(always)]
    fn add(&mut self, [x, y, z]: [&[f64; 4]; 3], p: Vec3, power: impl Fn(f64) -> f64) {
        let s = &mut self.0;
        let sums: [f64; 4] =
            std::array::from_fn(|i| power(x[i] - p.x) + power(y[i] - p.y) + power(z[i] - p.z));
        for i in 0..4 {
            s[2][i] = lower(s[2][i], upper(s[1][i], sums[i]));
            s[1][i] = lower(s[1][i], upper(s[0][i], sums[i]));
            s[0][i] = lower(s[0][i], sums[i]);
        }
    }

    /// One list of all.
    #[inline(always)]
    fn merged(&self) -> [f64; 3] {
        let [a, b, c] = &self.0;
        let list = |i: usize| [a[i], b[i], c[i]];
        merge(merge(list(0), list(2)), merge(list(1), list(3)))
    }
}

/// The three smallest of two lists, each in rising order.
#[inline(always)]
fn merge(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    let crossed = lower(upper(a[1], b[0]), upper(a[0], b[1]));
    [lower(a[0], b[0]), lower(lower(a[1], b[1]), upper(a[0], b[0])), lower(lower(a[2], b[2]), crossed)]
}

impl Pattern for Crackle {
    fn value(&self, p: Vec3, setting: &Setting) -> f64 {
        if self.solid {
            return noise(self.nearest(p), setting.noise);
        }
        let sums = self.least(p);
        let lift = match (self.offset, self.metric) {
            (0.0, _) => 0.0,
            (offset, 2.0) => offset * offset,
            (offset, metric) => offset.powf(metric),
        };
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

    /// Powers by multiplication are those of the library but for roundings.
    #[test]
    fn powers_agree() {
        for metric in [0.5, 1.0, 1.5, 2.0, 2.2, 3.0, 4.0] {
            let crackle = Crackle { metric, ..Default::default() };
            for d in [0.0, 1e-9, -0.3, 0.7, -1.0, 2.4] {
                let expected = f64::abs(d).powf(metric);
                assert!((crackle.power(d) - expected).abs() <= 4.0 * f64::EPSILON * expected, "{metric} {d}");
            }
        }
    }

    #[test]
    #[cfg(target_arch = "x86_64")]
    fn wide_sums_are_the_plain_ones() {
        if !wide::is_available() {
            println!("skipped: no AVX2");
            return;
        }
        for i in 0..300 {
            let t = f64::from(i);
            let p = Vec3::new((t * 0.71).sin() * 40.0, t * 0.13 - 2.0, (t * 0.37).cos() * 3.0);
            let plain = Neighbourhood::around(cell(p), |cells| least_around(cells, p, |d| d * d));
            assert_eq!(Crackle::default().least(p).map(f64::to_bits), plain.map(f64::to_bits), "{p}");
        }
    }

    #[test]
    fn places_asked_about_often_have_the_same_values() {
        for metric in [0.5, 0.7, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 5.0] {
            let crackle = Crackle { metric, ..Crackle::default() };
            let mut listed = 0;
            for i in 0..2000 {
                // Sixty boxes, one after the other, with their faces.
                let t = f64::from(i / 33);
                let f =
                    Vec3::new((f64::from(i) * 0.71).sin(), (f64::from(i) * 0.37).sin(), f64::from(i % 3 - 1));
                let middle = Vec3::new((t * 0.9).sin() * 9.0, t * 0.33 - 7.0, (t * 0.7).cos() * 3.0);
                let p = (middle * 4.0).floor() * 0.25 + 0.125 * (1.0 + f);
                let plain =
                    Neighbourhood::around(cell(p), |cells| least_around(cells, p, |d| crackle.power(d)));
                let found = crackle.least(p);
                assert!(found.iter().zip(plain).all(|(a, b)| (a - b).abs() <= 1e-14 * b), "{p}: {metric}");
                listed += usize::from(nook::around(p, metric, |d| crackle.power(d), |_| ()).is_some());
            }
            assert!(listed > 500, "{listed} at {metric}");
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
