//! Superellipsoid: `(|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n) = 1`.
//!
//! | parameter | meaning |
//! |---|---|
//! | east_west, north_south | e and n, positive; 1 is round, near 0 square, above 2 star-like |
//!
//! Evaluated as `g(g(|x|, |y|; 2/e), |z|; 2/n) - 1` with `g(a, b; k) = (a^k + b^k)^(1/k)`, which grows like
//! the distance from the origin: its gradient along p is g itself.
//!
//! Where both exponents are at most 2 the function bends upwards along every line, and Newton's method from outside
//! goes to the crossing without ever passing it; it meets a slope that does not fall where there is none.
//!
//! Numerical care: else the ray's stretch inside the cube is cut at the nine planes x=0, y=0, z=0, x=±y, x=±z,
//! y=±z, between which the function bends one way only unless just one of the exponents is above 2; then
//! the stretches are cut further. A sign change is refined to the last bits; where
//! both ends have one sign, the stationary point between them, if there is one, decides.

use super::span::slab;
use super::{COINCIDENT, Crossing, Shape, rounding};
use crate::math::{Aabb, EPSILON, Range, Ray, Vec3};
use smallvec::SmallVec;

#[derive(Clone, Debug, PartialEq)]
pub struct Superellipsoid {
    /// 2/e and 2/n.
    flat: f64,
    tall: f64,
}

/// The cube is searched a little beyond its sides, so that faces that lie in them are crossed.
const MARGIN: f64 = 1e-6;
/// Into how many parts a stretch is cut on which the function may bend both ways.
const MIXED_PIECES: u32 = 8;
/// Tangents after which a crossing is sought by halving: a line that all but touches.
const MAX_TANGENTS: usize = 24;
/// Powers with whole exponents up to this one are multiplied.
const WHOLE: f64 = 64.0;
/// Halvings and secant steps until a bracket is down to rounding.
const MAX_STEPS: usize = 100;

/// What Newton's method finds on its way.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Tangents {
    Crossing(f64),
    Miss,
    /// It starts inside.
    Inside,
    Unclear,
}

/// `(a^k + b^k)^(1/k)` and its derivatives by a and b, for numbers that are not negative.
fn norm(a: f64, b: f64, k: f64) -> (f64, f64, f64) {
    let (large, small) = (a.max(b), a.min(b));
    if large == 0.0 {
        return (0.0, 0.0, 0.0);
    }
    let ratio = small / large;
    let power = powered(ratio, k);
    let sum = 1.0 + power;
    let g = large * sum.powf(1.0 / k);
    // d/d large and d/d small of g; g/large is the k-th root of the sum.
    let by_large = g / large / sum;
    let by_small = by_ratio(by_large, (ratio, power), k);
    if a >= b { (g, by_large, by_small) } else { (g, by_small, by_large) }
}

/// `(x^k + y^k + z^k)^(1/k)` and its gradient, for numbers that are not negative: one root instead of two.
fn even_norm(a: Vec3, k: f64) -> (f64, Vec3) {
    let large = a.max_element();
    if large == 0.0 {
        return (0.0, Vec3::ZERO);
    }
    let ratio = a / large;
    let power = ratio.map(|r| powered(r, k));
    let sum = power.element_sum();
    let g = large * sum.powf(1.0 / k);
    let by_large = g / large / sum;
    (g, Vec3::from_array([0, 1, 2].map(|i| by_ratio(by_large, (ratio[i], power[i]), k))))
}

/// `ratio^k`, by multiplying for whole exponents that are not large: what is asked for with roundings of no more
/// than `k` units in a term that is at most 1 moves the `k`-th root of the sum by about one.
#[inline]
fn powered(ratio: f64, k: f64) -> f64 {
    if k <= WHOLE && k.fract() == 0.0 { ratio.powi(k as i32) } else { ratio.powf(k) }
}

/// The derivative by a term whose ratio to the largest has this `k`-th power, from that by the largest.
#[inline]
fn by_ratio(by_large: f64, (ratio, power): (f64, f64), k: f64) -> f64 {
    let by = if ratio > 0.0 { by_large * power / ratio } else { by_large * ratio.powf(k - 1.0) };
    if by.is_finite() { by } else { f64::MAX.sqrt() }
}

impl Superellipsoid {
    /// `None` unless both exponents are positive numbers.
    pub fn new(east_west: f64, north_south: f64) -> Option<Self> {
        let (flat, tall) = (2.0 / east_west, 2.0 / north_south);
        let fits = |v: f64, k: f64| v > 0.0 && v.is_finite() && k.is_finite();
        (fits(east_west, flat) && fits(north_south, tall)).then_some(Self { flat, tall })
    }

    fn value(&self, p: Vec3) -> f64 {
        let a = p.abs();
        if self.flat == self.tall {
            return even_norm(a, self.flat).0 - 1.0;
        }
        norm(norm(a.x, a.y, self.flat).0, a.z, self.tall).0 - 1.0
    }

    fn gradient(&self, p: Vec3) -> Vec3 {
        self.value_and_gradient(p).1
    }

    #[inline(always)]
    fn value_and_gradient(&self, p: Vec3) -> (f64, Vec3) {
        let a = p.abs();
        if self.flat == self.tall {
            let (g, by) = even_norm(a, self.flat);
            return (g - 1.0, by * p.signum());
        }
        let (rim, by_x, by_y) = norm(a.x, a.y, self.flat);
        let (g, by_rim, by_z) = norm(rim, a.z, self.tall);
        (g - 1.0, Vec3::new(by_rim * by_x, by_rim * by_y, by_z) * p.signum())
    }

    fn visit(&self, ray: &Ray, range: Range, mut found: impl FnMut(f64) -> bool) {
        let Some((enter, leave)) = stretch(ray) else { return };
        let (enter, leave) = (enter.max(range.min), leave.min(range.max));
        if enter.is_nan() || enter >= leave {
            return;
        }
        if self.flat >= 1.0 && self.tall >= 1.0 {
            let mut done = 0;
            match self.by_tangents(ray, enter, leave) {
                Tangents::Miss => return,
                Tangents::Crossing(t) if range.contains(t) && !found(t) => return,
                Tangents::Crossing(_) => done = 1,
                Tangents::Inside | Tangents::Unclear => {}
            }
            match self.by_tangents(ray, leave, enter) {
                Tangents::Crossing(t) if done == 1 || self.value(ray.at(enter)) < 0.0 => {
                    let _ = range.contains(t) && found(t);
                }
                Tangents::Inside if done == 1 => {}
                _ => self.visit_convex(ray, (enter, leave), |t| {
                    done -= 1;
                    done >= 0 || !range.contains(t) || found(t)
                }),
            }
            return;
        }
        let mut left = (enter, self.value(ray.at(enter)));
        // With one exponent round and one star-like the function may bend both ways between two planes.
        let mixed = (self.flat < 1.0) != (self.tall < 1.0);
        let pieces = if mixed { MIXED_PIECES } else { 1 };
        for t in cuts(ray, enter, leave) {
            let (from, step) = (left.0, (t - left.0) / f64::from(pieces));
            for i in 1..=pieces {
                let stop = if i == pieces { t } else { from + f64::from(i) * step };
                let right = (stop, self.value(ray.at(stop)));
                if !self.between(ray, left, right, |t| !range.contains(t) || found(t)) {
                    return;
                }
                left = right;
            }
        }
    }

    /// Newton's method from `from`, on the way to `to`, for a function that bends upwards only: it stays above its
    /// tangents, so steps never pass the crossing.
    fn by_tangents(&self, ray: &Ray, from: f64, to: f64) -> Tangents {
        let side = (to - from).signum();
        let mut t = from;
        for step in 0..MAX_TANGENTS {
            let (f, gradient) = self.value_and_gradient(ray.at(t));
            let slope = side * gradient.dot(ray.dir);
            if f < 0.0 {
                return if step == 0 { Tangents::Inside } else { Tangents::Crossing(t) };
            }
            if slope >= 0.0 {
                return Tangents::Miss;
            }
            let next = t - side * f / slope;
            if !((next - to) * side < 0.0) {
                return if next.is_nan() { Tangents::Unclear } else { Tangents::Miss };
            }
            if (next - t).abs() <= 2.0 * EPSILON * (1.0 + t.abs()) {
                return Tangents::Crossing(next);
            }
            t = next;
        }
        Tangents::Unclear
    }

    /// Where both exponents make norms the function bends one way only: there is one minimum along a line, and
    /// it lies beside the smallest of the values between the pieces.
    fn visit_convex(&self, ray: &Ray, (enter, leave): (f64, f64), mut found: impl FnMut(f64) -> bool) {
        let mut ends: SmallVec<[(f64, f64); 11]> = SmallVec::new();
        ends.push((enter, self.value(ray.at(enter))));
        let mut crossed = false;
        for t in cuts(ray, enter, leave) {
            let (left, right) = (ends[ends.len() - 1], (t, self.value(ray.at(t))));
            if (left.1 < 0.0) != (right.1 < 0.0) {
                crossed = true;
                if !found(self.root(ray, left, right)) || right.1 >= 0.0 {
                    return;
                }
            }
            ends.push(right);
        }
        if crossed || ends[0].1 < 0.0 {
            return;
        }
        let least = (0..ends.len()).min_by(|&a, &b| ends[a].1.total_cmp(&ends[b].1)).unwrap_or(0);
        for i in [least.wrapping_sub(1), least] {
            if i < ends.len() - 1
                && let Some(turn) = self.turn(ray, ends[i], ends[i + 1])
                && turn.1 < 0.0
            {
                let _ = found(self.root(ray, ends[i], turn)) && found(self.root(ray, turn, ends[i + 1]));
                return;
            }
        }
    }

    /// Crossings between two distances; false once `found` wants no more.
    fn between(
        &self,
        ray: &Ray,
        left: (f64, f64),
        right: (f64, f64),
        mut found: impl FnMut(f64) -> bool,
    ) -> bool {
        if (left.1 < 0.0) != (right.1 < 0.0) {
            return found(self.root(ray, left, right));
        }
        let Some(turn) = self.turn(ray, left, right) else { return true };
        if (turn.1 < 0.0) == (left.1 < 0.0) {
            return true;
        }
        found(self.root(ray, left, turn)) && found(self.root(ray, turn, right))
    }

    /// Where the function comes closest to zero between two ends of the same sign, or the first place met
    /// on the way there where the sign is the other.
    fn turn(&self, ray: &Ray, left: (f64, f64), right: (f64, f64)) -> Option<(f64, f64)> {
        let outside = left.1 >= 0.0;
        let convex = self.flat >= 1.0 && self.tall >= 1.0;
        // Towards zero from both ends: falling then rising outside, rising then falling inside.
        let slope = |t: f64| {
            let d = self.gradient(ray.at(t)).dot(ray.dir);
            if outside { d } else { -d }
        };
        // At the ends, which lie on planes of symmetry, the slope may be that of the other side.
        let inset = 1e-9 * (right.0 - left.0);
        let (mut a, mut b) = (left.0 + inset, right.0 - inset);
        if slope(a) >= 0.0 || slope(b) <= 0.0 {
            return None;
        }
        for _ in 0..MAX_STEPS {
            let t = 0.5 * (a + b);
            let f = self.value(ray.at(t));
            if (f >= 0.0) != outside {
                return Some((t, f));
            }
            if b - a <= 1e-9 * (1.0 + t.abs()) {
                return None;
            }
            let rise = slope(t);
            // Where the function bends upwards it stays above its tangents.
            if outside && convex && f - rise.abs() * (b - a) > 0.0 {
                return None;
            }
            if rise < 0.0 { a = t } else { b = t }
        }
        None
    }

    /// The root between ends of different sign: regula falsi with halved weights, bisection now and then.
    fn root(&self, ray: &Ray, left: (f64, f64), right: (f64, f64)) -> f64 {
        let ((mut a, mut fa), (mut b, mut fb)) = (left, right);
        let inside_left = fa < 0.0;
        let mut last = 0;
        for step in 0..MAX_STEPS {
            let width = b - a;
            if width <= 2.0 * EPSILON * (a.abs() + b.abs()) {
                break;
            }
            let guess = a + width * (fa / (fa - fb));
            let t = if step % 8 == 7 || guess <= a || guess >= b { 0.5 * (a + b) } else { guess };
            if t <= a || t >= b {
                break;
            }
            let f = self.value(ray.at(t));
            if f == 0.0 {
                return t;
            }
            if (f < 0.0) == inside_left {
                (a, fa) = (t, f);
                if last == 1 {
                    fb *= 0.5;
                }
                last = 1;
            } else {
                (b, fb) = (t, f);
                if last == 2 {
                    fa *= 0.5;
                }
                last = 2;
            }
        }
        0.5 * (a + b)
    }
}

/// Where the line is inside the slightly enlarged cube.
fn stretch(ray: &Ray) -> Option<(f64, f64)> {
    let side = 1.0 + MARGIN;
    let mut span = (f64::NEG_INFINITY, f64::INFINITY);
    for axis in 0..3 {
        let (near, far) = slab(ray.origin[axis], ray.dir[axis], -side, side)?;
        span = (span.0.max(near), span.1.min(far));
    }
    (span.0 < span.1).then_some(span)
}

/// Distances between `enter` and `leave` where the ray passes one of the nine planes, then `leave`.
fn cuts(ray: &Ray, enter: f64, leave: f64) -> SmallVec<[f64; 10]> {
    let (o, d) = (ray.origin, ray.dir);
    let planes = [
        (o.x, d.x),
        (o.y, d.y),
        (o.z, d.z),
        (o.x - o.y, d.x - d.y),
        (o.x + o.y, d.x + d.y),
        (o.x - o.z, d.x - d.z),
        (o.x + o.z, d.x + d.z),
        (o.y - o.z, d.y - d.z),
        (o.y + o.z, d.y + d.z),
    ];
    let mut cuts: SmallVec<[f64; 10]> =
        planes.into_iter().map(|(at, speed)| -at / speed).filter(|&t| t > enter && t < leave).collect();
    cuts.sort_unstable_by(f64::total_cmp);
    cuts.push(leave);
    cuts
}

impl Shape for Superellipsoid {
    fn bounds(&self) -> Aabb {
        Aabb::new(Vec3::NEG_ONE, Vec3::ONE).grown(16.0 * EPSILON)
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        self.visit(ray, range, |t| {
            out.push(Crossing::new(t));
            true
        });
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let mut first = None;
        self.visit(ray, range, |t| {
            first = Some(Crossing::new(t));
            false
        });
        first
    }

    fn contains(&self, p: Vec3) -> bool {
        self.value(p) < COINCIDENT
    }

    fn normal(&self, p: Vec3, _crossing: &Crossing) -> Vec3 {
        self.gradient(p).normalize_or(p.normalize_or(Vec3::Z))
    }

    fn locate(&self, ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        // The function is 1 higher than 0 at distance 2 from the center: scaling moves onto the surface.
        let p = ray.at(crossing.t);
        let g = self.value(p) + 1.0;
        let on = if (g - 1.0).abs() < 1e-6 { p / g } else { p };
        (on, rounding(8.0))
    }

    fn kind(&self) -> &'static str {
        "superellipsoid"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn with_exponents_1_it_is_a_sphere() {
        let s = Superellipsoid::new(1.0, 1.0).unwrap();
        let ball = super::super::Sphere::new(Vec3::ZERO, 1.0);
        for i in 0..500 {
            let (a, b) = (f64::from(i) * 0.37, f64::from(i) * 0.011);
            let origin = 3.0 * Vec3::new(a.cos() * b.cos(), b.sin(), a.sin() * b.cos());
            let target = Vec3::new((a * 1.3).sin(), (b * 7.1).cos(), (a + b).sin()) * 0.7;
            let ray = Ray::new(origin, (target - origin).normalize());
            let t = |s: &dyn Shape| s.nearest(&ray, Range::FORWARD).map(|c| c.t);
            match (t(&s), t(&ball)) {
                (Some(a), Some(b)) => assert!((a - b).abs() < 1e-11, "{a} {b}"),
                (a, b) => assert_eq!(a, b),
            }
        }
    }

    #[test]
    fn a_nearly_square_one_is_met_at_its_faces() {
        let s = Superellipsoid::new(0.01, 0.01).unwrap();
        let ray = Ray::new(Vec3::new(0.3, 0.2, -3.0), Vec3::Z);
        let c = s.nearest(&ray, Range::FORWARD).unwrap();
        assert!((c.t - 2.0).abs() < 1e-12);
        assert!(s.normal(ray.at(c.t), &c).distance(Vec3::NEG_Z) < 1e-12);
    }

    #[test]
    fn powers_by_multiplying_are_the_library_s() {
        for k in [1.0, 2.0, 3.0, 20.0, 40.0, 63.0, 64.0, 65.0, 2.5, 0.1] {
            for ratio in [0.0, 1e-9, 0.3, 0.7, 0.999, 1.0] {
                let expected = f64::powf(ratio, k);
                assert!(
                    (powered(ratio, k) - expected).abs() <= (k + 2.0) * f64::EPSILON * expected,
                    "{ratio} {k}"
                );
            }
        }
    }

    /// With equal exponents one root does what two do one inside the other.
    #[test]
    fn equal_exponents_need_one_root() {
        let places = [0.0, 1e-300, 1e-9, 0.2, 0.7, 0.99, 1.0, 1.3, 1e3];
        for k in [0.2, 0.5, 1.0, 1.7, 2.0, 3.0, 20.0, 40.0, 64.0, 200.0] {
            for (x, y, z) in triples(&places) {
                let (g, by) = even_norm(Vec3::new(x, y, z), k);
                let (rim, by_x, by_y) = norm(x, y, k);
                let (h, by_rim, by_z) = norm(rim, z, k);
                let close = |a: f64, b: f64| (a - b).abs() <= 1e-14 * (1.0 + 1.0 / k) * (a.abs() + b.abs());
                assert!(close(g, h), "{x} {y} {z} {k}: {g} {h}");
                for (a, b) in by.to_array().into_iter().zip([by_rim * by_x, by_rim * by_y, by_z]) {
                    // On the planes between octants the slopes depend on the way there, and powers of tiny ratios
                    // leave the range of numbers.
                    let told = x.min(y).min(z) > 0.0 && a > 1e-250 && a < 1e150 && b < 1e150;
                    assert!(
                        !told || (a - b).abs() <= 1e-12 * (a.abs() + b.abs()),
                        "{x} {y} {z} {k}: {a} {b}"
                    );
                }
            }
        }
    }

    fn triples(places: &[f64]) -> impl Iterator<Item = (f64, f64, f64)> {
        let all = move |x: f64| places.iter().flat_map(move |&y| places.iter().map(move |&z| (x, y, z)));
        places.iter().flat_map(move |&x| all(x))
    }

    #[test]
    fn exponents_must_be_positive() {
        assert!(Superellipsoid::new(0.0, 1.0).is_none() && Superellipsoid::new(1.0, -0.5).is_none());
    }
}
