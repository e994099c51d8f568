//! Two tiny contracts that cut circles: functions, patterns, pigments and shapes all hold these, never each
//! other.

use super::Vec3;
use std::fmt::Debug;

/// A number at every point of space.
pub trait Field: Debug + Send + Sync {
    fn value(&self, p: Vec3) -> f64;
}

/// A part of space.
pub trait Solid: Debug + Send + Sync {
    fn contains(&self, p: Vec3) -> bool;
}
