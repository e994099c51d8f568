//! The first zero of a function of one variable, under a bound on its slope.

/// Where a function changes sign: not yet at `near`, at `far`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bracket {
    pub near: (f64, f64),
    pub far: (f64, f64),
}

/// Deepest halving of an interval.
const LARGEST_DEPTH: usize = 64;

/// What the search goes by.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bound {
    /// Between these the function's slope lies.
    pub slopes: (f64, f64),
    /// Intervals shorter than this are not divided.
    pub resolution: f64,
}

impl Bound {
    /// Whether a function with these values at the ends of an interval, the first not negative, cannot be
    /// negative inside.
    pub fn excludes(&self, near: (f64, f64), far: (f64, f64)) -> bool {
        let (low, high) = self.slopes;
        if far.1.is_nan() || far.1 < 0.0 {
            return false;
        }
        // It cannot fall, or cannot rise again.
        if low >= 0.0 || high <= 0.0 {
            return true;
        }
        // Falling and rising as fast as may be, it gets down to this over `high - low`.
        near.1 * high - far.1 * low + low * high * (far.0 - near.0) >= 0.0
    }

    /// Whether a function that is not negative before an interval and negative behind it has one zero in it.
    fn falls(&self) -> bool {
        self.slopes.1 <= 0.0
    }
}

/// The first interval of length `resolution` at whose end `f`, not negative at first, is negative: by
/// halving, earlier halves first, without what the slopes exclude. A longer interval in which the function
/// only falls does as well.
pub(super) fn first_bracket(
    f: &mut impl FnMut(f64) -> f64,
    from: (f64, f64),
    to: (f64, f64),
    bound: &mut impl FnMut((f64, f64), (f64, f64)) -> Bound,
) -> Option<Bracket> {
    let mut near = from;
    // Ends of the intervals still to be searched, the nearest last.
    let mut ends = [(0.0, 0.0); LARGEST_DEPTH];
    ends[0] = to;
    let mut depth = 1;
    while depth > 0 {
        let far = ends[depth - 1];
        let bound = bound(near, far);
        let length = far.0 - near.0;
        let middle = near.0 + 0.5 * length;
        let leaf = length < bound.resolution || depth == LARGEST_DEPTH || middle <= near.0 || middle >= far.0;
        if far.1 < 0.0 && (leaf || bound.falls()) {
            return Some(Bracket { near, far });
        }
        if leaf || bound.excludes(near, far) {
            near = far;
            depth -= 1;
        } else {
            ends[depth] = (middle, f(middle));
            depth += 1;
        }
    }
    None
}

/// Shrinks a bracket until it is no longer than `width`.
///
/// Reference: T. Chandrupatla, "A new hybrid quadratic/bisection algorithm for finding the zero of a nonlinear
/// function without using derivatives", Advances in Engineering Software 28, 1997.
pub(super) fn refine(f: &mut impl FnMut(f64) -> f64, bracket: Bracket, width: f64) -> Bracket {
    /// More steps than halving needs.
    const LARGEST_COUNT: usize = 100;
    // The zero lies between `a`, the latest point, and `b`; `c` is the point before.
    let (mut a, mut b) = (bracket.far, bracket.near);
    let mut part = straight(a, b);
    for _ in 0..LARGEST_COUNT {
        let least = 0.5 * width / (b.0 - a.0).abs();
        if least >= 0.5 {
            break;
        }
        let t = a.0 + part.clamp(least, 1.0 - least) * (b.0 - a.0);
        if t == a.0 || t == b.0 {
            break;
        }
        let value = f(t);
        let c;
        if (value < 0.0) == (a.1 < 0.0) {
            c = a;
        } else {
            c = b;
            b = a;
        }
        a = (t, value);
        part = quadratic(a, b, c).unwrap_or(0.5);
    }
    if a.1 < 0.0 { Bracket { near: b, far: a } } else { Bracket { near: a, far: b } }
}

/// Where the straight line through two points is zero, as a part of the way from `a` to `b`.
fn straight(a: (f64, f64), b: (f64, f64)) -> f64 {
    let part = a.1 / (a.1 - b.1);
    if part.is_finite() { part } else { 0.5 }
}

/// Where the parabola `t(value)` through three points is zero, if it is monotonic between them.
fn quadratic(a: (f64, f64), b: (f64, f64), c: (f64, f64)) -> Option<f64> {
    let xi = (a.0 - b.0) / (c.0 - b.0);
    let phi = (a.1 - b.1) / (c.1 - b.1);
    let monotonic = phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi;
    let along = a.1 / (b.1 - a.1) * c.1 / (b.1 - c.1);
    let bent = (c.0 - a.0) / (b.0 - a.0) * a.1 / (c.1 - a.1) * b.1 / (c.1 - b.1);
    let part = along + bent;
    (monotonic && part.is_finite()).then_some(part)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn search(f: impl Fn(f64) -> f64, to: f64, slope: f64, resolution: f64) -> (Option<Bracket>, usize) {
        let mut count = 0;
        let mut counted = |t: f64| {
            count += 1;
            f(t)
        };
        let ends = [(0.0, f(0.0)), (to, f(to))];
        let found = first_bracket(&mut counted, ends[0], ends[1], &mut |_, _| Bound {
            slopes: (-slope, slope),
            resolution,
        });
        (found, count)
    }

    #[test]
    fn finds_the_first_of_many() {
        for period in [0.1, 0.37, 1.0, 2.9] {
            let f = |t: f64| 0.5 + (t * std::f64::consts::TAU / period).cos();
            let (found, _) = search(f, 10.0, 7.0 / period, 1e-4);
            let found = found.unwrap();
            let zero = period / 3.0;
            assert!(found.near.0 < zero && zero <= found.far.0 && found.far.0 - found.near.0 < 1e-4);
            let refined = refine(&mut |t| f(t), found, 1e-13);
            assert!((refined.far.0 - zero).abs() < 1e-12, "{refined:?} {zero}");
        }
    }

    #[test]
    fn a_true_bound_skips_most_of_the_way() {
        let (found, count) = search(|t| (t - 7.0).abs() - 1.0, 100.0, 1.0, 1e-6);
        assert!((found.unwrap().far.0 - 6.0).abs() < 1e-6);
        assert!(count < 40, "{count}");
    }

    #[test]
    fn no_zero_is_found_where_there_is_none() {
        let (found, count) = search(|t| (t - 7.0) * (t - 7.0) + 1e-3, 14.0, 14.0, 1e-3);
        assert_eq!(found, None);
        assert!(count < 3000, "{count}");
    }

    #[test]
    fn refining_takes_few_steps_and_stops_at_jumps() {
        let smooth: [fn(f64) -> f64; 4] =
            [|t| 1.0 - t * t * t, |t| (1.0 - t).sinh(), |t| 1.0 - t, |t| (2.0 - t * 2.0) * (1.0 + t).powi(9)];
        for f in smooth {
            let mut count = 0;
            let bracket = Bracket { near: (0.9996, f(0.9996)), far: (1.0003, f(1.0003)) };
            let mut counted = |t: f64| {
                count += 1;
                f(t)
            };
            let refined = refine(&mut counted, bracket, 1e-14);
            assert!((refined.far.0 - 1.0).abs() < 2e-14, "{refined:?}");
            assert!(count <= 8, "{count}");
        }
        let jump = |t: f64| if t < 0.7 { 3.0 } else { -1e-9 };
        let bracket = Bracket { near: (0.0, 3.0), far: (1.0, -1e-9) };
        let refined = refine(&mut |t| jump(t), bracket, 1e-12);
        assert!((refined.far.0 - 0.7).abs() < 1e-12);
    }
}
