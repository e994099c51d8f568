//! Trees over millions of boxes, built piece by piece: the builder needs some 250 bytes per box while it
//! works, so it is given at most [`CHUNK`] boxes at a time, and boxes are made when they are needed.

use super::build::{Bulk, Collapse, Frame, Place, binary_tree};
use super::{Bvh, COUNT_SHIFT, FIRST_MASK, LEAF, Node, Quality};
use crate::math::Aabb;
use rayon::prelude::*;

/// The most boxes that are built into one tree at once.
const CHUNK: usize = 1 << 17;
/// Places between which a cut into two pieces is chosen.
const BINS: usize = 32;
/// Boxes looked at to find where the bulk is.
const SAMPLE: usize = 4096;

impl Bvh {
    /// A tree over `count` boxes that `bounds` gives by number. Boxes that are empty or not finite are left
    /// out (no ray meets them).
    pub fn build_from(count: usize, bounds: impl Fn(u32) -> Aabb + Sync, quality: Quality) -> Bvh {
        if count <= CHUNK {
            let boxes: Vec<Aabb> = (0..count as u32).map(bounds).collect();
            return Bvh::build(&boxes, quality);
        }
        assert!(count < 1 << COUNT_SHIFT, "a tree holds fewer than 2^28 boxes");
        let mut whole = Aabb::EMPTY;
        let mut numbers = Vec::with_capacity(count);
        for i in 0..count as u32 {
            let b = bounds(i);
            if b.is_finite() && !b.is_empty() {
                whole = whole.union(b);
                numbers.push(i);
            }
        }
        let sample: Vec<Aabb> =
            numbers.iter().step_by(numbers.len().div_ceil(SAMPLE).max(1)).map(|&i| bounds(i)).collect();
        if sample.is_empty() {
            return Bvh::build(&[], quality);
        }
        let bulk = Bulk::of(&sample, &(0..sample.len() as u32).collect::<Vec<_>>());
        let frame = Frame::around(&bulk, &whole);
        let place = |i: u32| ((bounds(i).center() - frame.center) * frame.scale).as_vec3();
        let mut places: Vec<Center> =
            numbers.into_iter().map(|number| Center { at: place(number), number }).collect();
        let pieces = cut(&mut places);
        let built: Vec<Piece> =
            pieces.into_par_iter().map(|piece| Piece::build(&frame, &bounds, piece, quality)).collect();
        let (nodes, order) = join(built);
        Bvh::assemble(nodes, order, whole, frame.center, frame.scale)
    }
}

/// The middle of a box in the tree's coordinates, in single precision: it only decides in which piece a box goes.
#[derive(Clone, Copy, Debug)]
struct Center {
    at: glam::Vec3,
    number: u32,
}

/// A finished part of the tree.
struct Piece {
    bounds: obvhs::aabb::Aabb,
    wide: Collapse,
}

impl Piece {
    fn build(frame: &Frame, bounds: &impl Fn(u32) -> Aabb, places: &[Center], quality: Quality) -> Piece {
        let numbers: Vec<u32> = places.iter().map(|c| c.number).collect();
        let numbers = &numbers;
        let boxes: Vec<obvhs::aabb::Aabb> = numbers.iter().map(|&i| frame.single(&bounds(i))).collect();
        let whole = boxes.iter().fold(boxes[0], |a, b| a.union(b));
        let tree = binary_tree(&boxes, quality);
        drop(boxes);
        let mut wide = Collapse { nodes: Vec::new(), order: Vec::with_capacity(numbers.len()) };
        wide.collapse(Place::root(&tree, numbers, quality), None);
        Piece { bounds: whole, wide }
    }
}

/// Cuts a list of boxes in two where the surface area heuristic says, until no part is larger than a chunk.
/// Boxes are small beside their number: their middles stand for them.
fn cut(places: &mut [Center]) -> Vec<&mut [Center]> {
    let mut pieces = Vec::new();
    let mut todo = vec![places];
    while let Some(part) = todo.pop() {
        if part.len() <= CHUNK {
            pieces.push(part);
            continue;
        }
        let middle = partition(part);
        let (left, right) = part.split_at_mut(middle);
        todo.push(right);
        todo.push(left);
    }
    pieces
}

/// A box in single precision: least and greatest corner.
type Corners = (glam::Vec3, glam::Vec3);

const NOTHING: Corners = (glam::Vec3::INFINITY, glam::Vec3::NEG_INFINITY);

fn around(a: Corners, b: Corners) -> Corners {
    (a.0.min(b.0), a.1.max(b.1))
}

/// Sorts a list into two by the boxes' middles; the length of the first part.
fn partition(part: &mut [Center]) -> usize {
    let (least, greatest) = part.iter().fold(NOTHING, |b, c| around(b, (c.at, c.at)));
    let size = greatest - least;
    let axis = size.max_position();
    if !(size[axis] > 0.0) {
        return part.len() / 2;
    }
    let bin = |c: &Center| {
        let place = (c.at[axis] - least[axis]) / size[axis];
        ((place * BINS as f32) as usize).min(BINS - 1)
    };
    let mut boxes = [NOTHING; BINS];
    let mut counts = [0usize; BINS];
    for c in part.iter() {
        let k = bin(c);
        boxes[k] = around(boxes[k], (c.at, c.at));
        counts[k] += 1;
    }
    let last = cheapest_cut(&boxes, &counts);
    let mut first = 0;
    for k in 0..part.len() {
        if bin(&part[k]) <= last {
            part.swap(first, k);
            first += 1;
        }
    }
    first.clamp(1, part.len() - 1)
}

/// The bin after which a cut costs least.
fn cheapest_cut(boxes: &[Corners; BINS], counts: &[usize; BINS]) -> usize {
    let mut right = [(NOTHING, 0); BINS];
    let mut so_far = (NOTHING, 0);
    for k in (0..BINS).rev() {
        so_far = (around(so_far.0, boxes[k]), so_far.1 + counts[k]);
        right[k] = so_far;
    }
    let cost = |(b, n): (Corners, usize)| if n == 0 { 0.0 } else { half_area(b) * n as f32 };
    let mut left = (NOTHING, 0);
    let mut best = (f32::INFINITY, 0);
    for k in 0..BINS - 1 {
        left = (around(left.0, boxes[k]), left.1 + counts[k]);
        let total = cost(left) + cost(right[k + 1]);
        if left.1 > 0 && right[k + 1].1 > 0 && total < best.0 {
            best = (total, k);
        }
    }
    best.1
}

fn half_area((least, greatest): Corners) -> f32 {
    let s = greatest - least;
    s.x * s.y + s.y * s.z + s.z * s.x
}

/// A tree over the pieces, with their nodes and orders after its own.
fn join(pieces: Vec<Piece>) -> (Vec<Node>, Vec<u32>) {
    let boxes: Vec<obvhs::aabb::Aabb> = pieces.iter().map(|p| p.bounds).collect();
    let numbers: Vec<u32> = (0..pieces.len() as u32).collect();
    let tree = binary_tree(&boxes, Quality::Best);
    let mut top = Collapse { nodes: Vec::new(), order: Vec::new() };
    top.collapse(Place::root(&tree, &numbers, Quality::Best), None);
    let mut roots = Vec::with_capacity(pieces.len());
    let mut next = top.nodes.len();
    for piece in &pieces {
        roots.push(next as u32);
        next += piece.wide.nodes.len();
    }
    for node in &mut top.nodes {
        for i in 0..node.child.len() {
            if node.child[i] & LEAF != 0 && node.bounds[0][i] <= node.bounds[3][i] {
                node.child[i] = roots[top.order[(node.child[i] & FIRST_MASK) as usize] as usize];
            }
        }
    }
    let mut nodes = top.nodes;
    nodes.reserve_exact(next - nodes.len());
    let mut order = Vec::with_capacity(pieces.iter().map(|p| p.wide.order.len()).sum());
    for piece in pieces {
        let (node_shift, order_shift) = (nodes.len() as u32, order.len() as u32);
        nodes.extend(piece.wide.nodes.into_iter().map(|mut node| {
            for entry in &mut node.child {
                *entry += if *entry & LEAF != 0 { order_shift } else { node_shift };
            }
            node
        }));
        order.extend(piece.wide.order);
    }
    (nodes, order)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::bvh::tests::Random;
    use crate::math::{Range, Ray};

    /// A tree in pieces finds what a plain list finds.
    #[test]
    fn pieces_hold_every_box() {
        let mut random = Random::new(3);
        let boxes: Vec<Aabb> = (0..3 * CHUNK).map(|_| random.aabb(1.0, 0.01)).collect();
        let tree = Bvh::build_from(boxes.len(), |i| boxes[i as usize], Quality::Fast { leaf: 2 });
        let mut seen = vec![false; boxes.len()];
        tree.order().iter().for_each(|&i| seen[i as usize] = true);
        assert!(seen.iter().all(|&s| s));
        for _ in 0..6 {
            let ray = Ray::new(random.vector(2.0), random.direction());
            let mut met = std::collections::HashSet::new();
            tree.traverse(&ray, Range::FORWARD, |i, max| {
                met.insert(i);
                max
            });
            for (i, b) in boxes.iter().enumerate() {
                let hit = (0..3).map(|a| {
                    let (u, v) =
                        ((b.min[a] - ray.origin[a]) / ray.dir[a], (b.max[a] - ray.origin[a]) / ray.dir[a]);
                    (u.min(v), u.max(v))
                });
                let (near, far) = hit.fold((0.0f64, f64::INFINITY), |s, h| (s.0.max(h.0), s.1.min(h.1)));
                assert!(near > far || met.contains(&(i as u32)), "box {i} is missed");
            }
        }
    }
}
