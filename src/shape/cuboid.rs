//! Box: the points with `min <= p <= max` on every axis.
//!
//! | parameter | unit | meaning |
//! |---|---|---|
//! | corners | length | two opposite corners in any order; sides of length 0 are allowed |
//!
//! Numerical care: a crossing's point is put exactly onto its face and inside the face's rectangle. Where
//! a ray meets an edge, the face is chosen that the ray meets more squarely; y is preferred to x, and z to
//! both, only if the ray's component there is strictly larger.

use super::span::{slab, tie};
use super::{COINCIDENT, Chord, Crossing, Shape, Span, rounding};
use crate::math::{Aabb, Range, Ray, Vec2, Vec3};

/// Parts: 0 and 1 are the sides at small and large x, 2 and 3 at y, 4 and 5 at z.
#[derive(Clone, Debug, PartialEq)]
pub struct Cuboid {
    extent: Aabb,
}

impl Cuboid {
    pub fn new(a: Vec3, b: Vec3) -> Self {
        Self { extent: Aabb::new(a, b) }
    }

    /// Entry and exit of a line, in this order.
    #[inline]
    pub(super) fn ends(&self, ray: &Ray) -> Option<[Crossing; 2]> {
        let ([enter, leave], ties) = self.axes(ray)?;
        if ties {
            return self.chosen(ray);
        }
        let at = |axis: usize, forward: bool| {
            let face = if forward { self.extent.min[axis] } else { self.extent.max[axis] };
            (face - ray.origin[axis]) / ray.dir[axis]
        };
        let (first, last) = (at(enter, ray.dir[enter] > 0.0), at(leave, ray.dir[leave] < 0.0));
        Some(Self::crossings_at(ray, (first, enter), (last, leave)))
    }

    /// The axes of the slabs that a line enters last and leaves first, and whether others come so close that
    /// they are to be looked at again. Most lines pass by so clearly that rounded distances tell.
    #[inline]
    fn axes(&self, ray: &Ray) -> Option<([usize; 2], bool)> {
        let inverse = ray.dir.recip();
        let (a, b) = ((self.extent.min - ray.origin) * inverse, (self.extent.max - ray.origin) * inverse);
        let lesser = |a: f64, b: f64| if a < b { a } else { b };
        let greater = |a: f64, b: f64| if a > b { a } else { b };
        let near = [lesser(a.x, b.x), lesser(a.y, b.y), lesser(a.z, b.z)];
        let far = [greater(a.x, b.x), greater(a.y, b.y), greater(a.z, b.z)];
        let first = greater(greater(near[0], near[1]), near[2]);
        let last = lesser(lesser(far[0], far[1]), far[2]);
        let size = first.abs() + last.abs();
        if first - last > 1e-6 * size {
            return None;
        }
        let clear = 1e-9 * size;
        let (enter, leave) = (sole(near, |t| t >= first - clear), sole(far, |t| t <= last + clear));
        Some(match (enter, leave) {
            (Some(enter), Some(leave)) if last - first > clear => ([enter, leave], false),
            _ => ([0, 0], true),
        })
    }

    #[inline]
    fn crossings_at(ray: &Ray, enter: (f64, usize), leave: (f64, usize)) -> [Crossing; 2] {
        let entry_part = 2 * enter.1 + usize::from(ray.dir[enter.1] < 0.0);
        let exit_part = 2 * leave.1 + usize::from(ray.dir[leave.1] > 0.0);
        [Crossing::on_part(enter.0, entry_part as u32), Crossing::on_part(leave.0, exit_part as u32)]
    }

    /// The sides that show at entry and exit where lines meet edges, or run along sides.
    #[inline(never)]
    fn chosen(&self, ray: &Ray) -> Option<[Crossing; 2]> {
        let of =
            |axis: usize| slab(ray.origin[axis], ray.dir[axis], self.extent.min[axis], self.extent.max[axis]);
        let slabs = [of(0)?, of(1)?, of(2)?];
        let mut enter = (f64::NEG_INFINITY, 0);
        let mut leave = (f64::INFINITY, 0);
        for (axis, (near, far)) in slabs.into_iter().enumerate() {
            let speed = ray.dir[axis];
            let squarer = |other: usize| speed.abs() > ray.dir[other].abs();
            if wins(near, enter.0, squarer(enter.1)) {
                enter = (near, axis);
            }
            if wins(-far, -leave.0, squarer(leave.1)) {
                leave = (far, axis);
            }
        }
        (enter.0 <= leave.0).then(|| Self::crossings_at(ray, enter, leave))
    }
}

/// The axis whose number alone passes the test.
#[inline]
fn sole(numbers: [f64; 3], passes: impl Fn(f64) -> bool) -> Option<usize> {
    match (passes(numbers[0]), passes(numbers[1]), passes(numbers[2])) {
        (true, false, false) => Some(0),
        (false, true, false) => Some(1),
        (false, false, true) => Some(2),
        _ => None,
    }
}

/// Whether a slab's bound `t` replaces `best`; `squarer` decides on an edge.
fn wins(t: f64, best: f64, squarer: bool) -> bool {
    let tie = tie(t, best);
    t > best + tie || (squarer && t >= best - tie)
}

impl Shape for Cuboid {
    fn bounds(&self) -> Aabb {
        self.extent
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        if let Some(ends) = self.ends(ray) {
            out.extend(ends.into_iter().filter(|c| range.contains(c.t)));
        }
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let [enter, leave] = self.ends(ray)?;
        if range.contains(enter.t) && enter.t < leave.t {
            return Some(enter);
        }
        range.contains(leave.t).then_some(leave)
    }

    fn chord(&self, ray: &Ray, _range: Range) -> Option<Chord> {
        let end = |c: Crossing| (c.t, c.part);
        let span = self.ends(ray).map(|[enter, leave]| Span { enter: end(enter), leave: end(leave) });
        Some(Chord::within(span))
    }

    fn contains(&self, p: Vec3) -> bool {
        self.extent
            .grown(COINCIDENT * self.extent.size().max_element() + rounding(p.abs().max_element()))
            .contains(p)
    }

    fn normal(&self, _p: Vec3, crossing: &Crossing) -> Vec3 {
        let mut n = Vec3::ZERO;
        n[crossing.part as usize / 2] = if crossing.part.is_multiple_of(2) { -1.0 } else { 1.0 };
        n
    }

    fn locate(&self, ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        let axis = crossing.part as usize / 2;
        let face = if crossing.part.is_multiple_of(2) { self.extent.min } else { self.extent.max };
        let mut p = ray.at(crossing.t).clamp(self.extent.min, self.extent.max);
        p[axis] = face[axis];
        (p, rounding(p.abs().max_element()))
    }

    fn uv(&self, p: Vec3, crossing: &Crossing) -> Option<Vec2> {
        let size = self.extent.size();
        let q = (p - self.extent.min) / size.map(|s| if s > 0.0 { s } else { 1.0 });
        Some(match crossing.part {
            0 => Vec2::new(q.z / 4.0, (1.0 + q.y) / 3.0),
            1 => Vec2::new((3.0 - q.z) / 4.0, (1.0 + q.y) / 3.0),
            2 => Vec2::new((1.0 + q.x) / 4.0, q.z / 3.0),
            3 => Vec2::new((1.0 + q.x) / 4.0, 1.0 - q.z / 3.0),
            4 => Vec2::new(1.0 - q.x / 4.0, (1.0 + q.y) / 3.0),
            _ => Vec2::new((1.0 + q.x) / 4.0, (1.0 + q.y) / 3.0),
        })
    }

    fn kind(&self) -> &'static str {
        "box"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unit() -> Cuboid {
        Cuboid::new(Vec3::ONE, Vec3::NEG_ONE)
    }

    #[test]
    fn edges_show_the_squarer_face() {
        let normal = |o: [f64; 3], d: [f64; 3]| {
            let ray = Ray::new(Vec3::from(o), Vec3::from(d).normalize());
            let c = unit().nearest(&ray, Range::FORWARD).unwrap();
            unit().normal(ray.at(c.t), &c)
        };
        assert_eq!(normal([-3.0, 0.0, -3.0], [1.0, 0.0, 1.0]), Vec3::NEG_X);
        assert_eq!(normal([0.0, -3.0, -3.0], [0.0, 1.0, 1.0]), Vec3::NEG_Y);
        assert_eq!(normal([-4.0, 0.0, -3.0], [1.5, 0.0, 1.0]), Vec3::NEG_X);
        assert_eq!(normal([-1.5, 0.0, -2.0], [1.0, 0.0, 2.0]), Vec3::NEG_Z);
        assert_eq!(normal([-1.0, -1.0, -3.0], [0.0, 0.0, 1.0]), Vec3::NEG_Z);
    }

    #[test]
    fn a_flat_box_is_hit_on_its_far_side() {
        let flat = Cuboid::new(Vec3::ZERO, Vec3::new(1.0, 0.0, 1.0));
        let ray = Ray::new(Vec3::new(0.5, 3.0, 0.5), Vec3::NEG_Y);
        let c = flat.nearest(&ray, Range::FORWARD).unwrap();
        assert_eq!(flat.normal(Vec3::ZERO, &c), Vec3::NEG_Y);
    }

    #[test]
    fn points_sit_exactly_on_the_face() {
        let b = Cuboid::new(Vec3::new(0.1, 0.2, 0.3), Vec3::new(1.7, 2.9, 3.1));
        let ray = Ray::new(Vec3::new(-5.3, 1.1, 2.7), Vec3::new(0.9, 0.1, -0.17).normalize());
        let c = b.nearest(&ray, Range::FORWARD).unwrap();
        assert_eq!(b.locate(&ray, &c).0.x, 0.1);
    }
}
