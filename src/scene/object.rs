use super::ObjectPhotons;
use crate::light::Light;
use crate::material::{Attached, Interior, Texture};
use crate::math::Transform;
use crate::shape::Shape;
use std::sync::Arc;

/// One object statement. Cheap to clone: bodies, textures and children are shared.
#[derive(Clone, Debug)]
pub struct Object {
    pub body: Body,
    /// Takes the body's space (for CSG: the space in which the children stand) to the outer space.
    pub transform: Transform,
    /// The object's texture, bottom layer first. Empty: the parent's.
    pub textures: Vec<Attached<Texture>>,
    pub interior_textures: Vec<Attached<Texture>>,
    /// Textures of parts (mesh triangles, blob components), by index.
    pub part_textures: Vec<Attached<Texture>>,
    pub interior: Option<Attached<Interior>>,
    /// Only what all of these contain is kept. Transforms of this object move them too: each is wrapped
    /// with the transform that it has collected so far, in outer space.
    pub clipped_by: Vec<Arc<Object>>,
    pub bounded_by: Vec<Arc<Object>>,
    pub flags: Flags,
    pub photons: ObjectPhotons,
    /// Share of radiosity rays that look at the object in full; `None` until written.
    pub importance: Option<f32>,
    depth: u32,
}

#[derive(Clone, Debug)]
pub enum Body {
    Shape(Arc<dyn Shape>),
    Csg { op: CsgOp, children: Arc<Vec<Arc<Object>>> },
    Light(Arc<LightSource>),
}

/// `Difference` is kept as written: the first child without the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CsgOp {
    Union,
    Merge,
    Intersection,
    Difference,
    /// A union whose lights light only its members.
    LightGroup {
        global_lights: bool,
    },
}

/// A light with what hangs on it.
#[derive(Clone, Debug)]
pub struct LightSource {
    pub light: Light,
    /// Stands at the light's location, in world space already.
    pub looks_like: Option<Arc<Object>>,
    pub projected_through: Option<Arc<Object>>,
}

#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Flags {
    pub no_shadow: bool,
    pub no_image: bool,
    pub no_reflection: bool,
    pub no_radiosity: bool,
    pub double_illuminate: bool,
    /// `None` until written.
    pub hollow: Option<bool>,
    pub inverse: bool,
    pub uv_mapping: bool,
    pub cutaway_textures: bool,
    pub split_union: Option<bool>,
    pub sturm: bool,
}

impl Object {
    pub fn new(body: Body) -> Self {
        let depth = match &body {
            Body::Csg { children, .. } => 1 + deepest(children),
            Body::Shape(shape) => 1 + shape.depth(),
            Body::Light(_) => 1,
        };
        Self {
            depth,
            body,
            transform: Transform::IDENTITY,
            textures: Vec::new(),
            interior_textures: Vec::new(),
            part_textures: Vec::new(),
            interior: None,
            clipped_by: Vec::new(),
            bounded_by: Vec::new(),
            flags: Flags::default(),
            photons: ObjectPhotons::default(),
            importance: None,
        }
    }

    /// How many combinations and regions stand inside each other, itself included, or what it is made of, if that
    /// is more.
    pub fn depth(&self) -> u32 {
        self.depth
    }

    /// Counts what the object's textures and media are made of. Call it when they are complete.
    pub fn count_materials(&mut self) {
        let textures = self.textures.iter().chain(&self.interior_textures).chain(&self.part_textures);
        let deepest = textures.map(|a| a.value.depth()).max().unwrap_or(0);
        let media = self.interior.iter().flat_map(|a| &a.value.media);
        let densities = media.flat_map(|m| &m.densities).map(|d| d.depth());
        self.depth = self.depth.max(deepest).max(densities.max().unwrap_or(0));
    }

    /// Adds objects that clip.
    pub fn clip_by(&mut self, regions: Vec<Arc<Object>>) {
        self.depth = self.depth.max(1 + deepest(&regions));
        self.clipped_by.extend(regions);
    }

    /// Adds objects that bound.
    pub fn bound_by(&mut self, regions: Vec<Arc<Object>>) {
        self.depth = self.depth.max(1 + deepest(&regions));
        self.bounded_by.extend(regions);
    }

    /// Moves the object and everything attached to it so far.
    pub fn apply(&mut self, t: &Transform) {
        self.transform = self.transform.then(t);
        for a in self.textures.iter_mut().chain(&mut self.interior_textures).chain(&mut self.part_textures) {
            a.transform = a.transform.then(t);
        }
        if let Some(a) = &mut self.interior {
            a.transform = a.transform.then(t);
        }
        for o in self.clipped_by.iter_mut().chain(&mut self.bounded_by) {
            Arc::make_mut(o).apply(t);
        }
    }
}

fn deepest(objects: &[Arc<Object>]) -> u32 {
    objects.iter().map(|o| o.depth).max().unwrap_or(0)
}
