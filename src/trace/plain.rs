//! Surfaces that light only comes from straight: one opaque layer, lit by lights, perhaps mirroring. Most are
//! like that, and need no lists of what else is to be traced.

use super::direct::Look;
use super::layers;
use super::path::Path;
use super::shade::{Bounce, Site, declared_maximum};
use super::tracer::Tracer;
use crate::color::Rgb;
use crate::math::Ray;
use crate::world::{Hit, Surface};
use std::cell::Cell;

/// The quality from which on everything is traced.
const FULL_QUALITY: u8 = 9;

impl<'w> Tracer<'w> {
    /// Whether light only comes straight from lights and mirrors, as far as the scene goes.
    #[inline]
    fn lights_straight(&self) -> bool {
        self.radiosity.is_none()
            && self.photons.is_none()
            && self.subsurface.is_none()
            && self.settings.quality >= FULL_QUALITY
            && self.adc_bailout < 1.0
    }

    /// The colour of a hit, if its surface is as plain as that; the same as the long way gives.
    #[inline]
    pub(super) fn plain(&mut self, ray: &Ray, hit: &Hit, path: &Path) -> Option<Rgb> {
        if !self.lights_straight() {
            return None;
        }
        let surface = self.world.sole_surface(hit, hit.normal.dot(ray.dir) > 0.0)?;
        if !surface.plain || hit.uv_mapping {
            return None;
        }
        self.plain_light(&Site::new(ray, hit, path), surface)
    }

    #[inline]
    fn plain_light(&mut self, site: &Site, surface: &'w Surface) -> Option<Rgb> {
        let placed = layers::sole(surface, site.hit)?;
        let normal = self.normal(site, &placed, &Cell::new(site.facing));
        let color = self.pigment(site, &placed, normal)?;
        let finish = &*placed.layer.finish;
        let k = self.reflectivity(site, finish, normal, color.rgb);
        let look = Look { finish, color: color.rgb, opacity: self.opacity(color), normal };
        let glow = finish.emission + finish.ambient * self.world.scene.globals.ambient_light;
        let mut rgb = look.color * (glow * look.opacity) + self.direct(site, &look);
        if k != Rgb::ZERO {
            let weight = site.path.weight * declared_maximum(finish, k);
            rgb += self.bounce(site, &Bounce { share: 1.0, k, weight, normal, finish, through: None });
        }
        Some(rgb)
    }
}
