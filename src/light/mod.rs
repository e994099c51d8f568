//! Lights: given a point, the direction, distance and colour arriving unshadowed.

use crate::color::Rgb;
use crate::math::Vec3;

/// A light as the author described it; directions are unit vectors, angles in radians.
#[derive(Clone, Debug)]
pub struct Light {
    pub location: Vec3,
    pub color: Rgb,
    pub kind: LightKind,
    pub parallel: bool,
    /// Unit vector from the location towards `point_at`.
    pub direction: Vec3,
    pub area: Option<AreaLight>,
    pub shadowless: bool,
    pub fade_distance: f64,
    pub fade_power: f64,
    pub media_attenuation: bool,
    pub media_interaction: bool,
}

#[derive(Clone, Debug, PartialEq)]
pub enum LightKind {
    Point,
    /// A cone; `radius` and `falloff` are half angles in radians.
    Spot {
        radius: f64,
        falloff: f64,
        tightness: f64,
    },
    /// A cylinder; `radius` and `falloff` are lengths.
    Cylinder {
        radius: f64,
        falloff: f64,
        tightness: f64,
    },
}

#[derive(Clone, Debug, PartialEq)]
pub struct AreaLight {
    pub axis1: Vec3,
    pub axis2: Vec3,
    pub size1: u32,
    pub size2: u32,
    pub adaptive: u32,
    pub jitter: bool,
    pub circular: bool,
    pub orient: bool,
    pub illumination: bool,
}
