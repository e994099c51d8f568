//! Real roots of polynomials in one variable.
//!
//! Coefficients are written lowest power first: `c[0] + c[1] t + c[2] t² + …`.
//!
//! Signs of Bernstein coefficients part the roots where rounding lets them ([`bernstein`]). Else the roots of
//! the derivative are sought, and theirs before: the roots of the derivative cut the range into pieces on which the polynomial is monotone; each piece
//! whose ends differ in sign holds exactly one root, which Newton's method finds inside a shrinking
//! bracket. Whether there is a root is decided by signs alone, so a ray that starts just outside a surface
//! and leaves it cannot meet it again at a distance of a few roundings. No coefficient is ever taken for
//! zero because it is small; leading coefficients that are exactly 0 are dropped.
//!
//! Reference: C. Yuksel, "High-Performance Polynomial Root Finding for Graphics", HPG 2022.

mod bernstein;

use super::{EPSILON, Range};
use bernstein::isolate;
use smallvec::SmallVec;

/// Roots in ascending order.
pub type Roots = SmallVec<[f64; 6]>;

/// Most bracketed Newton steps: halving alone goes from any range of doubles to a root that is 10^30 times smaller
/// in so many.
const MAX_STEPS: usize = 256;

/// A value below this many roundings of the sum of the terms' sizes counts as touching zero.
const TOUCH: f64 = 32.0 * EPSILON;

/// What to report where the polynomial reaches zero without changing its sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Touching {
    /// Nothing: only sign changes are crossings.
    Skip,
    /// One root, also where rounding keeps the polynomial a little off zero.
    Once,
}

/// Value at `t`.
#[inline(always)]
pub fn value(c: &[f64], t: f64) -> f64 {
    let mut sum = 0.0;
    for i in (0..c.len()).rev() {
        sum = sum * t + c[i];
    }
    sum
}

/// Value and first derivative at `t`.
#[inline(always)]
pub fn value_and_slope(c: &[f64], t: f64) -> (f64, f64) {
    let (mut f, mut d) = (0.0, 0.0);
    for i in (0..c.len()).rev() {
        (f, d) = (f * t + c[i], d * t + f);
    }
    (f, d)
}

/// Sum of the absolute values of the terms at `t`: what rounding errors are measured by.
pub fn magnitude(c: &[f64], t: f64) -> f64 {
    let (t, mut sum) = (t.abs(), 0.0);
    for i in (0..c.len()).rev() {
        sum = sum * t + c[i].abs();
    }
    sum
}

/// How exact the places are where a derivative changes its sign, as a part of their distance from 0: next to a
/// turn a polynomial differs from its value there by the square of this, which is less than rounding.
const CLOSE: f64 = 1e-9;
/// How exact roots are.
const EXACT: f64 = 2.0 * EPSILON;

/// What is asked for.
#[derive(Clone, Copy, Debug)]
struct Wanted {
    touching: Touching,
    close: f64,
    /// The smallest root only.
    first: bool,
}

/// The roots strictly inside `range`.
pub fn roots(c: &[f64], range: Range, touching: Touching) -> Roots {
    wanted_roots(c, range, Wanted { touching, close: EXACT, first: false })
}

fn wanted_roots(c: &[f64], range: Range, wanted: Wanted) -> Roots {
    let c = trimmed(c);
    let mut out = Roots::new();
    if c.len() < 2 || c.iter().any(|k| !k.is_finite()) {
        return out;
    }
    let (mut lo, mut hi) = (range.min, range.max);
    if !(lo.is_finite() && hi.is_finite()) {
        let bound = root_bound(c);
        (lo, hi) = (lo.max(-bound), hi.min(bound));
    }
    if lo < hi {
        collect(c, lo, hi, wanted, &mut out);
    }
    out
}

/// The smallest root strictly inside `range`.
pub fn first_root(c: &[f64], range: Range, touching: Touching) -> Option<f64> {
    wanted_roots(c, range, Wanted { touching, close: EXACT, first: true }).first().copied()
}

/// The sign changes between two ends whose values the caller knows, so that pieces of a curve agree about
/// the points where they meet. A value of 0 counts as positive.
pub fn sign_changes(c: &[f64], low: (f64, f64), high: (f64, f64)) -> Roots {
    let mut out = Roots::new();
    let c = trimmed(c);
    let positive = |f: f64| if f == 0.0 { f64::MIN_POSITIVE } else { f };
    let (low, high) = ((low.0, positive(low.1)), (high.0, positive(high.1)));
    if c.len() < 3 {
        if (low.1 < 0.0) != (high.1 < 0.0) {
            let root = if c.len() == 2 { -c[0] / c[1] } else { 0.5 * (low.0 + high.0) };
            out.push(root.max(low.0).min(high.0));
        }
        return out;
    }
    if isolated(c, low, high, false, &mut out) {
        return out;
    }
    let slope = derivative(c);
    let mut turns = Roots::new();
    let changes = Wanted { touching: Touching::Skip, close: CLOSE, first: false };
    collect(trimmed(&slope), low.0, high.0, changes, &mut turns);
    between_turns(c, low, high, &turns, Wanted { close: EXACT, ..changes }, &mut out);
    out
}

/// `a * b`.
#[inline(always)]
pub fn product<const A: usize, const B: usize, const N: usize>(a: [f64; A], b: [f64; B]) -> [f64; N] {
    let mut out = [0.0; N];
    for i in 0..A {
        for j in 0..B {
            out[i + j] += a[i] * b[j];
        }
    }
    out
}

fn trimmed(c: &[f64]) -> &[f64] {
    let n = c.iter().rposition(|&k| k != 0.0).map_or(0, |i| i + 1);
    &c[..n]
}

/// Fujiwara's bound: no root has a larger absolute value. Capped so that powers do not overflow.
fn root_bound(c: &[f64]) -> f64 {
    let n = c.len() - 1;
    let lead = c[n];
    let largest = (0..n).map(|i| root_above((c[i] / lead).abs(), n - i)).fold(0.0, f64::max);
    (2.0 * largest * (1.0 + 8.0 * EPSILON)).min(10f64.powf(140.0 / n as f64))
}

/// The `n`th root of `v`, or something up to twice as large.
fn root_above(v: f64, n: usize) -> f64 {
    match n {
        1 => v,
        2 => v.sqrt(),
        4 => v.sqrt().sqrt(),
        _ if v == 0.0 || !v.is_normal() => v.powf(1.0 / n as f64),
        _ => {
            // v is less than the power of two with the next exponent.
            let exponent = ((v.to_bits() >> 52) & 0x7ff) as i64 - 1022;
            let root = -(-exponent).div_euclid(n as i64);
            f64::from_bits(((root + 1023) as u64) << 52)
        }
    }
}

fn collect(c: &[f64], lo: f64, hi: f64, wanted: Wanted, out: &mut Roots) {
    let touching = wanted.touching;
    match c.len() {
        0 | 1 => {}
        2 => push_inside(-c[0] / c[1], lo, hi, out),
        3 => quadratic(c, lo, hi, touching, out),
        _ if parted(c, lo, hi, wanted, out) => {}
        4..=8 => through_derivatives::<8>(c, lo, hi, wanted, out),
        _ => through_derivatives::<MAX_COEFFICIENTS>(c, lo, hi, wanted, out),
    }
}

/// Whether the signs of Bernstein coefficients tell the roots, which are appended then.
fn parted(c: &[f64], lo: f64, hi: f64, wanted: Wanted, out: &mut Roots) -> bool {
    wanted.close == EXACT
        && isolated(c, (lo, value_beside(c, lo, 1.0)), (hi, value_beside(c, hi, -1.0)), wanted.first, out)
}

/// The same between two ends with known values.
fn isolated(c: &[f64], low: (f64, f64), high: (f64, f64), first: bool, out: &mut Roots) -> bool {
    fn of<const N: usize>(
        c: &[f64],
        low: (f64, f64),
        high: (f64, f64),
        first: bool,
        out: &mut Roots,
    ) -> bool {
        c.first_chunk::<N>().is_some_and(|c| isolate(c, low, high, first, out))
    }
    if low.1 == 0.0 || high.1 == 0.0 {
        return false;
    }
    match c.len() {
        4 => of::<4>(c, low, high, first, out),
        5 => of::<5>(c, low, high, first, out),
        6 => of::<6>(c, low, high, first, out),
        7 => of::<7>(c, low, high, first, out),
        9 => of::<9>(c, low, high, first, out),
        11 => of::<11>(c, low, high, first, out),
        _ => false,
    }
}

/// Polynomials with more coefficients are not solved.
pub const MAX_COEFFICIENTS: usize = 40;

/// Roots between those of the derivative, which lie between those of the next, up from the quadratic one.
fn through_derivatives<const N: usize>(c: &[f64], lo: f64, hi: f64, wanted: Wanted, out: &mut Roots) {
    let n = c.len();
    if n > N {
        return;
    }
    let mut levels = [[0.0; N]; N];
    levels[0][..n].copy_from_slice(c);
    for k in 1..=n - 3 {
        for i in 0..n - k {
            levels[k][i] = (i + 1) as f64 * levels[k - 1][i + 1];
        }
    }
    let turning = Wanted { touching: Touching::Skip, close: CLOSE, first: false };
    let mut turns = Roots::new();
    quadratic(&levels[n - 3][..3], lo, hi, Touching::Skip, &mut turns);
    for k in (0..n - 3).rev() {
        let p = &levels[k][..n - k];
        let (low, high) = ((lo, value_beside(p, lo, 1.0)), (hi, value_beside(p, hi, -1.0)));
        let mut next = Roots::new();
        between_turns(p, low, high, &turns, if k == 0 { wanted } else { turning }, &mut next);
        turns = next;
    }
    out.append(&mut turns);
}

fn push_inside(t: f64, lo: f64, hi: f64, out: &mut Roots) {
    if t > lo && t < hi {
        out.push(t);
    }
}

fn derivative(c: &[f64]) -> SmallVec<[f64; 8]> {
    c.iter().enumerate().skip(1).map(|(i, &k)| i as f64 * k).collect()
}

/// Both roots of `c[0] + c[1] t + c[2] t²` without cancellation.
fn quadratic(c: &[f64], lo: f64, hi: f64, touching: Touching, out: &mut Roots) {
    let (a, half_b) = (c[2], 0.5 * c[1]);
    let disc = half_b * half_b - a * c[0];
    if disc <= 0.0 {
        if touching == Touching::Once && disc >= -TOUCH * (half_b * half_b + (a * c[0]).abs()) {
            push_inside(-half_b / a, lo, hi, out);
        }
        return;
    }
    let q = -(half_b + disc.sqrt().copysign(half_b));
    let (r0, r1) = if q == 0.0 { (-(disc.sqrt() / a), disc.sqrt() / a) } else { (q / a, c[0] / q) };
    push_inside(r0.min(r1), lo, hi, out);
    push_inside(r0.max(r1), lo, hi, out);
}

/// One root per monotone piece whose ends differ in sign. `turns` are the derivative's sign changes.
fn between_turns(
    c: &[f64],
    low: (f64, f64),
    high: (f64, f64),
    turns: &[f64],
    wanted: Wanted,
    out: &mut Roots,
) {
    let mut left = low;
    for (i, &x) in turns.iter().chain(std::iter::once(&high.0)).enumerate() {
        let is_end = i == turns.len();
        let f = if is_end { high.1 } else { value(c, x) };
        if wanted.first && !out.is_empty() {
            return;
        }
        if wanted.touching == Touching::Once && !is_end && f.abs() <= TOUCH * magnitude(c, x) {
            push_distinct(x, out);
            // The sign beyond comes from the next turn; a root is not sought in the two pieces beside.
            left = (x, 0.0);
            continue;
        }
        if f == 0.0 {
            continue;
        }
        if left.1 != 0.0 && (left.1 < 0.0) != (f < 0.0) {
            push_distinct(bracketed(c, left, (x, f), wanted.close), out);
        }
        left = (x, f);
    }
}

fn push_distinct(t: f64, out: &mut Roots) {
    if out.last().is_none_or(|&last| t > last) {
        out.push(t);
    }
}

/// The value at `x`; where it is 0, something with the sign that it has a little further in direction
/// `side` (1 or -1).
fn value_beside(c: &[f64], x: f64, side: f64) -> f64 {
    let here = value(c, x);
    if here != 0.0 {
        return here;
    }
    let mut k: SmallVec<[f64; 8]> = c.into();
    let mut sign = 1.0;
    while !k.is_empty() {
        let f = value(&k, x);
        if f != 0.0 {
            return sign * f;
        }
        k = derivative(&k);
        sign *= side;
    }
    0.0
}

/// The root between two ends with values of different sign: Newton's method, with a bisection whenever a
/// step leaves the bracket or is not half as long as the one before the last.
#[inline(always)]
fn bracketed(c: &[f64], left: (f64, f64), right: (f64, f64), closeness: f64) -> f64 {
    let (mut lo, mut hi) = (left.0, right.0);
    let rising = left.1 < 0.0;
    let mut x = lo + (hi - lo) * (left.1 / (left.1 - right.1)).clamp(0.05, 0.95);
    // The step before the last one, and the last.
    let (mut before, mut last) = (hi - lo, hi - lo);
    for _ in 0..MAX_STEPS {
        let (f, d) = value_and_slope(c, x);
        if f == 0.0 {
            return x;
        }
        if (f < 0.0) == rising {
            lo = x;
        } else {
            hi = x;
        }
        let newton = x - f / d;
        let step = (newton - x).abs();
        if step <= closeness * x.abs() && newton >= lo && newton <= hi {
            return newton;
        }
        let shrinks = newton > lo && newton < hi && step <= 0.5 * before;
        let next = if shrinks { newton } else { lo + 0.5 * (hi - lo) };
        if next <= lo || next >= hi {
            return next;
        }
        (before, last) = (last, (next - x).abs());
        x = next;
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Coefficients of the product of (t - r) over all roots.
    fn from_roots(roots: &[f64]) -> Vec<f64> {
        let mut c = vec![1.0];
        for &r in roots {
            let mut next = vec![0.0; c.len() + 1];
            for (i, &k) in c.iter().enumerate() {
                next[i + 1] += k;
                next[i] -= r * k;
            }
            c = next;
        }
        c
    }

    #[test]
    fn separated_roots_come_back() {
        let cases: [&[f64]; 5] = [
            &[0.3, 0.7],
            &[-2.5, 0.125, 3.0],
            &[-1.75, -0.5, 0.25, 4.0],
            &[-3.0, -1.0, 0.5, 1.0, 2.5],
            &[-2.0, -1.0, -0.5, 0.5, 1.5, 2.5, 3.25],
        ];
        for expected in cases {
            let found = roots(&from_roots(expected), Range::LINE, Touching::Skip);
            assert_eq!(found.len(), expected.len(), "{expected:?} {found:?}");
            for (f, e) in found.iter().zip(expected) {
                assert!((f - e).abs() <= 1e-12 * e.abs().max(1.0), "{f} {e}");
            }
        }
    }

    #[test]
    fn a_double_root_is_one_touch() {
        let c = from_roots(&[1.5, 1.5, -0.25, 4.0]);
        assert_eq!(roots(&c, Range::LINE, Touching::Skip).len(), 2);
        let all = roots(&c, Range::LINE, Touching::Once);
        assert_eq!(all.len(), 3, "{all:?}");
        assert!((all[1] - 1.5).abs() < 1e-7);
    }

    #[test]
    fn close_pairs_are_kept_apart() {
        let found = roots(&from_roots(&[1.0, 1.0 + 1e-6, 2.0, 3.0]), Range::LINE, Touching::Skip);
        assert_eq!(found.len(), 4);
        assert!((found[1] - found[0] - 1e-6).abs() < 1e-8);
    }

    #[test]
    fn a_start_on_a_root_is_not_a_root() {
        let c = from_roots(&[0.0, 1.0, 2.0, 5.0]);
        let found = roots(&c, Range::FORWARD, Touching::Skip);
        assert_eq!(found.len(), 3);
        assert!(found[0] > 0.5);
    }

    #[test]
    fn a_triple_root_is_a_crossing() {
        let found = roots(&from_roots(&[0.5, 0.5, 0.5, 2.0]), Range::LINE, Touching::Skip);
        assert_eq!(found.len(), 2, "{found:?}");
        assert!((found[0] - 0.5).abs() < 1e-4);
    }

    #[test]
    fn tiny_leading_coefficients_do_no_harm() {
        let found = roots(&[-6.0, 11.0, -6.0, 1.0, 1e-18], Range::new(0.0, 100.0), Touching::Skip);
        assert_eq!(found.len(), 3);
        assert!((found[2] - 3.0).abs() < 1e-12);
    }

    #[test]
    fn degenerate_input_has_no_roots() {
        assert!(roots(&[], Range::LINE, Touching::Once).is_empty());
        assert!(roots(&[1.0], Range::LINE, Touching::Once).is_empty());
        assert!(roots(&[0.0, 0.0, 0.0], Range::LINE, Touching::Once).is_empty());
        assert!(roots(&[f64::NAN, 1.0], Range::LINE, Touching::Once).is_empty());
    }
}
