//! The part of a tree that a [`Beam`] runs through, under a root of its own: rays inside the beam start there
//! instead of at the tree's root.

#[cfg(target_arch = "x86_64")]
use super::traverse::has_wide;
use super::{Bvh, LEAF, Node, Places, WIDTH, leaf_places};
use crate::math::{Accelerator, AnyHit, Beam, Range, Ray, Vec3};

/// Beams that start further away, in the tree's coordinates, are told too roughly by single precision.
const NEAR: f64 = 64.0;
/// Bound on the rounding of distances from a beam's sides, relative to the largest coordinate.
const ROUNDING: f64 = 16.0 * f32::EPSILON as f64;

/// Up to eight parts of a tree, which hold all that a beam may meet.
#[derive(Clone, Debug)]
pub struct Cut {
    pub(super) root: Node,
}

/// The beam's sides in the tree's coordinates: `normal · p >= least`.
struct Sides {
    normals: [[f32; 3]; 4],
    /// Where in a node's bounds the corner furthest inward is, for each axis.
    rows: [[usize; 3]; 4],
    least: [f32; 4],
}

impl Sides {
    fn new(bvh: &Bvh, beam: &Beam) -> Option<Sides> {
        let apex = (beam.apex - bvh.center) * bvh.scale;
        let far = apex.abs().max_element();
        // What moving into the tree's coordinates may cost.
        let moved = 1e-15 * (beam.apex.abs().max_element() + bvh.center.abs().max_element()) * bvh.scale;
        if !(far < NEAR && moved < ROUNDING) {
            return None;
        }
        let reach = (bvh.bounds.min - bvh.center).abs().max((bvh.bounds.max - bvh.center).abs()) * bvh.scale;
        let pad = ROUNDING * (1.0 + far + reach.max_element());
        let mut sides = Sides { normals: [[0.0; 3]; 4], rows: [[0; 3]; 4], least: [0.0; 4] };
        for (i, n) in beam.normals.iter().enumerate() {
            sides.normals[i] = n.as_vec3().to_array();
            sides.rows[i] =
                [0, 1, 2].map(|axis| if n[axis] > 0.0 { (axis + 3) * WIDTH } else { axis * WIDTH });
            sides.least[i] = (n.dot(apex) - pad) as f32;
        }
        Some(sides)
    }

    /// A bit for each child that the beam may meet.
    #[inline(always)]
    fn mask(&self, node: &Node) -> u32 {
        #[cfg(target_arch = "x86_64")]
        if has_wide() {
            // SAFETY: the processor has just been seen to have what `mask_wide` is compiled for.
            #[allow(unsafe_code)]
            return unsafe { self.mask_wide(node) };
        }
        self.mask_plain(node)
    }

    fn mask_plain(&self, node: &Node) -> u32 {
        let bounds = node.bounds.as_flattened();
        let mut met = [true; WIDTH];
        for side in 0..4 {
            let [x, y, z] = self.normals[side];
            let [a, b, c] = self.rows[side].map(|row| &bounds[row..row + WIDTH]);
            for i in 0..WIDTH {
                // No number, where there is no box, counts as outside.
                met[i] &= x * a[i] + y * b[i] + z * c[i] >= self.least[side];
            }
        }
        met.iter().enumerate().fold(0, |mask, (i, &met)| mask | u32::from(met) << i)
    }

    /// The same with eight boxes in one register.
    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2,fma")]
    fn mask_wide(&self, node: &Node) -> u32 {
        use std::arch::x86_64::*;
        let mut mask = 0xff;
        for side in 0..4 {
            let mut sum = _mm256_setzero_ps();
            for axis in 0..3 {
                let row = &node.bounds.as_flattened()[self.rows[side][axis]..][..WIDTH];
                // SAFETY: eight singles are read from a list of eight.
                #[allow(unsafe_code)]
                let row = unsafe { _mm256_loadu_ps(row.as_ptr()) };
                sum = _mm256_fmadd_ps(_mm256_set1_ps(self.normals[side][axis]), row, sum);
            }
            let met = _mm256_cmp_ps::<_CMP_GE_OQ>(sum, _mm256_set1_ps(self.least[side]));
            mask &= _mm256_movemask_ps(met) as u32;
        }
        mask
    }
}

/// A child, by its place in a node.
#[derive(Clone, Copy)]
struct Part<'a> {
    node: &'a Node,
    lane: usize,
    /// It can't be opened, or its own children would be too many.
    closed: bool,
}

impl<'a> Part<'a> {
    fn new(node: &'a Node, lane: u32) -> Part<'a> {
        let lane = lane as usize % WIDTH;
        Part { node, lane, closed: node.child[lane] & LEAF != 0 }
    }

    fn child(&self) -> u32 {
        self.node.child[self.lane]
    }
}

/// Up to eight parts of a tree.
struct Parts<'a> {
    list: [Part<'a>; WIDTH],
    count: usize,
}

impl<'a> Parts<'a> {
    /// The children of `root` that the beam may meet.
    fn new(sides: &Sides, root: &'a Node) -> Parts<'a> {
        let mut parts = Parts { list: [Part::new(root, 0); WIDTH], count: 0 };
        parts.add(root, sides.mask(root));
        parts
    }

    fn add(&mut self, node: &'a Node, mut mask: u32) {
        while mask != 0 && self.count < WIDTH {
            self.list[self.count] = Part::new(node, mask.trailing_zeros());
            self.count += 1;
            mask &= mask - 1;
        }
    }

    /// Puts a part's children in its place, those that the beam may meet, if there is room for them.
    fn open(&mut self, sides: &Sides, nodes: &'a [Node], i: usize) {
        let node = &nodes[self.list[i].child() as usize];
        let mask = sides.mask(node);
        if self.count - 1 + mask.count_ones() as usize > WIDTH {
            self.list[i].closed = true;
        } else if mask == 0 {
            self.count -= 1;
            self.list[i] = self.list[self.count];
        } else {
            self.list[i] = Part::new(node, mask.trailing_zeros());
            self.add(node, mask & (mask - 1));
        }
    }
}

impl Default for Cut {
    fn default() -> Cut {
        Cut { root: Node::EMPTY }
    }
}

impl Cut {
    fn fill(&mut self, parts: &[Part]) {
        self.root = Node::EMPTY;
        for (i, part) in parts.iter().enumerate() {
            for (row, from) in self.root.bounds.iter_mut().zip(&part.node.bounds) {
                row[i] = from[part.lane];
            }
            self.root.child[i] = part.child();
        }
    }

    /// Places of the primitives that are leaves of the cut itself.
    pub fn leaves(&self) -> impl Iterator<Item = u32> {
        let root = &self.root;
        let holds = |i: &usize| root.child[*i] & LEAF != 0 && root.bounds[0][*i] <= root.bounds[3][*i];
        (0..WIDTH).filter(holds).flat_map(|i| leaf_places(root.child[i]))
    }
}

impl Bvh {
    /// Finds what of the tree a beam may meet, opened as far as eight parts allow. False if that can't be told well;
    /// then the cut means nothing.
    pub fn cut(&self, beam: &Beam, cut: &mut Cut) -> bool {
        let (Some(sides), Some(root)) = (Sides::new(self, beam), self.nodes.first()) else { return false };
        let mut parts = Parts::new(&sides, root);
        // Level by level.
        while parts.list[..parts.count].iter().any(|part| !part.closed) {
            let mut i = 0;
            while i < parts.count {
                let before = parts.count;
                if !parts.list[i].closed {
                    parts.open(&sides, &self.nodes, i);
                }
                // One that went made room for the last.
                i += usize::from(parts.count >= before);
            }
        }
        cut.fill(&parts.list[..parts.count]);
        true
    }
}

/// A tree for rays that stay in the beam of a cut.
pub struct CutTree<'a> {
    pub tree: &'a Bvh,
    pub cut: &'a Cut,
}

impl AnyHit for CutTree<'_> {
    #[inline(always)]
    fn any(&self, ray: &Ray, range: Range, mut visit: impl FnMut(u32) -> bool) -> bool {
        let primitive = |i| self.tree.primitive(i);
        self.tree.any_leaf_below(&self.cut.root, ray, range, |mut leaf| leaf.any(|i| visit(primitive(i))))
    }
}

impl Accelerator for CutTree<'_> {
    #[inline(always)]
    fn traverse(&self, ray: &Ray, range: Range, visit: impl FnMut(u32, f64) -> f64) {
        self.tree.traverse_below(&self.cut.root, ray, range, visit);
    }

    fn any_at(&self, p: Vec3, visit: impl FnMut(u32) -> bool) -> bool {
        self.tree.any_at(p, visit)
    }

    fn heap_bytes(&self) -> usize {
        self.tree.heap_bytes()
    }
}

impl CutTree<'_> {
    /// See [`Bvh::traverse_leaves`].
    #[inline]
    pub fn traverse_leaves(&self, ray: &Ray, range: Range, visit: impl FnMut(Places, f64) -> f64) {
        self.tree.walk::<true>(&self.cut.root, ray, range, visit);
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Quality, tests::Random};
    use super::*;
    use crate::math::Aabb;

    /// A narrow beam with an apex at a distance of some `far`, aimed at about the middle.
    fn beam(random: &mut Random, far: f64, width: f64) -> Option<(Beam, [Vec3; 3])> {
        let apex = random.vector(far);
        let forward = random.vector(0.5) - apex;
        let (right, up) = (forward.length() * random.vector(width), forward.length() * random.vector(width));
        let edges = [forward, forward + right, forward + right + up, forward + up];
        Some((Beam::new(apex, edges)?, [forward, right, up]))
    }

    /// Rays in the beam find below the cut what they find in the whole tree, from inside the tree and out of it.
    #[test]
    fn rays_in_the_beam_find_the_same() {
        let mut random = Random::new(17);
        let (mut hits, mut shown, mut there, mut opened) = (0, 0, 0, 0);
        for (count, leaf) in [(3, 1), (60, 1), (3000, 1), (3000, 4)] {
            let boxes: Vec<Aabb> = (0..count).map(|_| random.aabb(1.0, 0.04)).collect();
            let quality = if leaf == 1 { Quality::Best } else { Quality::Fast { leaf } };
            let tree = Bvh::build(&boxes, quality);
            for i in 0..300 {
                let far = [0.5, 3.0, 40.0][i % 3];
                let Some((beam, [forward, right, up])) = beam(&mut random, far, 0.03) else { continue };
                let mut cut = Cut::default();
                if !tree.cut(&beam, &mut cut) {
                    continue;
                }
                // The large trees' roots hold no leaves.
                opened += usize::from(count == 3000 && cut.leaves().next().is_some());
                let cut = CutTree { tree: &tree, cut: &cut };
                for (s, t) in [(0.0, 0.0), (1.0, 0.3), (0.5, 0.5), (0.2, 1.0)] {
                    let ray = Ray::new(beam.apex, (forward + s * right + t * up).normalize());
                    let all = met(&tree, &boxes, &ray, &mut there);
                    assert_eq!(met(&cut, &boxes, &ray, &mut shown), all, "{ray:?}");
                    assert_eq!(cut.any(&ray, Range::FORWARD, |i| all.contains(&i)), !all.is_empty());
                    hits += all.len();
                }
            }
        }
        // Nor is more looked at.
        assert!(hits > 2000 && shown <= there && opened > 200, "{hits} {shown} {there} {opened}");
    }

    /// Primitives whose box the ray meets, among those that are shown to it.
    fn met(tree: &impl Accelerator, boxes: &[Aabb], ray: &Ray, shown: &mut usize) -> Vec<u32> {
        let mut met = Vec::new();
        tree.traverse(ray, Range::FORWARD, |i, max| {
            *shown += 1;
            let b = &boxes[i as usize];
            let (a, c) = ((b.min - ray.origin) / ray.dir, (b.max - ray.origin) / ray.dir);
            let (near, far) = (a.min(c).max_element().max(0.0), a.max(c).min_element());
            if near <= far {
                met.push(i);
            }
            max
        });
        met.sort_unstable();
        met
    }

    /// Beams that single precision can't tell are refused.
    #[test]
    fn far_beams_are_refused() {
        let tree = Bvh::build(&[Aabb::new(Vec3::splat(-1.0), Vec3::ONE)], Quality::Best);
        let edges = [
            Vec3::new(0.0, 0.0, 1.0),
            Vec3::new(0.1, 0.0, 1.0),
            Vec3::new(0.1, 0.1, 1.0),
            Vec3::new(0.0, 0.1, 1.0),
        ];
        for (far, told) in [(10.0, true), (1e4, false), (f64::INFINITY, false)] {
            let beam = Beam::new(Vec3::splat(far), edges).expect("a beam");
            assert_eq!(tree.cut(&beam, &mut Cut::default()), told, "{far}");
        }
        let beam = Beam::new(Vec3::ZERO, edges).expect("a beam");
        assert!(!Bvh::build(&[], Quality::Best).cut(&beam, &mut Cut::default()));
    }

    /// Both ways to hold a node's boxes against a beam say the same but for roundings, and none drops a box that holds
    /// a point of the beam.
    #[test]
    fn no_box_of_the_beam_is_dropped() {
        let mut random = Random::new(4);
        let (mut kept, mut dropped) = (0, 0);
        let boxes: Vec<Aabb> = (0..500).map(|_| random.aabb(1.0, 0.1)).collect();
        let tree = Bvh::build(&boxes, Quality::Best);
        for i in 0..2000 {
            let Some((beam, [forward, right, up])) = beam(&mut random, 4.0, 0.2) else { continue };
            let Some(sides) = Sides::new(&tree, &beam) else { continue };
            let at = |t: f64, k: f64| beam.apex + t * (forward + k * right + (1.0 - k) * up);
            let points: Vec<Vec3> =
                (0..50).map(|k| at(f64::from(k) / 25.0, f64::from(i % 5) / 4.0)).collect();
            for node in &tree.nodes {
                let (mask, plain) = (sides.mask(node), sides.mask_plain(node));
                assert!((mask ^ plain).count_ones() <= 1);
                for lane in 0..WIDTH {
                    let tree_point = |p: &Vec3| (*p - tree.center) * tree.scale;
                    let inside = |p: &Vec3| {
                        let q = tree_point(p);
                        (0..3).all(|a| {
                            f64::from(node.bounds[a][lane]) <= q[a]
                                && q[a] <= f64::from(node.bounds[a + 3][lane])
                        })
                    };
                    let bit = |mask: u32| mask >> lane & 1 == 1;
                    assert!(bit(mask) && bit(plain) || !points.iter().any(inside));
                    kept += usize::from(bit(mask));
                    dropped += usize::from(!bit(mask));
                }
            }
        }
        assert!(kept > 1000 && dropped > kept, "{kept} {dropped}");
    }
}
