//! Lathe: a profile in the x-y plane turned about the y axis. It is not closed at its ends.
//!
//! | parameter | unit | meaning |
//! |---|---|---|
//! | pieces | length | the profile; x is the radius |
//!
//! With `b` the ray's distance from the axis, `h` and `v` its speeds across and along the axis and `y0` its
//! height where it is nearest to the axis, a point of the profile is met where
//! `h² (y(w) - y0)² = v² (x(w)² - b²)`.
//!
//! Inside is what an odd number of profile points at the same height have a larger radius than, between the
//! smallest and the largest radius of the profile.
//!
//! Numerical care: for rays almost across the axis two roots come close and are refined one by one; for
//! rays across it the profile is met at the ray's height, on both sides. Neighbouring pieces agree about where they meet.

use super::curve::Piece;
use super::sphere::turn_about_y;
use super::{Crossing, Shape, rounding};
use crate::math::polynomial::{product, sign_changes};
use crate::math::{Aabb, Range, Ray, Vec2, Vec3};

/// Below this ratio of its speeds along and across the axis a ray counts as level on a piece of the profile:
/// it rises by less than roundings of the profile's height change.
const LEVEL: f64 = 1e-7;

#[derive(Clone, Debug, PartialEq)]
pub struct Lathe {
    pieces: Vec<Piece>,
    low: f64,
    high: f64,
    inner: f64,
    outer: f64,
}

/// A ray as the profile sees it.
struct Trace {
    /// Distance along the ray of its point nearest to the axis, the point's height and squared radius.
    t0: f64,
    y0: f64,
    b2: f64,
    /// Speeds across and along the axis.
    across: f64,
    along: f64,
}

impl Trace {
    fn new(ray: &Ray) -> Self {
        let (o, d) = (Vec2::new(ray.origin.x, ray.origin.z), Vec2::new(ray.dir.x, ray.dir.z));
        let across2 = d.length_squared();
        let t0 = if across2 > 0.0 { -o.dot(d) / across2 } else { -ray.origin.y / ray.dir.y };
        let b2 = (o + t0 * d).length_squared();
        Self { t0, y0: ray.origin.y + t0 * ray.dir.y, b2, across: across2.sqrt(), along: ray.dir.y }
    }

    /// Whether the ray may meet the ring around a piece.
    fn may_meet(&self, piece: &Piece) -> bool {
        let reach2 = piece.max.x.abs().max(piece.min.x.abs()).powi(2) - self.b2;
        if reach2 < 0.0 {
            return false;
        }
        // The rise between the nearest point and where the ray leaves the ring's cylinder.
        let rise = self.along.abs() * reach2.sqrt();
        let slack = rounding(self.y0.abs() + piece.max.y.abs() + piece.min.y.abs()) * self.across;
        let (low, high) = ((piece.min.y - self.y0) * self.across, (piece.max.y - self.y0) * self.across);
        low <= rise + slack && high >= -rise - slack
    }
}

impl Lathe {
    pub(crate) fn new(pieces: Vec<Piece>) -> Self {
        let min = pieces.iter().fold(Vec2::INFINITY, |m, p| m.min(p.min));
        let max = pieces.iter().fold(Vec2::NEG_INFINITY, |m, p| m.max(p.max));
        Self { low: min.y, high: max.y, inner: min.x.max(0.0), outer: max.x.max(-min.x), pieces }
    }

    fn visit(&self, ray: &Ray, range: Range, mut found: impl FnMut(Crossing)) {
        let trace = Trace::new(ray);
        for (i, piece) in self.pieces.iter().enumerate() {
            if !trace.may_meet(piece) {
                continue;
            }
            let mut report = |t: f64, w: f64| {
                if range.contains(t) {
                    found(Crossing { t, part: i as u32, uv: Vec2::new(w, 0.0) });
                }
            };
            if trace.along.abs() <= LEVEL * trace.across {
                level(&trace, piece, &mut report);
            } else {
                inclined(&trace, piece, &mut report);
            }
        }
    }

    fn radius_count(&self, p: Vec2) -> usize {
        let mut count = 0;
        for piece in &self.pieces {
            if piece.min.y <= p.y && piece.max.y >= p.y && piece.max.x.max(-piece.min.x) >= p.x {
                let all = piece.crossings(0.0, 1.0, -p.y);
                count += all.iter().filter(|&&w| piece.at(w).x.abs() >= p.x).count();
            }
        }
        count
    }
}

/// The ray rises or falls: one distance for each parameter.
fn inclined(trace: &Trace, piece: &Piece, report: &mut impl FnMut(f64, f64)) {
    let mut height = piece.y;
    height[0] -= trace.y0;
    let (h2, v2) = (trace.across * trace.across, trace.along * trace.along);
    let rise: [f64; 7] = product(height, height);
    let radius = piece.x_squared();
    let mut c: [f64; 7] = std::array::from_fn(|i| h2 * rise[i] - v2 * radius[i]);
    c[0] += v2 * trace.b2;
    let side = |p: Vec2| h2 * (p.y - trace.y0).powi(2) - v2 * (p.x * p.x - trace.b2);
    for w in sign_changes(&c, (0.0, side(piece.start)), (1.0, side(piece.end))) {
        let (t, w) = refined(trace, piece, w);
        report(trace.t0 + t, w);
    }
}

/// The distance from the nearest point to where the profile is met near `w`, and the parameter there.
///
/// For a flat ray two roots lie close together and are imprecise. Of the equation's two factors,
/// `h (y - y0) = ± v sqrt(x² - b²)`, one belongs to each, and does not suffer from that.
fn refined(trace: &Trace, piece: &Piece, mut w: f64) -> (f64, f64) {
    let (h, v) = (trace.across, trace.along);
    for _ in 0..2 {
        let (p, slope) = (piece.at(w), piece.slope(w));
        let half2 = p.x * p.x - trace.b2;
        if half2 <= 1e-6 * p.x * p.x {
            break;
        }
        let signed = half2.sqrt() * ((p.y - trace.y0) * v).signum() * v;
        let step = (h * (p.y - trace.y0) - signed) / (h * slope.y - signed * p.x * slope.x / half2);
        let next = w - step;
        if !(step.abs() < 1e-3 && (0.0..=1.0).contains(&next)) {
            break;
        }
        w = next;
    }
    let p = piece.at(w);
    let by_height = (p.y - trace.y0) / v;
    let half2 = p.x * p.x - trace.b2;
    // Whichever of height and radius tells the distance better.
    if half2 > 0.0 && v.abs() * p.x.abs() < h * half2.sqrt() {
        return ((half2.sqrt() / h).copysign(by_height), w);
    }
    (by_height, w)
}

/// The ray stays at one height: the profile is met there, on both sides of the nearest point.
fn level(trace: &Trace, piece: &Piece, report: &mut impl FnMut(f64, f64)) {
    for w in piece.crossings(0.0, 1.0, -trace.y0) {
        let half2 = piece.at(w).x.powi(2) - trace.b2;
        if half2 > 0.0 {
            let half = half2.sqrt() / trace.across;
            report(trace.t0 - half, w);
            report(trace.t0 + half, w);
        }
    }
}

impl Shape for Lathe {
    fn bounds(&self) -> Aabb {
        Aabb {
            min: Vec3::new(-self.outer, self.low, -self.outer),
            max: Vec3::new(self.outer, self.high, self.outer),
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
        let r = p.x.hypot(p.z);
        let between = p.y >= self.low && p.y <= self.high && r >= self.inner && r <= self.outer;
        between && self.radius_count(Vec2::new(r, p.y)) % 2 == 1
    }

    fn normal(&self, p: Vec3, crossing: &Crossing) -> Vec3 {
        let slope = self.pieces[crossing.part as usize].slope(crossing.uv.x);
        let out = Vec3::new(p.x, 0.0, p.z).normalize_or_zero();
        (slope.y * out - slope.x * Vec3::Y).normalize_or(Vec3::Y)
    }

    fn locate(&self, ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        let p = ray.at(crossing.t);
        let q = self.pieces[crossing.part as usize].at(crossing.uv.x);
        let out = Vec3::new(p.x, 0.0, p.z).normalize_or_zero() * q.x.abs();
        (out.with_y(q.y), rounding(8.0 * (self.outer + self.low.abs().max(self.high.abs()))))
    }

    fn uv(&self, p: Vec3, crossing: &Crossing) -> Option<Vec2> {
        let v = (f64::from(crossing.part) + crossing.uv.x) / self.pieces.len() as f64;
        Some(Vec2::new(turn_about_y(p), v))
    }

    fn kind(&self) -> &'static str {
        "lathe"
    }

    fn heap_bytes(&self) -> usize {
        self.pieces.capacity() * size_of::<Piece>()
    }
}
