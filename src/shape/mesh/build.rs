use super::leaves::{LANES, Leaves};
use super::{Corners, Indices, Mesh, MeshFaces, Textures};
use crate::math::bvh::{Bvh, Quality};
use crate::math::{Aabb, Vec3};
use std::collections::HashMap;
use std::hash::Hash;
use std::sync::LazyLock;

/// Stands for the first normal or uv of a face that has none.
pub const FLAT: u32 = u32::MAX;
/// Stands for the object's texture.
pub const NO_TEXTURE: u32 = u32::MAX;

/// Collects a mesh: either list by list, or face by face with equal entries merged.
#[derive(Debug, Default)]
pub struct MeshBuilder {
    pub vertices: Vec<[f32; 3]>,
    pub faces: Vec<Corners>,
    pub normals: Vec<[f32; 3]>,
    /// Empty where the faces' normals have the numbers of their vertices.
    pub normal_corners: Vec<Corners>,
    pub uvs: Vec<[f32; 2]>,
    /// Empty where the faces' uvs have the numbers of their vertices.
    pub uv_corners: Vec<Corners>,
    /// Empty, or one entry per face.
    pub textures: Vec<Corners>,
    pub inside_vector: Option<Vec3>,
    /// The word in the scene.
    pub kind: &'static str,
}

/// Numbers of entries already in a list.
#[derive(Debug)]
pub struct Merged<T> {
    numbers: HashMap<T, u32>,
}

impl<T: Hash + Eq> Default for Merged<T> {
    fn default() -> Self {
        Self { numbers: HashMap::new() }
    }
}

impl<T: Hash + Eq> Merged<T> {
    /// The number of `key`, whose `entry` is added to `list` if it is new.
    pub fn number<E>(&mut self, list: &mut Vec<E>, key: T, entry: E) -> u32 {
        *self.numbers.entry(key).or_insert_with(|| {
            list.push(entry);
            list.len() as u32 - 1
        })
    }
}

impl MeshBuilder {
    /// The finished mesh. Every index must be in its list. MeshFaces without area are never hit and left out.
    pub fn build(self) -> Mesh {
        let is_solid = self.inside_vector.and_then(Vec3::try_normalize).is_some();
        let kind = self.kind;
        Mesh { faces: LazyLock::new(Box::new(|| self.faces())), is_solid, kind }
    }

    fn faces(mut self) -> MeshFaces {
        let bounds = |i: u32| self.face_bounds(self.faces[i as usize]);
        let mut tree = Bvh::build_from(self.faces.len(), bounds, Quality::Fast { leaf: LANES });
        self.normals.shrink_to_fit();
        self.uvs.shrink_to_fit();
        let order = tree.order();
        let mut vertex_numbers = reordered(self.faces, order);
        let corners = |i: u32| vertex_numbers[i as usize].map(|v| self.vertices[v as usize]);
        let leaves = Leaves::new(tree.leaves(), order.len(), corners);
        let normal_corners = indices(self.normal_corners, !self.normals.is_empty(), order);
        let uv_corners = indices(self.uv_corners, !self.uvs.is_empty(), order);
        if ![&normal_corners, &uv_corners].iter().any(|list| matches!(list, Indices::Vertices)) {
            vertex_numbers = Vec::new();
        }
        let textures = textures(self.textures, order);
        leaves.tell(&mut tree);
        MeshFaces {
            normal_corners,
            normals: self.normals,
            uv_corners,
            uvs: self.uvs,
            textures,
            vertex_numbers,
            inside_vector: self.inside_vector.and_then(Vec3::try_normalize),
            kind: self.kind,
            numbers: tree.take_order(),
            tree,
            leaves,
        }
    }

    /// The face's box; empty if it has no area.
    fn face_bounds(&self, face: Corners) -> Aabb {
        let [a, b, c] = face.map(|v| super::wide(self.vertices[v as usize]));
        if (b - a).cross(c - a) == Vec3::ZERO {
            return Aabb::EMPTY;
        }
        Aabb::from_points([a, b, c])
    }
}

fn reordered<T: Copy>(list: Vec<T>, order: &[u32]) -> Vec<T> {
    order.iter().map(|&i| list[i as usize]).collect()
}

fn indices(list: Vec<Corners>, has_entries: bool, order: &[u32]) -> Indices {
    match (has_entries, list.is_empty()) {
        (false, _) => Indices::None,
        (true, true) => Indices::Vertices,
        (true, false) => Indices::Own(reordered(list, order)),
    }
}

fn textures(list: Vec<Corners>, order: &[u32]) -> Textures {
    if list.iter().flatten().all(|&t| t == NO_TEXTURE) {
        return Textures::None;
    }
    if list.iter().all(|t| t[0] == t[1] && t[0] == t[2]) {
        return Textures::One(order.iter().map(|&i| list[i as usize][0]).collect());
    }
    Textures::Three(reordered(list, order))
}
