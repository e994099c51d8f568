//! Ranges of a function together with ranges of its derivatives.
//!
//! Where a function may jump, its derivative is the whole line; at a bend it covers both sides.
//!
//! Reference: L. Rall, "Automatic Differentiation: Techniques and Applications", 1981.

use super::external::VectorFunction;
use super::internal::Internal;
use super::interval::Interval;
use super::number::{Binary, Number, Unary, mapped};
use crate::math::field::Field;
use crate::math::noise::{NoiseGenerator, enclose};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// The range of a value, and of its derivatives by x, y and z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slope {
    pub value: Interval,
    pub by: [Interval; 3],
}

const ZERO: Interval = Interval { lo: 0.0, hi: 0.0 };
const ONE: Interval = Interval { lo: 1.0, hi: 1.0 };

impl Slope {
    /// x, y or z itself, in a range.
    pub fn coordinate(axis: usize, range: Interval) -> Self {
        let mut by = [ZERO; 3];
        by[axis] = ONE;
        Self { value: range, by }
    }

    fn constant(value: Interval) -> Self {
        Self { value, by: [ZERO; 3] }
    }

    /// `value` with the derivatives of this times `factor`.
    fn chain(self, value: Interval, factor: Interval) -> Self {
        Self { value, by: self.by.map(|d| scaled(d, factor)) }
    }

    /// Whether this does not change at all.
    fn is_constant(&self) -> bool {
        self.by.iter().all(|d| *d == ZERO)
    }

    /// `value` with nothing known of derivatives, except that what does not change has none.
    fn jumping(value: Interval, from: &[Self]) -> Self {
        let by = std::array::from_fn(|i| match from.iter().all(|s| s.by[i] == ZERO) {
            true => ZERO,
            false => Interval::WHOLE,
        });
        Self { value, by }
    }

    /// `value` of a function that is constant between jumps: flat if `value` is a single number.
    fn stepped(value: Interval, from: &[Self]) -> Self {
        if value.lo == value.hi { Self::constant(value) } else { Self::jumping(value, from) }
    }

    /// With both derivatives, each weighted.
    fn blend(value: Interval, a: Self, wa: Interval, b: Self, wb: Interval) -> Self {
        Self { value, by: std::array::from_fn(|i| scaled(a.by[i], wa) + scaled(b.by[i], wb)) }
    }

    /// One of two.
    fn either(value: Interval, a: Self, b: Self) -> Self {
        Self { value, by: std::array::from_fn(|i| a.by[i].hull(b.by[i])) }
    }

    fn power(self, exponent: Self, value: Interval) -> Self {
        if !exponent.is_constant() {
            if self.value.lo > 0.0 {
                let ln = self.value.unary(Unary::Ln);
                return Self::blend(value, self, exponent.value * value / self.value, exponent, value * ln);
            }
            return Self::jumping(value, &[self, exponent]);
        }
        let below = self.value.binary(Binary::Pow, exponent.value - 1.0);
        self.chain(value, exponent.value * below)
    }

    fn angle(self, x: Self, value: Interval) -> Self {
        // Across the negative x axis the angle jumps.
        if x.value.lo <= 0.0 && self.value.contains(0.0) {
            return Self::jumping(value, &[self, x]);
        }
        let r2 = self.value.unary(Unary::Square) + x.value.unary(Unary::Square);
        Self::blend(value, self, x.value / r2, x, -self.value / r2)
    }

    fn remainder(self, divisor: Self, value: Interval) -> Self {
        let (quotient, period) = ((self.value / divisor.value).unary(Unary::Int), divisor.value.lo.abs());
        if divisor.known().is_some() && divisor.is_constant() && quotient.lo == quotient.hi {
            // Rounding may put the ends on the wrong side of a jump.
            let rest = self.value - divisor.value * quotient;
            let reaches = rest.lo <= -period * (1.0 - EDGE) || rest.hi >= period * (1.0 - EDGE);
            let begins = quotient.lo != 0.0 && rest.lo < period * EDGE && rest.hi > -period * EDGE;
            if !reaches && !begins {
                return Self { value, ..self };
            }
        }
        Self::jumping(value, &[self, divisor])
    }
}

/// Part of a period near its ends in which rounding may decide.
const EDGE: f64 = 1e-9;

/// A derivative times a factor; what does not change stays so whatever the factor.
fn scaled(d: Interval, factor: Interval) -> Interval {
    if d == ZERO { ZERO } else { d * factor }
}

/// The derivative of a function of one number.
fn derivative(f: Unary, v: Interval, value: Interval) -> Option<Interval> {
    let square = || v.unary(Unary::Square);
    Some(match f {
        Unary::Neg => -ONE,
        Unary::Abs if v.lo >= 0.0 => ONE,
        Unary::Abs if v.hi <= 0.0 => -ONE,
        Unary::Abs => Interval::new(-1.0, 1.0),
        Unary::Square => v * 2.0,
        Unary::Sqrt => ONE / (value * 2.0),
        Unary::Sin => v.unary(Unary::Cos),
        Unary::Cos => -v.unary(Unary::Sin),
        Unary::Tan => value.unary(Unary::Square) + 1.0,
        Unary::Asin => ONE / (ONE - square()).unary(Unary::Sqrt),
        Unary::Acos => -ONE / (ONE - square()).unary(Unary::Sqrt),
        Unary::Atan => ONE / (square() + 1.0),
        Unary::Sinh => v.unary(Unary::Cosh),
        Unary::Cosh => v.unary(Unary::Sinh),
        Unary::Tanh => ONE - value.unary(Unary::Square),
        Unary::Asinh => ONE / (square() + 1.0).unary(Unary::Sqrt),
        Unary::Acosh => ONE / (square() - 1.0).unary(Unary::Sqrt),
        Unary::Atanh => ONE / (ONE - square()),
        Unary::Exp => value,
        Unary::Ln => ONE / v,
        Unary::Log10 => ONE / (v * std::f64::consts::LN_10),
        Unary::Degrees => Interval::from(1f64.to_degrees()),
        Unary::Radians => Interval::from(1f64.to_radians()),
        Unary::Floor | Unary::Ceil | Unary::Int => return None,
    })
}

impl Number for Slope {
    const RANGES: bool = true;
    const UNKNOWN: Slope = Slope { value: Interval::WHOLE, by: [Interval::WHOLE; 3] };

    fn known(self) -> Option<f64> {
        self.value.known()
    }

    fn unary(self, f: Unary) -> Self {
        let value = self.value.unary(f);
        match derivative(f, self.value, value) {
            Some(factor) => self.chain(value, factor),
            None => Self::stepped(value, &[self]),
        }
    }

    fn binary(self, f: Binary, o: Self) -> Self {
        let value = self.value.binary(f, o.value);
        match f {
            Binary::Add => self + o,
            Binary::Sub => self - o,
            Binary::Mul => self * o,
            Binary::Div => self / o,
            Binary::Min if self.value.hi < o.value.lo => self,
            Binary::Min if o.value.hi < self.value.lo => o,
            Binary::Max if self.value.lo > o.value.hi => self,
            Binary::Max if o.value.lo > self.value.hi => o,
            Binary::Min | Binary::Max => Self::either(value, self, o),
            Binary::Pow => self.power(o, value),
            Binary::Mod => self.remainder(o, value),
            Binary::Atan2 => self.angle(o, value),
            _ => Self::stepped(value, &[self, o]),
        }
    }

    fn powi(self, n: i32) -> Self {
        self.chain(self.value.powi(n), self.value.powi(n - 1) * f64::from(n))
    }

    fn choose(self, negative: Self, zero: Self, positive: Self) -> Self {
        if self.value.hi < 0.0 {
            negative
        } else if self.value.lo > 0.0 {
            positive
        } else if self.value == ZERO {
            zero
        } else {
            let value = self.value.choose(negative.value, zero.value, positive.value);
            if negative == zero && zero == positive {
                return positive;
            }
            Self::jumping(value, &[self, negative, zero, positive])
        }
    }

    fn internal(function: &Internal, arguments: &[Self]) -> Self {
        function.slope_value(arguments)
    }

    fn noise(p: [Self; 3], generator: NoiseGenerator) -> Self {
        let (range, slopes) = enclose(&super::interval::cube(p.map(|c| c.value)), generator);
        let mut sum = Self::constant(Interval::new(range.0, range.1));
        for (coordinate, (lo, hi)) in p.into_iter().zip(slopes) {
            sum = Self::blend(sum.value, sum, ONE, coordinate, Interval::new(lo, hi));
        }
        sum
    }

    fn field(field: &dyn Field, p: [Self; 3]) -> Self {
        Self::jumping(Interval::field(field, p.map(|c| c.value)), &p)
    }

    fn vector(function: &dyn VectorFunction, arguments: &[Self], out: &mut [Self; 5]) {
        *out = function.affine().map_or([Self::UNKNOWN; 5], |t| mapped(t, arguments));
    }
}

impl From<f64> for Slope {
    fn from(v: f64) -> Self {
        Self::constant(Interval::from(v))
    }
}

impl Neg for Slope {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, by: self.by.map(|d| -d) }
    }
}

impl Add for Slope {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self { value: self.value + o.value, by: std::array::from_fn(|i| self.by[i] + o.by[i]) }
    }
}

impl Sub for Slope {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        Self { value: self.value - o.value, by: std::array::from_fn(|i| self.by[i] - o.by[i]) }
    }
}

impl Mul for Slope {
    type Output = Self;
    fn mul(self, o: Self) -> Self {
        Self::blend(self.value * o.value, self, o.value, o, self.value)
    }
}

impl Div for Slope {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        let value = self.value / o.value;
        Self::blend(value, self, ONE / o.value, o, -value / o.value)
    }
}

impl Add<f64> for Slope {
    type Output = Self;
    fn add(self, k: f64) -> Self {
        Self { value: self.value + k, ..self }
    }
}

impl Sub<f64> for Slope {
    type Output = Self;
    fn sub(self, k: f64) -> Self {
        Self { value: self.value - k, ..self }
    }
}

impl Mul<f64> for Slope {
    type Output = Self;
    fn mul(self, k: f64) -> Self {
        self.chain(self.value * k, Interval::from(k))
    }
}

impl Div<f64> for Slope {
    type Output = Self;
    fn div(self, k: f64) -> Self {
        self.chain(self.value / k, Interval::from(1.0) / Interval::from(k))
    }
}
