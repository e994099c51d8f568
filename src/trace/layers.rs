//! A surface's texture at a hit, taken apart into stacks of plain layers.

use crate::color::Color;
use crate::material::{Layer, Texture, TextureSample, View};
use crate::math::{Transform, Vec3};
use crate::pattern::{Context, Incidence};
use crate::world::{Hit, Surface};
use smallvec::SmallVec;
use std::cell::Cell;

/// A layer where it lies at the hit.
#[derive(Clone, Copy)]
pub(super) struct Placed<'w, 'a> {
    pub layer: &'w Layer,
    /// The hit in the layer's space.
    point: Vec3,
    to_world: Option<&'w Transform>,
    /// The way through patterned textures, if the layer stands in one.
    sample: Option<&'a TextureSample<'w>>,
    /// Whether the texture hangs on how the ray met the surface.
    pub asks_hit: bool,
}

impl Placed<'_, '_> {
    /// The unit shading normal, for the unit normal `facing` towards the viewer.
    pub fn normal(&self, facing: Vec3, context: &Context) -> Vec3 {
        let Some(normal) = &self.layer.normal else { return facing };
        let n = self.to_world.map_or(facing, |t| t.inverse_normal(facing));
        let n = match self.sample {
            Some(sample) => sample.perturb(self.layer, n, context),
            None => normal.perturb(n, self.point, context),
        };
        self.to_world.map_or(n, |t| t.normal(n).normalize())
    }

    /// The pigment; `None` outside of an image that is used once.
    pub fn color(&self, context: &Context) -> Option<Color> {
        self.layer.pigment.color(self.point, context)
    }
}

/// The layer of a surface that has just one, whose texture is not mapped by uv.
#[inline]
pub(super) fn sole<'w, 'a>(surface: &'w Surface, hit: &Hit) -> Option<Placed<'w, 'a>> {
    let [l] = &surface.layers[..] else { return None };
    let Texture::Layers(layers) = &*l.texture else { return None };
    let point = l.texture_to_local.as_ref().map_or(hit.local, |t| t.inverse_point(hit.local));
    let to_world = l.texture_to_world.as_deref();
    Some(Placed { layer: layers.first()?, point, to_world, sample: None, asks_hit: surface.asks_hit })
}

/// Calls `visit` with each stack that shows at the hit, top layer first, and its share. `normal` is the hit's
/// after the most recent perturbation, which `visit` keeps up to date.
pub(super) fn stacks<'w, 'i>(
    surface: &'w Surface,
    hit: &Hit,
    context: &Context,
    incidence: impl Fn() -> &'i Incidence,
    normal: &Cell<Vec3>,
    mut visit: impl FnMut(f32, &[Placed<'w, '_>]),
) {
    let place = |to_local: &Option<Box<Transform>>| {
        if hit.uv_mapping {
            incidence().uv.extend(0.0)
        } else {
            to_local.as_ref().map_or(hit.local, |t| t.inverse_point(hit.local))
        }
    };
    let frame = |to_world: &'w Option<Box<Transform>>| {
        if hit.uv_mapping { None } else { to_world.as_deref() }
    };
    let asks_hit = surface.asks_hit;
    if let [l] = &surface.layers[..]
        && let Texture::Layers(layers) = &*l.texture
        && let [layer] = &layers[..]
    {
        let (point, to_world) = (place(&l.texture_to_local), frame(&l.texture_to_world));
        return visit(1.0, &[Placed { layer, point, to_world, sample: None, asks_hit }]);
    }
    let mut stack: SmallVec<[Placed<'w, '_>; 2]> = SmallVec::new();
    for l in surface.layers.iter().rev() {
        let (point, to_world) = (place(&l.texture_to_local), frame(&l.texture_to_world));
        match &*l.texture {
            Texture::Layers(layers) => {
                for layer in layers.iter().rev() {
                    stack.push(Placed { layer, point, to_world, sample: None, asks_hit });
                }
            }
            // Nothing can be layered with a patterned texture.
            Texture::Patterned(_) => {
                let hit = asks_hit.then(|| (incidence(), normal));
                l.texture.visit(point, &View { context: *context, hit }, &mut |s| {
                    let layers = s.layers.iter().rev();
                    let stack: SmallVec<[Placed; 2]> = layers
                        .map(|layer| Placed { layer, point: s.point, to_world, sample: Some(s), asks_hit })
                        .collect();
                    visit(s.weight, &stack);
                });
                return;
            }
        }
    }
    visit(1.0, &stack);
}
