//! The way of a photon: through what lets it pass to its target, refracted and reflected from there on,
//! stored where it lands.

use super::super::layers::{self, Placed};
use super::super::path::{Interiors, Path, copied};
use super::super::refract::{self, Passage};
use super::super::shade::Site;
use super::super::tracer::Tracer;
use super::super::{reflect, spectrum};
use super::aim::{Aim, Kinds, Shot};
use super::{Landed, Stream};
use crate::color::{Rgb, grey};
use crate::light::PackedPhoton;
use crate::light::{Light, fade_factor};
use crate::math::{Range, Ray, Vec3};
use crate::world::{PhotonRules, RayClass};
use smallvec::SmallVec;
use std::cell::Cell;

/// Normals whose components differ by less count as one.
const SAME_NORMAL: f64 = 1e-10;

/// A photon on its way.
#[derive(Clone)]
struct Flight {
    color: Rgb,
    weight: f32,
    /// Distance from the light.
    travelled: f64,
    /// Nothing but what lets photons pass has been met so far.
    seeking: bool,
    path: Path,
}

/// What all photons of one shot share.
struct Run<'a> {
    aim: &'a Aim,
    light: &'a Light,
    media: Option<&'a mut Stream>,
    landed: &'a mut Landed,
}

/// A place where a photon has arrived.
struct Arrival<'a> {
    site: &'a Site<'a>,
    rules: PhotonRules,
    kinds: Kinds,
    /// Whether the surface lets it pass on its way to the target.
    passing: bool,
}

impl Tracer<'_> {
    /// Follows one photon to its end. `media` gives the draws for places in media, if photons stay there.
    pub(super) fn follow(&mut self, shot: &Shot, aim: &Aim, media: Option<&mut Stream>, landed: &mut Landed) {
        self.counters.photons += 1;
        let source = &self.world.lights[aim.light];
        let (mut ray, mut travelled) = (shot.ray, 0.0);
        if let Some(projector) = source.projected_through {
            match self.world.behind_projector(projector, &ray) {
                Some(t) => (ray, travelled) = (Ray::new(ray.at(t), ray.dir), t),
                None => return,
            }
        }
        let inside = self.photon_interiors(ray.origin);
        let path = Path { level: 0, weight: 1.0, class: RayClass::Photon, wavelength: None, inside };
        let color = source.light.color * shot.strength;
        let flight = Flight { color, weight: 1.0, travelled, seeking: true, path };
        self.fly(&ray, flight, &mut Run { aim, light: &source.light, media, landed });
    }

    fn fly(&mut self, ray: &Ray, mut flight: Flight, run: &mut Run) {
        if flight.path.level >= self.max_level || !(flight.weight >= self.adc_bailout) {
            return;
        }
        flight.path.level += 1;
        let Some(hit) = self.world.nearest(ray, Range::FORWARD, flight.path.class) else { return };
        let rules = *self.world.photon_rules(&hit);
        let arrived = rules.target == Some(run.aim.target);
        let passing = flight.seeking && !arrived;
        if passing && !rules.pass_through {
            return;
        }
        run.landed.hit_target |= arrived;
        let kinds = Kinds::new(run.light, &rules);
        let path = flight.path.clone();
        let site = Site::new(ray, &hit, &path);
        let arrival = Arrival { site: &site, rules, kinds, passing };
        let mut surfaces = SmallVec::new();
        self.world.surfaces(&hit, site.is_back(), &mut surfaces);
        let (world, context) = (self.world, self.context);
        for &(share, surface) in &surfaces {
            let incidence = || site.incidence(world);
            let facing = Cell::new(site.facing);
            layers::stacks(surface, &hit, &context, incidence, &facing, |part, stack| {
                let flight = Flight { color: flight.color * (share * part), ..flight.clone() };
                self.meet(&arrival, stack, flight, run);
            });
        }
    }

    /// One stack of layers: stores the photon, then sends it on.
    fn meet(&mut self, arrival: &Arrival, layers: &[Placed], mut flight: Flight, run: &mut Run) {
        let (site, hit) = (arrival.site, arrival.site.hit);
        let interior = self.world.interior(hit.interior);
        let inside = &site.path.inside;
        if !flight.seeking {
            self.photon_media(site, &mut flight.color, flight.travelled, run);
        }
        if inside.contains(&hit.interior) && interior.fade_power > 0.0 && refract::fades(interior) {
            flight.color *= refract::faded(interior, hit.t);
        }
        flight.color *= layers.last().map_or(1.0, |l| l.layer.finish.refraction);
        flight.travelled += hit.t;
        if !flight.seeking && arrival.rules.collect {
            let energy = energy(run, flight.color, flight.travelled, run.aim.spacing);
            run.landed.surface.push(PackedPhoton::new(hit.point, energy, -site.ray.dir));
        }
        let stack = self.photon_stack(site, layers);
        flight.seeking = arrival.passing;
        let through = Flight {
            color: flight.color * stack.filter,
            weight: flight.weight * stack.filter.max_element(),
            ..flight.clone()
        };
        if arrival.passing {
            return self.pass_on(site, through, run);
        }
        let mut all_reflected = false;
        if arrival.kinds.refraction && stack.clear > self.adc_bailout {
            all_reflected = self.refract_photon(site, stack.top, &flight, through, run);
        }
        if arrival.kinds.reflection {
            for bounce in &stack.bounces {
                if !(all_reflected && bounce.normal.abs_diff_eq(stack.top, SAME_NORMAL)) {
                    self.reflect_photon(site, bounce, &flight, run);
                }
            }
        }
    }

    /// Straight on, through what lets photons pass.
    fn pass_on(&mut self, site: &Site, mut flight: Flight, run: &mut Run) {
        if self.needs.interiors {
            flight.path.inside = Passage::new(self.world, &site.path.inside, site.hit.interior).inside;
        }
        self.fly(&site.departure().ray(site.ray.dir), flight, run);
    }

    /// Whether all was reflected.
    fn refract_photon(
        &mut self,
        site: &Site,
        normal: Vec3,
        before: &Flight,
        through: Flight,
        run: &mut Run,
    ) -> bool {
        let passage = Passage::new(self.world, &site.path.inside, site.hit.interior);
        let wavelength = before.path.wavelength;
        if passage.is_straight() {
            let inside = if self.needs.interiors { passage.inside } else { Interiors::new() };
            let path = Path { inside, ..through.path.clone() };
            self.fly(&site.departure().ray(site.ray.dir), Flight { path, ..through }, run);
            return false;
        }
        if passage.disperses() && wavelength.is_none() {
            let bands = passage.dispersion_samples;
            for (wavelength, hue) in spectrum::bands(bands) {
                let share = hue / bands as f32;
                let tinted = |f: &Flight| Flight {
                    color: f.color * share,
                    path: Path { wavelength: Some(wavelength), ..f.path.clone() },
                    ..f.clone()
                };
                let ratio = passage.ratio_at(wavelength);
                self.bend_photon(site, (&passage, ratio, normal), &tinted(before), tinted(&through), run);
            }
            return false;
        }
        let ratio = wavelength.map_or(passage.ratio, |w| passage.ratio_at(w));
        self.bend_photon(site, (&passage, ratio, normal), before, through, run)
    }

    fn bend_photon(
        &mut self,
        site: &Site,
        (passage, ratio, normal): (&Passage, f64, Vec3),
        before: &Flight,
        through: Flight,
        run: &mut Run,
    ) -> bool {
        match refract::bent(site.ray.dir, normal, ratio) {
            Some(direction) => {
                let path = Path { inside: copied(&passage.inside), ..through.path.clone() };
                self.fly(&site.departure().ray(direction), Flight { path, ..through }, run);
                false
            }
            None => {
                let direction = reflect::mirrored(site.ray.dir, normal, site.facing);
                let path = Path { class: RayClass::ReflectedPhoton, ..through.path.clone() };
                let flight = Flight { color: before.color, path, ..through };
                self.fly(&site.departure().ray(direction), flight, run);
                true
            }
        }
    }

    fn reflect_photon(&mut self, site: &Site, bounce: &PhotonBounce, flight: &Flight, run: &mut Run) {
        let direction = reflect::mirrored(site.ray.dir, bounce.normal, site.facing);
        let color = if bounce.power == 1.0 { flight.color } else { flight.color.powf(bounce.power) };
        let path = Path { class: RayClass::ReflectedPhoton, ..flight.path.clone() };
        let weight = flight.weight * bounce.weight;
        let flight = Flight { color: color * bounce.k, weight, path, ..flight.clone() };
        self.fly(&site.departure().ray(direction), flight, run);
    }

    /// What a stack of layers does to a photon.
    fn photon_stack(&self, site: &Site, layers: &[Placed]) -> PhotonStack {
        let mut stack =
            PhotonStack { filter: Rgb::ONE, clear: 1.0, top: site.facing, bounces: SmallVec::new() };
        let last = Cell::new(site.facing);
        for (i, placed) in layers.iter().enumerate() {
            if stack.clear <= self.adc_bailout {
                break;
            }
            let normal = self.normal(site, placed, &last);
            let color = self.pigment(site, placed, last.get());
            if i == 0 {
                stack.top = normal;
            }
            let finish = &placed.layer.finish;
            let k = self.reflectivity(site, finish, normal, color.map_or(Rgb::ZERO, |c| c.rgb));
            if k != Rgb::ZERO {
                let weight = stack.clear * super::super::shade::declared_maximum(finish, k) * k.max_element();
                stack.bounces.push(PhotonBounce { k, weight, power: finish.reflection.power, normal });
            }
            if let Some(c) = color {
                stack.filter *= c.transmittance();
                if finish.conserve_energy {
                    stack.filter *= (Rgb::ONE - k).min(Rgb::ONE);
                }
            }
            stack.clear = grey(stack.filter).abs().min(1.0);
        }
        stack
    }

    /// Leaves photons in the media before a hit, and takes from the photon what the media take.
    fn photon_media(&mut self, site: &Site, color: &mut Rgb, travelled: f64, run: &mut Run) {
        if !self.needs.media || site.path.inside.is_empty() || !self.is_hollow(&site.path.inside) {
            return;
        }
        let parallel = run.aim.parallel;
        let spread = if parallel { run.aim.spacing } else { run.aim.spacing * travelled };
        let Some(draws) = run.media.as_deref_mut() else {
            let ranges: SmallVec<[(u32, u32); 4]> =
                site.path.inside.iter().map(|i| self.media_of[i.0 as usize]).collect();
            *color *= self.media_shadow(site.ray, site.hit.t, &ranges);
            return;
        };
        let deposits = self.deposits(site, spread, draws);
        let before = *color;
        *color *= deposits.left;
        for (along, share) in deposits.places {
            let length = travelled + along;
            let reach = if parallel { 1.0 } else { length };
            let share = share * run.aim.spacing * reach;
            let energy = energy(run, before * share as f32, length, run.aim.spacing);
            run.landed.media.push(PackedPhoton::new(site.ray.at(along), energy, -site.ray.dir));
        }
    }
}

/// The layers at one place, as a photon sees them.
struct PhotonStack {
    filter: Rgb,
    clear: f32,
    /// Normal of the top layer.
    top: Vec3,
    bounces: SmallVec<[PhotonBounce; 2]>,
}

struct PhotonBounce {
    k: Rgb,
    /// Factor of the photon's weight.
    weight: f32,
    power: f32,
    normal: Vec3,
}

/// What a photon of a colour stands for, after `length` on its way.
fn energy(run: &Run, color: Rgb, length: f64, spacing: f64) -> Rgb {
    let reach = if run.aim.parallel { spacing } else { spacing * length };
    let fade = fade_factor(length, run.light.fade_distance, run.light.fade_power);
    color * (reach * reach * fade) as f32
}
