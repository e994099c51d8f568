//! Lights: given a point, the direction, distance and colour arriving unshadowed. One file per way of
//! fading.

mod area;
mod cylinder;
mod fade;
mod packed;
mod photon_file;
mod spot;

pub use area::AreaLight;
pub use cylinder::CylinderBeam;
pub use fade::factor as fade_factor;
pub use packed::{PackedPhoton, Turns};
pub use photon_file::PhotonFile;
pub use spot::SpotBeam;

use crate::color::Rgb;
use crate::math::{Ray, Transform, Vec3};

/// A light as the author described it; directions are unit vectors, angles in radians.
#[derive(Clone, Debug)]
pub struct Light {
    pub location: Vec3,
    pub point_at: Vec3,
    pub color: Rgb,
    pub kind: LightKind,
    pub parallel: bool,
    pub area: Option<AreaLight>,
    pub shadowless: bool,
    pub fade_distance: f64,
    pub fade_power: f64,
    pub media_attenuation: bool,
    pub media_interaction: bool,
    pub photons: LightPhotons,
    /// The axis, once worked out by [`Light::prepared`].
    pub known_axis: Option<Vec3>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightKind {
    Point,
    /// A cone.
    Spot(SpotBeam),
    /// A beam of parallel sides.
    Cylinder(CylinderBeam),
}

/// A light's `photons{}`; switches that were not written are `None`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LightPhotons {
    pub refraction: Option<bool>,
    pub reflection: Option<bool>,
    pub area_light: bool,
}

/// What arrives at a point when nothing stands between.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrival {
    /// Unit vector from the point towards the light.
    pub direction: Vec3,
    /// How far blockers count. Negative behind a parallel light's plane.
    pub distance: f64,
    /// What cone and distance leave of the light.
    pub strength: f32,
    /// The light's colour times `strength`.
    pub color: Rgb,
}

/// Colours whose components all stay below this give no light.
pub const DARK: f32 = 1e-10;

impl Default for Light {
    fn default() -> Self {
        Self {
            location: Vec3::ZERO,
            point_at: Vec3::Z,
            color: Rgb::ZERO,
            kind: LightKind::Point,
            parallel: false,
            area: None,
            shadowless: false,
            fade_distance: 0.0,
            fade_power: 0.0,
            media_attenuation: false,
            media_interaction: true,
            photons: LightPhotons::default(),
            known_axis: None,
        }
    }
}

impl Light {
    /// Unit vector from the location towards `point_at`.
    #[inline]
    pub fn axis(&self) -> Vec3 {
        self.known_axis.unwrap_or_else(|| (self.point_at - self.location).normalize_or(Vec3::Z))
    }

    /// The same light, quicker to ask. It is not to be changed any more.
    pub fn prepared(mut self) -> Light {
        self.known_axis = None;
        self.known_axis = Some(self.axis());
        if let LightKind::Spot(beam) = &mut self.kind {
            *beam = beam.prepared();
        }
        self
    }

    /// The light at `p`; `offset` moves the lamp (a sample of an area light), else zero. `None` where no
    /// light arrives.
    #[inline]
    pub fn arrival(&self, p: Vec3, offset: Vec3) -> Option<Arrival> {
        self.arrival_from(p, offset, self.towards(p, offset))
    }

    /// The share of light that a cone leaves at an angle of cosine `c` from its axis.
    pub fn cone(&self, c: f64) -> f64 {
        match &self.kind {
            LightKind::Spot(beam) => beam.factor(c),
            _ => 1.0,
        }
    }

    /// The same with what [`Light::towards`] said.
    #[inline]
    pub fn arrival_from(&self, p: Vec3, offset: Vec3, (direction, distance): (Vec3, f64)) -> Option<Arrival> {
        let cone = match &self.kind {
            LightKind::Point => 1.0,
            LightKind::Spot(beam) => beam.factor(-direction.dot(self.axis())),
            LightKind::Cylinder(beam) => beam.factor(p - self.location - offset, self.axis()),
        };
        if cone <= 0.0 {
            return None;
        }
        let strength = (cone * fade::factor(distance, self.fade_distance, self.fade_power)) as f32;
        let color = self.color * strength;
        (!is_dark(color)).then_some(Arrival { direction, distance, strength, color })
    }

    /// Whether shadow rays end at its lamps, wherever they start.
    pub fn is_aimed_at(&self) -> bool {
        !self.parallel && !matches!(self.kind, LightKind::Cylinder(_))
    }

    /// Unit vector to the lamp and distance, for a lamp moved by `offset` from the location.
    #[inline]
    pub fn towards(&self, p: Vec3, offset: Vec3) -> (Vec3, f64) {
        let lamp = self.location + offset;
        let to_lamp = lamp - p;
        if self.parallel {
            let back = (lamp - self.point_at).normalize_or(-Vec3::Z);
            return (back, to_lamp.dot(back));
        }
        if let LightKind::Cylinder(_) = self.kind {
            let back = -self.axis();
            return (back, to_lamp.dot(back));
        }
        let distance = to_lamp.length();
        (to_lamp * distance.recip(), distance)
    }

    /// [`Light::towards`] for a lamp that shines from its location.
    #[inline]
    pub fn from_point(&self, p: Vec3) -> (Vec3, f64) {
        let to_lamp = self.location - p;
        let distance = to_lamp.length();
        (to_lamp * distance.recip(), distance)
    }

    /// Whether the light comes from one point, as strong everywhere, and casts shadows.
    pub fn is_plain(&self) -> bool {
        self.kind == LightKind::Point
            && !self.parallel
            && self.area.is_none()
            && !self.shadowless
            && (self.fade_power <= 0.0 || self.fade_distance == 0.0)
            && !is_dark(self.color)
    }

    /// The stretch of `ray` that the light's beam may light, unclipped.
    pub fn section(&self, ray: &Ray) -> Option<(f64, f64)> {
        match &self.kind {
            LightKind::Point => Some((f64::NEG_INFINITY, f64::INFINITY)),
            LightKind::Spot(beam) => beam.section(ray, self.location, self.axis()),
            LightKind::Cylinder(beam) => beam.section(ray, self.location, self.axis()),
        }
    }

    /// The light moved by `t`.
    pub fn transformed(&self, t: &Transform) -> Light {
        let mut light = self.clone();
        light.location = t.point(self.location);
        light.point_at = t.point(self.point_at);
        if let Some(area) = &mut light.area {
            area.axis1 = t.vector(area.axis1);
            area.axis2 = t.vector(area.axis2);
        }
        light
    }
}

/// Whether a colour counts as no light at all.
#[inline]
pub fn is_dark(color: Rgb) -> bool {
    color.abs().max_element() < DARK
}
