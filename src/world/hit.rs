use crate::color::Rgb;
use crate::material::{Attached, Layer, Texture};
use crate::math::{Aabb, Transform, Vec3};
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
    /// surface starts this far along `face`, on the side that it goes to.
    pub error: f64,
    /// The point in the object's own space.
    pub local: Vec3,
    pub crossing: Crossing,
    /// Unit normal in world space; outward, turned inward for inverted objects; not turned to the ray.
    pub normal: Vec3,
    /// The surface's own unit normal, where `normal` is interpolated; else the same as `normal`.
    pub face: Vec3,
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
    /// Towards a light, past objects that let light through: those that do not are known to be out of the
    /// way.
    Filtered,
    /// A photon, and one with a reflection in its history.
    Photon,
    ReflectedPhoton,
}

/// What stands between a point and a lamp.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Obstacle<T> {
    None,
    /// Something that no light passes.
    Opaque,
    /// Nothing opaque, and this is met first.
    Filter(T),
}

impl RayClass {
    /// The class's bit in a set.
    pub(super) fn bit(self) -> u8 {
        1 << self as u8
    }
}

/// What an object does with photons. Switches that were not written are `None`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PhotonRules {
    /// The target in `World::targets` that the object is, or is part of.
    pub target: Option<u32>,
    pub refraction: Option<bool>,
    pub reflection: Option<bool>,
    pub pass_through: bool,
    pub collect: bool,
}

impl PhotonRules {
    pub(super) const NONE: PhotonRules =
        PhotonRules { target: None, refraction: None, reflection: None, pass_through: false, collect: true };
}

/// An object that photons are shot at.
#[derive(Clone, Copy, Debug)]
pub struct PhotonTarget {
    pub bounds: Aabb,
    pub density: f32,
    pub rules: PhotonRules,
    pub ignores_global_lights: bool,
}

/// What objects tell the shading of their hits; few differ, so they are shared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Shading {
    pub ignores_global_lights: bool,
    pub double_illuminate: bool,
    pub group_lights: (u32, u32),
    pub uv_mapping: bool,
    pub opaque: bool,
    /// Bits of the radiosity importance, if the object says something about it.
    pub importance: Option<u32>,
    pub photons: PhotonRules,
}

/// A texture as it sits on one object: layers bottom first, each with its own placement.
#[derive(Debug)]
pub struct Surface {
    pub layers: Vec<SurfaceLayer>,
    /// Whether some layer lets no light through anywhere.
    pub opaque: bool,
    /// What all layers let through, if that is the same everywhere.
    pub filter: Option<Rgb>,
    /// Whether some layer hangs on how a ray met the surface, not on the point alone.
    pub asks_hit: bool,
    /// Whether there is just one layer, opaque everywhere, without light from below and thin films.
    pub plain: bool,
}

impl Surface {
    pub(super) fn new(layers: Vec<SurfaceLayer>) -> Self {
        let opaque = layers.iter().any(|l| l.texture.is_opaque());
        let mut filter = Some(Rgb::ONE);
        for layer in layers.iter().rev() {
            let own = match &*layer.texture {
                Texture::Layers(plain) => {
                    plain.iter().rev().try_fold(Rgb::ONE, |f, l| Some(f * l.pigment.plain()?.transmittance()))
                }
                Texture::Patterned(_) => None,
            };
            filter = filter.zip(own).map(|(a, b)| a * b);
        }
        let asks_hit = layers.iter().any(|l| l.texture.asks_hit());
        let mut surface = Self { layers, opaque, filter, asks_hit, plain: false };
        surface.plain = opaque
            && !asks_hit
            && surface.sole_layer().is_some_and(|l| l.finish.irid == 0.0 && l.finish.subsurface.is_none());
        surface
    }

    /// The layer, if there is just one, the same everywhere.
    pub fn sole_layer(&self) -> Option<&Layer> {
        let [only] = &self.layers[..] else { return None };
        match &*only.texture {
            Texture::Layers(layers) if layers.len() == 1 => layers.first(),
            _ => None,
        }
    }
}

#[derive(Debug)]
pub struct SurfaceLayer {
    pub texture: Arc<Texture>,
    /// Takes texture space to the object's own space; `None` if they are the same.
    pub texture_to_local: Option<Box<Transform>>,
    /// Takes texture space to world space; `None` if they are the same. Frames normals.
    pub texture_to_world: Option<Box<Transform>>,
}

impl SurfaceLayer {
    /// `attached` is placed in world space, on a shape that stands at `shape_to_world`.
    pub(super) fn new(attached: &Attached<Texture>, shape_to_world: &Transform) -> Self {
        let to_world = attached.transform;
        let to_local = if to_world == *shape_to_world {
            Transform::IDENTITY
        } else {
            to_world.then(&shape_to_world.inverted())
        };
        let kept = |t: Transform| (!t.is_identity()).then(|| Box::new(t));
        Self {
            texture: attached.value.clone(),
            texture_to_local: kept(to_local),
            texture_to_world: kept(to_world),
        }
    }

    /// Tells equal layers: the texture's address and both placements to the bit.
    pub(super) fn key(&self) -> (usize, [u64; 24]) {
        let bits = |t: &Option<Box<Transform>>| {
            let t = t.as_ref().map_or(Transform::IDENTITY, |t| **t);
            t.forward.to_cols_array().map(f64::to_bits)
        };
        let (a, b) = (bits(&self.texture_to_local), bits(&self.texture_to_world));
        let key = std::array::from_fn(|i| if i < 12 { a[i] } else { b[i - 12] });
        (Arc::as_ptr(&self.texture) as usize, key)
    }
}
