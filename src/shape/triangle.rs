//! Triangles, with a flat or an interpolated normal. Surfaces without an inside.
//!
//! | parameter | unit | meaning |
//! |---|---|---|
//! | a, b, c | length | corners, not on one line |
//! | normals | – | at the corners, for a smooth triangle; all on one side of its plane |
//!
//! Numerical care: whether the ray passes inside is decided by the signs of three edge functions in a
//! frame that looks along the ray, so rays through an edge or a corner that two triangles share hit at
//! least one of them. Edges and corners belong to the triangle. The distance comes from the plane, whose
//! sign tells on which side the ray starts.
//!
//! Reference: S. Woop, C. Benthin, I. Wald, "Watertight Ray/Triangle Intersection", JCGT 2(1), 2013.

use super::plane::meet;
use super::{Crossing, Shape, rounding};
use crate::math::{Aabb, Range, Ray, Vec2, Vec3};

#[derive(Clone, Debug, PartialEq)]
pub struct Triangle {
    corners: [Vec3; 3],
    /// Unit vector along (a - b) x (c - b).
    normal: Vec3,
}

/// A ray's frame in which it runs along z: the same for every triangle that it is tested with.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shear {
    pub(super) axes: [usize; 3],
    pub(super) slope: Vec2,
}

impl Shear {
    pub fn new(dir: Vec3) -> Self {
        let size = dir.abs();
        let z = if size.x > size.y && size.x > size.z {
            0
        } else if size.y > size.z {
            1
        } else {
            2
        };
        let (mut x, mut y) = ((z + 1) % 3, (z + 2) % 3);
        if dir[z] < 0.0 {
            std::mem::swap(&mut x, &mut y);
        }
        Self { axes: [x, y, z], slope: Vec2::new(dir[x] / dir[z], dir[y] / dir[z]) }
    }

    /// A point relative to the ray's origin, seen along the ray.
    #[inline(always)]
    pub fn project(&self, p: Vec3) -> Vec2 {
        let depth = p[self.axes[2]];
        Vec2::new(p[self.axes[0]] - self.slope.x * depth, p[self.axes[1]] - self.slope.y * depth)
    }

    /// [`Shear::project`] of a corner in single precision, for a ray from `origin`: the same arithmetic.
    #[inline(always)]
    fn project_corner(&self, corner: &[f32; 3], origin: &[f64; 3]) -> Vec2 {
        let [x, y, z] = self.axes;
        let depth = f64::from(corner[z]) - origin[z];
        Vec2::new(
            (f64::from(corner[x]) - origin[x]) - self.slope.x * depth,
            (f64::from(corner[y]) - origin[y]) - self.slope.y * depth,
        )
    }

    /// What [`Shear::weights`] are proportional to, for corners in single precision and a ray from `origin`.
    #[inline(always)]
    pub fn shares_of(&self, corners: [&[f32; 3]; 3], origin: &[f64; 3]) -> Option<Vec3> {
        let [a, b, c] = corners;
        Self::shares(
            self.project_corner(a, origin),
            self.project_corner(b, origin),
            self.project_corner(c, origin),
        )
    }

    /// The weights of the corners (relative to the ray's origin) where the ray passes, if it passes inside.
    #[inline]
    pub fn weights(&self, corners: [Vec3; 3]) -> Option<Vec3> {
        let [a, b, c] = corners;
        Self::inside(self.project(a), self.project(b), self.project(c))
    }

    #[inline(always)]
    pub fn inside(a: Vec2, b: Vec2, c: Vec2) -> Option<Vec3> {
        Self::shares(a, b, c).map(|shares| shares / shares.element_sum())
    }

    #[inline(always)]
    fn shares(a: Vec2, b: Vec2, c: Vec2) -> Option<Vec3> {
        let (u, v) = (c.perp_dot(b), a.perp_dot(c));
        if (u < 0.0 && v > 0.0) || (u > 0.0 && v < 0.0) {
            return None;
        }
        let w = b.perp_dot(a);
        if (w < 0.0 && (u > 0.0 || v > 0.0)) || (w > 0.0 && (u < 0.0 || v < 0.0)) {
            return None;
        }
        let sum = u + v + w;
        (sum != 0.0 && sum.is_finite()).then(|| Vec3::new(u, v, w))
    }
}

impl Shear {
    /// Whether the ray passes inside, each edge counting for only one of the two triangles beside it.
    pub fn passes_once(&self, corners: [Vec3; 3]) -> bool {
        let [a, b, c] = corners.map(|p| self.project(p));
        let turn = (b - a).perp_dot(c - a).signum();
        [(b, c), (c, a), (a, b)].into_iter().all(|(from, to)| {
            let side = turn * from.perp_dot(to);
            let along = turn * (to - from);
            side > 0.0 || (side == 0.0 && (along.y > 0.0 || (along.y == 0.0 && along.x < 0.0)))
        })
    }
}

impl Triangle {
    /// `None` if the corners lie on one line.
    pub fn new(a: Vec3, b: Vec3, c: Vec3) -> Option<Self> {
        let normal = (a - b).cross(c - b).try_normalize()?;
        Some(Self { corners: [a, b, c], normal })
    }

    fn hit(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let (t, shares) = self.passed(ray, range)?;
        let sum = shares.element_sum();
        Some(Crossing { t, part: 0, uv: Vec2::new(shares.y / sum, shares.z / sum) })
    }

    /// Distance and shares of the corners. The plane is asked first: it lies behind most rays that start near it.
    #[inline]
    fn passed(&self, ray: &Ray, range: Range) -> Option<(f64, Vec3)> {
        let t = meet(ray, self.normal, self.corners[0]).filter(|&t| range.contains(t))?;
        let shear = Shear::new(ray.dir);
        let [a, b, c] = self.corners.map(|p| shear.project(p - ray.origin));
        Shear::shares(a, b, c).map(|shares| (t, shares))
    }

    fn at(&self, uv: Vec2) -> Vec3 {
        let [a, b, c] = self.corners;
        (1.0 - uv.x - uv.y) * a + uv.x * b + uv.y * c
    }

    fn scale(&self) -> f64 {
        let [a, b, c] = self.corners.map(|p| p.abs().max_element());
        a.max(b).max(c)
    }
}

impl Shape for Triangle {
    fn bounds(&self) -> Aabb {
        Aabb::from_points(self.corners)
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        out.extend(self.hit(ray, range));
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        self.hit(ray, range)
    }

    fn meets(&self, ray: &Ray, range: Range) -> bool {
        self.passed(ray, range).is_some()
    }

    fn contains(&self, _p: Vec3) -> bool {
        false
    }

    fn is_solid(&self) -> bool {
        false
    }

    fn normal(&self, _p: Vec3, _crossing: &Crossing) -> Vec3 {
        self.normal
    }

    fn locate(&self, _ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        let p = self.at(crossing.uv);
        (p - self.normal.dot(p - self.corners[0]) * self.normal, rounding(2.0 * self.scale()))
    }

    fn kind(&self) -> &'static str {
        "triangle"
    }
}

#[derive(Clone, Debug, PartialEq)]
pub struct SmoothTriangle {
    face: Triangle,
    normals: [Vec3; 3],
}

impl SmoothTriangle {
    /// `None` if the corners lie on one line, or the normals are not all on one side of the face.
    pub fn new(corners: [Vec3; 3], normals: [Vec3; 3]) -> Option<Self> {
        let face = Triangle::new(corners[0], corners[1], corners[2])?;
        let normals = normals.map(Vec3::normalize_or_zero);
        let sides = normals.map(|n| n.dot(face.normal));
        let one_sided = sides.iter().all(|&s| s > 0.0) || sides.iter().all(|&s| s < 0.0);
        one_sided.then_some(Self { face, normals })
    }
}

impl Shape for SmoothTriangle {
    fn bounds(&self) -> Aabb {
        self.face.bounds()
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        self.face.crossings(ray, range, out);
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        self.face.nearest(ray, range)
    }

    fn meets(&self, ray: &Ray, range: Range) -> bool {
        self.face.meets(ray, range)
    }

    fn contains(&self, _p: Vec3) -> bool {
        false
    }

    fn is_solid(&self) -> bool {
        false
    }

    fn normal(&self, _p: Vec3, crossing: &Crossing) -> Vec3 {
        let [a, b, c] = self.normals;
        let uv = crossing.uv;
        ((1.0 - uv.x - uv.y) * a + uv.x * b + uv.y * c).normalize_or(self.face.normal)
    }

    fn face_normal(&self, _p: Vec3, _crossing: &Crossing) -> Option<Vec3> {
        Some(self.face.normal)
    }

    fn locate(&self, ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        self.face.locate(ray, crossing)
    }

    fn kind(&self) -> &'static str {
        "smooth_triangle"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_and_corners_are_hit() {
        let t = Triangle::new(Vec3::ZERO, Vec3::X, Vec3::Y).unwrap();
        for (x, y) in [(0.0, 0.5), (0.5, 0.0), (0.5, 0.5), (0.0, 0.0), (1.0, 0.0)] {
            let ray = Ray::new(Vec3::new(x, y, -3.0), Vec3::Z);
            let c = t.nearest(&ray, Range::FORWARD).unwrap();
            assert_eq!(t.locate(&ray, &c).0, Vec3::new(x, y, 0.0));
            assert_eq!(t.normal(Vec3::ZERO, &c), Vec3::NEG_Z);
        }
        assert!(t.nearest(&Ray::new(Vec3::new(0.6, 0.5, -3.0), Vec3::Z), Range::FORWARD).is_none());
    }

    #[test]
    fn no_ray_slips_through_a_shared_edge() {
        let (a, b) = (Vec3::new(0.1, 0.7, -0.3), Vec3::new(1.9, -0.2, 0.4));
        let one = Triangle::new(a, b, Vec3::new(0.3, -1.1, 0.9)).unwrap();
        let two = Triangle::new(b, a, Vec3::new(1.3, 1.7, 0.1)).unwrap();
        for i in 1..2000 {
            let target = a + (b - a) * (f64::from(i) / 2000.0);
            let origin = Vec3::new(3.1, 2.3, -7.7) * (1.0 + f64::from(i % 17));
            let ray = Ray::new(origin, (target - origin).normalize());
            let hits = [&one, &two].iter().filter(|t| t.nearest(&ray, Range::FORWARD).is_some()).count();
            assert!(hits >= 1, "at {i}");
        }
    }

    #[test]
    fn degenerate_triangles_are_refused() {
        assert!(Triangle::new(Vec3::ZERO, Vec3::X, 2.0 * Vec3::X).is_none());
        let corners = [Vec3::ZERO, Vec3::X, Vec3::Y];
        assert!(SmoothTriangle::new(corners, [Vec3::Z, Vec3::Z, Vec3::NEG_Z]).is_none());
        assert!(SmoothTriangle::new(corners, [Vec3::Z, Vec3::new(0.1, 0.0, 1.0), Vec3::Z]).is_some());
    }
}
