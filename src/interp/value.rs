use crate::camera::Camera;
use crate::color::Color;
use crate::material::{Finish, Interior, Media, Normal, Pigment, Texture};
use crate::math::Transform;
use crate::pattern::{BlendMap, ColorMap};
use crate::scene::{Fog, Object, Rainbow, SkySphere};
use std::sync::Arc;

/// What an identifier can hold. Anything big is shared.
#[derive(Clone, Debug)]
pub enum Value {
    Float(f64),
    /// 2 to 4 components (unused ones 0) or a 5-component vector that was not stored as a colour.
    Vector(u8, [f64; 5]),
    Color(Color),
    String(Arc<str>),
    Array(Arc<Array>),
    Transform(Arc<Transform>),
    Object(Arc<Object>),
    Pigment(Arc<Pigment>),
    Normal(Option<Arc<Normal>>),
    Finish(Arc<Finish>),
    /// A layered texture, bottom layer first.
    Texture(Arc<Vec<crate::material::Attached<Texture>>>),
    Interior(Arc<Interior>),
    Media(Arc<Media>),
    Material(Arc<Material>),
    Camera(Arc<Camera>),
    Fog(Arc<Fog>),
    Rainbow(Arc<Rainbow>),
    SkySphere(Arc<SkySphere>),
    /// `color_map`, `pigment_map` and their like, not yet given to a pattern.
    Map(Arc<Map>),
    Function(Arc<dyn std::any::Any + Send + Sync>),
    Spline(Arc<dyn std::any::Any + Send + Sync>),
    Density(Arc<Pigment>),
}

/// Elements in row-major order; `None` where nothing was assigned.
#[derive(Clone, Debug)]
pub struct Array {
    pub sizes: Vec<usize>,
    pub elements: Vec<Option<Value>>,
}

/// `material { texture interior_texture interior }`.
#[derive(Clone, Debug, Default)]
pub struct Material {
    pub textures: Vec<crate::material::Attached<Texture>>,
    pub interior_textures: Vec<crate::material::Attached<Texture>>,
    pub interior: Option<crate::material::Attached<Interior>>,
}

/// A map as an identifier keeps it.
#[derive(Clone, Debug)]
pub enum Map {
    Colors(ColorMap),
    Pigments(BlendMap<Arc<Pigment>>),
    Densities(BlendMap<Arc<Pigment>>),
    Normals(BlendMap<Arc<Normal>>),
    Textures(BlendMap<Texture>),
    /// Height and slope.
    Slopes(BlendMap<(f64, f64)>),
}
