//! What rays need: the scene's objects flattened, with transforms worked out and a tree over them.
//!
//! When you hold a [`World`]: CSG children know their transforms to world space, textures and interiors
//! are inherited, numbered and shared, infinite objects stand apart from the tree.

mod hit;

pub use hit::{Hit, InteriorId, RayClass, Surface, SurfaceLayer};

use crate::light::Light;
use crate::material::Interior;
use crate::math::{Range, Ray, Vec2, Vec3};
use crate::scene::Scene;
use smallvec::SmallVec;

/// A scene ready for rays. Immutable while rendering.
#[derive(Debug)]
pub struct World {
    /// Everything that is not geometry: globals, camera, atmosphere. Its `objects` are empty.
    pub scene: Scene,
    /// Every global light, in order of declaration.
    pub lights: Vec<WorldLight>,
    /// Lights of light groups; an item's `group_lights` index into it.
    pub group_lights: Vec<WorldLight>,
}

/// A light with the bodies that shape its beam, prepared.
#[derive(Debug)]
pub struct WorldLight {
    pub light: Light,
    /// Index for [`World::projector`], if the light shines through an object.
    pub projected_through: Option<u32>,
}

impl World {
    pub fn prepare(_scene: Scene) -> World {
        todo!()
    }

    /// The nearest hit inside `range` among the objects that `class` sees. `ray.dir` has unit length.
    pub fn nearest(&self, _ray: &Ray, _range: Range, _class: RayClass) -> Option<Hit> {
        todo!()
    }

    /// The nearest hit of the ray with projector `index` alone.
    pub fn projector(&self, _index: u32, _ray: &Ray, _range: Range) -> Option<f64> {
        todo!()
    }

    /// Whether any fully opaque object that casts shadows lies inside `range`; used before a shadow ray
    /// is followed in full. False when only transparent ones do.
    pub fn blocked(&self, _ray: &Ray, _range: Range) -> bool {
        todo!()
    }

    /// The interiors of the top-level objects that contain `p`, in scene order.
    pub fn interiors_at(&self, _p: Vec3) -> SmallVec<[InteriorId; 4]> {
        todo!()
    }

    pub fn interior(&self, _id: InteriorId) -> &Interior {
        todo!()
    }

    /// Whether the interior's object is hollow (media and fog act inside it).
    pub fn is_hollow(&self, _id: InteriorId) -> bool {
        todo!()
    }

    /// The surface parameters of a hit: the shape's own, or world x and y.
    pub fn uv(&self, _hit: &Hit) -> Vec2 {
        todo!()
    }

    /// The surfaces that show at a hit with weights that add to 1. `from_inside` asks for the
    /// `interior_texture` where there is one.
    pub fn surfaces<'w>(
        &'w self,
        _hit: &Hit,
        _from_inside: bool,
        _out: &mut SmallVec<[(f32, &'w Surface); 2]>,
    ) {
        todo!()
    }
}
