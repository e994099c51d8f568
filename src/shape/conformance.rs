//! What every shape promises, checked on every sibling: in its own space, and rotated, unequally scaled
//! and moved. Parameters are neither 0 nor 1.

use super::*;
use crate::math::Transform;

/// A shape with what can be asked of it.
struct Subject {
    shape: Arc<dyn Shape>,
    /// Every crossing goes from inside to outside or back.
    flips: bool,
    /// The normal points from inside to outside.
    outward: bool,
    /// How exact the shape's own points are where that is the scene's choice, else 0.
    accuracy: f64,
}

fn solid(shape: impl Shape + 'static) -> Subject {
    Subject { shape: Arc::new(shape), flips: true, outward: true, accuracy: 0.0 }
}

fn surface(shape: impl Shape + 'static) -> Subject {
    Subject { shape: Arc::new(shape), flips: false, outward: false, accuracy: 0.0 }
}

/// A closed quartic without symmetry: x⁴ + y⁴ + z⁴ + x y² - z x² + … = 2.
fn algebraic() -> Algebraic {
    let mut c = vec![0.0; Algebraic::count(4)];
    let terms =
        [(4, 0, 0, 1.0), (0, 4, 0, 1.2), (0, 0, 4, 0.8), (1, 2, 0, 0.5), (2, 0, 1, -0.4), (0, 0, 0, -2.0)];
    for (i, j, k, value) in terms {
        c[Algebraic::position(4, i, j, k)] = value;
    }
    Algebraic::new(4, c).unwrap()
}

fn subjects() -> Vec<Subject> {
    let v = Vec3::new;
    vec![
        solid(Sphere::new(v(0.3, -0.7, 1.1), 1.7)),
        solid(Cuboid::new(v(-0.4, 0.2, -1.3), v(1.9, 1.4, 0.6))),
        solid(Plane::new(v(1.0, 2.0, -0.5), 0.7).unwrap()),
        solid(Cylinder::new(v(0.2, -0.9, 0.1), v(0.7, 1.6, 0.4), 0.65, false).unwrap()),
        surface(Cylinder::new(v(0.2, -0.9, 0.1), v(0.7, 1.6, 0.4), 0.65, true).unwrap()),
        solid(Cone::new(v(0.2, -0.9, 0.1), 1.3, v(0.7, 1.6, 0.4), 0.35, false).unwrap()),
        solid(Cone::new(v(0.2, -0.9, 0.1), 0.0, v(0.7, 1.6, 0.4), 0.85, false).unwrap()),
        solid(Cone::new(v(0.2, -0.9, 0.1), 0.6, v(0.7, 1.6, 0.4), -0.45, false).unwrap()),
        solid(Torus::new(1.4, 0.45)),
        solid(Quadric::new(v(0.6, 1.1, 0.4), v(0.2, -0.1, 0.3), v(0.3, -0.2, 0.1), -1.3)),
        solid(Quadric::new(v(1.1, -0.7, 0.9), v(0.1, 0.0, 0.2), v(0.1, -0.2, 0.1), -0.6)),
        solid(algebraic()),
        Subject { outward: false, ..solid(closed_mesh()) },
        solid(isosurface()),
        surface(Torus::new(0.5, 0.8)),
        Subject { outward: false, ..solid(prism(CurveKind::Cubic, Sweep::Linear)) },
        Subject { outward: false, ..solid(prism(CurveKind::Linear, Sweep::Conic)) },
        Subject { outward: false, ..solid(ring()) },
        solid(Sor::new(&vase(), false).unwrap()),
        surface(Sor::new(&vase(), true).unwrap()),
        solid(Superellipsoid::new(0.4, 1.3).unwrap()),
        solid(Superellipsoid::new(2.6, 1.7).unwrap()),
        solid(Ovus::new(1.1, 0.6)),
        solid(Ovus::new(0.7, 1.2)),
        solid(Ovus::new(0.3, 1.2)),
        solid(SphereSweep::new(SweepKind::Linear, &beads()[..3])),
        solid(SphereSweep::new(SweepKind::Cubic, &beads())),
        solid(SphereSweep::new(SweepKind::BSpline, &beads())),
        solid(drops()),
        solid(Quadric::new(v(1.3, 0.6, 2.1), v(0.2, -0.3, 0.1), v(0.4, 0.1, -0.2), -1.2)),
        solid(Quadric::new(v(1.0, -0.5, 1.3), v(0.1, 0.0, 0.2), v(0.0, 0.1, 0.0), -0.5)),
        solid(tangle()),
        Subject { outward: false, accuracy: 2e-7, ..solid(fractal()) },
        Subject { accuracy: 0.03, ..surface(egg()) },
        surface(patch()),
        surface(hills()),
        surface(Disc::new(v(0.1, 0.4, -0.3), v(0.3, 1.0, -0.4), 1.6, 0.35).unwrap()),
        surface(Triangle::new(v(-1.2, -0.8, 0.2), v(1.3, -0.6, -0.4), v(0.2, 1.5, 0.7)).unwrap()),
        surface(
            SmoothTriangle::new(
                [v(-1.2, -0.8, 0.2), v(1.3, -0.6, -0.4), v(0.2, 1.5, 0.7)],
                [v(-0.4, -0.2, -1.0), v(0.5, 0.1, -1.2), v(0.1, 0.6, -0.9)],
            )
            .unwrap(),
        ),
        surface(
            Polygon::new(&[
                v(-1.1, -0.9, 0.5),
                v(1.4, -1.2, 0.5),
                v(0.2, 0.1, 0.5),
                v(0.9, 1.3, 0.5),
                v(-0.8, 1.1, 0.5),
                v(-1.1, -0.9, 0.5),
            ])
            .unwrap(),
        ),
    ]
}

/// A dented ball: few iterations make no thin parts, which steps along the ray would miss.
fn fractal() -> Julia {
    let c = [-0.12, 0.1, 0.07, -0.03];
    let slice_normal = [0.1, -0.2, 0.15, 1.0];
    Julia::new(&JuliaSettings { c, iterations: 4, precision: 60.0, slice_normal, ..Default::default() })
        .unwrap()
}

/// A part of an egg's shell, given by functions of two parameters.
fn egg() -> Parametric {
    #[derive(Debug)]
    struct Egg(usize);
    impl crate::math::field::Field for Egg {
        fn value(&self, p: Vec3) -> f64 {
            let (u, v) = (p.x, p.y);
            [0.6 * u.cos() * v.cos(), 0.9 * v.sin(), 0.5 * u.sin() * v.cos() + 0.1 * v][self.0]
        }
    }
    let functions = [0, 1, 2].map(|i| Arc::new(Egg(i)) as Arc<dyn crate::math::field::Field>);
    let mut egg = Parametric::new(functions, Vec2::new(0.3, -0.7), Vec2::new(2.1, 0.6));
    egg.accuracy = 0.03;
    egg.container = Container::cuboid(Vec3::new(-0.5, -0.8, -0.1), Vec3::new(0.7, 0.7, 0.7));
    egg
}

/// A ball with dents, cut off by its container.
fn isosurface() -> Isosurface {
    #[derive(Debug)]
    struct Dented;
    impl crate::math::field::Field for Dented {
        fn value(&self, p: Vec3) -> f64 {
            p.length() - 1.3 + 0.1 * (3.0 * p.x).sin() * (4.0 * p.y).cos()
        }
    }
    let mut surface = Isosurface::new(Arc::new(Dented));
    surface.container = Container::cuboid(Vec3::new(-1.1, -1.6, -1.7), Vec3::new(1.5, 1.8, 1.4));
    surface.max_gradient = 1.6;
    surface.accuracy = 1e-13;
    surface.max_trace = 10;
    surface
}

/// An irregular octahedron with an inside.
fn closed_mesh() -> Mesh {
    let vertices = vec![
        [1.7, 0.1, -0.2],
        [-1.3, 0.3, 0.1],
        [0.2, 1.4, -0.3],
        [-0.1, -0.9, 0.4],
        [0.3, 0.2, 1.9],
        [-0.2, 0.1, -1.2],
    ];
    let faces = (0..8).map(|i| [i & 1, 2 + (i >> 1 & 1), 4 + (i >> 2)]).collect();
    let inside_vector = Some(Vec3::new(0.1, 0.2, 1.0));
    MeshBuilder { vertices, faces, inside_vector, kind: "mesh", ..Default::default() }.build()
}

fn prism(kind: CurveKind, sweep: Sweep) -> Prism {
    let points = [[1.2, -0.9], [-1.1, -1.3], [-0.8, 1.2], [1.3, 0.7], [1.2, -0.9], [-1.1, -1.3], [-0.8, 1.2]];
    let points = points.map(Vec2::from_array);
    let used = if kind == CurveKind::Linear { &points[..5] } else { &points[..] };
    let (pieces, _) = closed_curves(kind, used).unwrap();
    Prism::new(pieces, [0.35, 1.4], sweep, false)
}

/// A lathe whose profile is closed.
fn ring() -> Lathe {
    let points = [[0.6, -0.8], [1.5, -0.4], [1.2, 0.9], [0.4, 0.6], [0.6, -0.8]].map(Vec2::from_array);
    Lathe::new(open_curve(CurveKind::Linear, &points))
}

fn vase() -> [Vec2; 6] {
    [[0.1, -1.3], [0.6, -1.1], [0.9, -0.3], [0.4, 0.4], [0.7, 1.1], [0.3, 1.5]].map(Vec2::from_array)
}

fn beads() -> [(Vec3, f64); 5] {
    let v = Vec3::new;
    [
        (v(-1.4, -0.5, 0.1), 0.35),
        (v(-0.6, 0.4, -0.2), 0.3),
        (v(0.2, -0.3, 0.4), 0.55),
        (v(0.9, 0.6, -0.1), 0.25),
        (v(1.5, 0.1, 0.3), 0.4),
    ]
}

fn drops() -> Blob {
    let v = Vec3::new;
    let squeezed = Transform::scale(v(0.7, 1.4, 0.9)).then(&Transform::rotate(v(0.0, 20.0, 35.0)));
    let components = vec![
        BlobComponent::sphere(v(0.5, 0.1, 0.0), 1.1, 1.3).unwrap(),
        BlobComponent::cylinder(v(-0.9, 0.3, 0.2), v(0.4, -0.7, 0.3), 0.7, 0.9).unwrap(),
        BlobComponent::sphere(v(-0.2, 0.6, -0.3), 0.8, 1.2).unwrap().transformed(&squeezed),
        BlobComponent::sphere(v(0.3, 0.1, -0.6), 0.6, -0.8).unwrap(),
    ];
    Blob::new(components, 0.45)
}

fn patch() -> BicubicPatch {
    let heights =
        [[0.2, 0.6, -0.4, 0.1], [0.5, 1.2, 0.3, -0.3], [-0.2, 0.4, 1.0, 0.3], [0.0, -0.5, 0.2, 0.4]];
    let at = |i: usize, j: usize| Vec3::new(j as f64 - 1.5, heights[i][j], i as f64 - 1.4);
    let controls = std::array::from_fn(|i| std::array::from_fn(|j| at(i, j)));
    let detail = PatchDetail { u_steps: 3, v_steps: 2, flatness: 0.01 };
    BicubicPatch::new(controls, detail, [Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y]).unwrap()
}

fn hills() -> HeightField {
    let height = |i: usize, j: usize| 32000.0 + 20000.0 * (i as f64 * 0.7).sin() * (j as f64 * 0.4).cos();
    let samples = (0..13).flat_map(|j| (0..9).map(move |i| height(i, j) as u16)).collect();
    HeightField::new(9, 13, samples, true, 0.0).unwrap()
}

/// x⁴ + y⁴ + z⁴ - 2 (x² + y² + z²) + 0.3 xy + 1.4 = 0
fn tangle() -> Algebraic {
    let mut c = vec![0.0; Algebraic::count(4)];
    let terms = [
        (4, 0, 0, 1.0),
        (0, 4, 0, 1.0),
        (0, 0, 4, 1.0),
        (2, 0, 0, -2.0),
        (0, 2, 0, -2.0),
        (0, 0, 2, -2.0),
        (1, 1, 0, 0.3),
        (0, 0, 0, 1.4),
    ];
    for (i, j, k, v) in terms {
        c[Algebraic::position(4, i, j, k)] = v;
    }
    Algebraic::new(4, c).unwrap()
}

fn placements() -> [Transform; 2] {
    let moved = Transform::rotate(Vec3::new(17.0, 40.0, -63.0))
        .then(&Transform::scale(Vec3::new(1.7, 0.4, 2.3)))
        .then(&Transform::rotate(Vec3::new(-25.0, 110.0, 5.0)))
        .then(&Transform::translate(Vec3::new(3.5, -2.25, 7.75)));
    [Transform::IDENTITY, moved]
}

/// Marsaglia's xorshift; the same numbers in every run.
pub(super) struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(0x9E37_79B9_7F4A_7C15 ^ seed << 20)
    }

    pub fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn in_box(&mut self, b: &Aabb) -> Vec3 {
        b.min + b.size() * Vec3::new(self.unit(), self.unit(), self.unit())
    }

    pub fn direction(&mut self) -> Vec3 {
        loop {
            let v = self.in_box(&Aabb::new(Vec3::NEG_ONE, Vec3::ONE));
            if v.length() > 0.1 && v.length() <= 1.0 {
                return v.normalize();
            }
        }
    }
}

/// The part of the shape's bounds that rays are aimed at.
fn stage(shape: &dyn Shape) -> Aabb {
    shape.bounds().intersection(Aabb::new(Vec3::splat(-4.0), Vec3::splat(4.0)))
}

fn rays(shape: &dyn Shape, random: &mut Random) -> Vec<Ray> {
    let stage = stage(shape);
    let size = stage.size().max_element();
    (0..300)
        .map(|i| {
            let target = random.in_box(&stage);
            let away = random.direction();
            let distance = [0.0, 2.0, 5.0, 300.0][i % 4] * size;
            Ray::new(target + distance * away, if distance > 0.0 { -away } else { away })
        })
        .collect()
}

/// Runs `check` on rays in the shape's own space that come from rays in the space outside.
fn on_every_ray(mut check: impl FnMut(&Subject, &Ray, &mut Vec<Crossing>)) {
    for subject in subjects() {
        let shape = &*subject.shape;
        let mut random = Random::new(1);
        for place in placements() {
            for local in rays(shape, &mut random) {
                let world = Ray::new(place.point(local.origin), place.vector(local.dir).normalize());
                let (ray, _) = place.inverse_ray(&world);
                let mut found = Vec::new();
                shape.crossings(&ray, Range::FORWARD, &mut found);
                found.sort_by(|a, b| a.t.total_cmp(&b.t));
                check(&subject, &ray, &mut found);
            }
        }
    }
}

#[test]
fn every_shape_is_hit() {
    let mut hits = std::collections::BTreeMap::new();
    on_every_ray(|s, _, found| {
        // Told apart by where they are: the same kind comes more than once.
        let place = Arc::as_ptr(&s.shape).cast::<()>();
        hits.entry(place).or_insert((s.shape.clone(), 0)).1 += found.len();
    });
    for (shape, count) in hits.into_values() {
        assert!(count > 100, "{count} crossings of {shape:?}");
    }
}

#[test]
fn crossings_lie_in_range_and_bounds() {
    on_every_ray(|s, ray, found| {
        let bounds = s.shape.bounds();
        for c in found {
            assert!(c.t > 0.0 && c.t.is_finite());
            let (p, error) = s.shape.locate(ray, c);
            let size = 1.0 + p.abs().max_element() + c.t;
            assert!(bounds.grown(error).contains(p), "{p} outside {bounds:?} of {:?}", s.shape);
            assert!(error > 0.0 && error < 1e-10 * size + 1.01 * s.accuracy, "{error} {:?}", s.shape);
            assert!(p.distance(ray.at(c.t)) < 1e-6 * size, "{} {:?}", p.distance(ray.at(c.t)), s.shape);
        }
    });
}

#[test]
fn a_range_cuts_the_crossings() {
    on_every_ray(|s, ray, found| {
        if found.len() < 2 || found[1].t - found[0].t < 1e-6 {
            return;
        }
        let middle = 0.5 * (found[0].t + found[1].t);
        let first = s.shape.nearest(ray, Range::new(middle, f64::INFINITY)).unwrap();
        assert!((first.t - found[1].t).abs() < 1e-9 * (1.0 + first.t), "{:?}", s.shape);
        let first = s.shape.nearest(ray, Range::new(0.0, middle)).unwrap();
        assert!((first.t - found[0].t).abs() < 1e-9 * (1.0 + first.t), "{:?}", s.shape);
    });
}

#[test]
fn nearest_is_the_smallest_crossing() {
    on_every_ray(|s, ray, found| {
        let nearest = s.shape.nearest(ray, Range::FORWARD);
        assert_eq!(nearest.map(|c| c.t), found.first().map(|c| c.t), "{:?}", s.shape);
    });
}

#[test]
fn crossings_flip_the_inside() {
    on_every_ray(|s, ray, found| {
        if !s.flips {
            return;
        }
        let mut stops = vec![0.0];
        stops.extend(found.iter().map(|c| c.t));
        stops.push(stops[stops.len() - 1] + 1.0);
        for w in stops.windows(3) {
            if w[1] - w[0] < 1e-6 || w[2] - w[1] < 1e-6 {
                continue;
            }
            let before = s.shape.contains(ray.at(0.5 * (w[0] + w[1])));
            let after = s.shape.contains(ray.at(0.5 * (w[1] + w[2])));
            assert!(before != after, "{ray:?} {stops:?} {:?}", s.shape);
        }
    });
}

#[test]
fn normals_are_unit_vectors_and_point_outward() {
    let (mut wrong, mut all) = (0, 0);
    on_every_ray(|s, ray, found| {
        for c in found {
            let (p, _) = s.shape.locate(ray, c);
            let n = s.shape.normal(p, c);
            assert!((n.length() - 1.0).abs() < 1e-12, "{n} {:?}", s.shape);
            if s.outward {
                let h = 1e-6 * stage(&*s.shape).size().max_element();
                all += 1;
                wrong += usize::from(!s.shape.contains(p - h * n) || s.shape.contains(p + h * n));
            }
        }
    });
    // Within `h` of an edge the step along the normal may leave the solid on another side.
    assert!(wrong * 1000 < all, "{wrong} of {all}");
}

#[test]
fn a_ray_that_leaves_does_not_meet_its_own_start() {
    let mut random = Random::new(77);
    on_every_ray(|s, ray, found| {
        for c in found.iter() {
            let (p, error) = s.shape.locate(ray, c);
            let n = s.shape.face_normal(p, c).unwrap_or_else(|| s.shape.normal(p, c));
            let d = random.direction();
            let side = n.dot(d).signum();
            let leaving = Ray::new(p + side * error * n, d);
            if n.dot(d).abs() < 1e-3 {
                continue;
            }
            let next = s.shape.nearest(&leaving, Range::FORWARD);
            assert!(next.is_none_or(|x| x.t > 1e-7), "{next:?} {leaving:?} {:?}", s.shape);
        }
    });
}

#[test]
fn moving_the_start_along_the_ray_changes_nothing_else() {
    on_every_ray(|s, ray, found| {
        let Some(first) = found.first() else { return };
        let back = 1.75 * stage(&*s.shape).size().max_element();
        let moved = Ray::new(ray.at(-back), ray.dir);
        let range = Range::new(back, f64::INFINITY);
        let mut again = Vec::new();
        s.shape.crossings(&moved, range, &mut again);
        let near = 1e-5 + 5.0 * s.accuracy;
        if found.windows(2).any(|w| w[1].t - w[0].t < near) || first.t < near {
            return;
        }
        again.sort_by(|a, b| a.t.total_cmp(&b.t));
        assert_eq!(again.len(), found.len(), "{:?}", s.shape);
        for (a, f) in again.iter().zip(found.iter()) {
            assert!((a.t - back - f.t).abs() < 1e-8 * (1.0 + f.t) + s.accuracy, "{a:?} {f:?} {:?}", s.shape);
        }
    });
}
