//! Two tiny contracts that cut circles: functions, patterns, pigments and shapes all hold these, never each
//! other.

use super::{Aabb, Vec3};
use std::fmt::Debug;

/// A number at every point of space.
pub trait Field: Debug + Send + Sync {
    fn value(&self, p: Vec3) -> f64;

    /// Two numbers between which all values inside a box lie, if that is known.
    fn range(&self, _b: &Aabb) -> Option<(f64, f64)> {
        None
    }
}

/// A part of space.
pub trait Solid: Debug + Send + Sync {
    fn contains(&self, p: Vec3) -> bool;
}
