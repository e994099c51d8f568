use super::Finish;
use crate::color::Color;
use crate::math::{Transform, Vec3};
use crate::pattern::Context;
use smallvec::SmallVec;
use std::sync::Arc;

/// A colour at every point.
#[derive(Clone, Debug)]
pub struct Pigment {}

impl Pigment {
    /// The colour at `p` in pigment space; `None` outside an image mapped `once`.
    pub fn color(&self, _p: Vec3, _context: &Context) -> Option<Color> {
        todo!()
    }

    /// The colour if it is the same everywhere.
    pub fn plain(&self) -> Option<Color> {
        todo!()
    }

    /// Whether no point lets light through.
    pub fn is_opaque(&self) -> bool {
        todo!()
    }
}

/// A perturbation of surface normals.
#[derive(Clone, Debug)]
pub struct Normal {}

impl Normal {
    /// Perturbs `n` at `p`, both in the space that the normal statement is attached in. `n` is turned
    /// towards the ray and need not have unit length; the result has.
    pub fn perturb(&self, _n: Vec3, _p: Vec3, _context: &Context) -> Vec3 {
        todo!()
    }
}

/// Pigment, normal and finish together.
#[derive(Clone, Debug)]
pub struct Layer {
    pub pigment: Arc<Pigment>,
    pub normal: Option<Arc<Normal>>,
    pub finish: Arc<Finish>,
}

/// A texture: layers from bottom to top, or a pattern that chooses between textures.
#[derive(Clone, Debug)]
pub enum Texture {
    Layers(Vec<Layer>),
    Patterned(Arc<PatternedTexture>),
}

/// A texture chosen by a pattern (`texture_map`, lists, `material_map`, `average`, `uv_mapping`).
#[derive(Clone, Debug)]
pub struct PatternedTexture {}

/// One stack of plain layers that shows at a point, with its share of the colour.
#[derive(Clone, Debug)]
pub struct TextureSample<'a> {
    pub weight: f32,
    pub layers: &'a [Layer],
    /// The point in the layers' space, after the warps of all enclosing patterns.
    pub point: Vec3,
    /// Plain transforms of the enclosing patterned textures, outermost first, which frame normals.
    pub frames: SmallVec<[Transform; 2]>,
}

impl Texture {
    /// The stacks that show at `p` (in texture space), with weights that add to 1.
    pub fn samples<'a>(&'a self, _p: Vec3, _context: &Context, _out: &mut SmallVec<[TextureSample<'a>; 2]>) {
        todo!()
    }

    /// Whether no point lets light through.
    pub fn is_opaque(&self) -> bool {
        todo!()
    }
}

/// Something attached to an object, moved by the transformations written after it.
#[derive(Clone, Debug)]
pub struct Attached<T> {
    pub value: Arc<T>,
    /// Takes the value's own space to the object's outer space.
    pub transform: Transform,
}

impl<T> Attached<T> {
    pub fn new(value: Arc<T>) -> Self {
        Self { value, transform: Transform::IDENTITY }
    }
}
