//! Laws of combinations, and what hits promise.

use super::convex::Glance;
use super::flatten::Flattened;
use super::geometry::{Found, Geometry, NONE, Solid};
use super::hit::{Obstacle, RayClass};
use super::probe::Probe;
use super::scratch::with_lists;
use super::{Accel, ObjectQuery};
use crate::math::strategy::vector;
use crate::math::{Range, Ray, Transform, Vec3};
use crate::scene::{Body, CsgOp, Object};
use crate::shape::{Cuboid, Plane, Shape, Sphere};
use proptest::prelude::*;
use std::sync::Arc;

pub(super) fn shape(s: impl Shape + 'static) -> Object {
    Object::new(Body::Shape(Arc::new(s)))
}

pub(super) fn csg(op: CsgOp, children: &[&Object]) -> Object {
    let children = children.iter().map(|&c| Arc::new(c.clone())).collect();
    Object::new(Body::Csg { op, children: Arc::new(children) })
}

fn inverse(object: &Object) -> Object {
    let mut o = object.clone();
    o.flags.inverse = !o.flags.inverse;
    o
}

/// A sphere or a box, turned and stretched.
fn solid() -> impl Strategy<Value = Object> {
    (any::<bool>(), vector(1.0), 0.2..1.5f64, vector(180.0), 0.3..2.0f64).prop_map(
        |(round, c, r, turn, k)| {
            let mut o = if round { shape(Sphere::new(c, r)) } else { shape(Cuboid::new(c - r, c + 0.7 * r)) };
            o.apply(&Transform::scale(Vec3::new(1.0, k, 1.0)).then(&Transform::rotate(turn)));
            o
        },
    )
}

fn ray() -> impl Strategy<Value = Ray> {
    (vector(5.0), vector(1.0))
        .prop_filter("a direction", |(_, d)| d.length() > 0.1)
        .prop_map(|(o, target)| Ray::new(o, (target - o).normalize()))
}

/// Distances of the nearest hit agree.
fn same_hit(a: &Object, b: &Object, ray: &Ray) -> bool {
    let t = |o: &Object| ObjectQuery::new(o).trace(ray).map(|(p, _)| p.distance(ray.origin));
    match (t(a), t(b)) {
        (None, None) => true,
        (Some(x), Some(y)) => (x - y).abs() < 1e-9,
        _ => false,
    }
}

proptest! {
    #[test]
    fn containment_follows_the_logic(a in solid(), b in solid(), p in vector(3.0)) {
        let inside = |o: &Object| ObjectQuery::new(o).contains(p);
        let (x, y) = (inside(&a), inside(&b));
        prop_assert_eq!(inside(&csg(CsgOp::Union, &[&a, &b])), x || y);
        prop_assert_eq!(inside(&csg(CsgOp::Merge, &[&a, &b])), x || y);
        prop_assert_eq!(inside(&csg(CsgOp::Intersection, &[&a, &b])), x && y);
        prop_assert_eq!(inside(&csg(CsgOp::Difference, &[&a, &b])), x && !y);
        prop_assert_eq!(inside(&inverse(&a)), !x);
    }

    #[test]
    fn a_difference_is_an_intersection_with_the_inverse(a in solid(), b in solid(), r in ray()) {
        let d = csg(CsgOp::Difference, &[&a, &b]);
        let i = csg(CsgOp::Intersection, &[&a, &inverse(&b)]);
        prop_assert!(same_hit(&d, &i, &r));
    }

    /// A glance at an intersection says what the careful way says.
    #[test]
    fn a_glance_is_right(
        solids in proptest::collection::vec((solid(), any::<bool>()), 2..6), r in ray(), end in 0.0..12.0f64,
        back in any::<bool>(), plane in vector(1.0),
    ) {
        let mut parts: Vec<Object> =
            solids.iter().map(|(o, hole)| if *hole { inverse(o) } else { o.clone() }).collect();
        parts.extend(Plane::new(plane, 0.2).map(shape));
        let whole = csg(CsgOp::Intersection, &parts.iter().collect::<Vec<_>>());
        let (flat, built, _) = Flattened::of_one(&whole);
        let Solid::Compound(i) = built else { panic!("a combination") };
        let compound = &flat.geometry.compounds[i as usize];
        let range = Range::new(if back { -3.0 } else { 0.0 }, end);
        let probe = Probe::new(&r);
        let careful = with_lists(|lists| {
            let candidates = compound.candidates(&flat.geometry, &probe, range, lists)?;
            compound.nearest_kept(&flat.geometry, &probe, candidates, lists)
        });
        let same = |a: &Found, b: &Found| (a.t, a.leaf, a.crossing) == (b.t, b.leaf, b.crossing);
        match compound.glance(&flat.geometry, &probe, range) {
            Glance::Unsure => {}
            Glance::Nothing => prop_assert!(careful.is_none()),
            Glance::Nearest(found) => prop_assert!(careful.is_some_and(|c| same(&c, &found))),
        }
    }

    #[test]
    fn what_is_met_has_a_nearest_crossing(
        a in solid(), b in solid(), c in solid(), d in solid(), r in ray(), end in 0.0..12.0f64, times in 1..4usize,
    ) {
        let ops = [CsgOp::Union, CsgOp::Merge, CsgOp::Intersection, CsgOp::Difference];
        for op in ops {
            for outer in ops {
                let inner = csg(op, &[&a, &b]);
                let mut members = vec![&inner, &c];
                // Enough for boxes side by side, and for a tree.
                (0..times * times - 1).for_each(|_| members.push(&d));
                let mut whole = csg(outer, &members);
                // Not to be taken apart.
                whole.flags.inverse = true;
                let flat = Flattened::new(&[Arc::new(whole)], Accel::ByScene);
                let range = Range::new(0.0, end);
                for root in &flat.geometry.roots {
                    let nearest = flat.geometry.nearest_of(root.solid, &r, range);
                    prop_assert_eq!(flat.geometry.meets(root.solid, &r, range), nearest.is_some());
                }
            }
        }
    }

    #[test]
    fn de_morgan_holds_for_rays(a in solid(), b in solid(), r in ray()) {
        let left = inverse(&csg(CsgOp::Intersection, &[&a, &b]));
        let right = csg(CsgOp::Merge, &[&inverse(&a), &inverse(&b)]);
        prop_assert!(same_hit(&left, &right, &r));
    }

    #[test]
    fn union_and_merge_look_alike_from_outside(a in solid(), b in solid(), r in ray()) {
        let (u, m) = (csg(CsgOp::Union, &[&a, &b]), csg(CsgOp::Merge, &[&a, &b]));
        prop_assume!(!ObjectQuery::new(&u).contains(r.origin));
        prop_assert!(same_hit(&u, &m, &r));
    }

    #[test]
    fn crossings_of_a_solid_separate_inside_from_outside(a in solid(), b in solid(), c in solid(), r in ray()) {
        let o = csg(CsgOp::Difference, &[&csg(CsgOp::Merge, &[&a, &b]), &c]);
        let query = ObjectQuery::new(&o);
        let mut inside = query.contains(r.origin);
        let mut from = r;
        for _ in 0..20 {
            let Some((p, n)) = query.trace(&from) else { break };
            let leaving = n.dot(r.dir) > 0.0;
            prop_assert_eq!(leaving, inside);
            inside = !inside;
            from.origin = p + 1e-9 * r.dir;
        }
        prop_assert!(!inside);
    }

    #[test]
    fn clipping_is_the_part_of_the_surface_inside(a in solid(), b in solid(), r in ray()) {
        let mut clipped = a.clone();
        clipped.clipped_by.push(Arc::new(b.clone()));
        if let Some((p, _)) = ObjectQuery::new(&clipped).trace(&r) {
            let mut grown = b.clone();
            grown.apply(&Transform::IDENTITY);
            prop_assert!(ObjectQuery::new(&grown).contains(p - 1e-9 * r.dir) || ObjectQuery::new(&grown).contains(p + 1e-9 * r.dir));
        }
    }

    #[test]
    fn a_ray_that_leaves_a_hit_by_its_error_does_not_meet_it_again(
        a in solid(), shift in vector(1.0), e in -6.0..7.0f64, r in ray(), to in vector(1.0)
    ) {
        // The whole scene moved far away, or the object made tiny.
        let mut o = a;
        let place = Transform::translate(shift * 10f64.powf(e.max(0.0)));
        let scale = 10f64.powf(e.min(0.0));
        o.apply(&Transform::scale(Vec3::splat(scale)).then(&place));
        let flat = Flattened::new(&[Arc::new(o)], Accel::ByScene);
        let r = Ray::new(place.point(r.origin * scale), r.dir);
        let Some(found) = flat.geometry.nearest(&r, Range::FORWARD, RayClass::Image) else { return Ok(()) };
        let hit = flat.geometry.locate(&r, &found);
        let outward = if hit.normal.dot(r.dir) < 0.0 { hit.normal } else { return Ok(()) };
        let dir = to.normalize_or(outward);
        prop_assume!(dir.dot(outward) > 1e-3);
        let origin = hit.point + 2.0 * hit.error * outward;
        // Both solids are convex: outside, a ray away from the surface meets it no more.
        let again = flat.geometry.nearest(&Ray::new(origin, dir), Range::FORWARD, RayClass::Image);
        prop_assert!(again.is_none(), "again at {:?}, error {}", again, hit.error);
        prop_assert!(hit.error <= 1e-9 * (scale + place.forward.translation.length()));
    }
}

/// Tree, grid and list find the same, to the bit: nearest hits, what stands in the way of light, and what
/// contains a point.
#[test]
fn accelerators_agree() {
    let mut random = crate::math::bvh::tests::Random::new(21);
    let mut objects: Vec<Arc<Object>> = (0..300)
        .map(|i| {
            let size = 10f64.powf(-3.0 * random.unit());
            let c = random.vector(1.5);
            let ball = shape(Sphere::new(c, 0.2 * size));
            Arc::new(match i % 7 {
                0 => shape(Cuboid::new(c, c + random.vector(0.2))),
                1 => csg(CsgOp::Difference, &[&ball, &shape(Sphere::new(c + 0.1 * size, 0.2 * size))]),
                _ => ball,
            })
        })
        .collect();
    // Twice the same, and one around all.
    objects.push(objects[5].clone());
    objects.push(Arc::new(shape(Sphere::new(Vec3::ZERO, 1e4))));
    objects.push(Arc::new(shape(Plane::new(Vec3::Y, -1.0).expect("a plane"))));
    let made = [Accel::Bvh, Accel::Grid, Accel::None].map(|accel| Flattened::new(&objects, accel).geometry);
    let [bvh, grid, none] = &made;
    for i in 0..20_000 {
        let origin = if i % 5 == 0 { random.direction() * 1e7 } else { random.vector(2.0) };
        let toward = random.vector(1.5) - origin;
        let dir = if i % 4 == 0 { random.direction() } else { toward.normalize_or(Vec3::X) };
        let ray = Ray::new(origin, dir);
        let range = Range::new(0.0, if i % 3 == 0 { random.unit() * 3.0 } else { f64::INFINITY });
        let nearest = |g: &Geometry| g.nearest(&ray, range, RayClass::Image).map(|f| (f.t, f.leaf));
        let stopped = |g: &Geometry| matches!(g.obstacle(&ray, range, &mut NONE.clone()), Obstacle::Opaque);
        assert_eq!(nearest(grid), nearest(bvh), "{ray:?}");
        assert_eq!(nearest(none), nearest(bvh), "{ray:?}");
        assert_eq!((stopped(grid), stopped(none)), (stopped(bvh), stopped(bvh)), "{ray:?}");
        assert_eq!(grid.roots_at(origin), none.roots_at(origin));
        assert_eq!(bvh.roots_at(origin), none.roots_at(origin));
    }
}

#[test]
fn a_shared_face_of_a_merge_vanishes_and_an_outer_one_stays() {
    let left = shape(Cuboid::new(Vec3::ZERO, Vec3::ONE));
    let right = shape(Cuboid::new(Vec3::new(1.0, 0.0, 0.0), Vec3::new(2.0, 1.0, 1.0)));
    let query = ObjectQuery::new(&csg(CsgOp::Merge, &[&left, &right]));
    let (p, _) = query.trace(&Ray::new(Vec3::new(0.5, 0.5, 0.5), Vec3::X)).expect("the far side");
    assert_eq!(p.x, 2.0);
    // Two boxes with a common front: it is the surface of both.
    let twin = shape(Cuboid::new(Vec3::new(0.5, 0.0, 0.0), Vec3::new(1.5, 1.0, 2.0)));
    let query = ObjectQuery::new(&csg(CsgOp::Merge, &[&left, &twin]));
    let (p, n) = query.trace(&Ray::new(Vec3::new(0.7, 0.5, -1.0), Vec3::Z)).expect("the front");
    assert_eq!((p.z, n), (0.0, -Vec3::Z));
}

#[test]
fn of_coincident_faces_the_later_child_shows() {
    let a = shape(Cuboid::new(Vec3::ZERO, Vec3::ONE));
    let b = shape(Cuboid::new(Vec3::new(0.25, 0.25, 0.0), Vec3::new(0.75, 0.75, 0.5)));
    let query = ObjectQuery::new(&csg(CsgOp::Difference, &[&a, &b]));
    let (p, n) = query.trace(&Ray::new(Vec3::new(0.5, 0.5, -1.0), Vec3::Z)).expect("the skin");
    assert_eq!((p.z, n), (0.0, Vec3::Z));
}

#[test]
fn a_union_falls_apart_and_flags_reach_its_children() {
    let mut union =
        csg(CsgOp::Union, &[&shape(Sphere::new(Vec3::ZERO, 1.0)), &shape(Sphere::new(Vec3::X, 1.0))]);
    union.flags.no_shadow = true;
    let plane = shape(Plane::new(Vec3::Y, -1.0).expect("a plane"));
    let flat = Flattened::new(&[Arc::new(union), Arc::new(plane)], Accel::ByScene);
    assert_eq!((flat.geometry.finite.len(), flat.geometry.infinite.len()), (2, 1));
    let down = Ray::new(Vec3::new(0.0, 5.0, 0.0), -Vec3::Y);
    assert_eq!(flat.geometry.nearest(&down, Range::FORWARD, RayClass::Image).map(|f| f.t), Some(4.0));
    assert_eq!(flat.geometry.nearest(&down, Range::FORWARD, RayClass::Shadow).map(|f| f.t), Some(6.0));
}

/// Planes are looked at without asking their shapes: the answers are the shapes' own.
#[test]
fn planes_are_met_where_their_shapes_say() {
    let planes = [(Vec3::Y, -1.0), (Vec3::Y, -1.0), (Vec3::new(1.0, 0.2, 0.0), -3.0), (Vec3::Z, 6.0)];
    let plane = |(n, d)| Arc::new(shape(Plane::new(n, d).expect("a plane")));
    let mut objects: Vec<Arc<Object>> = planes.into_iter().map(plane).collect();
    objects.push(Arc::new(inverse(&objects[3])));
    let flat = Flattened::new(&objects, Accel::ByScene);
    let g = &flat.geometry;
    assert_eq!(g.planes.iter().flatten().count(), 5);
    let steps = [-2.0, -1.0, 0.0, 0.3];
    let mut hits = 0;
    for (i, x) in (0..4).flat_map(|i| steps.map(|x| (i, x))) {
        let from = Vec3::new(0.1, [-1.0, 0.0, 6.0, -4.0][i], 0.4 * x);
        for (y, z) in steps.into_iter().flat_map(|y| steps.map(|z| (y, z))) {
            let Some(way) = Vec3::new(x, y, z).try_normalize() else { continue };
            let (ray, range) = (Ray::new(from, way), Range::new(0.0, 20.0));
            let each = (0..5).filter_map(|leaf| g.nearest_of(Solid::Leaf(leaf), &ray, range));
            let nearest = each.min_by(|a, b| (a.t, a.leaf).partial_cmp(&(b.t, b.leaf)).expect("numbers"));
            let found = g.nearest(&ray, range, RayClass::Image);
            assert_eq!(found.map(|f| (f.t, f.leaf)), nearest.map(|f| (f.t, f.leaf)), "{ray:?}");
            let stopped = matches!(g.obstacle(&ray, range, &mut { NONE }), Obstacle::Opaque);
            assert_eq!(stopped, nearest.is_some(), "{ray:?}");
            hits += usize::from(stopped);
        }
    }
    assert!(hits > 100, "{hits}");
}

#[test]
fn of_coincident_objects_the_first_in_the_scene_shows() {
    let ball = |x: f64| shape(Sphere::new(Vec3::new(x, 0.0, 0.0), 1.0));
    let objects: Vec<Arc<Object>> =
        [9.0, 0.0, 0.0, 5.0, -7.0, 0.0].into_iter().map(|x| Arc::new(ball(x))).collect();
    let flat = Flattened::new(&objects, Accel::ByScene);
    let ray = Ray::new(Vec3::new(0.3, 0.2, -5.0), Vec3::Z);
    assert_eq!(flat.geometry.nearest(&ray, Range::FORWARD, RayClass::Image).map(|f| f.leaf), Some(1));
}

/// As in the reference: rays of the picture see a single shape whole, questions of the scene's text do not.
#[test]
fn bounds_cut_combinations_ray_by_ray_and_leave_other_shapes() {
    let bound = Arc::new(shape(Sphere::new(Vec3::ZERO, 0.5)));
    let mut ball = shape(Sphere::new(Vec3::ZERO, 1.0));
    ball.bounded_by.push(bound.clone());
    let mut union =
        csg(CsgOp::Union, &[&shape(Sphere::new(Vec3::ZERO, 1.0)), &shape(Sphere::new(Vec3::ZERO, 0.1))]);
    union.bounded_by.push(bound);
    // Meets the ball outside of the small sphere's box; meets the box but not the small sphere; meets both.
    for (x, in_union) in [(0.6, false), (0.48, false), (0.3, true)] {
        let ray = Ray::new(Vec3::new(x, 0.45 * x, -5.0), Vec3::Z);
        assert_eq!(ObjectQuery::new(&union).trace(&ray).is_some(), in_union, "{x}");
        assert_eq!(ObjectQuery::new(&ball).trace(&ray).is_some(), in_union, "{x}");
        let flat = Flattened::new(&[Arc::new(ball.clone())], Accel::ByScene);
        assert!(flat.geometry.nearest(&ray, Range::FORWARD, RayClass::Image).is_some(), "{x}");
    }
}

/// A box stands in the hollow of another, face on face: rays that leave the inner one along or away from the
/// shared face see the frame around it.
#[test]
fn a_ray_that_starts_on_a_shared_face_sees_the_frame() {
    let cut = |x: f64, y: f64, z: f64| {
        let reach = Vec3::new(x, y, z);
        shape(Cuboid::new(-reach, reach))
    };
    let frame = csg(
        CsgOp::Difference,
        &[&cut(0.5, 0.5, 0.5), &cut(0.45, 0.45, 1.0), &cut(1.0, 0.45, 0.45), &cut(0.45, 1.0, 0.45)],
    );
    let flat = Flattened::new(&[Arc::new(frame)], Accel::ByScene);
    let start = Vec3::new(0.1, 0.2, -0.45 - 1e-16);
    for direction in [Vec3::new(1.0, 0.0, -0.01), Vec3::new(1.0, 0.0, -0.001), Vec3::new(1.0, 0.0, -0.1)] {
        let ray = Ray::new(start, direction.normalize());
        let found = flat.geometry.nearest(&ray, Range::FORWARD, RayClass::Image);
        assert!((found.expect("the frame").t - 0.35).abs() < 0.01, "{direction}");
    }
}

#[test]
fn bounds_of_what_is_taken_away_do_not_bound_the_rest() {
    let mut hole = csg(
        CsgOp::Intersection,
        &[&shape(Sphere::new(Vec3::ZERO, 1.0)), &shape(Cuboid::new(Vec3::splat(-2.0), Vec3::splat(2.0)))],
    );
    hole.bounded_by.push(Arc::new(shape(Cuboid::new(Vec3::splat(-1.1), Vec3::splat(1.1)))));
    let bar = shape(Cuboid::new(Vec3::new(-0.5, -4.0, -0.5), Vec3::new(0.5, 4.0, 0.5)));
    let rest = ObjectQuery::new(&csg(CsgOp::Difference, &[&bar, &hole]));
    let down = |y: f64| Ray::new(Vec3::new(0.0, y, -5.0), Vec3::Z);
    assert!(rest.trace(&down(-3.0)).is_some(), "beyond the hole's bounds");
    assert!(rest.trace(&down(0.0)).is_none(), "in the hole");
}
