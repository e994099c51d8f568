//! Numbers and space; nothing here knows what a scene is.

mod aabb;
mod accelerator;
mod beam;
pub mod bvh;
pub mod chi_square;
pub mod field;
pub mod grid;
pub mod jitter;
pub mod noise;
pub mod polyhedron;
pub mod polynomial;
pub mod random;
mod range;
mod ray;
mod shaft;
mod spline;
#[cfg(test)]
pub mod strategy;
mod transform;
mod whole;

pub use aabb::Aabb;
pub use accelerator::{Accelerator, AnyHit};
pub use beam::Beam;
pub use range::Range;
pub use ray::Ray;
pub use shaft::Shaft;
pub use spline::{Spline, SplineKind, SplineValue};
pub use transform::Transform;
pub use whole::{floor, floor_of, is_odd};

/// A point or vector in space.
pub type Vec3 = glam::DVec3;
/// A point on a surface's parameter plane.
pub type Vec2 = glam::DVec2;

/// Half the distance from 1 to the next double: the largest relative error of one rounding.
pub const EPSILON: f64 = f64::EPSILON / 2.0;
