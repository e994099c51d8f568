//! What is known of a field inside a container: cells in which it is positive, negative, or changes no
//! faster than given.
//!
//! Each of 8 × 8 × 8 cells may be divided further into 4 × 4 × 4. A cell is looked at when the first ray
//! passes it; what is found does not depend on which ray that was.

use crate::math::field::{Enclosure, Field};
use crate::math::{Aabb, Ray, Vec3};
use std::sync::OnceLock;

/// Cells on each side of the container, and of a cell that is divided.
const COARSE: usize = 8;
const FINE: usize = 4;

/// Cells overlap by this part of their size, so that rounding moves no point out of all of them.
const OVERLAP: f64 = 1e-9;

/// A container divided into cells.
pub(super) struct Cells {
    min: Vec3,
    /// Of a cell.
    size: Vec3,
    cells: Vec<OnceLock<Cell>>,
}

/// One of the large cells.
enum Cell {
    Positive,
    Negative,
    Divided(Box<[OnceLock<Content>; FINE * FINE * FINE]>),
}

/// What is known in a small cell.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Content {
    Positive,
    Negative,
    /// Lower and upper bounds of the derivatives by x, y and z, rounded outward.
    Slopes([f32; 6]),
}

/// What is known of the field along a stretch of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Stretch {
    Positive,
    Negative,
    /// It changes at a rate between these, which may be infinite.
    Slopes(f64, f64),
}

/// A field whose values are compared with a threshold.
#[derive(Clone, Copy)]
pub(super) struct Level<'a> {
    pub field: &'a dyn Field,
    pub threshold: f64,
}

impl Cells {
    /// `None` if nothing is known of the field.
    pub fn new(level: Level, bounds: &Aabb) -> Option<Self> {
        if !bounds.is_finite() || bounds.volume() <= 0.0 {
            return None;
        }
        // A small box tells whether the field can say anything about boxes.
        let sample = Aabb::new(bounds.center(), bounds.center() + 1e-3 * bounds.size());
        level.field.range(&sample)?;
        let cells = (0..COARSE * COARSE * COARSE).map(|_| OnceLock::new()).collect();
        Some(Self { min: bounds.min, size: bounds.size() / COARSE as f64, cells })
    }

    /// Calls `visit` with the stretches of a ray between `from` and `to` of which something is known, in
    /// order, until it gives something.
    pub fn walk<T>(
        &self,
        level: Level,
        ray: &Ray,
        [from, to]: [f64; 2],
        visit: &mut impl FnMut(f64, Stretch) -> Option<T>,
    ) -> Option<T> {
        let grid = Grid { min: self.min, size: self.size, side: COARSE };
        grid.walk(ray, [from, to], &mut |[from, to], index| {
            let min = grid.corner(index);
            let cell = self.cells[index].get_or_init(|| self.cell(level, min));
            match cell {
                Cell::Positive => visit(to, Stretch::Positive),
                Cell::Negative => visit(to, Stretch::Negative),
                Cell::Divided(parts) => {
                    let inner = Grid { min, size: self.size / FINE as f64, side: FINE };
                    inner.walk(ray, [from, to], &mut |[_, to], index| {
                        let make = || content(level, &around(inner.corner(index), inner.size));
                        visit(to, parts[index].get_or_init(make).along(ray.dir))
                    })
                }
            }
        })
    }

    fn cell(&self, level: Level, min: Vec3) -> Cell {
        match level.field.range(&around(min, self.size)) {
            Some((low, _)) if low > level.threshold => Cell::Positive,
            Some((_, high)) if high < level.threshold => Cell::Negative,
            _ => Cell::Divided(Box::new(std::array::from_fn(|_| OnceLock::new()))),
        }
    }

    pub fn heap_bytes(&self) -> usize {
        let divided = self.cells.iter().filter(|c| matches!(c.get(), Some(Cell::Divided(_)))).count();
        let part = size_of::<OnceLock<Content>>();
        size_of_val(&self.cells[..]) + divided * FINE * FINE * FINE * part
    }
}

impl std::fmt::Debug for Cells {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        write!(f, "Cells from {} of {}", self.min, self.size)
    }
}

/// A cell with its overlap.
fn around(min: Vec3, size: Vec3) -> Aabb {
    let margin = size * OVERLAP;
    Aabb { min: min - margin, max: min + size + margin }
}

fn content(level: Level, cube: &Aabb) -> Content {
    let all = (f64::NEG_INFINITY, f64::INFINITY);
    let unknown = Enclosure { range: all, gradient: [all; 3] };
    let found = level.field.enclosure(cube).unwrap_or(unknown);
    let range = tightened(level.field, cube, &found);
    if range.0 > level.threshold {
        return Content::Positive;
    }
    if range.1 < level.threshold {
        return Content::Negative;
    }
    let [x, y, z] = found.gradient.map(|(lo, hi)| [(lo as f32).next_down(), (hi as f32).next_up()]);
    Content::Slopes([x[0], x[1], y[0], y[1], z[0], z[1]])
}

/// The range of values narrowed by the value at the center and the slopes.
fn tightened(field: &dyn Field, cube: &Aabb, found: &Enclosure) -> (f64, f64) {
    let half = 0.5 * cube.size();
    let reach: f64 = (0..3).map(|i| found.gradient[i].0.abs().max(found.gradient[i].1.abs()) * half[i]).sum();
    if !reach.is_finite() {
        return found.range;
    }
    let center = field.value(cube.center());
    let reach = reach * (1.0 + OVERLAP);
    (found.range.0.max(center - reach), found.range.1.min(center + reach))
}

impl Content {
    fn along(self, dir: Vec3) -> Stretch {
        let s = match self {
            Content::Positive => return Stretch::Positive,
            Content::Negative => return Stretch::Negative,
            Content::Slopes(s) => s.map(f64::from),
        };
        let (mut low, mut high) = (0.0, 0.0);
        for axis in 0..3 {
            let (a, b) = (s[2 * axis] * dir[axis], s[2 * axis + 1] * dir[axis]);
            low += a.min(b);
            high += a.max(b);
        }
        // Across an axis by which a derivative is unbounded, the product says nothing.
        let known = |v: f64, instead: f64| if v.is_nan() { instead } else { v };
        Stretch::Slopes(known(low, f64::NEG_INFINITY), known(high, f64::INFINITY))
    }
}

/// A cube of cells.
#[derive(Clone, Copy)]
struct Grid {
    min: Vec3,
    size: Vec3,
    side: usize,
}

impl Grid {
    fn corner(&self, index: usize) -> Vec3 {
        let at = [index % self.side, index / self.side % self.side, index / (self.side * self.side)];
        self.min + self.size * Vec3::from_array(at.map(|i| i as f64))
    }

    /// Calls `visit` with the part of a ray in each cell, until it gives something.
    ///
    /// Reference: J. Amanatides and A. Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", Eurographics
    /// 1987.
    #[inline]
    fn walk<T>(
        &self,
        ray: &Ray,
        [from, to]: [f64; 2],
        visit: &mut impl FnMut([f64; 2], usize) -> Option<T>,
    ) -> Option<T> {
        let p = (ray.at(from) - self.min) / self.size;
        let speed = ray.dir / self.size;
        let side = self.side as i32;
        let (mut at, mut step, mut next, mut delta) = ([0; 3], [0; 3], [f64::INFINITY; 3], [0.0; 3]);
        for i in 0..3 {
            at[i] = (p[i].floor() as i32).clamp(0, side - 1);
            if speed[i] != 0.0 {
                step[i] = if speed[i] > 0.0 { 1 } else { -1 };
                let face = f64::from(at[i] + i32::from(speed[i] > 0.0));
                next[i] = from + (face - p[i]) / speed[i];
                delta[i] = 1.0 / speed[i].abs();
            }
        }
        let mut t = from;
        loop {
            let [x, y, z] = next;
            let axis = if x <= y && x <= z {
                0
            } else if y <= z {
                1
            } else {
                2
            };
            let leave = next[axis].max(t).min(to);
            if leave > t {
                let found = visit([t, leave], ((at[2] * side + at[1]) * side + at[0]) as usize);
                if found.is_some() {
                    return found;
                }
            }
            t = leave;
            at[axis] += step[axis];
            next[axis] += delta[axis];
            // A ray along an outer face may seem to leave a little early; it stays in the last cell.
            if t >= to {
                return None;
            }
            if at[axis] < 0 || at[axis] >= side {
                at[axis] = at[axis].clamp(0, side - 1);
                next[axis] = f64::INFINITY;
            }
        }
    }
}
