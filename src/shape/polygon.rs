//! Polygon: a flat region bounded by closed lines, filled where an odd number of them surrounds a point.
//!
//! | parameter | unit | meaning |
//! |---|---|---|
//! | points | length | sub-polygons one after another, each closed by repeating its first point |
//!
//! Numerical care: the region is tested in a frame of the polygon's own plane. Of points exactly on the
//! boundary those on lines along the frame's x axis are hit, all others and the corners are not.

use super::plane::meet;
use super::{COINCIDENT, Crossing, Shape, rounding};
use crate::math::{Aabb, Range, Ray, Vec2, Vec3};

#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    origin: Vec3,
    normal: Vec3,
    axes: [Vec3; 2],
    /// The boundary's lines in the plane's frame.
    edges: Vec<[Vec2; 2]>,
    extent: Aabb,
}

impl Polygon {
    /// `None` if the points do not lie in one plane or all lie on one line.
    pub fn new(points: &[Vec3]) -> Option<Self> {
        let origin = *points.first()?;
        let extent = Aabb::from_points(points.iter().copied());
        let size = extent.size().max_element();
        let (first, normal) = frame(points, size)?;
        let axes = [first, normal.cross(first)];
        let flat = |p: &Vec3| {
            let scale = size + p.abs().max_element();
            normal.dot(*p - origin).abs() <= COINCIDENT * scale
        };
        if !points.iter().all(flat) {
            return None;
        }
        let project = |p: &Vec3| Vec2::new((*p - origin).dot(axes[0]), (*p - origin).dot(axes[1]));
        let edges = sub_polygons(points)
            .flat_map(|part| part.windows(2).map(|w| [project(&w[0]), project(&w[1])]).collect::<Vec<_>>())
            .collect();
        Some(Self { origin, normal, axes, edges, extent })
    }

    fn covers(&self, p: Vec2) -> bool {
        let mut inside = false;
        for [a, b] in &self.edges {
            let side = (*b - *a).perp_dot(p - *a);
            if side == 0.0 && (p - *a).dot(p - *b) <= 0.0 {
                return a.y == b.y && p != *a && p != *b;
            }
            if (a.y < p.y) != (b.y < p.y) && (side > 0.0) == (b.y > a.y) {
                inside = !inside;
            }
        }
        inside
    }

    fn hit(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let t = meet(ray, self.normal, self.origin)?;
        let q = ray.at(t) - self.origin;
        let p = Vec2::new(q.dot(self.axes[0]), q.dot(self.axes[1]));
        (range.contains(t) && self.covers(p)).then(|| Crossing::new(t))
    }
}

/// The unit direction of the first side and the unit normal, from the first three points not on one line.
fn frame(points: &[Vec3], size: f64) -> Option<(Vec3, Vec3)> {
    let origin = points[0];
    let margin = COINCIDENT * size;
    let mut rest = points[1..].iter().map(|&p| p - origin).filter(|v| v.length() > margin);
    let first = rest.next()?.normalize();
    let across = rest.map(|v| first.cross(v)).find(|n| n.length() > margin)?;
    Some((first, across.normalize()))
}

/// The closed runs of points; the last is closed if it was left open.
fn sub_polygons(points: &[Vec3]) -> impl Iterator<Item = Vec<Vec3>> {
    let mut rest = points;
    std::iter::from_fn(move || {
        let first = *rest.first()?;
        let end = rest[1..].iter().position(|&p| p == first).map(|i| i + 2);
        let (part, left) = rest.split_at(end.unwrap_or(rest.len()));
        rest = left;
        let mut part = part.to_vec();
        if end.is_none() {
            part.push(first);
        }
        Some(part)
    })
}

/// Whether the points' last sub-polygon is closed.
pub fn is_closed(points: &[Vec3]) -> bool {
    let mut rest = points;
    while let Some(first) = rest.first() {
        match rest[1..].iter().position(|p| p == first) {
            Some(i) => rest = &rest[i + 2..],
            None => return false,
        }
    }
    true
}

impl Shape for Polygon {
    fn bounds(&self) -> Aabb {
        self.extent
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        out.extend(self.hit(ray, range));
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        self.hit(ray, range)
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

    fn locate(&self, ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        let p = ray.at(crossing.t);
        let p = p - self.normal.dot(p - self.origin) * self.normal;
        (p, rounding(2.0 * self.extent.min.abs().max(self.extent.max.abs()).max_element()))
    }

    fn kind(&self) -> &'static str {
        "polygon"
    }

    fn heap_bytes(&self) -> usize {
        self.edges.capacity() * size_of::<[Vec2; 2]>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square() -> Vec<Vec3> {
        vec![Vec3::ZERO, Vec3::X, Vec3::new(1.0, 1.0, 0.0), Vec3::Y, Vec3::ZERO]
    }

    fn hit(points: &[Vec3], x: f64, y: f64) -> bool {
        let p = Polygon::new(points).unwrap();
        p.nearest(&Ray::new(Vec3::new(x, y, -3.0), Vec3::Z), Range::FORWARD).is_some()
    }

    #[test]
    fn boundary_rule() {
        let s = square();
        assert!(hit(&s, 0.5, 0.5) && hit(&s, 0.5, 0.0) && hit(&s, 0.5, 1.0));
        assert!(!hit(&s, 0.0, 0.5) && !hit(&s, 1.0, 0.5) && !hit(&s, 0.0, 0.0) && !hit(&s, 1.0, 1.0));
        assert_eq!(Polygon::new(&s).unwrap().normal, Vec3::Z);
    }

    #[test]
    fn a_second_ring_is_a_hole() {
        let mut s = square();
        s.extend(square().iter().map(|p| 0.25 + 0.5 * *p).map(|p| p.with_z(0.0)));
        assert!(hit(&s, 0.1, 0.1) && !hit(&s, 0.5, 0.5));
        assert!(is_closed(&s) && !is_closed(&s[..9]));
    }

    #[test]
    fn points_off_the_plane_are_refused() {
        let mut s = square();
        s[2].z = 1e-6;
        assert!(Polygon::new(&s).is_none());
        assert!(Polygon::new(&[Vec3::ZERO, Vec3::X, Vec3::ZERO]).is_none());
    }
}
