//! What finds the boxes that a ray may meet.

use super::{Range, Ray, Vec3};

/// Boxes numbered from 0, made ready for rays that ask whether any is met.
pub trait AnyHit {
    /// Calls `visit` with every box that the ray may meet inside `range`, in no order, until it returns true.
    fn any(&self, ray: &Ray, range: Range, visit: impl FnMut(u32) -> bool) -> bool;
}

/// The same for every question. Implementations differ in time only: each names every box that the ray meets,
/// and maybe others.
pub trait Accelerator: AnyHit {
    /// Calls `visit(box, max)` with every box that the ray may meet inside `range`. `visit` returns the new
    /// `max`: the distance of the hit it keeps, or `max` unchanged. A result not above `range.min` ends the
    /// search.
    fn traverse(&self, ray: &Ray, range: Range, visit: impl FnMut(u32, f64) -> f64);

    /// Calls `visit` with every box that may contain `p`, until it returns true.
    fn any_at(&self, p: Vec3, visit: impl FnMut(u32) -> bool) -> bool;

    fn heap_bytes(&self) -> usize;
}
