use crate::camera::Camera;
use crate::color::Color;
use crate::function::Function;
use crate::material::{Finish, Interior, Media, Normal, Pigment, Texture};
use crate::math::{Spline, Transform};
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
    Function(Arc<Function>),
    Spline(Arc<Spline>),
    Density(Arc<Pigment>),
}

/// Elements in row-major order; `None` where nothing was assigned.
#[derive(Clone, Debug)]
pub struct Array {
    pub sizes: Vec<usize>,
    pub elements: Vec<Option<Value>>,
    /// What every element must be, from the first one set.
    pub kind: Option<&'static str>,
    /// At most so many arrays stand within each other here, this one counted.
    pub depth: u32,
}

impl Value {
    /// How many arrays stand within each other; 0 for what is no array.
    pub fn array_depth(&self) -> u32 {
        match self {
            Value::Array(array) => array.depth,
            _ => 0,
        }
    }

    /// What the value is, in the words of a message.
    pub fn kind(&self) -> &'static str {
        match self {
            Value::Float(_) => "number",
            Value::Vector(2, _) => "2-vector",
            Value::Vector(4, _) => "4-vector",
            Value::Vector(..) => "vector",
            Value::Color(_) => "color",
            Value::String(_) => "string",
            Value::Array(_) => "array",
            Value::Transform(_) => "transform",
            Value::Object(_) => "object",
            Value::Pigment(_) => "pigment",
            Value::Normal(_) => "normal",
            Value::Finish(_) => "finish",
            Value::Texture(_) => "texture",
            Value::Interior(_) => "interior",
            Value::Media(_) => "media",
            Value::Material(_) => "material",
            Value::Camera(_) => "camera",
            Value::Fog(_) => "fog",
            Value::Rainbow(_) => "rainbow",
            Value::SkySphere(_) => "sky_sphere",
            Value::Map(_) => "map",
            Value::Function(_) => "function",
            Value::Spline(_) => "spline",
            Value::Density(_) => "density",
        }
    }
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
