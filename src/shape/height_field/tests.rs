use super::blocks::PARTS;
use super::*;

fn hills(width: usize, height: usize, smooth: bool, water: f64) -> HeightField {
    let at = |i: usize, j: usize| {
        let (x, z) = (i as f64 / (width - 1) as f64, j as f64 / (height - 1) as f64);
        ((0.5 + 0.3 * (5.0 * x).sin() * (4.0 * z).cos()) * 65535.0) as u16
    };
    let samples = (0..height).flat_map(|j| (0..width).map(move |i| (i, j))).map(|(i, j)| at(i, j)).collect();
    HeightField::new(width, height, samples, smooth, water).unwrap()
}

#[test]
fn blocks_miss_no_cell() {
    let field = hills(37, 22, false, 0.0);
    let mut random = crate::shape::conformance::Random::new(9);
    let around = Aabb::new(Vec3::new(-0.5, -0.2, -0.5), Vec3::new(1.5, 1.2, 1.5));
    for _ in 0..1500 {
        let (origin, target) = (random.in_box(&around), random.in_box(&around));
        let ray = Ray::new(origin, (target - origin).normalize());
        let mut found = Vec::new();
        field.crossings(&ray, Range::FORWARD, &mut found);
        let shear = Shear::new(ray.dir);
        let mut expected = 0;
        for j in 0..21 {
            for i in 0..36 {
                for upper in [false, true] {
                    let [a, b, c] = field.grid.triangle(i, j, upper).map(|p| p - ray.origin);
                    let n = (b - a).cross(c - a);
                    let t = n.dot(a) / n.dot(ray.dir);
                    expected += usize::from(t > 0.0 && shear.weights([a, b, c]).is_some());
                }
            }
        }
        assert_eq!(found.len(), expected, "{ray:?}");
        let first = found.iter().map(|c| c.t).fold(f64::INFINITY, f64::min);
        assert_eq!(field.nearest(&ray, Range::FORWARD).map_or(f64::INFINITY, |c| c.t), first);
    }
}

/// Four parts of a block at once are passed as they are one by one, to the bit.
#[test]
#[cfg(target_arch = "x86_64")]
fn wide_registers_change_nothing() {
    if !std::arch::is_x86_feature_detected!("avx2") {
        println!("skipped: no AVX2");
        return;
    }
    let field = hills(90, 43, false, 0.0);
    let scale = Vec3::new(89.0, UNIT, 42.0);
    let mut random = crate::shape::conformance::Random::new(3);
    let around = Aabb::new(Vec3::new(-0.5, -0.2, -0.5), Vec3::new(1.5, 1.2, 1.5));
    let mut passed = 0;
    for k in 0..2000 {
        let (origin, mut target) = (random.in_box(&around), random.in_box(&around));
        // Along axes and planes, too.
        (0..3).filter(|axis| k >> axis & 1 == 1).for_each(|axis| target[axis] = origin[axis]);
        let Some(dir) = (target - origin).try_normalize() else { continue };
        let ray = Ray::new(origin * scale, dir * scale);
        let both = |walk: &Walk, block: &Block, range: Range, parts: &Parts| {
            // SAFETY: the processor has just been seen to have what `wide` is compiled for.
            #[allow(unsafe_code)]
            let wide = unsafe { wide::passed(walk, block, range, parts) };
            let plain = walk.passed(block, range, parts);
            let bits = |near: [f64; PARTS]| near.map(f64::to_bits);
            assert_eq!((wide.set, bits(wide.near)), (plain.set, bits(plain.near)), "{ray:?}");
            plain
        };
        let cells = |i: usize, j: usize| {
            let rows = field.grid.cell_rows(i, j);
            let parts = Parts::of_cells(rows);
            // SAFETY: as above.
            #[allow(unsafe_code)]
            let wide = unsafe { wide::of_cells(rows) };
            assert_eq!((wide.least, wide.greatest), (parts.least, parts.greatest));
            parts
        };
        field.grid.blocks.traverse(&ray, Range::FORWARD, cells, both, |_, _, max| {
            passed += 1;
            max
        });
    }
    assert!(passed > 500, "{passed}");
}

#[test]
fn crossings_of_the_columns_flip_the_inside() {
    let field = hills(16, 12, false, 0.0);
    let mut random = crate::shape::conformance::Random::new(4);
    for _ in 0..500 {
        let p = Vec3::new(random.unit(), 2.0, random.unit());
        let ray = Ray::new(p, Vec3::NEG_Y);
        let c = field.nearest(&ray, Range::FORWARD).unwrap();
        assert!(!field.contains(ray.at(c.t - 1e-9)) && field.contains(ray.at(c.t + 1e-9)));
    }
}

#[test]
fn water_hides_what_is_below() {
    let field = hills(16, 12, false, 0.5);
    assert!(field.bounds().min.y >= 0.5);
    assert!(field.contains(Vec3::new(0.9, 0.49, 0.1)) && field.contains(Vec3::new(0.9, -5.0, 0.1)));
    let ray = Ray::new(Vec3::new(0.9, 2.0, 0.1), Vec3::NEG_Y);
    assert!(field.nearest(&ray, Range::FORWARD).is_none());
}

#[test]
fn too_small_grids_are_refused() {
    assert!(HeightField::new(1, 5, vec![0; 5], false, 0.0).is_none());
}
