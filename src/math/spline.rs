//! Curves through knots `(t, P)`: `spline { … }`.
//!
//! | kind | curve |
//! |---|---|
//! | linear | straight pieces |
//! | quadratic | in `[t_k, t_k+1]` the parabola through knots k-1, k, k+1; in the first piece through 0, 1, 2 |
//! | cubic | Catmull-Rom: Hermite pieces between the second and the last knot but one |
//! | natural | twice continuously differentiable, second derivative 0 at both ends |
//!
//! Before the first knot and after the last the end value holds; a cubic spline has no piece before the
//! second knot nor after the last but one, and holds those knots' values there.
//!
//! Numerical care: pieces are evaluated from differences to their own knots, so that a far-away `t` origin
//! costs no digits; the tridiagonal system of the natural spline is diagonally dominant, so elimination
//! without pivoting is stable.
//!
//! References: E. Catmull and R. Rom, "A class of local interpolating splines", 1974; C. de Boor, "A
//! Practical Guide to Splines", 1978, chapter IV.

use std::sync::OnceLock;

/// Up to five components; those beyond the spline's dimension are 0.
pub type SplineValue = [f64; 5];

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SplineKind {
    #[default]
    Linear,
    Quadratic,
    Cubic,
    Natural,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Knot {
    t: f64,
    value: SplineValue,
}

/// A curve of 2 to 5 components over one parameter.
#[derive(Clone, Debug)]
pub struct Spline {
    pub kind: SplineKind,
    dimension: usize,
    /// Ascending in `t`.
    knots: Vec<Knot>,
    /// Second derivatives at the knots of the natural curve, found when it is first asked for.
    bends: OnceLock<Vec<SplineValue>>,
}

impl Spline {
    pub fn new(kind: SplineKind) -> Self {
        Self { kind, dimension: 2, knots: Vec::new(), bends: OnceLock::new() }
    }

    /// Adds a knot of `dimension` components. One at the same `t` is replaced, except that the last of
    /// several keeps its value, as the reference has it. One at no number has no place and is left out.
    pub fn insert(&mut self, t: f64, dimension: usize, value: SplineValue) {
        self.dimension = self.dimension.max(dimension);
        self.bends = OnceLock::new();
        if t.is_nan() {
            return;
        }
        let at = self.knots.partition_point(|k| k.t < t);
        let knot = Knot { t, value };
        match self.knots.get(at) {
            Some(k) if k.t == t => {
                if at == 0 || at + 1 < self.knots.len() {
                    self.knots[at] = knot;
                }
            }
            _ => self.knots.insert(at, knot),
        }
    }

    /// The number of components, 2 to 5.
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    pub fn is_empty(&self) -> bool {
        self.knots.is_empty()
    }

    /// The point at `t`; zero for a spline without knots.
    pub fn value(&self, t: f64) -> SplineValue {
        self.value_as(t, self.kind)
    }

    /// The point at `t` of the curve of another kind through the same knots.
    pub fn value_as(&self, t: f64, kind: SplineKind) -> SplineValue {
        let (Some(first), Some(last)) = (self.knots.first(), self.knots.last()) else {
            return [0.0; 5];
        };
        if self.knots.len() == 1 {
            return first.value;
        }
        if kind == SplineKind::Cubic {
            return self.cubic(t);
        }
        if t <= first.t {
            return first.value;
        }
        if t >= last.t {
            return last.value;
        }
        let k = self.piece(t);
        match kind {
            SplineKind::Quadratic if self.knots.len() > 2 => self.quadratic(k, t),
            SplineKind::Natural if self.knots.len() > 2 => self.natural(k, t),
            _ => self.linear(k, t),
        }
    }

    /// The piece `k` with `t_k <= t < t_k+1`, or the nearest end's.
    fn piece(&self, t: f64) -> usize {
        self.knots.partition_point(|k| k.t <= t).saturating_sub(1).min(self.knots.len() - 2)
    }

    fn linear(&self, k: usize, t: f64) -> SplineValue {
        let (a, b) = (&self.knots[k], &self.knots[k + 1]);
        let s = (t - a.t) / (b.t - a.t);
        each(|i| a.value[i] + s * (b.value[i] - a.value[i]))
    }

    /// Newton's form of the parabola through three knots.
    fn quadratic(&self, k: usize, t: f64) -> SplineValue {
        let k = k.saturating_sub(1);
        let (a, b, c) = (&self.knots[k], &self.knots[k + 1], &self.knots[k + 2]);
        each(|i| {
            let ab = (b.value[i] - a.value[i]) / (b.t - a.t);
            let bc = (c.value[i] - b.value[i]) / (c.t - b.t);
            let curvature = (bc - ab) / (c.t - a.t);
            a.value[i] + (t - a.t) * (ab + (t - b.t) * curvature)
        })
    }

    fn cubic(&self, t: f64) -> SplineValue {
        let n = self.knots.len() - 1;
        if n == 1 {
            return each(|i| 0.5 * (self.knots[0].value[i] + self.knots[1].value[i]));
        }
        // Also where t is no number, as the reference has it.
        if !(t > self.knots[1].t) {
            return self.knots[1].value;
        }
        if t >= self.knots[n - 1].t {
            return self.knots[n - 1].value;
        }
        let k = self.piece(t);
        let [before, a, b, after] = [k - 1, k, k + 1, k + 2].map(|j| &self.knots[j]);
        let h = b.t - a.t;
        let s = (t - a.t) / h;
        each(|i| {
            let slope = (b.value[i] - a.value[i]) / h;
            let slope_a = 0.5 * ((a.value[i] - before.value[i]) / (a.t - before.t) + slope);
            let slope_b = 0.5 * (slope + (after.value[i] - b.value[i]) / (after.t - b.t));
            let (down, up) = (1.0 - s, s);
            a.value[i] * down * down * (1.0 + 2.0 * up)
                + b.value[i] * up * up * (1.0 + 2.0 * down)
                + h * up * down * (slope_a * down - slope_b * up)
        })
    }

    fn natural(&self, k: usize, t: f64) -> SplineValue {
        let bends = self.bends.get_or_init(|| self.solve_bends());
        let (a, b) = (&self.knots[k], &self.knots[k + 1]);
        let h = b.t - a.t;
        let (up, down) = ((t - a.t) / h, (b.t - t) / h);
        each(|i| {
            let sag = (down * down - 1.0) * down * bends[k][i] + (up * up - 1.0) * up * bends[k + 1][i];
            down * a.value[i] + up * b.value[i] + sag * h * h / 6.0
        })
    }

    /// Second derivatives at all knots: `h_k-1 M_k-1 + 2 (h_k-1 + h_k) M_k + h_k M_k+1 = 6 (slope_k -
    /// slope_k-1)` with `M` 0 at both ends, by elimination.
    fn solve_bends(&self) -> Vec<SplineValue> {
        let n = self.knots.len();
        let mut bends = vec![[0.0; 5]; n];
        let mut factors = vec![0.0; n];
        for k in 1..n - 1 {
            let [a, b, c] = [k - 1, k, k + 1].map(|j| &self.knots[j]);
            let (before, after) = (b.t - a.t, c.t - b.t);
            let pivot = 2.0 * (before + after) - before * factors[k - 1];
            factors[k] = after / pivot;
            let above = bends[k - 1];
            bends[k] = each(|i| {
                let turn = (c.value[i] - b.value[i]) / after - (b.value[i] - a.value[i]) / before;
                (6.0 * turn - before * above[i]) / pivot
            });
        }
        for k in (1..n - 1).rev() {
            let next = bends[k + 1];
            bends[k] = each(|i| bends[k][i] - factors[k] * next[i]);
        }
        bends
    }
}

fn each(f: impl Fn(usize) -> f64) -> SplineValue {
    std::array::from_fn(f)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spline(knots: &[(f64, [f64; 3])]) -> Spline {
        let mut s = Spline::new(SplineKind::Linear);
        for &(t, [x, y, z]) in knots {
            s.insert(t, 3, [x, y, z, 0.0, 0.0]);
        }
        s
    }

    /// The splines of `tests/data/spline-oracle.csv`, by name.
    fn oracle_spline(name: &str) -> Spline {
        let s1 = [(0.0, [0., 0., 0.]), (1.0, [1., 2., 3.]), (3.0, [2., 2., 2.]), (4.0, [0., 1., 5.])];
        let s4 = [(2.0, [1., 2., 5.]), (0.5, [3., 2., 1.]), (5.0, [-1., -2., 4.])];
        let s5 = [
            (5.0, [1., 1., 1.]),
            (0.0, [0., 0., 0.]),
            (3.0, [2., 2., 2.]),
            (1.0, [1., 2., 3.]),
            (4.0, [0., 1., 5.]),
            (3.0, [2.5, 2., 1.]),
        ];
        match name {
            "S1" => spline(&s1),
            "S2" => spline(&s4[..1]),
            "S3" => spline(&s4[..2]),
            "S4" => spline(&s4),
            "S5" => spline(&s5),
            _ => {
                let mut s = spline(&s5);
                s.insert(2.0, 3, [0., 7., 0., 0., 0.]);
                s.insert(5.0, 3, [9., 9., 9., 0., 0.]);
                s
            }
        }
    }

    #[test]
    fn agrees_with_the_reference() {
        let kinds = [SplineKind::Linear, SplineKind::Quadratic, SplineKind::Cubic, SplineKind::Natural];
        let rows = include_str!("../../tests/data/spline-oracle.csv").lines().filter(|l| !l.starts_with('#'));
        let mut count = 0;
        for row in rows {
            let fields: Vec<&str> = row.split(',').collect();
            let numbers: Vec<f64> = fields[1..].iter().map(|f| f.parse().unwrap()).collect();
            let s = oracle_spline(fields[0]);
            for (kind, expected) in kinds.iter().zip(numbers[1..].chunks(3)) {
                let value = s.value_as(numbers[0], *kind);
                for i in 0..3 {
                    assert!((value[i] - expected[i]).abs() < 2e-12, "{row}: {kind:?} gives {value:?}");
                }
            }
            count += 1;
        }
        assert_eq!(count, 132);
    }

    #[test]
    fn keeps_digits_far_from_the_origin() {
        let near = oracle_spline("S5");
        let mut far = Spline::new(SplineKind::Linear);
        for k in &near.knots {
            far.insert(k.t + 1048576.0, 3, k.value);
        }
        for kind in [SplineKind::Quadratic, SplineKind::Cubic, SplineKind::Natural] {
            let (a, b) = (near.value_as(2.25, kind), far.value_as(1048578.25, kind));
            assert!((0..3).all(|i| (a[i] - b[i]).abs() < 1e-14), "{kind:?}: {a:?} {b:?}");
        }
    }

    #[test]
    fn dimension_is_the_largest_given() {
        let mut s = Spline::new(SplineKind::Linear);
        s.insert(0.0, 2, [1.0, 1.0, 0.0, 0.0, 0.0]);
        assert_eq!(s.dimension(), 2);
        s.insert(1.0, 5, [1.0, 2.0, 3.0, 4.0, 5.0]);
        assert_eq!(s.dimension(), 5);
        assert_eq!(s.value(0.5), [1.0, 1.5, 1.5, 2.0, 2.5]);
    }

    #[test]
    fn what_is_no_number_has_no_place() {
        let corner = |i: usize| std::array::from_fn(|k| if k == i { 1.0 } else { 0.0 });
        for kind in [SplineKind::Linear, SplineKind::Quadratic, SplineKind::Cubic, SplineKind::Natural] {
            let mut s = Spline::new(kind);
            (0..4).for_each(|i| s.insert(i as f64, 3, corner(i)));
            s.insert(f64::NAN, 3, corner(4));
            assert_eq!((s.knots.len(), s.value(1.0)), (4, corner(1)));
            let nowhere = s.value(f64::NAN);
            // As measured.
            assert!(if kind == SplineKind::Cubic { nowhere == corner(1) } else { nowhere[0].is_nan() });
        }
    }
}
