//! Ranges of numbers, and what functions do to them.
//!
//! A range encloses every double that a program computes from doubles inside the ranges that it was given.
//! Addition, multiplication, division and square root round monotonically, so their end points need no
//! margin; functions of the mathematics library get one of [`LIBRARY_ERROR`]. Where a result may be NaN the
//! range is the whole line, and the whole line yields the whole line: NaN is not lost on the way.
//!
//! Reference: R. E. Moore, "Interval Analysis", 1966, chapter 3.

use super::number::{Binary, Number, Unary};
use crate::math::{Aabb, Vec3};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// All numbers from `lo` to `hi`, both included. Ends may be infinite, never NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    pub lo: f64,
    pub hi: f64,
}

/// The box of points with coordinates in these ranges.
pub(super) fn cube(p: [Interval; 3]) -> Aabb {
    Aabb { min: Vec3::from_array(p.map(|i| i.lo)), max: Vec3::from_array(p.map(|i| i.hi)) }
}

/// Relative error that functions of the mathematics library stay well below.
const LIBRARY_ERROR: f64 = 4.0 * f64::EPSILON;

impl Interval {
    /// Every number, and perhaps none (NaN).
    pub const WHOLE: Interval = Interval { lo: f64::NEG_INFINITY, hi: f64::INFINITY };

    const TRUTH: Interval = Interval { lo: 0.0, hi: 1.0 };

    /// The range between two ends in order; the whole line if they are not, or are NaN.
    #[inline]
    pub fn new(lo: f64, hi: f64) -> Self {
        if lo <= hi { Self { lo, hi } } else { Self::WHOLE }
    }

    pub fn contains(&self, v: f64) -> bool {
        self.lo <= v && v <= self.hi
    }

    /// The smallest range around both.
    pub fn hull(self, o: Self) -> Self {
        Self { lo: self.lo.min(o.lo), hi: self.hi.max(o.hi) }
    }

    /// With room for the library's errors.
    fn widened(lo: f64, hi: f64) -> Self {
        let margin = |v: f64| v.abs() * LIBRARY_ERROR + f64::MIN_POSITIVE;
        Self::new(lo - margin(lo), hi + margin(hi))
    }

    fn opened(self) -> Self {
        Self::widened(self.lo, self.hi)
    }

    fn limited(self, lo: f64, hi: f64) -> Self {
        Self { lo: self.lo.clamp(lo, hi), hi: self.hi.clamp(lo, hi) }
    }

    /// Of a function that rises everywhere between `from` and `to` and is not defined outside.
    fn rising(self, f: impl Fn(f64) -> f64, from: f64, to: f64) -> Self {
        if self.lo >= from && self.hi <= to { Self::widened(f(self.lo), f(self.hi)) } else { Self::WHOLE }
    }

    /// Of a function that rises everywhere and is computed exactly.
    fn stepped(self, f: impl Fn(f64) -> f64) -> Self {
        Self::new(f(self.lo), f(self.hi))
    }

    pub(super) fn unary(self, f: Unary) -> Self {
        const ALL: f64 = f64::INFINITY;
        if self.is_whole() {
            return self;
        }
        match f {
            Unary::Neg => -self,
            Unary::Abs => self.magnitude(),
            Unary::Square => self.magnitude().stepped(|v| v * v),
            Unary::Sqrt if self.lo >= 0.0 => self.stepped(f64::sqrt),
            Unary::Sqrt => Self::WHOLE,
            Unary::Sin => self.wave(f64::sin, FRAC_PI_2),
            Unary::Cos => self.wave(f64::cos, 0.0),
            Unary::Tan => self.tangent(),
            Unary::Asin => self.rising(f64::asin, -1.0, 1.0),
            Unary::Acos => -(self.rising(|v| -v.acos(), -1.0, 1.0)),
            Unary::Atan => self.rising(f64::atan, -ALL, ALL),
            Unary::Sinh => self.rising(f64::sinh, -ALL, ALL),
            Unary::Cosh => self.magnitude().rising(f64::cosh, 0.0, ALL),
            Unary::Tanh => self.rising(f64::tanh, -ALL, ALL),
            Unary::Asinh => self.rising(f64::asinh, -ALL, ALL),
            Unary::Acosh => self.rising(f64::acosh, 1.0, ALL),
            Unary::Atanh => self.rising(f64::atanh, -1.0, 1.0),
            Unary::Exp => self.rising(f64::exp, -ALL, ALL).limited(0.0, ALL),
            Unary::Ln => self.rising(f64::ln, 0.0, ALL),
            Unary::Log10 => self.rising(f64::log10, 0.0, ALL),
            Unary::Floor => self.stepped(f64::floor),
            Unary::Ceil => self.stepped(f64::ceil),
            Unary::Int if self.lo > -2147483649.0 && self.hi < 2147483648.0 => self.stepped(f64::trunc),
            Unary::Int => Self::WHOLE,
            Unary::Degrees => self.stepped(f64::to_degrees),
            Unary::Radians => self.stepped(f64::to_radians),
        }
    }

    #[inline]
    pub(super) fn binary(self, f: Binary, o: Self) -> Self {
        match f {
            Binary::Add => self + o,
            Binary::Sub => self - o,
            Binary::Mul => self * o,
            Binary::Div => self / o,
            _ if self.is_whole() || o.is_whole() => self.unknown(f, o),
            Binary::Min => Self::new(self.lo.min(o.lo), self.hi.min(o.hi)),
            Binary::Max => Self::new(self.lo.max(o.lo), self.hi.max(o.hi)),
            Binary::Pow => self.power(o),
            Binary::Mod => self.remainder(o),
            Binary::IntDiv => (self / o).unary(Unary::Int),
            Binary::Atan2 => self.angle(o),
            Binary::Less => Self::decided(self.hi < o.lo, self.lo >= o.hi),
            Binary::LessEqual => Self::decided(self.hi <= o.lo, self.lo > o.hi),
            Binary::Greater => Self::decided(self.lo > o.hi, self.hi <= o.lo),
            Binary::GreaterEqual => Self::decided(self.lo >= o.hi, self.hi < o.lo),
            Binary::Equal => Self::decided(self.is_same(o), self.is_apart(o)),
            Binary::NotEqual => Self::decided(self.is_apart(o), self.is_same(o)),
            Binary::And => {
                Self::decided(!self.contains(0.0) && !o.contains(0.0), self.is_zero() || o.is_zero())
            }
            Binary::Or => {
                Self::decided(!self.contains(0.0) || !o.contains(0.0), self.is_zero() && o.is_zero())
            }
        }
    }

    /// Of functions of what may be NaN. (The smaller and the larger of two are the second and the first
    /// one if either is NaN.)
    fn unknown(self, f: Binary, o: Self) -> Self {
        match f {
            Binary::Min if !o.is_whole() => Self { lo: f64::NEG_INFINITY, hi: o.hi },
            Binary::Max if !self.is_whole() => Self { lo: self.lo, hi: f64::INFINITY },
            Binary::Less | Binary::LessEqual | Binary::Greater | Binary::GreaterEqual => Self::TRUTH,
            Binary::Equal | Binary::NotEqual | Binary::And | Binary::Or => Self::TRUTH,
            _ => Self::WHOLE,
        }
    }

    pub(super) fn powi(self, n: i32) -> Self {
        if self.is_whole() {
            return self;
        }
        if n < 0 {
            return Self::from(1.0) / self.powi(n.saturating_neg());
        }
        if n % 2 == 0 { self.magnitude().stepped(|v| v.powi(n)) } else { self.stepped(|v| v.powi(n)) }
    }

    pub(super) fn choose(self, negative: Self, zero: Self, positive: Self) -> Self {
        let branches = [(self.lo < 0.0, negative), (self.contains(0.0), zero), (self.hi > 0.0, positive)];
        let possible = branches.into_iter().filter(|b| b.0).map(|b| b.1);
        possible.reduce(Self::hull).unwrap_or(Self::WHOLE)
    }

    fn decided(yes: bool, no: bool) -> Self {
        if yes {
            Self::from(1.0)
        } else if no {
            Self::from(0.0)
        } else {
            Self::TRUTH
        }
    }

    fn is_whole(self) -> bool {
        self == Self::WHOLE
    }

    fn is_zero(self) -> bool {
        self.lo == 0.0 && self.hi == 0.0
    }

    fn is_same(self, o: Self) -> bool {
        self.lo == self.hi && o.lo == o.hi && self.lo == o.lo
    }

    fn is_apart(self, o: Self) -> bool {
        self.hi < o.lo || self.lo > o.hi
    }

    fn magnitude(self) -> Self {
        if self.lo >= 0.0 {
            self
        } else if self.hi <= 0.0 {
            -self
        } else {
            Self { lo: 0.0, hi: self.hi.max(-self.lo) }
        }
    }

    /// Of `f`, a sine wave with a crest at `crest`.
    fn wave(self, f: impl Fn(f64) -> f64, crest: f64) -> Self {
        /// Beyond this a double no longer resolves a turn well.
        const FAR: f64 = 1e9;
        if !self.lo.is_finite() || !self.hi.is_finite() {
            return Self::WHOLE;
        }
        if self.hi - self.lo >= TAU || self.lo < -FAR || self.hi > FAR {
            return Self { lo: -1.0, hi: 1.0 };
        }
        let (a, b) = (f(self.lo), f(self.hi));
        let lo = if self.meets(crest + PI, TAU) { -1.0 } else { a.min(b) };
        let hi = if self.meets(crest, TAU) { 1.0 } else { a.max(b) };
        Self::widened(lo, hi).limited(-1.0, 1.0)
    }

    fn tangent(self) -> Self {
        if self.hi - self.lo >= PI || self.magnitude().hi > 1e9 || self.meets(FRAC_PI_2, PI) {
            return Self::WHOLE;
        }
        Self::widened(self.lo.tan(), self.hi.tan())
    }

    /// Whether some `at + k * period` may lie inside.
    fn meets(self, at: f64, period: f64) -> bool {
        let margin = LIBRARY_ERROR * (self.lo.abs().max(self.hi.abs()) + period);
        let k = ((self.lo - margin - at) / period).ceil();
        // The quotient may have been rounded up past a whole number.
        at + k * period <= self.hi + margin || at + (k - 1.0) * period >= self.lo - margin
    }

    fn power(self, exponent: Self) -> Self {
        if let Some(n) = exponent.known().filter(|n| n.trunc() == *n && *n > 0.0 && *n < 1e9) {
            let base = if n % 2.0 == 0.0 { self.magnitude() } else { self };
            return Self::widened(base.lo.powf(n), base.hi.powf(n));
        }
        if self.lo < 0.0 {
            return Self::WHOLE;
        }
        let corners = [
            self.lo.powf(exponent.lo),
            self.lo.powf(exponent.hi),
            self.hi.powf(exponent.lo),
            self.hi.powf(exponent.hi),
        ];
        Self::of_corners(corners).opened().limited(0.0, f64::INFINITY)
    }

    /// Of what is monotonic in each of two variables, by its values at the corners.
    #[inline]
    fn of_corners([a, b, c, d]: [f64; 4]) -> Self {
        // Products of 0 and infinity are NaN, which `min` and `max` would pass over.
        if (a + b + c + d).is_nan() {
            return Self::WHOLE;
        }
        Self { lo: a.min(b).min(c.min(d)), hi: a.max(b).max(c.max(d)) }
    }

    fn remainder(self, divisor: Self) -> Self {
        let largest = divisor.magnitude().hi;
        if divisor.contains(0.0) || !largest.is_finite() || !self.magnitude().hi.is_finite() {
            return Self::WHOLE;
        }
        if let Some(d) = divisor.known() {
            let (a, b) = (self.lo % d, self.hi % d);
            let one_sign = self.lo >= 0.0 || self.hi <= 0.0;
            if one_sign && self.hi - self.lo < d.abs() && a <= b {
                return Self::new(a, b);
            }
        }
        let lo = if self.lo < 0.0 { -largest } else { 0.0 };
        Self::new(lo, if self.hi > 0.0 { largest } else { 0.0 })
    }

    /// Of atan2(`self`, `x`).
    fn angle(self, x: Self) -> Self {
        // The angle jumps across the negative x axis, and takes every value at the origin.
        if x.lo <= 0.0 && self.contains(0.0) {
            return Self::widened(-PI, PI);
        }
        let (y, atan2) = (self, f64::atan2);
        let corners = [atan2(y.lo, x.lo), atan2(y.lo, x.hi), atan2(y.hi, x.lo), atan2(y.hi, x.hi)];
        Self::of_corners(corners).opened()
    }
}

impl From<f64> for Interval {
    #[inline]
    fn from(v: f64) -> Self {
        Self::new(v, v)
    }
}

impl Neg for Interval {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { lo: -self.hi, hi: -self.lo }
    }
}

impl Add for Interval {
    type Output = Self;
    #[inline]
    fn add(self, o: Self) -> Self {
        Self::new(self.lo + o.lo, self.hi + o.hi)
    }
}

impl Sub for Interval {
    type Output = Self;
    #[inline]
    fn sub(self, o: Self) -> Self {
        Self::new(self.lo - o.hi, self.hi - o.lo)
    }
}

impl Mul for Interval {
    type Output = Self;
    #[inline]
    fn mul(self, o: Self) -> Self {
        Self::of_corners([self.lo * o.lo, self.lo * o.hi, self.hi * o.lo, self.hi * o.hi])
    }
}

impl Div for Interval {
    type Output = Self;
    fn div(self, o: Self) -> Self {
        if o.lo > 0.0 || o.hi < 0.0 {
            return Self::of_corners([self.lo / o.lo, self.lo / o.hi, self.hi / o.lo, self.hi / o.hi]);
        }
        // At 0 itself the quotient may be infinite either way.
        Self::WHOLE
    }
}

impl Add<f64> for Interval {
    type Output = Self;
    #[inline]
    fn add(self, k: f64) -> Self {
        Self::new(self.lo + k, self.hi + k)
    }
}

impl Sub<f64> for Interval {
    type Output = Self;
    #[inline]
    fn sub(self, k: f64) -> Self {
        Self::new(self.lo - k, self.hi - k)
    }
}

impl Mul<f64> for Interval {
    type Output = Self;
    #[inline]
    fn mul(self, k: f64) -> Self {
        let (a, b) = (self.lo * k, self.hi * k);
        if k < 0.0 { Self::new(b, a) } else { Self::new(a, b) }
    }
}

impl Div<f64> for Interval {
    type Output = Self;
    #[inline]
    fn div(self, k: f64) -> Self {
        self / Self::from(k)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const UNARY: [Unary; 24] = [
        Unary::Neg,
        Unary::Abs,
        Unary::Square,
        Unary::Sqrt,
        Unary::Sin,
        Unary::Cos,
        Unary::Tan,
        Unary::Asin,
        Unary::Acos,
        Unary::Atan,
        Unary::Sinh,
        Unary::Cosh,
        Unary::Tanh,
        Unary::Asinh,
        Unary::Acosh,
        Unary::Atanh,
        Unary::Exp,
        Unary::Ln,
        Unary::Log10,
        Unary::Floor,
        Unary::Ceil,
        Unary::Int,
        Unary::Degrees,
        Unary::Radians,
    ];

    const BINARY: [Binary; 18] = [
        Binary::Add,
        Binary::Sub,
        Binary::Mul,
        Binary::Div,
        Binary::Min,
        Binary::Max,
        Binary::Pow,
        Binary::Mod,
        Binary::IntDiv,
        Binary::Atan2,
        Binary::Less,
        Binary::LessEqual,
        Binary::Greater,
        Binary::GreaterEqual,
        Binary::Equal,
        Binary::NotEqual,
        Binary::And,
        Binary::Or,
    ];

    /// Ends of all sizes, whole numbers among them.
    fn end() -> impl Strategy<Value = f64> {
        prop_oneof![-1.5..1.5, -10.0..10.0, -1e4..1e4, (-4i32..5).prop_map(f64::from)]
    }

    fn encloses(range: Interval, value: f64) -> bool {
        range == Interval::WHOLE || range.contains(value)
    }

    proptest! {
        #[test]
        fn one_argument(a in end(), b in end(), s in 0.0..=1.0) {
            let range = Interval::new(a.min(b), a.max(b));
            let v: f64 = f64::clamp(a + s * (b - a), range.lo, range.hi);
            for f in UNARY {
                prop_assert!(encloses(range.unary(f), f64::unary(v, f)), "{f:?} of {v} in {range:?}");
            }
            for n in 2..=8 {
                prop_assert!(encloses(range.powi(n), f64::powi(v, n)), "{v}^{n} in {range:?}");
            }
        }

        #[test]
        fn two_arguments(a in [end(), end()], b in [end(), end()], s in 0.0..=1.0, t in 0.0..=1.0) {
            let ranges = [a, b].map(|[a, b]| Interval::new(a.min(b), a.max(b)));
            let at = |r: Interval, s: f64| f64::clamp(r.lo + s * (r.hi - r.lo), r.lo, r.hi);
            let (v, w) = (at(ranges[0], s), at(ranges[1], t));
            for f in BINARY {
                let range = ranges[0].binary(f, ranges[1]);
                prop_assert!(encloses(range, v.binary(f, w)), "{f:?} of {v}, {w} in {ranges:?}: {range:?}");
                let range = ranges[0].binary(f, Interval::from(b[0]));
                prop_assert!(encloses(range, v.binary(f, b[0])), "{f:?} of {v}, {} in {ranges:?}", b[0]);
            }
        }
    }

    #[test]
    fn waves_reach_their_crests() {
        let r = Interval::new(1.5, 1.6).unary(Unary::Sin);
        assert_eq!(r.hi, 1.0);
        assert!((r.lo - 1.5f64.sin()).abs() < 1e-14);
        assert_eq!(Interval::new(3.0, 3.2).unary(Unary::Cos).lo, -1.0);
        assert!(Interval::new(0.1, 0.2).unary(Unary::Sin).hi < 0.2);
    }

    #[test]
    fn squares_are_tight() {
        assert_eq!(Interval::new(-1.0, 2.0).unary(Unary::Square), Interval::new(0.0, 4.0));
        assert_eq!(Interval::new(-1.0, 2.0).powi(3), Interval::new(-1.0, 8.0));
    }
}
