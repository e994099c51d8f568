//! Triangle mesh: corners, normals and surface parameters in single precision, shared by index.
//!
//! | parameter | unit | default | meaning |
//! |---|---|---|---|
//! | vertices, faces | length | | three corners per face |
//! | normals | – | flat | per corner; where a face's three coincide it is flat |
//! | uvs | – | (0, 0) | per corner |
//! | textures | – | the object's | one per face, or one per corner, blended |
//! | inside_vector | – | none | makes the mesh a solid: a point is inside if a ray along the vector meets an odd number of faces |
//!
//! Numerical care: single precision corners are exact in double precision, in which everything is worked
//! out. Whether a ray passes a face is decided by the signs of edge functions that two faces evaluate
//! alike along a shared edge, so no ray slips between them; edges and corners belong to all their faces.
//! For `inside_vector` each edge belongs to just one of the two faces that a nudge of the ray would choose
//! between, so every crossing counts once.
//!
//! Faces are stored in the order of the tree's leaves. Memory per face: 37 bytes for its corners beside those of
//! its leaf, about 8 for the tree, 4 for the place in the scene's list, and 12 for each of normals and uvs that
//! has indices of its own, or for both where they go by the vertices' numbers.
//!
//! Reference: S. Woop, C. Benthin, I. Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013.

mod build;
mod leaves;

pub use build::{FLAT, Merged, MeshBuilder, NO_TEXTURE};

use leaves::{Leaves, Passage};

use super::triangle::Shear;
use super::{Crossing, PartTexture, Place, Shape, rounding};
use crate::math::bvh::{Bvh, Cut, CutTree};
use crate::math::{Aabb, Beam, EPSILON, Range, Ray, Vec2, Vec3};
use std::sync::LazyLock;

/// Numbers of a face's three corners in some list.
pub type Corners = [u32; 3];

/// A mesh as it was written; its tree is built when somebody first asks for a face.
#[derive(Debug)]
pub struct Mesh {
    faces: LazyLock<MeshFaces, Box<dyn FnOnce() -> MeshFaces + Send>>,
    is_solid: bool,
    kind: &'static str,
}

/// The faces of a mesh in the order of their tree's leaves.
#[derive(Debug)]
pub struct MeshFaces {
    /// Numbers of the faces' vertices, where normals or uvs go by them; else empty.
    vertex_numbers: Vec<Corners>,
    normals: Vec<[f32; 3]>,
    normal_corners: Indices,
    uvs: Vec<[f32; 2]>,
    uv_corners: Indices,
    textures: Textures,
    tree: Bvh,
    leaves: Leaves,
    /// Where in the scene's list each face stood.
    numbers: Vec<u32>,
    inside_vector: Option<Vec3>,
    kind: &'static str,
}

/// Which entries of a list a face uses.
#[derive(Clone, Debug)]
enum Indices {
    None,
    /// Those with the numbers of its vertices.
    Vertices,
    /// Its own; the first is [`FLAT`] where it uses none.
    Own(Vec<Corners>),
}

impl Indices {
    fn of(&self, face: usize, vertices: &[Corners]) -> Option<Corners> {
        match self {
            Indices::None => None,
            Indices::Vertices => Some(vertices[face]),
            Indices::Own(list) => Some(list[face]).filter(|c| c[0] != FLAT),
        }
    }

    fn heap_bytes(&self) -> usize {
        match self {
            Indices::Own(list) => list.capacity() * size_of::<Corners>(),
            _ => 0,
        }
    }
}

/// Texture numbers of faces; [`NO_TEXTURE`] is the object's.
#[derive(Clone, Debug)]
enum Textures {
    None,
    One(Vec<u32>),
    Three(Vec<Corners>),
}

fn wide(v: [f32; 3]) -> Vec3 {
    Vec3::new(f64::from(v[0]), f64::from(v[1]), f64::from(v[2]))
}

impl Mesh {
    pub fn faces(&self) -> &MeshFaces {
        &self.faces
    }

    fn crossing(face: u32, (t, shares): Passage) -> Crossing {
        let sum = shares.element_sum();
        Crossing { t, part: face, uv: Vec2::new(shares.y / sum, shares.z / sum) }
    }
}

impl Mesh {
    /// See [`Bvh::cut`].
    pub fn cut(&self, beam: &Beam, cut: &mut Cut) -> bool {
        self.faces().tree.cut(beam, cut)
    }

    /// [`Shape::nearest`] for a ray inside the beam that the cut was made for.
    pub fn nearest_in(&self, cut: &Cut, ray: &Ray, range: Range) -> Option<Crossing> {
        let (faces, mut best) = (self.faces(), None);
        let tree = CutTree { tree: &faces.tree, cut };
        tree.traverse_leaves(ray, range, faces.leaves.nearer(ray, range.min, &faces.numbers, &mut best));
        best.map(|(face, hit)| Self::crossing(face, hit))
    }

    pub fn node_count(&self) -> usize {
        self.faces().tree.node_count()
    }
}

impl MeshFaces {
    #[cfg(test)]
    fn face_count(&self) -> usize {
        self.numbers.len()
    }

    /// MeshFaces in the order in which the scene lists them; `None` for faces of a `mesh2` without area.
    pub fn in_order(&self) -> Vec<Option<usize>> {
        let length = self.numbers.iter().max().map_or(0, |&last| last as usize + 1);
        let mut places = vec![None; length];
        for (place, &number) in self.numbers.iter().enumerate() {
            places[number as usize] = Some(place);
        }
        if self.kind == "mesh" {
            places.retain(Option::is_some);
        }
        places
    }

    pub fn corners(&self, face: usize) -> [Vec3; 3] {
        self.leaves.corners(face).map(wide)
    }

    pub fn flat_normal(&self, face: usize) -> Vec3 {
        let [a, b, c] = self.corners(face);
        (c - a).cross(b - a).normalize_or(Vec3::Y)
    }

    /// The corners' normals; `None` on a flat face.
    pub fn corner_normals(&self, face: usize) -> Option<[Vec3; 3]> {
        let corners = self.normal_corners.of(face, &self.vertex_numbers)?;
        let [a, b, c] = corners.map(|n| wide(self.normals[n as usize]));
        let same = (a - b).length_squared() < SAME_NORMAL && (a - c).length_squared() < SAME_NORMAL;
        (!same).then_some([a, b, c])
    }

    /// The corners' surface parameters, if they have any.
    pub fn corner_uvs(&self, face: usize) -> Option<[Vec2; 3]> {
        let corners = self.uv_corners.of(face, &self.vertex_numbers)?;
        Some(corners.map(|i| {
            let [u, v] = self.uvs[i as usize];
            Vec2::new(f64::from(u), f64::from(v))
        }))
    }

    /// The interpolated normal; `None` on a flat face.
    fn smooth_normal(&self, face: usize, uv: Vec2) -> Option<Vec3> {
        let [a, b, c] = self.corner_normals(face)?;
        (a + uv.x * (b - a) + uv.y * (c - a)).try_normalize()
    }

    fn heap_bytes(&self) -> usize {
        let textures = match &self.textures {
            Textures::None => 0,
            Textures::One(list) => list.capacity() * 4,
            Textures::Three(list) => list.capacity() * 12,
        };
        self.vertex_numbers.capacity() * 12
            + self.normals.capacity() * 12
            + self.uvs.capacity() * 8
            + self.numbers.capacity() * 4
            + self.normal_corners.heap_bytes()
            + self.uv_corners.heap_bytes()
            + textures
            + self.tree.heap_bytes()
            + self.leaves.heap_bytes()
    }
}

/// Squared distance below which unit normals are the same.
const SAME_NORMAL: f64 = 1e-10;

/// The point of a face with these weights of its last two corners, a bound on its distance from the face's
/// plane, and the face's normal.
#[inline]
fn located([a, b, c]: [Vec3; 3], uv: Vec2) -> (Vec3, f64, Vec3) {
    let p = (1.0 - uv.x - uv.y) * a + uv.x * b + uv.y * c;
    let (e, f) = (b - a, c - a);
    let across = f.cross(e);
    let area = across.length();
    // A thin face's plane tilts with the rounding of its normal.
    let (long, short) = (e.length(), f.length());
    let (long, short) = if long > short { (long, short) } else { (short, long) };
    let tilt = long * long * short / area;
    let error = rounding(a.abs().max(b.abs()).max(c.abs()).max_element() + tilt) + 4.0 * EPSILON * tilt;
    let normal = across / area;
    (p, error, if normal.is_finite() && area > 0.0 { normal } else { Vec3::Y })
}

/// Where a ray from the origin along `dir` meets the plane of three points.
fn plane_distance(a: Vec3, b: Vec3, c: Vec3, dir: Vec3) -> Option<f64> {
    let normal = (b - a).cross(c - a);
    let speed = normal.dot(dir);
    (speed != 0.0).then(|| normal.dot(a) / speed)
}

impl Shape for Mesh {
    fn bounds(&self) -> Aabb {
        self.faces.tree.bounds()
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        let shear = Shear::new(ray.dir);
        let faces = self.faces();
        faces.tree.traverse_leaves(ray, range, |leaf, max| {
            faces.leaves.each_passed(leaf, ray, &shear, |face, hit| {
                if range.contains(hit.0) {
                    out.push(Self::crossing(face, hit));
                }
            });
            max
        });
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let (faces, mut best) = (self.faces(), None);
        faces.tree.traverse_leaves(
            ray,
            range,
            faces.leaves.nearer(ray, range.min, &faces.numbers, &mut best),
        );
        best.map(|(face, hit)| Self::crossing(face, hit))
    }

    fn contains(&self, p: Vec3) -> bool {
        if !self.is_solid {
            return false;
        }
        let faces = self.faces();
        let Some(dir) = faces.inside_vector else { return false };
        if !faces.tree.bounds().contains(p) {
            return false;
        }
        let ray = Ray::new(p, dir);
        let shear = Shear::new(dir);
        let mut inside = false;
        faces.tree.traverse(&ray, Range::FORWARD, |face, max| {
            let [a, b, c] = faces.corners(face as usize).map(|q| q - p);
            if shear.passes_once([a, b, c]) && plane_distance(a, b, c, dir).is_some_and(|t| t > 0.0) {
                inside = !inside;
            }
            max
        });
        inside
    }

    fn is_solid(&self) -> bool {
        self.is_solid
    }

    fn normal(&self, _p: Vec3, crossing: &Crossing) -> Vec3 {
        let face = crossing.part as usize;
        let faces = self.faces();
        faces.smooth_normal(face, crossing.uv).unwrap_or_else(|| faces.flat_normal(face))
    }

    fn face_normal(&self, _p: Vec3, crossing: &Crossing) -> Option<Vec3> {
        let face = crossing.part as usize;
        let smooth = !matches!(self.faces.normal_corners, Indices::None);
        smooth.then(|| self.faces.flat_normal(face))
    }

    fn locate(&self, _ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        let (point, error, _) = located(self.faces.corners(crossing.part as usize), crossing.uv);
        (point, error)
    }

    fn at(&self, _ray: &Ray, crossing: &Crossing) -> Place {
        let face = crossing.part as usize;
        let faces = self.faces();
        let (point, error, flat) = located(faces.corners(face), crossing.uv);
        if matches!(faces.normal_corners, Indices::None) {
            return Place { point, error, normal: flat, face: None };
        }
        let normal = faces.smooth_normal(face, crossing.uv).unwrap_or(flat);
        Place { point, error, normal, face: Some(flat) }
    }

    fn meets(&self, ray: &Ray, range: Range) -> bool {
        let shear = Shear::new(ray.dir);
        let faces = self.faces();
        faces.tree.any_leaf(ray, range, |leaf| {
            let mut met = false;
            faces.leaves.each_passed(leaf, ray, &shear, |_, (t, _)| met |= range.contains(t));
            met
        })
    }

    fn uv(&self, _p: Vec3, crossing: &Crossing) -> Option<Vec2> {
        let face = crossing.part as usize;
        let Some([a, b, c]) = self.faces.corner_uvs(face) else { return Some(Vec2::ZERO) };
        Some((1.0 - crossing.uv.x - crossing.uv.y) * a + crossing.uv.x * b + crossing.uv.y * c)
    }

    fn part_texture(&self, _p: Vec3, crossing: &Crossing) -> PartTexture {
        let some = |i: u32| (i != NO_TEXTURE).then_some(i);
        let face = crossing.part as usize;
        match &self.faces.textures {
            Textures::None => PartTexture::Object,
            Textures::One(list) if list[face] == NO_TEXTURE => PartTexture::Object,
            Textures::One(list) => PartTexture::Blend([(some(list[face]), 1.0)].into_iter().collect()),
            Textures::Three(list) => {
                let uv = crossing.uv;
                let weights = [1.0 - uv.x - uv.y, uv.x, uv.y];
                let parts = list[face].iter().zip(weights);
                PartTexture::Blend(parts.map(|(&i, w)| (some(i), w as f32)).collect())
            }
        }
    }

    fn kind(&self) -> &'static str {
        self.kind
    }

    fn as_mesh(&self) -> Option<&Mesh> {
        Some(self)
    }

    fn heap_bytes(&self) -> usize {
        self.faces.heap_bytes()
    }
}

#[cfg(test)]
mod tests;
