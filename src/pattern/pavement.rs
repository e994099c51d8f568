use super::{Modifier, Pattern, Setting};
use crate::math::Vec3;
use std::sync::Arc;

/// Pavings by polyforms. Their settings are read, but where the tiles lie is not known here: the value is 0
/// everywhere, and the author is told.
#[derive(Clone, Copy, Debug)]
pub struct Pavement;

impl Pattern for Pavement {
    fn value(&self, _p: Vec3, _setting: &Setting) -> f64 {
        0.0
    }

    fn modified(&self, modifier: Modifier) -> Option<Arc<dyn Pattern>> {
        match modifier {
            Modifier::Sides(_)
            | Modifier::Tiles(_)
            | Modifier::Number(_)
            | Modifier::Exterior(..)
            | Modifier::Interior(..)
            | Modifier::Form(_) => Some(Arc::new(*self)),
            _ => None,
        }
    }
}
