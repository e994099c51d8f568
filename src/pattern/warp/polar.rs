use super::oriented;
use crate::math::Vec3;
use std::f64::consts::{PI, TAU};

/// Turns angles about y into coordinates, so that a flat pattern wraps a sphere, cylinder or torus.
///
/// | parameter | default | meaning |
/// |---|---|---|
/// | orientation | z | unit vector along which the pattern's third coordinate runs |
/// | dist_exp | 0 | angles are scaled by this power of the distance |
/// | major_radius | 1 | of the torus |
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Polar {
    pub kind: PolarKind,
    pub orientation: Vec3,
    pub distance_exponent: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PolarKind {
    Spherical,
    Cylindrical,
    Toroidal { major_radius: f64 },
}

/// The angle about y in turns, 0..1, from +x towards +z.
pub(crate) fn turn(x: f64, z: f64) -> f64 {
    if z == 0.0 {
        return if x > 0.0 { 0.0 } else { 0.5 };
    }
    let angle = (x / (x * x + z * z).sqrt()).acos();
    (if z < 0.0 { TAU - angle } else { angle }) / TAU
}

/// Longitude and latitude as parts of a whole, and the distance; `None` at the origin.
pub(crate) fn spherical(p: Vec3) -> Option<(f64, f64, f64)> {
    let d = p.length();
    if d == 0.0 {
        return None;
    }
    let latitude = 0.5 + (p.y / d).clamp(-1.0, 1.0).asin() / PI;
    let longitude = if p.x == 0.0 && p.z == 0.0 { 0.0 } else { turn(p.x, p.z) };
    Some((longitude, latitude, d))
}

/// Longitude and the distance from the y axis; `None` on the axis.
pub(crate) fn cylindrical(p: Vec3) -> Option<(f64, f64)> {
    let d = (p.x * p.x + p.z * p.z).sqrt();
    if d == 0.0 { None } else { Some((turn(p.x, p.z), d)) }
}

/// Longitude, the angle about the ring, and the distance from the ring; `None` on the y axis.
pub(crate) fn toroidal(p: Vec3, major_radius: f64) -> Option<(f64, f64, f64)> {
    let (longitude, length) = cylindrical(p)?;
    let x = length - major_radius;
    let d = (x * x + p.y * p.y).sqrt();
    let angle = (-x / d).clamp(-1.0, 1.0).acos();
    let angle = if p.y > 0.0 { TAU - angle } else { angle };
    Some((longitude, angle / TAU, d))
}

impl Polar {
    pub fn apply(&self, p: Vec3) -> Vec3 {
        let scale = |angle: f64, d: f64| {
            if self.distance_exponent == 0.0 {
                angle
            } else if self.distance_exponent == 1.0 {
                angle * d
            } else {
                angle * d.powf(self.distance_exponent)
            }
        };
        let triple = match self.kind {
            PolarKind::Spherical => spherical(p).map(|(th, ph, d)| (scale(th, d), scale(ph, d), d)),
            PolarKind::Cylindrical => cylindrical(p).map(|(th, d)| (scale(th, d), p.y, d)),
            PolarKind::Toroidal { major_radius } => {
                toroidal(p, major_radius).map(|(th, ph, d)| (scale(th, d), scale(ph, d), d))
            }
        };
        triple.map_or(p, |triple| oriented(self.orientation, triple))
    }
}
