//! Where a field may change sign: a grid of cells, each of them positive, negative or undecided.

use crate::math::field::Field;
use crate::math::{Aabb, Ray, Vec3};

/// What is known of a field's sign in a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sign {
    Unknown,
    Positive,
    Negative,
}

/// Cells on each side of the grid.
const SIDE: usize = 1 << LEVELS;
const LEVELS: u32 = 5;

/// Cells overlap by this part of their size, so that rounding moves no point out of all of them.
const OVERLAP: f64 = 1e-7;

/// A container divided into cells.
#[derive(Clone, Debug)]
pub(super) struct Cells {
    min: Vec3,
    /// Cells per unit length.
    density: Vec3,
    size: Vec3,
    signs: Vec<Sign>,
}

impl Cells {
    /// `None` if nothing is known of the field anywhere.
    pub fn new(field: &dyn Field, threshold: f64, bounds: &Aabb) -> Option<Self> {
        if !bounds.is_finite() || bounds.volume() <= 0.0 {
            return None;
        }
        let size = bounds.size() / SIDE as f64;
        let mut cells = Self {
            min: bounds.min,
            density: size.recip(),
            size,
            signs: vec![Sign::Unknown; SIDE * SIDE * SIDE],
        };
        cells.divide(field, threshold, [0; 3], LEVELS);
        cells.signs.iter().any(|s| *s != Sign::Unknown).then_some(cells)
    }

    /// Decides a cube of `1 << level` cells a side, or its eight parts.
    fn divide(&mut self, field: &dyn Field, threshold: f64, corner: [usize; 3], level: u32) {
        let side = 1 << level;
        let at = |i: [usize; 3]| self.min + self.size * Vec3::from_array(i.map(|i| i as f64));
        let margin = self.size * OVERLAP;
        let cube = Aabb { min: at(corner) - margin, max: at(corner.map(|c| c + side)) + margin };
        let sign = match field.range(&cube) {
            Some((lo, _)) if lo > threshold => Sign::Positive,
            Some((_, hi)) if hi < threshold => Sign::Negative,
            _ => Sign::Unknown,
        };
        if sign != Sign::Unknown {
            self.fill(corner, side, sign);
        } else if level > 0 {
            let half = side / 2;
            for part in 0..8 {
                let part = [part & 1, part >> 1 & 1, part >> 2].map(|b| b * half);
                self.divide(field, threshold, [0, 1, 2].map(|i| corner[i] + part[i]), level - 1);
            }
        }
    }

    fn fill(&mut self, corner: [usize; 3], side: usize, sign: Sign) {
        for z in corner[2]..corner[2] + side {
            for y in corner[1]..corner[1] + side {
                let row = (z * SIDE + y) * SIDE + corner[0];
                self.signs[row..row + side].fill(sign);
            }
        }
    }

    pub fn heap_bytes(&self) -> usize {
        self.signs.len()
    }

    /// Calls `visit` with the parts of `from..to` on which the field may be negative (or, unless `positive`,
    /// may be positive), in order, until it gives something.
    pub fn stretches<T>(
        &self,
        ray: &Ray,
        [from, to]: [f64; 2],
        positive: bool,
        mut visit: impl FnMut(f64, f64) -> Option<T>,
    ) -> Option<T> {
        let clear = if positive { Sign::Positive } else { Sign::Negative };
        let mut walk = Walk::new(self, ray, from);
        let mut start: Option<f64> = None;
        let mut t = from;
        while t < to {
            let is_clear = walk.cell().is_some_and(|i| self.signs[i] == clear);
            let (next, slack) = walk.step();
            if is_clear && let Some(begin) = start.take() {
                let found = visit((begin - slack).max(from), (t + slack).min(to));
                if found.is_some() {
                    return found;
                }
            }
            if !is_clear && start.is_none() {
                start = Some(t);
            }
            if !next.is_finite() {
                break;
            }
            t = next.max(t);
        }
        visit(start?.max(from), to)
    }
}

/// The cells that a ray passes, in order.
///
/// Reference: J. Amanatides and A. Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", Eurographics 1987.
struct Walk {
    at: [i32; 3],
    step: [i32; 3],
    next: [f64; 3],
    delta: [f64; 3],
    slack: f64,
}

impl Walk {
    fn new(cells: &Cells, ray: &Ray, from: f64) -> Self {
        let p = (ray.at(from) - cells.min) * cells.density;
        let limit = SIDE as f64 - 1.0;
        let at = p.to_array().map(|c| c.floor().clamp(0.0, limit));
        let speed = ray.dir * cells.density;
        let mut walk = Self {
            at: at.map(|c| c as i32),
            step: [0; 3],
            next: [f64::INFINITY; 3],
            delta: [0.0; 3],
            slack: 0.0,
        };
        for i in 0..3 {
            if speed[i] != 0.0 {
                walk.step[i] = if speed[i] > 0.0 { 1 } else { -1 };
                let face = if speed[i] > 0.0 { at[i] + 1.0 } else { at[i] };
                walk.next[i] = from + (face - p[i]) / speed[i];
                walk.delta[i] = 1.0 / speed[i].abs();
            }
        }
        walk.slack = 0.25 * OVERLAP * cells.size.min_element();
        walk
    }

    /// The index of the cell here; `None` outside the grid.
    fn cell(&self) -> Option<usize> {
        let [x, y, z] = self.at;
        let inside = [x, y, z].iter().all(|c| (0..SIDE as i32).contains(c));
        inside.then(|| (z as usize * SIDE + y as usize) * SIDE + x as usize)
    }

    /// Goes to the next cell; where this one ends, and how far it reaches beyond.
    fn step(&mut self) -> (f64, f64) {
        let [x, y, z] = self.next;
        let axis = if x <= y && x <= z {
            0
        } else if y <= z {
            1
        } else {
            2
        };
        let t = self.next[axis];
        self.at[axis] += self.step[axis];
        self.next[axis] += self.delta[axis];
        (t, self.slack)
    }
}
