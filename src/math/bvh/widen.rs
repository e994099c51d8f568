//! Which nodes of a binary tree become wide nodes: those whose areas add up to least, as a ray opens a node about
//! as often as its box is large. Found from the leaves upward.
//!
//! Reference: H. Ylitie, T. Karras, S. Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide
//! BVHs", High-Performance Graphics 2017, section 3.1.

use super::WIDTH;
use obvhs::bvh2::Bvh2;
use smallvec::{SmallVec, smallvec};

/// How a node's share of its parent's places is divided.
#[derive(Clone, Copy)]
struct Division {
    /// The first child's part of `i` places, at `i`; 0 where one place less does as well.
    first: [u8; WIDTH],
    /// The same where the node is a wide one itself and has all places.
    own: u8,
}

/// The best wide nodes below each node of a binary tree.
pub(super) struct Plan {
    divisions: Vec<Division>,
}

impl Plan {
    pub fn new(tree: &Bvh2) -> Plan {
        let none = Division { first: [0; WIDTH], own: 0 };
        let mut divisions = vec![none; tree.nodes.len()];
        // The least area of wide nodes below each node if it has so many places, at one less.
        let mut least = vec![[0f32; WIDTH - 1]; tree.nodes.len()];
        for at in downward(tree).into_iter().rev() {
            let node = &tree.nodes[at];
            if node.is_leaf() {
                continue;
            }
            let first = node.first_index as usize;
            let (a, b) = (least[first], least[first + 1]);
            let divided = |places: usize| {
                let cost = |k: usize| a[k - 1] + b[places - k - 1];
                (1..places).map(|k| (cost(k), k as u8)).reduce(|best, c| if c.0 < best.0 { c } else { best })
            };
            let (below, own) = divided(WIDTH).unwrap_or((0.0, 1));
            divisions[at].own = own;
            let mut best = node.aabb().half_area() + below;
            least[at][0] = best;
            for places in 2..WIDTH {
                if let Some((cost, k)) = divided(places)
                    && cost < best
                {
                    best = cost;
                    divisions[at].first[places] = k;
                }
                least[at][places - 1] = best;
            }
        }
        Plan { divisions }
    }

    /// The nodes that become the children of a wide node, which is made of inner node `root`.
    pub fn children(&self, tree: &Bvh2, root: usize, mut visit: impl FnMut(usize)) {
        let first = tree.nodes[root].first_index as usize;
        let own = self.divisions[root].own as usize;
        let mut todo: SmallVec<[(usize, usize); WIDTH]> = smallvec![(first + 1, WIDTH - own), (first, own)];
        while let Some((at, places)) = todo.pop() {
            let node = &tree.nodes[at];
            if node.is_leaf() || places < 2 {
                visit(at);
                continue;
            }
            match self.divisions[at].first[places] as usize {
                0 => todo.push((at, places - 1)),
                k => {
                    let first = node.first_index as usize;
                    todo.extend([(first + 1, places - k), (first, k)]);
                }
            }
        }
    }
}

/// All nodes, parents before their children.
fn downward(tree: &Bvh2) -> Vec<usize> {
    let mut order = Vec::with_capacity(tree.nodes.len());
    order.push(0);
    let mut next = 0;
    while next < order.len() {
        let node = &tree.nodes[order[next]];
        if !node.is_leaf() {
            order.extend([node.first_index as usize, node.first_index as usize + 1]);
        }
        next += 1;
    }
    order
}

#[cfg(test)]
mod tests {
    use super::super::tests::Random;
    use super::*;
    use crate::math::bvh::Quality;
    use crate::math::bvh::build::{Bulk, Frame, binary_tree};

    fn tree(count: usize, seed: u64) -> Bvh2 {
        let mut random = Random::new(seed);
        let boxes: Vec<_> = (0..count).map(|_| random.aabb(1.0, 0.1)).collect();
        let whole = boxes.iter().fold(boxes[0], |a, b| a.union(*b));
        let numbers: Vec<u32> = (0..count as u32).collect();
        let frame = Frame::around(&Bulk::of(&boxes, &numbers), &whole);
        let singles: Vec<_> = boxes.iter().map(|b| frame.single(b)).collect();
        binary_tree(&singles, Quality::Best).tree
    }

    /// The areas of the wide nodes that `plan` makes, and the leaves below them.
    fn made(tree: &Bvh2, plan: &Plan) -> (f32, Vec<usize>) {
        let (mut area, mut leaves, mut todo) = (0.0, Vec::new(), vec![0]);
        while let Some(root) = todo.pop() {
            area += tree.nodes[root].aabb().half_area();
            let mut count = 0;
            plan.children(tree, root, |at| {
                count += 1;
                if tree.nodes[at].is_leaf() { leaves.push(at) } else { todo.push(at) }
            });
            assert!((2..=WIDTH).contains(&count), "{count} children");
        }
        leaves.sort_unstable();
        (area, leaves)
    }

    /// The least area, by trying all ways.
    fn least(tree: &Bvh2, at: usize, places: usize) -> f32 {
        let node = &tree.nodes[at];
        if node.is_leaf() {
            return 0.0;
        }
        let first = node.first_index as usize;
        let divided = |places: usize| {
            (1..places)
                .map(|k| least(tree, first, k) + least(tree, first + 1, places - k))
                .fold(f32::INFINITY, f32::min)
        };
        let alone = node.aabb().half_area() + divided(WIDTH);
        (2..=places).map(divided).fold(alone, f32::min)
    }

    #[test]
    fn every_leaf_is_there_once() {
        for count in [2, 7, 8, 9, 300] {
            let tree = tree(count, count as u64);
            let (_, leaves) = made(&tree, &Plan::new(&tree));
            let all: Vec<usize> =
                downward(&tree).into_iter().filter(|&at| tree.nodes[at].is_leaf()).collect();
            let mut all = all;
            all.sort_unstable();
            assert_eq!(leaves, all);
        }
    }

    #[test]
    fn no_other_way_has_less_area() {
        for (count, seed) in [(2, 1), (9, 2), (14, 3), (17, 4)] {
            let tree = tree(count, seed);
            let (area, _) = made(&tree, &Plan::new(&tree));
            let best = least(&tree, 0, 1);
            assert!((area - best).abs() <= 1e-5 * best, "{area} {best}");
        }
    }
}
