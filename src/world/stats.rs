use super::World;
use super::geometry::Solid;
use crate::material::{Ingredients, Interior};
use std::collections::BTreeMap;

/// What was built for a scene; for `check` and `explain`.
#[derive(Clone, Debug, Default)]
pub struct Stats {
    /// Top-level objects with finite bounds, unions taken apart.
    pub finite_objects: usize,
    pub infinite_objects: usize,
    /// Lights, those of light groups included.
    pub light_sources: usize,
    /// Leaves by kind of shape.
    pub shapes: BTreeMap<&'static str, usize>,
    /// CSG combinations and clipped objects.
    pub combinations: usize,
    pub surfaces: usize,
    pub interiors: usize,
    /// What the finite objects are kept in: `bvh`, `grid` or `none`.
    pub accel: &'static str,
    /// Nodes of the tree over the top-level objects, or cells of the grid; 0 where there is neither.
    pub tree_nodes: usize,
    pub tree_bytes: usize,
    /// Bytes that shapes keep beyond their own structures, copies counted once.
    pub shape_bytes: usize,
}

impl World {
    pub fn stats(&self) -> Stats {
        let g = &self.geometry;
        let mut stats = Stats {
            finite_objects: g.finite.len(),
            infinite_objects: g.infinite.len(),
            light_sources: self.lights.len() + self.group_lights.len(),
            combinations: g.compounds.len(),
            surfaces: self.surfaces.len(),
            interiors: self.interiors.len(),
            accel: g.search.name(),
            tree_nodes: g.search.node_count(),
            tree_bytes: g.search.heap_bytes(),
            ..Stats::default()
        };
        let mut counted = std::collections::HashSet::new();
        for leaf in &g.leaves {
            *stats.shapes.entry(leaf.shape.kind()).or_default() += 1;
            if counted.insert(std::sync::Arc::as_ptr(&leaf.shape).cast::<()>() as usize) {
                stats.shape_bytes += leaf.shape.heap_bytes();
            }
        }
        stats
    }

    /// What the scene's textures are made of, those of the sky and of media included.
    pub fn ingredients(&self) -> Ingredients {
        let mut all = Ingredients::default();
        for layer in self.surfaces.iter().flat_map(|s| &s.layers) {
            all.add_texture(&layer.texture);
        }
        for interior in &self.interiors {
            interior.interior.media.iter().for_each(|m| all.media(m));
        }
        self.scene.media.iter().for_each(|m| all.media(&m.value));
        self.scene.sky_sphere.iter().flat_map(|s| &s.pigments).for_each(|p| all.pigment(p));
        all
    }

    /// Objects with an interior that bends light or weakens it, and objects with media.
    pub fn interior_counts(&self) -> (usize, usize) {
        let bends = |i: &Interior| i.ior != 1.0 || i.fade_power != 0.0;
        let count =
            |test: &dyn Fn(&Interior) -> bool| self.interiors.iter().filter(|i| test(&i.interior)).count();
        (count(&bends), count(&|i| !i.media.is_empty()))
    }

    /// How deep combinations are nested, counted from the top-level objects.
    pub fn csg_depth(&self) -> usize {
        self.geometry.roots.iter().map(|r| self.depth_of(r.solid)).max().unwrap_or(0)
    }

    fn depth_of(&self, solid: Solid) -> usize {
        match solid {
            Solid::Leaf(_) => 0,
            Solid::Compound(i) => {
                let children = &self.geometry.compounds[i as usize].children;
                1 + children.iter().map(|c| self.depth_of(c.solid)).max().unwrap_or(0)
            }
        }
    }
}
