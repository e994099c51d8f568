//! Least and greatest heights of blocks of cells, in ever larger blocks.

use super::UNIT;
use crate::math::{EPSILON, Range, Ray, Vec3};
use smallvec::SmallVec;

/// Levels of blocks; level 0 has 2 by 2 cells to a block, and each next one 2 by 2 blocks.
#[derive(Clone, Debug, Default)]
pub(super) struct Blocks {
    columns: usize,
    rows: usize,
    levels: Vec<Level>,
}

#[derive(Clone, Debug)]
struct Level {
    columns: usize,
    /// Least and greatest height, row by row.
    ranges: Vec<(u16, u16)>,
}

fn joined(a: (u16, u16), b: (u16, u16)) -> (u16, u16) {
    (a.0.min(b.0), a.1.max(b.1))
}

impl Level {
    /// Blocks of 2 by 2 of what `range` gives for `columns` by `rows` places.
    fn over(columns: usize, rows: usize, range: impl Fn(usize, usize) -> (u16, u16)) -> Self {
        let wide = columns.div_ceil(2);
        let mut ranges = vec![(u16::MAX, 0); wide * rows.div_ceil(2)];
        for j in 0..rows {
            for i in 0..columns {
                let block = &mut ranges[j / 2 * wide + i / 2];
                *block = joined(*block, range(i, j));
            }
        }
        Self { columns: wide, ranges }
    }

    fn rows(&self) -> usize {
        self.ranges.len() / self.columns
    }
}

impl Blocks {
    pub fn build(columns: usize, rows: usize, cell: impl Fn(usize, usize) -> (u16, u16)) -> Self {
        let mut levels = vec![Level::over(columns, rows, cell)];
        while let Some(top) = levels.last().filter(|top| top.ranges.len() > 1) {
            let next = Level::over(top.columns, top.rows(), |i, j| top.ranges[j * top.columns + i]);
            levels.push(next);
        }
        Self { columns, rows, levels }
    }

    /// Least and greatest of all heights.
    pub fn whole(&self) -> (u16, u16) {
        self.levels.last().map_or((0, 0), |top| top.ranges[0])
    }

    pub fn heap_bytes(&self) -> usize {
        self.levels.iter().map(|l| l.ranges.capacity() * size_of::<(u16, u16)>()).sum()
    }

    /// Calls `visit(column, row, max)` with the cells that the ray (in cells and units of height) may meet
    /// inside `range`, nearer blocks first. `visit` returns the new `max`; `heights` are those of a cell.
    pub fn traverse(
        &self,
        ray: &Ray,
        range: Range,
        heights: impl Fn(usize, usize) -> (u16, u16),
        mut visit: impl FnMut(usize, usize, f64) -> f64,
    ) {
        let mut max = range.max;
        let walk = Walk::new(self, ray);
        let mut stack: SmallVec<[Block; 64]> = SmallVec::new();
        stack.push(Block { level: self.levels.len() as u32, i: 0, j: 0, near: range.min });
        while let Some(block) = stack.pop() {
            if block.near > max {
                continue;
            }
            if block.level == 0 {
                max = max.min(visit(block.i as usize, block.j as usize, max));
            } else {
                let within = Range::new(range.min, max);
                if block.level == 1 {
                    walk.divide(block, within, &heights, &mut stack);
                } else {
                    let parts = &self.levels[block.level as usize - 2];
                    walk.divide(block, within, |i, j| parts.ranges[j * parts.columns + i], &mut stack);
                }
            }
        }
    }
}

/// A block that is still to be looked at, and where the ray comes into it at the earliest.
#[derive(Clone, Copy)]
struct Block {
    level: u32,
    i: u32,
    j: u32,
    near: f64,
}

/// A ray in the coordinates of cells and heights.
struct Walk {
    origin: Vec3,
    dir: Vec3,
    inverse: Vec3,
    /// A coordinate between the ray's origin and the far side of everything is known to less than this, also if it
    /// comes from a distance along the ray.
    slack: Vec3,
    columns: usize,
    rows: usize,
    /// The part of a block that the ray comes to last, along both axes.
    last: [usize; 2],
}

/// One comparison, where nothing needs to be said about what is no number.
#[inline(always)]
fn lesser(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

#[inline(always)]
fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

impl Walk {
    fn new(blocks: &Blocks, ray: &Ray) -> Self {
        let scale = Vec3::new(blocks.columns as f64, UNIT, blocks.rows as f64);
        let slack = 16.0 * EPSILON * (ray.origin.abs() + scale);
        let inverse = ray.dir.recip();
        let last = [usize::from(inverse.x >= 0.0), usize::from(inverse.z >= 0.0)];
        let (columns, rows) = (blocks.columns, blocks.rows);
        Self { origin: ray.origin, dir: ray.dir, inverse, slack, columns, rows, last }
    }

    /// Where the ray is between the planes at `low`, `middle` and `high` across an axis: from, to for both halves.
    #[inline(always)]
    fn halves(&self, axis: usize, low: usize, middle: usize, high: usize) -> [(f64, f64); 2] {
        let (origin, inverse, slack) = (self.origin[axis], self.inverse[axis], self.slack[axis]);
        let below = |plane: usize| (plane as f64 - slack - origin) * inverse;
        let above = |plane: usize| (plane as f64 + slack - origin) * inverse;
        if inverse >= 0.0 {
            [(below(low), above(middle)), (below(middle), above(high))]
        } else {
            [(above(middle), below(low)), (above(high), below(middle))]
        }
    }

    /// Puts those of a block's four parts on the stack that the ray may pass, the farthest first.
    #[inline(always)]
    fn divide(
        &self,
        block: Block,
        range: Range,
        heights: impl Fn(usize, usize) -> (u16, u16),
        stack: &mut SmallVec<[Block; 64]>,
    ) {
        let (level, i, j) = (block.level - 1, 2 * block.i as usize, 2 * block.j as usize);
        let x = [i, i + 1, i + 2].map(|k| (k << level).min(self.columns));
        let z = [j, j + 1, j + 2].map(|k| (k << level).min(self.rows));
        let along_x = self.halves(0, x[0], x[1], x[2]);
        let along_z = self.halves(2, z[0], z[1], z[2]);
        let [a, b] = self.last;
        for (di, dj) in [(a, b), (1 - a, b), (a, 1 - b), (1 - a, 1 - b)] {
            if x[di] >= self.columns || z[dj] >= self.rows {
                continue;
            }
            let near = greater(greater(along_x[di].0, along_z[dj].0), range.min);
            let far = lesser(lesser(along_x[di].1, along_z[dj].1), range.max);
            // A ray along an axis is outside of a block nowhere, or at all distances: up to infinity then.
            if near > far || near == f64::INFINITY {
                continue;
            }
            if !self.may_reach(heights(i + di, j + dj), near, far) {
                continue;
            }
            stack.push(Block { level, i: (i + di) as u32, j: (j + dj) as u32, near });
        }
    }

    /// Whether the ray's heights between two distances may be among those of a block.
    #[inline(always)]
    fn may_reach(&self, heights: (u16, u16), near: f64, far: f64) -> bool {
        let (a, b) = (near * self.dir.y, far * self.dir.y);
        let low = self.origin.y + lesser(a, b) - self.slack.y;
        let high = self.origin.y + greater(a, b) + self.slack.y;
        !(low > f64::from(heights.1) || high < f64::from(heights.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rays along axes are led to the few cells on their way, whether they end or not.
    #[test]
    fn rays_along_axes_visit_few_cells() {
        let blocks = Blocks::build(64, 64, |_, _| (0, 60000));
        let visited = |origin: Vec3, dir: Vec3, max: f64| {
            let mut count = 0;
            blocks.traverse(
                &Ray::new(origin, dir),
                Range::new(0.0, max),
                |_, _| (0, 60000),
                |_, _, max| {
                    count += 1;
                    max
                },
            );
            count
        };
        for max in [1e6, f64::INFINITY] {
            for dir in [Vec3::Y, Vec3::NEG_Y] {
                let from = if dir.y > 0.0 { -10.0 } else { 70000.0 };
                assert_eq!(visited(Vec3::new(20.5, from, 41.5), dir, max), 1, "{dir} {max}");
                assert_eq!(visited(Vec3::new(-0.5, from, 41.5), dir, max), 0, "{dir} {max}");
                assert_eq!(visited(Vec3::new(20.5, from, 65.0), dir, max), 0, "{dir} {max}");
            }
            for dir in [Vec3::X, Vec3::NEG_X] {
                let from = Vec3::new(32.0 - 50.0 * dir.x, 5.0, 7.5);
                assert_eq!(visited(from, dir, max), 64, "{dir} {max}");
                assert_eq!(visited(from + 100.0 * Vec3::Z, dir, max), 0, "{dir} {max}");
            }
        }
    }
}
