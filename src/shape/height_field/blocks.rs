//! Least and greatest heights of blocks of cells, in ever larger blocks.

use super::UNIT;
use crate::math::{EPSILON, Range, Ray, Vec3};
use smallvec::SmallVec;

/// A block has so many parts along each axis.
pub(super) const SIDE: usize = 4;
const SHIFT: u32 = SIDE.ilog2();
pub(super) const PARTS: usize = SIDE * SIDE;

/// Blocks of 4 by 4 cells, of 4 by 4 of these, and so on up to one around everything.
#[derive(Clone, Debug, Default)]
pub(super) struct Blocks {
    columns: usize,
    rows: usize,
    /// What blocks are made of, from those of 4 by 4 blocks of cells on. Cells' own heights are not kept twice.
    levels: Vec<Level>,
    whole: (u16, u16),
}

#[derive(Clone, Debug)]
struct Level {
    columns: usize,
    parts: Vec<Parts>,
}

/// Least and greatest heights of a block's parts, row by row: a line of cache.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub(super) struct Parts {
    pub least: [u16; PARTS],
    pub greatest: [u16; PARTS],
}

/// So many heights of a row are read at once.
pub(super) const ROW: usize = 8;
/// The heights at the corners of 4 by 4 cells, in the first places of each row.
pub(super) type CellRows<'a> = [&'a [u16; ROW]; SIDE + 1];

impl Parts {
    /// Those of 4 by 4 cells.
    #[inline(always)]
    pub fn of_cells(rows: CellRows) -> Parts {
        let mut parts = Parts { least: [0; PARTS], greatest: [0; PARTS] };
        for part in 0..PARTS {
            let (di, dj) = (part % SIDE, part / SIDE);
            let (here, next) = (rows[dj], rows[dj + 1]);
            let (a, b, c, d) = (here[di], here[di + 1], next[di], next[di + 1]);
            parts.least[part] = a.min(b).min(c.min(d));
            parts.greatest[part] = a.max(b).max(c.max(d));
        }
        parts
    }
}

const NOTHING: (u16, u16) = (u16::MAX, 0);

fn joined(a: (u16, u16), b: (u16, u16)) -> (u16, u16) {
    (a.0.min(b.0), a.1.max(b.1))
}

/// Ranges of heights, row by row.
struct Ranges {
    columns: usize,
    list: Vec<(u16, u16)>,
}

impl Ranges {
    /// Those of blocks of 4 by 4 of what `range` gives for `columns` by `rows` places.
    fn over(columns: usize, rows: usize, range: impl Fn(usize, usize) -> (u16, u16)) -> Ranges {
        let wide = columns.div_ceil(SIDE);
        let mut list = vec![NOTHING; wide * rows.div_ceil(SIDE)];
        for j in 0..rows {
            for i in 0..columns {
                let block = &mut list[j / SIDE * wide + i / SIDE];
                *block = joined(*block, range(i, j));
            }
        }
        Ranges { columns: wide, list }
    }

    fn rows(&self) -> usize {
        self.list.len() / self.columns
    }
}

impl Level {
    fn new(ranges: &Ranges) -> Level {
        let columns = ranges.columns.div_ceil(SIDE);
        let empty = Parts { least: [NOTHING.0; PARTS], greatest: [NOTHING.1; PARTS] };
        let mut parts = vec![empty; columns * ranges.rows().div_ceil(SIDE)];
        for (k, &(least, greatest)) in ranges.list.iter().enumerate() {
            let (i, j) = (k % ranges.columns, k / ranges.columns);
            let block = &mut parts[j / SIDE * columns + i / SIDE];
            let part = j % SIDE * SIDE + i % SIDE;
            (block.least[part], block.greatest[part]) = (least, greatest);
        }
        Level { columns, parts }
    }
}

impl Blocks {
    pub fn build(columns: usize, rows: usize, cell: impl Fn(usize, usize) -> (u16, u16)) -> Self {
        let mut ranges = Ranges::over(columns, rows, cell);
        let mut levels = Vec::new();
        while ranges.list.len() > 1 {
            levels.push(Level::new(&ranges));
            ranges = Ranges::over(ranges.columns, ranges.rows(), |i, j| ranges.list[j * ranges.columns + i]);
        }
        let whole = ranges.list.first().copied().unwrap_or((0, 0));
        Self { columns, rows, levels, whole }
    }

    /// Least and greatest of all heights.
    pub fn whole(&self) -> (u16, u16) {
        self.whole
    }

    pub fn heap_bytes(&self) -> usize {
        self.levels.iter().map(|l| l.parts.capacity() * size_of::<Parts>()).sum()
    }

    /// Calls `visit(column, row, max)` with the cells that the ray (in cells and units of height) may meet
    /// inside `range`, nearer blocks first. `visit` returns the new `max`. `cells` says the heights of 4 by 4 cells
    /// from one on, and `passed` is [`Walk::passed`] or does the same.
    #[inline(always)]
    pub fn traverse(
        &self,
        ray: &Ray,
        range: Range,
        cells: impl Fn(usize, usize) -> Parts,
        passed: impl Fn(&Walk, &Block, Range, &Parts) -> Passed,
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
            let within = Range::new(range.min, max);
            let (i, j) = (block.i as usize, block.j as usize);
            let place = |bit: u32| {
                let part = (bit ^ walk.flip) as usize % PARTS;
                (i * SIDE + part % SIDE, j * SIDE + part / SIDE, part)
            };
            if block.level == 0 {
                let passed = passed(&walk, &block, within, &cells(i * SIDE, j * SIDE));
                let mut set = walk.flipped(passed.set);
                while set != 0 {
                    let (i, j, part) = place(set.trailing_zeros());
                    set &= set - 1;
                    if passed.near[part] <= max {
                        max = max.min(visit(i, j, max));
                    }
                }
            } else {
                let level = &self.levels[block.level as usize - 1];
                let passed = passed(&walk, &block, within, &level.parts[j * level.columns + i]);
                let mut set = walk.flipped(passed.set);
                while set != 0 {
                    // The farthest first.
                    let bit = set.ilog2();
                    set ^= 1 << bit;
                    let (i, j, part) = place(bit);
                    let near = passed.near[part];
                    stack.push(Block { level: block.level - 1, i: i as u32, j: j as u32, near });
                }
            }
        }
    }
}

/// A block that is still to be looked at, and where the ray comes into it at the earliest.
#[derive(Clone, Copy)]
pub(super) struct Block {
    /// 0 if its parts are cells.
    level: u32,
    i: u32,
    j: u32,
    near: f64,
}

/// The parts of a block that a ray may pass: a bit for each, and from where on.
pub(super) struct Passed {
    pub set: u32,
    pub near: [f64; PARTS],
}

/// A ray in the coordinates of cells and heights.
pub(super) struct Walk {
    pub origin: Vec3,
    pub dir: Vec3,
    pub inverse: Vec3,
    /// A coordinate between the ray's origin and the far side of everything is known to less than this, also if it
    /// comes from a distance along the ray.
    pub slack: Vec3,
    columns: usize,
    rows: usize,
    /// What turns the number of a block's part into its place in the order in which the ray comes to them: ones where
    /// it goes backward.
    flip: u32,
}

/// The planes between a block's parts across an axis.
pub(super) struct Planes {
    pub first: f64,
    pub step: f64,
    /// None is further on than this.
    pub last: f64,
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
    #[inline(always)]
    fn new(blocks: &Blocks, ray: &Ray) -> Self {
        let scale = Vec3::new(blocks.columns as f64, UNIT, blocks.rows as f64);
        let slack = 16.0 * EPSILON * (ray.origin.abs() + scale);
        let inverse = ray.dir.recip();
        let (columns, rows) = (blocks.columns, blocks.rows);
        let back = |inverse: f64| if inverse >= 0.0 { 0 } else { SIDE as u32 - 1 };
        let flip = back(inverse.z) << SHIFT | back(inverse.x);
        Self { origin: ray.origin, dir: ray.dir, inverse, slack, columns, rows, flip }
    }

    /// Across x, and across z.
    #[inline(always)]
    pub fn planes(&self, block: &Block) -> [Planes; 2] {
        let shift = SHIFT * block.level;
        [(block.i, self.columns), (block.j, self.rows)].map(|(at, count)| Planes {
            first: ((at as usize * SIDE) << shift) as f64,
            step: (1u64 << shift) as f64,
            last: count as f64,
        })
    }

    /// A bit for each part of a block that holds cells.
    #[inline(always)]
    pub fn there(&self, block: &Block) -> u32 {
        let used = |at: u32, count: usize| {
            let last = (count - 1) >> (SHIFT * block.level);
            (last - at as usize * SIDE).min(SIDE - 1)
        };
        let row = 0xf >> (SIDE - 1 - used(block.i, self.columns));
        (0x1111 * row) & (0xffff >> (SIDE * (SIDE - 1 - used(block.j, self.rows))))
    }

    /// Where the ray is in each of four slabs across an axis: from, to.
    #[inline(always)]
    fn slabs(&self, axis: usize, planes: &Planes) -> ([f64; SIDE], [f64; SIDE]) {
        let (origin, inverse, slack) = (self.origin[axis], self.inverse[axis], self.slack[axis]);
        let plane = |k: usize| lesser(planes.first + k as f64 * planes.step, planes.last);
        let below = std::array::from_fn(|k| (plane(k) - slack - origin) * inverse);
        let above = std::array::from_fn(|k| (plane(k + 1) + slack - origin) * inverse);
        if inverse >= 0.0 { (below, above) } else { (above, below) }
    }

    /// Which parts of a block the ray may pass inside a range, by their places and their heights.
    #[inline(always)]
    pub fn passed(&self, block: &Block, range: Range, parts: &Parts) -> Passed {
        let [x, z] = self.planes(block);
        let (x, z) = (self.slabs(0, &x), self.slabs(2, &z));
        let mut passed = Passed { set: 0, near: [0.0; PARTS] };
        for part in 0..PARTS {
            let (di, dj) = (part % SIDE, part / SIDE);
            let near = greater(x.0[di], greater(z.0[dj], range.min));
            let far = lesser(x.1[di], lesser(z.1[dj], range.max));
            // A ray along an axis is outside of a block nowhere, or at all distances: up to infinity then.
            let beside = (near > far) | (near == f64::INFINITY);
            let (a, b) = (near * self.dir.y, far * self.dir.y);
            let low = self.origin.y + lesser(a, b) - self.slack.y;
            let high = self.origin.y + greater(a, b) + self.slack.y;
            let over = (low > f64::from(parts.greatest[part])) | (high < f64::from(parts.least[part]));
            passed.near[part] = near;
            passed.set |= u32::from(!(beside | over)) << part;
        }
        passed.set &= self.there(block);
        passed
    }

    /// A set of parts in the order in which the ray comes to them.
    #[inline(always)]
    fn flipped(&self, mut set: u32) -> u32 {
        if self.flip & 1 != 0 {
            set = (set & 0x5555) << 1 | set >> 1 & 0x5555;
            set = (set & 0x3333) << 2 | set >> 2 & 0x3333;
        }
        if self.flip & SIDE as u32 != 0 {
            set = (set & 0x0f0f) << 4 | set >> 4 & 0x0f0f;
            set = (set & 0x00ff) << 8 | set >> 8 & 0x00ff;
        }
        set
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
                |_, _| Parts { least: [0; PARTS], greatest: [60000; PARTS] },
                Walk::passed,
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
