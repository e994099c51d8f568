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

    /// Calls `visit(column, row, max)` with the cells that the ray may meet inside `range`, nearer blocks
    /// first. `visit` returns the new `max`.
    pub fn traverse(&self, ray: &Ray, range: Range, mut visit: impl FnMut(usize, usize, f64) -> f64) {
        let mut max = range.max;
        let walk = Walk::new(self, ray);
        let mut stack: SmallVec<[(u32, u32, u32); 64]> = SmallVec::new();
        stack.push((self.levels.len() as u32, 0, 0));
        while let Some((level, i, j)) = stack.pop() {
            let (i, j) = (i as usize, j as usize);
            if level > 0 {
                let below = &self.levels[level as usize - 1];
                let heights = below.ranges[j * below.columns + i];
                if !walk.may_meet(level, i, j, heights, Range::new(range.min, max)) {
                    continue;
                }
                let (columns, rows) = match level {
                    1 => (self.columns, self.rows),
                    _ => {
                        let inner = &self.levels[level as usize - 2];
                        (inner.columns, inner.rows())
                    }
                };
                for (di, dj) in walk.far_to_near() {
                    let (ci, cj) = (2 * i + di, 2 * j + dj);
                    if ci < columns && cj < rows {
                        stack.push((level - 1, ci as u32, cj as u32));
                    }
                }
            } else if walk.may_meet(0, i, j, (0, u16::MAX), Range::new(range.min, max)) {
                max = max.min(visit(i, j, max));
            }
        }
    }
}

/// A ray in the coordinates of cells and heights.
struct Walk {
    origin: Vec3,
    inverse: Vec3,
    /// Bound on the rounding of a coordinate.
    slack: Vec3,
    columns: usize,
    rows: usize,
}

impl Walk {
    fn new(blocks: &Blocks, ray: &Ray) -> Self {
        let scale = Vec3::new(blocks.columns as f64, UNIT, blocks.rows as f64);
        let origin = ray.origin * scale;
        let slack = 16.0 * EPSILON * (origin.abs() + scale);
        Self { origin, inverse: (ray.dir * scale).recip(), slack, columns: blocks.columns, rows: blocks.rows }
    }

    /// Whether the ray may pass the box of a block.
    fn may_meet(&self, level: u32, i: usize, j: usize, heights: (u16, u16), range: Range) -> bool {
        let high_i = ((i + 1) << level).min(self.columns);
        let high_j = ((j + 1) << level).min(self.rows);
        let low = Vec3::new((i << level) as f64, f64::from(heights.0), (j << level) as f64) - self.slack;
        let high = Vec3::new(high_i as f64, f64::from(heights.1), high_j as f64) + self.slack;
        let (mut near, mut far) = (range.min, range.max);
        for axis in 0..3 {
            let (a, b) = (low[axis] - self.origin[axis], high[axis] - self.origin[axis]);
            if self.inverse[axis].is_infinite() {
                if a > 0.0 || b < 0.0 {
                    return false;
                }
                continue;
            }
            let (t0, t1) = (a * self.inverse[axis], b * self.inverse[axis]);
            near = near.max(t0.min(t1));
            far = far.min(t0.max(t1));
        }
        near <= far + 8.0 * EPSILON * near.abs().max(far.abs())
    }

    /// The four parts of a block, the one that the ray leaves last first.
    fn far_to_near(&self) -> [(usize, usize); 4] {
        let x = usize::from(self.inverse.x < 0.0);
        let z = usize::from(self.inverse.z < 0.0);
        [(1 - x, 1 - z), (x, 1 - z), (1 - x, z), (x, z)]
    }
}
