//! Gathered light by place: an octree whose cells are as large as their samples reach.
//!
//! A sample is seen from everywhere inside its cell enlarged by half on every side, and from everywhere if
//! its cell is the root. Cells are cubes of edge `2^level`, counted from a far corner of space.
//!
//! Reference: G. Ward, F. Rubinstein, R. Clear, "A Ray Tracing Solution for Diffuse Interreflection",
//! SIGGRAPH 1988.

use crate::color::Rgb;
use crate::math::Vec3;
use glam::{Vec3A, Vec4};

/// Light gathered at one place.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// How often the light has been reflected: 0 for what the camera sees.
    pub depth: u32,
    pub point: Vec3,
    /// Unit normal.
    pub normal: Vec3,
    pub color: Rgb,
    pub quality: f32,
    /// Harmonic mean of the distances to what was seen, within the bounds of reuse.
    pub radius: f32,
    /// Distance to the nearest thing seen, and its direction.
    pub nearest: f32,
    pub towards: Vec3,
    /// How far around the sample it is filed.
    pub reach: f64,
}

/// Where cells are counted from, along each axis.
const CORNER: f64 = 1e7;

/// Most cells along an axis.
const MOST_CELLS: f64 = 1e9;

const NONE: u32 = u32::MAX;

#[derive(Clone, Copy, Debug, PartialEq)]
struct Cell {
    level: i32,
    index: [i64; 3],
    edge: f64,
    /// Counted from the corner.
    center: Vec3,
}

impl Cell {
    fn new(level: i32, index: [i64; 3]) -> Self {
        let edge = f64::from(level).exp2();
        let center = Vec3::from_array(index.map(|i| (i as f64 + 0.5) * edge));
        Self { level, index, edge, center }
    }

    /// Places before the corner belong to the first cell.
    fn at(p: Vec3, level: i32) -> Self {
        let edge = f64::from(level).exp2();
        Self::new(level, p.to_array().map(|x| (((x + CORNER) / edge).floor() as i64).max(0)))
    }

    fn parent(self) -> Self {
        Self::new(self.level + 1, self.index.map(|i| i >> 1))
    }

    /// The cell of `level`, at or above its own, that contains it.
    fn ancestor(self, level: i32) -> Self {
        let up = (level - self.level).clamp(0, 63);
        Self::new(self.level.max(level), self.index.map(|i| i >> up))
    }

    fn contains(self, cell: Cell) -> bool {
        cell.level <= self.level && cell.ancestor(self.level).index == self.index
    }

    /// The smallest cell that contains both.
    fn joined(self, cell: Cell) -> Self {
        let mut over = self;
        while !over.contains(cell) {
            over = over.parent();
        }
        over
    }

    /// Which child of its parent it is.
    fn octant(self) -> usize {
        let [x, y, z] = self.index.map(|i| (i & 1) as usize);
        (x << 2) | (y << 1) | z
    }

    /// Whether `p` lies strictly inside the cell enlarged by half its edge on every side.
    fn surrounds(self, p: Vec3) -> bool {
        self.holds(p + CORNER)
    }

    /// The same for a point counted from the corner.
    fn holds(&self, shifted: Vec3) -> bool {
        (shifted - self.center).abs().cmplt(Vec3::splat(self.edge)).all()
    }

    /// The cell of a sample at `p` that reaches `reach` around.
    fn of(p: Vec3, reach: f64) -> Self {
        let mut level = f64::from((2.0 * reach) as f32).log2().floor().max(-1000.0) as i32;
        let far = (p - reach).abs().max_element() + CORNER;
        level = level.max((far / MOST_CELLS).log2().ceil() as i32);
        let mut cell = Cell::at(p, level);
        while !(cell.surrounds(p - reach) && cell.surrounds(p + reach)) && cell.level < 1000 {
            cell = cell.parent();
        }
        cell
    }
}

/// What a search reads first of samples: four side by side, in single precision. Places are counted from the
/// centre of their cell, so that rounding stays small against their reach.
#[derive(Clone, Copy, Debug)]
struct Heads {
    /// By axis. Lanes without a sample lie at infinity.
    points: [Vec4; 3],
    normals: [Vec4; 3],
    radii: Vec4,
    /// Places in `Cache::samples`.
    places: [u32; 4],
}

impl Heads {
    const NONE: Self =
        Self { points: [Vec4::INFINITY; 3], normals: [Vec4::ZERO; 3], radii: Vec4::ZERO, places: [NONE; 4] };

    fn set(&mut self, lane: usize, point: Vec3A, sample: &Sample, place: u32) {
        let normal = sample.normal.as_vec3();
        for axis in 0..3 {
            self.points[axis][lane] = point[axis];
            self.normals[axis][lane] = normal[axis];
        }
        self.radii[lane] = sample.radius;
        self.places[lane] = place;
    }

    /// A bit for each sample whose radius reaches `p` and whose normal is near enough.
    #[inline]
    fn near(&self, p: Vec3A, slack: f32, search: &Search) -> u32 {
        let [x, y, z] = self.points;
        let (x, y, z) = (x - p.x, y - p.y, z - p.z);
        let reach = self.radii * search.bound + slack;
        let [nx, ny, nz] = self.normals;
        let cosine = nx * search.normal.x + ny * search.normal.y + nz * search.normal.z;
        let near = (x * x + y * y + z * z).cmplt(reach * reach);
        (near & cosine.cmpgt(Vec4::splat(search.cosine))).bitmask()
    }
}

#[derive(Clone, Debug)]
struct Node {
    cell: Cell,
    edge: f32,
    children: [u32; 8],
    /// A bit for each child that there is.
    present: u8,
    /// The newest last.
    samples: Vec<Heads>,
    count: usize,
}

impl Node {
    fn new(cell: Cell) -> Self {
        let edge = cell.edge as f32;
        Self { cell, edge, children: [NONE; 8], present: 0, samples: Vec::new(), count: 0 }
    }

    fn adopt(&mut self, octant: usize, child: u32) {
        self.children[octant] = child;
        self.present |= 1 << octant;
    }

    /// A point counted from the corner, as one counted from the cell's centre.
    #[inline]
    fn seen_from_center(&self, shifted: Vec3) -> Vec3A {
        (shifted - self.cell.center).as_vec3a()
    }

    fn add(&mut self, sample: &Sample, place: u32) {
        let lane = self.count % 4;
        if lane == 0 {
            self.samples.push(Heads::NONE);
        }
        self.count += 1;
        let from_center = self.seen_from_center(sample.point + CORNER);
        if let Some(heads) = self.samples.last_mut() {
            heads.set(lane, from_center, sample, place);
        }
    }
}

/// Samples of one depth.
#[derive(Clone, Debug, Default)]
struct Tree {
    nodes: Vec<Node>,
    root: u32,
}

/// The octree. Samples of different depths do not meet; what is the root is decided by all of them.
#[derive(Clone, Debug, Default)]
pub struct Cache {
    samples: Vec<Sample>,
    trees: Vec<Tree>,
    root: Option<Cell>,
}

impl Cache {
    /// In order of insertion.
    pub fn samples(&self) -> &[Sample] {
        &self.samples
    }

    pub fn clear(&mut self) {
        self.samples.clear();
        self.trees.iter_mut().for_each(|t| t.nodes.clear());
        self.root = None;
    }

    pub fn insert(&mut self, sample: Sample) {
        let cell = Cell::of(sample.point, sample.reach);
        let depth = sample.depth as usize;
        if self.trees.len() <= depth {
            self.trees.resize_with(depth + 1, Tree::default);
        }
        let root = self.root.map_or(cell, |root| root.joined(cell));
        self.root = Some(root);
        self.trees[depth].insert(cell, &sample, self.samples.len() as u32);
        self.samples.push(sample);
    }

    /// Calls `visit` with the samples of `depth` that are seen from `p`, whose radius times `bound` reaches it
    /// and whose normals are near enough to `normal`; a few others may be among them.
    pub fn around(&self, p: Vec3, normal: Vec3, depth: u32, bound: f64, mut visit: impl FnMut(&Sample)) {
        let Some(tree) = self.trees.get(depth as usize) else { return };
        let Some(root) = tree.nodes.get(tree.root as usize) else { return };
        // An error of 2 sqrt(1 - cosine) must stay below the bound.
        let cosine = (1.0 - 0.25 * bound * bound - ROUNDING) as f32;
        let (normal, bound) = (normal.as_vec3(), (bound * (1.0 + ROUNDING)) as f32);
        let search = Search { shifted: p + CORNER, bound, normal, cosine };
        let inside = root.cell.holds(search.shifted);
        if inside {
            self.visit_node(tree, root, &search, &mut visit);
        } else if Some(root.cell) == self.root {
            self.visit_samples(root, root.seen_from_center(search.shifted), &search, &mut visit);
        }
    }

    /// The samples of a node that surrounds the point, those below it first.
    fn visit_node(&self, tree: &Tree, node: &Node, search: &Search, visit: &mut impl FnMut(&Sample)) {
        let p = node.seen_from_center(search.shifted);
        if node.present != 0 {
            let mut left = node.present & octants_around(p, node.edge);
            while left != 0 {
                let child = &tree.nodes[node.children[left.trailing_zeros() as usize] as usize];
                left &= left - 1;
                self.visit_node(tree, child, search, visit);
            }
        }
        self.visit_samples(node, p, search, visit);
    }

    #[inline]
    fn visit_samples(&self, node: &Node, p: Vec3A, search: &Search, visit: &mut impl FnMut(&Sample)) {
        let slack = ROUNDING as f32 * node.edge;
        for heads in node.samples.iter().rev() {
            let mut near = heads.near(p, slack, search);
            while near != 0 {
                let lane = 31 - near.leading_zeros();
                near ^= 1 << lane;
                visit(&self.samples[heads.places[lane as usize & 3] as usize]);
            }
        }
    }
}

/// A bit for each octant of a cell of `edge` whose own cell, enlarged, holds the point `v` from the centre.
#[inline]
fn octants_around(v: Vec3A, edge: f32) -> u8 {
    let (near, far) = (Vec3A::splat(0.25 * edge), Vec3A::splat(0.75 * edge));
    let low = (v.cmplt(near) & v.cmpgt(-far)).bitmask() as usize;
    let high = (v.cmpgt(-near) & v.cmplt(far)).bitmask() as usize;
    OCTANTS[(low | high << 3) & 63]
}

/// Octants by the sides that a point is near to: three bits for the low sides of x, y, z, three for the high ones.
const OCTANTS: [u8; 64] = {
    const LOW: [u8; 3] = [0x0f, 0x33, 0x55];
    let mut table = [0; 64];
    let mut sides = 0;
    while sides < 64 {
        let (mut octants, mut axis) = (0xff, 0);
        while axis < 3 {
            let low = if sides >> axis & 1 != 0 { LOW[axis] } else { 0 };
            let high = if sides >> (axis + 3) & 1 != 0 { !LOW[axis] } else { 0 };
            octants &= low | high;
            axis += 1;
        }
        table[sides] = octants;
        sides += 1;
    }
    table
};

/// Where samples are looked for.
struct Search {
    /// The point, counted from the corner.
    shifted: Vec3,
    bound: f32,
    normal: glam::Vec3,
    /// The least cosine between normals.
    cosine: f32,
}

/// Of single-precision cosines and distances, and more.
const ROUNDING: f64 = 1e-6;

impl Tree {
    fn insert(&mut self, cell: Cell, sample: &Sample, place: u32) {
        let node = self.node(cell);
        self.nodes[node as usize].add(sample, place);
    }

    /// The node of `cell`, made if need be together with all between it and the root.
    fn node(&mut self, cell: Cell) -> u32 {
        if self.nodes.is_empty() {
            self.nodes.push(Node::new(cell));
            self.root = 0;
            return 0;
        }
        self.raise_root(cell);
        let mut at = self.root;
        while self.nodes[at as usize].cell.level > cell.level {
            let next = cell.ancestor(self.nodes[at as usize].cell.level - 1);
            let octant = next.octant();
            at = match self.nodes[at as usize].children[octant] {
                NONE => {
                    let made = self.nodes.len() as u32;
                    self.nodes.push(Node::new(next));
                    self.nodes[at as usize].adopt(octant, made);
                    made
                }
                child => child,
            };
        }
        at
    }

    /// Puts parents over the root until it contains `cell`.
    fn raise_root(&mut self, cell: Cell) {
        loop {
            let root = self.nodes[self.root as usize].cell;
            if root.contains(cell) {
                return;
            }
            let mut over = Node::new(root.parent());
            over.adopt(root.octant(), self.root);
            self.root = self.nodes.len() as u32;
            self.nodes.push(over);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(point: Vec3, reach: f64) -> Sample {
        Sample {
            depth: 0,
            point,
            normal: Vec3::Y,
            color: Rgb::ONE,
            quality: 1.0,
            radius: reach as f32,
            nearest: 1.0,
            towards: Vec3::Y,
            reach,
        }
    }

    /// Whatever its cell, a sample is seen from everywhere within its reach.
    #[test]
    fn samples_are_found_within_their_reach() {
        let mut cache = Cache::default();
        let places: Vec<(Vec3, f64)> = (0..400)
            .map(|i| {
                let f = f64::from(i);
                let p = Vec3::new((f * 0.37).sin() * 30.0, (f * 0.11).cos() * 9.0, (f * 0.73).sin() * 200.0);
                (p, 0.02 * 1.02f64.powi(i))
            })
            .collect();
        places.iter().for_each(|&(p, reach)| cache.insert(sample(p, reach)));
        for &(p, reach) in &places {
            for shift in [Vec3::X, -Vec3::Y, Vec3::Z, Vec3::splat(-0.57)] {
                let mut found = false;
                cache.around(p + 0.999 * reach * shift, Vec3::Y, 0, 1.0, |s| found |= s.point == p);
                assert!(found, "{p} {reach}");
            }
        }
        cache.around(Vec3::ZERO, Vec3::Y, 1, 1.0, |_| panic!("no sample has that depth"));
    }

    #[test]
    fn far_samples_are_not_visited() {
        let mut cache = Cache::default();
        cache.insert(sample(Vec3::ZERO, 0.5));
        cache.insert(sample(Vec3::splat(1000.0), 0.5));
        let mut count = 0;
        cache.around(Vec3::splat(999.9), Vec3::Y, 0, 1.0, |_| count += 1);
        assert_eq!(count, 1);
    }
}
