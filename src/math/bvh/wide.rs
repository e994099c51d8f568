//! The traversal with eight boxes in one register. What happens at a node hangs on few conditions that a
//! processor could guess wrong: the nearest child is opened next, and the others are set aside all at once.

use super::traverse::{InTree, Planes, Setup};
use super::{Bvh, LEAF, Node, Places, WIDTH};
use crate::math::Range;
use std::arch::x86_64::*;
use std::mem::MaybeUninit;

/// Room for waiting children that a ray sets aside without asking for memory; deeper trees ask.
const STACK: usize = 104;

/// A [`Setup`] with every number eight times.
struct Wide {
    near_inverse: [__m256; 3],
    near_offset: [__m256; 3],
    far_inverse: [__m256; 3],
    far_offset: [__m256; 3],
    planes: &'static Planes,
}

#[target_feature(enable = "avx2,fma")]
#[inline]
fn widened(s: &Setup) -> Wide {
    // Read anew after each leaf: registers that hold the ray would have to be saved while it is visited.
    let s = std::hint::black_box(s);
    let all = |row: &[f32; 4]| [_mm256_set1_ps(row[0]), _mm256_set1_ps(row[1]), _mm256_set1_ps(row[2])];
    Wide {
        near_inverse: all(&s.near_inverse),
        near_offset: all(&s.near_offset),
        far_inverse: all(&s.far_inverse),
        far_offset: all(&s.far_offset),
        planes: s.planes,
    }
}

/// Boxes that the ray may meet: a bit for each, the distances to their near sides, and the same with infinity
/// for boxes that it misses.
struct Met {
    mask: u32,
    near: __m256,
    or_infinite: __m256,
}

/// The slab test of all children, with products that are not rounded.
#[target_feature(enable = "avx2,fma")]
#[inline]
fn slabs(node: &Node, w: &Wide, min: f32, max: f32) -> Met {
    let mut lo = _mm256_set1_ps(min);
    let mut hi = _mm256_set1_ps(max);
    // SAFETY: `Node` begins with its bounds and is aligned to 32 bytes; `Planes` holds places of whole rows of
    // eight singles in it.
    #[allow(unsafe_code)]
    unsafe {
        let bounds = node.bounds.as_ptr().cast::<f32>();
        for axis in 0..3 {
            let a = _mm256_load_ps(bounds.add(w.planes.near[axis]));
            let b = _mm256_load_ps(bounds.add(w.planes.far[axis]));
            lo = _mm256_max_ps(_mm256_fmsub_ps(a, w.near_inverse[axis], w.near_offset[axis]), lo);
            hi = _mm256_min_ps(_mm256_fmsub_ps(b, w.far_inverse[axis], w.far_offset[axis]), hi);
        }
    }
    let met = _mm256_cmp_ps::<_CMP_LE_OQ>(lo, hi);
    let or_infinite = _mm256_blendv_ps(_mm256_set1_ps(f32::INFINITY), lo, met);
    Met { mask: _mm256_movemask_ps(met) as u32, near: lo, or_infinite }
}

impl Met {
    /// The nearest of at least one box that is met.
    #[target_feature(enable = "avx2,fma")]
    #[inline]
    fn nearest(&self) -> u32 {
        let all = self.or_infinite;
        let least = _mm256_min_ps(all, _mm256_permute2f128_ps::<1>(all, all));
        let least = _mm256_min_ps(least, _mm256_permute_ps::<0b01_00_11_10>(least));
        let least = _mm256_min_ps(least, _mm256_permute_ps::<0b10_11_00_01>(least));
        let equal = _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_EQ_OQ>(all, least)) as u32;
        (equal & self.mask).trailing_zeros() % WIDTH as u32
    }
}

/// For each set of lanes their numbers, in order, and then anything.
static IN_FRONT: [[u8; WIDTH]; 256] = {
    let mut all = [[0; WIDTH]; 256];
    let mut set = 0;
    while set < 256 {
        let (mut lane, mut place) = (0, 0);
        while lane < WIDTH {
            if set >> lane & 1 == 1 {
                all[set][place] = lane as u8;
                place += 1;
            }
            lane += 1;
        }
        set += 1;
    }
    all
};

/// Lines of cache of a node.
const LINES: usize = size_of::<Node>().div_ceil(LINE);
const LINE: usize = 64;

/// Tells the processor that so many lines of cache from there on are likely to be read soon. A sphereflake of 66,430
/// spheres takes 0.95 of the time that it takes without.
#[inline(always)]
fn fetch<const COUNT: usize>(from: *const i8) {
    for line in 0..COUNT {
        // SAFETY: a hint reads nothing, whatever it points to.
        #[allow(unsafe_code)]
        unsafe {
            _mm_prefetch::<_MM_HINT_T0>(from.wrapping_add(line * LINE));
        }
    }
}

/// Children that wait to be opened, with the distances to their boxes. There is room for [`WIDTH`] more than
/// can wait, as so many are written at once.
struct Waiting<'a> {
    near: &'a mut [MaybeUninit<f32>],
    child: &'a mut [MaybeUninit<u32>],
    /// As many have been written.
    top: usize,
}

impl Waiting<'_> {
    /// Sets the children in `mask` aside.
    #[target_feature(enable = "avx2,popcnt")]
    #[inline]
    fn push(&mut self, mask: u32, near: __m256, node: &Node) {
        assert!(self.top + WIDTH <= self.near.len() && self.near.len() == self.child.len());
        // SAFETY: both lists hold eight places from `top` on, as has just been asserted; `IN_FRONT` holds eight
        // bytes for each of 256 masks of eight children.
        #[allow(unsafe_code)]
        unsafe {
            let lanes = _mm256_cvtepu8_epi32(_mm_loadl_epi64(IN_FRONT[mask as usize & 255].as_ptr().cast()));
            let child = _mm256_loadu_si256(node.child.as_ptr().cast());
            _mm256_storeu_ps(
                self.near.as_mut_ptr().add(self.top).cast(),
                _mm256_permutevar8x32_ps(near, lanes),
            );
            let child = _mm256_permutevar8x32_epi32(child, lanes);
            _mm256_storeu_si256(self.child.as_mut_ptr().add(self.top).cast(), child);
        }
        self.top += mask.count_ones() as usize;
    }

    /// Fetches the topmost child, which is likely to be opened next, if it is a node.
    #[inline(always)]
    fn fetch_next(&self, bvh: &Bvh) {
        let Some(top) = self.top.checked_sub(1) else { return };
        // SAFETY: `push` has written every place below `top`.
        #[allow(unsafe_code)]
        let child = unsafe { self.child[top].assume_init() };
        if child & LEAF == 0 {
            fetch::<LINES>(bvh.nodes.as_ptr().wrapping_add(child as usize).cast());
        }
    }

    /// Takes the topmost child whose box is no further than `limit`.
    #[inline(always)]
    fn next(&mut self, limit: f32) -> Option<u32> {
        loop {
            self.top = self.top.checked_sub(1)?;
            let (near, child) = (self.near[self.top], self.child[self.top]);
            // SAFETY: `push` has written every place that it lifted `top` above.
            #[allow(unsafe_code)]
            let (near, child) = unsafe { (near.assume_init(), child.assume_init()) };
            if near <= limit {
                return Some(child);
            }
        }
    }
}

/// Calls `visit` as [`Bvh::traverse`] says, nearer boxes mostly first if `SORTED`, from `root` on.
#[target_feature(enable = "avx2,fma,popcnt")]
#[inline]
pub(super) fn walk<const SORTED: bool>(
    bvh: &Bvh,
    root: &Node,
    s: &Setup,
    range: Range,
    visit: impl FnMut(Places, f64) -> f64,
) {
    // A root of another making may stand above eight nodes of the tree.
    let size = bvh.stack_size + 2 * WIDTH;
    if size <= STACK {
        let mut near = [const { MaybeUninit::uninit() }; STACK];
        let mut child = [const { MaybeUninit::uninit() }; STACK];
        let waiting = Waiting { near: &mut near, child: &mut child, top: 0 };
        return walk_in::<SORTED>((bvh, root), s, range, waiting, visit);
    }
    let (mut near, mut child) = (vec![MaybeUninit::uninit(); size], vec![MaybeUninit::uninit(); size]);
    walk_in::<SORTED>((bvh, root), s, range, Waiting { near: &mut near, child: &mut child, top: 0 }, visit);
}

#[target_feature(enable = "avx2,fma,popcnt")]
#[inline]
fn walk_in<const SORTED: bool>(
    (bvh, root): (&Bvh, &Node),
    s: &Setup,
    range: Range,
    mut waiting: Waiting,
    mut visit: impl FnMut(Places, f64) -> f64,
) {
    let mut reach = InTree::new(bvh, s, range);
    let mut node = root;
    loop {
        let ray = widened(s);
        let mut entry = loop {
            // Leaves are first among the children, and what is in them side by side.
            let first = node.child[0];
            fetch::<2>(if first & LEAF != 0 { bvh.row(first) } else { std::ptr::from_ref(node).cast() });
            let met = slabs(node, &ray, reach.start, reach.limit);
            let entry = if met.mask & met.mask.wrapping_sub(1) == 0 && met.mask != 0 {
                node.child[met.mask.trailing_zeros() as usize]
            } else if met.mask != 0 {
                let next = if SORTED { met.nearest() } else { met.mask.trailing_zeros() };
                waiting.push(met.mask & !(1 << next), met.near, node);
                node.child[next as usize]
            } else {
                match waiting.next(reach.limit) {
                    Some(next) => next,
                    None => return,
                }
            };
            if entry & LEAF != 0 {
                break entry;
            }
            node = &bvh.nodes[entry as usize];
        };
        loop {
            waiting.fetch_next(bvh);
            if !reach.visit_leaf(bvh, s, entry, &mut visit) {
                return;
            }
            match waiting.next(reach.limit) {
                Some(next) => entry = next,
                None => return,
            }
            if entry & LEAF == 0 {
                break;
            }
        }
        node = &bvh.nodes[entry as usize];
    }
}

/// What the slab test says of a node, for tests: a bit for each child, the distances, and the nearest child.
#[cfg(test)]
#[target_feature(enable = "avx2,fma")]
pub(super) fn slabs_of(node: &Node, s: &Setup, min: f32, max: f32) -> (u32, [f32; WIDTH], usize) {
    let met = slabs(node, &widened(s), min, max);
    let mut near = [0f32; WIDTH];
    // SAFETY: `near` holds eight singles; stores need no alignment.
    #[allow(unsafe_code)]
    unsafe {
        _mm256_storeu_ps(near.as_mut_ptr(), met.near);
    }
    (met.mask, near, met.nearest() as usize)
}
