//! What rays need: the scene's objects flattened, with transforms worked out and a tree over them.
//!
//! When you hold a [`World`]: CSG children know their transforms to world space, textures and interiors
//! are inherited, numbered and shared, infinite objects stand apart from the tree.

mod accel;
mod ball;
mod between;
mod compound;
mod convex;
mod crossed;
mod flatten;
mod geometry;
mod hit;
mod intersection;
mod obstacle;
mod placement;
mod probe;
mod query;
mod scratch;
mod sight;
mod stats;
#[cfg(test)]
mod tests;

pub use accel::Accel;
pub use between::Between;
pub use crossed::{Crossed, Next};
pub use hit::{Hit, InteriorId, Obstacle, PhotonRules, PhotonTarget, RayClass, Surface, SurfaceLayer};
pub use query::ObjectQuery;
pub use sight::Sight;
pub use stats::Stats;

use crate::light::Light;
use crate::material::Interior;
use crate::math::{Beam, Range, Ray, Shaft, Transform, Vec2, Vec3};
use crate::scene::Scene;
use crate::shape::PartTexture;
use flatten::Flattened;
use geometry::{Found, Geometry, NONE, Nearest, Solid};
use hit::Shading;
use smallvec::SmallVec;
use std::sync::Arc;

/// A scene ready for rays. Immutable while rendering.
#[derive(Debug)]
pub struct World {
    /// Everything that is not geometry: globals, camera, atmosphere. Its `objects` are empty.
    pub scene: Scene,
    /// Every global light, in order of declaration.
    pub lights: Vec<WorldLight>,
    /// Lights of light groups; a hit's `group_lights` index into it.
    pub group_lights: Vec<WorldLight>,
    /// What photons are shot at, in the order of the scene.
    pub targets: Vec<PhotonTarget>,
    geometry: Geometry,
    surfaces: Vec<Surface>,
    part_surfaces: Vec<u32>,
    shadings: Vec<Shading>,
    interiors: Vec<Inside>,
    projectors: Vec<Solid>,
}

/// Surfaces of one projector that a ray is followed through.
const MOST_PROJECTOR_SURFACES: usize = 1000;

/// A light with the bodies that shape its beam, prepared.
#[derive(Clone, Debug)]
pub struct WorldLight {
    pub light: Light,
    /// Index for [`World::projector`], if the light shines through an object.
    pub projected_through: Option<u32>,
    /// Its place among all lights, those of groups behind the global ones.
    pub number: u32,
    /// Whether its place and colour are all that there is to it: see [`Light::is_plain`].
    pub plain: bool,
}

/// The object that stopped the last shadow ray towards a light.
#[derive(Clone, Copy, Debug)]
pub struct Blocker(u32);

impl Default for Blocker {
    fn default() -> Self {
        Self(NONE)
    }
}

/// An object's interior where it stands.
#[derive(Debug)]
pub(crate) struct Inside {
    interior: Arc<Interior>,
    transform: Transform,
    hollow: bool,
}

impl World {
    pub fn prepare(scene: Scene) -> World {
        World::prepare_with(scene, Accel::default())
    }

    /// The same with the structure that is to hold the objects.
    pub fn prepare_with(mut scene: Scene, accel: Accel) -> World {
        let objects = std::mem::take(&mut scene.objects);
        let mut flat = Flattened::new(&objects, accel);
        drop(objects);
        for (i, light) in flat.lights.iter_mut().chain(&mut flat.group_lights).enumerate() {
            light.number = i as u32;
        }
        World {
            scene,
            lights: flat.lights,
            group_lights: flat.group_lights,
            targets: flat.targets,
            geometry: flat.geometry,
            surfaces: flat.surfaces,
            part_surfaces: flat.part_surfaces,
            shadings: flat.shadings,
            interiors: flat.interiors,
            projectors: flat.projectors,
        }
    }

    /// The nearest hit inside `range` among the objects that `class` sees. `ray.dir` has unit length.
    pub fn nearest(&self, ray: &Ray, range: Range, class: RayClass) -> Option<Hit> {
        let mut best = Nearest::of(class);
        self.geometry.find(&mut best, ray, range);
        best.found.as_ref().map(|found| self.hit(ray, found))
    }

    /// Whether there is so much in the scene that [`Sight`]s save time.
    pub fn deserves_sights(&self) -> bool {
        self.geometry.deserves_sights()
    }

    /// Fills `sight` with what rays in `beam` may meet, for [`World::nearest_in_sight`].
    pub fn look_along(&self, beam: &Beam, sight: &mut Sight) {
        self.geometry.look_along(beam, sight);
    }

    /// [`World::nearest`] for a ray inside the beam that the sight was filled for.
    pub fn nearest_in_sight(&self, sight: &Sight, ray: &Ray, range: Range, class: RayClass) -> Option<Hit> {
        self.geometry.nearest_in_sight(sight, ray, range, class).as_ref().map(|found| self.hit(ray, found))
    }

    #[inline]
    fn hit(&self, ray: &Ray, found: &Found) -> Hit {
        let located = self.geometry.locate(ray, found);
        let leaf = &self.geometry.leaves[found.leaf as usize];
        let shading = &self.shadings[leaf.shading as usize];
        Hit {
            t: found.t,
            point: located.point,
            error: located.error,
            local: located.local,
            crossing: found.crossing,
            normal: located.normal,
            face: located.face,
            item: found.leaf,
            interior: leaf.interior,
            ignores_global_lights: shading.ignores_global_lights,
            double_illuminate: shading.double_illuminate,
            group_lights: shading.group_lights,
            uv_mapping: shading.uv_mapping,
            opaque: shading.opaque,
        }
    }

    /// How far the last surface of projector `index` on the ray is.
    pub fn behind_projector(&self, index: u32, ray: &Ray) -> Option<f64> {
        let nearest = |from: f64| self.projector(index, ray, Range::new(from, f64::INFINITY));
        let mut last = nearest(0.0)?;
        for _ in 0..MOST_PROJECTOR_SURFACES {
            match nearest(last * (1.0 + 1e-12)) {
                Some(t) if t > last => last = t,
                _ => break,
            }
        }
        Some(last)
    }

    /// The nearest hit of the ray with projector `index` alone.
    pub fn projector(&self, index: u32, ray: &Ray, range: Range) -> Option<f64> {
        self.geometry.nearest_of(self.projectors[index as usize], ray, range).map(|f| f.t)
    }

    /// What stands in the way of light inside `range`: any fully opaque object, or else the nearest surface of
    /// one that lets light through. `last` only makes it faster: one per light and thread, at first
    /// [`Blocker::default`].
    #[inline]
    pub fn obstacle(&self, ray: &Ray, range: Range, last: &mut Blocker) -> Obstacle<Hit> {
        self.as_hit(ray, self.geometry.obstacle(ray, range, &mut last.0))
    }

    #[inline]
    fn as_hit(&self, ray: &Ray, obstacle: Obstacle<Found>) -> Obstacle<Hit> {
        match obstacle {
            Obstacle::None => Obstacle::None,
            Obstacle::Opaque => Obstacle::Opaque,
            Obstacle::Filter(found) => Obstacle::Filter(self.hit(ray, &found)),
        }
    }

    /// Finds what may stop or change light in the shaft, for [`World::obstacle_between`]. False if that is much,
    /// or there is no quick way to tell; then `between` means nothing.
    pub fn stands_between(&self, shaft: &Shaft, between: &mut Between) -> bool {
        self.geometry.stands_between(shaft, between)
    }

    /// [`World::obstacle`] for a ray that stays in the shaft that `between` was found for.
    #[inline]
    pub fn obstacle_between(&self, between: &Between, ray: &Ray, range: Range) -> Obstacle<Hit> {
        self.as_hit(ray, self.geometry.obstacle_between(between, ray, range))
    }

    /// Whether no object lets light through or changes it: [`World::is_stopped`] then says all.
    pub fn stops_or_passes(&self) -> bool {
        self.geometry.stops_or_passes()
    }

    /// Whether light is stopped inside `range`, by objects that stop all of it; `last` as for
    /// [`World::obstacle`].
    #[inline]
    pub fn is_stopped(&self, ray: &Ray, range: Range, last: &mut Blocker) -> bool {
        self.geometry.is_stopped(ray, range, &mut last.0)
    }

    /// Whether no object lets light through.
    pub fn all_opaque(&self) -> bool {
        self.geometry.roots.iter().all(|r| r.opaque)
    }

    /// The interiors of the top-level objects that contain `p`, in scene order.
    pub fn interiors_at(&self, p: Vec3) -> SmallVec<[InteriorId; 4]> {
        self.geometry.roots_at(p).into_iter().map(|i| self.geometry.roots[i as usize].interior).collect()
    }

    #[inline]
    pub fn interior(&self, id: InteriorId) -> &Interior {
        &self.interiors[id.0 as usize].interior
    }

    /// Every interior with its number.
    pub fn interiors(&self) -> impl Iterator<Item = (InteriorId, &Interior)> {
        self.interiors.iter().enumerate().map(|(i, inside)| (InteriorId(i as u32), &*inside.interior))
    }

    /// Where the interior's own space (that of its densities) stands in the world.
    pub fn interior_to_world(&self, id: InteriorId) -> &Transform {
        &self.interiors[id.0 as usize].transform
    }

    /// Whether the interior's object is hollow (media and fog act inside it).
    #[inline]
    pub fn is_hollow(&self, id: InteriorId) -> bool {
        self.interiors[id.0 as usize].hollow
    }

    /// Share of radiosity rays that look at what was hit in full.
    pub fn importance(&self, hit: &Hit) -> f32 {
        let shading = self.geometry.leaves[hit.item as usize].shading;
        self.shadings[shading as usize].importance.map_or(self.scene.globals.importance, f32::from_bits)
    }

    /// What the object does with photons.
    pub fn photon_rules(&self, hit: &Hit) -> &PhotonRules {
        let shading = self.geometry.leaves[hit.item as usize].shading;
        &self.shadings[shading as usize].photons
    }

    /// The kind of shape that was hit.
    pub fn kind(&self, hit: &Hit) -> &'static str {
        self.geometry.leaves[hit.item as usize].shape.kind()
    }

    /// The surface parameters of a hit: the shape's own, or world x and y.
    pub fn uv(&self, hit: &Hit) -> Vec2 {
        let shape = &self.geometry.leaves[hit.item as usize].shape;
        shape.uv(hit.local, &hit.crossing).unwrap_or(Vec2::new(hit.point.x, hit.point.y))
    }

    /// The surface that shows at a hit, if it is certain to be the only one. `from_inside` asks for the
    /// `interior_texture` where there is one.
    #[inline]
    pub fn sole_surface(&self, hit: &Hit, from_inside: bool) -> Option<&Surface> {
        let leaf = &self.geometry.leaves[hit.item as usize];
        let number = match from_inside && leaf.interior_surface != NONE {
            true => leaf.interior_surface,
            false if leaf.has_parts => NONE,
            false => leaf.surface,
        };
        (number != NONE).then(|| &self.surfaces[number as usize])
    }

    /// The surfaces that show at a hit with weights that add to 1. `from_inside` asks for the
    /// `interior_texture` where there is one.
    pub fn surfaces<'w>(&'w self, hit: &Hit, from_inside: bool, out: &mut SmallVec<[(f32, &'w Surface); 2]>) {
        let leaf = &self.geometry.leaves[hit.item as usize];
        if from_inside && leaf.interior_surface != NONE {
            out.push((1.0, &self.surfaces[leaf.interior_surface as usize]));
            return;
        }
        match leaf.shape.part_texture(hit.local, &hit.crossing) {
            PartTexture::Object => self.object_surface(leaf, hit.point, 1.0, out),
            PartTexture::Blend(parts) => {
                for (part, weight) in parts {
                    match part {
                        None => self.object_surface(leaf, hit.point, weight, out),
                        Some(i) => {
                            let number = self.part_surfaces[(leaf.parts + i) as usize];
                            out.push((weight, &self.surfaces[number as usize]));
                        }
                    }
                }
            }
        }
    }

    /// The leaf's surface, or those of the solids that its cut shows.
    fn object_surface<'w>(
        &'w self,
        leaf: &geometry::Leaf,
        p: Vec3,
        weight: f32,
        out: &mut SmallVec<[(f32, &'w Surface); 2]>,
    ) {
        if leaf.surface != NONE {
            out.push((weight, &self.surfaces[leaf.surface as usize]));
        } else if leaf.cutaway != NONE {
            let mut numbers: SmallVec<[u32; 4]> = SmallVec::new();
            self.cutaway_surfaces(Solid::Compound(leaf.cutaway), p, &mut numbers);
            let share = weight / numbers.len().max(1) as f32;
            out.extend(numbers.iter().map(|&n| (share, &self.surfaces[n as usize])));
        }
    }

    /// The surfaces of the textured solids below `solid` that contain `p`: of a difference the first
    /// child's.
    fn cutaway_surfaces(&self, solid: Solid, p: Vec3, out: &mut SmallVec<[u32; 4]>) {
        match solid {
            Solid::Leaf(i) => {
                let surface = self.geometry.leaves[i as usize].surface;
                if surface != NONE {
                    out.push(surface);
                }
            }
            Solid::Compound(i) => {
                for child in &self.geometry.compounds[i as usize].children {
                    let child = child.solid;
                    let inverted =
                        matches!(child, Solid::Leaf(l) if self.geometry.leaves[l as usize].inverted);
                    if !inverted && self.geometry.contains(child, p) {
                        self.cutaway_surfaces(child, p, out);
                    }
                }
            }
        }
    }
}
