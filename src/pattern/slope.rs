//! Slope: how far a surface leans towards a direction, mixed with how high it lies.
//!
//! With `s` the cosine between the normal and the direction, the value is `(1 + asin(s) 2/π) / 2`: 0 where the
//! surface faces away, 0.5 where it stands along, 1 where it faces. Away from surfaces it is 0.
//!
//! | parameter | default | meaning |
//! |---|---|---|
//! | direction or point_at | | world space |
//! | low, high | 0, 0 | slopes that become 0 and 1; equal: all |
//! | altitude | none | a direction in pattern space, with its own low and high |

use super::{EDGE, Pattern, Setting};
use crate::math::Vec3;
use std::f64::consts::FRAC_2_PI;

#[derive(Clone, Copy, Debug)]
pub struct Slope {
    pub direction: SlopeDirection,
    pub low: f64,
    pub high: f64,
    pub altitude: Option<Altitude>,
}

#[derive(Clone, Copy, Debug)]
pub enum SlopeDirection {
    /// Any length; it weighs against the length of the altitude's direction.
    Along(Vec3),
    /// Towards this point.
    PointAt(Vec3),
}

#[derive(Clone, Copy, Debug)]
pub struct Altitude {
    pub direction: Vec3,
    pub low: f64,
    pub high: f64,
}

/// `v` measured from `low` in units of `high - low`.
fn ranged(v: f64, low: f64, high: f64) -> f64 {
    if high == low { v } else { (v - low) / (high - low) }
}

/// Wrapped to 0..1; what is 1 or hardly above stays just below.
fn wrapped(v: f64) -> f64 {
    let v = if (1.0..1.0 + EDGE).contains(&v) { v - EDGE } else { v % 1.0 };
    if v < 0.0 { v + 1.0 } else { v }
}

impl Pattern for Slope {
    fn asks_hit(&self) -> bool {
        true
    }

    fn value(&self, p: Vec3, setting: &Setting) -> f64 {
        let Some(hit) = setting.context.hit else { return 0.0 };
        let (direction, length) = match self.direction {
            SlopeDirection::Along(v) => (v, v.length()),
            SlopeDirection::PointAt(q) => (q - hit.point, (q - hit.point).length()),
        };
        let cosine = hit.normal.dot(direction) / length;
        let slope = 0.5 * (1.0 + cosine.clamp(-1.0, 1.0).asin() * FRAC_2_PI);
        let slope = ranged(slope, self.low, self.high);
        let Some(altitude) = self.altitude else { return wrapped(slope) };
        let height = altitude.direction.length();
        let a = ranged(p.dot(altitude.direction) / height, altitude.low, altitude.high);
        let weight = length / (length + height);
        wrapped(weight * slope + (1.0 - weight) * a)
    }
}
