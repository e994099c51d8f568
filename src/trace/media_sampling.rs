//! Where media are sampled along a stretch, and how the samples are put together.
//!
//! Method 1 draws places at random, method 2 spaces them evenly, method 3 starts evenly and looks between
//! two places again where they differ. Methods 1 and 2 take more samples while their variance is large.

use super::media::{ALIKE_IN_SIGHT, Local, Medium, Stretch, exp};
use super::tracer::Tracer;
use crate::color::Rgb;
use smallvec::SmallVec;

/// Halvings that method 3 makes at most, whatever the scene asks for.
const DEEPEST: u32 = 24;

/// Optical depth behind which nothing is seen: less than a millionth of the light comes through.
const OPAQUE: f32 = 16.0;

/// Fewest intervals for the truth.
const FINE: u32 = 48;

/// What decides about places.
pub(super) struct Plan {
    /// The medium that decides, a place in `Tracer::media`.
    medium: u32,
    pub intervals: u32,
    pub samples: (u32, u32),
    pub method: u32,
    pub jitter: f64,
    threshold: f32,
    level: u32,
    /// Share of the intervals that lit parts get.
    ratio: f64,
    pub has_density: bool,
    /// Densities are asked for exactly.
    truth: bool,
}

impl Plan {
    pub fn new(place: u32, medium: &Medium, threshold: f32) -> Self {
        let m = medium.media;
        Self {
            medium: place,
            intervals: m.intervals.max(1),
            samples: (m.samples.0.max(1), m.samples.1),
            method: m.method,
            jitter: f64::from(m.jitter),
            threshold,
            level: m.aa_level.min(DEEPEST),
            ratio: f64::from(m.ratio),
            has_density: !m.densities.is_empty(),
            truth: false,
        }
    }

    /// Many short intervals, sampled at random.
    pub fn fine(self) -> Self {
        let intervals = self.intervals.saturating_mul(4).clamp(FINE, FINE * FINE);
        Self { intervals, samples: (2, 2), method: 1, ratio: 0.5, has_density: true, truth: true, ..self }
    }

    /// The same with no more samples than `most`, or with other intervals.
    pub fn with(mut self, most: Option<u32>, intervals: Option<u32>) -> Self {
        if let Some(most) = most {
            self.samples = (self.samples.0.min(most).max(1), self.samples.1.min(most));
        }
        self.intervals = intervals.unwrap_or(self.intervals);
        self
    }
}

/// A part of the stretch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Interval {
    pub start: f64,
    pub length: f64,
    lit: bool,
    /// Sums over the samples: light sent, its squares, optical depth.
    glow: Rgb,
    squares: Rgb,
    depth: Rgb,
    samples: u32,
}

impl Interval {
    fn new(start: f64, length: f64, lit: bool) -> Self {
        Self { start, length, lit, glow: Rgb::ZERO, squares: Rgb::ZERO, depth: Rgb::ZERO, samples: 0 }
    }

    fn add(&mut self, glow: Rgb, depth: Rgb) {
        self.glow += glow;
        self.squares += glow * glow;
        self.depth += depth;
        self.samples += 1;
    }

    fn variance(&self) -> Rgb {
        let n = self.samples as f32;
        let mean = self.glow / n;
        (self.squares / n - mean * mean) / n
    }
}

pub(super) type Intervals = SmallVec<[Interval; 4]>;

/// The light that the media on the stretch send, and their optical depth.
pub(super) fn sampled(tracer: &mut Tracer, stretch: &Stretch, plan: &Plan) -> (Rgb, Rgb) {
    let mut intervals = intervals(stretch, plan);
    let mut front = Rgb::ZERO;
    for interval in &mut intervals {
        if is_opaque(front) || !tracer.goes_on(stretch, front) {
            interval.samples = 1;
            continue;
        }
        match plan.method {
            3 => adaptive(tracer, stretch, plan, interval, front),
            _ => even_or_random(tracer, stretch, plan, interval, front),
        }
        front += interval.depth / interval.samples as f32;
    }
    if plan.method != 3 && !stretch.is_shadow() && plan.samples.1 > plan.samples.0 {
        stretch.share.set(f32::INFINITY);
        for interval in &mut intervals {
            refine(tracer, stretch, plan, interval);
        }
    }
    let (mut glow, mut depth) = (Rgb::ZERO, Rgb::ZERO);
    for interval in &intervals {
        let n = interval.samples as f32;
        if interval.glow != Rgb::ZERO {
            glow += interval.glow / n * exp(-depth);
        }
        depth += interval.depth / n;
    }
    (glow, depth)
}

/// Cuts the stretch into lit and unlit parts, and those into intervals.
pub(super) fn intervals(stretch: &Stretch, plan: &Plan) -> Intervals {
    let mut parts: SmallVec<[(f64, f64, bool); 8]> = SmallVec::new();
    let mut end = 0.0;
    for (from, to) in stretch.lit_parts() {
        if from > end {
            parts.push((end, from, false));
        }
        parts.push((from, to, true));
        end = to;
    }
    if end < stretch.length {
        parts.push((end, stretch.length, false));
    }
    let mut out = Intervals::new();
    if let [(from, to, lit)] = parts[..] {
        let n = if !lit && !plan.has_density { 1 } else { plan.intervals };
        push_equal(&mut out, from, to, lit, n);
        return out;
    }
    let weight = |lit: bool| if lit { plan.ratio } else { 1.0 - plan.ratio };
    let sum: f64 = parts.iter().map(|p| weight(p.2)).sum();
    let n = plan.intervals.max(parts.len() as u32);
    let mut remaining = n;
    for (i, &(from, to, lit)) in parts.iter().enumerate() {
        let later = (parts.len() - 1 - i) as u32;
        let share = (weight(lit) / sum * f64::from(n)) as u32 + 1;
        let count = share.min(remaining.saturating_sub(later)).max(1);
        push_equal(&mut out, from, to, lit, count);
        remaining = remaining.saturating_sub(count);
    }
    out
}

fn push_equal(out: &mut Intervals, from: f64, to: f64, lit: bool, n: u32) {
    let length = (to - from) / f64::from(n);
    out.extend((0..n).map(|i| Interval::new(from + length * f64::from(i), length, lit)));
}

/// Methods 1 and 2: the samples that every interval gets.
fn even_or_random(tracer: &mut Tracer, stretch: &Stretch, plan: &Plan, interval: &mut Interval, front: Rgb) {
    let n = plan.samples.0;
    stretch.aim(plan, front, interval.length, n);
    for j in 0..n {
        let random = tracer.random.draw();
        let d = if plan.method == 1 {
            random
        } else {
            (f64::from(j) + 0.5 + random * plan.jitter) / f64::from(n)
        };
        take(tracer, stretch, interval, d);
    }
}

/// Whether so little light comes from behind the optical depth that it does not count.
pub(super) fn is_opaque(depth: Rgb) -> bool {
    depth.min_element() > OPAQUE
}

impl Stretch<'_, '_> {
    /// Sampling goes on behind optical depth `front`, in an interval of `length` with so many samples.
    fn aim(&self, plan: &Plan, front: Rgb, length: f64, samples: u32) {
        self.sample_share.set(1.0 / samples as f32);
        if let Some(path) = self.path {
            let seen = path.weight * (-front.min_element()).exp();
            self.share.set(seen * length as f32);
            self.slack.set(if plan.truth { 0.0 } else { ALIKE_IN_SIGHT * samples as f32 / seen });
        }
    }
}

/// Methods 1 and 2: more samples while the variance is too large.
fn refine(tracer: &mut Tracer, stretch: &Stretch, plan: &Plan, interval: &mut Interval) {
    while interval.samples <= plan.samples.1 {
        let thresholds = &tracer.media[plan.medium as usize].thresholds;
        let Some(&threshold) = thresholds.get(interval.samples as usize - 1) else { return };
        if !interval.variance().cmpge(Rgb::splat(threshold)).any() {
            return;
        }
        let d = tracer.random.draw();
        take(tracer, stretch, interval, d);
    }
}

/// Samples at fraction `d` of the interval, dimmed by the part of the interval before it.
fn take(tracer: &mut Tracer, stretch: &Stretch, interval: &mut Interval, d: f64) {
    let local = tracer.local(stretch, interval.start + d * interval.length, interval.lit);
    let length = interval.length as f32;
    let depth = local.extinction * length;
    interval.add(local.glow * length * exp(-depth * d as f32), depth);
}

/// Method 3.
fn adaptive(tracer: &mut Tracer, stretch: &Stretch, plan: &Plan, interval: &mut Interval, front: Rgb) {
    let n = (plan.samples.0 / 2 + 1).max(2);
    let step = 1.0 / f64::from(n + 1);
    let probe = Probe { stretch, plan, interval: *interval };
    let (mut glow, mut depth) = (Rgb::ZERO, Rgb::ZERO);
    stretch.aim(plan, front, interval.length, 2 * n);
    let mut before = probe.at(tracer, 0.0, step);
    for j in 1..=n {
        let reached = front + depth / n as f32;
        if is_opaque(reached) || (j > 1 && !tracer.goes_on(stretch, reached)) {
            break;
        }
        stretch.aim(plan, reached, interval.length, 2 * n);
        let (a, b) = (f64::from(j - 1) * step, f64::from(j) * step);
        let after = probe.at(tracer, b, step);
        let mean = probe.between(tracer, (a, before), (b, after), plan.level as i32 - 1);
        if mean.glow != Rgb::ZERO {
            glow += mean.glow * exp(-depth / n as f32);
        }
        depth += mean.extinction;
        before = after;
    }
    interval.glow = glow;
    interval.depth = depth;
    interval.samples = n;
}

/// Method 3's view of one interval: samples hold light and depth of the whole interval's length.
struct Probe<'a, 's, 'w> {
    stretch: &'a Stretch<'s, 'w>,
    plan: &'a Plan,
    interval: Interval,
}

impl Probe<'_, '_, '_> {
    /// The sample at fraction `d`, shaken within `width`.
    fn at(&self, tracer: &mut Tracer, d: f64, width: f64) -> Local {
        let shift = if self.plan.jitter == 0.0 {
            0.0
        } else {
            width * self.plan.jitter * (tracer.random.draw() - 0.5)
        };
        let s = self.interval.start + (d + shift) * self.interval.length;
        let local = tracer.local(self.stretch, s, self.interval.lit);
        let length = self.interval.length as f32;
        Local { glow: local.glow * length, extinction: local.extinction * length }
    }

    /// The mean between two samples; halves that differ at their ends are looked into.
    fn between(&self, tracer: &mut Tracer, a: (f64, Local), b: (f64, Local), level: i32) -> Local {
        let middle = 0.5 * (a.0 + b.0);
        let m = (middle, self.at(tracer, middle, b.0 - a.0));
        if level <= 0 {
            return weighted(&[(a.1, 1.0 / 3.0), (m.1, 1.0 / 3.0), (b.1, 1.0 / 3.0)]);
        }
        let mut half = |end: (f64, Local), low: (f64, Local), high: (f64, Local)| {
            if (end.1.glow - m.1.glow).abs().element_sum() > self.plan.threshold {
                weighted(&[(self.between(tracer, low, high, level - 1), 0.5)])
            } else {
                weighted(&[(end.1, 1.0 / 3.0), (m.1, 1.0 / 6.0)])
            }
        };
        let left = half(a, a, m);
        let right = half(b, m, b);
        weighted(&[(left, 1.0), (right, 1.0)])
    }
}

fn weighted(parts: &[(Local, f32)]) -> Local {
    let mut sum = Local { glow: Rgb::ZERO, extinction: Rgb::ZERO };
    for (part, weight) in parts {
        sum.glow += part.glow * *weight;
        sum.extinction += part.extinction * *weight;
    }
    sum
}

#[cfg(test)]
pub(super) mod tests {
    use crate::color::Rgb;
    use crate::material::Media;
    use crate::math::Transform;

    pub fn medium() -> Media {
        Media {
            intervals: 1,
            samples: (10, 10),
            method: 3,
            jitter: 0.0,
            aa_threshold: 0.1,
            aa_level: 3,
            collect: true,
            absorption: Rgb::ZERO,
            emission: Rgb::ZERO,
            scattering: Rgb::ZERO,
            scattering_type: 1,
            eccentricity: 0.0,
            extinction: 1.0,
            confidence: 0.9,
            variance: 1.0 / 128.0,
            ratio: 0.9,
            densities: Vec::new(),
            transform: Transform::IDENTITY,
        }
    }
}
