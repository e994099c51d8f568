//! Quadric: `A x² + B y² + C z² + D xy + E xz + F yz + G x + H y + I z + J = 0`.
//!
//! | parameter | meaning |
//! |---|---|
//! | `squares` | A, B, C |
//! | `products` | D, E, F: of xy, xz, yz |
//! | `linear` | G, H, I |
//! | `constant` | J |
//!
//! The inside is where the left side is negative; the surface belongs to it. `inverse` negates all
//! coefficients and keeps the normal, as the language has it.
//!
//! Numerical care: along a ray the equation is expanded at the ray's point closest to the quadric's
//! center of coordinates, so a distant origin costs no digits; the quadratic is solved without cancellation
//! and each root is refined once on the surface itself. A ray that only touches misses.

use super::{COINCIDENT, Chord, Crossing, Shape, Span, rounding};
use crate::math::{Aabb, Range, Ray, Vec3};
use glam::DMat3;
use std::sync::Arc;

#[derive(Clone, Debug, PartialEq)]
pub struct Quadric {
    squares: Vec3,
    products: Vec3,
    linear: Vec3,
    constant: f64,
    /// Whether there are any products.
    mixed: bool,
    /// 1, or -1 after `inverse`: keeps the normal as it was.
    facing: f64,
}

impl Quadric {
    pub fn new(squares: Vec3, products: Vec3, linear: Vec3, constant: f64) -> Self {
        Self { squares, products, linear, constant, mixed: products != Vec3::ZERO, facing: 1.0 }
    }

    #[inline]
    fn value(&self, p: Vec3) -> f64 {
        self.form(p) + self.linear.dot(p) + self.constant
    }

    /// The squares and products of the left side.
    #[inline]
    fn form(&self, p: Vec3) -> f64 {
        let squares = self.squares.dot(p * p);
        if !self.mixed {
            return squares;
        }
        squares + self.products.dot(Vec3::new(p.x * p.y, p.x * p.z, p.y * p.z))
    }

    /// Sum of the terms' sizes at `p`.
    fn magnitude(&self, p: Vec3) -> f64 {
        let p = p.abs();
        let mixed = Vec3::new(p.x * p.y, p.x * p.z, p.y * p.z);
        let terms = self.squares.abs().dot(p * p) + self.products.abs().dot(mixed);
        terms + self.linear.abs().dot(p) + self.constant.abs()
    }

    #[inline]
    fn gradient(&self, p: Vec3) -> Vec3 {
        if !self.mixed {
            return 2.0 * self.squares * p + self.linear;
        }
        let m = self.products;
        let mixed = Vec3::new(m.x * p.y + m.y * p.z, m.x * p.x + m.z * p.z, m.y * p.x + m.z * p.y);
        2.0 * self.squares * p + mixed + self.linear
    }

    /// The line's crossings in order, those near `range` refined; infinite where there is only one.
    #[inline]
    fn distances(&self, ray: &Ray, range: Range) -> Option<[f64; 2]> {
        let shift = -ray.origin.dot(ray.dir);
        let [first, last] = self.roots_of(self.along(ray, shift), shift)?;
        Some([self.refined(ray, first, range), self.refined(ray, last, range)])
    }

    /// Curvature, half the slope and the value at the ray's point at `shift`.
    #[inline]
    fn along(&self, ray: &Ray, shift: f64) -> [f64; 3] {
        let p = ray.at(shift);
        [self.form(ray.dir), 0.5 * self.gradient(p).dot(ray.dir), self.value(p)]
    }

    #[inline]
    fn roots_of(&self, [a, half_b, c]: [f64; 3], shift: f64) -> Option<[f64; 2]> {
        if a == 0.0 {
            return (half_b != 0.0).then(|| [shift - 0.5 * c / half_b, f64::INFINITY]);
        }
        let discriminant = half_b * half_b - a * c;
        if discriminant.is_nan() || discriminant <= 0.0 {
            return None;
        }
        let q = -(half_b + discriminant.sqrt().copysign(half_b));
        let (s0, s1) = (q / a, if q == 0.0 { 0.0 } else { c / q });
        Some([shift + s0.min(s1), shift + s0.max(s1)])
    }

    /// Root `t` refined once on the surface, if it is anywhere near `range`.
    fn refined(&self, ray: &Ray, t: f64, range: Range) -> f64 {
        // Refinement moves no root that far.
        let slack = 1e-4 * (t.abs() + ray.origin.abs().max_element());
        if !Range::new(range.min - slack, range.max + slack).contains(t) {
            return t;
        }
        let at = ray.at(t);
        let better = t - self.value(at) / self.gradient(at).dot(ray.dir);
        if better.is_finite() { better } else { t }
    }

    /// The bounds of an ellipsoid or, along the axes, of a cylinder; infinite for everything else.
    fn surface_bounds(&self) -> Aabb {
        if self.mixed { self.turned_bounds() } else { self.aligned_bounds() }
    }

    fn aligned_bounds(&self) -> Aabb {
        let used: Vec<usize> = (0..3).filter(|&i| self.squares[i] != 0.0).collect();
        let sign = used.first().map_or(0.0, |&i| self.squares[i].signum());
        let same = used.iter().all(|&i| self.squares[i] * sign > 0.0);
        let unused_are_free = (0..3).all(|i| self.squares[i] != 0.0 || self.linear[i] == 0.0);
        if used.is_empty() || !same || !unused_are_free {
            return Aabb::INFINITE;
        }
        let mut room = -self.constant * sign;
        for &i in &used {
            room += self.linear[i] * self.linear[i] / (4.0 * self.squares[i].abs());
        }
        if room < 0.0 {
            return Aabb::EMPTY;
        }
        let mut bounds = Aabb::INFINITE;
        for &i in &used {
            let center = -self.linear[i] / (2.0 * self.squares[i]);
            let half = (room / self.squares[i].abs()).sqrt();
            let margin = rounding(center.abs() + half);
            bounds.min[i] = center - half - margin;
            bounds.max[i] = center + half + margin;
        }
        bounds
    }

    /// Along an axis with a positive square, or none: where the value can be 0 or less if the other terms are
    /// least.
    fn narrowed(&self, axis: usize, region: &Aabb) -> Option<(f64, f64)> {
        let (a, b) = (self.squares[axis], 0.5 * self.linear[axis]);
        let others = (0..3).filter(|&i| i != axis);
        let least = others.fold(self.constant, |sum, i| {
            sum + least_of(self.squares[i], self.linear[i], region.min[i], region.max[i])
        });
        if a == 0.0 && b != 0.0 && least.is_finite() {
            let (end, free) = (-0.5 * least / b, f64::INFINITY.copysign(b));
            let end = end + rounding(end).copysign(b);
            return Some((end.min(-free), end.max(-free)));
        }
        let room = b * b - a * least;
        if !(a > 0.0 && room.is_finite()) {
            return None;
        }
        let (center, half) = (-b / a, room.max(0.0).sqrt() / a);
        let margin = rounding(center.abs() + half);
        Some((center - half - margin, center + half + margin))
    }

    fn turned_bounds(&self) -> Aabb {
        let (s, m) = (self.squares, 0.5 * self.products);
        let form =
            DMat3::from_cols(Vec3::new(s.x, m.x, m.y), Vec3::new(m.x, s.y, m.z), Vec3::new(m.y, m.z, s.z));
        let sign = s.x.signum();
        let form = form * sign;
        let minor = form.x_axis.x * form.y_axis.y - form.x_axis.y * form.x_axis.y;
        let size = s.abs().max_element();
        let definite = form.x_axis.x > 0.0
            && minor > 1e-9 * size * size
            && form.determinant() > 1e-9 * size * size * size;
        if !definite {
            return Aabb::INFINITE;
        }
        let inverse = form.inverse();
        let center = inverse * (-0.5 * sign * self.linear);
        let room = center.dot(form * center) - sign * self.constant;
        if room < 0.0 {
            return Aabb::EMPTY;
        }
        let diagonal = Vec3::new(inverse.x_axis.x, inverse.y_axis.y, inverse.z_axis.z);
        let half = (diagonal * room).max(Vec3::ZERO).map(f64::sqrt);
        Aabb { min: center - half, max: center + half }.grown(1e-6 * (center.abs() + half).max_element())
    }
}

/// The least value of `a x² + b x` from `low` to `high`.
fn least_of(a: f64, b: f64, low: f64, high: f64) -> f64 {
    let at = |x: f64| if x.is_finite() { (a * x + b) * x } else { least_far(a, b, x) };
    let ends = at(low).min(at(high));
    let turn = -0.5 * b / a;
    if a > 0.0 && low < turn && turn < high { ends.min(at(turn)) } else { ends }
}

/// `a x² + b x` at an infinite x.
fn least_far(a: f64, b: f64, x: f64) -> f64 {
    let leading = if a == 0.0 { b * x.signum() } else { a };
    if leading == 0.0 { 0.0 } else { leading * f64::INFINITY }
}

impl Shape for Quadric {
    fn bounds(&self) -> Aabb {
        self.surface_bounds()
    }

    fn inside_bounds(&self) -> Aabb {
        // With a negative square the far end of that axis is inside.
        if self.squares.min_element() < 0.0 { Aabb::INFINITE } else { self.surface_bounds() }
    }

    fn within(&self, region: &Aabb) -> Aabb {
        let mut left = region.intersection(self.inside_bounds());
        if !self.mixed {
            for axis in 0..3 {
                if let Some((low, high)) = self.narrowed(axis, &left) {
                    (left.min[axis], left.max[axis]) = (left.min[axis].max(low), left.max[axis].min(high));
                }
            }
        }
        left
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        let Some([a, b]) = self.distances(ray, range) else { return };
        for t in [a.min(b), a.max(b)] {
            if range.contains(t) {
                out.push(Crossing::new(t));
            }
        }
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let shift = -ray.origin.dot(ray.dir);
        let [first, last] = self.roots_of(self.along(ray, shift), shift)?;
        let first = self.refined(ray, first, range);
        if range.contains(first) {
            return Some(Crossing::new(first));
        }
        let last = self.refined(ray, last, range);
        range.contains(last).then(|| Crossing::new(last))
    }

    fn chord(&self, ray: &Ray, range: Range) -> Option<Chord> {
        let shift = -ray.origin.dot(ray.dir);
        let form @ [a, half_b, c] = self.along(ray, shift);
        let Some([first, last]) = self.roots_of(form, shift) else {
            let inside = if a == 0.0 { c <= 0.0 } else { a < 0.0 };
            return Some(if inside { Chord::INSIDE } else { Chord::OUTSIDE });
        };
        let exact = |t: f64| self.refined(ray, t, range);
        if a == 0.0 {
            let t = exact(first);
            let (enter, leave) = if half_b < 0.0 { (t, f64::INFINITY) } else { (f64::NEG_INFINITY, t) };
            return Some(Chord::within(Some(Span::new(enter, leave, 0))));
        }
        let (t0, t1) = (exact(first), exact(last));
        Some(Chord { span: Span::new(t0.min(t1), t0.max(t1), 0), beyond: a < 0.0 })
    }

    fn contains(&self, p: Vec3) -> bool {
        let value = self.value(p);
        value <= 0.0 || value <= COINCIDENT * self.magnitude(p)
    }

    fn inverse(&self) -> Option<Arc<dyn Shape>> {
        Some(Arc::new(Quadric {
            squares: -self.squares,
            products: -self.products,
            linear: -self.linear,
            constant: -self.constant,
            mixed: self.mixed,
            facing: -self.facing,
        }))
    }

    fn normal(&self, p: Vec3, _crossing: &Crossing) -> Vec3 {
        (self.facing * self.gradient(p)).normalize_or(Vec3::Y)
    }

    fn locate(&self, ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        let p = ray.at(crossing.t);
        let slope = self.gradient(p);
        let squared = slope.length_squared();
        if squared == 0.0 {
            return (p, rounding(p.abs().max_element()));
        }
        let p = p - self.value(p) / squared * slope;
        (p, rounding(p.abs().max_element() + self.magnitude(p) / squared.sqrt()))
    }

    fn kind(&self) -> &'static str {
        "quadric"
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::Sphere;

    fn ellipsoid() -> Quadric {
        // (x-1)²/4 + y² + z²/9 = 1
        Quadric::new(Vec3::new(0.25, 1.0, 1.0 / 9.0), Vec3::ZERO, Vec3::new(-0.5, 0.0, 0.0), -0.75)
    }

    #[test]
    fn a_unit_quadric_is_a_unit_sphere() {
        let q = Quadric::new(Vec3::ONE, Vec3::ZERO, Vec3::ZERO, -1.0);
        let s = Sphere::new(Vec3::ZERO, 1.0);
        for i in 0..200 {
            let a = f64::from(i) * 0.37;
            let origin = Vec3::new(3.0 * a.cos(), a.sin(), 3.0 * a.sin());
            let dir = (Vec3::new(0.3 * (2.0 * a).sin(), 0.9 * a.cos(), 0.1) - origin).normalize();
            let ray = Ray::new(origin, dir);
            let (x, y) = (q.nearest(&ray, Range::FORWARD), s.nearest(&ray, Range::FORWARD));
            match (x, y) {
                (Some(x), Some(y)) => assert!((x.t - y.t).abs() < 1e-13, "{} {}", x.t, y.t),
                (x, y) => assert_eq!(x.is_some(), y.is_some()),
            }
        }
    }

    #[test]
    fn a_distant_ray_is_as_exact_as_a_near_one() {
        let q = ellipsoid();
        let target = Vec3::new(1.3, 0.2, -0.4);
        let dir = Vec3::new(0.6, 0.0, 0.8);
        let near = q.nearest(&Ray::new(target - 5.0 * dir, dir), Range::FORWARD).unwrap();
        let far = q.nearest(&Ray::new(target - 5e6 * dir, dir), Range::FORWARD).unwrap();
        assert!((far.t - 5e6 - (near.t - 5.0)).abs() < 1e-8);
    }

    #[test]
    fn bounds_of_an_ellipsoid_are_tight_and_of_a_hyperboloid_infinite() {
        let b = ellipsoid().bounds();
        assert!(b.min.distance(Vec3::new(-1.0, -1.0, -3.0)) < 1e-9);
        assert!(b.max.distance(Vec3::new(3.0, 1.0, 3.0)) < 1e-9);
        let saddle = Quadric::new(Vec3::new(1.0, -1.0, 1.0), Vec3::ZERO, Vec3::ZERO, -1.0);
        assert_eq!(saddle.bounds(), Aabb::INFINITE);
        let turned = Quadric::new(Vec3::new(2.0, 2.0, 1.0), Vec3::new(2.0, 0.0, 0.0), Vec3::ZERO, -1.0);
        let b = turned.bounds();
        assert!(b.is_finite() && b.contains(Vec3::new(0.0, 0.0, 1.0)) && b.max.x < 0.83 && b.max.x > 0.81);
    }

    #[test]
    fn inverse_keeps_the_normal_and_exchanges_the_sides() {
        let q = Quadric::new(Vec3::ONE, Vec3::ZERO, Vec3::ZERO, -1.0);
        let inverse = q.inverse().unwrap();
        let ray = Ray::new(Vec3::new(0.0, 0.0, -3.0), Vec3::Z);
        let hit = inverse.nearest(&ray, Range::FORWARD).unwrap();
        assert_eq!(inverse.normal(ray.at(hit.t), &hit), -Vec3::Z);
        assert!(q.contains(Vec3::ZERO) && !inverse.contains(Vec3::ZERO));
        assert!(inverse.contains(Vec3::splat(5.0)) && inverse.inside_bounds() == Aabb::INFINITE);
    }

    #[test]
    fn a_plane_in_disguise_is_hit_once() {
        let q = Quadric::new(Vec3::ZERO, Vec3::ZERO, Vec3::new(0.0, 2.0, 0.0), -1.0);
        let mut all = Vec::new();
        q.crossings(&Ray::new(Vec3::ZERO, Vec3::new(0.6, 0.8, 0.0)), Range::FORWARD, &mut all);
        assert_eq!(all.len(), 1);
        assert!((all[0].t - 0.625).abs() < 1e-15);
    }

    proptest::proptest! {
        /// What is inside of a part of space stays inside of what that is narrowed to.
        #[test]
        fn a_narrowed_region_loses_nothing(
            c in proptest::array::uniform7(-3.0..3.0f64),
            at in proptest::array::uniform3(-4.0..4.0f64),
            open in 0..64u8,
        ) {
            let squares = Vec3::new(c[0], c[1], c[2]).map(|v| if v.abs() < 0.5 { 0.0 } else { v });
            let q = Quadric::new(squares, Vec3::ZERO, Vec3::new(c[3], c[4], c[5]), c[6]);
            let side = |bit: u8, v: f64| if open >> bit & 1 == 1 { v * f64::INFINITY } else { v };
            let region = Aabb {
                min: Vec3::new(side(0, -2.0), side(1, -2.0), side(2, -2.0)),
                max: Vec3::new(side(3, 3.0), side(4, 3.0), side(5, 3.0)),
            };
            let p = Vec3::from_array(at);
            if region.contains(p) && q.value(p) <= 0.0 {
                proptest::prop_assert!(q.within(&region).contains(p), "{:?}", q.within(&region));
            }
        }
    }
}
