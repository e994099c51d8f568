//! A uniform grid of cells over boxes.
//!
//! Every cell lists the boxes that come within [`PAD`] of a cell's width of it. A ray goes from cell to cell; the
//! distance to a cell's side is worked out anew from the side's number, so that rounding does not add up. Per axis
//! the cell that the ray is said to be in is then wrong by no more than the rounding of one such distance, for
//! which there is room in the pad; rays for which there is not (they start too far away for doubles to tell cells
//! apart) are held against every box.
//!
//! A box may stand in many cells. The cells of a box are a block, a ray goes through it once and changes one axis
//! at a time: it has been in the block before exactly if the cell that it comes from lies in it too.
//!
//! Reference: J. Amanatides, A. Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", Eurographics 1987;
//! J. Cleary, G. Wyvill, "Analysis of an algorithm for fast ray tracing using uniform space subdivision",
//! The Visual Computer 4 (1988).

use super::{Aabb, Accelerator, AnyHit, Range, Ray, Vec3};

/// How far from a cell's sides boxes are still listed, in widths of a cell.
const PAD: f64 = 1e-3;
/// Cells for each box: more made rays slower wherever it was measured.
const CELLS_PER_BOX: f64 = 1.0;
/// The most cells along an axis.
const MOST_CELLS: f64 = 1024.0;
/// Entries for each box that lists of cells may have: where boxes are large, cells become larger.
const MOST_ENTRIES: usize = 24;
/// Bound on the relative rounding of a place in cells: the move along the ray, the way from the grid's corner, and
/// the division by a cell's size.
const ROUNDING: f64 = 8.0 * f64::EPSILON;
/// Cells a little beyond the nearest hit are still looked at: what shapes say of distances is rounded too.
const SLACK: f64 = 1e-6;

/// First and last cell of a box along each axis.
type Block = [[u16; 2]; 3];

/// Boxes by cell.
#[derive(Clone, Debug)]
pub struct Grid {
    /// Around everything.
    bounds: Aabb,
    /// Cells along each axis.
    counts: [u16; 3],
    /// Cells in a unit of length.
    density: Vec3,
    /// Where each cell's list begins in `items`; one more entry ends the last.
    starts: Vec<u32>,
    items: Vec<u32>,
    blocks: Vec<Block>,
}

/// A ray on its way through the cells.
struct Walk {
    cell: [i32; 3],
    /// Along itself until it was put into the grid.
    advance: f64,
    /// Where it is then, in cells.
    origin: Vec3,
    /// From `advance`, for the length of a cell along each axis: infinite where it does not move.
    length: Vec3,
    /// Added to distances up to which cells are looked at.
    slack: f64,
}

/// What becomes of a ray.
enum Entry {
    Misses,
    Walks(Walk),
    /// Doubles do not tell in which cell it is.
    Unsure,
}

impl Grid {
    /// A grid over finite boxes. Those that are empty or not finite are left out: no ray meets them.
    pub fn build(boxes: &[Aabb]) -> Grid {
        let usable = |b: &&Aabb| b.is_finite() && !b.is_empty();
        let bounds = boxes.iter().filter(usable).fold(Aabb::EMPTY, |a, b| a.union(*b));
        let count = boxes.iter().filter(usable).count();
        let mut wanted = counts(&bounds, count);
        loop {
            let mut grid = Grid::empty(bounds, wanted);
            grid.blocks = boxes.iter().map(|b| grid.block(b)).collect();
            let entries: usize = grid.blocks.iter().map(cells_of).sum();
            if entries <= MOST_ENTRIES * count || wanted == [1; 3] {
                grid.fill();
                return grid;
            }
            wanted = wanted.map(|n| n.div_ceil(2));
        }
    }

    fn empty(bounds: Aabb, counts: [u16; 3]) -> Grid {
        let size = bounds.size();
        let density = |a: usize| if size[a] > 0.0 { f64::from(counts[a]) / size[a] } else { 1.0 };
        Grid {
            bounds,
            counts,
            density: Vec3::new(density(0), density(1), density(2)),
            starts: Vec::new(),
            items: Vec::new(),
            blocks: Vec::new(),
        }
    }

    /// The cells that a box comes near to; no cell for a box without points.
    fn block(&self, b: &Aabb) -> Block {
        if !b.is_finite() || b.is_empty() {
            return [[1, 0]; 3];
        }
        std::array::from_fn(|a| {
            let place = |v: f64, pad: f64| self.clamped(a, (v - self.bounds.min[a]) * self.density[a] + pad);
            [place(b.min[a], -PAD) as u16, place(b.max[a], PAD) as u16]
        })
    }

    /// The cell at a place along an axis, or the nearest one.
    fn clamped(&self, axis: usize, place: f64) -> i32 {
        (place.floor() as i32).clamp(0, i32::from(self.counts[axis]) - 1)
    }

    /// Sorts the boxes into cells.
    fn fill(&mut self) {
        let [nx, ny, nz] = self.counts.map(usize::from);
        let mut starts = vec![0u32; nx * ny * nz + 1];
        for block in &self.blocks {
            each_cell(block, self.counts, |cell| starts[cell + 1] += 1);
        }
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut next = starts.clone();
        self.items = vec![0; starts[starts.len() - 1] as usize];
        for (i, block) in self.blocks.iter().enumerate() {
            each_cell(block, self.counts, |cell| {
                self.items[next[cell] as usize] = i as u32;
                next[cell] += 1;
            });
        }
        self.starts = starts;
    }

    pub fn cell_count(&self) -> usize {
        self.starts.len() - 1
    }

    /// The boxes in a cell's list.
    #[inline]
    fn list(&self, cell: [i32; 3]) -> &[u32] {
        let [nx, ny, _] = self.counts.map(usize::from);
        let at = (cell[2] as usize * ny + cell[1] as usize) * nx + cell[0] as usize;
        &self.items[self.starts[at] as usize..self.starts[at + 1] as usize]
    }

    fn enter(&self, ray: &Ray, range: Range) -> Entry {
        let pad = ray.origin.abs() * (2.0 * f64::EPSILON) + f64::MIN_POSITIVE;
        let inverse = ray.dir.recip();
        let a = (self.bounds.min - pad - ray.origin) * inverse;
        let b = (self.bounds.max + pad - ray.origin) * inverse;
        let near = a.min(b).max_element().max(range.min);
        let far = a.max(b).min_element().min(range.max);
        if near > far + 8.0 * f64::EPSILON * (near.abs() + far.abs()) || near == f64::INFINITY {
            return Entry::Misses;
        }
        let advance = near.max(0.0);
        let reach = ray.origin.abs() + (self.bounds.min.abs() + advance);
        let most = Vec3::from_array(self.counts.map(f64::from));
        let doubt = (reach * self.density + most) * ROUNDING;
        if !doubt.cmple(Vec3::splat(PAD)).all() {
            return Entry::Unsure;
        }
        let origin = (ray.at(advance) - self.bounds.min) * self.density;
        let length = (ray.dir.abs() * self.density).recip();
        let slack = PAD * length.min_element();
        let cell = std::array::from_fn(|a| self.clamped(a, origin[a]));
        Entry::Walks(Walk { cell, advance, origin, length, slack })
    }

    fn walk(&self, ray: &Ray, range: Range, mut visit: impl FnMut(u32, f64) -> f64) {
        let mut walk = match self.enter(ray, range) {
            Entry::Misses => return,
            Entry::Unsure => return self.walk_all(range, visit),
            Entry::Walks(walk) => walk,
        };
        let forward = ray.dir.to_array().map(|d| d > 0.0);
        let mut next = Vec3::from_array(std::array::from_fn(|a| walk.side(a, forward[a])));
        let mut max = range.max;
        let mut limit = walk.limit(max);
        // The axis that the last step changed, and from where.
        let mut before: Option<(usize, u16)> = None;
        loop {
            for &i in self.list(walk.cell) {
                if let Some((axis, from)) = before {
                    let [first, last] = self.blocks[i as usize][axis];
                    if (first..=last).contains(&from) {
                        continue;
                    }
                }
                let closer = visit(i, max);
                if closer < max {
                    max = closer;
                    if max <= range.min {
                        return;
                    }
                    limit = walk.limit(max);
                }
            }
            let axis = next.min_position();
            if !(next[axis] <= limit) || next[axis] == f64::INFINITY {
                return;
            }
            before = Some((axis, walk.cell[axis] as u16));
            walk.cell[axis] += if forward[axis] { 1 } else { -1 };
            if !(0..i32::from(self.counts[axis])).contains(&walk.cell[axis]) {
                return;
            }
            next[axis] = walk.side(axis, forward[axis]);
        }
    }

    /// Every box, one after the other.
    #[cold]
    fn walk_all(&self, range: Range, mut visit: impl FnMut(u32, f64) -> f64) {
        let mut max = range.max;
        for i in 0..self.blocks.len() as u32 {
            max = visit(i, max);
            if max <= range.min {
                return;
            }
        }
    }
}

impl Walk {
    /// How far it is to the side by which the ray leaves its cell along an axis.
    #[inline]
    fn side(&self, axis: usize, forward: bool) -> f64 {
        if self.length[axis] == f64::INFINITY {
            return f64::INFINITY;
        }
        let cell = f64::from(self.cell[axis]);
        let way = if forward { cell + 1.0 - self.origin[axis] } else { self.origin[axis] - cell };
        way * self.length[axis]
    }

    /// How far cells are worth looking at.
    #[inline]
    fn limit(&self, max: f64) -> f64 {
        (max - self.advance) * (1.0 + SLACK) + self.slack + SLACK * self.advance
    }
}

impl AnyHit for Grid {
    #[inline]
    fn any(&self, ray: &Ray, range: Range, mut visit: impl FnMut(u32) -> bool) -> bool {
        let mut found = false;
        self.walk(ray, range, |i, max| {
            found = visit(i);
            if found { f64::NEG_INFINITY } else { max }
        });
        found
    }
}

impl Accelerator for Grid {
    #[inline]
    fn traverse(&self, ray: &Ray, range: Range, visit: impl FnMut(u32, f64) -> f64) {
        self.walk(ray, range, visit);
    }

    fn any_at(&self, p: Vec3, mut visit: impl FnMut(u32) -> bool) -> bool {
        if !self.bounds.contains(p) {
            return false;
        }
        let doubt = (p.abs() + self.bounds.min.abs()) * self.density * ROUNDING;
        if !doubt.cmple(Vec3::splat(PAD)).all() {
            return (0..self.blocks.len() as u32).any(visit);
        }
        let place = (p - self.bounds.min) * self.density;
        let cell = std::array::from_fn(|a| self.clamped(a, place[a]));
        self.list(cell).iter().any(|&i| visit(i))
    }

    fn heap_bytes(&self) -> usize {
        size_of_val(&self.starts[..]) + size_of_val(&self.items[..]) + size_of_val(&self.blocks[..])
    }
}

/// Cells along each axis: cubes, so many that there are [`CELLS_PER_BOX`]. An axis along which everything is flatter
/// than a cell is not cut.
fn counts(bounds: &Aabb, boxes: usize) -> [u16; 3] {
    let size = bounds.size();
    let largest = size.max_element();
    if boxes == 0 || !(largest > 0.0) {
        return [1; 3];
    }
    let size = size / largest;
    let wanted = CELLS_PER_BOX * boxes as f64;
    let mut flat = [false; 3];
    let mut side = 1.0;
    for _ in 0..3 {
        let cut: Vec<f64> = (0..3).filter(|&a| !flat[a]).map(|a| size[a]).collect();
        side = (cut.iter().product::<f64>() / wanted).powf(1.0 / cut.len() as f64);
        (0..3).for_each(|a| flat[a] |= size[a] <= side);
        if flat == [true; 3] {
            return [1; 3];
        }
    }
    // Cells that are wide enough for doubles to tell them apart.
    let reach = bounds.min.abs().max(bounds.max.abs()) / largest;
    std::array::from_fn(|a| {
        let finest = size[a] / reach[a] * (0.01 * PAD / f64::EPSILON);
        if flat[a] { 1 } else { (size[a] / side).min(MOST_CELLS).min(finest).max(1.0) as u16 }
    })
}

fn cells_of(block: &Block) -> usize {
    block.iter().map(|[first, last]| (usize::from(*last) + 1).saturating_sub(usize::from(*first))).product()
}

fn each_cell(block: &Block, counts: [u16; 3], mut visit: impl FnMut(usize)) {
    let [nx, ny, _] = counts.map(usize::from);
    let [x, y, z] = block.map(|[first, last]| usize::from(first)..usize::from(last) + 1);
    for k in z {
        for j in y.clone() {
            x.clone().for_each(|i| visit((k * ny + j) * nx + i));
        }
    }
}

#[cfg(test)]
mod tests;
