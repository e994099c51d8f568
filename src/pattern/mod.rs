//! Patterns: a point in, a value out. One file each.

use crate::math::{Vec2, Vec3};
use std::fmt::Debug;

/// Which lattice noise a pattern uses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoiseGenerator {
    Original = 1,
    RangeCorrected = 2,
    Perlin = 3,
}

/// What a pattern may ask about besides the point.
#[derive(Clone, Copy, Debug)]
pub struct Context<'a> {
    /// The scene's generator, for patterns without one of their own.
    pub noise: NoiseGenerator,
    /// `number_of_waves`.
    pub waves: usize,
    /// The surface hit, if there is one (not in functions, nor in the sky).
    pub hit: Option<&'a Incidence>,
}

/// How a ray met a surface, in world space.
#[derive(Clone, Copy, Debug)]
pub struct Incidence {
    pub point: Vec3,
    /// The normal after the most recent perturbation, turned towards the ray; unit length.
    pub normal: Vec3,
    /// The ray's unit direction.
    pub direction: Vec3,
    pub uv: Vec2,
}

/// A scalar field over space: a point of the pattern's own space to its raw value.
pub trait Pattern: Debug + Send + Sync {
    fn value(&self, p: Vec3, context: &Context) -> f64;
}
