use super::flatten::Flattened;
use super::geometry::Solid;
use crate::math::{Aabb, Range, Ray, Vec3};
use crate::scene::Object;

/// One object prepared alone, for what a scene asks while it is read: `trace`, `inside`, extents, and
/// patterns and containers that are objects.
#[derive(Debug)]
pub struct ObjectQuery {
    flat: Flattened,
    solid: Solid,
    bounds: Aabb,
    depth: u32,
}

impl ObjectQuery {
    pub fn new(object: &Object) -> Self {
        let (flat, solid, bounds) = Flattened::of_one(object);
        Self { flat, solid, bounds, depth: object.depth() }
    }

    /// The nearest crossing in front of the ray's origin: its point and the unit normal, outward and not
    /// turned towards the ray.
    pub fn trace(&self, ray: &Ray) -> Option<(Vec3, Vec3)> {
        let found = self.flat.geometry.nearest_of(self.solid, ray, Range::FORWARD)?;
        let located = self.flat.geometry.locate(ray, &found);
        Some((located.point, located.normal))
    }

    pub fn contains(&self, p: Vec3) -> bool {
        self.flat.geometry.contains(self.solid, p)
    }

    /// A box around the object; sides may be infinite.
    pub fn bounds(&self) -> Aabb {
        self.bounds
    }
}

impl crate::math::field::Solid for ObjectQuery {
    fn contains(&self, p: Vec3) -> bool {
        ObjectQuery::contains(self, p)
    }

    fn depth(&self) -> u32 {
        self.depth
    }
}
