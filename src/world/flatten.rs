//! Objects as the author nested them to leaves in world space.
//!
//! Transforms are worked out down to the shapes; textures, interiors and flags are inherited; inversion is
//! pushed down to the leaves (an inverted union is an intersection of inverted children); top-level unions
//! are taken apart.

use super::accel::Accel;
use super::compound::{Child, Compound, Extent, Op};
use super::geometry::{Geometry, Leaf, NONE, Root, Solid};
use super::hit::{InteriorId, PhotonRules, PhotonTarget, RayClass, Shading, Surface, SurfaceLayer};
use super::placement::Placement;
use super::probe::Reach;
use super::{Inside, WorldLight};
use crate::material::{Attached, Texture};
use crate::math::bvh::{Bvh, Quality};
use crate::math::{Aabb, Transform, Vec3};
use crate::scene::{Body, CsgOp, Flags, LightSource, Object};
use crate::shape::common::{self, Member};
use std::collections::HashMap;
use std::rc::Rc;
use std::sync::Arc;

/// From this many children on a combination gets a tree of its own.
const TREE_FROM: usize = 8;

/// Everything that flattening makes.
#[derive(Debug, Default)]
pub(super) struct Flattened {
    pub geometry: Geometry,
    pub surfaces: Vec<Surface>,
    pub part_surfaces: Vec<u32>,
    pub shadings: Vec<Shading>,
    pub interiors: Vec<Inside>,
    pub lights: Vec<WorldLight>,
    pub group_lights: Vec<WorldLight>,
    /// What photons are shot at.
    pub targets: Vec<PhotonTarget>,
    /// Objects that lights shine through, by [`WorldLight::projected_through`].
    pub projectors: Vec<Solid>,
    /// For questions of the scene language, whose extents the boxes are.
    asked: bool,
    /// The last leaf's: siblings mostly stand in one place.
    last_place: Option<Arc<Placement>>,
    surface_numbers: HashMap<SurfaceKey, u32>,
    shading_numbers: HashMap<Shading, u32>,
}

/// Texture and both placements, to the bit.
type SurfaceKey = Vec<(usize, [u64; 24])>;

/// A texture list in world space.
type Textures = Rc<Vec<Attached<Texture>>>;

/// What a child takes from what it stands in.
#[derive(Clone)]
struct Inherited {
    to_world: Transform,
    textures: Option<Textures>,
    interior_textures: Option<Textures>,
    interior: Option<InteriorId>,
    flags: Flags,
    uv_mapping: bool,
    inverted: bool,
    cutaway: u32,
    group_lights: (u32, u32),
    ignores_global_lights: bool,
    importance: Option<f32>,
    photons: PhotonRules,
    /// Crossings of others survive where this contains them, so bounds are of the inside.
    in_intersection: bool,
    /// A member of a combination.
    is_member: bool,
    /// Inside a light group: its lights have been gathered already.
    in_group: bool,
}

impl Inherited {
    fn top() -> Self {
        Self {
            to_world: Transform::IDENTITY,
            textures: None,
            interior_textures: None,
            interior: None,
            flags: Flags::default(),
            uv_mapping: false,
            inverted: false,
            cutaway: NONE,
            group_lights: (0, 0),
            ignores_global_lights: false,
            importance: None,
            photons: PhotonRules::NONE,
            in_intersection: false,
            is_member: false,
            in_group: false,
        }
    }
}

/// A solid in the geometry.
struct Built {
    solid: Solid,
    /// Of what rays may see of it.
    bounds: Aabb,
    extent: Extent,
}

impl Built {
    fn child(self) -> Child {
        let reach = Reach::new(&self.bounds.intersection(self.extent.surface));
        let tight = matches!(self.solid, Solid::Leaf(_)) && self.extent.surface == self.extent.hull;
        Child { solid: self.solid, reach, extent: self.extent, tight }
    }

    /// The same as something that only keeps what it contains.
    fn clip(self) -> Child {
        let Extent { hull, .. } = self.extent;
        Child { solid: self.solid, reach: Reach::new(&hull), extent: self.extent, tight: hull.is_finite() }
    }
}

/// Room for points that count as inside although rounding put them just outside.
fn slightly_grown(b: Aabb) -> Aabb {
    let size = |v: Vec3| v.map(|c| if c.is_finite() { c.abs() } else { 0.0 }).max_element();
    b.grown(1e-9 * (size(b.min) + size(b.max)))
}

impl Flattened {
    pub fn new(objects: &[Arc<Object>], accel: Accel) -> Self {
        let mut flat = Flattened::default();
        for object in objects {
            flat.top(object, &Inherited::top());
        }
        flat.geometry.finish(accel);
        flat
    }

    /// One object alone, for questions asked while the text is read.
    pub fn of_one(object: &Object) -> (Self, Solid, Aabb) {
        let mut flat = Flattened { asked: true, ..Flattened::default() };
        let built = flat.solid(object, &Inherited::top());
        let (solid, bounds) = built.map_or_else(|| (flat.nothing(), Aabb::EMPTY), |b| (b.solid, b.bounds));
        (flat, solid, bounds)
    }

    /// A top-level object: unions fall apart, lights go to their list, the rest becomes a root.
    fn top(&mut self, object: &Object, outer: &Inherited) {
        match &object.body {
            Body::Light(source) => {
                if !outer.in_group {
                    self.light(source, &object.transform.then(&outer.to_world), false);
                }
            }
            Body::Csg { op: CsgOp::Union | CsgOp::LightGroup { .. }, children } if splits(object, outer) => {
                let target = self.targets.len();
                let inner = self.inherit(object, outer);
                let first = self.geometry.root_bounds.len();
                for child in children.iter() {
                    self.top(child, &inner);
                }
                let parts = &self.geometry.root_bounds[first..];
                let bounds = parts.iter().fold(Aabb::EMPTY, |a, b| a.union(*b));
                self.aim_at(target, object, outer, bounds);
            }
            _ => self.root(object, outer),
        }
    }

    fn root(&mut self, object: &Object, outer: &Inherited) {
        let first_leaf = self.geometry.leaves.len();
        let Some(Built { solid, bounds, .. }) = self.solid(object, outer) else { return };
        let flags = merged(&object.flags, &outer.flags);
        let leaves = &self.geometry.leaves[first_leaf..];
        let opaque = leaves.iter().all(|l| self.shadings[l.shading as usize].opaque);
        let interior = match solid {
            Solid::Leaf(i) => self.geometry.leaves[i as usize].interior,
            Solid::Compound(_) => leaves.first().map_or(InteriorId(0), |l| l.interior),
        };
        self.geometry.roots.push(Root { solid, interior, hidden: hidden(&flags, opaque), opaque });
        self.geometry.root_bounds.push(bounds);
    }

    /// A shape or a combination in world space; `None` for lights.
    fn solid(&mut self, object: &Object, outer: &Inherited) -> Option<Built> {
        let target = self.targets.len();
        let Built { solid, mut bounds, extent } = match &object.body {
            Body::Light(source) => {
                if !outer.in_group {
                    self.light(source, &object.transform.then(&outer.to_world), false);
                }
                return None;
            }
            Body::Shape(_) => self.leaf(object, outer),
            Body::Csg { op, children } => self.csg(*op, children, object, outer),
        };
        let clips: Vec<Built> =
            object.clipped_by.iter().filter_map(|c| self.solid(c, &region(outer))).collect();
        // What clips and bounds enclose is the surface; an inverted solid reaches beyond it.
        let reaches_beyond = outer.inverted != object.flags.inverse;
        if !reaches_beyond {
            bounds = clips.iter().fold(bounds, |b, clip| b.intersection(clip.bounds));
        }
        let gates: Vec<Built> =
            object.bounded_by.iter().filter_map(|b| self.solid(b, &region(outer))).collect();
        let keeps = keeps_bounds(object) || outer.is_member || self.asked;
        let hull = bounds;
        if !reaches_beyond {
            bounds = shrunk(bounds, object, &gates);
        }
        self.aim_at(target, object, outer, bounds);
        let limits = |gate: &Built| keeps && !self.encloses(gate, &hull);
        let gates: Vec<Solid> = gates.into_iter().filter(limits).map(|g| g.solid).collect();
        if clips.is_empty() && gates.is_empty() {
            return Some(Built { solid, bounds, extent });
        }
        let clips: Vec<Child> = clips.into_iter().map(Built::clip).collect();
        let clipped = extent.clipped(&clips);
        if let Solid::Compound(i) = solid
            && let compound = &mut self.geometry.compounds[i as usize]
            && compound.clips.is_empty()
            && compound.gates.is_empty()
        {
            (compound.clips, compound.gates) = (clips, gates);
            return Some(Built { solid, bounds, extent: clipped });
        }
        let wrapper = Compound {
            children: vec![Built { solid, bounds, extent }.child()],
            clips,
            gates,
            ..Compound::nothing()
        };
        Some(Built { solid: self.compound(wrapper), bounds, extent: clipped })
    }

    fn place(&mut self, to_world: Transform) -> Option<Arc<Placement>> {
        if to_world.is_identity() {
            return None;
        }
        if self.last_place.as_ref().is_none_or(|last| last.transform != to_world) {
            self.last_place = Some(Arc::new(Placement::new(to_world)));
        }
        self.last_place.clone()
    }

    fn leaf(&mut self, object: &Object, outer: &Inherited) -> Built {
        let Body::Shape(shape) = &object.body else { unreachable!("leaf of a combination") };
        let inner = self.inherit(object, outer);
        let to_world = inner.to_world;
        let own_texture = inner.textures.is_some();
        let surface = inner.textures.as_ref().map_or(NONE, |t| self.surface(t, &to_world));
        let interior_surface = inner.interior_textures.as_ref().map_or(NONE, |t| self.surface(t, &to_world));
        let parts = self.part_surfaces.len() as u32;
        for part in &object.part_textures {
            let placed =
                Attached { value: part.value.clone(), transform: part.transform.then(&outer.to_world) };
            let number = self.surface(&[placed], &to_world);
            self.part_surfaces.push(number);
        }
        let opaque_parts =
            self.part_surfaces[parts as usize..].iter().all(|&s| self.surfaces[s as usize].opaque);
        let opaque_of = |s: u32| s == NONE || self.surfaces[s as usize].opaque;
        let shading = Shading {
            ignores_global_lights: inner.ignores_global_lights,
            double_illuminate: inner.flags.double_illuminate,
            group_lights: inner.group_lights,
            uv_mapping: inner.uv_mapping,
            opaque: opaque_of(surface) && opaque_of(interior_surface) && opaque_parts,
            importance: inner.importance.map(f32::to_bits),
            photons: inner.photons,
        };
        let shading = self.shading(shading);
        let inverted = inner.inverted && shape.is_solid();
        let replacement = if inverted { shape.inverse() } else { None };
        let inverted = inverted && replacement.is_none();
        let shape = replacement.unwrap_or_else(|| shape.clone());
        let shape = shape.placed(&to_world).unwrap_or(shape);
        let bounds = if inverted || (self.asked && !shape.has_extent()) {
            Aabb::INFINITE
        } else if outer.in_intersection {
            to_world.bounds(&shape.inside_bounds())
        } else if self.asked {
            to_world.bounds(&shape.extent())
        } else {
            to_world.bounds(&shape.bounds())
        };
        let extent = Extent {
            surface: slightly_grown(to_world.bounds(&shape.bounds())),
            hull: slightly_grown(to_world.bounds(&shape.inside_bounds())),
            outside: inverted,
        };
        let place = self.place(to_world);
        self.geometry.leaves.push(Leaf {
            shape,
            place,
            surface,
            interior_surface,
            parts,
            has_parts: !object.part_textures.is_empty(),
            shading,
            cutaway: if own_texture { NONE } else { inner.cutaway },
            interior: inner.interior.unwrap_or(InteriorId(0)),
            inverted,
        });
        Built { solid: Solid::Leaf(self.geometry.leaves.len() as u32 - 1), bounds, extent }
    }

    fn csg(&mut self, op: CsgOp, children: &[Arc<Object>], object: &Object, outer: &Inherited) -> Built {
        let mut inner = self.inherit(object, outer);
        inner.is_member = true;
        inner.in_intersection |= effective(op, inner.inverted) == Op::Intersection;
        let slot = self.reserve();
        if object.flags.cutaway_textures && inner.textures.is_none() {
            inner.cutaway = slot;
        }
        let mut built = Vec::with_capacity(children.len());
        let mut first = true;
        for child in children {
            let is_light = matches!(child.body, Body::Light(_));
            let mut taken = inner.clone();
            if op == CsgOp::Difference && !first {
                taken.inverted = !taken.inverted;
            }
            first &= is_light;
            built.extend(self.solid(child, &taken));
        }
        let child_bounds: Vec<Aabb> = built.iter().map(|b| b.bounds).collect();
        let op = effective(op, inner.inverted);
        let (bounds, common) = match op {
            Op::Intersection => {
                let all = child_bounds.iter().fold(Aabb::INFINITE, |a, b| a.intersection(*b));
                let common = self.common(&built, all);
                (all.intersection(common), common)
            }
            Op::Union | Op::Merge => {
                (child_bounds.iter().fold(Aabb::EMPTY, |a, b| a.union(*b)), Aabb::INFINITE)
            }
        };
        let tree = (built.len() >= TREE_FROM
            && op != Op::Intersection
            && child_bounds.iter().all(|b| b.is_finite()))
        .then(|| Bvh::build(&child_bounds, Quality::Best));
        let children: Vec<Child> = built.into_iter().map(Built::child).collect();
        let mut extent = Extent::combined(op, &children);
        if !extent.outside {
            extent.surface = extent.surface.intersection(common);
            extent.hull = extent.hull.intersection(common);
        }
        let mut compound = Compound { op, tree, ..Compound::nothing() };
        if compound.tree.is_some() {
            compound.children = children;
        } else {
            children.into_iter().for_each(|child| compound.absorb(&self.geometry, child));
        }
        compound.enclose(&extent);
        self.geometry.compounds[slot as usize] = compound;
        Built { solid: Solid::Compound(slot), bounds, extent }
    }

    /// A box around what the members of an intersection have in common.
    fn common(&self, members: &[Built], bounds: Aabb) -> Aabb {
        let member = |built: &Built| {
            let Solid::Leaf(leaf) = built.solid else { return None };
            let leaf = &self.geometry.leaves[leaf as usize];
            let place = leaf.place.as_ref().map_or(&Transform::IDENTITY, |p| &p.transform);
            Some(Member { shape: &*leaf.shape, place, inverted: leaf.inverted })
        };
        common::bounds(&members.iter().filter_map(member).collect::<Vec<_>>(), bounds)
    }

    /// Whether a bounding object plainly holds all of a box, so that no ray can miss it and meet the box.
    fn encloses(&self, gate: &Built, b: &Aabb) -> bool {
        let Solid::Leaf(leaf) = gate.solid else { return false };
        let leaf = &self.geometry.leaves[leaf as usize];
        let convex = matches!(leaf.shape.kind(), "box" | "sphere") && !leaf.inverted;
        convex
            && b.is_finite()
            && b.corners().iter().all(|&corner| self.geometry.contains(gate.solid, corner))
    }

    /// What the children (or the shape) of `object` stand in.
    fn inherit(&mut self, object: &Object, outer: &Inherited) -> Inherited {
        let placed = |list: &Vec<Attached<Texture>>| {
            let place = |a: &Attached<Texture>| Attached {
                value: a.value.clone(),
                transform: a.transform.then(&outer.to_world),
            };
            (!list.is_empty()).then(|| Rc::new(list.iter().map(place).collect::<Vec<_>>()))
        };
        let interior = self.interior(object, outer);
        let own = placed(&object.textures);
        let uv_mapping = object.flags.uv_mapping || (own.is_none() && outer.uv_mapping);
        let mut inner = Inherited {
            to_world: object.transform.then(&outer.to_world),
            textures: own.or_else(|| outer.textures.clone()),
            interior_textures: placed(&object.interior_textures).or_else(|| outer.interior_textures.clone()),
            interior: Some(interior),
            flags: merged(&object.flags, &outer.flags),
            uv_mapping,
            inverted: outer.inverted != object.flags.inverse,
            importance: object.importance.or(outer.importance),
            photons: self.photon_rules(object, outer),
            ..outer.clone()
        };
        if let Body::Csg { op: CsgOp::LightGroup { global_lights }, children } = &object.body {
            self.enter_group(&mut inner, children, *global_lights);
        }
        inner
    }

    /// The object's own words about photons, else those of what it stands in. The outermost object that is
    /// a target is shot at as a whole.
    fn photon_rules(&mut self, object: &Object, outer: &Inherited) -> PhotonRules {
        let (own, outer_rules) = (&object.photons, &outer.photons);
        let mut rules = PhotonRules {
            target: outer_rules.target,
            refraction: own.refraction.or(outer_rules.refraction),
            reflection: own.reflection.or(outer_rules.reflection),
            pass_through: own.pass_through || outer_rules.pass_through,
            collect: own.collect && outer_rules.collect,
        };
        if let (None, Some(density)) = (rules.target, own.target) {
            rules.target = Some(self.targets.len() as u32);
            let ignores_global_lights = outer.ignores_global_lights;
            self.targets.push(PhotonTarget { bounds: Aabb::EMPTY, density, rules, ignores_global_lights });
        }
        rules
    }

    /// Notes where target number `target` is, if `object` is a new one.
    fn aim_at(&mut self, target: usize, object: &Object, outer: &Inherited, bounds: Aabb) {
        if object.photons.target.is_some() && outer.photons.target.is_none() {
            self.targets[target].bounds = bounds;
        }
    }

    /// Gathers the lights of a light group, after those of the groups around it.
    fn enter_group(&mut self, inner: &mut Inherited, children: &[Arc<Object>], global_lights: bool) {
        let first = self.group_lights.len();
        for i in inner.group_lights.0..inner.group_lights.1 {
            let outer = self.group_lights[i as usize].clone();
            self.group_lights.push(outer);
        }
        self.lights_of_group(children, &inner.to_world.clone());
        inner.group_lights = (first as u32, self.group_lights.len() as u32);
        inner.ignores_global_lights = !global_lights;
        inner.in_group = true;
    }

    fn lights_of_group(&mut self, children: &[Arc<Object>], to_world: &Transform) {
        for child in children {
            let here = child.transform.then(to_world);
            match &child.body {
                Body::Light(source) => self.light(source, &here, true),
                Body::Csg { op: CsgOp::Union, children } => self.lights_of_group(children, &here),
                _ => {}
            }
        }
    }

    fn light(&mut self, source: &LightSource, to_world: &Transform, in_group: bool) {
        let outer = Inherited { to_world: *to_world, ..Inherited::top() };
        if let Some(body) = &source.looks_like {
            let mut body = (**body).clone();
            body.flags.no_shadow = true;
            self.top(&body, &outer);
        }
        let projector = source.projected_through.as_ref().and_then(|o| self.solid(o, &outer));
        let projected_through = projector.map(|b| {
            self.projectors.push(b.solid);
            self.projectors.len() as u32 - 1
        });
        let light = source.light.transformed(to_world).prepared();
        let plain = projected_through.is_none() && light.is_plain();
        let light = WorldLight { light, projected_through, number: 0, plain };
        if in_group { self.group_lights.push(light) } else { self.lights.push(light) }
    }

    /// The object's own interior, else that of what it stands in, else a new default one.
    fn interior(&mut self, object: &Object, outer: &Inherited) -> InteriorId {
        let hollow = object.flags.hollow.or(outer.flags.hollow).unwrap_or(false);
        let old_words = old_words(&object.textures);
        if object.interior.is_none()
            && old_words == (None, None)
            && let Some(shared) = outer.interior
        {
            return shared;
        }
        let own = object.interior.as_ref();
        let shared = outer.interior.map(|id| self.interiors[id.0 as usize].interior.clone());
        let mut interior = own.map(|a| a.value.clone()).or(shared).unwrap_or_default();
        if let Some(ior) = old_words.0 {
            Arc::make_mut(&mut interior).ior = ior;
        }
        if let Some(caustics) = old_words.1 {
            Arc::make_mut(&mut interior).caustics = caustics;
        }
        let transform = own.map_or(outer.to_world, |a| a.transform.then(&outer.to_world));
        self.interiors.push(Inside { interior, transform, hollow });
        InteriorId(self.interiors.len() as u32 - 1)
    }

    /// The number of a placed texture list on a shape that stands at `to_world`.
    fn surface(&mut self, textures: &[Attached<Texture>], to_world: &Transform) -> u32 {
        let layers: Vec<SurfaceLayer> = textures.iter().map(|a| SurfaceLayer::new(a, to_world)).collect();
        let key: SurfaceKey = layers.iter().map(SurfaceLayer::key).collect();
        if let Some(&number) = self.surface_numbers.get(&key) {
            return number;
        }
        self.surfaces.push(Surface::new(layers));
        let number = self.surfaces.len() as u32 - 1;
        self.surface_numbers.insert(key, number);
        number
    }

    fn shading(&mut self, shading: Shading) -> u32 {
        *self.shading_numbers.entry(shading).or_insert_with(|| {
            self.shadings.push(shading);
            self.shadings.len() as u32 - 1
        })
    }

    fn reserve(&mut self) -> u32 {
        self.geometry.compounds.push(Compound::nothing());
        self.geometry.compounds.len() as u32 - 1
    }

    fn compound(&mut self, compound: Compound) -> Solid {
        let slot = self.reserve();
        self.geometry.compounds[slot as usize] = compound;
        Solid::Compound(slot)
    }

    fn nothing(&mut self) -> Solid {
        Solid::Compound(self.reserve())
    }
}

/// `ior` and `caustics` that stand in a finish, as the oldest scenes have them: they belong to the interior
/// if the texture is a plain one. Such a `caustics` is 45 times weaker than the interior's.
fn old_words(textures: &[Attached<Texture>]) -> (Option<f32>, Option<f32>) {
    let mut words = (None, None);
    for texture in textures {
        if let Texture::Layers(layers) = &*texture.value {
            for layer in layers {
                words.0 = layer.finish.ior.or(words.0);
                words.1 = layer.finish.caustics.map(|c| c / 45.0).or(words.1);
            }
        }
    }
    words
}

/// The object's box, or that of its `bounded_by` objects where it is smaller.
fn shrunk(bounds: Aabb, object: &Object, gates: &[Built]) -> Aabb {
    let mut box_of_bounds = Aabb::INFINITE;
    for (gate, built) in object.bounded_by.iter().zip(gates) {
        if !gate.flags.inverse {
            box_of_bounds = box_of_bounds.intersection(built.bounds);
        }
    }
    let smaller = box_of_bounds.volume() < bounds.volume() || !bounds.is_finite();
    if smaller { bounds.intersection(box_of_bounds) } else { bounds }
}

/// Whether rays that miss the `bounded_by` objects miss the object too, wherever it stands: the language keeps the
/// bounds of combinations and of algebraic surfaces, and drops those of other shapes that are no members.
fn keeps_bounds(object: &Object) -> bool {
    match &object.body {
        Body::Csg { .. } => true,
        Body::Shape(shape) => matches!(shape.kind(), "poly" | "quadric"),
        Body::Light(_) => false,
    }
}

/// Whether a top-level union's children may stand on their own.
fn splits(object: &Object, outer: &Inherited) -> bool {
    object.clipped_by.is_empty()
        && object.bounded_by.is_empty()
        && object.flags.split_union != Some(false)
        && object.flags.inverse == outer.inverted
}

/// Clip and bound objects stand where the object stands, and inherit nothing else.
fn region(outer: &Inherited) -> Inherited {
    Inherited { to_world: outer.to_world, in_group: true, in_intersection: true, ..Inherited::top() }
}

/// A difference is an intersection with inverted subtrahends; inversion exchanges union and intersection.
fn effective(op: CsgOp, inverted: bool) -> Op {
    match (op, inverted) {
        (CsgOp::Union | CsgOp::LightGroup { .. }, false) => Op::Union,
        (CsgOp::Merge, false) => Op::Merge,
        (CsgOp::Intersection | CsgOp::Difference, false) => Op::Intersection,
        (CsgOp::Union | CsgOp::LightGroup { .. } | CsgOp::Merge, true) => Op::Intersection,
        (CsgOp::Intersection | CsgOp::Difference, true) => Op::Merge,
    }
}

/// A child's flags with those that it takes from its parent.
fn merged(own: &Flags, outer: &Flags) -> Flags {
    Flags {
        no_shadow: own.no_shadow || outer.no_shadow,
        no_image: own.no_image || outer.no_image,
        no_reflection: own.no_reflection || outer.no_reflection,
        no_radiosity: own.no_radiosity || outer.no_radiosity,
        double_illuminate: own.double_illuminate || outer.double_illuminate,
        hollow: own.hollow.or(outer.hollow),
        ..*own
    }
}

fn hidden(flags: &Flags, opaque: bool) -> u8 {
    let bit = |on: bool, class: RayClass| if on { class.bit() } else { 0 };
    bit(flags.no_image, RayClass::Image)
        | bit(flags.no_reflection, RayClass::Reflected)
        | bit(flags.no_shadow, RayClass::Shadow)
        | bit(flags.no_shadow || opaque, RayClass::Filtered)
        | bit(flags.no_radiosity, RayClass::Radiosity)
        | bit(flags.no_image || flags.no_shadow, RayClass::Photon)
        | bit(flags.no_reflection || flags.no_shadow, RayClass::ReflectedPhoton)
}
