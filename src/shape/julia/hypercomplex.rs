//! Iteration of hypercomplex numbers: pairs of complex numbers that are iterated side by side.
//!
//! With `a = (x - w) + i (y + z)` and `b = (x + w) + i (y - z)` every function of a hypercomplex number is the
//! function of a and of b, and `|z|² = (|a|² + |b|²) / 2`.

use super::Fate;
use super::quaternion::Four;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// What is iterated. `cube` is the square here, as it always was.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Function {
    Square,
    Cube,
    Exp,
    Reciprocal,
    Sin,
    Asin,
    Sinh,
    Asinh,
    Cos,
    Acos,
    Cosh,
    Acosh,
    Tan,
    Atan,
    Tanh,
    Atanh,
    Ln,
    /// To this complex power.
    Power([f64; 2]),
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Complex {
    re: f64,
    im: f64,
}

const ONE: Complex = Complex { re: 1.0, im: 0.0 };
const I: Complex = Complex { re: 0.0, im: 1.0 };

impl Add for Complex {
    type Output = Complex;
    fn add(self, o: Complex) -> Complex {
        Complex { re: self.re + o.re, im: self.im + o.im }
    }
}

impl Sub for Complex {
    type Output = Complex;
    fn sub(self, o: Complex) -> Complex {
        Complex { re: self.re - o.re, im: self.im - o.im }
    }
}

impl Mul for Complex {
    type Output = Complex;
    fn mul(self, o: Complex) -> Complex {
        Complex { re: self.re * o.re - self.im * o.im, im: self.re * o.im + self.im * o.re }
    }
}

impl Mul<f64> for Complex {
    type Output = Complex;
    fn mul(self, k: f64) -> Complex {
        Complex { re: self.re * k, im: self.im * k }
    }
}

impl Div for Complex {
    type Output = Complex;
    fn div(self, o: Complex) -> Complex {
        let size = o.re * o.re + o.im * o.im;
        let p = self * o.conjugate();
        Complex { re: p.re / size, im: p.im / size }
    }
}

impl Neg for Complex {
    type Output = Complex;
    fn neg(self) -> Complex {
        Complex { re: -self.re, im: -self.im }
    }
}

impl Complex {
    fn conjugate(self) -> Complex {
        Complex { re: self.re, im: -self.im }
    }

    fn squared_size(self) -> f64 {
        self.re * self.re + self.im * self.im
    }

    fn exp(self) -> Complex {
        let (sin, cos) = self.im.sin_cos();
        Complex { re: cos, im: sin } * self.re.exp()
    }

    fn ln(self) -> Complex {
        Complex { re: self.re.hypot(self.im).ln(), im: self.im.atan2(self.re) }
    }

    fn sqrt(self) -> Complex {
        let size = self.re.hypot(self.im);
        let re = (0.5 * (size + self.re)).max(0.0).sqrt();
        let im = (0.5 * (size - self.re)).max(0.0).sqrt();
        Complex { re, im: im.copysign(self.im) }
    }

    fn sin(self) -> Complex {
        let (sin, cos) = self.re.sin_cos();
        Complex { re: sin * self.im.cosh(), im: cos * self.im.sinh() }
    }

    fn cos(self) -> Complex {
        let (sin, cos) = self.re.sin_cos();
        Complex { re: cos * self.im.cosh(), im: -sin * self.im.sinh() }
    }

    fn sinh(self) -> Complex {
        -(I * (I * self).sin())
    }

    fn cosh(self) -> Complex {
        (I * self).cos()
    }

    fn tan(self) -> Complex {
        let (x, y) = (2.0 * self.re, 2.0 * self.im);
        let below = x.cos() + y.cosh();
        Complex { re: x.sin() / below, im: y.sinh() / below }
    }

    fn tanh(self) -> Complex {
        -(I * (I * self).tan())
    }

    fn asin(self) -> Complex {
        -(I * (I * self + (ONE - self * self).sqrt()).ln())
    }

    fn acos(self) -> Complex {
        -(I * (self + (self * self - ONE).sqrt()).ln())
    }

    fn atanh(self) -> Complex {
        ((ONE + self) / (ONE - self)).ln() * 0.5
    }
}

impl Function {
    fn value(self, z: Complex) -> Complex {
        match self {
            Function::Square | Function::Cube => z * z,
            Function::Exp => z.exp(),
            Function::Reciprocal => ONE / z,
            Function::Sin => z.sin(),
            Function::Asin => z.asin(),
            Function::Sinh => z.sinh(),
            Function::Asinh => (z + (z * z + ONE).sqrt()).ln(),
            Function::Cos => z.cos(),
            Function::Acos => z.acos(),
            Function::Cosh => z.cosh(),
            Function::Acosh => (z + (z * z - ONE).sqrt()).ln(),
            Function::Tan => z.tan(),
            Function::Atan => -(I * (I * z).atanh()),
            Function::Tanh => z.tanh(),
            Function::Atanh => z.atanh(),
            Function::Ln => z.ln(),
            Function::Power([re, im]) => (Complex { re, im } * z.ln()).exp(),
        }
    }

    fn slope(self, z: Complex) -> Complex {
        let square = z * z;
        match self {
            Function::Square | Function::Cube => z * 2.0,
            Function::Exp => z.exp(),
            Function::Reciprocal => -(ONE / square),
            Function::Sin => z.cos(),
            Function::Asin => ONE / (ONE - square).sqrt(),
            Function::Sinh => z.cosh(),
            Function::Asinh => ONE / (square + ONE).sqrt(),
            Function::Cos => -z.sin(),
            // The derivative of its value here, whichever branch the root is on.
            Function::Acos => -(I / (square - ONE).sqrt()),
            Function::Cosh => z.sinh(),
            Function::Acosh => ONE / (square - ONE).sqrt(),
            Function::Tan => ONE + z.tan() * z.tan(),
            Function::Atan => ONE / (ONE + square),
            Function::Tanh => ONE - z.tanh() * z.tanh(),
            Function::Atanh => ONE / (ONE - square),
            Function::Ln => ONE / z,
            Function::Power([re, im]) => {
                let power = Complex { re, im };
                power * (power * z.ln()).exp() / z
            }
        }
    }
}

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Hypercomplex {
    function: Function,
    c: [Complex; 2],
}

/// Squared size from which an iterate has escaped.
const LIMIT: f64 = 16.0;
/// An estimate of the distance is used up to this many steps.
const MOST_STEPS: f64 = 30.0;

fn split([x, y, z, w]: Four) -> [Complex; 2] {
    [Complex { re: x - w, im: y + z }, Complex { re: x + w, im: y - z }]
}

fn size([a, b]: [Complex; 2]) -> f64 {
    0.5 * (a.squared_size() + b.squared_size())
}

impl Hypercomplex {
    pub fn new(c: Four, function: Function) -> Self {
        Self { function, c: split(c) }
    }

    fn next(&self, [a, b]: [Complex; 2]) -> [Complex; 2] {
        [self.function.value(a) + self.c[0], self.function.value(b) + self.c[1]]
    }

    pub fn stays(&self, z: Four, iterations: u32) -> bool {
        let mut z = split(z);
        for _ in 0..iterations {
            if !(size(z) <= LIMIT) {
                return false;
            }
            z = self.next(z);
        }
        true
    }

    /// `slope` is how the point changes along the ray.
    pub fn fate(&self, z: Four, slope: Four, iterations: u32, step: f64) -> Fate {
        let (mut z, mut slope) = (split(z), split(slope));
        for _ in 0..iterations {
            let now = size(z);
            if !(now <= LIMIT) {
                let closing = -(0..2).map(|k| (z[k].conjugate() * slope[k]).re).sum::<f64>();
                let near = now > step * closing && now < MOST_STEPS * step * closing;
                return Fate::Outside(if near { now / closing } else { 0.0 });
            }
            for k in 0..2 {
                slope[k] = slope[k] * self.function.slope(z[k]);
            }
            z = self.next(z);
        }
        Fate::Inside
    }

    /// After how many iterations the size decides about a point of the surface: the last, but for functions
    /// whose iterates may grow and shrink again, where it is largest.
    fn decisive(&self, z: Four, iterations: u32) -> u32 {
        if matches!(self.function, Function::Square | Function::Cube) {
            return iterations;
        }
        let (mut z, mut largest) = (split(z), (0, 0.0));
        for i in 0..iterations {
            let now = size(z);
            if now > largest.1 {
                largest = (i, now);
            }
            if !(now < LIMIT * LIMIT) {
                break;
            }
            z = self.next(z);
        }
        largest.0
    }

    /// The gradient of the squared size that decides.
    pub fn gradient(&self, z: Four, iterations: u32) -> Four {
        let decisive = self.decisive(z, iterations);
        let mut z = split(z);
        let mut slope = [ONE, ONE];
        for _ in 0..decisive {
            let next = self.next(z);
            let slopes = [self.function.slope(z[0]), self.function.slope(z[1])];
            let grown = [slope[0] * slopes[0], slope[1] * slopes[1]];
            let largest = grown[0].squared_size().max(grown[1].squared_size()).sqrt();
            // Beyond this the direction no longer changes, and numbers would overflow.
            if !(size(next) < 1e100 && largest > 0.0 && largest.is_finite()) {
                break;
            }
            slope = grown.map(|s| s * (1.0 / largest));
            z = next;
        }
        let [a, b] = [z[0].conjugate() * slope[0], z[1].conjugate() * slope[1]];
        // The real part of each times the derivatives of a and b by x, y, z, w.
        [a.re + b.re, -a.im - b.im, -a.im + b.im, -a.re + b.re]
    }

    #[cfg(test)]
    pub fn decisive_size(&self, at: Four, z: Four, iterations: u32) -> f64 {
        let mut z = split(z);
        for _ in 0..self.decisive(at, iterations) {
            z = self.next(z);
        }
        size(z)
    }
}
