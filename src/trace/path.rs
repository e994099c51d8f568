//! What a ray carries along, and what it brings back.

use crate::color::Rgb;
use crate::math::{Ray, Vec3};
use crate::world::{Hit, InteriorId, RayClass};
use smallvec::SmallVec;

/// The interiors that a ray is inside of, in order of entering.
pub(super) type Interiors = SmallVec<[InteriorId; 4]>;

/// A copy, at once instead of one by one.
#[inline]
pub(super) fn copied(inside: &Interiors) -> Interiors {
    SmallVec::from_slice(inside)
}

/// The history of a ray.
#[derive(Debug)]
pub(super) struct Path {
    /// Hits before this ray that count for `max_trace_level`.
    pub level: u32,
    /// At most this much of the ray's colour reaches the picture.
    pub weight: f32,
    pub class: RayClass,
    /// Wavelength in nanometres, once dispersion has split the ray.
    pub wavelength: Option<f64>,
    pub inside: Interiors,
}

impl Clone for Path {
    #[inline]
    fn clone(&self) -> Self {
        Self { inside: copied(&self.inside), ..*self }
    }
}

/// Colour brought back by a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Radiance {
    pub rgb: Rgb,
    /// How much of nothing shows through.
    pub transmit: f32,
}

impl Radiance {
    pub const BLACK: Radiance = Radiance { rgb: Rgb::ZERO, transmit: 0.0 };
}

/// What lies over a stretch of a ray: light behind it comes through as `factor * light + added`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Veil {
    pub factor: Rgb,
    pub added: Rgb,
    /// Factor of the transmit part.
    pub clear: f32,
}

impl Veil {
    pub const NONE: Veil = Veil { factor: Rgb::ONE, added: Rgb::ZERO, clear: 1.0 };

    /// `self` seen through `front`.
    #[inline]
    pub fn under(self, front: Veil) -> Veil {
        Veil {
            factor: front.factor * self.factor,
            added: front.added + front.factor * self.added,
            clear: front.clear * self.clear,
        }
    }

    #[inline]
    pub fn over(&self, light: Radiance) -> Radiance {
        Radiance { rgb: self.factor * light.rgb + self.added, transmit: self.clear * light.transmit }
    }
}

/// A place that rays leave from.
#[derive(Clone, Copy, Debug)]
pub(super) struct Departure {
    pub point: Vec3,
    /// Unit normal of the surface, on either side.
    pub normal: Vec3,
    /// Bound on the distance of `point` from the true surface; 0 in free space.
    pub error: f64,
}

impl Departure {
    /// How many error bounds a ray starts away from its surface: one reaches the surface, one is for the
    /// rounding of the ray's own first step.
    const MARGIN: f64 = 2.0;

    #[inline]
    pub fn from_hit(hit: &Hit) -> Self {
        Self { point: hit.point, normal: hit.face, error: hit.error }
    }

    #[inline]
    pub fn free(point: Vec3) -> Self {
        Self { point, normal: Vec3::ZERO, error: 0.0 }
    }

    /// The ray towards `direction`, started on the side of the surface that it goes to.
    #[inline]
    pub fn ray(&self, direction: Vec3) -> Ray {
        let shift = (Self::MARGIN * self.error).copysign(direction.dot(self.normal));
        Ray::new(self.point + shift * self.normal, direction)
    }
}
