//! Escape-time fractals in the xy plane.
//!
//! | fractal | iteration |
//! |---|---|
//! | mandel | `z ← z^e + c` from the point, c the point |
//! | julia | the same with a fixed c |
//! | magnet 1 | `z ← ((z² + c - 1) / (2z + c - 2))²` |
//! | magnet 2 | `z ← ((z³ + 3(c-1)z + (c-1)(c-2)) / (3z² + 3(c-2)z + (c-1)(c-2) + 1))²` |
//!
//! Points that escape are coloured by `exterior` (type 1: by how soon), the others by `interior` (type 0: a
//! constant). Magnets also end when they come near their fixed point 1.

use super::{Modifier, Pattern, Setting, keyed};
use crate::color::Color;
use crate::math::Vec3;
use std::sync::Arc;

#[derive(Clone, Copy, Debug)]
pub struct Fractal {
    pub kind: FractalKind,
    /// The constant of a julia set; the point itself in a mandel set.
    pub constant: Option<[f64; 2]>,
    pub iterations: u32,
    pub exterior: (u32, f64),
    pub interior: (u32, f64),
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FractalKind {
    /// The exponent, 2 ..= 33.
    Power(u32),
    Magnet(Magnet),
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Magnet {
    First,
    Second,
}

/// The iteration whose result is the first that later ones are compared with; then at every doubling.
const FIRST_RENEWAL: u32 = 16;
/// Iterations between two comparisons.
const STRETCH: u32 = 8;

impl Fractal {
    pub fn new(kind: FractalKind, constant: Option<[f64; 2]>, iterations: u32) -> Self {
        Self { kind, constant, iterations, exterior: (1, 1.0), interior: (0, 1.0) }
    }

    /// The value of a point that escaped in iteration `k`, arriving at `z`.
    fn outside(&self, k: u32, z: Complex) -> f64 {
        let (kind, factor) = self.exterior;
        let remainder = |divisor: f64| {
            let divisor = divisor as i64;
            if divisor == 0 { 0.0 } else { (i64::from(k) % divisor) as f64 / factor }
        };
        match kind {
            0 => factor,
            2 => z.re * factor,
            3 => z.im * factor,
            4 => z.re * z.re * factor,
            5 => z.im * z.im * factor,
            6 => z.square_length().sqrt() * factor,
            7 => remainder(factor),
            8 => remainder(1.0 + factor),
            _ => f64::from(k) / f64::from(self.iterations),
        }
    }

    /// The value of a point that stays, ending at `z` after coming as near to 0 as `least` squared.
    fn inside(&self, least: f64, z: Complex) -> f64 {
        let (kind, factor) = self.interior;
        match kind {
            1 => least.sqrt() * factor,
            2 => z.re * factor,
            3 => z.im * factor,
            4 => z.re * z.re * factor,
            5 => z.im * z.im * factor,
            6 => z.re * z.re + z.im * z.im * factor,
            _ => factor,
        }
    }

    fn value_at(&self, p: Vec3) -> f64 {
        let at = Complex::new(p.x, p.y);
        let c = self.constant.map_or(at, |[re, im]| Complex::new(re, im));
        match self.kind {
            // What stays has this value, wherever it goes.
            FractalKind::Power(2) if self.constant.is_none() && self.interior.0 == 0 && is_attracted(c) => {
                self.interior.1
            }
            FractalKind::Power(2) => self.orbit(Square, at, c),
            FractalKind::Power(exponent) => self.orbit(Power(exponent), at, c),
            FractalKind::Magnet(Magnet::First) => self.orbit(FirstMagnet, at, c),
            FractalKind::Magnet(Magnet::Second) => self.orbit(SecondMagnet, at, c),
        }
    }

    fn orbit<I: Iteration>(&self, iteration: I, at: Complex, c: Complex) -> f64 {
        let from_0 = self.constant.is_none() && I::BEGINS_AT_0;
        let mut z = if from_0 { Complex::new(0.0, 0.0) } else { at };
        let mut squares = z.squares();
        let mut least = if from_0 { 10000.0 } else { squares.0 + squares.1 };
        // Orbits that stay end in cycles, exactly, for lack of digits: one round has seen all that there is.
        let (mut kept, mut kept_at, mut renew_at) = (Complex::new(f64::NAN, f64::NAN), 0, FIRST_RENEWAL);
        let mut done = 0;
        while done < self.iterations {
            for k in done..self.iterations.min(done + STRETCH) {
                z = iteration.step(z, squares, c);
                squares = z.squares();
                let square = squares.0 + squares.1;
                least = if square < least { square } else { least };
                if iteration.escapes(z, square) {
                    return self.outside(k, z);
                }
            }
            done = self.iterations.min(done + STRETCH);
            if z == kept {
                let rest = (self.iterations - done) % (done - kept_at);
                return self.inside(least, (0..rest).fold(z, |z, _| iteration.step(z, z.squares(), c)));
            }
            if done >= renew_at {
                (kept, kept_at, renew_at) = (z, done, 2 * done);
            }
        }
        self.inside(least, z)
    }
}

/// What is repeated, and when it ends.
trait Iteration: Copy {
    /// Where the point itself is the constant, the orbit begins at 0 instead of there.
    const BEGINS_AT_0: bool = false;

    /// What follows `z`, whose components' squares are known.
    fn step(self, z: Complex, squares: (f64, f64), c: Complex) -> Complex;

    /// Whether the orbit ends at `z`, of the given square length.
    fn escapes(self, _z: Complex, square: f64) -> bool {
        square > 4.0
    }
}

/// Whether the orbit of 0 under `z^2 + c` is drawn to a fixed point or to a cycle of two: the Mandelbrot set's
/// heart and the disc to its left.
fn is_attracted(c: Complex) -> bool {
    let y2 = c.im * c.im;
    let (x, left) = (c.re - 0.25, c.re + 1.0);
    let q = x * x + y2;
    q * (q + x) < 0.25 * y2 || left * left + y2 < 0.0625
}

const ONE: Complex = Complex::new(1.0, 0.0);

#[derive(Clone, Copy)]
struct Square;

impl Iteration for Square {
    #[inline]
    fn step(self, z: Complex, (re2, im2): (f64, f64), c: Complex) -> Complex {
        Complex::new(re2 - im2 + c.re, 2.0 * (z.re * z.im) + c.im)
    }
}

#[derive(Clone, Copy)]
struct Power(u32);

impl Iteration for Power {
    #[inline]
    fn step(self, z: Complex, _: (f64, f64), c: Complex) -> Complex {
        z.power(self.0) + c
    }
}

/// Magnets end far away, and near their fixed point 1.
#[inline]
fn magnet_escapes(z: Complex, square: f64) -> bool {
    square > 10000.0 || (z - ONE).square_length() < 0.0001
}

#[derive(Clone, Copy)]
struct FirstMagnet;

impl Iteration for FirstMagnet {
    const BEGINS_AT_0: bool = true;

    #[inline]
    fn step(self, z: Complex, _: (f64, f64), c: Complex) -> Complex {
        let top = z * z + c - ONE;
        let bottom = z * 2.0 + c - ONE * 2.0;
        (top / bottom).power(2)
    }

    #[inline]
    fn escapes(self, z: Complex, square: f64) -> bool {
        magnet_escapes(z, square)
    }
}

#[derive(Clone, Copy)]
struct SecondMagnet;

impl Iteration for SecondMagnet {
    const BEGINS_AT_0: bool = true;

    #[inline]
    fn step(self, z: Complex, _: (f64, f64), c: Complex) -> Complex {
        let (c1, c2) = (c - ONE, c - ONE * 2.0);
        let top = z * z * z + c1 * z * 3.0 + c1 * c2;
        let bottom = z * z * 3.0 + c2 * z * 3.0 + c1 * c2 + ONE;
        (top / bottom).power(2)
    }

    #[inline]
    fn escapes(self, z: Complex, square: f64) -> bool {
        magnet_escapes(z, square)
    }
}

impl Pattern for Fractal {
    fn value(&self, p: Vec3, _setting: &Setting) -> f64 {
        self.value_at(p)
    }

    fn colors(&self) -> Vec<(f32, Color)> {
        if self.constant.is_none() && self.kind == FractalKind::Power(2) {
            keyed(&[
                (0.001, [0.0, 0.0, 0.0]),
                (0.001, [0.0, 1.0, 1.0]),
                (0.012, [1.0, 1.0, 0.0]),
                (0.015, [1.0, 0.0, 1.0]),
                (0.1, [0.0, 1.0, 1.0]),
            ])
        } else {
            keyed(&[(0.0, [0.0, 0.0, 0.0]), (1.0, [1.0, 1.0, 1.0])])
        }
    }

    fn modified(&self, modifier: Modifier) -> Option<Arc<dyn Pattern>> {
        let mut changed = *self;
        match (modifier, self.kind) {
            (Modifier::Exponent(e), FractalKind::Power(_)) => changed.kind = FractalKind::Power(e),
            (Modifier::Exterior(kind, factor), _) => changed.exterior = (kind, factor),
            (Modifier::Interior(kind, factor), _) => changed.interior = (kind, factor),
            _ => return None,
        }
        Some(Arc::new(changed))
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Complex {
    re: f64,
    im: f64,
}

impl Complex {
    const fn new(re: f64, im: f64) -> Self {
        Self { re, im }
    }

    #[inline]
    fn squares(self) -> (f64, f64) {
        (self.re * self.re, self.im * self.im)
    }

    #[inline]
    fn square_length(self) -> f64 {
        self.re * self.re + self.im * self.im
    }

    #[inline]
    fn power(self, exponent: u32) -> Self {
        (1..exponent).fold(self, |z, _| z * self)
    }
}

impl std::ops::Add for Complex {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        Self::new(self.re + o.re, self.im + o.im)
    }
}

impl std::ops::Sub for Complex {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        Self::new(self.re - o.re, self.im - o.im)
    }
}

impl std::ops::Mul for Complex {
    type Output = Self;
    #[inline]
    fn mul(self, o: Self) -> Self {
        Self::new(self.re * o.re - self.im * o.im, self.re * o.im + self.im * o.re)
    }
}

impl std::ops::Mul<f64> for Complex {
    type Output = Self;
    #[inline]
    fn mul(self, k: f64) -> Self {
        Self::new(self.re * k, self.im * k)
    }
}

impl std::ops::Div for Complex {
    type Output = Self;
    #[inline]
    fn div(self, o: Self) -> Self {
        let scale = 1.0 / o.square_length();
        self * Self::new(o.re, -o.im) * scale
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn step(kind: FractalKind, z: Complex, c: Complex) -> Complex {
        match kind {
            FractalKind::Power(exponent) => z.power(exponent) + c,
            FractalKind::Magnet(Magnet::First) => ((z * z + c - ONE) / (z * 2.0 + c - ONE * 2.0)).power(2),
            FractalKind::Magnet(Magnet::Second) => {
                let (c1, c2) = (c - ONE, c - ONE * 2.0);
                let bottom = z * z * 3.0 + c2 * z * 3.0 + c1 * c2 + ONE;
                ((z * z * z + c1 * z * 3.0 + c1 * c2) / bottom).power(2)
            }
        }
    }

    fn escapes(kind: FractalKind, z: Complex) -> bool {
        let near_one = (z - ONE).square_length() < 0.0001;
        match kind {
            FractalKind::Power(_) => z.square_length() > 4.0,
            FractalKind::Magnet(_) => z.square_length() > 10000.0 || near_one,
        }
    }

    /// The iteration as it stands in the table, to its very end.
    fn to_the_end(f: &Fractal, p: Vec3) -> f64 {
        let start = Complex::new(p.x, p.y);
        let (c, mut z) = match (f.constant, f.kind) {
            (Some([re, im]), _) => (Complex::new(re, im), start),
            (None, FractalKind::Power(_)) => (start, start),
            (None, FractalKind::Magnet(_)) => (start, Complex::new(0.0, 0.0)),
        };
        let from_start = f.constant.is_some() || matches!(f.kind, FractalKind::Power(_));
        let mut least = if from_start { start.square_length() } else { 10000.0 };
        for k in 0..f.iterations {
            z = step(f.kind, z, c);
            least = least.min(z.square_length());
            if escapes(f.kind, z) {
                return f.outside(k, z);
            }
        }
        f.inside(least, z)
    }

    #[test]
    fn what_is_attracted_stays() {
        let f = Fractal { interior: (0, 0.5), ..Fractal::new(FractalKind::Power(2), None, 2000) };
        let mut attracted = 0;
        for i in 0..40_000 {
            let p = Vec3::new(f64::from(i % 200) * 0.0131 - 2.1, f64::from(i / 200) * 0.0129 - 1.3, 0.0);
            if is_attracted(Complex::new(p.x, p.y)) {
                attracted += 1;
                assert_eq!(to_the_end(&f, p), 0.5, "{p}");
            }
        }
        assert!(attracted > 6000, "{attracted}");
        // Just inside and just outside of the heart's tip and the disc's left end.
        let inside = |re: f64| is_attracted(Complex::new(re, 0.0));
        assert!(inside(0.2499999) && !inside(0.2500001) && inside(-1.2499999) && !inside(-1.2500001));
    }

    #[test]
    fn a_cycle_found_early_changes_nothing() {
        let kinds = [
            (FractalKind::Power(2), None),
            (FractalKind::Power(2), Some([-0.12, 0.74])),
            (FractalKind::Power(3), None),
            (FractalKind::Magnet(Magnet::First), None),
            (FractalKind::Magnet(Magnet::Second), None),
        ];
        for (kind, constant) in kinds {
            for (iterations, interior) in [(700, 1), (1001, 2), (1002, 3), (40, 6), (1003, 6)] {
                let f = Fractal { interior: (interior, 1.5), ..Fractal::new(kind, constant, iterations) };
                for i in 0..200 {
                    let p = Vec3::new(f64::from(i % 20) * 0.13 - 1.9, f64::from(i / 20) * 0.11 - 0.4, 0.0);
                    assert_eq!(f.value_at(p).to_bits(), to_the_end(&f, p).to_bits(), "{f:?} at {p}");
                }
            }
        }
    }
}
