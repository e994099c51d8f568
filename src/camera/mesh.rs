//! The faces of meshes as a camera: a ray leaves from each face along its normal.
//!
//! | parameter | unit | default | meaning |
//! |---|---|---|---|
//! | rays per pixel | | | whose mean is the pixel; 1 for `Strips` and `Uv` |
//! | distribution | | | which faces a pixel sees from |
//! | max_distance | length | none | what a ray from a face meets beyond it is not seen |
//! | smooth | | off | `Uv` alone: along the interpolated normal |
//!
//! | distribution | faces of pixel (X, Y), number i = Y W + X |
//! |---|---|
//! | 0 | face i of mesh k, for ray k |
//! | 1 | face i + k n of all meshes one after another, n in total; so only ray 0 has one |
//! | 2 | the picture is cut into upright strips, one per mesh |
//! | 3 | the first face of the first mesh whose surface parameters contain the pixel's place; baking |
//!
//! Where a pixel has no face it sees nothing. The camera's `location.z` moves the start along the normal; a
//! negative `direction.z` turns the ray round. The mesh's own transformation acts, the camera's does not.

use crate::math::bvh::{Bvh, Quality};
use crate::math::{Aabb, Ray, Transform, Vec2, Vec3};
use crate::shape::Mesh;
use crate::shape::mesh::MeshFaces;

/// Which faces a pixel sees from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Distribution {
    /// 0: one mesh for each ray.
    Parallel,
    /// 1: the meshes one after another.
    Serial,
    /// 2: one upright strip of the picture for each mesh.
    Strips,
    /// 3: by surface parameters.
    Uv { smooth: bool },
}

/// Meshes made ready to look from.
#[derive(Clone, Debug)]
pub struct MeshCamera {
    pub rays_per_pixel: usize,
    pub distribution: Distribution,
    /// Infinite for none.
    pub max_distance: f64,
    meshes: Vec<Faces>,
}

/// A mesh's faces in the order in which the scene lists them.
#[derive(Clone, Debug)]
struct Faces {
    transform: Transform,
    /// `None` for a face without area.
    faces: Vec<Option<Face>>,
    /// Finds faces by surface parameters; for `Uv` alone.
    by_uv: Option<Bvh>,
}

#[derive(Clone, Copy, Debug)]
struct Face {
    corners: [Vec3; 3],
    normals: [Vec3; 3],
    flat: Vec3,
    uvs: [Vec2; 3],
}

impl MeshCamera {
    /// The number of rays may not exceed what the distribution has use for: see the parser.
    pub fn new(distribution: Distribution, rays_per_pixel: usize) -> Self {
        Self { rays_per_pixel, distribution, max_distance: f64::INFINITY, meshes: Vec::new() }
    }

    pub fn mesh_count(&self) -> usize {
        self.meshes.len()
    }

    /// Adds a mesh that stands at `transform`.
    pub fn add(&mut self, mesh: &Mesh, transform: Transform) {
        let mesh = mesh.faces();
        let faces: Vec<_> = mesh.in_order().into_iter().map(|place| Some(Face::new(mesh, place?))).collect();
        let by_uv = matches!(self.distribution, Distribution::Uv { .. }).then(|| uv_tree(&faces));
        self.meshes.push(Faces { transform, faces, by_uv });
    }

    /// Ray number `k` through (x, y) of a picture of `size` pixels; y runs down.
    pub(super) fn ray(
        &self,
        k: usize,
        (x, y): (f64, f64),
        size: (f64, f64),
        (shift, turned): (f64, bool),
    ) -> Option<Ray> {
        // Rows are counted half a pixel late: the first two see from the same faces.
        let (x, y) = (x.min(size.0 - 1.0).max(0.0), (y - 1.0).max(0.0));
        let (column, row, width) = (x as usize, y as usize, size.0 as usize);
        let number = row * width + column;
        let (mesh, start, along) = match self.distribution {
            Distribution::Parallel => self.flat(k, number)?,
            Distribution::Serial => self.serial(number, k)?,
            Distribution::Strips => {
                let strip = (size.0 / self.meshes.len() as f64).max(1.0);
                let mesh = (x / strip) as usize;
                self.flat(mesh, row * strip as usize + column)?
            }
            Distribution::Uv { smooth } => {
                self.at_uv(Vec2::new((x - 0.5) / size.0, 1.0 - (y + 0.5) / size.1), smooth)?
            }
        };
        let transform = &self.meshes[mesh].transform;
        let origin = transform.point(start + shift * along);
        let dir = transform.normal(along);
        dir.is_finite().then(|| Ray::new(origin, if turned { -dir } else { dir }))
    }

    /// A face's centre and normal.
    fn flat(&self, mesh: usize, face: usize) -> Option<(usize, Vec3, Vec3)> {
        let face = self.meshes.get(mesh)?.faces.get(face)?.as_ref()?;
        Some((mesh, (face.corners[0] + face.corners[1] + face.corners[2]) / 3.0, face.flat))
    }

    fn serial(&self, mut number: usize, k: usize) -> Option<(usize, Vec3, Vec3)> {
        if k > 0 {
            return None;
        }
        for (mesh, faces) in self.meshes.iter().enumerate() {
            if number < faces.faces.len() {
                return self.flat(mesh, number);
            }
            number -= faces.faces.len();
        }
        None
    }

    fn at_uv(&self, uv: Vec2, smooth: bool) -> Option<(usize, Vec3, Vec3)> {
        self.meshes.iter().enumerate().find_map(|(mesh, faces)| {
            let (face, w) = faces.at_uv(uv)?;
            let mean = |v: &[Vec3; 3]| w.x * v[0] + w.y * v[1] + w.z * v[2];
            let along = if smooth { mean(&face.normals).try_normalize() } else { None };
            Some((mesh, mean(&face.corners), along.unwrap_or(face.flat)))
        })
    }
}

impl Faces {
    /// The first face whose parameters contain `uv`, and its corners' weights.
    fn at_uv(&self, uv: Vec2) -> Option<(Face, Vec3)> {
        let mut first: Option<(u32, Face, Vec3)> = None;
        self.by_uv.as_ref()?.any_at(uv.extend(0.0), |i| {
            if first.as_ref().is_none_or(|f| i < f.0)
                && let Some(face) = self.faces[i as usize]
                && let Some(weights) = face.weights(uv)
            {
                first = Some((i, face, weights));
            }
            false
        });
        first.map(|(_, face, weights)| (face, weights))
    }
}

impl Face {
    fn new(mesh: &MeshFaces, place: usize) -> Self {
        let corners = mesh.corners(place);
        let flat = mesh.flat_normal(place);
        let normals = mesh.corner_normals(place).unwrap_or([flat; 3]);
        Self { corners, normals, flat, uvs: mesh.corner_uvs(place).unwrap_or_default() }
    }

    /// The corners' weights at `uv`, edges included.
    fn weights(&self, uv: Vec2) -> Option<Vec3> {
        let [a, b, c] = self.uvs.map(|p| p - uv);
        let w = Vec3::new(b.perp_dot(c), c.perp_dot(a), a.perp_dot(b));
        let outside = w.cmplt(Vec3::ZERO).any() && w.cmpgt(Vec3::ZERO).any();
        let sum = w.element_sum();
        (!outside && sum != 0.0).then(|| w / sum)
    }
}

/// Faces' boxes in the plane of the surface parameters.
fn uv_tree(faces: &[Option<Face>]) -> Bvh {
    let boxes: Vec<Aabb> = faces
        .iter()
        .map(|f| f.as_ref().map_or(Aabb::EMPTY, |f| Aabb::from_points(f.uvs.map(|p| p.extend(0.0)))))
        .collect();
    Bvh::build(&boxes, Quality::Fast { leaf: 2 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::MeshBuilder;

    /// A sheet of 3 x 2 squares, of each of which one half is there.
    fn sheet() -> Mesh {
        let mut builder = MeshBuilder { kind: "mesh2", ..Default::default() };
        for j in 0..3 {
            for i in 0..4 {
                builder.vertices.push([i as f32, j as f32, 0.0]);
                builder.uvs.push([i as f32 / 3.0, j as f32 / 2.0]);
            }
        }
        for j in 0..2 {
            for i in 0..3 {
                let a = 4 * j + i;
                builder.faces.push([a, a + 1, a + 4]);
            }
        }
        builder.build()
    }

    fn camera(distribution: Distribution) -> MeshCamera {
        let mut camera = MeshCamera::new(distribution, 1);
        camera.add(&sheet(), Transform::IDENTITY);
        camera.add(&sheet(), Transform::translate(10.0 * Vec3::Y));
        camera
    }

    #[test]
    fn pixels_see_from_faces_and_the_first_rows_alike() {
        let camera = camera(Distribution::Parallel);
        for (row, column) in [(0, 0), (1, 0), (0, 2), (1, 2)] {
            let place = (f64::from(column) + 0.5, f64::from(row) + 0.5);
            let ray = camera.ray(0, place, (3.0, 2.0), (0.25, true)).unwrap();
            let third = 1.0 / 3.0;
            let expected = Vec3::new(f64::from(column.min(2)) + third, third, -0.25);
            assert!(ray.origin.distance(expected) < 1e-12, "{ray:?}");
            assert!(ray.dir.distance(Vec3::Z) < 1e-12, "{ray:?}");
        }
        let second = camera.ray(1, (1.5, 2.5), (3.0, 2.0), (0.0, false)).unwrap();
        assert!((second.origin.y - 11.0 - 1.0 / 3.0).abs() < 1e-12);
        assert_eq!(camera.ray(2, (1.5, 2.5), (3.0, 2.0), (0.0, false)), None);
    }

    #[test]
    fn meshes_in_a_row_and_in_strips() {
        let serial = camera(Distribution::Serial);
        let ray = serial.ray(0, (1.5, 3.5), (3.0, 4.0), (0.0, false)).unwrap();
        assert!(ray.origin.y > 10.0);
        assert_eq!(serial.ray(1, (1.5, 0.5), (3.0, 4.0), (0.0, false)), None);
        let strips = camera(Distribution::Strips);
        // Faces of the second strip are counted from the picture's left edge.
        let ray = strips.ray(0, (3.5, 0.5), (6.0, 2.0), (0.0, false)).unwrap();
        assert!((ray.origin - Vec3::new(1.0 / 3.0, 11.0 + 1.0 / 3.0, 0.0)).length() < 1e-7, "{ray:?}");
    }

    #[test]
    fn surface_parameters_choose_the_face() {
        let camera = camera(Distribution::Uv { smooth: false });
        let ray = camera.ray(0, (10.6, 90.0), (100.0, 100.0), (0.0, false)).unwrap();
        assert!((ray.origin - Vec3::new(0.303, 2.0 * 0.105, 0.0)).length() < 1e-7, "{ray:?}");
        // The halves that are not there.
        assert_eq!(camera.ray(0, (31.5, 52.5), (100.0, 100.0), (0.0, false)), None);
    }
}
