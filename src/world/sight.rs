//! What rays inside one beam may meet: found once, for many of them.

use super::accel::Finite;
use super::geometry::{Found, Geometry, Item, Nearest, Solid};
use super::hit::RayClass;
use crate::math::bvh::{Cut, CutTree};
use crate::math::{Accelerator, Beam, Range, Ray};
use crate::shape::Mesh;

/// Trees of fewer nodes are gone through as quickly.
const WORTHWHILE: usize = 16;
/// The longest list of objects among which meshes are looked for.
const FEW: usize = 8;

/// The parts of trees that a [`Beam`] runs through; kept to be filled again.
#[derive(Debug, Default)]
pub struct Sight {
    /// Of the tree over the finite objects, if there is one.
    roots: Cut,
    has_roots: bool,
    /// Of meshes among these objects, by their place there.
    meshes: Vec<(u32, Cut)>,
}

impl Sight {
    /// Whether it says more than that everything is to be asked.
    pub fn is_useful(&self) -> bool {
        self.has_roots || !self.meshes.is_empty()
    }

    #[cfg(test)]
    pub fn mesh_count(&self) -> usize {
        self.meshes.len()
    }

    fn mesh(&self, place: u32) -> Option<&Cut> {
        self.meshes.iter().find(|(of, _)| *of == place).map(|(_, cut)| cut)
    }
}

fn is_large(mesh: &Mesh) -> bool {
    mesh.node_count() >= WORTHWHILE
}

impl Geometry {
    /// Whether there is so much in the scene that sights save time.
    pub fn deserves_sights(&self) -> bool {
        let is_large_mesh = |item: &Item| match item.solid {
            Solid::Leaf(i) => self.leaves[i as usize].shape.as_mesh().is_some_and(is_large),
            Solid::Compound(_) => false,
        };
        match &self.search {
            Finite::Tree(tree) => tree.node_count() >= WORTHWHILE || self.finite.iter().any(is_large_mesh),
            Finite::List(_) => self.finite.len() <= FEW && self.finite.iter().any(is_large_mesh),
            Finite::Grid(_) => false,
        }
    }

    /// Fills `sight` with what rays in `beam` may meet.
    pub fn look_along(&self, beam: &Beam, sight: &mut Sight) {
        let Sight { roots, has_roots, meshes } = sight;
        *has_roots = false;
        meshes.clear();
        let mut look = |place| {
            let mut cut = Cut::default();
            if self.cut_mesh(&self.finite[place as usize], beam, &mut cut) {
                meshes.push((place, cut));
            }
        };
        match &self.search {
            Finite::Tree(tree) => {
                *has_roots = tree.cut(beam, roots);
                if *has_roots {
                    roots.leaves().for_each(look);
                }
            }
            Finite::List(_) => (0..self.finite.len() as u32).for_each(&mut look),
            Finite::Grid(_) => {}
        }
    }

    /// Cuts a mesh whose space is the world's but for a turn and an even scale.
    fn cut_mesh(&self, item: &Item, beam: &Beam, cut: &mut Cut) -> bool {
        let Solid::Leaf(i) = item.solid else { return false };
        let leaf = &self.leaves[i as usize];
        let Some(mesh) = leaf.shape.as_mesh().filter(|mesh| is_large(mesh)) else { return false };
        let Some(place) = &leaf.place else { return mesh.cut(beam, cut) };
        let local = place.even_scale().and_then(|_| {
            beam.mapped(place.inverse_point(beam.apex), |v| place.transform.inverse.matrix3 * v)
        });
        local.is_some_and(|beam| mesh.cut(&beam, cut))
    }

    /// [`Geometry::nearest`] for a ray inside the beam that the sight was filled for.
    pub fn nearest_in_sight(&self, sight: &Sight, ray: &Ray, range: Range, class: RayClass) -> Option<Found> {
        match &self.search {
            Finite::Tree(tree) if sight.has_roots => {
                let tree = CutTree { tree, cut: &sight.roots };
                self.nearest_among(&tree, sight, ray, range, class)
            }
            Finite::List(list) => self.nearest_among(list, sight, ray, range, class),
            _ => self.nearest(ray, range, class),
        }
    }

    #[inline(always)]
    fn nearest_among(
        &self,
        finite: &impl Accelerator,
        sight: &Sight,
        ray: &Ray,
        range: Range,
        class: RayClass,
    ) -> Option<Found> {
        let mut best = Nearest::of(class);
        self.find_among(finite, Some(sight), &mut best, ray, range);
        best.found
    }

    /// [`Geometry::nearest_of`] for the finite object at a place, of which `sight` may know more.
    #[inline(always)]
    pub fn nearest_seen(
        &self,
        sight: Option<&Sight>,
        (place, item): (u32, &Item),
        ray: &Ray,
        range: Range,
    ) -> Option<Found> {
        match sight.and_then(|sight| sight.mesh(place)) {
            Some(cut) => self.nearest_of_mesh(item.solid, cut, ray, range),
            None => self.nearest_of(item.solid, ray, range),
        }
    }

    #[inline(never)]
    fn nearest_of_mesh(&self, solid: Solid, cut: &Cut, ray: &Ray, range: Range) -> Option<Found> {
        let Solid::Leaf(index) = solid else { return None };
        let leaf = &self.leaves[index as usize];
        let (local, length) = leaf.place.as_ref().map_or((*ray, 1.0), |place| place.inverse_ray(ray));
        let crossing = leaf.shape.as_mesh()?.nearest_in(cut, &local, range.scaled(length))?;
        Some(Found::new(crossing.t / length, index, crossing))
    }
}
