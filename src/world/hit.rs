use crate::material::Texture;
use crate::math::{Transform, Vec3};
use crate::shape::Crossing;
use std::sync::Arc;

/// What a ray met.
#[derive(Clone, Debug)]
pub struct Hit {
    /// World distance from the ray's origin.
    pub t: f64,
    /// The point in world space.
    pub point: Vec3,
    /// Bound on the distance between `point` and the true surface, in world units. A ray that leaves the
    /// surface starts this far along the normal, on the side that it goes to.
    pub error: f64,
    /// The point in the object's own space.
    pub local: Vec3,
    pub crossing: Crossing,
    /// Unit normal in world space; outward, turned inward for inverted objects; not turned to the ray.
    pub normal: Vec3,
    /// The leaf object that was hit.
    pub item: u32,
    pub interior: InteriorId,
    /// The object ignores global lights (member of a light group without `global_lights`).
    pub ignores_global_lights: bool,
    pub double_illuminate: bool,
    /// Range of the object's lights in `World::group_lights`.
    pub group_lights: (u32, u32),
    /// Whether the object's texture is evaluated at (u, v, 0).
    pub uv_mapping: bool,
    /// Whether every texture of the object (interior ones too) is fully opaque everywhere.
    pub opaque: bool,
}

/// Identity of an object's interior: children of one CSG that have none of their own share it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct InteriorId(pub u32);

/// Which objects a ray sees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RayClass {
    /// From the camera, and its transmitted continuation.
    Image,
    /// With a reflection in its history.
    Reflected,
    /// Towards a light.
    Shadow,
    /// A radiosity sample.
    Radiosity,
}

/// A texture as it sits on one object: layers bottom first, each with its own placement.
#[derive(Debug)]
pub struct Surface {
    pub layers: Vec<SurfaceLayer>,
    pub opaque: bool,
}

#[derive(Debug)]
pub struct SurfaceLayer {
    pub texture: Arc<Texture>,
    /// `inverse` takes the object's own space to texture space; `None` if they are the same space.
    pub texture_to_local: Option<Transform>,
    /// `inverse` takes world space to texture space; `None` if they are the same space. Frames normals.
    pub texture_to_world: Option<Transform>,
}
