//! A box around an algebraic surface, if there is one.
//!
//! Far from the origin the terms of the highest degree decide. Where these are of one sign in all directions, a
//! cube can be given outside of which the others cannot make up for them; from all sides parts are then cut
//! off it in which there is no zero, as the polynomial about the part's middle tells. Every step is a proof: a surface for which none is
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

/// All coefficients up to a power, those that are 0 too: of x^i y^j z^k at place (i (n + 1) + j) (n + 1) + k.
struct Dense {
    order: usize,
    coefficients: Vec<f64>,
    /// Those that are not 0, with their powers.
    used: Vec<([usize; 3], f64)>,
}

/// A part of space with what it is looked at for; the largest key comes first.
struct Cell {
    key: f64,
    part: Aabb,
}

/// Polynomials of a higher degree get no box: finding it would take too long.
const LARGEST_DEGREE: usize = 8;
/// How many parts of space are looked at for each side, and for the terms of highest degree.
const TRIALS: usize = 500;
/// Sides are found to this part of the width, at first and in the end.
const PRECISIONS: [f64; 2] = [1.0 / 8.0, 1.0 / 32.0];
/// Bound on the rounding of a value, as a part of the sum of its terms' sizes.
const ROUNDING: f64 = 1e-10;

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
        if self.order > LARGEST_DEGREE {
            return None;
        }
        let all = Dense::new(self);
        let degree: usize = all.used.iter().map(|t| t.0.iter().sum()).max()?;
        if degree % 2 == 1 {
            return None;
        }
        let top = all.of_degree(degree);
        let negative = top.range(&Aabb::new(Vec3::X, Vec3::X)).1 < 0.0;
        let reach = all.reach(degree, top.least_size(negative)?)?;
        let mut bounds = Aabb::new(Vec3::splat(-reach), Vec3::splat(reach));
        for precision in PRECISIONS {
            for axis in 0..3 {
                for upper in [false, true] {
                    let side = all.side(bounds, axis, upper, precision)?;
                    if upper { bounds.max[axis] = side } else { bounds.min[axis] = side }
                }
            }
        }
        let bounds = bounds.grown(1e-9 * reach);
        (bounds.is_finite() && !bounds.is_empty()).then_some((bounds, negative))
    }
}

impl Dense {
    fn new(surface: &Algebraic) -> Self {
        let order = surface.order;
        let side = order + 1;
        let mut coefficients = vec![0.0; side * side * side];
        for plane in &surface.planes {
            for line in &surface.lines[plane.lines.0..plane.lines.1] {
                let terms = &surface.coefficients[line.terms.0..line.terms.1];
                let first = (plane.power * side + line.power) * side;
                terms.iter().rev().enumerate().for_each(|(k, &c)| coefficients[first + k] = c);
            }
        }
        Self::of(order, coefficients)
    }

    fn of(order: usize, coefficients: Vec<f64>) -> Self {
        let mut all = Self { order, coefficients, used: Vec::new() };
        all.used = all.terms().filter(|t| t.1 != 0.0).collect();
        all
    }

    /// Powers and coefficients.
    fn terms(&self) -> impl Iterator<Item = ([usize; 3], f64)> {
        let side = self.order + 1;
        let powers = move |place: usize| [place / (side * side), place / side % side, place % side];
        self.coefficients.iter().enumerate().map(move |(place, &c)| (powers(place), c))
    }

    /// The terms of one degree.
    fn of_degree(&self, degree: usize) -> Dense {
        let kept =
            |(powers, c): ([usize; 3], f64)| if powers.iter().sum::<usize>() == degree { c } else { 0.0 };
        Self::of(self.order, self.terms().map(kept).collect())
    }

    /// Beyond this coordinate the terms of the highest degree, no smaller than `least` on the unit cube, are
    /// larger than all others together: Fujiwara's bound.
    fn reach(&self, degree: usize, least: f64) -> Option<f64> {
        let mut sizes = vec![0.0; degree];
        for &(powers, c) in &self.used {
            if let Some(size) = sizes.get_mut(powers.iter().sum::<usize>()) {
                *size += c.abs();
            }
        }
        let bound = |(d, size): (usize, &f64)| (size / least).powf(1.0 / (degree - d) as f64);
        let reach = 2.0 * (1.0 + 1e-9) * sizes.iter().enumerate().map(bound).fold(0.0, f64::max);
        (reach > 0.0 && reach.is_finite()).then_some(reach)
    }

    /// A number that a form of even degree is not below (not above its negative, if it is to be negative) on
    /// the surface of the unit cube.
    fn least_size(&self, negative: bool) -> Option<f64> {
        let sized = |part: Aabb| {
            let v = self.range(&part);
            Cell { key: if negative { v.1 } else { -v.0 }, part }
        };
        let mut cells = BinaryHeap::new();
        for axis in 0..3 {
            let mut face = Aabb::new(Vec3::NEG_ONE, Vec3::ONE);
            face.min[axis] = 1.0;
            cells.push(sized(face));
        }
        for _ in 0..TRIALS {
            let worst = cells.pop()?;
            let middle = worst.part.center();
            let there = self.range(&Aabb::new(middle, middle));
            let seen = if negative { -there.1 } else { there.0 };
            if !(seen > 0.0) {
                return None;
            }
            if -worst.key > 0.5 * seen {
                return Some(-worst.key);
            }
            cells.extend(halves(worst.part).map(sized));
        }
        let worst = cells.pop()?;
        (-worst.key > 0.0).then_some(-worst.key)
    }

    /// The lower or upper side, along one axis, of the part of `bounds` in which there may be zeros.
    fn side(&self, bounds: Aabb, axis: usize, upper: bool, precision: f64) -> Option<f64> {
        let cell = |part: Aabb| {
            let v = self.range(&part);
            let key = if upper { part.max[axis] } else { -part.min[axis] };
            (v.0 <= 0.0 && v.1 >= 0.0).then_some(Cell { key, part })
        };
        let precise = precision * bounds.size()[axis];
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

    /// Bounds of the values in a part of space: those of the terms, and those of the polynomial about its middle.
    fn range(&self, part: &Aabb) -> (f64, f64) {
        let own = self.range_of_terms(part);
        if own.0 > 0.0 || own.1 < 0.0 {
            return own;
        }
        let middle = self.range_about_middle(part);
        (own.0.max(middle.0), own.1.min(middle.1))
    }

    fn range_of_terms(&self, part: &Aabb) -> (f64, f64) {
        let mut powers = [[(1.0, 1.0); LARGEST_DEGREE + 1]; 3];
        for (axis, powers) in powers.iter_mut().enumerate() {
            let (mut a, mut b) = (1.0, 1.0);
            let (low, high) = (part.min[axis], part.max[axis]);
            let through = low < 0.0 && high > 0.0;
            for power in &mut powers[1..=self.order] {
                (a, b) = (a * low, b * high);
                *power = (if through { a.min(b).min(0.0) } else { a.min(b) }, a.max(b));
            }
        }
        let times = |(a, b): (f64, f64), (c, d): (f64, f64)| {
            let (e, f, g, h) = (a * c, a * d, b * c, b * d);
            (e.min(f).min(g.min(h)), e.max(f).max(g.max(h)))
        };
        let (mut low, mut high, mut slack) = (0.0, 0.0, 0.0);
        for &([i, j, k], c) in &self.used {
            let (a, b) = times(times(powers[0][i], powers[1][j]), times(powers[2][k], (c, c)));
            (low, high) = (low + a, high + b);
            slack += a.abs().max(b.abs());
        }
        (low - ROUNDING * slack, high + ROUNDING * slack)
    }

    fn range_about_middle(&self, part: &Aabb) -> (f64, f64) {
        let (middle, half, far) = (part.center(), 0.5 * part.size(), part.min.abs().max(part.max.abs()));
        let about = self.moved(middle);
        let (mut low, mut high, mut slack) = (0.0, 0.0, 0.0);
        let side = self.order + 1;
        let (mut near_x, mut far_x) = (1.0, 1.0);
        for i in 0..=self.order {
            let (mut near_y, mut far_y) = (near_x, far_x);
            for j in 0..=self.order - i {
                let (mut near_z, mut far_z) = (near_y, far_y);
                for k in 0..=self.order - i - j {
                    let place = (i * side + j) * side + k;
                    slack += (self.coefficients[place] * far_z).abs();
                    let size = about[place] * near_z;
                    if place == 0 {
                        (low, high) = (size, size);
                    } else if (i | j | k) % 2 == 0 {
                        (low, high) = (low + size.min(0.0), high + size.max(0.0));
                    } else {
                        (low, high) = (low - size.abs(), high + size.abs());
                    }
                    (near_z, far_z) = (near_z * half.z, far_z * far.z);
                }
                (near_y, far_y) = (near_y * half.y, far_y * far.y);
            }
            (near_x, far_x) = (near_x * half.x, far_x * far.x);
        }
        (low - ROUNDING * slack, high + ROUNDING * slack)
    }

    /// The coefficients with `to` for the origin: Horner's shift along one axis after the other.
    fn moved(&self, to: Vec3) -> Vec<f64> {
        let side = self.order + 1;
        let strides = [side * side, side, 1];
        let mut c = self.coefficients.clone();
        for axis in 0..3 {
            let (stride, others) = (strides[axis], [strides[(axis + 1) % 3], strides[(axis + 2) % 3]]);
            for j in 0..side {
                for k in 0..side - j {
                    let first = j * others[0] + k * others[1];
                    let top = self.order - j - k;
                    for lowest in 0..top {
                        for n in (lowest..top).rev() {
                            c[first + n * stride] += to[axis] * c[first + (n + 1) * stride];
                        }
                    }
                }
            }
        }
        c
    }
}
