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
//! without changing its sign there is one crossing, so double surfaces are visible.

use super::{COINCIDENT, Crossing, Shape, rounding};
use crate::math::polynomial::{self, Touching};
use crate::math::{Aabb, Range, Ray, Vec3};
use smallvec::SmallVec;

#[derive(Clone, Debug, PartialEq)]
pub struct Algebraic {
    order: usize,
    coefficients: Vec<f64>,
}

/// A polynomial in the distance, lowest power first.
type Univariate = SmallVec<[f64; 8]>;

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
        (coefficients.len() == Self::count(order)).then_some(Self { order, coefficients })
    }

    /// Horner's rule in x, y and z for anything that can be multiplied by a coordinate and added to.
    fn horner<T>(
        &self,
        zero: impl Fn() -> T,
        mut times: impl FnMut(&mut T, usize),
        add: impl Fn(&mut T, T),
        constant: impl Fn(&mut T, f64),
    ) -> T {
        let mut next = self.coefficients.iter();
        let mut in_x = zero();
        for i in (0..=self.order).rev() {
            let mut in_y = zero();
            for j in (0..=self.order - i).rev() {
                let mut in_z = zero();
                for _ in 0..=self.order - i - j {
                    times(&mut in_z, 2);
                    constant(&mut in_z, *next.next().unwrap_or(&0.0));
                }
                times(&mut in_y, 1);
                add(&mut in_y, in_z);
            }
            times(&mut in_x, 0);
            add(&mut in_x, in_y);
        }
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
                *g += h;
            },
            |(v, _), c| *v += c,
        )
    }

    /// The polynomial along `p + t * d`.
    fn along(&self, p: Vec3, d: Vec3) -> Univariate {
        self.horner(
            Univariate::new,
            |v, axis| {
                if v.is_empty() {
                    return;
                }
                v.push(0.0);
                for k in (1..v.len()).rev() {
                    v[k] = v[k] * p[axis] + v[k - 1] * d[axis];
                }
                v[0] *= p[axis];
            },
            |v, w| {
                if v.len() < w.len() {
                    v.resize(w.len(), 0.0);
                }
                v.iter_mut().zip(w).for_each(|(a, b)| *a += b);
            },
            |v, c| match v.first_mut() {
                Some(first) => *first += c,
                None if c != 0.0 => v.push(c),
                None => {}
            },
        )
    }

    /// The ray's point closest to the origin, and the polynomial from there.
    fn expanded(&self, ray: &Ray) -> (f64, Univariate) {
        let shift = -ray.origin.dot(ray.dir);
        (shift, self.along(ray.at(shift), ray.dir))
    }
}

impl Shape for Algebraic {
    fn bounds(&self) -> Aabb {
        Aabb::INFINITE
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        let (shift, c) = self.expanded(ray);
        let range = Range::new(range.min - shift, range.max - shift);
        out.extend(
            polynomial::roots(&c, range, Touching::Once).into_iter().map(|s| Crossing::new(s + shift)),
        );
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let (shift, c) = self.expanded(ray);
        let range = Range::new(range.min - shift, range.max - shift);
        polynomial::roots(&c, range, Touching::Once).first().map(|&s| Crossing::new(s + shift))
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
        self.coefficients.len() * size_of::<f64>()
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
