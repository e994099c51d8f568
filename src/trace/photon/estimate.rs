//! The light that photons around a point stand for.
//!
//! On surfaces the energies over the area of the search, `sum E / (pi r^2)`, each as a light of its own
//! direction; in media over the volume, `3 sum E / (4 pi r^3)`, scattered towards the eye.

use super::super::direct::Look;
use super::super::media::Stretch;
use super::super::shade::Site;
use super::super::tracer::Tracer;
use super::map::Metric;
use super::{Nearby, Neighbourhoods, Photons};
use crate::color::Rgb;
use crate::light::Turns;
use crate::math::Vec3;
use crate::world::RayClass;
use std::f64::consts::PI;

/// Photons that graze the surface count as if they came from no less than this cosine.
const LEAST_COSINE: f64 = 0.1;

/// The second search reaches this much farther.
const WIDER: f64 = 3.0;

/// Searches pass by a few photons: so many are clearly more, as a share.
const CLEARLY: usize = 8;

/// Densities below count as this.
const NO_DENSITY: f64 = 1e-16;

impl Tracer<'_> {
    /// Light that photons bring to a layer.
    pub(in crate::trace) fn caustics(&mut self, site: &Site, look: &Look) -> Rgb {
        let f = look.finish;
        let answers = f.diffuse != 0.0 || f.diffuse_back != 0.0 || f.specular != 0.0 || f.phong != 0.0;
        let Some(photons) = self.photons.clone() else { return Rgb::ZERO };
        if !answers || photons.surface.is_empty() || !self.world.photon_rules(site.hit).collect {
            return Rgb::ZERO;
        }
        let nearby = match site.photons.take() {
            Some(nearby) => nearby,
            None => self.photons_around(site.hit.point, look.normal),
        };
        let shines = (f.phong > 0.0 || f.specular > 0.0) && site.path.class != RayClass::Radiosity;
        let plain = !shines && f.irid == 0.0 && f.crand == 0.0 && f.brilliance == 1.0;
        let sum = if plain && !self.is_translucent(look) {
            diffused(&photons, &nearby, site, look)
        } else {
            self.answered(&photons, &nearby, site, look)
        };
        let area = PI * nearby.radius * nearby.radius;
        site.photons.set(Some(nearby));
        sum / area as f32
    }

    /// Each photon as a light of its own.
    fn answered(&mut self, photons: &Photons, nearby: &Nearby, site: &Site, look: &Look) -> Rgb {
        let mut sum = Rgb::ZERO;
        for (towards, light, behind) in lights(photons, nearby, site, look) {
            sum += self.answer(site, look, towards, light, behind, false);
        }
        sum
    }

    /// The photons that count at a point of a surface; where they are too few, those from farther around.
    fn photons_around(&mut self, point: Vec3, normal: Vec3) -> Nearby {
        let mut nearby = self.spare_nearby.pop().unwrap_or_default();
        let Some(photons) = self.photons.clone() else { return nearby };
        let s = &photons.settings;
        let most = s.gather_max as usize;
        let late = &mut self.photons_of_late;
        photons.surface.gather_near(point, photons.surface_radius, most, Some(normal), &mut nearby, late);
        if nearby.members.len() >= s.gather_min as usize {
            return nearby;
        }
        let mut wider = self.spare_nearby.pop().unwrap_or_default();
        let metric = Metric::new(point, Some(normal));
        if is_crowded(&photons, &nearby, &metric, &mut wider, late) {
            self.spare_nearby.push(wider);
            return nearby;
        }
        let (late, radius) = (&mut self.photons_of_late, WIDER * photons.surface_radius);
        photons.surface.gather_near(point, radius, most, Some(normal), &mut wider, late);
        let before = density(&nearby);
        let grows = (density(&wider) - before) / before;
        let some = (1..s.expand_min as usize).contains(&wider.members.len());
        if grows < s.expand_increase || some {
            std::mem::swap(&mut nearby, &mut wider);
        }
        self.spare_nearby.push(wider);
        nearby
    }

    /// Light of photons at a point in media that is scattered along the ray, for scattering 1.
    pub(in crate::trace) fn scattered_photons(&mut self, stretch: &Stretch, p: Vec3) -> Rgb {
        let Some(photons) = self.photons.clone() else { return Rgb::ZERO };
        if photons.media.is_empty() {
            return Rgb::ZERO;
        }
        let mut nearby = self.spare_nearby.pop().unwrap_or_default();
        let most = photons.settings.gather_max as usize;
        photons.media.gather(p, photons.media_radius, most, None, &mut nearby);
        let mut sum = Rgb::ZERO;
        for &(_, place) in &nearby.members {
            let photon = &photons.media.photons()[place as usize];
            sum += self.phase(stretch, photon.towards().dot(stretch.ray.dir)) * photon.energy();
        }
        let volume = 4.0 / 3.0 * PI * nearby.radius.powi(3);
        self.spare_nearby.push(nearby);
        sum / volume as f32
    }
}

/// Photons found in a square.
fn density(found: &Nearby) -> f64 {
    (found.members.len() as f64 / (found.radius * found.radius)).max(NO_DENSITY)
}

/// Whether so many photons lie farther around that the second search is in vain, whichever of them are the nearest:
/// it would be full, and its photons too dense.
fn is_crowded(
    photons: &Photons,
    found: &Nearby,
    metric: &Metric,
    spare: &mut Nearby,
    late: &Neighbourhoods,
) -> bool {
    let s = &photons.settings;
    let most = s.gather_max as usize;
    let dense = (most as f64 / ((1.0 + s.expand_increase) * density(found))).sqrt();
    let radius = dense.min(WIDER * photons.surface_radius);
    s.gather_max >= s.expand_min
        && photons.surface.has_near(most + most / CLEARLY, metric, radius, spare, late)
}

/// Direction and light of each photon that reaches the layer, and whether it does so from behind.
fn lights<'a>(
    photons: &'a Photons,
    nearby: &'a Nearby,
    site: &'a Site,
    look: &'a Look,
) -> impl Iterator<Item = (Vec3, Rgb, bool)> + 'a {
    let turns = Turns::get();
    nearby.members.iter().filter_map(move |&(_, place)| {
        let photon = &photons.surface.photons()[place as usize];
        let towards = turns.towards(photon);
        let behind = look.is_lit_from_behind(towards, site.hit.double_illuminate)?;
        let cosine = site.facing.dot(towards).clamp(LEAST_COSINE, 1.0);
        Some((towards, photon.energy() / cosine as f32, behind))
    })
}

/// The answer of a layer that only reflects diffusely.
fn diffused(photons: &Photons, nearby: &Nearby, site: &Site, look: &Look) -> Rgb {
    let mut sum = Rgb::ZERO;
    for (towards, light, behind) in lights(photons, nearby, site, look) {
        let share = if behind { look.finish.diffuse_back } else { look.finish.diffuse };
        sum += light * (look.normal.dot(towards).abs() as f32 * share.max(0.0));
    }
    look.color * sum * look.opacity
}
