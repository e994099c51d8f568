use super::{Bvh, LEAF, Node, WIDTH, leaf_places};
use crate::math::{Range, Ray};

/// Relative error of a slab distance in single precision: direction, reciprocal, difference, product.
const SLACK: f32 = 8.0 * f32::EPSILON;
/// Components below this count as this: their slab distances exceed any tree's size either way.
const SMALLEST_COMPONENT: f64 = 1e-18;

/// Room for waiting children that a ray sets aside without asking for memory; deeper trees ask.
const STACK: usize = 96;
/// The same for small trees, which most scenes have.
const SMALL_STACK: usize = 16;

/// A ray in the tree's coordinates, with its rounding bounds worked in.
struct Setup {
    /// Where slab distances are measured from: moved back for near planes, forward for far ones.
    near_origin: [f32; 3],
    far_origin: [f32; 3],
    inverse: [f32; 3],
    /// Which of a node's six bounds is the near plane of each axis, and the far one.
    near_plane: [usize; 3],
    far_plane: [usize; 3],
    /// How far the ray was moved along itself before it was rounded, in the caller's units.
    advance: f64,
}

impl Bvh {
    /// Calls `visit(primitive, max)` with every primitive whose box the ray may meet inside `range`, nearer
    /// boxes first. `visit` returns the new `max`: the distance of the hit it keeps, or `max` unchanged.
    /// A result not above `range.min` ends the search.
    #[inline]
    pub fn traverse(&self, ray: &Ray, range: Range, visit: impl FnMut(u32, f64) -> f64) {
        self.walk::<true>(ray, range, visit);
    }

    /// Calls `visit` with every primitive whose box the ray may meet inside `range`, in no order, until it
    /// returns true.
    #[inline]
    pub fn any(&self, ray: &Ray, range: Range, mut visit: impl FnMut(u32) -> bool) -> bool {
        let mut found = false;
        self.walk::<false>(ray, range, |i, max| {
            found = visit(i);
            if found { f64::NEG_INFINITY } else { max }
        });
        found
    }

    #[inline]
    fn walk<const SORTED: bool>(&self, ray: &Ray, range: Range, visit: impl FnMut(u32, f64) -> f64) {
        if self.nodes.is_empty() {
            return;
        }
        let Some(setup) = self.setup(ray, range) else { return };
        if self.stack_size <= SMALL_STACK {
            self.run::<SORTED>(&setup, range, &mut [0; SMALL_STACK], visit);
        } else if self.stack_size <= STACK {
            self.run::<SORTED>(&setup, range, &mut [0; STACK], visit);
        } else {
            self.run::<SORTED>(&setup, range, &mut vec![0; self.stack_size], visit);
        }
    }

    #[inline]
    fn run<const SORTED: bool>(
        &self,
        setup: &Setup,
        range: Range,
        stack: &mut [u64],
        visit: impl FnMut(u32, f64) -> f64,
    ) {
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has just been seen to have what `wide` is compiled for.
            #[allow(unsafe_code)]
            unsafe {
                wide::<SORTED>(self, setup, range, stack, visit);
            }
            return;
        }
        plain::<SORTED>(self, setup, range, stack, visit);
    }

    #[inline]
    fn setup(&self, ray: &Ray, range: Range) -> Option<Setup> {
        let dir =
            ray.dir.map(|d| if d.abs() < SMALLEST_COMPONENT { SMALLEST_COMPONENT.copysign(d) } else { d });
        let inverse = dir.recip();
        let advance = self.entry(ray, range)?;
        let o = (ray.origin + advance * ray.dir - self.center) * self.scale;
        // What rounding in the move and the shift cost, in the tree's units.
        let reach = ray.origin.abs() + (self.center.abs() + advance);
        let pad = reach * (4.01 * f64::EPSILON * self.scale) + o.abs() * (4.0 * f64::from(f32::EPSILON));
        let mut setup = Setup {
            near_origin: [0.0; 3],
            far_origin: [0.0; 3],
            inverse: inverse.as_vec3().to_array(),
            near_plane: [0; 3],
            far_plane: [0; 3],
            advance,
        };
        for axis in 0..3 {
            let (origin, pad) = (o[axis] as f32, pad[axis] as f32 + f32::MIN_POSITIVE);
            let pad = pad.copysign(setup.inverse[axis]);
            setup.near_origin[axis] = origin + pad;
            setup.far_origin[axis] = origin - pad;
            let backward = usize::from(setup.inverse[axis].is_sign_negative());
            setup.near_plane[axis] = axis + 3 * backward;
            setup.far_plane[axis] = axis + 3 - 3 * backward;
        }
        Some(setup)
    }

    /// How far to move the ray before rounding it: to where it enters the box of everything, or 0 when it
    /// starts inside. `None` if it misses that box.
    #[inline]
    fn entry(&self, ray: &Ray, range: Range) -> Option<f64> {
        let (mut near, mut far) = (range.min, range.max);
        // Infinite for 0, which the pad keeps from meeting another 0.
        let inverse = ray.dir.recip();
        let pad = ray.origin.abs() * (2.0 * f64::EPSILON) + f64::MIN_POSITIVE;
        let a = (self.bounds.min - pad - ray.origin) * inverse;
        let b = (self.bounds.max + pad - ray.origin) * inverse;
        for axis in 0..3 {
            let (lo, hi) = if inverse[axis] > 0.0 { (a[axis], b[axis]) } else { (b[axis], a[axis]) };
            near = if lo > near { lo } else { near };
            far = if hi < far { hi } else { far };
        }
        let slack = 8.0 * f64::EPSILON * (near.abs() + far.abs());
        if near > far + slack || near == f64::INFINITY {
            return None;
        }
        Some(if near > 0.0 && near.is_finite() { near } else { 0.0 })
    }
}

/// The slab test of all children: a bit for each that the ray may meet, and the distances to their near
/// sides.
#[inline(always)]
fn slabs(node: &Node, s: &Setup, min: f32, max: f32, near: &mut [f32; WIDTH]) -> u32 {
    let mut lo = [min; WIDTH];
    let mut hi = [max; WIDTH];
    for axis in 0..3 {
        let a = &node.bounds[s.near_plane[axis]];
        let b = &node.bounds[s.far_plane[axis]];
        for i in 0..WIDTH {
            let n = (a[i] - s.near_origin[axis]) * s.inverse[axis];
            let f = (b[i] - s.far_origin[axis]) * s.inverse[axis];
            lo[i] = if n > lo[i] { n } else { lo[i] };
            hi[i] = if f < hi[i] { f } else { hi[i] };
        }
    }
    let mut mask = 0;
    for i in 0..WIDTH {
        mask |= u32::from(lo[i] * (1.0 - SLACK) <= hi[i] * (1.0 + SLACK)) << i;
    }
    *near = lo;
    mask
}

/// [`slabs`], eight at once: the same operations in the same order, so the same bits.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
#[inline]
fn slabs_avx2(node: &Node, s: &Setup, min: f32, max: f32, near: &mut [f32; WIDTH]) -> u32 {
    use std::arch::x86_64::*;
    // SAFETY: `Node` is aligned to 32 bytes and each of its rows is 32 bytes long; `near` is written
    // unaligned and holds eight singles.
    #[allow(unsafe_code)]
    unsafe {
        let mut lo = _mm256_set1_ps(min);
        let mut hi = _mm256_set1_ps(max);
        for axis in 0..3 {
            let a = _mm256_load_ps(node.bounds[s.near_plane[axis]].as_ptr());
            let b = _mm256_load_ps(node.bounds[s.far_plane[axis]].as_ptr());
            let inverse = _mm256_set1_ps(s.inverse[axis]);
            let n = _mm256_mul_ps(_mm256_sub_ps(a, _mm256_set1_ps(s.near_origin[axis])), inverse);
            let f = _mm256_mul_ps(_mm256_sub_ps(b, _mm256_set1_ps(s.far_origin[axis])), inverse);
            lo = _mm256_max_ps(n, lo);
            hi = _mm256_min_ps(f, hi);
        }
        _mm256_storeu_ps(near.as_mut_ptr(), lo);
        let l = _mm256_mul_ps(lo, _mm256_set1_ps(1.0 - SLACK));
        let h = _mm256_mul_ps(hi, _mm256_set1_ps(1.0 + SLACK));
        _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_LE_OQ>(l, h)) as u32
    }
}

/// A child with the distance to its box, in one word that sorts by distance: distances are not negative.
#[inline(always)]
fn packed(distance: f32, child: u32) -> u64 {
    u64::from(distance.to_bits()) << 32 | u64::from(child)
}

/// Distances up to which children are worth opening, as their bits in [`packed`] words.
#[inline(always)]
fn tree_limit(bvh: &Bvh, s: &Setup, max: f64) -> f32 {
    let distance = ((max - s.advance) * bvh.scale) as f32;
    distance * (1.0 + 2.0 * SLACK) + f32::MIN_POSITIVE
}

/// Writes the traversal once for each slab test.
macro_rules! traversal {
    ($(#[$attribute:meta])* $name:ident, $slabs:path) => {
        $(#[$attribute])*
        #[inline]
        fn $name<const SORTED: bool>(
            bvh: &Bvh,
            s: &Setup,
            range: Range,
            stack: &mut [u64],
            mut visit: impl FnMut(u32, f64) -> f64,
        ) {
            let mut max = range.max;
            let tree_min = (((range.min - s.advance) * bvh.scale) as f32).max(0.0);
            let mut limit = tree_limit(bvh, s, max);
            let mut near = [0f32; WIDTH];
            let mut entry = 0u32;
            let mut top = 0;
            loop {
                if entry & LEAF != 0 {
                    for i in leaf_places(entry) {
                        let closer = visit(bvh.primitive(i), max);
                        if closer < max {
                            max = closer;
                            if max <= range.min {
                                return;
                            }
                            limit = tree_limit(bvh, s, max);
                        }
                    }
                } else {
                    let node = &bvh.nodes[entry as usize];
                    let mut mask = $slabs(node, s, tree_min, limit, &mut near);
                    let bottom = top;
                    while mask != 0 {
                        let i = mask.trailing_zeros() as usize;
                        mask &= mask - 1;
                        let item = packed(near[i], node.child[i]);
                        if SORTED {
                            // Nearest on top.
                            let mut at = top;
                            while at > bottom && stack[at - 1] < item {
                                stack[at] = stack[at - 1];
                                at -= 1;
                            }
                            stack[at] = item;
                        } else {
                            stack[top] = item;
                        }
                        top += 1;
                    }
                    if top > bottom {
                        top -= 1;
                        entry = stack[top] as u32;
                        continue;
                    }
                }
                loop {
                    if top == 0 {
                        return;
                    }
                    top -= 1;
                    let item = stack[top];
                    if f32::from_bits((item >> 32) as u32) <= limit {
                        entry = item as u32;
                        break;
                    }
                }
            }
        }
    };
}

traversal!(plain, slabs);

#[cfg(target_arch = "x86_64")]
traversal!(
    #[target_feature(enable = "avx2")]
    wide,
    slabs_avx2
);

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::math::Aabb;
    use crate::math::bvh::Quality;

    /// Both slab tests give the same bits for boxes and rays of all sizes.
    #[test]
    #[cfg(target_arch = "x86_64")]
    fn wide_slabs_equal_plain_ones() {
        if !std::arch::is_x86_feature_detected!("avx2") {
            println!("skipped: no AVX2");
            return;
        }
        let mut random = super::super::tests::Random::new(7);
        let boxes: Vec<Aabb> = (0..200).map(|_| random.aabb(1.0, 0.2)).collect();
        let bvh = Bvh::build(&boxes, Quality::Best);
        for _ in 0..2000 {
            let ray = Ray::new(random.vector(2.0), random.direction());
            let Some(s) = bvh.setup(&ray, Range::FORWARD) else { continue };
            for node in &bvh.nodes {
                let (mut a, mut b) = ([0f32; WIDTH], [0f32; WIDTH]);
                let p = slabs(node, &s, 0.0, f32::INFINITY, &mut a);
                // SAFETY: AVX2 was detected above.
                #[allow(unsafe_code)]
                let w = unsafe { slabs_avx2(node, &s, 0.0, f32::INFINITY, &mut b) };
                assert_eq!(p, w);
                assert_eq!(a.map(f32::to_bits), b.map(f32::to_bits));
            }
        }
    }
}
