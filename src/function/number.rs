use super::external::VectorFunction;
use super::internal::Internal;
use super::interval::{Interval, cube};
use crate::math::field::Field;
use crate::math::noise::{NoiseGenerator, enclose, noise};
use crate::math::{Transform, Vec3};
use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Functions of one number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Unary {
    Neg,
    Abs,
    Square,
    Sqrt,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    Asinh,
    Acosh,
    Atanh,
    Exp,
    Ln,
    Log10,
    Floor,
    Ceil,
    Int,
    Degrees,
    Radians,
}

/// Functions of two numbers. Comparisons and logic give 1 or 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Binary {
    Add,
    Sub,
    Mul,
    Div,
    Min,
    Max,
    Pow,
    /// Remainder with the sign of the dividend.
    Mod,
    /// Quotient truncated to a 32-bit whole number.
    IntDiv,
    Atan2,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    And,
    Or,
}

/// What programs and internal functions compute with: numbers, or ranges of numbers.
pub trait Number:
    Copy
    + Debug
    + From<f64>
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
{
    /// Whether these are ranges, whose sign may be undecided.
    const RANGES: bool;

    /// The result of what cannot be told.
    const UNKNOWN: Self;

    /// The number, if this stands for one only.
    fn known(self) -> Option<f64>;

    fn unary(self, f: Unary) -> Self;

    fn binary(self, f: Binary, other: Self) -> Self;

    /// The whole power `n`, found by multiplications.
    fn powi(self, n: i32) -> Self;

    /// `negative`, `zero` or `positive`, as this number is.
    fn choose(self, negative: Self, zero: Self, positive: Self) -> Self;

    fn internal(function: &Internal, arguments: &[Self]) -> Self;

    /// Lattice noise, 0 ..= 1.
    fn noise(p: [Self; 3], generator: NoiseGenerator) -> Self;

    fn field(field: &dyn Field, p: [Self; 3]) -> Self;

    fn vector(function: &dyn VectorFunction, arguments: &[Self], out: &mut [Self; 5]);

    fn square(self) -> Self {
        self.unary(Unary::Square)
    }
    fn sqrt(self) -> Self {
        self.unary(Unary::Sqrt)
    }
    fn abs(self) -> Self {
        self.unary(Unary::Abs)
    }
    fn exp(self) -> Self {
        self.unary(Unary::Exp)
    }
    fn sin(self) -> Self {
        self.unary(Unary::Sin)
    }
    fn cos(self) -> Self {
        self.unary(Unary::Cos)
    }
    fn floor(self) -> Self {
        self.unary(Unary::Floor)
    }
    /// The angle of the point with this ordinate and abscissa `x`.
    fn atan2(self, x: Self) -> Self {
        self.binary(Binary::Atan2, x)
    }
    fn rem(self, divisor: Self) -> Self {
        self.binary(Binary::Mod, divisor)
    }
    fn pow(self, exponent: Self) -> Self {
        self.binary(Binary::Pow, exponent)
    }
    fn min(self, other: Self) -> Self {
        self.binary(Binary::Min, other)
    }
    fn max(self, other: Self) -> Self {
        self.binary(Binary::Max, other)
    }
}

/// Truncation to a 32-bit whole number; what does not fit is the smallest one.
fn int(a: f64) -> f64 {
    let whole = a.trunc();
    if (-2147483648.0..=2147483647.0).contains(&whole) { whole } else { -2147483648.0 }
}

fn truth(b: bool) -> f64 {
    f64::from(u8::from(b))
}

impl Number for f64 {
    const RANGES: bool = false;
    const UNKNOWN: f64 = f64::NAN;

    #[inline(always)]
    fn known(self) -> Option<f64> {
        Some(self)
    }

    #[inline(always)]
    fn unary(self, f: Unary) -> f64 {
        match f {
            Unary::Neg => -self,
            Unary::Abs => self.abs(),
            Unary::Square => self * self,
            Unary::Sqrt => self.sqrt(),
            Unary::Sin => self.sin(),
            Unary::Cos => self.cos(),
            Unary::Tan => self.tan(),
            Unary::Asin => self.asin(),
            Unary::Acos => self.acos(),
            Unary::Atan => self.atan(),
            Unary::Sinh => self.sinh(),
            Unary::Cosh => self.cosh(),
            Unary::Tanh => self.tanh(),
            Unary::Asinh => self.asinh(),
            Unary::Acosh => self.acosh(),
            Unary::Atanh => self.atanh(),
            Unary::Exp => self.exp(),
            Unary::Ln => self.ln(),
            Unary::Log10 => self.log10(),
            Unary::Floor => self.floor(),
            Unary::Ceil => self.ceil(),
            Unary::Int => int(self),
            Unary::Degrees => self.to_degrees(),
            Unary::Radians => self.to_radians(),
        }
    }

    #[inline(always)]
    #[allow(clippy::neg_cmp_op_on_partial_ord)] // A comparison with NaN: `>` and `>=` hold, `<` and `<=` do not.
    fn binary(self, f: Binary, o: f64) -> f64 {
        match f {
            Binary::Add => self + o,
            Binary::Sub => self - o,
            Binary::Mul => self * o,
            Binary::Div => self / o,
            Binary::Min => {
                if self < o {
                    self
                } else {
                    o
                }
            }
            Binary::Max => {
                if self < o {
                    o
                } else {
                    self
                }
            }
            Binary::Pow => self.powf(o),
            Binary::Mod => self % o,
            Binary::IntDiv => int(self / o),
            Binary::Atan2 => f64::atan2(self, o),
            Binary::Less => truth(self < o),
            Binary::LessEqual => truth(self <= o),
            Binary::Greater => truth(!(self <= o)),
            Binary::GreaterEqual => truth(!(self < o)),
            Binary::Equal => truth(self == o),
            Binary::NotEqual => truth(self != o),
            Binary::And => truth(self != 0.0 && o != 0.0),
            Binary::Or => truth(self != 0.0 || o != 0.0),
        }
    }

    #[inline(always)]
    fn powi(self, n: i32) -> f64 {
        f64::powi(self, n)
    }

    #[inline(always)]
    fn choose(self, negative: f64, zero: f64, positive: f64) -> f64 {
        if self < 0.0 {
            negative
        } else if self == 0.0 {
            zero
        } else {
            positive
        }
    }

    #[inline]
    fn internal(function: &Internal, arguments: &[f64]) -> f64 {
        function.number_value(arguments)
    }

    #[inline]
    fn noise(p: [f64; 3], generator: NoiseGenerator) -> f64 {
        noise(Vec3::from_array(p), generator)
    }

    #[inline]
    fn field(field: &dyn Field, p: [f64; 3]) -> f64 {
        field.value(Vec3::from_array(p))
    }

    #[inline]
    fn vector(function: &dyn VectorFunction, arguments: &[f64], out: &mut [f64; 5]) {
        *out = function.value(arguments);
    }
}

/// A point moved by an affine map.
pub(super) fn mapped<N: Number>(t: &Transform, p: &[N]) -> [N; 5] {
    let m = t.forward.matrix3;
    std::array::from_fn(|i| match i {
        0..3 => p[0] * m.x_axis[i] + p[1] * m.y_axis[i] + p[2] * m.z_axis[i] + t.forward.translation[i],
        _ => N::from(0.0),
    })
}

impl Number for Interval {
    const RANGES: bool = true;
    const UNKNOWN: Interval = Interval::WHOLE;

    fn known(self) -> Option<f64> {
        (self.lo == self.hi).then_some(self.lo)
    }

    fn unary(self, f: Unary) -> Interval {
        Interval::unary(self, f)
    }

    fn binary(self, f: Binary, o: Interval) -> Interval {
        Interval::binary(self, f, o)
    }

    fn powi(self, n: i32) -> Interval {
        Interval::powi(self, n)
    }

    fn choose(self, negative: Interval, zero: Interval, positive: Interval) -> Interval {
        Interval::choose(self, negative, zero, positive)
    }

    fn internal(function: &Internal, arguments: &[Interval]) -> Interval {
        function.range_value(arguments)
    }

    fn noise(p: [Interval; 3], generator: NoiseGenerator) -> Interval {
        let (lo, hi) = enclose(&cube(p), generator).0;
        Interval::new(lo, hi)
    }

    fn field(field: &dyn Field, p: [Interval; 3]) -> Interval {
        match field.range(&cube(p)) {
            Some((lo, hi)) => Interval::new(lo, hi),
            None => Interval::WHOLE,
        }
    }

    fn vector(function: &dyn VectorFunction, arguments: &[Interval], out: &mut [Interval; 5]) {
        *out = function.affine().map_or([Interval::WHOLE; 5], |t| mapped(t, arguments));
    }
}
