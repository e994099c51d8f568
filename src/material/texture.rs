use super::normal::Frame;
use super::{Finish, Normal, Pigment};
use crate::math::{Transform, Vec3};
use crate::pattern::image::ImageMap;
use crate::pattern::{BlendMap, Blended, Context, Incidence, Signal};
use smallvec::SmallVec;
use std::cell::Cell;
use std::sync::Arc;

/// Pigment, normal and finish together.
#[derive(Clone, Debug, Default)]
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

/// A texture chosen by a pattern.
#[derive(Clone, Debug)]
pub struct PatternedTexture {
    pub kind: PatternedKind,
    pub signal: Signal,
    /// Items of the map, list or average; of one item in a `uv_mapping`.
    pub map: BlendMap<Texture>,
    pub scale_bumps: bool,
    opaque: bool,
    depth: u32,
    cost: f64,
}

#[derive(Clone, Debug)]
pub enum PatternedKind {
    /// `texture_map`, lists.
    Blended,
    Average,
    /// The item that an image's index names.
    Material(ImageMap),
    /// The item at the surface's (u, v, 0).
    Uv,
}

/// One stack of plain layers that shows at a point, with its share of the colour.
#[derive(Clone, Debug)]
pub struct TextureSample<'a> {
    pub weight: f32,
    pub layers: &'a [Layer],
    /// The point in the layers' space, after the warps of all enclosing patterns.
    pub point: Vec3,
    /// The enclosing patterned textures, outermost first, which frame normals.
    frames: Frames<'a>,
}

impl TextureSample<'_> {
    /// The normal of one of the layers. `n` is in texture space, turned towards the ray; the result has unit
    /// length. (POV-Ray leaves it at any length after scaled textures with `no_bump_scale`, which makes them
    /// shine too brightly.)
    pub fn perturb(&self, layer: &Layer, n: Vec3, context: &Context) -> Vec3 {
        let Some(normal) = &layer.normal else { return n.normalize_or_zero() };
        let (mut inward, mut scale_bumps) = (n, true);
        for texture in &self.frames {
            scale_bumps &= texture.scale_bumps;
            inward = texture.frame(scale_bumps).enter(inward);
        }
        let mut outward = normal.perturb_within(inward, self.point, scale_bumps, context);
        for (i, texture) in self.frames.iter().enumerate().rev() {
            let scale_bumps = self.frames[..=i].iter().all(|t| t.scale_bumps);
            outward = texture.frame(scale_bumps).leave(outward);
        }
        outward.normalize_or_zero()
    }
}

/// What patterns that choose textures may ask about besides the point.
#[derive(Clone, Copy, Debug)]
pub struct View<'a> {
    pub context: Context<'a>,
    /// For textures that ask about the hit: the hit, and its normal after the most recent perturbation, which
    /// the layers visited so far leave behind.
    pub hit: Option<(&'a Incidence, &'a Cell<Vec3>)>,
}

impl View<'_> {
    fn value(&self, signal: &Signal, warped: Vec3) -> f64 {
        match self.hit {
            None => signal.value(warped, &self.context),
            Some((hit, normal)) => {
                let hit = Incidence { normal: normal.get(), ..*hit };
                signal.value(warped, &Context { hit: Some(&hit), ..self.context })
            }
        }
    }
}

type Frames<'a> = SmallVec<[&'a PatternedTexture; 2]>;

impl Texture {
    /// Calls `visit` with the stacks that show at `p` (in texture space), with weights that add to 1. What
    /// comes after a stack sees the normal that the stack leaves behind.
    #[inline]
    pub fn visit<'a>(&'a self, p: Vec3, view: &View, visit: &mut dyn FnMut(&TextureSample<'a>)) {
        self.gather(p, 1.0, &SmallVec::new(), view, visit);
    }

    fn gather<'a>(
        &'a self,
        point: Vec3,
        weight: f32,
        frames: &Frames<'a>,
        view: &View,
        visit: &mut dyn FnMut(&TextureSample<'a>),
    ) {
        match self {
            Texture::Layers(layers) => {
                visit(&TextureSample { weight, layers, point, frames: frames.clone() })
            }
            Texture::Patterned(texture) => {
                let mut frames = frames.clone();
                frames.push(texture);
                texture.gather(point, weight, &frames, view, visit);
            }
        }
    }

    /// Whether no point lets light through.
    pub fn is_opaque(&self) -> bool {
        match self {
            Texture::Layers(layers) => layers.iter().any(|layer| layer.pigment.is_opaque()),
            Texture::Patterned(texture) => texture.opaque,
        }
    }

    /// Whether some of it hangs on how a ray met the surface, not on the point alone.
    pub fn asks_hit(&self) -> bool {
        match self {
            Texture::Layers(layers) => layers.iter().any(Layer::asks_hit),
            Texture::Patterned(texture) => {
                matches!(texture.kind, PatternedKind::Uv)
                    || texture.signal.pattern.asks_hit()
                    || texture.map.items().any(Texture::asks_hit)
            }
        }
    }

    /// How deep textures, pigments and normals are nested.
    pub fn depth(&self) -> u32 {
        match self {
            Texture::Layers(layers) => layers.iter().map(Layer::depth).max().unwrap_or(0),
            Texture::Patterned(texture) => texture.depth,
        }
    }

    /// How many textures, pigments and normals are asked at one point at most.
    pub fn cost(&self) -> f64 {
        match self {
            Texture::Layers(layers) => layers.iter().map(Layer::cost).sum(),
            Texture::Patterned(texture) => texture.cost,
        }
    }

    /// Moves every pattern of the texture.
    pub fn transform(&mut self, t: &Transform) {
        match self {
            Texture::Layers(layers) => layers.iter_mut().for_each(|layer| layer.transform(t)),
            Texture::Patterned(texture) => Arc::make_mut(texture).signal.transform(t),
        }
    }
}

impl Layer {
    fn depth(&self) -> u32 {
        self.pigment.depth().max(self.normal.as_ref().map_or(0, |n| n.depth()))
    }

    fn cost(&self) -> f64 {
        self.pigment.cost() + self.normal.as_ref().map_or(0.0, |n| n.cost())
    }

    fn asks_hit(&self) -> bool {
        self.pigment.asks_hit() || self.normal.as_ref().is_some_and(|n| n.asks_hit())
    }

    /// Moves pigment and normal.
    pub fn transform(&mut self, t: &Transform) {
        Arc::make_mut(&mut self.pigment).transform(t);
        if let Some(normal) = &mut self.normal {
            Arc::make_mut(normal).transform(t);
        }
    }
}

impl PatternedTexture {
    pub fn new(kind: PatternedKind, signal: Signal, map: BlendMap<Texture>) -> Self {
        let opaque = map.items().all(Texture::is_opaque);
        let depth = 1 + map.items().map(Texture::depth).fold(signal.pattern.depth(), u32::max);
        let below = match kind {
            PatternedKind::Blended => map.cost(Texture::cost),
            PatternedKind::Average => map.items().map(Texture::cost).sum(),
            PatternedKind::Material(_) | PatternedKind::Uv => {
                map.items().map(Texture::cost).fold(0.0, f64::max)
            }
        };
        let cost = 1.0 + signal.pattern.cost() + below;
        Self { kind, signal, map, scale_bumps: true, opaque, depth, cost }
    }

    fn frame(&self, scale_bumps: bool) -> Frame<'_> {
        Frame { chain: &self.signal.chain, scale_bumps }
    }

    /// An index above the number of textures goes around; one that equals it means the last.
    fn material(&self, image: &ImageMap, q: Vec3) -> &Texture {
        let count = self.map.len();
        let index = image.coordinates(q).map_or(0, |(u, v)| image.material_at(u, v) as usize);
        self.map.item(if index > count { index % count } else { index })
    }

    fn gather<'a>(
        &'a self,
        p: Vec3,
        weight: f32,
        frames: &Frames<'a>,
        view: &View,
        visit: &mut dyn FnMut(&TextureSample<'a>),
    ) {
        match &self.kind {
            PatternedKind::Blended => {
                let q = self.signal.warp(p);
                match self.map.at(view.value(&self.signal, q)) {
                    Blended::One(texture) => texture.gather(q, weight, frames, view, visit),
                    Blended::Two(t, low, high) => {
                        // In this order they leave their normals behind.
                        high.gather(q, weight * t as f32, frames, view, visit);
                        low.gather(q, weight * (1.0 - t) as f32, frames, view, visit);
                    }
                }
            }
            PatternedKind::Average => {
                let (q, total) = (self.signal.warp_alone(p), self.map.total_weight());
                for (share, texture) in self.map.iter() {
                    texture.gather(q, weight * (share / total) as f32, frames, view, visit);
                }
            }
            PatternedKind::Material(image) => {
                let q = self.signal.warp_alone(p);
                self.material(image, q).gather(q, weight, frames, view, visit);
            }
            PatternedKind::Uv => {
                let q = view.hit.map_or(p, |(hit, _)| hit.uv.extend(0.0));
                self.map.item(0).gather(q, weight, frames, view, visit);
            }
        }
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interp::interpret_str;
    use crate::pattern::NoiseGenerator;

    /// As the reference does: where a texture that asks for slopes stands twice in a map, the second look sees the
    /// bumps of the first, and the first has the share of the upper key.
    #[test]
    fn of_two_blended_textures_the_upper_comes_first() {
        let text = "#version 3.7; global_settings { assumed_gamma 1 }
            plane { y, 0 texture { gradient x texture_map {
              [0 slope y texture_map { [0.9 pigment { rgb 0 }] [0.9 pigment { rgb 1 }] }]
              [1 slope y texture_map { [0.9 pigment { rgb 0 }] [0.9 pigment { rgb 1 }] }] } } }";
        let scene = interpret_str(text).scene.unwrap();
        let texture = &scene.objects[0].textures[0].value;
        let hit = Incidence {
            point: Vec3::new(0.125, 0.0, 0.0),
            normal: Vec3::Y,
            direction: -Vec3::Y,
            uv: crate::math::Vec2::ZERO,
        };
        let context = Context { noise: NoiseGenerator::RangeCorrected, waves: 10, hit: None };
        let (normal, mut seen) = (Cell::new(Vec3::Y), Vec::new());
        texture.visit(hit.point, &View { context, hit: Some((&hit, &normal)) }, &mut |sample| {
            seen.push((sample.weight, sample.layers[0].pigment.plain().unwrap().rgb.x));
            normal.set(Vec3::X);
        });
        assert_eq!(seen, [(0.125, 1.0), (0.875, 0.0)]);
    }
}
