use super::ImageMap;
use crate::color::grey;
use crate::math::Vec3;
use crate::pattern::{Character, Pattern, Setting};

/// An image as a pattern: its grey values, 0 outside.
#[derive(Clone, Debug)]
pub struct ImagePattern {
    pub map: ImageMap,
    pub value: ImageValue,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ImageValue {
    Grey,
    /// Transparency if the file has any, else red.
    Alpha,
}

impl Pattern for ImagePattern {
    fn value(&self, p: Vec3, _setting: &Setting) -> f64 {
        let Some(color) = self.map.color(p) else { return 0.0 };
        let value = match self.value {
            ImageValue::Grey => grey(color.rgb),
            ImageValue::Alpha if self.map.image.has_alpha() => color.transmit,
            ImageValue::Alpha => color.rgb.x,
        };
        f64::from(value).clamp(0.0, 1.0)
    }

    fn character(&self) -> Character {
        Character::APERIODIC
    }
}
