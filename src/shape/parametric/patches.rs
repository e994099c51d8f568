//! What is the same for all rays: the surface's points at the corners of the first halvings, and the boxes
//! around the parts of the surface.
//!
//! A patch's box comes from its corners and bounds of the functions' slopes: their own, where they are known,
//! else the scene's. It is grown by as much as the smallest rectangles' bounds reach beyond the surface, so the
//! boxes leave out no rectangle that would have been met. Patches are divided further when a ray first
//! meets them.

use super::{Parametric, Rectangle};
use crate::math::{Aabb, Vec2, Vec3};
use smallvec::SmallVec;
use std::sync::OnceLock;

/// How often the domain is halved for the boxes, and a patch again when it is met.
const HALVINGS: u32 = 14;
const INNER_HALVINGS: u32 = 6;
/// Slopes are worked out for blocks of this many patches a side.
const BLOCK: usize = 8;

pub(super) struct Patches {
    /// Around the whole, its halves, the halves of those …: part i's halves are parts 2 i + 1 and 2 i + 2.
    boxes: Vec<Aabb>,
    /// Along which axis each halving goes.
    axes: Vec<usize>,
    /// Of a patch.
    size: Vec2,
    corners: Grid,
    /// Cells a side within a patch, and their corners.
    cells: [usize; 2],
    inner: Vec<OnceLock<Grid>>,
}

/// A rectangle of the domain divided evenly, with the surface's points.
#[derive(Debug)]
pub(super) struct Grid {
    /// The parameters at which it is divided.
    stops: [Vec<f64>; 2],
    /// Row by row.
    points: Vec<Vec3>,
}

impl std::fmt::Debug for Patches {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        write!(f, "{} patches", self.inner.len())
    }
}

/// A range of a slope.
type Slope = (f64, f64);

/// Halves the longer side again and again: along which axes, and what is left.
fn halvings(mut size: Vec2, most: u32, smallest: f64) -> (Vec<usize>, Vec2) {
    let mut axes = Vec::new();
    for _ in 0..most {
        if !(size.abs().max_element() > smallest) {
            break;
        }
        let axis = usize::from(size.x < size.y);
        axes.push(axis);
        size[axis] *= 0.5;
    }
    (axes, size)
}

/// How many parts halvings make along each axis.
fn counts(axes: &[usize]) -> [usize; 2] {
    [0, 1].map(|axis| 1 << axes.iter().filter(|&&a| a == axis).count())
}

/// How far values over a stretch of length `h` may lie below and above those at its ends.
fn bulge(a: f64, b: f64, h: f64, slope: Slope) -> f64 {
    let (rise, width) = (b - a, (slope.1 - slope.0) * h);
    if width > 0.0 { ((rise - slope.0 * h) * (slope.1 * h - rise) / width).max(0.0) } else { 0.0 }
}

impl Patches {
    pub fn new(surface: &Parametric) -> Self {
        let (axes, size) = halvings(surface.high - surface.low, HALVINGS, surface.accuracy);
        let [columns, rows] = counts(&axes);
        let cells = counts(&halvings(size, INNER_HALVINGS, surface.accuracy).0);
        let corners = Grid::new(surface, surface.low, surface.high, [columns, rows]);
        let inner = (0..columns * rows).map(|_| OnceLock::new()).collect();
        let mut patches = Self { boxes: Vec::new(), axes, size, corners, cells, inner };
        patches.boxes = patches.all_boxes(surface);
        patches
    }

    /// Column and row of a patch; patches are counted as halving the domain leads to them.
    fn place(&self, patch: usize) -> [usize; 2] {
        let mut place = [0, 0];
        for (level, &axis) in self.axes.iter().enumerate() {
            let bit = patch >> (self.axes.len() - 1 - level) & 1;
            place[axis] = 2 * place[axis] + bit;
        }
        place
    }

    /// The next patch in whose box `meets` sees something to find; `todo` are the parts left, 0 at first.
    pub fn next(&self, todo: &mut SmallVec<[u32; 32]>, meets: impl Fn(&Aabb) -> bool) -> Option<usize> {
        let first = (1 << self.axes.len()) - 1;
        while let Some(part) = todo.pop() {
            if !meets(&self.boxes[part as usize]) {
                continue;
            }
            match (part as usize).checked_sub(first) {
                Some(patch) => return Some(patch),
                None => todo.extend([2 * part + 2, 2 * part + 1]),
            }
        }
        None
    }

    fn all_boxes(&self, surface: &Parametric) -> Vec<Aabb> {
        let margin = (1.0 + surface.max_gradient.abs()) * surface.accuracy.abs();
        let [columns, rows] = counts(&self.axes);
        let blocks = columns.div_ceil(BLOCK);
        let slopes: Vec<[[Slope; 2]; 3]> = (0..blocks * rows.div_ceil(BLOCK))
            .map(|b| [(b % blocks) * BLOCK, (b / blocks) * BLOCK])
            .map(|at| {
                let to = [(at[0] + BLOCK).min(columns), (at[1] + BLOCK).min(rows)];
                slopes(surface, self.corners.parameters(at), self.corners.parameters(to))
            })
            .collect();
        let first = (1 << self.axes.len()) - 1;
        let mut boxes = vec![Aabb::EMPTY; 2 * first + 1];
        for (patch, found) in boxes[first..].iter_mut().enumerate() {
            let [i, j] = self.place(patch);
            let slopes = &slopes[j / BLOCK * blocks + i / BLOCK];
            let patch = self.patch_box(&self.corners.rectangle([i, j], [1, 1]).corners, slopes).grown(margin);
            *found = if patch.is_finite() { patch } else { surface.container.bounds() };
        }
        for part in (0..first).rev() {
            boxes[part] = boxes[2 * part + 1].union(boxes[2 * part + 2]);
        }
        boxes
    }

    fn patch_box(&self, corners: &[Vec3; 4], slopes: &[[Slope; 2]; 3]) -> Aabb {
        let h = self.size.abs();
        let mut patch = corners.iter().fold(Aabb::EMPTY, |b, &p| b.extended(p));
        for axis in 0..3 {
            let [a, b, c, d] = corners.map(|p| p[axis]);
            let [by_u, by_v] = slopes[axis];
            // Along both sides in v; then between two points of these at one v, which differ by at most that much.
            let sides = bulge(a, b, h.y, by_v).max(bulge(c, d, h.y, by_v));
            let (low, high) = (patch.min[axis] - sides, patch.max[axis] + sides);
            let across = bulge_of_any(high - low, h.x, by_u);
            (patch.min[axis], patch.max[axis]) = (low - across, high + across);
        }
        patch
    }

    /// A patch's own cells.
    pub fn inner(&self, surface: &Parametric, patch: usize) -> &Grid {
        self.inner[patch].get_or_init(|| {
            let [i, j] = self.place(patch);
            let (low, high) = (self.corners.parameters([i, j]), self.corners.parameters([i + 1, j + 1]));
            Grid::new(surface, low, high, self.cells)
        })
    }

    pub fn heap_bytes(&self) -> usize {
        let inner: usize = self.inner.iter().filter_map(OnceLock::get).map(Grid::heap_bytes).sum();
        size_of_val(&self.boxes[..]) + self.corners.heap_bytes() + size_of_val(&self.inner[..]) + inner
    }
}

/// Of the three functions by u and v, over a block of patches.
fn slopes(surface: &Parametric, low: Vec2, high: Vec2) -> [[Slope; 2]; 3] {
    let block = Aabb::new(low.extend(0.0), high.extend(0.0));
    let written = (-surface.max_gradient, surface.max_gradient);
    surface.functions.each_ref().map(|f| match f.enclosure(&block) {
        Some(e) => [0, 1].map(|axis| {
            let s = e.gradient[axis];
            if s.0.is_finite() && s.1.is_finite() { s } else { written }
        }),
        None => [written; 2],
    })
}

/// The largest bulge for any rise up to `rise` in size.
fn bulge_of_any(rise: f64, h: f64, slope: Slope) -> f64 {
    let middle = 0.5 * (slope.0 + slope.1) * h;
    // Not `clamp`, which refuses what is no number.
    let at = middle.max(-rise).min(rise);
    bulge(0.0, at, h, slope)
}

/// Both ends and the places between them to which halving leads; `count` is a power of two.
fn stops(low: f64, high: f64, count: usize) -> Vec<f64> {
    let mut stops = vec![low; count + 1];
    stops[count] = high;
    let mut step = count;
    while step > 1 {
        for i in (0..count).step_by(step) {
            stops[i + step / 2] = 0.5 * (stops[i] + stops[i + step]);
        }
        step /= 2;
    }
    stops
}

impl Grid {
    fn new(surface: &Parametric, low: Vec2, high: Vec2, [columns, rows]: [usize; 2]) -> Self {
        let stops = [stops(low.x, high.x, columns), stops(low.y, high.y, rows)];
        let row = |v: &f64| stops[0].iter().map(move |&u| surface.at(Vec2::new(u, *v))).collect::<Vec<_>>();
        let points = stops[1].iter().flat_map(row).collect();
        Self { stops, points }
    }

    fn parameters(&self, [i, j]: [usize; 2]) -> Vec2 {
        Vec2::new(self.stops[0][i], self.stops[1][j])
    }

    /// How many cells there are along u and v.
    pub fn cells(&self) -> [usize; 2] {
        [self.stops[0].len() - 1, self.stops[1].len() - 1]
    }

    /// The rectangle of `size` cells from `at` on.
    pub fn rectangle(&self, at: [usize; 2], size: [usize; 2]) -> Rectangle {
        let point = |i: usize, j: usize| self.points[j * self.stops[0].len() + i];
        let ([i, j], [k, l]) = (at, [at[0] + size[0], at[1] + size[1]]);
        let corners = [point(i, j), point(i, l), point(k, j), point(k, l)];
        Rectangle { low: self.parameters(at), high: self.parameters([k, l]), corners, depth: 0 }
    }

    fn heap_bytes(&self) -> usize {
        size_of_val(&self.stops[0][..]) + size_of_val(&self.stops[1][..]) + size_of_val(&self.points[..])
    }
}
