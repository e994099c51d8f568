//! Height field: a grid of heights over the unit square in x and z, two triangles per cell.
//!
//! | parameter | unit | default | meaning |
//! |---|---|---|---|
//! | samples | 1/65536 | | heights, row by row from z = 0, at x = i/(W-1), z = j/(H-1) |
//! | smooth | – | off | interpolates normals over each cell |
//! | water_level | 1/65536 | 0 | what lies lower is not drawn, but is inside |
//!
//! A cell is cut along the diagonal from (x+1, z) to (x, z+1). Inside is what lies below the surface or the
//! water level and above the square; nothing bounds it below.
//!
//! Smooth normals are the average of the up to four triangles at the corners of the squares around a
//! sample, in single steps of 1/32767. They are turned into world space and made unit length before they
//! are interpolated, so the shape has to know where it stands.
//!
//! Numerical care: cells share their corners to the bit and rays are tested by the signs of edge functions,
//! so none slips between two cells.
//!
//! A tree of the least and greatest heights in blocks of 4, 16, 64 … cells a side leads a ray to the cells that
//! it can meet, nearest first.

mod blocks;
#[cfg(target_arch = "x86_64")]
mod wide;

use super::triangle::Shear;
use super::{Crossing, Shape, rounding};
use crate::math::{Aabb, Range, Ray, Transform, Vec2, Vec3};
use blocks::{Block, Blocks, CellRows, Parts, Passed, ROW, Walk};
use glam::DMat3;
use std::sync::Arc;

/// Heights count in these parts of a unit.
const UNIT: f64 = 65536.0;
/// Vertex normals count in these parts.
const NORMAL_STEPS: f64 = 32767.0;

#[derive(Clone, Debug)]
pub struct HeightField {
    grid: Arc<Grid>,
    smooth: bool,
    /// Height below which nothing is drawn, in units.
    floor: f64,
    /// Height up to which everything is inside, in units.
    water: f64,
    /// Takes normals from grid space (cells and height steps) to the world.
    grid_normal: DMat3,
    /// Takes normals from the world to the shape's space.
    world_normal: DMat3,
}

#[derive(Clone, Debug)]
pub(super) struct Grid {
    width: usize,
    height: usize,
    /// Row by row, and a few more: whole blocks of cells are read at once.
    samples: Vec<u16>,
    blocks: Blocks,
}

impl Grid {
    fn sample(&self, i: usize, j: usize) -> u16 {
        self.samples[j * self.width + i]
    }

    fn vertex(&self, i: usize, j: usize) -> Vec3 {
        let (columns, rows) = (self.width - 1, self.height - 1);
        let h = f64::from(self.sample(i, j)) / UNIT;
        Vec3::new(i as f64 / columns as f64, h, j as f64 / rows as f64)
    }

    /// In cells and steps of height: the corners that the lower triangle has first, then the other one's.
    #[inline(always)]
    fn cell_corners(&self, i: usize, j: usize) -> [Vec3; 4] {
        let (x, z, first) = (i as f64, j as f64, j * self.width + i);
        let h = |n: usize| f64::from(self.samples[n]);
        [
            Vec3::new(x, h(first), z),
            Vec3::new(x + 1.0, h(first + 1), z),
            Vec3::new(x, h(first + self.width), z + 1.0),
            Vec3::new(x + 1.0, h(first + self.width + 1), z + 1.0),
        ]
    }

    /// Corners of the lower or the upper triangle of a cell.
    fn triangle(&self, i: usize, j: usize, upper: bool) -> [Vec3; 3] {
        let (right, far) = (self.vertex(i + 1, j), self.vertex(i, j + 1));
        if upper { [self.vertex(i + 1, j + 1), far, right] } else { [self.vertex(i, j), right, far] }
    }

    /// The averaged normal at a sample, in grid space.
    fn vertex_normal(&self, i: usize, j: usize) -> Vec3 {
        let h = |i: usize, j: usize| f64::from(self.sample(i, j));
        let here = h(i, j);
        let (left, right) = (i > 0, i + 1 < self.width);
        let (near, far) = (j > 0, j + 1 < self.height);
        let mut sum = Vec3::ZERO;
        let mut corner = |has: bool, x: f64, z: f64| {
            if has {
                let n = Vec3::new(x, 1.0, z);
                sum += n.normalize();
            }
        };
        let dx = |forward: bool| if forward { here - h(i + 1, j) } else { h(i - 1, j) - here };
        let dz = |forward: bool| if forward { here - h(i, j + 1) } else { h(i, j - 1) - here };
        for (ok_x, forward_x) in [(right, true), (left, false)] {
            for (ok_z, forward_z) in [(far, true), (near, false)] {
                if ok_x && ok_z {
                    corner(true, dx(forward_x), dz(forward_z));
                }
            }
        }
        let n = sum.normalize_or(Vec3::Y);
        (n * NORMAL_STEPS).trunc() / NORMAL_STEPS
    }

    /// The heights at the corners of 4 by 4 cells from one on, and some more. Beyond the grid's sides they are anything.
    #[inline(always)]
    fn cell_rows(&self, i: usize, j: usize) -> CellRows<'_> {
        std::array::from_fn(|k| {
            let from = (j + k).min(self.height - 1) * self.width + i;
            self.samples[from..].first_chunk().unwrap_or(&[0; ROW])
        })
    }

    /// Least and greatest height of a cell.
    fn cell_range(&self, i: usize, j: usize) -> (u16, u16) {
        let (a, b) = (self.sample(i, j), self.sample(i + 1, j));
        let (c, d) = (self.sample(i, j + 1), self.sample(i + 1, j + 1));
        (a.min(b).min(c.min(d)), a.max(b).max(c.max(d)))
    }
}

impl HeightField {
    /// At least 2 by 2 samples, rows from z = 0 up. `None` if there are fewer.
    pub fn new(
        width: usize,
        height: usize,
        mut samples: Vec<u16>,
        smooth: bool,
        water_level: f64,
    ) -> Option<Self> {
        if width < 2 || height < 2 || samples.len() != width * height {
            return None;
        }
        samples.reserve_exact(ROW);
        samples.extend([0; ROW]);
        let mut grid = Grid { width, height, samples, blocks: Blocks::default() };
        grid.blocks = Blocks::build(width - 1, height - 1, |i, j| grid.cell_range(i, j));
        let mut field = Self {
            grid: Arc::new(grid),
            smooth,
            floor: f64::NEG_INFINITY,
            water: water_level,
            grid_normal: DMat3::IDENTITY,
            world_normal: DMat3::IDENTITY,
        };
        if water_level > f64::from(field.grid.blocks.whole().0) / UNIT {
            field.floor = water_level;
        }
        field.place(&Transform::IDENTITY);
        Some(field)
    }

    fn place(&mut self, to_world: &Transform) {
        let (columns, rows) = ((self.grid.width - 1) as f64, (self.grid.height - 1) as f64);
        let from_grid = DMat3::from_diagonal(Vec3::new(columns, UNIT, rows));
        self.grid_normal = to_world.inverse.matrix3.transpose() * from_grid;
        self.world_normal = to_world.forward.matrix3.transpose();
    }

    /// Column and row of a crossing's cell, and whether it is on the upper triangle.
    fn cell(&self, crossing: &Crossing) -> (usize, usize, bool) {
        let (cell, upper) = (crossing.part as usize / 2, crossing.part % 2 == 1);
        (cell % (self.grid.width - 1), cell / (self.grid.width - 1), upper)
    }

    /// Calls `found` with crossings; it returns up to where others still count.
    #[inline(always)]
    fn visit(&self, ray: &Ray, range: Range, found: impl FnMut(Crossing) -> f64) {
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has just been seen to have what `visit_wide` is compiled for.
            #[allow(unsafe_code)]
            return unsafe { self.visit_wide(ray, range, found) };
        }
        self.visit_by(ray, range, Parts::of_cells, Walk::passed, found);
    }

    /// Four parts of a block at once: with it a block of 27 fields takes 0.85 of the time.
    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    #[inline]
    fn visit_wide(&self, ray: &Ray, range: Range, found: impl FnMut(Crossing) -> f64) {
        let passed =
            |walk: &Walk, block: &Block, range, parts: &Parts| wide::passed(walk, block, range, parts);
        self.visit_by(ray, range, |rows| wide::of_cells(rows), passed, found);
    }

    #[inline(always)]
    fn visit_by(
        &self,
        ray: &Ray,
        range: Range,
        of_cells: impl Fn(CellRows) -> Parts,
        passed: impl Fn(&Walk, &Block, Range, &Parts) -> Passed,
        mut found: impl FnMut(Crossing) -> f64,
    ) {
        let grid = &self.grid;
        // Between samples 1 apart: corners are whole numbers.
        let scale = Vec3::new((grid.width - 1) as f64, UNIT, (grid.height - 1) as f64);
        let local = Ray::new(ray.origin * scale, ray.dir * scale);
        let shear = Shear::new(local.dir);
        let cells = |i: usize, j: usize| of_cells(grid.cell_rows(i, j));
        grid.blocks.traverse(&local, range, cells, passed, |i, j, max| {
            let mut max = max;
            let corners = grid.cell_corners(i, j).map(|p| p - local.origin);
            let seen = corners.map(|p| shear.project(p));
            for (upper, [a, b, c]) in [(false, [0, 1, 2]), (true, [3, 2, 1])] {
                let Some(w) = Shear::inside(seen[a], seen[b], seen[c]) else { continue };
                let (a, b, c) = (corners[a], corners[b], corners[c]);
                let normal = (b - a).cross(c - a);
                let t = normal.dot(a) / normal.dot(local.dir);
                if t > range.min && t < max && ray.origin.y + t * ray.dir.y >= self.floor {
                    let part = 2 * (j * (grid.width - 1) + i) as u32 + u32::from(upper);
                    max = max.min(found(Crossing { t, part, uv: Vec2::new(w.y, w.z) }));
                }
            }
            max
        });
    }

    fn flat_normal(&self, crossing: &Crossing) -> Vec3 {
        let (i, j, upper) = self.cell(crossing);
        let [a, b, c] = self.grid.triangle(i, j, upper);
        (c - a).cross(b - a).normalize_or(Vec3::Y)
    }

    /// Interpolated over the cell in world space, in the shape's own space.
    fn smooth_normal(&self, p: Vec3, crossing: &Crossing) -> Vec3 {
        let (i, j, _) = self.cell(crossing);
        let u = (p.x * (self.grid.width - 1) as f64 - i as f64).clamp(0.0, 1.0);
        let v = (p.z * (self.grid.height - 1) as f64 - j as f64).clamp(0.0, 1.0);
        let at =
            |i: usize, j: usize| (self.grid_normal * self.grid.vertex_normal(i, j)).normalize_or(Vec3::Y);
        let near = (1.0 - u) * at(i, j) + u * at(i + 1, j);
        let far = (1.0 - u) * at(i, j + 1) + u * at(i + 1, j + 1);
        (self.world_normal * ((1.0 - v) * near + v * far)).normalize_or(Vec3::Y)
    }

    /// Height of the surface above a point of the square.
    fn height_at(&self, x: f64, z: f64) -> f64 {
        let grid = &self.grid;
        let (gx, gz) = (x * (grid.width - 1) as f64, z * (grid.height - 1) as f64);
        let (i, j) = ((gx as usize).min(grid.width - 2), (gz as usize).min(grid.height - 2));
        let (u, v) = (gx - i as f64, gz - j as f64);
        let h = |i: usize, j: usize| f64::from(grid.sample(i, j)) / UNIT;
        let (right, far) = (h(i + 1, j), h(i, j + 1));
        if u + v <= 1.0 {
            let here = h(i, j);
            here + u * (right - here) + v * (far - here)
        } else {
            let there = h(i + 1, j + 1);
            there + (1.0 - u) * (far - there) + (1.0 - v) * (right - there)
        }
    }
}

impl Shape for HeightField {
    fn bounds(&self) -> Aabb {
        let (low, high) = self.grid.blocks.whole();
        let low = (f64::from(low) / UNIT).max(self.floor);
        Aabb { min: Vec3::new(0.0, low, 0.0), max: Vec3::new(1.0, f64::from(high) / UNIT, 1.0) }
    }

    fn inside_bounds(&self) -> Aabb {
        let b = self.bounds();
        Aabb { min: b.min.with_y(f64::NEG_INFINITY), max: b.max.with_y(b.max.y.max(self.water)) }
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        self.visit(ray, range, |c| {
            out.push(c);
            f64::INFINITY
        });
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let mut best = None;
        self.visit(ray, range, |c| {
            best = Some(c);
            c.t
        });
        best
    }

    fn meets(&self, ray: &Ray, range: Range) -> bool {
        let mut met = false;
        self.visit(ray, range, |_| {
            met = true;
            f64::NEG_INFINITY
        });
        met
    }

    fn contains(&self, p: Vec3) -> bool {
        let over = p.x >= 0.0 && p.x < 1.0 && p.z >= 0.0 && p.z < 1.0;
        over && (p.y < self.water || p.y < self.height_at(p.x, p.z))
    }

    fn normal(&self, p: Vec3, crossing: &Crossing) -> Vec3 {
        if self.smooth { self.smooth_normal(p, crossing) } else { self.flat_normal(crossing) }
    }

    fn face_normal(&self, _p: Vec3, crossing: &Crossing) -> Option<Vec3> {
        self.smooth.then(|| self.flat_normal(crossing))
    }

    fn placed(&self, to_world: &Transform) -> Option<Arc<dyn Shape>> {
        self.smooth.then(|| {
            let mut placed = self.clone();
            placed.place(to_world);
            Arc::new(placed) as Arc<dyn Shape>
        })
    }

    fn locate(&self, _ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        let (i, j, upper) = self.cell(crossing);
        let [a, b, c] = self.grid.triangle(i, j, upper);
        let uv = crossing.uv;
        ((1.0 - uv.x - uv.y) * a + uv.x * b + uv.y * c, rounding(4.0))
    }

    fn kind(&self) -> &'static str {
        "height_field"
    }

    fn heap_bytes(&self) -> usize {
        self.grid.samples.capacity() * 2 + self.grid.blocks.heap_bytes()
    }
}

#[cfg(test)]
mod tests;
