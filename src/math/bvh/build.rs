use super::widen::Plan;
use super::{Bvh, COUNT_SHIFT, LEAF, MAX_LEAF, Node, WIDTH};
use crate::math::{Aabb, Vec3};
use glam::Vec3A;
use obvhs::BvhBuildParams;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::builder::build_bvh2;
use obvhs::ploc::PlocSearchDistance;
use smallvec::{SmallVec, smallvec};
use std::time::Duration;

/// How much building may cost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quality {
    /// One primitive a leaf and an optimised tree: for primitives that are costly to intersect.
    Best,
    /// Leaves of up to `leaf` primitives, built quickly: for triangles by the million.
    Fast { leaf: usize },
}

impl Quality {
    fn parameters(self) -> BvhBuildParams {
        match self {
            Quality::Best => BvhBuildParams {
                max_prims_per_leaf: 1,
                ploc_search_distance: PlocSearchDistance::VeryHigh,
                ..BvhBuildParams::medium_build()
            },
            Quality::Fast { .. } => BvhBuildParams { max_prims_per_leaf: 1, ..BvhBuildParams::fast_build() },
        }
    }

    /// The most primitives of a leaf.
    fn leaf(self) -> usize {
        match self {
            Quality::Best => 1,
            Quality::Fast { leaf } => leaf.clamp(1, MAX_LEAF),
        }
    }
}

/// A box whose middle is this many times the bulk's spread away from its middle, or which is this many
/// times larger, stands outside the bulk: sorting along a curve would squeeze the bulk into one cell.
const OUTLIER: f64 = 256.0;

impl Bvh {
    /// A tree over finite, non-empty boxes. Boxes that are not both are left out (no ray meets them).
    pub fn build(boxes: &[Aabb], quality: Quality) -> Bvh {
        assert!(boxes.len() < 1 << COUNT_SHIFT, "a tree holds fewer than 2^28 boxes");
        let usable: Vec<u32> = (0..boxes.len() as u32)
            .filter(|&i| boxes[i as usize].is_finite() && !boxes[i as usize].is_empty())
            .collect();
        let bounds = usable.iter().fold(Aabb::EMPTY, |b, &i| b.union(boxes[i as usize]));
        if usable.is_empty() {
            return Bvh::assemble(Vec::new(), Vec::new(), bounds, Vec3::ZERO, 1.0);
        }
        let bulk = Bulk::of(boxes, &usable);
        let frame = Frame::around(&bulk, &bounds);
        let mut wide = Collapse { nodes: Vec::new(), order: Vec::with_capacity(usable.len()) };
        let (inner, outer): (Vec<u32>, Vec<u32>) =
            usable.iter().partition(|&&i| bulk.holds(&boxes[i as usize]));
        if outer.is_empty() || inner.len() < 2 {
            wide.add_tree(&frame, boxes, usable, quality, None);
        } else {
            let tree = (frame.boxes(boxes, &inner), inner);
            wide.add_tree(&frame, boxes, outer, quality, Some(tree));
        }
        Bvh::assemble(wide.nodes, wide.order, bounds, frame.center, frame.scale)
    }
}

/// Where most of the boxes are.
pub(super) struct Bulk {
    center: Vec3,
    spread: Vec3,
}

impl Bulk {
    /// Medians and quartiles per axis, from at most a few thousand boxes evenly picked.
    pub fn of(boxes: &[Aabb], usable: &[u32]) -> Bulk {
        let step = usable.len().div_ceil(4096);
        let picked: Vec<&Aabb> = usable.iter().step_by(step).map(|&i| &boxes[i as usize]).collect();
        let mut center = Vec3::ZERO;
        let mut spread = Vec3::ZERO;
        for axis in 0..3 {
            let mut middles: Vec<f64> = picked.iter().map(|b| b.center()[axis]).collect();
            let mut sizes: Vec<f64> = picked.iter().map(|b| b.size()[axis]).collect();
            middles.sort_by(f64::total_cmp);
            sizes.sort_by(f64::total_cmp);
            let n = middles.len();
            center[axis] = middles[n / 2];
            spread[axis] = (middles[n - 1 - n / 8] - middles[n / 8]).max(sizes[n - 1 - n / 8]);
        }
        Bulk { center, spread: Vec3::splat(spread.max_element()) }
    }

    fn holds(&self, b: &Aabb) -> bool {
        let far = (b.max - self.center).max(self.center - b.min);
        far.cmple(self.spread * OUTLIER).all()
    }
}

/// The tree's own coordinates.
pub(super) struct Frame {
    pub center: Vec3,
    pub scale: f64,
}

impl Frame {
    pub fn around(bulk: &Bulk, bounds: &Aabb) -> Frame {
        let reach = (bounds.max - bulk.center).max(bulk.center - bounds.min).max_element();
        Frame { center: bulk.center, scale: power_of_two_below(1.0 / reach.max(f64::MIN_POSITIVE)) }
    }

    pub fn single(&self, b: &Aabb) -> obvhs::aabb::Aabb {
        let (lo, hi) = ((b.min - self.center) * self.scale, (b.max - self.center) * self.scale);
        // The subtraction's own rounding: half an ulp of the larger operand.
        let slack = |v: f64, c: f64| (v.abs() + c.abs()) * f64::EPSILON * self.scale;
        let low = |a: usize| round_down(lo[a] - slack(b.min[a], self.center[a]));
        let high = |a: usize| round_up(hi[a] + slack(b.max[a], self.center[a]));
        obvhs::aabb::Aabb::new(Vec3A::new(low(0), low(1), low(2)), Vec3A::new(high(0), high(1), high(2)))
    }

    fn boxes(&self, boxes: &[Aabb], picked: &[u32]) -> Vec<obvhs::aabb::Aabb> {
        picked.iter().map(|&i| self.single(&boxes[i as usize])).collect()
    }
}

/// Binary trees turned into wide nodes.
pub(super) struct Collapse {
    pub nodes: Vec<Node>,
    pub order: Vec<u32>,
}

/// A node of one of the binary trees: the outer one, or the bulk's inside it.
#[derive(Clone, Copy)]
pub(super) struct Place<'a> {
    pub tree: &'a Bvh2,
    /// Primitive numbers of the tree's boxes; the bulk stands in the outer tree as `u32::MAX`.
    pub numbers: &'a [u32],
    pub node: usize,
    /// Which nodes below become wide ones, if that was worked out.
    plan: Option<&'a Plan>,
    /// Nodes above so many primitives are taken for leaves.
    leaf: usize,
    is_leaf: bool,
}

impl<'a> Place<'a> {
    pub fn root(planned: &'a Planned, numbers: &'a [u32], quality: Quality) -> Self {
        let Planned { tree, plan } = planned;
        Self { tree, numbers, node: 0, plan: plan.as_ref(), leaf: quality.leaf(), is_leaf: false }.at(0)
    }

    /// Another node of the same tree.
    fn at(&self, node: usize) -> Place<'a> {
        let is_leaf = self.tree.nodes[node].is_leaf() || count_below(self.tree, node, self.leaf).is_some();
        Place { node, is_leaf, ..*self }
    }

    fn bounds(&self) -> obvhs::aabb::Aabb {
        *self.tree.nodes[self.node].aabb()
    }

    fn children(&self) -> [Place<'a>; 2] {
        let first = self.tree.nodes[self.node].first_index as usize;
        [self.at(first), self.at(first + 1)]
    }

    /// Those of a leaf.
    fn primitives(&self) -> SmallVec<[u32; MAX_LEAF]> {
        let mut found = SmallVec::new();
        let mut todo: SmallVec<[usize; MAX_LEAF]> = smallvec![self.node];
        while let Some(at) = todo.pop() {
            let node = &self.tree.nodes[at];
            let first = node.first_index as usize;
            if node.is_leaf() {
                let own = &self.tree.primitive_indices[first..first + node.prim_count as usize];
                found.extend(own.iter().map(|&k| self.numbers[k as usize]));
            } else {
                todo.extend([first + 1, first]);
            }
        }
        found
    }
}

/// How many primitives are at or below a node, if one leaf of `most` can hold them.
fn count_below(tree: &Bvh2, node: usize, most: usize) -> Option<usize> {
    let node = &tree.nodes[node];
    if node.is_leaf() {
        return (node.prim_count as usize <= most).then_some(node.prim_count as usize);
    }
    if most < 2 {
        return None;
    }
    let first = node.first_index as usize;
    let left = count_below(tree, first, most - 1)?;
    Some(left + count_below(tree, first + 1, most - left)?)
}

impl Collapse {
    /// Adds the tree over `picked`; `bulk` is a tree of its own that takes one more place in it.
    fn add_tree(
        &mut self,
        frame: &Frame,
        boxes: &[Aabb],
        mut picked: Vec<u32>,
        quality: Quality,
        bulk: Option<(Vec<obvhs::aabb::Aabb>, Vec<u32>)>,
    ) {
        let mut list = frame.boxes(boxes, &picked);
        let inner = bulk.map(|(inner_boxes, numbers)| {
            let whole = inner_boxes.iter().fold(inner_boxes[0], |a, b| a.union(b));
            list.push(whole);
            picked.push(u32::MAX);
            (binary_tree(&inner_boxes, quality), numbers)
        });
        // A leaf with the bulk in it must hold nothing else.
        let outer_quality = if inner.is_some() { Quality::Best } else { quality };
        let outer = binary_tree(&list, outer_quality);
        drop(list);
        let root = Place::root(&outer, &picked, outer_quality);
        let graft = inner.as_ref().map(|(tree, numbers)| Place::root(tree, numbers, quality));
        self.collapse(root, graft);
    }

    /// Wide nodes for everything below `root`, which becomes node 0.
    pub fn collapse(&mut self, root: Place, graft: Option<Place>) {
        self.nodes.push(Node::EMPTY);
        let mut todo = vec![(root, 0usize)];
        let mut children: Vec<Place> = Vec::with_capacity(WIDTH);
        while let Some((place, at)) = todo.pop() {
            children.clear();
            match place.plan {
                Some(plan) if !place.is_leaf => {
                    plan.children(place.tree, place.node, |node| children.push(place.at(node)));
                    take_bulk(&mut children, graft);
                }
                _ => {
                    children.push(place);
                    widen(&mut children, graft);
                }
            }
            children.sort_by_key(|child| !child.is_leaf);
            for (slot, child) in children.iter().enumerate() {
                let b = child.bounds();
                let entry = if child.is_leaf {
                    self.leaf(child)
                } else {
                    self.nodes.push(Node::EMPTY);
                    todo.push((*child, self.nodes.len() - 1));
                    self.nodes.len() as u32 - 1
                };
                let node = &mut self.nodes[at];
                for axis in 0..3 {
                    node.bounds[axis][slot] = b.min[axis];
                    node.bounds[axis + 3][slot] = b.max[axis];
                }
                node.child[slot] = entry;
            }
        }
    }

    fn leaf(&mut self, place: &Place) -> u32 {
        let first = self.order.len() as u32;
        self.order.extend(place.primitives());
        let count = self.order.len() as u32 - first;
        debug_assert!((1..=MAX_LEAF as u32).contains(&count));
        LEAF | (count - 1) << COUNT_SHIFT | first
    }
}

/// Opens the largest inner child until there are as many children as a node holds.
fn widen<'a>(children: &mut Vec<Place<'a>>, graft: Option<Place<'a>>) {
    while children.len() < WIDTH {
        let mut largest = None;
        for (i, child) in children.iter_mut().enumerate() {
            if child.is_leaf {
                // The bulk's place in the outer tree: go on in the bulk's own tree.
                match graft {
                    Some(g) if child.primitives()[0] == u32::MAX => *child = g,
                    _ => continue,
                }
                if child.is_leaf {
                    continue;
                }
            }
            let area = child.bounds().half_area();
            if largest.is_none_or(|(_, a)| area > a) {
                largest = Some((i, area));
            }
        }
        let Some((i, _)) = largest else { return };
        let [a, b] = children[i].children();
        children[i] = a;
        children.push(b);
    }
    // The last ones opened may again be the bulk's place.
    take_bulk(children, graft);
}

/// Puts the bulk's own tree in its place in the outer one.
fn take_bulk<'a>(children: &mut [Place<'a>], graft: Option<Place<'a>>) {
    if let Some(g) = graft {
        for child in children.iter_mut() {
            if child.is_leaf && child.primitives()[0] == u32::MAX {
                *child = g;
            }
        }
    }
}

/// A binary tree, and what is to become of it.
pub(super) struct Planned {
    pub tree: Bvh2,
    plan: Option<Plan>,
}

pub(super) fn binary_tree(boxes: &[obvhs::aabb::Aabb], quality: Quality) -> Planned {
    let tree = build_bvh2(boxes, quality.parameters(), &mut Duration::default());
    let plan = (quality == Quality::Best && !tree.nodes.is_empty()).then(|| Plan::new(&tree));
    Planned { tree, plan }
}

/// The greatest power of two that is at most `v`, within the range of single precision.
fn power_of_two_below(v: f64) -> f64 {
    let exponent = v.clamp(1e-300, 1e300).log2().floor() as i32;
    2f64.powi(exponent)
}

/// The greatest single that is at most `v`.
pub(super) fn round_down(v: f64) -> f32 {
    let s = v as f32;
    if f64::from(s) > v { s.next_down() } else { s }
}

/// The least single that is at least `v`.
pub(super) fn round_up(v: f64) -> f32 {
    let s = v as f32;
    if f64::from(s) < v { s.next_up() } else { s }
}
