use super::ImageMap;
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
        let Some((u, v)) = self.map.coordinates(p) else { return 0.0 };
        if self.value == ImageValue::Grey {
            return self.map.grey_at(u, v).clamp(0.0, 1.0);
        }
        let color = self.map.color_at(u, v);
        let value = match self.value {
            ImageValue::Alpha if self.map.image.has_alpha() => color.transmit,
            _ => color.rgb.x,
        };
        f64::from(value).clamp(0.0, 1.0)
    }

    fn character(&self) -> Character {
        Character::APERIODIC
    }
}
