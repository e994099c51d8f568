//! Shapes: what a ray crosses, in the shape's own space. One file each.

mod algebraic;
mod bicubic_patch;
mod blob;
pub mod common;
mod cone;
#[cfg(test)]
mod conformance;
mod container;
mod cuboid;
mod curve;
mod cylinder;
mod disc;
mod empty;
pub mod font;
mod glyph;
mod height_field;
mod isosurface;
mod julia;
mod lathe;
pub mod mesh;
mod ovus;
mod parametric;
mod plane;
mod polygon;
mod prism;
mod quadric;
mod sor;
mod span;
mod sphere;
mod sphere_sweep;
mod superellipsoid;
mod torus;
mod triangle;

pub use algebraic::Algebraic;
pub use bicubic_patch::{BicubicPatch, PatchDetail};
pub use blob::{Blob, BlobComponent};
pub use cone::Cone;
pub use container::Container;
pub use cuboid::Cuboid;
pub use curve::CurveKind;
pub(crate) use curve::{closed_curves, open_curve};
pub use cylinder::Cylinder;
pub use disc::Disc;
pub use empty::Empty;
pub use glyph::{Glyph, Segment};
pub use height_field::HeightField;
pub use isosurface::Isosurface;
pub use julia::{Function as JuliaFunction, Julia, JuliaError, JuliaSettings};
pub use lathe::Lathe;
pub use mesh::{Mesh, MeshBuilder};
pub use ovus::Ovus;
pub use parametric::Parametric;
pub use plane::Plane;
pub use polygon::{Polygon, is_closed as is_closed_polygon};
pub use prism::{Prism, Sweep};
pub use quadric::Quadric;
pub use sor::{Sor, SorError};
pub use span::{Chord, Span};
pub use sphere::Sphere;
pub(crate) use sphere::{place_on_sphere, sphere_span};
pub use sphere_sweep::{SphereSweep, SweepKind};
pub use superellipsoid::Superellipsoid;
pub use torus::Torus;
pub use triangle::{SmoothTriangle, Triangle};

use crate::math::{Aabb, EPSILON, Range, Ray, Transform, Vec2, Vec3};
use std::fmt::Debug;
use std::sync::Arc;

/// Faces nearer to each other than this part of the shape's size coincide: solids whose rule counts the
/// surface as inside (or outside) do so within this distance, so that faces shared by two solids are
/// treated alike at every point in spite of rounding.
pub(crate) const COINCIDENT: f64 = 1e-11;

/// A bound on what a few roundings do to numbers of size `scale`.
pub(crate) fn rounding(scale: f64) -> f64 {
    16.0 * EPSILON * scale
}

thread_local! {
    /// A list that is used again and again.
    static SPARE: std::cell::Cell<Vec<Crossing>> = const { std::cell::Cell::new(Vec::new()) };
}

/// One place where a ray crosses a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// Distance along the (unit) direction, in object units.
    pub t: f64,
    /// Which part of the shape: a box's side, a mesh's triangle, 0 where there is only one.
    pub part: u32,
    /// The shape's own surface parameters where it needs them later (barycentrics, a spline's parameter).
    pub uv: Vec2,
}

impl Crossing {
    pub fn new(t: f64) -> Self {
        Self { t, part: 0, uv: Vec2::ZERO }
    }

    pub fn on_part(t: f64, part: u32) -> Self {
        Self { t, part, uv: Vec2::ZERO }
    }
}

/// Where a crossing is, and how the surface lies there: see [`Shape::locate`], [`Shape::normal`] and
/// [`Shape::face_normal`].
#[derive(Clone, Copy, Debug)]
pub struct Place {
    pub point: Vec3,
    pub error: f64,
    pub normal: Vec3,
    pub face: Option<Vec3>,
}

/// Which texture a crossing shows, for shapes whose parts have textures of their own.
#[derive(Clone, Debug, PartialEq)]
pub enum PartTexture {
    /// The object's.
    Object,
    /// Parts' textures (indices into the object's list) with weights that add to 1; `None` is the object's.
    Blend(smallvec::SmallVec<[(Option<u32>, f32); 4]>),
}

/// A surface in its own space. Rays have unit directions; all lengths are in object units.
pub trait Shape: Debug + Send + Sync {
    /// How many functions, patterns, pigments and objects stand within each other in what the shape is made of.
    fn depth(&self) -> u32 {
        0
    }

    /// A box around the whole surface; sides may be infinite.
    fn bounds(&self) -> Aabb;

    /// A box around the inside, where that reaches beyond the surface.
    fn inside_bounds(&self) -> Aabb {
        self.bounds()
    }

    /// What the scene language takes for the shape's bounds.
    fn extent(&self) -> Aabb {
        self.bounds()
    }

    /// Whether the scene language takes the bounds for the shape's extent.
    fn has_extent(&self) -> bool {
        true
    }

    /// A box around what is inside of the part that lies in `region`, whose sides may be infinite.
    fn within(&self, region: &Aabb) -> Aabb {
        region.intersection(self.inside_bounds())
    }

    /// Appends every crossing inside `range`, in the order that the specification gives for exact ties
    /// (the one appended last wins).
    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>);

    /// The nearest crossing inside `range`.
    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let mut all = SPARE.take();
        all.clear();
        self.crossings(ray, range, &mut all);
        let nearest = nearest_of(&all);
        SPARE.set(all);
        nearest
    }

    /// Whether there is any crossing inside `range`.
    fn meets(&self, ray: &Ray, range: Range) -> bool {
        self.nearest(ray, range).is_some()
    }

    /// Where the ray's line is inside, for solids that tell it in one piece with the crossings: always `None` or
    /// never. Ends that lie in `range` are those of [`Shape::crossings`], others need only lie outside.
    fn chord(&self, _ray: &Ray, _range: Range) -> Option<Chord> {
        None
    }

    /// Whether `p` is inside the solid. Surfaces without an inside say no.
    fn contains(&self, p: Vec3) -> bool;

    /// Whether the shape has an inside at all.
    fn is_solid(&self) -> bool {
        true
    }

    /// The shape that `inverse` turns this one into, where that is not its complement with the normal
    /// turned round. It replaces the shape, and is not inverted any further.
    fn inverse(&self) -> Option<Arc<dyn Shape>> {
        None
    }

    /// The same shape made ready for its place in the world, where that matters.
    fn placed(&self, _to_world: &Transform) -> Option<Arc<dyn Shape>> {
        None
    }

    /// The unit normal at a crossing, outward where the specification does not say otherwise; not turned
    /// towards the ray.
    fn normal(&self, p: Vec3, crossing: &Crossing) -> Vec3;

    /// The unit normal of the surface itself, where [`Shape::normal`] is interpolated or has a convention of
    /// its own. Tells on which side of the surface a ray leaves.
    fn face_normal(&self, _p: Vec3, _crossing: &Crossing) -> Option<Vec3> {
        None
    }

    /// The crossing's point, moved onto the surface where that is cheap, and a bound on its distance from
    /// the true surface in object units.
    fn locate(&self, ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        let p = ray.at(crossing.t);
        (p, 8.0 * EPSILON * (ray.origin.abs().max_element() + crossing.t.abs() + p.abs().max_element()))
    }

    /// Everything about a crossing's place that lighting asks for, in one call.
    fn at(&self, ray: &Ray, crossing: &Crossing) -> Place {
        let (point, error) = self.locate(ray, crossing);
        let normal = self.normal(point, crossing);
        Place { point, error, normal, face: self.face_normal(point, crossing) }
    }

    /// Surface parameters in 0..1, if the shape defines any.
    fn uv(&self, _p: Vec3, _crossing: &Crossing) -> Option<Vec2> {
        None
    }

    /// Which textures the crossing shows.
    fn part_texture(&self, _p: Vec3, _crossing: &Crossing) -> PartTexture {
        PartTexture::Object
    }

    /// Center and radius, if the surface is a sphere with its normals outward.
    fn sphere(&self) -> Option<(Vec3, f64)> {
        None
    }

    /// The shape's name in the scene language.
    fn kind(&self) -> &'static str;

    /// `(n, d)` with a unit `n`, if the inside is where `n · p <= d`.
    fn half_space(&self) -> Option<(Vec3, f64)> {
        None
    }

    /// The shape, if it is a mesh: cameras look from its faces.
    fn as_mesh(&self) -> Option<&Mesh> {
        None
    }

    /// Bytes kept beyond the struct itself (meshes, height fields); for `explain`.
    fn heap_bytes(&self) -> usize {
        0
    }
}

/// The smallest `t`; of equal ones the last.
pub fn nearest_of(crossings: &[Crossing]) -> Option<Crossing> {
    crossings.iter().copied().reduce(|best, c| if c.t <= best.t { c } else { best })
}
