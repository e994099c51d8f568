//! Many lights at a place that only adds to a gathered sample: a few of them speak for all.
//!
//! Each light is asked what it would give without shadows, which costs little. A few are then picked, each as
//! often as it would give, and only those are looked for behind blockers. Where none or all of them are in
//! shadow the sum is exact; only where some are does chance decide, and a gather takes the mean over many
//! such places. The mean is that of all lights.
//!
//! Reference: P. Shirley, C. Wang, K. Zimmerman, "Monte Carlo Techniques for Direct Lighting Calculations",
//! ACM Transactions on Graphics 15, 1996.

use super::direct::Look;
use super::shade::Site;
use super::tracer::Tracer;
use crate::color::Rgb;
use crate::light::{Arrival, is_dark};
use crate::math::Vec3;
use crate::world::{RayClass, WorldLight};
use smallvec::SmallVec;

/// So few lights are all tested.
const FEW: usize = 4;

/// One light of so many is tested.
const SHARE: usize = 8;

/// What a light would give without shadows.
struct Offer<'w> {
    source: &'w WorldLight,
    arrival: Arrival,
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
        let mut total = 0.0;
        for source in lights {
            if let Some(offer) = self.offer(site, look, source) {
                total += offer.strength;
                offers.push(offer);
            }
        }
        let picks = (offers.len() / SHARE).max(1);
        let step = total / picks as f32;
        if offers.len() <= picks || !(step > f32::MIN_POSITIVE) {
            return offers.iter().map(|o| self.taken(site, look, o)).sum();
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
                sum += self.taken(site, look, offer) * (count * step / offer.strength);
            }
        }
        sum
    }

    fn offer(&self, site: &Site, look: &Look, source: &'w WorldLight) -> Option<Offer<'w>> {
        let (light, point) = (&source.light, site.hit.point);
        let towards = light.towards(point, Vec3::ZERO);
        let behind = look.is_lit_from_behind(towards.0, site.hit.double_illuminate)?;
        let arrival = light.arrival_from(point, Vec3::ZERO, towards)?;
        let share = if behind { look.finish.diffuse_back } else { look.finish.diffuse };
        let cosine = look.normal.dot(towards.0).abs() as f32;
        let strength = arrival.color.abs().max_element() * (cosine * share.abs());
        (strength > 0.0).then_some(Offer { source, arrival, behind, strength })
    }

    /// What the layer sends of one light.
    fn taken(&mut self, site: &Site, look: &Look, offer: &Offer) -> Rgb {
        let Offer { source, arrival, behind, .. } = offer;
        let inside = &site.path.inside;
        let color = self.shadowed(&site.departure, inside, source, arrival, site.path.class);
        if is_dark(color) {
            return Rgb::ZERO;
        }
        self.answer(site, look, arrival.direction, color, *behind, source.light.shadowless)
    }
}
