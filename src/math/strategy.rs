//! What property tests draw.

use super::Vec3;
use proptest::prelude::*;

/// Components up to `size`, of either sign.
pub fn vector(size: f64) -> impl Strategy<Value = Vec3> {
    (-size..size, -size..size, -size..size).prop_map(|(x, y, z)| Vec3::new(x, y, z))
}
