//! Gathered light by place: an octree whose cells are as large as their samples reach.
//!
//! A sample is seen from everywhere inside its cell enlarged by half on every side, and from everywhere if
//! its cell is the root. Cells are cubes of edge `2^level`, counted from a far corner of space.
//!
//! Reference: G. Ward, F. Rubinstein, R. Clear, "A Ray Tracing Solution for Diffuse Interreflection",
//! SIGGRAPH 1988.

use crate::color::Rgb;
use crate::math::Vec3;

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

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Cell {
    level: i32,
    index: [i64; 3],
}

impl Cell {
    fn edge(self) -> f64 {
        f64::from(self.level).exp2()
    }

    /// Places before the corner belong to the first cell.
    fn at(p: Vec3, level: i32) -> Self {
        let edge = f64::from(level).exp2();
        Self { level, index: p.to_array().map(|x| (((x + CORNER) / edge).floor() as i64).max(0)) }
    }

    fn parent(self) -> Self {
        Self { level: self.level + 1, index: self.index.map(|i| i >> 1) }
    }

    /// The cell of `level`, at or above its own, that contains it.
    fn ancestor(self, level: i32) -> Self {
        let up = (level - self.level).clamp(0, 63);
        Self { level: self.level.max(level), index: self.index.map(|i| i >> up) }
    }

    /// Which child of its parent it is.
    fn octant(self) -> usize {
        let [x, y, z] = self.index.map(|i| (i & 1) as usize);
        (x << 2) | (y << 1) | z
    }

    /// Whether `p` lies strictly inside the cell enlarged by half its edge on every side.
    fn surrounds(self, p: Vec3) -> bool {
        let edge = self.edge();
        let p = p.to_array();
        (0..3).all(|a| (p[a] + CORNER - (self.index[a] as f64 + 0.5) * edge).abs() < edge)
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

#[derive(Clone, Debug)]
struct Node {
    cell: Cell,
    children: [u32; 8],
    /// Places in `Cache::samples`, the newest last.
    samples: Vec<u32>,
}

impl Node {
    fn new(cell: Cell) -> Self {
        Self { cell, children: [NONE; 8], samples: Vec::new() }
    }
}

/// The octree. Holds samples of all depths.
#[derive(Clone, Debug, Default)]
pub struct Cache {
    samples: Vec<Sample>,
    nodes: Vec<Node>,
    root: u32,
}

impl Cache {
    /// In order of insertion.
    pub fn samples(&self) -> &[Sample] {
        &self.samples
    }

    pub fn clear(&mut self) {
        self.samples.clear();
        self.nodes.clear();
    }

    pub fn insert(&mut self, sample: Sample) {
        let cell = Cell::of(sample.point, sample.reach);
        let place = self.samples.len() as u32;
        self.samples.push(sample);
        let node = self.node(cell);
        self.nodes[node as usize].samples.push(place);
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
                    self.nodes[at as usize].children[octant] = made;
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
            if cell.level <= root.level && cell.ancestor(root.level) == root {
                return;
            }
            let mut over = Node::new(root.parent());
            over.children[root.octant()] = self.root;
            self.root = self.nodes.len() as u32;
            self.nodes.push(over);
        }
    }

    /// Calls `visit` with the samples of `depth` that are seen from `p`.
    pub fn around(&self, p: Vec3, depth: u32, mut visit: impl FnMut(&Sample)) {
        let Some(root) = self.nodes.get(self.root as usize) else { return };
        self.visit_samples(root, depth, &mut visit);
        if root.cell.surrounds(p) {
            self.visit_children(root, p, depth, &mut visit);
        }
    }

    fn visit_children(&self, node: &Node, p: Vec3, depth: u32, visit: &mut impl FnMut(&Sample)) {
        for &child in node.children.iter().filter(|&&c| c != NONE) {
            let child = &self.nodes[child as usize];
            if child.cell.surrounds(p) {
                self.visit_children(child, p, depth, visit);
                self.visit_samples(child, depth, visit);
            }
        }
    }

    fn visit_samples(&self, node: &Node, depth: u32, visit: &mut impl FnMut(&Sample)) {
        for &i in node.samples.iter().rev() {
            let sample = &self.samples[i as usize];
            if sample.depth == depth {
                visit(sample);
            }
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
                cache.around(p + 0.999 * reach * shift, 0, |s| found |= s.point == p);
                assert!(found, "{p} {reach}");
            }
        }
        cache.around(Vec3::ZERO, 1, |_| panic!("no sample has that depth"));
    }

    #[test]
    fn far_samples_are_not_visited() {
        let mut cache = Cache::default();
        cache.insert(sample(Vec3::ZERO, 0.5));
        cache.insert(sample(Vec3::splat(1000.0), 0.5));
        let mut count = 0;
        cache.around(Vec3::splat(999.9), 0, |_| count += 1);
        assert_eq!(count, 1);
    }
}
