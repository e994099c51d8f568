//! Two tiny contracts that cut circles: functions, patterns, pigments and shapes all hold these, never each
//! other.

use super::{Aabb, Vec3};
use std::fmt::Debug;

/// A number at every point of space.
pub trait Field: Debug + Send + Sync {
    fn value(&self, p: Vec3) -> f64;

    /// How many functions, patterns, pigments and objects stand within each other here.
    fn depth(&self) -> u32 {
        0
    }

    /// Two numbers between which all values inside a box lie, if that is known.
    fn range(&self, _b: &Aabb) -> Option<(f64, f64)> {
        None
    }

    /// What is known of values and derivatives inside a box.
    fn enclosure(&self, b: &Aabb) -> Option<Enclosure> {
        let all = (f64::NEG_INFINITY, f64::INFINITY);
        self.range(b).map(|range| Enclosure { range, gradient: [all; 3] })
    }
}

/// What is known of a field inside a box: two numbers between which its values lie, and two between which
/// each of its derivatives lies. Infinite ones say nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Enclosure {
    pub range: (f64, f64),
    pub gradient: [(f64, f64); 3],
}

/// A part of space.
pub trait Solid: Debug + Send + Sync {
    fn contains(&self, p: Vec3) -> bool;

    /// As [`Field::depth`].
    fn depth(&self) -> u32 {
        0
    }
}
