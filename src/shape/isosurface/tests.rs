use super::*;
use crate::shape::conformance::Random;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// A function of a point with, perhaps, its range over boxes.
struct Formula {
    value: fn(Vec3) -> f64,
    range: Option<fn(Vec3, Vec3) -> (f64, f64)>,
    calls: AtomicUsize,
}

impl std::fmt::Debug for Formula {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.write_str("Formula")
    }
}

impl Field for Formula {
    fn value(&self, p: Vec3) -> f64 {
        self.calls.fetch_add(1, Relaxed);
        (self.value)(p)
    }
    fn range(&self, b: &Aabb) -> Option<(f64, f64)> {
        self.range.map(|range| range(b.min, b.max))
    }
}

fn formula(value: fn(Vec3) -> f64, range: Option<fn(Vec3, Vec3) -> (f64, f64)>) -> Arc<Formula> {
    Arc::new(Formula { value, range, calls: AtomicUsize::new(0) })
}

/// The squares of the nearest and the farthest point of a box from the origin.
fn squares(a: Vec3, b: Vec3) -> (f64, f64) {
    let near = Vec3::ZERO.clamp(a, b);
    (near.length_squared(), a.abs().max(b.abs()).length_squared())
}

fn ball() -> Isosurface {
    let range = |a, b| {
        let (near, far) = squares(a, b);
        (near.sqrt() - 1.2, far.sqrt() - 1.2)
    };
    let function = formula(|p| p.length() - 1.2, Some(range));
    Isosurface { max_gradient: 1.5, accuracy: 0.0001, ..Isosurface::new(function) }
}

fn hyperboloid() -> Isosurface {
    let function = formula(|p| p.x * p.x + p.y * p.y - p.z * p.z * 0.5, None);
    Isosurface {
        threshold: 0.3,
        open: true,
        container: Container::sphere(Vec3::ZERO, 1.3),
        max_gradient: 4.0,
        accuracy: 0.0001,
        ..Isosurface::new(function)
    }
}

/// Two balls.
fn pair() -> Isosurface {
    let function = formula(|p| (p.x.abs() - 0.5).hypot(p.y).hypot(p.z) - 0.3, None);
    Isosurface { max_gradient: 1.01, max_trace: 10, ..Isosurface::new(function) }
}

#[test]
fn agrees_with_the_reference() {
    let text = include_str!("../../../tests/data/isosurface-trace-oracle.csv");
    let mut rows = 0;
    for line in text.lines() {
        let surface = match line.split(',').next() {
            Some("isosurface_sphere_in_box") => ball(),
            Some("isosurface_open_thresh") => hyperboloid(),
            _ => continue,
        };
        let numbers = line.rsplit('"').next().unwrap().split(',').skip(1);
        let n: Vec<f64> = numbers.map(|n| n.parse().unwrap()).collect();
        let vector = |i: usize| Vec3::new(n[i], n[i + 1], n[i + 2]);
        let ray = Ray::new(vector(0), vector(3).normalize());
        let found = surface.nearest(&ray, Range::FORWARD);
        assert_eq!(found.is_some(), n[6] == 1.0, "{line}");
        if let Some(crossing) = found {
            let (p, _) = surface.locate(&ray, &crossing);
            assert!(p.distance(vector(7)) < 1e-11, "{p}: {line}");
            let turned = vector(10).distance(surface.normal(p, &crossing));
            assert!(turned < 1e-9, "{turned}: {line}");
        }
        rows += 1;
    }
    assert_eq!(rows, 48);
}

fn rays(seed: u64) -> impl Iterator<Item = Ray> {
    let mut random = Random::new(seed);
    let stage = Aabb::new(Vec3::NEG_ONE, Vec3::ONE);
    (0..2000).map(move |i| {
        let target = random.in_box(&stage);
        let away = random.direction();
        let distance = [0.0, 3.0, 300.0][i % 3];
        Ray::new(target + distance * away, if distance > 0.0 { -away } else { away })
    })
}

#[test]
fn cells_change_no_crossing_and_save_work() {
    let known = Isosurface { max_gradient: 8.0, ..ball() };
    let function = formula(|p| p.length() - 1.2, None);
    let unknown = Isosurface { function: function.clone(), cells: Arc::default(), ..known.clone() };
    let counter = formula(
        |p| p.length() - 1.2,
        Some(|a, b| {
            let (near, far) = squares(a, b);
            (near.sqrt() - 1.2, far.sqrt() - 1.2)
        }),
    );
    let known = Isosurface { function: counter.clone(), cells: Arc::default(), ..known };
    for ray in rays(5) {
        let (mut with, mut without) = (Vec::new(), Vec::new());
        known.crossings(&ray, Range::FORWARD, &mut with);
        unknown.crossings(&ray, Range::FORWARD, &mut without);
        assert_eq!(with.len(), without.len(), "{ray:?}");
        for (a, b) in with.iter().zip(&without) {
            assert!((a.t - b.t).abs() < 1e-12 * (1.0 + a.t) && a.part == b.part, "{a:?} {b:?}");
        }
    }
    let (with, without) = (counter.calls.load(Relaxed), function.calls.load(Relaxed));
    assert!(with < without, "{with} {without}");
}

#[test]
fn points_lie_behind_zeros_by_at_most_the_accuracy() {
    for accuracy in [0.02, 1e-3, 1e-6] {
        let surface = Isosurface { accuracy, ..pair() };
        for ray in rays(6) {
            let mut found = Vec::new();
            surface.crossings(&ray, Range::FORWARD, &mut found);
            for crossing in found.iter().filter(|c| c.part == 0) {
                let value = surface.value(ray.at(crossing.t));
                assert!(value.abs() < accuracy + 1e-12, "{value}");
            }
        }
    }
}

#[test]
fn zeros_are_exact_where_the_accuracy_is_coarse() {
    let small = pair().placed(&Transform::scale(Vec3::splat(1e-4))).unwrap();
    for ray in rays(6) {
        let mut found = Vec::new();
        small.crossings(&ray, Range::FORWARD, &mut found);
        for crossing in found.iter().filter(|c| c.part == 0) {
            let value = pair().value(ray.at(crossing.t));
            assert!(value.abs() < 1e-13 * (10.0 + crossing.t), "{value}");
        }
    }
}

#[test]
fn every_crossing_is_counted_up_to_max_trace() {
    let ray = Ray::new(Vec3::new(-3.0, 0.1, 0.0), Vec3::X);
    let mut found = Vec::new();
    pair().crossings(&ray, Range::FORWARD, &mut found);
    assert_eq!(found.len(), 4);
    let mut few = Vec::new();
    Isosurface { max_trace: 2, ..pair() }.crossings(&ray, Range::FORWARD, &mut few);
    assert_eq!(few, found[..2]);
}

#[test]
fn a_solid_that_fills_its_container_shows_the_container() {
    let full = Isosurface { max_trace: 10, ..Isosurface::new(formula(|p| p.z, None)) };
    let mut found = Vec::new();
    full.crossings(&Ray::new(Vec3::new(0.1, 0.2, 3.0), Vec3::NEG_Z), Range::FORWARD, &mut found);
    let ts: Vec<f64> = found.iter().map(|c| c.t).collect();
    assert!((3.0..3.001).contains(&ts[0]) && ts[1..] == [4.0], "{ts:?}");
    let normal = full.normal(Vec3::new(0.1, 0.2, -1.0), &found[1]);
    assert_eq!(normal, Vec3::NEG_Z);
    let open = Isosurface { open: true, ..full };
    found.clear();
    open.crossings(&Ray::new(Vec3::new(0.1, 0.2, -3.0), Vec3::Z), Range::FORWARD, &mut found);
    assert_eq!(found.len(), 1);
}

#[test]
fn a_small_copy_looks_like_the_large_one() {
    let large = pair();
    let ray = Ray::new(Vec3::new(-3.0, 0.29, 0.0), Vec3::X);
    let small = large.placed(&Transform::scale(Vec3::splat(1e-6))).unwrap();
    let (a, b) = (small.nearest(&ray, Range::FORWARD), large.nearest(&ray, Range::FORWARD));
    assert!((a.unwrap().t - b.unwrap().t).abs() < 0.001);
}

#[test]
fn an_adapting_bound_finds_what_a_small_one_misses() {
    let dip = formula(|p| 1.6 + 1.2 * p.z - (8.0 * (0.2 - (p.z + 0.3).abs())).max(0.0), None);
    let ray = Ray::new(Vec3::new(0.05, 0.02, 3.0), Vec3::NEG_Z);
    let fixed = Isosurface { max_gradient: 1.3, ..Isosurface::new(dip) };
    assert_eq!(fixed.nearest(&ray, Range::FORWARD), None);
    let adapting = Isosurface { evaluate: Some([1.0, 3.0, 0.9]), ..fixed };
    assert!(adapting.nearest(&ray, Range::FORWARD).is_some());
}
