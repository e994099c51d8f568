//! A box around an algebraic surface, if there is one.
//!
//! Far from the origin the terms of the highest degree decide. Where these are of one sign in all directions, a
//! cube can be given outside of which the others cannot make up for them; from all sides parts are then cut
//! off it in which interval arithmetic finds no zero. Every step is a proof: a surface for which none is
//! found within a fixed number of trials counts as unbounded.
//!
//! Numerical care: an interval is widened by far more than its rounding, and by what the roots' search takes
//! for touching.
//!
//! Reference: R. Moore, R. Kearfott, M. Cloud, "Introduction to Interval Analysis", SIAM 2009, chapters 5 and 6.

use super::Algebraic;
use crate::math::{Aabb, Vec3};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Least and greatest value.
#[derive(Clone, Copy)]
struct Interval(f64, f64);

/// A part of space with what it is looked at for; the largest key comes first.
struct Cell {
    key: f64,
    part: Aabb,
}

/// How many parts of space are looked at for each side, and for the terms of highest degree.
const TRIALS: usize = 400;
/// Sides are found to this part of the width.
const PRECISION: f64 = 1.0 / 64.0;
/// Bound on the rounding of a value, as a part of the sum of its terms' sizes.
const ROUNDING: f64 = 1e-10;

impl Interval {
    fn times(self, o: Interval) -> Interval {
        let p = [self.0 * o.0, self.0 * o.1, self.1 * o.0, self.1 * o.1];
        Interval(p[0].min(p[1]).min(p[2].min(p[3])), p[0].max(p[1]).max(p[2].max(p[3])))
    }

    fn plus(self, o: Interval) -> Interval {
        Interval(self.0 + o.0, self.1 + o.1)
    }

    fn largest(self) -> f64 {
        self.0.abs().max(self.1.abs())
    }
}

impl PartialEq for Cell {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Cell {}

impl PartialOrd for Cell {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Cell {
    fn cmp(&self, other: &Self) -> Ordering {
        self.key.total_cmp(&other.key)
    }
}

/// Both halves across the longest side.
fn halves(part: Aabb) -> [Aabb; 2] {
    let axis = part.size().max_position();
    let middle = 0.5 * (part.min[axis] + part.max[axis]);
    let (mut low, mut high) = (part, part);
    low.max[axis] = middle;
    high.min[axis] = middle;
    [low, high]
}

impl Algebraic {
    /// A box around the surface, and whether the polynomial is negative all over outside of it.
    pub(super) fn extent(&self) -> Option<(Aabb, bool)> {
        let degree = self.degree()?;
        if degree % 2 == 1 {
            return None;
        }
        let top = self.of_degree(|d| d == degree);
        let negative = top.value(Vec3::X) < 0.0;
        let least = top.least_size(negative)?;
        let reach = self.reach(degree, least)?;
        let mut bounds = Aabb::new(Vec3::splat(-reach), Vec3::splat(reach));
        for axis in 0..3 {
            for upper in [false, true] {
                let side = self.side(bounds, axis, upper)?;
                if upper { bounds.max[axis] = side } else { bounds.min[axis] = side }
            }
        }
        let bounds = bounds.grown(1e-9 * reach);
        (bounds.is_finite() && !bounds.is_empty()).then_some((bounds, negative))
    }

    /// Beyond this coordinate the terms of the highest degree, no smaller than `least` on the unit cube, are
    /// larger than all others together: Fujiwara's bound.
    fn reach(&self, degree: usize, least: f64) -> Option<f64> {
        let mut reach = 0.0f64;
        for d in 0..degree {
            let size = self.of_degree(|k| k == d).magnitude(Vec3::ONE);
            reach = reach.max((size / least).powf(1.0 / (degree - d) as f64));
        }
        let reach = 2.0 * (1.0 + 1e-9) * reach;
        (reach > 0.0 && reach.is_finite()).then_some(reach)
    }

    /// A number that a form of even degree is not below (not above its negative, if it is to be negative) on
    /// the surface of the unit cube.
    fn least_size(&self, negative: bool) -> Option<f64> {
        let sign = if negative { -1.0 } else { 1.0 };
        let lower = |part: Aabb| {
            let v = self.range(&part);
            Cell { key: if negative { v.1 } else { -v.0 }, part }
        };
        let mut cells = BinaryHeap::new();
        for axis in 0..3 {
            let mut face = Aabb::new(Vec3::NEG_ONE, Vec3::ONE);
            face.min[axis] = 1.0;
            cells.push(lower(face));
        }
        let mut seen = f64::INFINITY;
        for _ in 0..TRIALS {
            let worst = cells.pop()?;
            seen = seen.min(sign * self.value(worst.part.center()));
            if !(seen > 0.0) {
                return None;
            }
            if -worst.key > 0.5 * seen {
                return Some(-worst.key);
            }
            cells.extend(halves(worst.part).map(lower));
        }
        let worst = cells.pop()?;
        (-worst.key > 0.0).then_some(-worst.key)
    }

    /// The lower or upper side, along one axis, of the part of `bounds` in which there may be zeros.
    fn side(&self, bounds: Aabb, axis: usize, upper: bool) -> Option<f64> {
        let cell = |part: Aabb| {
            let v = self.range(&part);
            let key = if upper { part.max[axis] } else { -part.min[axis] };
            (v.0 <= 0.0 && v.1 >= 0.0).then_some(Cell { key, part })
        };
        let precise = PRECISION * bounds.size()[axis];
        let mut cells = BinaryHeap::new();
        cells.extend(cell(bounds));
        for _ in 0..TRIALS {
            let outermost = cells.peek()?;
            if outermost.part.size()[axis] <= precise {
                break;
            }
            let part = cells.pop()?.part;
            cells.extend(halves(part).into_iter().filter_map(cell));
        }
        let key = cells.peek()?.key;
        Some(if upper { key } else { -key })
    }

    /// Bounds of the values in a part of space: those of Horner's rule and those by the slopes from its middle.
    fn range(&self, part: &Aabb) -> Interval {
        let sides: [Interval; 3] = std::array::from_fn(|i| Interval(part.min[i], part.max[i]));
        let zero = [Interval(0.0, 0.0); 4];
        let [value, slopes @ ..] = self.horner(
            || zero,
            |v, axis| {
                let value = v[0];
                v.iter_mut().for_each(|k| *k = k.times(sides[axis]));
                v[axis + 1] = v[axis + 1].plus(value);
            },
            |v, w| v.iter_mut().zip(w).for_each(|(a, b)| *a = a.plus(*b)),
            |v, c| v[0] = v[0].plus(Interval(c, c)),
        );
        let half = 0.5 * part.size();
        let change: f64 = (0..3).map(|i| slopes[i].largest() * half[i]).sum();
        let middle = self.value(part.center());
        let slack = ROUNDING * self.magnitude(part.min.abs().max(part.max.abs()));
        Interval(value.0.max(middle - change) - slack, value.1.min(middle + change) + slack)
    }

    /// The highest degree of a term; `None` without any.
    fn degree(&self) -> Option<usize> {
        (0..=self.order).rev().find(|&d| self.of_degree(|k| k == d).magnitude(Vec3::ONE) > 0.0)
    }

    /// The terms of some degrees only.
    fn of_degree(&self, wanted: impl Fn(usize) -> bool) -> Algebraic {
        let mut part = self.clone();
        for plane in &self.planes {
            for line in &self.lines[plane.lines.0..plane.lines.1] {
                let top = line.terms.1 - 1;
                for i in line.terms.0..line.terms.1 {
                    if !wanted(plane.power + line.power + top - i) {
                        part.coefficients[i] = 0.0;
                    }
                }
            }
        }
        part
    }
}
