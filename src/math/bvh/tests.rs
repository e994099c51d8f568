use super::{Bvh, LEAF, Quality, WIDTH, leaf_places};
use crate::math::{Aabb, Accelerator, Range, Ray, Vec3};

/// A small generator, so that the tests repeat.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Random(seed)
    }

    /// Uniform in 0..1.
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn vector(&mut self, size: f64) -> Vec3 {
        Vec3::new(self.unit() - 0.5, self.unit() - 0.5, self.unit() - 0.5) * (2.0 * size)
    }

    pub fn direction(&mut self) -> Vec3 {
        let d = self.vector(1.0).normalize_or(Vec3::X);
        match (self.unit() * 8.0) as u32 {
            0 => Vec3::X,
            1 => -Vec3::Y,
            2 => Vec3::new(d.x, 0.0, d.z).normalize_or(Vec3::Z),
            _ => d,
        }
    }

    pub fn aabb(&mut self, place: f64, size: f64) -> Aabb {
        let c = self.vector(place);
        let s = self.vector(size);
        Aabb::new(c - s, c + s)
    }
}

/// Spheres as centre and radius.
fn sphere_hit(ray: &Ray, c: Vec3, r: f64) -> Option<f64> {
    let oc = c - ray.origin;
    let b = oc.dot(ray.dir);
    let perpendicular = oc - b * ray.dir;
    let h = r * r - perpendicular.length_squared();
    if h < 0.0 {
        return None;
    }
    let root = h.sqrt();
    [b - root, b + root].into_iter().find(|t| *t > 0.0)
}

/// Nearest sphere by what `build` makes of the boxes and by brute force for `rays` rays; they must agree exactly.
fn compare<A: Accelerator>(
    build: &impl Fn(&[Aabb]) -> Vec<A>,
    spheres: &[(Vec3, f64)],
    rays: usize,
    random: &mut Random,
    origins: impl Fn(&mut Random) -> Vec3,
) {
    let boxes: Vec<Aabb> = spheres.iter().map(|(c, r)| Aabb::new(*c, *c).grown(*r)).collect();
    let built = build(&boxes);
    for accelerator in &built {
        for _ in 0..rays / built.len() {
            let origin = origins(random);
            let aim = &spheres[(random.unit() * spheres.len() as f64) as usize];
            let toward = (aim.0 + random.vector(aim.1) - origin).normalize_or(Vec3::X);
            let dir = if random.unit() < 0.7 { toward } else { random.direction() };
            let ray = Ray::new(origin, dir);
            let brute = spheres.iter().filter_map(|(c, r)| sphere_hit(&ray, *c, *r)).reduce(f64::min);
            let mut best = None;
            accelerator.traverse(&ray, Range::FORWARD, |i, max| {
                let (c, r) = spheres[i as usize];
                match sphere_hit(&ray, c, r) {
                    Some(t) if t < max => {
                        best = Some(t);
                        t
                    }
                    _ => max,
                }
            });
            assert_eq!(brute, best, "ray {ray:?}");
        }
    }
}

/// `rays` rays in each of six scenes that are hard on numbers.
pub fn cases<A: Accelerator>(build: impl Fn(&[Aabb]) -> Vec<A>, rays: usize) {
    let build = &build;
    let mut random = Random::new(1);
    let even: Vec<(Vec3, f64)> = (0..300).map(|_| (random.vector(1.0), 0.05 * random.unit())).collect();
    compare(build, &even, rays, &mut random, |r| r.vector(2.0));
    // Origins a million scene sizes away.
    compare(build, &even, rays, &mut random, |r| r.direction() * 1e6 + r.vector(1.0));
    // Far from the origin of space, and tiny.
    let far: Vec<(Vec3, f64)> = even.iter().map(|(c, r)| (*c + Vec3::splat(1e6), *r)).collect();
    compare(build, &far, rays, &mut random, |r| r.vector(2.0) + Vec3::splat(1e6));
    let tiny: Vec<(Vec3, f64)> = even.iter().map(|(c, r)| (*c * 1e-9, *r * 1e-9)).collect();
    compare(build, &tiny, rays, &mut random, |r| r.vector(2e-9));
    // Extents of 1 : 10^8 in one scene, with a sky around it.
    let mut mixed: Vec<(Vec3, f64)> =
        (0..300).map(|_| (random.vector(1.0), 10f64.powf(-8.0 * random.unit()))).collect();
    mixed.push((Vec3::ZERO, 1e8));
    mixed.push((Vec3::new(0.0, -1e7, 0.0), 1e7 - 1.0));
    compare(build, &mixed, rays, &mut random, |r| r.vector(2.0));
    // Sizes and places spread over eight decades.
    let spread: Vec<(Vec3, f64)> = (0..300)
        .map(|_| {
            let scale = 10f64.powf(-8.0 * random.unit());
            (random.vector(scale), 0.2 * scale * random.unit())
        })
        .collect();
    compare(build, &spread, rays, &mut random, |r| {
        let scale = 10f64.powf(-8.0 * r.unit());
        r.vector(2.0 * scale)
    });
}

/// Six cases, 10^7 rays in all.
#[test]
fn tree_and_brute_force_agree_for_ten_million_rays() {
    let both =
        |boxes: &[Aabb]| [Quality::Best, Quality::Fast { leaf: 4 }].map(|q| Bvh::build(boxes, q)).into();
    cases(both, 10_000_000 / 6 + 2);
}

/// Rays along the faces of 64 boxes side by side reach every box that they touch.
pub fn faces<A: Accelerator>(build: impl Fn(&[Aabb]) -> A) {
    let boxes: Vec<Aabb> = (0..64)
        .map(|i| {
            let c = Vec3::new(f64::from(i % 4), f64::from(i / 4 % 4), f64::from(i / 16));
            Aabb::new(c, c + 1.0)
        })
        .collect();
    let accelerator = build(&boxes);
    for axis in 0..3 {
        for a in 0..5 {
            for b in 0..5 {
                let mut origin = Vec3::splat(-1.0);
                origin[(axis + 1) % 3] = f64::from(a);
                origin[(axis + 2) % 3] = f64::from(b);
                let mut dir = Vec3::ZERO;
                dir[axis] = 1.0;
                let mut seen = std::collections::BTreeSet::new();
                accelerator.traverse(&Ray::new(origin, dir), Range::FORWARD, |i, max| {
                    seen.insert(i);
                    max
                });
                let touched = (0..64u32).filter(|&i| {
                    let bx = boxes[i as usize];
                    (0..3).all(|k| k == axis || (bx.min[k] <= origin[k] && origin[k] <= bx.max[k]))
                });
                for i in touched {
                    assert!(seen.contains(&i), "axis {axis} at {a},{b}: box {i} not visited");
                }
            }
        }
    }
}

#[test]
fn rays_along_faces_of_boxes_reach_their_primitives() {
    faces(|boxes| Bvh::build(boxes, Quality::Best));
}

#[test]
fn an_empty_tree_and_a_single_box_work() {
    let none = Bvh::build(&[], Quality::Best);
    none.traverse(&Ray::new(Vec3::ZERO, Vec3::X), Range::FORWARD, |_, _| panic!("nothing to visit"));
    let one = Bvh::build(&[Aabb::new(Vec3::ONE, Vec3::splat(2.0))], Quality::Fast { leaf: 2 });
    let mut visits = 0;
    one.traverse(&Ray::new(Vec3::ZERO, Vec3::ONE.normalize()), Range::FORWARD, |i, max| {
        assert_eq!(i, 0);
        visits += 1;
        max
    });
    assert_eq!(visits, 1);
    assert!(one.any_at(Vec3::splat(1.5), |_| true));
    assert!(!one.any_at(Vec3::splat(0.5), |_| true));
}

/// Searches fetch what a node's first child holds: leaves come first, and their rows are where the caller said.
#[test]
fn rows_of_leaves_are_fetched_from_where_they_are() {
    let mut random = Random::new(9);
    let boxes: Vec<Aabb> = (0..300).map(|_| random.aabb(1.0, 0.1)).collect();
    for (leaf, per_place) in [(1, 1), (3, 9)] {
        let mut tree = Bvh::build(&boxes, Quality::Fast { leaf });
        let rows = vec![[0f32; 3]; boxes.len() * per_place];
        tree.set_rows(&rows, per_place);
        let mut leaves = 0;
        for node in &tree.nodes {
            let used = (0..WIDTH).filter(|&i| node.bounds[0][i] <= node.bounds[3][i]);
            let is_leaf: Vec<bool> = used.map(|i| node.child[i] & LEAF != 0).collect();
            assert!(is_leaf.is_sorted_by(|a, b| a >= b), "{is_leaf:?}");
            if is_leaf[0] {
                let place = leaf_places(node.child[0]).start as usize;
                assert_eq!(tree.row(node.child[0]), rows[place * per_place..].as_ptr().cast());
                leaves += 1;
            }
        }
        assert!(leaves > 20);
    }
}
