//! Algebraic surface: a polynomial in x, y, z equals 0 (`cubic`, `quartic`, `poly`, `polynomial`).
//!
//! | parameter | meaning |
//! |---|---|
//! | `order` | the highest sum of exponents, 2 to 35 |
//! | `coefficients` | by falling powers of x, then of y, then of z |
//!
//! The inside is where the polynomial is negative; the surface belongs to it.
//!
//! Numerical care: along a ray the polynomial in the distance is expanded, by Horner's rule in x, y and z,
//! around the ray's point closest to the origin of the object's space, so a distant camera costs no digits.
//! Roots are told by sign changes and bracketed (see `math::polynomial`); where the polynomial touches zero
//! without changing its sign there is one crossing, so double surfaces are visible. Surfaces that are proven to
//! be bounded have a box ([`extent`]).

mod extent;

use super::span::within;
use super::{COINCIDENT, Crossing, Shape, rounding};
use crate::math::polynomial::{self, Touching};
use crate::math::{Aabb, Range, Ray, Vec3};

#[derive(Clone, Debug, PartialEq)]
pub struct Algebraic {
    order: usize,
    /// The powers of x, then those of y, that the polynomial has, falling.
    planes: Vec<Plane>,
    lines: Vec<Line>,
    /// By falling powers of z, each line from its own highest one.
    coefficients: Vec<f64>,
    /// Around the surface.
    bounds: Aabb,
    /// Around the inside.
    inside: Aabb,
}

/// What is multiplied by one power of x.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Plane {
    power: usize,
    /// From, to.
    lines: (usize, usize),
}

/// What is multiplied by one power of x and one of y.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Line {
    power: usize,
    /// From, to in the coefficients.
    terms: (usize, usize),
}

/// A polynomial in the distance, lowest power first.
struct Univariate<const N: usize> {
    terms: [f64; N],
    /// How many of them are in use.
    count: usize,
}

impl Algebraic {
    pub const MAX_ORDER: usize = 35;

    /// How many coefficients a polynomial of this order has.
    pub fn count(order: usize) -> usize {
        (order + 1) * (order + 2) * (order + 3) / 6
    }

    /// Where the coefficient of x^i y^j z^k stands.
    pub fn position(order: usize, i: usize, j: usize, k: usize) -> usize {
        // All terms with a higher power of x, then those with this one and a higher power of y.
        let (rest, last) = (order - i, order - i - j);
        let before_x = if i == order { 0 } else { Self::count(order - i - 1) };
        let before_y: usize = (j + 1..=rest).map(|power| rest - power + 1).sum();
        before_x + before_y + (last - k)
    }

    /// `None` unless there are as many coefficients as the order asks for.
    pub fn new(order: usize, coefficients: Vec<f64>) -> Option<Self> {
        if coefficients.len() != Self::count(order) {
            return None;
        }
        let (bounds, inside) = (Aabb::INFINITE, Aabb::INFINITE);
        let mut out =
            Self { order, planes: Vec::new(), lines: Vec::new(), coefficients: Vec::new(), bounds, inside };
        let mut rest = &coefficients[..];
        for i in (0..=order).rev() {
            let first = out.lines.len();
            for j in (0..=order - i).rev() {
                let (line, others) = rest.split_at(order - i - j + 1);
                rest = others;
                if let Some(top) = line.iter().position(|&c| c != 0.0) {
                    let from = out.coefficients.len();
                    out.coefficients.extend(&line[top..]);
                    out.lines.push(Line { power: j, terms: (from, out.coefficients.len()) });
                }
            }
            if first < out.lines.len() {
                out.planes.push(Plane { power: i, lines: (first, out.lines.len()) });
            }
        }
        if let Some((bounds, negative_outside)) = out.extent() {
            out.bounds = bounds;
            if !negative_outside {
                out.inside = bounds;
            }
        }
        Some(out)
    }

    /// Horner's rule in x, y and z for anything that can be multiplied by a coordinate and added to. Powers
    /// that the polynomial does not have are skipped.
    #[inline(always)]
    fn horner<T>(
        &self,
        zero: impl Fn() -> T,
        mut times: impl FnMut(&mut T, usize),
        add: impl Fn(&mut T, &T),
        constant: impl Fn(&mut T, f64),
    ) -> T {
        let mut in_x = zero();
        let mut x = self.order;
        for plane in &self.planes {
            (plane.power..x).for_each(|_| times(&mut in_x, 0));
            x = plane.power;
            let mut in_y = zero();
            let mut y = self.order;
            for line in &self.lines[plane.lines.0..plane.lines.1] {
                (line.power..y).for_each(|_| times(&mut in_y, 1));
                y = line.power;
                let mut in_z = zero();
                for (i, &c) in self.coefficients[line.terms.0..line.terms.1].iter().enumerate() {
                    if i > 0 {
                        times(&mut in_z, 2);
                    }
                    constant(&mut in_z, c);
                }
                add(&mut in_y, &in_z);
            }
            (0..y).for_each(|_| times(&mut in_y, 1));
            add(&mut in_x, &in_y);
        }
        (0..x).for_each(|_| times(&mut in_x, 0));
        in_x
    }

    fn value(&self, p: Vec3) -> f64 {
        self.horner(|| 0.0, |v, axis| *v *= p[axis], |v, w| *v += w, |v, c| *v += c)
    }

    /// Sum of the terms' sizes at `p`.
    fn magnitude(&self, p: Vec3) -> f64 {
        let p = p.abs();
        self.horner(|| 0.0, |v, axis| *v *= p[axis], |v, w| *v += w, |v: &mut f64, c| *v += c.abs())
    }

    /// Value and gradient.
    fn gradient(&self, p: Vec3) -> (f64, Vec3) {
        self.horner(
            || (0.0, Vec3::ZERO),
            |(v, g), axis| {
                *g *= p[axis];
                g[axis] += *v;
                *v *= p[axis];
            },
            |(v, g), (w, h)| {
                *v += w;
                *g += *h;
            },
            |(v, _), c| *v += c,
        )
    }

    /// The polynomial along `p + t * d`.
    fn along<const N: usize>(&self, p: Vec3, d: Vec3) -> Univariate<N> {
        self.horner(
            || Univariate { terms: [0.0; N], count: 0 },
            |v, axis| v.times(p[axis], d[axis]),
            |v, w| {
                v.count = v.count.max(w.count);
                for k in 0..if N <= 5 { N } else { w.count } {
                    v.terms[k] += w.terms[k];
                }
            },
            |v, c| {
                v.terms[0] += c;
                v.count = v.count.max(1);
            },
        )
    }

    /// Calls `solve` with the ray's point closest to the origin, the polynomial from there, and the part of the
    /// range in which there may be roots; `None` if there is none.
    fn with_expanded<R>(
        &self,
        ray: &Ray,
        range: Range,
        solve: impl Fn(f64, &[f64], Range) -> R,
    ) -> Option<R> {
        let range = self.within(ray, range)?;
        let shift = -ray.origin.dot(ray.dir);
        let p = ray.at(shift);
        let range = Range::new(range.min - shift, range.max - shift);
        Some(match self.order {
            0..=3 => solve(shift, self.along::<4>(p, ray.dir).slice(), range),
            4 => solve(shift, self.along::<5>(p, ray.dir).slice(), range),
            5..=8 => solve(shift, self.along::<9>(p, ray.dir).slice(), range),
            _ => solve(shift, self.along::<{ Self::MAX_ORDER + 1 }>(p, ray.dir).slice(), range),
        })
    }

    /// The part of a range in which the ray is inside the bounds.
    fn within(&self, ray: &Ray, range: Range) -> Option<Range> {
        if !self.bounds.is_finite() {
            return Some(range);
        }
        within(ray, range, &self.bounds)
    }
}

impl<const N: usize> Univariate<N> {
    /// Times `a + b t`.
    #[inline(always)]
    fn times(&mut self, a: f64, b: f64) {
        // Short ones are multiplied as a whole, without a look at their length.
        let n = if N <= 5 { N - 1 } else { self.count.min(N - 1) };
        for k in (1..=n).rev() {
            self.terms[k] = self.terms[k] * a + self.terms[k - 1] * b;
        }
        self.terms[0] *= a;
        self.count = n + 1;
    }

    fn slice(&self) -> &[f64] {
        &self.terms[..self.count]
    }
}

impl Shape for Algebraic {
    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn inside_bounds(&self) -> Aabb {
        self.inside
    }

    fn has_extent(&self) -> bool {
        false
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        let found = self.with_expanded(ray, range, |shift, c, range| {
            (shift, polynomial::roots(c, range, Touching::Once))
        });
        if let Some((shift, found)) = found {
            out.extend(found.into_iter().map(|s| Crossing::new(s + shift)));
        }
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        self.with_expanded(ray, range, |shift, c, range| {
            polynomial::first_root(c, range, Touching::Once).map(|s| Crossing::new(s + shift))
        })?
    }

    fn contains(&self, p: Vec3) -> bool {
        self.value(p) <= COINCIDENT * self.magnitude(p)
    }

    fn normal(&self, p: Vec3, _crossing: &Crossing) -> Vec3 {
        self.gradient(p).1.normalize_or(Vec3::Y)
    }

    fn locate(&self, ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        let p = ray.at(crossing.t);
        let (value, slope) = self.gradient(p);
        let squared = slope.length_squared();
        let step = value / squared * slope;
        let size = rounding(p.abs().max_element());
        if !step.is_finite() {
            return (p, size);
        }
        let p = p - step;
        (p, size + rounding(self.magnitude(p) / squared.sqrt()))
    }

    fn kind(&self) -> &'static str {
        "poly"
    }

    fn heap_bytes(&self) -> usize {
        size_of_val(&self.coefficients[..]) + size_of_val(&self.lines[..]) + size_of_val(&self.planes[..])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::{Sphere, Torus};

    fn with_terms(order: usize, terms: &[(usize, usize, usize, f64)]) -> Algebraic {
        let mut c = vec![0.0; Algebraic::count(order)];
        for &(i, j, k, v) in terms {
            c[Algebraic::position(order, i, j, k)] += v;
        }
        Algebraic::new(order, c).unwrap()
    }

    #[test]
    fn coefficients_stand_by_falling_powers() {
        let mut position = 0;
        for i in (0..=4usize).rev() {
            for j in (0..=4 - i).rev() {
                for k in (0..=4 - i - j).rev() {
                    assert_eq!(Algebraic::position(4, i, j, k), position, "{i} {j} {k}");
                    position += 1;
                }
            }
        }
        assert_eq!(position, Algebraic::count(4));
    }

    /// (x² + y² + z² + R² - r²)² = 4 R² (x² + z²)
    fn torus(major: f64, minor: f64) -> Algebraic {
        let k = major * major - minor * minor;
        let m = 4.0 * major * major;
        with_terms(
            4,
            &[
                (4, 0, 0, 1.0),
                (0, 4, 0, 1.0),
                (0, 0, 4, 1.0),
                (2, 2, 0, 2.0),
                (2, 0, 2, 2.0),
                (0, 2, 2, 2.0),
                (2, 0, 0, 2.0 * k - m),
                (0, 2, 0, 2.0 * k),
                (0, 0, 2, 2.0 * k - m),
                (0, 0, 0, k * k),
            ],
        )
    }

    #[test]
    fn a_quartic_torus_is_the_torus() {
        let (quartic, torus) = (torus(1.4, 0.45), Torus::new(1.4, 0.45));
        let mut hits = 0;
        for i in 0..400 {
            let a = f64::from(i) * 0.61;
            let origin = Vec3::new(4.0 * a.cos(), 2.0 * (1.7 * a).sin(), 4.0 * a.sin());
            let target = Vec3::new(1.5 * (2.3 * a).sin(), 0.3 * a.cos(), 1.5 * (1.1 * a).cos());
            let ray = Ray::new(origin, (target - origin).normalize());
            match (quartic.nearest(&ray, Range::FORWARD), torus.nearest(&ray, Range::FORWARD)) {
                (Some(x), Some(y)) => {
                    hits += 1;
                    assert!((x.t - y.t).abs() < 1e-9, "{} {}", x.t, y.t);
                    let (n, m) = (quartic.normal(ray.at(x.t), &x), torus.normal(ray.at(y.t), &y));
                    assert!(n.distance(m) < 1e-7);
                }
                (x, y) => assert_eq!(x.is_some(), y.is_some(), "ray {i}"),
            }
        }
        assert!(hits > 100);
    }

    #[test]
    fn boxes_hold_the_whole_surface_and_are_not_much_larger() {
        let heart = with_terms(
            6,
            &[(6, 0, 0, 1.0), (0, 6, 0, 2.0), (0, 0, 6, 1.5), (1, 1, 0, -0.5), (0, 0, 0, -0.2)],
        );
        for bounded in [torus(1.4, 0.45), heart] {
            let free = Algebraic { bounds: Aabb::INFINITE, inside: Aabb::INFINITE, ..bounded.clone() };
            let mut random = crate::shape::conformance::Random::new(5);
            let mut seen = Aabb::EMPTY;
            for _ in 0..20_000 {
                let ray = Ray::new(3.0 * random.direction(), random.direction());
                let mut all = Vec::new();
                free.crossings(&ray, Range::LINE, &mut all);
                seen = all.iter().fold(seen, |b, c| b.extended(ray.at(c.t)));
            }
            let bounds = bounded.bounds();
            assert!(
                bounds.min.cmple(seen.min).all() && bounds.max.cmpge(seen.max).all(),
                "{bounds:?} {seen:?}"
            );
            let excess = (bounds.size() - seen.size()).max_element();
            assert!(excess < 0.15 * seen.size().max_element(), "{bounds:?} {seen:?}");
        }
    }

    #[test]
    fn surfaces_that_go_on_for_ever_have_no_box() {
        let saddle = with_terms(4, &[(4, 0, 0, 1.0), (0, 4, 0, -1.0), (0, 0, 4, 1.0), (0, 0, 0, -1.0)]);
        let pipe = with_terms(4, &[(4, 0, 0, 1.0), (0, 4, 0, 1.0), (0, 0, 0, -1.0)]);
        let cubic = with_terms(3, &[(3, 0, 0, 1.0), (0, 2, 0, 1.0), (0, 0, 2, 1.0)]);
        for s in [saddle, pipe, cubic] {
            assert_eq!(s.bounds(), Aabb::INFINITE);
        }
        // Everything but a ball.
        let terms = [(2, 0, 0, -1.0), (0, 2, 0, -1.0), (0, 0, 2, -1.0), (0, 0, 0, 1.0)];
        let hole = with_terms(2, &terms);
        assert!(hole.bounds().is_finite() && !hole.inside_bounds().is_finite());
    }

    #[test]
    fn a_distant_origin_costs_no_digits() {
        let ball = with_terms(2, &[(2, 0, 0, 1.0), (0, 2, 0, 1.0), (0, 0, 2, 1.0), (0, 0, 0, -1.0)]);
        let sphere = Sphere::new(Vec3::ZERO, 1.0);
        let dir = Vec3::new(0.6, 0.0, 0.8);
        let ray = Ray::new(Vec3::new(0.1, 0.2, 0.3) - 1e7 * dir, dir);
        let (x, y) =
            (ball.nearest(&ray, Range::FORWARD).unwrap(), sphere.nearest(&ray, Range::FORWARD).unwrap());
        assert!((x.t - y.t).abs() < 1e-8);
    }

    #[test]
    fn the_gradient_is_that_of_the_value() {
        let s = torus(1.2, 0.7);
        let p = Vec3::new(0.3, -0.8, 1.1);
        let (v, g) = s.gradient(p);
        assert!((v - s.value(p)).abs() < 1e-12);
        for axis in 0..3 {
            let mut step = Vec3::ZERO;
            step[axis] = 1e-6;
            let slope = (s.value(p + step) - s.value(p - step)) / 2e-6;
            assert!((g[axis] - slope).abs() < 1e-6);
        }
    }
}
