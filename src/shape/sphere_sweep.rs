//! Sphere sweep: the union of all spheres that a moving, growing sphere passes through.
//!
//! | parameter | unit | meaning |
//! |---|---|---|
//! | spheres | length | centers and radii, control points of the spline |
//! | kind | – | linear, cubic (Catmull-Rom through all but the first and last), or uniform b-spline |
//!
//! For each parameter w a line is inside the sphere between `b(w) - sqrt(D(w))` and `b(w) + sqrt(D(w))`, where
//! b is the distance to the point nearest to the center and D half the chord squared. Where D is not
//! negative these stretches change continuously with w, so over one such interval of w they fill one
//! stretch without a gap: from the least entry to the greatest exit. Both lie at an end of the interval or
//! where `4 b'² D = D'²`, a polynomial of degree 10. Stretches of all pieces are then merged.
//!
//! Numerical care: b and D are polynomials about the ray's point nearest to the piece; only values are
//! compared, so an imprecise root costs precision of second order.

use super::{Crossing, Shape, rounding};
use crate::math::bvh::{Bvh, Quality};
use crate::math::polynomial::{Touching, product, roots, value};
use crate::math::{Aabb, Range, Ray, Vec2, Vec3};
use smallvec::SmallVec;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SweepKind {
    Linear,
    Cubic,
    BSpline,
}

impl SweepKind {
    /// The fewest spheres.
    pub fn fewest(self) -> usize {
        if self == SweepKind::Linear { 2 } else { 4 }
    }
}

#[derive(Clone, Debug)]
pub struct SphereSweep {
    pieces: Vec<Tube>,
    /// Over the pieces, if there are many.
    tree: Option<Bvh>,
    extent: Aabb,
}

/// From this many pieces on a tree finds those that a ray or point can meet.
const TREE_FROM: usize = 8;

/// Centers and radii of one piece for parameters 0 to 1, lowest power first.
#[derive(Clone, Debug, PartialEq)]
struct Tube {
    center: [Vec3; 4],
    radius: [f64; 4],
    /// A sphere around the piece.
    middle: Vec3,
    reach: f64,
    /// Center and radius change evenly.
    straight: bool,
}

/// A stretch of the line inside, with piece and parameter of the spheres at its ends.
#[derive(Clone, Copy, Debug)]
struct Stretch {
    enter: Crossing,
    leave: Crossing,
}

type Stretches = SmallVec<[Stretch; 8]>;

impl SphereSweep {
    /// At least [`SweepKind::fewest`] spheres.
    pub fn new(kind: SweepKind, spheres: &[(Vec3, f64)]) -> Self {
        let four: Vec<[f64; 4]> = spheres.iter().map(|(c, r)| [c.x, c.y, c.z, *r]).collect();
        let pieces: Vec<Tube> = four.windows(kind.fewest()).map(|w| Tube::new(kind, w)).collect();
        let boxes: Vec<Aabb> = pieces.iter().map(Tube::bounds).collect();
        let extent = boxes.iter().copied().fold(Aabb::EMPTY, Aabb::union);
        let tree = (pieces.len() >= TREE_FROM).then(|| Bvh::build(&boxes, Quality::Best));
        Self { pieces, tree, extent }
    }

    fn stretches(&self, ray: &Ray, all: &mut Stretches) {
        let mut add = |i: usize| {
            let piece = &self.pieces[i];
            if piece.may_meet(ray) {
                piece.stretches(ray, i as u32, all);
            }
        };
        match &self.tree {
            Some(tree) => {
                // From in front of everything: stretches that the ray starts in begin behind it.
                let back = (self.extent.center() - ray.origin).dot(ray.dir) - self.extent.size().length();
                let ray = Ray::new(ray.at(back), ray.dir);
                tree.any(&ray, Range::FORWARD, |i| {
                    add(i as usize);
                    false
                });
            }
            None => (0..self.pieces.len()).for_each(add),
        }
        if all.len() > 1 {
            merge(all);
        }
    }
}

/// Sorts stretches and joins those that overlap.
fn merge(all: &mut Stretches) {
    all.sort_by(|a, b| a.enter.t.total_cmp(&b.enter.t));
    let mut last = 0;
    for i in 1..all.len() {
        let next = all[i];
        if next.enter.t <= all[last].leave.t {
            if next.leave.t > all[last].leave.t {
                all[last].leave = next.leave;
            }
        } else {
            last += 1;
            all[last] = next;
        }
    }
    all.truncate(last + 1);
}

/// Spline coefficients of four numbers at a time.
fn spline(kind: SweepKind, p: &[[f64; 4]]) -> [[f64; 4]; 4] {
    let weights: &[&[f64]] = match kind {
        SweepKind::Linear => &[&[1.0, 0.0], &[-1.0, 1.0], &[0.0, 0.0], &[0.0, 0.0]],
        SweepKind::Cubic => {
            &[&[0.0, 1.0, 0.0, 0.0], &[-0.5, 0.0, 0.5, 0.0], &[1.0, -2.5, 2.0, -0.5], &[-0.5, 1.5, -1.5, 0.5]]
        }
        SweepKind::BSpline => &[
            &[1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0, 0.0],
            &[-0.5, 0.0, 0.5, 0.0],
            &[0.5, -1.0, 0.5, 0.0],
            &[-1.0 / 6.0, 0.5, -0.5, 1.0 / 6.0],
        ],
    };
    std::array::from_fn(|power| {
        std::array::from_fn(|axis| weights[power].iter().zip(p).map(|(w, q)| w * q[axis]).sum())
    })
}

impl Tube {
    fn new(kind: SweepKind, points: &[[f64; 4]]) -> Self {
        let c = spline(kind, points);
        let mut tube = Self {
            center: c.map(|v| Vec3::new(v[0], v[1], v[2])),
            radius: c.map(|v| v[3]),
            middle: Vec3::ZERO,
            reach: 0.0,
            straight: kind == SweepKind::Linear,
        };
        let bounds = tube.bounds();
        tube.middle = bounds.center();
        tube.reach = 0.5 * bounds.size().length();
        tube
    }

    fn at(&self, w: f64) -> (Vec3, f64) {
        let [a, b, c, d] = self.center;
        (a + w * (b + w * (c + w * d)), value(&self.radius, w).abs())
    }

    /// Around all spheres: each coordinate plus and minus the radius is a cubic.
    fn bounds(&self) -> Aabb {
        let mut bounds = Aabb::EMPTY;
        let inner = Range::new(0.0, 1.0);
        for axis in 0..3 {
            for sign in [-1.0, 1.0] {
                let slope: [f64; 3] = std::array::from_fn(|i| {
                    (i + 1) as f64 * (self.center[i + 1][axis] + sign * self.radius[i + 1])
                });
                let turns = roots(&slope, inner, Touching::Skip);
                for w in turns.into_iter().chain([0.0, 1.0]) {
                    let (c, r) = self.at(w);
                    bounds.min[axis] = bounds.min[axis].min(c[axis] - r);
                    bounds.max[axis] = bounds.max[axis].max(c[axis] + r);
                }
            }
        }
        bounds
    }

    fn may_meet(&self, ray: &Ray) -> bool {
        let q = self.middle - ray.origin;
        let across = q - q.dot(ray.dir) * ray.dir;
        across.length_squared() <= self.reach * self.reach * (1.0 + 1e-9)
    }

    fn stretches(&self, ray: &Ray, part: u32, out: &mut Stretches) {
        if self.straight {
            self.stretches_of::<2, 3, 3>(ray, part, out);
        } else {
            self.stretches_of::<4, 7, 11>(ray, part, out);
        }
    }

    /// With `B` coefficients of the centers, `C` of the chord and `S` of the condition for a stationary end.
    fn stretches_of<const B: usize, const C: usize, const S: usize>(
        &self,
        ray: &Ray,
        part: u32,
        out: &mut Stretches,
    ) {
        let shift = (self.middle - ray.origin).dot(ray.dir);
        let o = ray.at(shift);
        let (b, chord) = self.along::<B, C>(o, ray.dir);
        let intervals = chord_intervals(&chord);
        if intervals.is_empty() {
            return;
        }
        let conditions = stationary::<B, C, S>(&b, &chord);
        for (from, to) in intervals {
            let crossing = |t: f64, w: f64| Crossing { t: t + shift, part, uv: Vec2::new(w, 0.0) };
            let mut enter = (f64::INFINITY, 0.0);
            let mut leave = (f64::NEG_INFINITY, 0.0);
            let mut look = |w: f64| {
                let (middle, half) = (value(&b, w), value(&chord, w).max(0.0).sqrt());
                if middle - half < enter.0 {
                    enter = (middle - half, w);
                }
                if middle + half > leave.0 {
                    leave = (middle + half, w);
                }
            };
            roots(&conditions, Range::new(from, to), Touching::Once).iter().for_each(|&w| look(w));
            look(from);
            look(to);
            polish(&b, &chord, -1.0, (from, to), &mut enter);
            polish(&b, &chord, 1.0, (from, to), &mut leave);
            if enter.0 < leave.0 {
                out.push(Stretch { enter: crossing(enter.0, enter.1), leave: crossing(leave.0, leave.1) });
            }
        }
    }

    /// Distance to the point nearest to the center, and half the chord squared, by the parameter.
    #[inline(always)]
    fn along<const B: usize, const C: usize>(&self, o: Vec3, d: Vec3) -> ([f64; B], [f64; C]) {
        let (mut b, mut chord) = ([0.0; B], [0.0; C]);
        let mut across = [Vec3::ZERO; B];
        for i in 0..B {
            let center = if i == 0 { self.center[0] - o } else { self.center[i] };
            b[i] = center.dot(d);
            across[i] = center - b[i] * d;
        }
        for i in 0..B {
            for j in 0..B {
                chord[i + j] += self.radius[i] * self.radius[j] - across[i].dot(across[j]);
            }
        }
        (b, chord)
    }

    /// The least value of |p - c|² - r², and where.
    fn depth(&self, p: Vec3) -> f64 {
        let mut q = self.center;
        q[0] -= p;
        let mut f: [f64; 7] = product(self.radius, self.radius);
        f.iter_mut().for_each(|v| *v = -*v);
        for axis in 0..3 {
            let c = q.map(|v| v[axis]);
            let square: [f64; 7] = product(c, c);
            f.iter_mut().zip(square).for_each(|(sum, s)| *sum += s);
        }
        let slope: [f64; 6] = std::array::from_fn(|i| (i + 1) as f64 * f[i + 1]);
        let turns = roots(&slope, Range::new(0.0, 1.0), Touching::Skip);
        turns.into_iter().chain([0.0, 1.0]).map(|w| value(&f, w)).fold(f64::INFINITY, f64::min)
    }
}

/// Moves the parameter of an end to where that is stationary: where the condition has a double root, the
/// root is good to half the digits only, and the normal depends on it.
#[inline(always)]
fn polish(b: &[f64], chord: &[f64], side: f64, within: (f64, f64), end: &mut (f64, f64)) {
    for _ in 0..2 {
        let w = end.1;
        let (_, b1, b2) = derivatives(b, w);
        let (d, d1, d2) = derivatives(chord, w);
        if w <= within.0 || w >= within.1 || d <= 0.0 {
            return;
        }
        let root = d.sqrt();
        let slope = b1 + side * d1 / (2.0 * root);
        let bend = b2 + side * (d2 / (2.0 * root) - d1 * d1 / (4.0 * d * root));
        let next = w - slope / bend;
        if !((next - w).abs() < 1e-4 && next > within.0 && next < within.1) {
            return;
        }
        let half = value(chord, next).max(0.0).sqrt();
        *end = (value(b, next) + side * half, next);
    }
}

/// Value, first and second derivative.
fn derivatives(c: &[f64], t: f64) -> (f64, f64, f64) {
    let (mut f, mut d, mut h) = (0.0, 0.0, 0.0);
    for i in (0..c.len()).rev() {
        (f, d, h) = (f * t + c[i], d * t + f, h * t + d);
    }
    (f, d, 2.0 * h)
}

/// `4 b'² D - D'²`, whose roots are where the entry or the exit is stationary.
#[inline(always)]
fn stationary<const B: usize, const C: usize, const S: usize>(b: &[f64; B], chord: &[f64; C]) -> [f64; S] {
    let mut c = [0.0; S];
    let mut slope2 = [0.0; S];
    for i in 1..B {
        for j in 1..B {
            slope2[i + j - 2] += (4 * i * j) as f64 * b[i] * b[j];
        }
    }
    for i in 0..2 * B - 3 {
        for j in 0..C {
            c[i + j] += slope2[i] * chord[j];
        }
    }
    for i in 1..C {
        for j in 1..C {
            c[i + j - 2] -= (i * j) as f64 * chord[i] * chord[j];
        }
    }
    c
}

/// Where the chord is real, between 0 and 1.
#[inline(always)]
fn chord_intervals(chord: &[f64]) -> SmallVec<[(f64, f64); 4]> {
    let mut intervals = SmallVec::new();
    let mut from = 0.0;
    for &to in roots(chord, Range::new(0.0, 1.0), Touching::Skip).iter().chain(&[1.0]) {
        if value(chord, 0.5 * (from + to)) > 0.0 {
            intervals.push((from, to));
        }
        from = to;
    }
    intervals
}

impl Shape for SphereSweep {
    fn bounds(&self) -> Aabb {
        self.extent
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        let mut all = Stretches::new();
        self.stretches(ray, &mut all);
        out.extend(all.iter().flat_map(|s| [s.enter, s.leave]).filter(|c| range.contains(c.t)));
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let mut all = Stretches::new();
        self.stretches(ray, &mut all);
        all.iter().flat_map(|s| [s.enter, s.leave]).find(|c| range.contains(c.t))
    }

    fn contains(&self, p: Vec3) -> bool {
        let holds = |i: usize| self.pieces[i].depth(p) <= 0.0;
        match &self.tree {
            Some(tree) => tree.any_at(p, |i| holds(i as usize)),
            None => self.extent.contains(p) && (0..self.pieces.len()).any(holds),
        }
    }

    fn normal(&self, p: Vec3, crossing: &Crossing) -> Vec3 {
        let (center, _) = self.pieces[crossing.part as usize].at(crossing.uv.x);
        (p - center).normalize_or(Vec3::Y)
    }

    fn locate(&self, ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        let (center, radius) = self.pieces[crossing.part as usize].at(crossing.uv.x);
        let out = (ray.at(crossing.t) - center).normalize_or(Vec3::Y);
        let size = self.extent.min.abs().max(self.extent.max.abs()).max_element();
        (center + radius * out, rounding(64.0 * size))
    }

    fn kind(&self) -> &'static str {
        "sphere_sweep"
    }

    fn heap_bytes(&self) -> usize {
        self.pieces.capacity() * size_of::<Tube>() + self.tree.as_ref().map_or(0, Bvh::heap_bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_normal_leans_with_the_growing_radius() {
        let sweep = SphereSweep::new(SweepKind::Linear, &[(Vec3::ZERO, 0.5), (2.0 * Vec3::X, 1.0)]);
        let ray = Ray::new(Vec3::new(0.7, 5.0, 0.0), Vec3::NEG_Y);
        let c = sweep.nearest(&ray, Range::FORWARD).unwrap();
        // On a cone around spheres whose radius grows by 1/4 per unit the normal leans back by asin(1/4).
        let n = sweep.normal(sweep.locate(&ray, &c).0, &c);
        assert!((n.x + 0.25).abs() < 1e-9, "{n}");
    }
}
