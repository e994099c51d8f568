//! Surface of revolution about the y axis whose squared radius is a cubic in y between given heights.
//!
//! | parameter | unit | meaning |
//! |---|---|---|
//! | points | length | radius and height; the first and the last only set slopes |
//! | open | – | leaves the two end discs out; the inside stays |
//!
//! In each span `x² + z² = r²(y)`: a cubic in the distance along a ray, inside the span's two planes.
//!
//! Numerical care: a span's cubic is set up from its lower height and from where the ray enters the span
//! or the cylinder around the shape; neighbouring spans agree about the circle
//! where they meet.

use super::span::slab;
use super::sphere::turn_about_y;
use super::{COINCIDENT, Crossing, Shape, rounding};
use crate::math::polynomial::{Touching, roots, sign_changes, value, value_and_slope};
use crate::math::{Aabb, Range, Ray, Vec2, Vec3};

/// End discs with a squared radius up to this part of the largest are left out.
const POINT: f64 = 1e-12;

#[derive(Clone, Debug, PartialEq)]
pub struct Sor {
    spans: Vec<SorSpan>,
    outer: f64,
    open: bool,
}

#[derive(Clone, Debug, PartialEq)]
struct SorSpan {
    low: f64,
    high: f64,
    /// Squared radii at the two heights.
    ends: [f64; 2],
    /// Squared radius by height above `low`, lowest power first.
    square: [f64; 4],
}

/// What is wrong with a list of points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SorError {
    NegativeRadius,
    HeightsNotRising,
    /// The first and third or the last but two and last point have the same height.
    NoSlope,
}

impl SorSpan {
    fn new(points: &[Vec2]) -> Self {
        let [before, low, high, after] = [points[0], points[1], points[2], points[3]];
        let height = high.y - low.y;
        let (r0, r1) = (low.x * low.x, high.x * high.x);
        let s0 = 2.0 * low.x * (high.x - before.x) / (high.y - before.y);
        let s1 = 2.0 * high.x * (after.x - low.x) / (after.y - low.y);
        let mean = (r1 - r0) / height;
        let square =
            [r0, s0, (3.0 * mean - 2.0 * s0 - s1) / height, (s0 + s1 - 2.0 * mean) / (height * height)];
        Self { low: low.y, high: high.y, ends: [r0, r1], square }
    }

    fn largest(&self) -> f64 {
        let slope = [self.square[1], 2.0 * self.square[2], 3.0 * self.square[3]];
        let inner = Range::new(0.0, self.high - self.low);
        let turns = roots(&slope, inner, Touching::Skip);
        turns.iter().map(|&h| value(&self.square, h)).chain(self.ends).fold(0.0, f64::max)
    }

    /// Distances along a ray, measured from where it is nearest to the axis. The ray is more than `reach`
    /// from there outside the whole shape.
    fn distances(&self, trace: &Trace, reach: f64, mut found: impl FnMut(f64)) {
        let Some((enter, leave)) = slab(trace.y0, trace.along, self.low, self.high) else { return };
        let (near, far) = (enter.max(-reach), leave.min(reach));
        if near >= far {
            return;
        }
        let h = trace.y0 + near * trace.along - self.low;
        // r²(h + v t) by powers of t.
        let [_, b, c, d] = self.square;
        let v = trace.along;
        let r = [
            value(&self.square, h),
            v * (b + h * (2.0 * c + 3.0 * d * h)),
            v * v * (c + 3.0 * d * h),
            v * v * v * d,
        ];
        let square = |t: f64| trace.b2 + trace.across2 * t * t;
        let k = [square(near) - r[0], 2.0 * trace.across2 * near - r[1], trace.across2 - r[2], -r[3]];
        let [first, last] = if v > 0.0 { self.ends } else { [self.ends[1], self.ends[0]] };
        let start = if near == enter { square(near) - first } else { 1.0 };
        let end = if far == leave { square(far) - last } else { 1.0 };
        for s in sign_changes(&k, (0.0, start), (far - near, end)) {
            found(near + s);
        }
    }
}

/// A ray from where it is nearest to the axis.
struct Trace {
    t0: f64,
    y0: f64,
    b2: f64,
    across2: f64,
    along: f64,
}

impl Trace {
    fn new(ray: &Ray) -> Self {
        let (o, d) = (Vec2::new(ray.origin.x, ray.origin.z), Vec2::new(ray.dir.x, ray.dir.z));
        let across2 = d.length_squared();
        let t0 = if across2 > 0.0 { -o.dot(d) / across2 } else { 0.0 };
        let b2 = (o + t0 * d).length_squared();
        Self { t0, y0: ray.origin.y + t0 * ray.dir.y, b2, across2, along: ray.dir.y }
    }
}

impl Sor {
    /// At least four points.
    pub fn new(points: &[Vec2], open: bool) -> Result<Self, SorError> {
        if points.iter().any(|p| p.x < 0.0) {
            return Err(SorError::NegativeRadius);
        }
        let inner = &points[1..points.len() - 1];
        let rises = |w: &[Vec2]| w[1].y > w[0].y;
        let slopes = points.windows(3).all(|w| w[2].y != w[0].y);
        if !inner.windows(2).all(rises) {
            return Err(SorError::HeightsNotRising);
        }
        if !slopes {
            return Err(SorError::NoSlope);
        }
        let spans: Vec<SorSpan> = points.windows(4).map(SorSpan::new).collect();
        let outer = spans.iter().map(SorSpan::largest).fold(0.0, f64::max).sqrt();
        Ok(Self { spans, outer, open })
    }

    fn low(&self) -> f64 {
        self.spans[0].low
    }

    fn high(&self) -> f64 {
        self.spans[self.spans.len() - 1].high
    }

    /// The end discs' parts follow those of the spans.
    fn base_part(&self) -> u32 {
        self.spans.len() as u32
    }

    /// Height and squared radius of both end discs.
    fn discs(&self) -> [(f64, f64); 2] {
        [(self.low(), self.spans[0].ends[0]), (self.high(), self.spans[self.spans.len() - 1].ends[1])]
    }

    fn visit(&self, ray: &Ray, range: Range, mut found: impl FnMut(Crossing)) {
        let trace = Trace::new(ray);
        let outer2 = self.outer * self.outer * (1.0 + 1e-6);
        if trace.b2 > outer2 {
            return;
        }
        let reach = ((outer2 - trace.b2) / trace.across2).sqrt();
        for (i, span) in self.spans.iter().enumerate() {
            span.distances(&trace, reach, |s| {
                let t = trace.t0 + s;
                if range.contains(t) {
                    found(Crossing::on_part(t, i as u32));
                }
            });
        }
        if self.open || trace.along == 0.0 {
            return;
        }
        for (i, (height, square)) in self.discs().into_iter().enumerate() {
            let s = (height - trace.y0) / trace.along;
            let t = trace.t0 + s;
            let solid = square > POINT * self.outer * self.outer;
            if solid && trace.b2 + trace.across2 * s * s <= square && range.contains(t) {
                found(Crossing::on_part(t, self.base_part() + i as u32));
            }
        }
    }

    fn span_at(&self, y: f64) -> &SorSpan {
        let after = self.spans.partition_point(|s| s.high < y);
        &self.spans[after.min(self.spans.len() - 1)]
    }
}

impl Shape for Sor {
    fn bounds(&self) -> Aabb {
        Aabb {
            min: Vec3::new(-self.outer, self.low(), -self.outer),
            max: Vec3::new(self.outer, self.high(), self.outer),
        }
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        self.visit(ray, range, |c| out.push(c));
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let mut best: Option<Crossing> = None;
        self.visit(ray, range, |c| {
            if best.is_none_or(|b| c.t <= b.t) {
                best = Some(c);
            }
        });
        best
    }

    fn contains(&self, p: Vec3) -> bool {
        let margin = COINCIDENT * (self.outer + self.high() - self.low());
        if p.y < self.low() - margin || p.y > self.high() + margin {
            return false;
        }
        let span = self.span_at(p.y);
        let square = value(&span.square, (p.y - span.low).max(0.0).min(span.high - span.low));
        p.x * p.x + p.z * p.z <= square + margin * self.outer
    }

    fn normal(&self, p: Vec3, crossing: &Crossing) -> Vec3 {
        match crossing.part.checked_sub(self.base_part()) {
            Some(0) => Vec3::NEG_Y,
            Some(_) => Vec3::Y,
            None => {
                let span = &self.spans[crossing.part as usize];
                let slope = value_and_slope(&span.square, p.y - span.low).1;
                Vec3::new(p.x, -0.5 * slope, p.z).normalize_or(Vec3::Y)
            }
        }
    }

    fn locate(&self, ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        let p = ray.at(crossing.t);
        let p = match crossing.part.checked_sub(self.base_part()) {
            Some(end) => p.with_y(self.discs()[end as usize].0),
            None => {
                let span = &self.spans[crossing.part as usize];
                let r = value(&span.square, p.y - span.low).max(0.0).sqrt();
                (Vec3::new(p.x, 0.0, p.z).normalize_or_zero() * r).with_y(p.y)
            }
        };
        (p, rounding(8.0 * (self.outer + self.low().abs().max(self.high().abs()))))
    }

    fn uv(&self, p: Vec3, crossing: &Crossing) -> Option<Vec2> {
        let r = p.x.hypot(p.z);
        let v = match crossing.part.checked_sub(self.base_part()) {
            Some(0) => r / self.discs()[0].1.sqrt() - 1.0,
            Some(_) => 2.0 - r / self.discs()[1].1.sqrt(),
            None => {
                let span = &self.spans[crossing.part as usize];
                let fraction = (p.y - span.low) / (span.high - span.low);
                (f64::from(crossing.part) + fraction) / self.spans.len() as f64
            }
        };
        Some(Vec2::new(turn_about_y(p), v))
    }

    fn kind(&self) -> &'static str {
        "sor"
    }

    fn heap_bytes(&self) -> usize {
        self.spans.capacity() * size_of::<SorSpan>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrong_points_are_refused() {
        let p = |x: f64, y: f64| Vec2::new(x, y);
        let good = [p(0.0, -1.0), p(0.5, 0.0), p(0.7, 1.0), p(0.2, 2.0)];
        assert!(Sor::new(&good, false).is_ok());
        let mut bad = good;
        bad[2].y = -0.5;
        assert_eq!(Sor::new(&bad, false), Err(SorError::HeightsNotRising));
        bad = good;
        bad[1].x = -0.1;
        assert_eq!(Sor::new(&bad, false), Err(SorError::NegativeRadius));
    }
}
