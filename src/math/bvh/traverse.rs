use super::{Bvh, LEAF, Node, WIDTH, leaf_places};
use crate::math::{Range, Ray, Vec3};

/// Relative error of a slab distance in single precision: direction, reciprocal, difference, product.
const SLACK: f32 = 8.0 * f32::EPSILON;
/// Reciprocals of components are cut off here: slab distances then exceed any tree's size either way.
const LARGEST_INVERSE: f64 = 1e18;
/// Bound on the relative rounding of the move into the tree's coordinates.
const ROUNDING: f64 = 4.01 * f64::EPSILON;
/// Bound on the relative rounding of a coordinate to single precision and of its distance from a side.
const SINGLE_ROUNDING: f64 = 4.0 * f32::EPSILON as f64;

/// Room for waiting children that a ray sets aside without asking for memory; deeper trees ask.
const STACK: usize = 96;
/// The same for small trees, which most scenes have.
const SMALL_STACK: usize = 16;

/// A ray in the tree's coordinates, with its rounding bounds worked in.
struct Setup {
    /// Where slab distances are measured from: moved back for near planes, forward for far ones.
    near_origin: [f32; 4],
    far_origin: [f32; 4],
    inverse: [f32; 4],
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
        #[cfg(target_arch = "x86_64")]
        if std::arch::is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has just been seen to have what `setup_avx2` is compiled for.
            #[allow(unsafe_code)]
            return unsafe { self.setup_avx2(ray, range) };
        }
        self.setup_plain(ray, range)
    }

    fn setup_plain(&self, ray: &Ray, range: Range) -> Option<Setup> {
        // Infinite for 0, which the pad keeps from meeting another 0.
        let inverse = ray.dir.recip();
        let pad = ray.origin.abs() * (2.0 * f64::EPSILON) + f64::MIN_POSITIVE;
        let a = (self.bounds.min - pad - ray.origin) * inverse;
        let b = (self.bounds.max + pad - ray.origin) * inverse;
        let advance = entry(a.min(b).max_element(), a.max(b).min_element(), range)?;
        let o = (ray.origin + advance * ray.dir - self.center) * self.scale;
        let reach = ray.origin.abs() + (self.center.abs() + advance);
        let pad = reach * (ROUNDING * self.scale) + o.abs() * SINGLE_ROUNDING;
        let inverse = inverse.clamp(Vec3::splat(-LARGEST_INVERSE), Vec3::splat(LARGEST_INVERSE)).as_vec3();
        let pad = (pad.as_vec3() + f32::MIN_POSITIVE).copysign(inverse);
        let o = o.as_vec3();
        let (near, far) = ((o + pad).extend(0.0), (o - pad).extend(0.0));
        Some(Setup::new(near.to_array(), far.to_array(), inverse.extend(1.0).to_array(), advance))
    }

    /// [`Bvh::setup_plain`], all axes at once.
    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    fn setup_avx2(&self, ray: &Ray, range: Range) -> Option<Setup> {
        use std::arch::x86_64::*;
        let four = |v: Vec3, w: f64| _mm256_set_pd(w, v.z, v.y, v.x);
        let all = |x: f64| _mm256_set1_pd(x);
        let sign = all(-0.0);
        // The fourth place is a slab without ends.
        let (origin, dir, center) = (four(ray.origin, 0.0), four(ray.dir, 1.0), four(self.center, 0.0));
        let size = _mm256_andnot_pd(sign, origin);
        let inverse = _mm256_div_pd(all(1.0), dir);
        let pad = _mm256_add_pd(_mm256_mul_pd(size, all(2.0 * f64::EPSILON)), all(f64::MIN_POSITIVE));
        let low = _mm256_sub_pd(_mm256_sub_pd(four(self.bounds.min, f64::NEG_INFINITY), pad), origin);
        let high = _mm256_sub_pd(_mm256_add_pd(four(self.bounds.max, f64::INFINITY), pad), origin);
        let (a, b) = (_mm256_mul_pd(low, inverse), _mm256_mul_pd(high, inverse));
        let (near, far) = (_mm256_min_pd(a, b), _mm256_max_pd(a, b));
        let near = _mm_max_pd(_mm256_castpd256_pd128(near), _mm256_extractf128_pd::<1>(near));
        let far = _mm_min_pd(_mm256_castpd256_pd128(far), _mm256_extractf128_pd::<1>(far));
        let near = _mm_cvtsd_f64(_mm_max_sd(near, _mm_unpackhi_pd(near, near)));
        let far = _mm_cvtsd_f64(_mm_min_sd(far, _mm_unpackhi_pd(far, far)));
        let advance = entry(near, far, range)?;
        let moved = _mm256_add_pd(origin, _mm256_mul_pd(all(advance), dir));
        let o = _mm256_mul_pd(_mm256_sub_pd(moved, center), all(self.scale));
        let reach = _mm256_add_pd(size, _mm256_add_pd(_mm256_andnot_pd(sign, center), all(advance)));
        let cost = _mm256_mul_pd(reach, all(ROUNDING * self.scale));
        let single = _mm256_mul_pd(_mm256_andnot_pd(sign, o), all(SINGLE_ROUNDING));
        let pad = _mm256_cvtpd_ps(_mm256_add_pd(cost, single));
        let inverse = _mm256_min_pd(_mm256_max_pd(inverse, all(-LARGEST_INVERSE)), all(LARGEST_INVERSE));
        let (inverse, o) = (_mm256_cvtpd_ps(inverse), _mm256_cvtpd_ps(o));
        let pad = _mm_add_ps(pad, _mm_set1_ps(f32::MIN_POSITIVE));
        let pad = _mm_or_ps(pad, _mm_and_ps(inverse, _mm_set1_ps(-0.0)));
        let (near, far) = (_mm_add_ps(o, pad), _mm_sub_ps(o, pad));
        let mut rows = [[0f32; 4]; 3];
        // SAFETY: each row holds four singles; stores need no alignment.
        #[allow(unsafe_code)]
        unsafe {
            _mm_storeu_ps(rows[0].as_mut_ptr(), near);
            _mm_storeu_ps(rows[1].as_mut_ptr(), far);
            _mm_storeu_ps(rows[2].as_mut_ptr(), inverse);
        }
        Some(Setup::new(rows[0], rows[1], rows[2], advance))
    }
}

impl Setup {
    #[inline(always)]
    fn new(near_origin: [f32; 4], far_origin: [f32; 4], inverse: [f32; 4], advance: f64) -> Self {
        let backward = |axis: usize| 3 * usize::from(inverse[axis].is_sign_negative());
        let (x, y, z) = (backward(0), backward(1), backward(2));
        Self {
            near_origin,
            far_origin,
            inverse,
            near_plane: [x, 1 + y, 2 + z],
            far_plane: [3 - x, 4 - y, 5 - z],
            advance,
        }
    }
}

/// How far to move a ray before it is rounded: to where it enters the box of everything (`near`), or 0 when
/// it starts inside. `None` if it misses that box.
#[inline(always)]
fn entry(near: f64, far: f64, range: Range) -> Option<f64> {
    let near = if near > range.min { near } else { range.min };
    let far = if far < range.max { far } else { range.max };
    let slack = 8.0 * f64::EPSILON * (near.abs() + far.abs());
    if near > far + slack || near == f64::INFINITY {
        return None;
    }
    Some(if near > 0.0 { near } else { 0.0 })
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

    /// Both ways to set a ray up give the same bits.
    #[test]
    #[cfg(target_arch = "x86_64")]
    fn wide_setup_equals_the_plain_one() {
        if !std::arch::is_x86_feature_detected!("avx2") {
            println!("skipped: no AVX2");
            return;
        }
        let mut random = super::super::tests::Random::new(3);
        let boxes: Vec<Aabb> = (0..50).map(|_| random.aabb(1.0, 0.2)).collect();
        let bvh = Bvh::build(&boxes, Quality::Best);
        for i in 0..4000 {
            let mut dir = random.direction();
            if i % 3 == 0 {
                dir[i % 9 / 3] = 0.0;
            }
            let ray = Ray::new(random.vector(10f64.powi(i as i32 % 7 - 2)), dir.normalize());
            let plain = bvh.setup_plain(&ray, Range::FORWARD);
            // SAFETY: AVX2 was detected above.
            #[allow(unsafe_code)]
            let wide = unsafe { bvh.setup_avx2(&ray, Range::FORWARD) };
            let bits = |s: Option<Setup>| {
                s.map(|s| {
                    let rows = [s.near_origin, s.far_origin, s.inverse].map(|r| [r[0], r[1], r[2]]);
                    (rows.map(|r| r.map(f32::to_bits)), s.near_plane, s.far_plane, s.advance.to_bits())
                })
            };
            assert_eq!(bits(plain), bits(wide), "{ray:?}");
        }
    }

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
