#[cfg(target_arch = "x86_64")]
use super::wide;
use super::{Bvh, LEAF, Node, Places, WIDTH, leaf_places};
use crate::math::{Range, Ray, Vec3};
use smallvec::SmallVec;
#[cfg(target_arch = "x86_64")]
use std::arch::x86_64::*;

/// Room for the relative rounding of slab distances in single precision: direction, reciprocal, product with
/// the plane and with the origin, on both sides.
const SLACK: f32 = 24.0 * f32::EPSILON;
/// Reciprocals of components are cut off here: slab distances then exceed any tree's size either way.
const LARGEST_INVERSE: f64 = 1e18;
/// Bound on the relative rounding of the move into the tree's coordinates.
const ROUNDING: f64 = 4.01 * f64::EPSILON;
/// Bound on the relative rounding of a coordinate to single precision, of its product with a reciprocal and of
/// its distance from a side.
const SINGLE_ROUNDING: f64 = 6.0 * f32::EPSILON as f64;
/// Rays that start nearer to the tree's middle than this, in the tree's coordinates, are not moved.
const NEAR: f64 = 16.0;

/// A ray in the tree's coordinates, with its rounding bounds worked in: slab distances are
/// `plane * inverse - offset`, from an origin moved back for near planes and forward for far ones.
pub(super) struct Setup {
    pub near_inverse: [f32; 4],
    pub near_offset: [f32; 4],
    pub far_inverse: [f32; 4],
    pub far_offset: [f32; 4],
    pub planes: &'static Planes,
    /// How far the ray was moved along itself before it was rounded, in the caller's units.
    advance: f64,
}

impl Setup {
    const NONE: Setup = Setup {
        near_inverse: [0.0; 4],
        near_offset: [0.0; 4],
        far_inverse: [0.0; 4],
        far_offset: [0.0; 4],
        planes: &PLANES[0],
        advance: 0.0,
    };
}

/// Where in a node's bounds the near plane of each axis begins, and the far one.
pub(super) struct Planes {
    pub near: [usize; 3],
    pub far: [usize; 3],
}

/// For each set of axes along which a ray goes backward.
static PLANES: [Planes; 8] = {
    let mut all =
        [const { Planes { near: [0, WIDTH, 2 * WIDTH], far: [3 * WIDTH, 4 * WIDTH, 5 * WIDTH] } }; 8];
    let mut i = 0;
    while i < 8 {
        let mut axis = 0;
        while axis < 3 {
            if i >> axis & 1 == 1 {
                all[i].near[axis] = (axis + 3) * WIDTH;
                all[i].far[axis] = axis * WIDTH;
            }
            axis += 1;
        }
        i += 1;
    }
    all
};

impl Bvh {
    /// Calls `visit(primitive, max)` with every primitive whose box the ray may meet inside `range`, nearer
    /// boxes first. `visit` returns the new `max`: the distance of the hit it keeps, or `max` unchanged.
    /// A result not above `range.min` ends the search.
    #[inline]
    pub fn traverse(&self, ray: &Ray, range: Range, visit: impl FnMut(u32, f64) -> f64) {
        if let Some(root) = self.nodes.first() {
            self.traverse_below(root, ray, range, visit);
        }
    }

    /// The same from `root` on, which may be of another making.
    #[inline]
    pub(super) fn traverse_below(
        &self,
        root: &Node,
        ray: &Ray,
        range: Range,
        mut visit: impl FnMut(u32, f64) -> f64,
    ) {
        self.walk::<true>(root, ray, range, |leaf, max| self.each_in(leaf, (range.min, max), &mut visit));
    }

    /// The same leaf by leaf: `visit(places, max)` is shown the places in the leaves' order.
    #[inline]
    pub fn traverse_leaves(&self, ray: &Ray, range: Range, visit: impl FnMut(Places, f64) -> f64) {
        if let Some(root) = self.nodes.first() {
            self.walk::<true>(root, ray, range, visit);
        }
    }

    /// Calls `visit` with every primitive whose box the ray may meet inside `range`, in no order, until it
    /// returns true.
    #[inline]
    pub fn any(&self, ray: &Ray, range: Range, mut visit: impl FnMut(u32) -> bool) -> bool {
        self.any_leaf(ray, range, |mut leaf| leaf.any(|i| visit(self.primitive(i))))
    }

    /// The same leaf by leaf.
    #[inline]
    pub fn any_leaf(&self, ray: &Ray, range: Range, visit: impl FnMut(Places) -> bool) -> bool {
        self.nodes.first().is_some_and(|root| self.any_leaf_below(root, ray, range, visit))
    }

    /// The same from `root` on, which may be of another making.
    #[inline]
    pub(super) fn any_leaf_below(
        &self,
        root: &Node,
        ray: &Ray,
        range: Range,
        mut visit: impl FnMut(Places) -> bool,
    ) -> bool {
        let mut found = false;
        self.walk::<false>(root, ray, range, |leaf, max| {
            found = visit(leaf);
            if found { f64::NEG_INFINITY } else { max }
        });
        found
    }

    /// Shows a leaf's primitives to `visit`, until the search is over.
    #[inline(always)]
    fn each_in(
        &self,
        leaf: Places,
        (min, mut max): (f64, f64),
        visit: &mut impl FnMut(u32, f64) -> f64,
    ) -> f64 {
        for i in leaf {
            let closer = visit(self.primitive(i), max);
            if closer < max {
                max = closer;
                if max <= min {
                    break;
                }
            }
        }
        max
    }

    #[inline]
    pub(super) fn walk<const SORTED: bool>(
        &self,
        root: &Node,
        ray: &Ray,
        range: Range,
        visit: impl FnMut(Places, f64) -> f64,
    ) {
        #[cfg(target_arch = "x86_64")]
        if has_wide() {
            // SAFETY: the processor has just been seen to have what `walk_wide` is compiled for.
            #[allow(unsafe_code)]
            unsafe {
                self.walk_wide::<SORTED>(root, ray, range, visit);
            }
            return;
        }
        let Some(setup) = self.setup(ray, range) else { return };
        plain::<SORTED>(self, root, &setup, range, visit);
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2,fma,popcnt")]
    #[inline]
    fn walk_wide<const SORTED: bool>(
        &self,
        root: &Node,
        ray: &Ray,
        range: Range,
        visit: impl FnMut(Places, f64) -> f64,
    ) {
        let mut setup = Setup::NONE;
        if !self.setup_near(ray, range, &mut setup) {
            match self.setup(ray, range) {
                Some(moved) => setup = moved,
                None => return,
            }
        }
        wide::walk::<SORTED>(self, root, &setup, range, visit);
    }

    #[inline(never)]
    fn setup(&self, ray: &Ray, range: Range) -> Option<Setup> {
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
        let far_inverse = inverse * (1.0 + SLACK);
        let backward = inverse.to_array().map(f32::is_sign_negative);
        let planes = (0..3).map(|a| usize::from(backward[a]) << a).sum::<usize>();
        Some(Setup {
            near_inverse: inverse.extend(0.0).to_array(),
            near_offset: ((o + pad) * inverse).extend(0.0).to_array(),
            far_inverse: far_inverse.extend(0.0).to_array(),
            far_offset: ((o - pad) * far_inverse).extend(0.0).to_array(),
            planes: &PLANES[planes],
            advance,
        })
    }

    /// The same, quicker and written to where it is read, for a ray that starts near the tree and need not be
    /// moved; else false.
    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2,fma")]
    #[inline]
    fn setup_near(&self, ray: &Ray, range: Range, setup: &mut Setup) -> bool {
        let four = |v: Vec3, w: f64| _mm256_set_pd(w, v.z, v.y, v.x);
        let o = _mm256_mul_pd(
            _mm256_sub_pd(four(ray.origin, 0.0), four(self.center, 0.0)),
            _mm256_set1_pd(self.scale),
        );
        let size = _mm256_andnot_pd(_mm256_set1_pd(-0.0), o);
        let is_near = _mm256_cmp_pd::<_CMP_LT_OQ>(size, _mm256_set1_pd(NEAR));
        if _mm256_movemask_pd(is_near) != 15 || range.min < 0.0 {
            return false;
        }
        let (sign, limit) = (_mm_set1_ps(-0.0), _mm_set1_ps(LARGEST_INVERSE as f32));
        let inverse = _mm_div_ps(_mm_set1_ps(1.0), _mm256_cvtpd_ps(four(ray.dir, 1.0)));
        let inverse = _mm_max_ps(_mm_min_ps(inverse, limit), _mm_xor_ps(limit, sign));
        let o = _mm256_cvtpd_ps(o);
        let size = _mm_andnot_ps(sign, o);
        let pad = _mm_fmadd_ps(size, _mm_set1_ps(SINGLE_ROUNDING as f32), _mm_set1_ps(self.near_pad));
        let pad = _mm_or_ps(pad, _mm_and_ps(inverse, sign));
        let far_inverse = _mm_mul_ps(inverse, _mm_set1_ps(1.0 + SLACK));
        let near_offset = _mm_mul_ps(_mm_add_ps(o, pad), inverse);
        let far_offset = _mm_mul_ps(_mm_sub_ps(o, pad), far_inverse);
        setup.planes = &PLANES[_mm_movemask_ps(inverse) as usize & 7];
        let put = |row: &mut [f32; 4], value| {
            // SAFETY: a row holds four singles; stores need no alignment.
            #[allow(unsafe_code)]
            unsafe {
                _mm_storeu_ps(row.as_mut_ptr(), value);
            }
        };
        put(&mut setup.near_inverse, inverse);
        put(&mut setup.near_offset, near_offset);
        put(&mut setup.far_inverse, far_inverse);
        put(&mut setup.far_offset, far_offset);
        setup.advance = 0.0;
        true
    }

    /// What the move into the tree's coordinates may cost a ray that starts near the tree.
    pub(super) fn near_pad(center: Vec3, scale: f64) -> f32 {
        let reach = 2.0 * center.abs().max_element() + NEAR / scale;
        // Singles round to nearest: a little more.
        (1.001 * reach * ROUNDING * scale) as f32 + f32::MIN_POSITIVE
    }
}

/// Whether the processor has what the wide traversal is compiled for.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub(super) fn has_wide() -> bool {
    std::arch::is_x86_feature_detected!("avx2")
        && std::arch::is_x86_feature_detected!("fma")
        && std::arch::is_x86_feature_detected!("popcnt")
}

/// Children that wait to be opened, [`packed`].
struct Stack(SmallVec<[u64; 96]>);

impl Stack {
    /// Puts an item below those smaller than it, but not below place `bottom`.
    fn insert(&mut self, item: u64, bottom: usize) {
        let above = self.0[bottom..].iter().rev().take_while(|&&other| other < item).count();
        self.0.insert(self.0.len() - above, item);
    }

    /// Takes the topmost child whose box is no further than `limit`.
    fn next(&mut self, limit: f32) -> Option<u32> {
        loop {
            let item = self.0.pop()?;
            if f32::from_bits((item >> 32) as u32) <= limit {
                return Some(item as u32);
            }
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
        let bounds = node.bounds.as_flattened();
        let (a, b) = (&bounds[s.planes.near[axis]..], &bounds[s.planes.far[axis]..]);
        for i in 0..WIDTH {
            let n = a[i] * s.near_inverse[axis] - s.near_offset[axis];
            let f = b[i] * s.far_inverse[axis] - s.far_offset[axis];
            lo[i] = if n > lo[i] { n } else { lo[i] };
            hi[i] = if f < hi[i] { f } else { hi[i] };
        }
    }
    let mut mask = 0;
    for i in 0..WIDTH {
        mask |= u32::from(lo[i] <= hi[i]) << i;
    }
    *near = lo;
    mask
}

/// A child with the distance to its box, in one word that sorts by distance: distances are not negative.
#[inline(always)]
fn packed(distance: f32, child: u32) -> u64 {
    u64::from(distance.to_bits()) << 32 | u64::from(child)
}

/// What is left of a ray's range, also in the tree's units, a little wider.
pub(super) struct InTree {
    min: f64,
    max: f64,
    /// From here on children are worth opening,
    pub start: f32,
    /// and up to here.
    pub limit: f32,
}

impl InTree {
    #[inline(always)]
    pub fn new(bvh: &Bvh, s: &Setup, range: Range) -> InTree {
        let start = ((range.min - s.advance) * bvh.scale) as f32;
        let start = if start > 0.0 { start } else { 0.0 };
        InTree { min: range.min, max: range.max, start, limit: limit(bvh, s, range.max) }
    }

    /// Shows a leaf to `visit`; false once the search is over.
    #[inline(always)]
    pub fn visit_leaf(
        &mut self,
        bvh: &Bvh,
        s: &Setup,
        leaf: u32,
        visit: &mut impl FnMut(Places, f64) -> f64,
    ) -> bool {
        let closer = visit(leaf_places(leaf), self.max);
        if closer < self.max {
            self.max = closer;
            self.limit = limit(bvh, s, closer);
        }
        self.max > self.min
    }
}

/// A distance in the tree's units, rounded up.
#[inline(always)]
fn limit(bvh: &Bvh, s: &Setup, max: f64) -> f32 {
    let distance = ((max - s.advance) * bvh.scale) as f32;
    distance * (1.0 + 2.0 * SLACK) + f32::MIN_POSITIVE
}

/// The traversal without wide registers.
fn plain<const SORTED: bool>(
    bvh: &Bvh,
    root: &Node,
    s: &Setup,
    range: Range,
    mut visit: impl FnMut(Places, f64) -> f64,
) {
    let mut stack = Stack(SmallVec::new());
    let mut reach = InTree::new(bvh, s, range);
    let mut near = [0f32; WIDTH];
    let mut node = root;
    loop {
        let mut mask = slabs(node, s, reach.start, reach.limit, &mut near);
        let bottom = stack.0.len();
        while mask != 0 {
            let i = mask.trailing_zeros() as usize;
            mask &= mask - 1;
            let item = packed(near[i], node.child[i]);
            // Nearest on top.
            if SORTED { stack.insert(item, bottom) } else { stack.0.push(item) }
        }
        node = loop {
            let Some(next) = stack.next(reach.limit) else { return };
            if next & LEAF == 0 {
                break &bvh.nodes[next as usize];
            }
            if !reach.visit_leaf(bvh, s, next, &mut visit) {
                return;
            }
        };
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::math::Aabb;
    use crate::math::bvh::Quality;

    /// Without wide registers the same is found.
    #[test]
    fn the_plain_way_finds_what_the_wide_one_finds() {
        let mut random = super::super::tests::Random::new(5);
        let mut met = 0;
        for count in [1, 9, 700] {
            let boxes: Vec<Aabb> = (0..count).map(|_| random.aabb(1.0, 0.1)).collect();
            let bvh = Bvh::build(&boxes, Quality::Best);
            for _ in 0..500 {
                let ray = Ray::new(random.vector(2.0), random.direction());
                let setup = bvh.setup(&ray, Range::FORWARD);
                let enter = |i: u32, max: f64| {
                    let b = &boxes[i as usize];
                    let (a, c) = ((b.min - ray.origin) / ray.dir, (b.max - ray.origin) / ray.dir);
                    let (near, far) = (a.min(c).max_element().max(0.0), a.max(c).min_element());
                    if near <= far && near < max { near } else { max }
                };
                let (mut wide, mut narrow) = (f64::INFINITY, f64::INFINITY);
                bvh.traverse(&ray, Range::FORWARD, |i, max| {
                    wide = enter(i, max);
                    wide
                });
                if let Some(setup) = setup {
                    plain::<true>(&bvh, &bvh.nodes[0], &setup, Range::FORWARD, |leaf, max| {
                        narrow = leaf.fold(max, |max, i| enter(bvh.primitive(i), max));
                        narrow
                    });
                }
                assert_eq!(wide, narrow, "{ray:?}");
                met += usize::from(wide.is_finite());
            }
        }
        assert!(met > 50, "{met}");
    }

    /// The quick way to set a ray up says what the other one says.
    #[test]
    #[cfg(target_arch = "x86_64")]
    fn near_rays_are_set_up_alike() {
        if !has_wide() {
            println!("skipped: no AVX2");
            return;
        }
        let mut random = super::super::tests::Random::new(3);
        let boxes: Vec<Aabb> = (0..50).map(|_| random.aabb(1.0, 0.2)).collect();
        let bvh = Bvh::build(&boxes, Quality::Best);
        let mut near = 0;
        for i in 0..4000 {
            let mut dir = random.direction();
            if i % 3 == 0 {
                dir[i % 9 / 3] = 0.0;
            }
            if dir.length() < 0.1 {
                continue;
            }
            let ray = Ray::new(random.vector(10f64.powi(i as i32 % 7 - 4)), dir.normalize());
            let mut quick = Setup::NONE;
            #[allow(unsafe_code)]
            // SAFETY: the features were detected above.
            if !unsafe { bvh.setup_near(&ray, Range::FORWARD, &mut quick) } {
                continue;
            }
            let Some(slow) = bvh.setup(&ray, Range::FORWARD) else { continue };
            assert!(std::ptr::eq(quick.planes, slow.planes), "{ray:?}");
            for a in 0..3 {
                let close = |x: f32, y: f32| (x - y).abs() <= 4.0 * f32::EPSILON * x.abs();
                assert!(close(quick.near_inverse[a], slow.near_inverse[a]), "{ray:?}");
                assert!(close(quick.far_inverse[a], slow.far_inverse[a]), "{ray:?}");
                if slow.advance == 0.0 {
                    let room = 1e-6 * quick.near_inverse[a].abs() * (1.0 + ray.origin[a].abs() as f32);
                    assert!((quick.near_offset[a] - slow.near_offset[a]).abs() <= room, "{ray:?}");
                    assert!((quick.far_offset[a] - slow.far_offset[a]).abs() <= room, "{ray:?}");
                }
            }
            near += 1;
        }
        assert!(near > 1000, "{near}");
    }

    /// Neither slab test loses a child that the ray meets, and both find the same distances.
    #[test]
    #[cfg(target_arch = "x86_64")]
    fn wide_slabs_agree_with_plain_ones() {
        if !has_wide() {
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
                let mut a = [0f32; WIDTH];
                let p = slabs(node, &s, 0.0, f32::INFINITY, &mut a);
                // SAFETY: the features were detected above.
                #[allow(unsafe_code)]
                let (w, b, nearest) = unsafe { wide::slabs_of(node, &s, 0.0, f32::INFINITY) };
                assert_eq!(p, w);
                let met = || (0..WIDTH).filter(|i| p >> i & 1 == 1);
                for i in met() {
                    assert!((a[i] - b[i]).abs() <= 1e-5 * (1.0 + a[i].abs()), "{} {}", a[i], b[i]);
                }
                let least = met().map(|i| b[i]).reduce(f32::min);
                assert!(least.is_none_or(|least| b[nearest] == least && p >> nearest & 1 == 1));
            }
        }
    }
}
