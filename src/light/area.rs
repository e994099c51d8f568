//! Area lights: a grid of lamps spread over a rectangle or a disc.
//!
//! Lamp (u, v) of an `n1` by `n2` grid stands at `axis1 (u/(n1-1) - 1/2) + axis2 (v/(n2-1) - 1/2)` from
//! the centre; a size of 1 puts it in the middle. On a disc, the square (a, b) is pulled in by
//! `max(|a|,|b|) / hypot(a,b)`.

use crate::math::Vec3;

#[derive(Clone, Debug, PartialEq)]
pub struct AreaLight {
    pub axis1: Vec3,
    pub axis2: Vec3,
    pub size1: u32,
    pub size2: u32,
    /// Subdivisions that are always made; the default 100 takes every lamp.
    pub adaptive: u32,
    pub jitter: bool,
    pub circular: bool,
    pub orient: bool,
    pub illumination: bool,
}

/// Keeps the centre of a disc off 0/0.
const OFF_CENTRE: f64 = 0.001;

impl AreaLight {
    pub const DEFAULT_ADAPTIVE: u32 = 100;

    pub fn new(axis1: Vec3, axis2: Vec3, size1: u32, size2: u32) -> Self {
        Self {
            axis1,
            axis2,
            size1,
            size2,
            adaptive: Self::DEFAULT_ADAPTIVE,
            jitter: false,
            circular: false,
            orient: false,
            illumination: false,
        }
    }

    /// The two axes as seen along `direction`, the unit vector to the light's centre: its own, or for an
    /// oriented light two across the direction.
    pub fn axes(&self, direction: Vec3) -> (Vec3, Vec3) {
        if !self.orient {
            return (self.axis1, self.axis2);
        }
        let helper = if (direction.z.abs() - 1.0).abs() < 0.01 { Vec3::Y } else { Vec3::Z };
        let across = direction.cross(helper).normalize();
        let length = self.axis1.length();
        (across * length, direction.cross(across).normalize() * length)
    }

    /// Where lamp (u, v) stands from the centre; u and v may lie between lamps.
    pub fn offset(&self, (axis1, axis2): (Vec3, Vec3), u: f64, v: f64) -> Vec3 {
        let part = |x: f64, size: u32| if size > 1 { x / f64::from(size - 1) - 0.5 } else { 0.0 };
        let (a, b) = (part(u, self.size1), part(v, self.size2));
        if self.is_disc() {
            let (a, b) = (a + OFF_CENTRE, b + OFF_CENTRE);
            let q = a.abs().max(b.abs()) / (a * a + b * b).sqrt();
            axis1 * (a * q) + axis2 * (b * q)
        } else {
            axis1 * a + axis2 * b
        }
    }

    /// How far lamps stand from the centre along each axis of space, at most, shaken ones too.
    pub fn reach(&self, (axis1, axis2): (Vec3, Vec3)) -> Vec3 {
        let part = |size: u32| match size {
            0 | 1 => 0.0,
            n if self.jitter => 0.5 + 0.5 / f64::from(n - 1) + OFF_CENTRE,
            _ => 0.5 + OFF_CENTRE,
        };
        axis1.abs() * part(self.size1) + axis2.abs() * part(self.size2)
    }

    fn is_disc(&self) -> bool {
        (self.circular || self.orient) && self.size1 > 1 && self.size2 > 1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_and_middle_of_a_rectangle() {
        let area = AreaLight::new(4.0 * Vec3::X, 2.0 * Vec3::Y, 5, 1);
        let axes = area.axes(Vec3::Z);
        assert_eq!(area.offset(axes, 0.0, 0.0), Vec3::new(-2.0, 0.0, 0.0));
        assert_eq!(area.offset(axes, 4.0, 0.0), Vec3::new(2.0, 0.0, 0.0));
        assert_eq!(area.offset(axes, 2.0, 0.0), Vec3::ZERO);
    }

    #[test]
    fn no_lamp_stands_beyond_the_reach() {
        for (circular, jitter, size) in
            [(false, false, 5), (true, false, 4), (false, true, 2), (true, true, 3)]
        {
            let mut area =
                AreaLight::new(Vec3::new(4.0, 1.0, 0.0), Vec3::new(-1.0, 2.0, 3.0), size, size + 1);
            (area.circular, area.jitter) = (circular, jitter);
            let axes = area.axes(Vec3::Z);
            let reach = area.reach(axes);
            let shift = if jitter { 0.5 } else { 0.0 };
            for i in 0..100u32 {
                let (u, v) = (f64::from(i % 10) / 9.0, f64::from(i / 10) / 9.0);
                let along = |x: f64, n: u32| x * (f64::from(n - 1) + 2.0 * shift) - shift;
                let offset = area.offset(axes, along(u, size), along(v, size + 1));
                assert!(offset.abs().cmple(reach).all(), "{offset} {reach}");
            }
        }
    }

    #[test]
    fn disc_corners_lie_on_the_rim() {
        let mut area = AreaLight::new(4.0 * Vec3::X, 4.0 * Vec3::Y, 5, 5);
        area.circular = true;
        let corner = area.offset(area.axes(Vec3::Z), 4.0, 4.0);
        assert!((corner.length() - 2.0).abs() < 0.01, "{corner}");
    }

    #[test]
    fn oriented_axes_stand_across_the_direction() {
        let mut area = AreaLight::new(3.0 * Vec3::X, 1.0 * Vec3::Y, 4, 4);
        area.orient = true;
        let direction = Vec3::new(1.0, 2.0, -2.0) / 3.0;
        let (a, b) = area.axes(direction);
        assert!(a.dot(direction).abs() < 1e-12 && b.dot(direction).abs() < 1e-12 && a.dot(b).abs() < 1e-12);
        assert!((a.length() - 3.0).abs() < 1e-12 && (b.length() - 3.0).abs() < 1e-12);
    }
}
