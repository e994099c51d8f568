//! Roots isolated by the signs of Bernstein coefficients.
//!
//! On an interval a polynomial lies in the convex hull of its Bernstein coefficients, and has as many roots there as
//! they have changes of sign, or an even number fewer (Descartes' rule). No change: no root. One change: one
//! root, between ends of different sign. With more the interval is halved.
//!
//! Numerical care: the ends' signs are those of the values that the caller has; the sign of a coefficient between
//! them counts only if it is larger than a bound on its rounding. Where one is not, the answer is "unclear" and
//! the roots are sought through the derivatives instead, so nothing is decided here that rounding could
//! turn.

use super::{EXACT, Roots, bracketed, magnitude, push_distinct, value};
use crate::math::EPSILON;

/// Intervals are halved so often at most.
const DEEPEST: usize = 10;

/// A part of the interval.
#[derive(Clone, Copy)]
struct Part<const N: usize> {
    coefficients: [f64; N],
    low: (f64, f64),
    high: (f64, f64),
    depth: usize,
}

/// Appends the roots (or just the smallest) of `c` between two ends whose values are known and not 0;
/// false, with nothing appended, where rounding leaves them unclear.
pub(super) fn isolate<const N: usize>(
    c: &[f64; N],
    low: (f64, f64),
    high: (f64, f64),
    first: bool,
    out: &mut Roots,
) -> bool {
    let width = high.0 - low.0;
    let coefficients = transformed(c, low.0, width);
    let error = (16 * N) as f64 * EPSILON * magnitude(c, low.0.abs() + width);
    let whole = Part { coefficients, low, high, depth: 0 };
    match changes(&whole, error) {
        Some(0) => true,
        Some(1) => {
            push_distinct(bracketed(c, low, high, EXACT), out);
            true
        }
        Some(_) => divide(c, &whole, error, first, out),
        None => false,
    }
}

/// The same where there may be several roots.
#[inline(never)]
fn divide<const N: usize>(c: &[f64; N], whole: &Part<N>, error: f64, first: bool, out: &mut Roots) -> bool {
    let before = out.len();
    let mut todo = [*whole; DEEPEST + 1];
    let mut left = 1;
    while left > 0 {
        left -= 1;
        let part = todo[left];
        match changes(&part, error) {
            Some(0) => {}
            Some(1) => {
                push_distinct(bracketed(c, part.low, part.high, EXACT), out);
                if first {
                    return true;
                }
            }
            Some(_) if part.depth < DEEPEST => {
                let middle = 0.5 * (part.low.0 + part.high.0);
                let f = value(c, middle);
                if f.abs() <= error {
                    out.truncate(before);
                    return false;
                }
                (todo[left + 1], todo[left]) = halves(&part, (middle, f));
                left += 2;
            }
            _ => {
                out.truncate(before);
                return false;
            }
        }
    }
    true
}

/// How often the sign changes; `None` where that is not certain.
#[inline(always)]
fn changes<const N: usize>(part: &Part<N>, error: f64) -> Option<u32> {
    let mut count = 0;
    let mut negative = part.low.1 < 0.0;
    for i in 1..N - 1 {
        let b = part.coefficients[i];
        if !(b.abs() > error) {
            return None;
        }
        count += u32::from((b < 0.0) != negative);
        negative = b < 0.0;
    }
    Some(count + u32::from((part.high.1 < 0.0) != negative))
}

/// The Bernstein coefficients on the interval of this width from `low` on.
#[inline(always)]
fn transformed<const N: usize>(c: &[f64; N], low: f64, width: f64) -> [f64; N] {
    let mut a = *c;
    if low != 0.0 {
        for i in 0..N - 1 {
            for j in (i..N - 1).rev() {
                a[j] += low * a[j + 1];
            }
        }
    }
    // Divided by the binomial coefficient of N - 1 over k.
    let mut factor = 1.0;
    for (k, a) in a.iter_mut().enumerate().skip(1) {
        factor *= width * (k as f64 / (N - k) as f64);
        *a *= factor;
    }
    for i in 1..N {
        for j in (i..N).rev() {
            a[j] += a[j - 1];
        }
    }
    a
}

/// Both halves, by de Casteljau's rule; the point between them and the value there are known.
#[inline(always)]
fn halves<const N: usize>(part: &Part<N>, middle: (f64, f64)) -> (Part<N>, Part<N>) {
    let mut right = part.coefficients;
    let mut left = right;
    for (i, left) in left.iter_mut().enumerate().skip(1) {
        for j in 0..N - i {
            right[j] = 0.5 * (right[j] + right[j + 1]);
        }
        *left = right[0];
    }
    let depth = part.depth + 1;
    (
        Part { coefficients: left, low: part.low, high: middle, depth },
        Part { coefficients: right, low: middle, high: part.high, depth },
    )
}
