//! Many lights at a place that only adds to a gathered sample: a few of them speak for all.
//!
//! Each light is asked what it would give without shadows, which costs little. A few are then picked, each as
//! often as it would give, and only those are looked for behind blockers. Where none or all of them are in
//! shadow the sum is exact; only where some are does chance decide, and a gather takes the mean over many
//! such places. The mean is that of all lights.
//!
//! Reference: P. Shirley, C. Wang, K. Zimmerman, "Monte Carlo Techniques for Direct Lighting Calculations",
//! ACM Transactions on Graphics 15, 1996.

use super::direct::{LIT, Look};
use super::light_row::Spot;
use super::shade::Site;
use super::tracer::Tracer;
use crate::color::Rgb;
use crate::light::is_dark;
use crate::math::Vec3;
use crate::world::{RayClass, WorldLight};
use smallvec::SmallVec;

/// So few lights are all tested.
pub(super) const FEW: usize = 4;

/// One light of so many is tested.
const SHARE: usize = 8;

/// What a light would give without shadows.
struct Offer<'w> {
    source: &'w WorldLight,
    behind: bool,
    /// What the layer would send, about.
    strength: f32,
}

impl<'w> Tracer<'w> {
    /// Whether a few of so many lights do for a layer.
    pub(super) fn may_choose(&self, site: &Site, look: &Look, lights: usize) -> bool {
        lights > FEW
            && site.path.class == RayClass::Radiosity
            && site.lit.is_none()
            && look.finish.crand == 0.0
            && !self.settings.overrides.reference
    }

    /// What the layer sends of all lights in the mean.
    pub(super) fn chosen(
        &mut self,
        site: &Site,
        look: &Look,
        lights: impl Iterator<Item = &'w WorldLight>,
    ) -> Rgb {
        let mut offers: SmallVec<[Offer; 16]> = SmallVec::new();
        if !self.offers_at_once(site, look, &mut offers) {
            offers.extend(lights.filter_map(|source| self.offer(site, look, source)));
        }
        let total: f32 = offers.iter().map(|o| o.strength).sum();
        let picks = (offers.len() / SHARE).max(1);
        let step = total / picks as f32;
        if offers.len() <= picks || !(step > f32::MIN_POSITIVE) {
            return offers.iter().filter_map(|o| self.taken(site, look, o)).sum();
        }
        let mut next = step * self.random.draw() as f32;
        let (mut sum, mut passed) = (Rgb::ZERO, 0.0);
        for offer in &offers {
            passed += offer.strength;
            let mut count = 0.0;
            while next < passed {
                next += step;
                count += 1.0;
            }
            if count > 0.0 {
                let light = self.taken(site, look, offer).unwrap_or(Rgb::ZERO);
                sum += light * (count * step / offer.strength);
            }
        }
        sum
    }

    /// Asks all lights at once, if they are of kinds for which that goes.
    fn offers_at_once(&self, site: &Site, look: &Look, offers: &mut SmallVec<[Offer<'w>; 16]>) -> bool {
        let Some(row) = &self.light_row else { return false };
        let (hit, lights) = (site.hit, &self.world.lights[..]);
        let global_only = !hit.ignores_global_lights && hit.group_lights.0 == hit.group_lights.1;
        if !global_only || look.finish.diffuse_back != 0.0 {
            return false;
        }
        let least = if hit.double_illuminate { f32::NEG_INFINITY } else { LIT as f32 };
        let spot = Spot { point: hit.point, normal: look.normal, least };
        let share = look.finish.diffuse.abs();
        let cone = |i: usize, c: f32| lights[i].light.cone(f64::from(c)) as f32;
        row.each(&spot, cone, |i, given| {
            let (source, strength) = (&lights[i], share * given);
            if strength > 0.0 {
                offers.push(Offer { source, behind: false, strength });
            }
        });
        true
    }

    fn offer(&self, site: &Site, look: &Look, source: &'w WorldLight) -> Option<Offer<'w>> {
        let (light, point) = (&source.light, site.hit.point);
        let towards = light.towards(point, Vec3::ZERO);
        let behind = look.is_lit_from_behind(towards.0, site.hit.double_illuminate)?;
        let arrival = light.arrival_from(point, Vec3::ZERO, towards)?;
        let share = if behind { look.finish.diffuse_back } else { look.finish.diffuse };
        let cosine = look.normal.dot(towards.0).abs() as f32;
        let strength = arrival.color.abs().max_element() * (cosine * share.abs());
        (strength > 0.0).then_some(Offer { source, behind, strength })
    }

    /// What the layer sends of one light.
    fn taken(&mut self, site: &Site, look: &Look, offer: &Offer) -> Option<Rgb> {
        let Offer { source, behind, .. } = offer;
        let arrival = source.light.arrival(site.hit.point, Vec3::ZERO)?;
        let color = self.shadowed(&site.departure(), &site.path.inside, source, &arrival, site.path.class);
        let shadowless = source.light.shadowless;
        (!is_dark(color)).then(|| self.answer(site, look, arrival.direction, color, *behind, shadowless))
    }
}
