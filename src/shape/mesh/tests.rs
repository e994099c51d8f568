use super::*;
use crate::shape::nearest_of;

/// A regular octahedron's eight faces, all corners in one list.
fn octahedron(inside_vector: Option<Vec3>) -> Mesh {
    let vertices = vec![
        [1.0, 0.0, 0.0],
        [-1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, -1.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.0, 0.0, -1.0],
    ];
    let faces = (0..8).map(|i| [i & 1, 2 + (i >> 1 & 1), 4 + (i >> 2)]).collect();
    MeshBuilder { vertices, faces, inside_vector, kind: "mesh", ..Default::default() }.build()
}

#[test]
fn rays_through_edges_and_corners_do_not_leak() {
    let mesh = octahedron(None);
    let mut random = crate::shape::conformance::Random::new(5);
    let vertices = [Vec3::X, Vec3::NEG_X, Vec3::Y, Vec3::NEG_Y, Vec3::Z, Vec3::NEG_Z];
    for i in 0..5000 {
        let (a, b) = (vertices[i % 6], vertices[(i / 6) % 6]);
        let on = if a == -b { a } else { a + (b - a) * random.unit() };
        let inside = 0.3 * random.direction();
        for origin in [inside, on + (on - inside) * 7.0] {
            let ray = Ray::new(origin, (on - origin).normalize());
            let hit = mesh.nearest(&ray, Range::FORWARD).expect("a hit");
            assert!((hit.t - on.distance(origin)).abs() < 1e-12, "{i} {hit:?}");
        }
    }
}

#[test]
fn inside_counts_shared_edges_once() {
    // The vector runs through edges and corners for many of these points.
    let mesh = octahedron(Some(Vec3::Z));
    for i in -9i32..10 {
        for j in -9i32..10 {
            let p = Vec3::new(f64::from(i) / 8.0, f64::from(j) / 8.0, 0.03);
            let inside = p.abs().element_sum() < 1.0;
            assert_eq!(mesh.contains(p), inside, "{p}");
        }
    }
    assert!(!octahedron(None).contains(Vec3::ZERO));
    assert!(!octahedron(None).is_solid());
}

#[test]
fn uv_and_textures_blend_by_weight() {
    let builder = MeshBuilder {
        vertices: vec![[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 4.0, 0.0]],
        faces: vec![[0, 1, 2]],
        uvs: vec![[0.25, 0.5], [0.75, 0.5], [0.25, 1.0]],
        textures: vec![[3, 7, NO_TEXTURE]],
        kind: "mesh2",
        ..Default::default()
    };
    let mesh = builder.build();
    let ray = Ray::new(Vec3::new(0.5, 2.0, -3.0), Vec3::Z);
    let c = mesh.nearest(&ray, Range::FORWARD).unwrap();
    assert_eq!(mesh.uv(Vec3::ZERO, &c), Some(Vec2::new(0.375, 0.75)));
    let PartTexture::Blend(parts) = mesh.part_texture(Vec3::ZERO, &c) else { panic!("no blend") };
    assert_eq!(&parts[..], &[(Some(3), 0.25), (Some(7), 0.25), (None, 0.5)]);
    assert_eq!(mesh.normal(Vec3::ZERO, &c), Vec3::NEG_Z);
}

#[test]
fn faces_without_area_are_left_out() {
    let builder = MeshBuilder {
        vertices: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        faces: vec![[0, 1, 2], [0, 1, 3]],
        kind: "mesh2",
        ..Default::default()
    };
    assert_eq!(builder.build().faces().face_count(), 1);
    assert_eq!(MeshBuilder::default().build().bounds(), Aabb::EMPTY);
}

#[test]
fn nearest_agrees_with_all_faces() {
    let mut random = crate::shape::conformance::Random::new(11);
    let cell = Aabb::new(Vec3::splat(-1.0), Vec3::splat(1.0));
    let mut builder = MeshBuilder { kind: "mesh2", ..Default::default() };
    for i in 0..500 {
        let at = random.in_box(&cell);
        for _ in 0..3 {
            builder.vertices.push((at + 0.2 * random.direction()).as_vec3().to_array());
        }
        builder.faces.push([3 * i, 3 * i + 1, 3 * i + 2]);
    }
    let mesh = builder.build();
    for _ in 0..2000 {
        let ray = Ray::new(2.0 * random.direction(), random.direction());
        let shear = Shear::new(ray.dir);
        let pass = |face: usize| {
            let [a, b, c] = mesh.faces().corners(face).map(|p| p - ray.origin);
            let weights = shear.weights([a, b, c])?;
            Some((plane_distance(a, b, c, ray.dir)?, weights))
        };
        let all = (0..mesh.faces().face_count()).filter_map(pass);
        let all: Vec<Crossing> = all.filter(|h| h.0 > 0.0).map(|h| Mesh::crossing(0, h)).collect();
        let mut found = Vec::new();
        mesh.crossings(&ray, Range::FORWARD, &mut found);
        assert_eq!(found.len(), all.len());
        let t = |c: Option<Crossing>| c.map(|c| c.t);
        assert_eq!(t(mesh.nearest(&ray, Range::FORWARD)), t(nearest_of(&all)));
    }
}
