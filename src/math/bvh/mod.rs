//! A bounding volume hierarchy, eight children wide.
//!
//! `obvhs` builds a binary tree over boxes; it is collapsed here into nodes whose eight child boxes are
//! tested at once. Boxes are single precision, relative to the middle of the bulk of the primitives and
//! rounded outward. Traversal keeps every box that the double precision ray could touch:
//!
//! * a ray from far away first moves, in double precision, to where it enters the box of everything;
//! * the origin's rounding is bounded per axis (`6 |o| * 2^-23` plus what the move cost) and added to each
//!   slab, the relative rounding of the products to the interval's far end.
//!
//! Reference: Ernst and Greiner, "Multi Bounding Volume Hierarchies", 2008; Ize, "Robust BVH Ray
//! Traversal", 2013.

mod build;
mod chunks;
mod cut;
mod shaft;
mod traverse;
#[cfg(target_arch = "x86_64")]
mod wide;
mod widen;

use super::{Aabb, Accelerator, AnyHit, Range, Ray, Vec3};

pub use build::Quality;
pub use cut::{Cut, CutTree};

/// How many children a node has.
const WIDTH: usize = 8;
/// Marks a child as a leaf; the rest holds `count - 1` and the first place in `order`.
const LEAF: u32 = 1 << 31;
const COUNT_SHIFT: u32 = 28;
const FIRST_MASK: u32 = (1 << COUNT_SHIFT) - 1;
/// The most primitives that a leaf can hold.
const MAX_LEAF: usize = 8;

/// A tree over boxes that are numbered from 0.
#[derive(Clone, Debug)]
pub struct Bvh {
    nodes: Vec<Node>,
    /// Primitive numbers, leaf by leaf.
    order: Vec<u32>,
    /// Around everything, in the caller's space.
    bounds: Aabb,
    center: Vec3,
    /// The most children that can wait while a ray goes down the tree.
    stack_size: usize,
    /// A power of two: the tree's coordinates are `(p - center) * scale`.
    scale: f64,
    /// Bound on the rounding of that for points near the tree, in its coordinates.
    near_pad: f32,
    rows: Rows,
}

/// Where in memory the caller keeps what stands at each place. Hints to the processor are made of it, and nothing is
/// read: pictures do not depend on it.
#[derive(Clone, Copy, Debug)]
struct Rows {
    start: usize,
    /// Bytes from one place to the next.
    stride: usize,
}

/// Eight boxes with what is inside them. Unused places hold an empty box, which no ray enters.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
struct Node {
    /// Least x, y, z, then greatest x, y, z, of each child.
    bounds: [[f32; WIDTH]; 6],
    /// Leaves come first.
    child: [u32; WIDTH],
}

impl Node {
    const EMPTY: Node = Node {
        bounds: [
            [f32::INFINITY; WIDTH],
            [f32::INFINITY; WIDTH],
            [f32::INFINITY; WIDTH],
            [f32::NEG_INFINITY; WIDTH],
            [f32::NEG_INFINITY; WIDTH],
            [f32::NEG_INFINITY; WIDTH],
        ],
        child: [LEAF; WIDTH],
    };
}

impl Bvh {
    /// Around everything.
    pub fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// Takes finished nodes and works out what traversal needs to know of them.
    fn assemble(nodes: Vec<Node>, order: Vec<u32>, bounds: Aabb, center: Vec3, scale: f64) -> Bvh {
        let mut stack_size = 0;
        // Node, and the children that wait when it is opened.
        let mut todo: Vec<(u32, usize)> = if nodes.is_empty() { Vec::new() } else { vec![(0, 0)] };
        while let Some((at, waiting)) = todo.pop() {
            let node = &nodes[at as usize];
            let children = (0..WIDTH).filter(|&i| node.bounds[0][i] <= node.bounds[3][i]).count();
            stack_size = stack_size.max(waiting + children);
            let inner = node.child.iter().filter(|c| **c & LEAF == 0);
            todo.extend(inner.map(|&c| (c, waiting + children.saturating_sub(1))));
        }
        // What is always at hand.
        let rows = Rows { start: nodes.as_ptr() as usize, stride: 0 };
        Bvh { nodes, order, bounds, center, stack_size, scale, near_pad: Bvh::near_pad(center, scale), rows }
    }

    pub fn node_count(&self) -> usize {
        self.nodes.len()
    }

    pub fn heap_bytes(&self) -> usize {
        self.nodes.len() * size_of::<Node>() + self.order.len() * size_of::<u32>()
    }

    /// Primitive numbers in the order in which leaves hold them. A caller may store its primitives in this
    /// order and then [`Bvh::take_order`], which saves an indirection.
    pub fn order(&self) -> &[u32] {
        &self.order
    }

    /// The places of each leaf's primitives.
    pub fn leaves(&self) -> impl Iterator<Item = Places> {
        self.nodes.iter().flat_map(|node| {
            let holds = |i: &usize| node.child[*i] & LEAF != 0 && node.bounds[0][*i] <= node.bounds[3][*i];
            (0..WIDTH).filter(holds).map(|i| leaf_places(node.child[i]))
        })
    }

    /// From now on primitives are called by their place in [`Bvh::order`].
    pub fn take_order(&mut self) -> Vec<u32> {
        std::mem::take(&mut self.order)
    }

    /// Tells where a search will look for what stands at each place, `per_place` items of it: they are fetched ahead.
    /// The list must stay where it is; else there is nothing gained.
    pub fn set_rows<T>(&mut self, rows: &[T], per_place: usize) {
        self.rows = Rows { start: rows.as_ptr() as usize, stride: per_place * size_of::<T>() };
    }

    /// Where a leaf's first row may be.
    #[inline(always)]
    fn row(&self, leaf: u32) -> *const i8 {
        self.rows.start.wrapping_add((leaf & FIRST_MASK) as usize * self.rows.stride) as *const i8
    }

    /// Calls `visit` with every primitive whose box contains `p`, until it returns true.
    pub fn any_at(&self, p: Vec3, mut visit: impl FnMut(u32) -> bool) -> bool {
        if self.nodes.is_empty() || !self.bounds.contains(p) {
            return false;
        }
        let q = (p - self.center) * self.scale;
        let lo = [build::round_down(q.x), build::round_down(q.y), build::round_down(q.z)];
        let hi = [build::round_up(q.x), build::round_up(q.y), build::round_up(q.z)];
        let mut stack: smallvec::SmallVec<[u32; 128]> = smallvec::smallvec![0];
        while let Some(entry) = stack.pop() {
            if entry & LEAF != 0 {
                for i in leaf_places(entry) {
                    if visit(self.primitive(i)) {
                        return true;
                    }
                }
                continue;
            }
            let node = &self.nodes[entry as usize];
            for i in 0..WIDTH {
                let inside = (0..3).all(|a| node.bounds[a][i] <= hi[a] && node.bounds[a + 3][i] >= lo[a]);
                if inside {
                    stack.push(node.child[i]);
                }
            }
        }
        false
    }

    /// The number of the primitive at place `i` of the leaves' order.
    #[inline(always)]
    fn primitive(&self, i: u32) -> u32 {
        if self.order.is_empty() { i } else { self.order[i as usize] }
    }
}

impl AnyHit for Bvh {
    #[inline(always)]
    fn any(&self, ray: &Ray, range: Range, visit: impl FnMut(u32) -> bool) -> bool {
        Bvh::any(self, ray, range, visit)
    }
}

/// Nearer boxes come first.
impl Accelerator for Bvh {
    #[inline(always)]
    fn traverse(&self, ray: &Ray, range: Range, visit: impl FnMut(u32, f64) -> f64) {
        Bvh::traverse(self, ray, range, visit);
    }

    fn any_at(&self, p: Vec3, visit: impl FnMut(u32) -> bool) -> bool {
        Bvh::any_at(self, p, visit)
    }

    fn heap_bytes(&self) -> usize {
        Bvh::heap_bytes(self)
    }
}

/// Places in [`Bvh::order`], those of one leaf.
pub type Places = std::ops::Range<u32>;

/// The places in `order` of a leaf's primitives.
#[inline(always)]
fn leaf_places(entry: u32) -> Places {
    let first = entry & FIRST_MASK;
    let count = ((entry & !LEAF) >> COUNT_SHIFT) + 1;
    first..first + count
}

#[cfg(test)]
pub(crate) mod tests;
