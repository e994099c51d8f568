use super::*;
use crate::math::bvh::tests::{Random, cases, faces};

/// The cases that trees are held against.
#[test]
fn grid_and_brute_force_agree_for_three_million_rays() {
    cases(|boxes| vec![Grid::build(boxes)], 500_000);
}

#[test]
fn rays_along_faces_of_boxes_reach_their_primitives() {
    faces(Grid::build);
}

/// A ray calls each box once, however many cells they share, and calls all that it meets.
#[test]
fn boxes_are_called_once() {
    let mut random = Random::new(5);
    let boxes: Vec<Aabb> = (0..400).map(|i| random.aabb(1.0, if i % 9 == 0 { 0.8 } else { 0.05 })).collect();
    let grid = Grid::build(&boxes);
    assert!(grid.items.len() > 2 * boxes.len() && grid.cell_count() > boxes.len() / 2, "{:?}", grid.counts);
    for _ in 0..4000 {
        let ray = Ray::new(random.vector(2.0), random.direction());
        let mut calls = vec![0; boxes.len()];
        grid.traverse(&ray, Range::FORWARD, |i, max| {
            calls[i as usize] += 1;
            max
        });
        for (b, calls) in boxes.iter().zip(calls) {
            let (u, v) = ((b.min - ray.origin) * ray.dir.recip(), (b.max - ray.origin) * ray.dir.recip());
            let met = u.min(v).max_element().max(0.0) <= u.max(v).min_element();
            assert!(calls <= 1 && (calls == 1 || !met), "{calls} calls: {b:?} {ray:?}");
        }
    }
}

/// What doubles cannot tell apart is not cut: nothing is lost, and boxes that are large make cells large.
#[test]
fn cells_suit_the_boxes() {
    let unit = Aabb::new(Vec3::ZERO, Vec3::ONE);
    let shifted = |by: Vec3| Aabb { min: unit.min + by, max: unit.max + by };
    let row = |n: u32, step: Vec3| (0..n).map(|i| shifted(step * f64::from(i))).collect::<Vec<_>>();
    assert_eq!(Grid::build(&[]).counts, [1; 3]);
    assert_eq!(Grid::build(&[Aabb::new(Vec3::ONE, Vec3::ONE)]).counts, [1; 3]);
    let line = Grid::build(&row(100, Vec3::new(2.0, 0.0, 0.0)));
    assert!(line.counts[0] > 50 && line.counts[1] == 1 && line.counts[2] == 1, "{:?}", line.counts);
    let far: Vec<Aabb> =
        row(100, Vec3::X).iter().map(|b| Aabb { min: b.min + 1e15, max: b.max + 1e15 }).collect();
    assert_eq!(Grid::build(&far).counts, [1; 3]);
    let same = Grid::build(&vec![unit; 1000]);
    assert!(same.items.len() <= MOST_ENTRIES * 1000, "{}", same.items.len());
    // From where doubles do not tell cells apart every box is asked.
    let ray = Ray::new(Vec3::new(-1e18, 0.5, 0.5), Vec3::X);
    let mut called = 0;
    line.traverse(&ray, Range::FORWARD, |_, max| {
        called += 1;
        max
    });
    assert_eq!(called, 100);
}

#[test]
fn places_are_in_their_boxes() {
    let mut random = Random::new(11);
    let boxes: Vec<Aabb> = (0..200).map(|_| random.aabb(1.0, 0.3)).collect();
    let grid = Grid::build(&boxes);
    for _ in 0..2000 {
        let p = random.vector(1.5);
        let mut called = vec![false; boxes.len()];
        grid.any_at(p, |i| {
            called[i as usize] = true;
            false
        });
        assert!(boxes.iter().zip(called).all(|(b, c)| c || !b.contains(p)), "{p}");
    }
}
