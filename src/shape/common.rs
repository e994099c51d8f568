//! A box around what several shapes have in common, where each alone may be infinite.

use super::Shape;
use crate::math::{Aabb, Transform, Vec3, polyhedron};

/// A shape and where it stands.
#[derive(Clone, Copy, Debug)]
pub struct Member<'a> {
    pub shape: &'a dyn Shape,
    pub place: &'a Transform,
    /// Whether what is outside counts.
    pub inverted: bool,
}

/// Boxes found are wider by this part of their size.
const SLACK: f64 = 1e-9;

/// How often what one shape leaves may narrow another.
const ROUNDS: usize = 2;

/// A box around what lies inside all members and inside `bounds`; infinite where it is not clear.
///
/// First the flat members alone, together with the sides of `bounds`; if that is not enough, what each member
/// leaves of the region that those along its own axes enclose.
pub fn bounds(members: &[Member], mut bounds: Aabb) -> Aabb {
    if bounds.is_empty() {
        return bounds;
    }
    let flat: Vec<(Vec3, f64)> = members.iter().filter_map(half_space).collect();
    if flat.is_empty() {
        return bounds;
    }
    bounds = bounds.intersection(between(&flat, &bounds));
    for _ in 0..ROUNDS {
        if bounds.is_finite() || bounds.is_empty() {
            return bounds;
        }
        for member in members.iter().filter(|m| !m.inverted) {
            let left = member.shape.within(&region(member.place, &flat, &bounds));
            bounds = bounds.intersection(grown(member.place.bounds(&left)));
        }
        bounds = bounds.intersection(between(&flat, &bounds));
    }
    bounds
}

/// The same by what stands along the axes alone, as the scene language's reference finds it.
pub fn aligned_bounds(members: &[Member], bounds: Aabb) -> Aabb {
    let flat: Vec<(Vec3, f64)> = members.iter().filter_map(half_space).collect();
    let mut bounds = region(&Transform::IDENTITY, &flat, &bounds);
    for _ in 0..ROUNDS {
        for member in members.iter().filter(|m| !m.inverted && m.shape.has_extent()) {
            let left = member.shape.within(&region(member.place, &flat, &bounds));
            bounds = bounds.intersection(grown(member.place.bounds(&left)));
        }
    }
    bounds
}

/// The polyhedron of half-spaces and the finite sides of a box.
fn between(flat: &[(Vec3, f64)], bounds: &Aabb) -> Aabb {
    let mut all = flat.to_vec();
    for (axis, n) in Vec3::AXES.into_iter().enumerate() {
        let sides = [(n, bounds.max[axis]), (-n, -bounds.min[axis])];
        all.extend(sides.into_iter().filter(|(_, d)| d.is_finite()));
    }
    let closed = polyhedron::bounds(&all);
    if closed.is_finite() { closed } else { polyhedron::bounds(flat) }
}

/// The half-space in the space around; none if the shape is no half-space.
fn half_space(member: &Member) -> Option<(Vec3, f64)> {
    let (n, d) = member.shape.half_space()?;
    let normal = member.place.normal(n).normalize();
    let d = normal.dot(member.place.point(d * n));
    Some(if member.inverted { (-normal, -d) } else { (normal, d) })
}

/// The part of a shape's own space that `bounds` and the half-spaces along its axes enclose.
fn region(place: &Transform, flat: &[(Vec3, f64)], bounds: &Aabb) -> Aabb {
    let back = place.inverted();
    let mut region = back.bounds(bounds);
    for &(n, d) in flat {
        let normal = back.normal(n);
        let Some(axis) = (0..3).find(|&axis| normal[axis].abs() == normal.length()) else { continue };
        let side = back.point(d * n)[axis];
        let side = side + SLACK * side.abs() * normal[axis].signum();
        if normal[axis] > 0.0 {
            region.max[axis] = region.max[axis].min(side);
        } else {
            region.min[axis] = region.min[axis].max(side);
        }
    }
    region
}

fn grown(b: Aabb) -> Aabb {
    let size = |v: Vec3| v.abs().map(|x| if x.is_finite() { SLACK * x } else { 0.0 });
    Aabb { min: b.min - size(b.min), max: b.max + size(b.max) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::{Plane, Quadric};

    fn hyperboloid() -> Quadric {
        Quadric::new(Vec3::new(1.0, -1.0, 1.0), Vec3::ZERO, Vec3::ZERO, -1.0)
    }

    /// x² + z² <= 1 + y², and y from -1 to 2: at most the root of 5 wide.
    #[test]
    fn a_hyperboloid_between_planes_is_finite() {
        let plane = |n: Vec3, d: f64| Plane::new(n, d).unwrap();
        let (quadric, low, high) = (hyperboloid(), plane(-Vec3::Y, 1.0), plane(Vec3::Y, 2.0));
        let place = Transform::scale(Vec3::new(0.5, 1.0, 0.5)).then(&Transform::translate(Vec3::X));
        let stands = Transform::IDENTITY;
        let members = [
            Member { shape: &low, place: &stands, inverted: false },
            Member { shape: &quadric, place: &place, inverted: false },
            Member { shape: &high, place: &stands, inverted: false },
        ];
        let b = bounds(&members, Aabb::INFINITE);
        let half = 0.5 * 5f64.sqrt();
        assert!(b.min.distance(Vec3::new(1.0 - half, -1.0, -half)) < 1e-6, "{b:?}");
        assert!(b.max.distance(Vec3::new(1.0 + half, 2.0, half)) < 1e-6, "{b:?}");
        assert!(!bounds(&members[..2], Aabb::INFINITE).is_finite());
    }

    /// A cylinder's box has no top; planes close it, one of them askew.
    #[test]
    fn planes_close_an_open_box() {
        let plane = |n: Vec3, d: f64| Plane::new(n, d).unwrap();
        let (low, high) = (plane(Vec3::Y, 0.0), plane(Vec3::new(0.0, 1.0, -1.0), 15.0));
        let stands = Transform::IDENTITY;
        let members = [(&low, true), (&high, false)].map(|(shape, inverted)| Member {
            shape,
            place: &stands,
            inverted,
        });
        let open =
            Aabb { min: Vec3::new(-5.0, f64::NEG_INFINITY, -5.0), max: Vec3::new(5.0, f64::INFINITY, 5.0) };
        let b = bounds(&members, open);
        assert!((b.max.y - (15.0 * 2f64.sqrt() + 5.0)).abs() < 1e-6 && b.min.y.abs() < 1e-6, "{b:?}");
    }
}
