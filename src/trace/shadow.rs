//! How much of a light reaches a point: surfaces on the way filter it, opaque ones stop it.

use super::layers::{self, Placed};
use super::media::Worth;
use super::path::{Departure, Interiors, Path, copied};
use super::photon::Kinds;
use super::refract;
use super::shade::Site;
use super::tracer::Tracer;
use crate::color::Rgb;
use crate::light::{Arrival, Light, is_dark};
use crate::math::{EPSILON, Range, Ray};
use crate::pattern::Context;
use crate::world::{Blocker, Crossed, Hit, Next, Obstacle, RayClass, Surface, World, WorldLight};
use smallvec::SmallVec;
use std::cell::Cell;

/// Surfaces that a shadow ray passes before it is given up.
const MAX_PASSED: u32 = 1 << 16;

/// Exponent of the highlight that stands for focused light, for `caustics 1`.
const FOCUS: f64 = 45.0;

/// What is left of the way to a lamp.
struct Stretch {
    ray: Ray,
    /// To the lamp.
    distance: f64,
    /// Where blockers stop counting.
    end: f64,
}

impl Stretch {
    /// The way on from a surface that was passed.
    fn behind(&self, hit: &Hit) -> Stretch {
        Stretch {
            ray: Departure::from_hit(hit).ray(self.ray.dir),
            distance: self.distance - hit.t,
            end: self.end - hit.t,
        }
    }
}

impl Tracer<'_> {
    /// The light's colour at a point after shadows.
    #[inline]
    pub(super) fn shadowed(
        &mut self,
        departure: &Departure,
        inside: &Interiors,
        source: &WorldLight,
        arrival: &Arrival,
        class: RayClass,
    ) -> Rgb {
        let light = &source.light;
        if self.settings.quality < 4 || (light.shadowless && source.projected_through.is_none()) {
            return arrival.color;
        }
        let worth = self.shadow_worth;
        let color = match &light.area {
            Some(area) if self.uses_area(class) => {
                self.area_shadowed(departure, inside, source, area, arrival, class)
            }
            _ => {
                let ray = departure.ray(arrival.direction);
                self.transmitted(&ray, arrival.distance, inside, source, arrival.color)
            }
        };
        self.shadow_worth = worth;
        color
    }

    /// What is left of `color` along `ray`, whose lamp is `distance` away.
    #[inline]
    pub(super) fn transmitted(
        &mut self,
        ray: &Ray,
        distance: f64,
        inside: &Interiors,
        source: &WorldLight,
        color: Rgb,
    ) -> Rgb {
        if self.needs.filters || source.projected_through.is_some() || source.light.shadowless {
            return self.transmitted_filtered(ray, distance, inside, source, color);
        }
        self.counters.shadow_rays += 1;
        let end = lamp_end(ray, distance);
        let last = &mut self.blockers[source.number as usize];
        let stopped = end > 0.0 && self.world.is_stopped(ray, Range::new(0.0, end), last);
        if stopped { Rgb::ZERO } else { color }
    }

    /// The same, where light may be changed on its way.
    #[inline(never)]
    fn transmitted_filtered(
        &mut self,
        ray: &Ray,
        distance: f64,
        inside: &Interiors,
        source: &WorldLight,
        color: Rgb,
    ) -> Rgb {
        let collects = self.needs.media;
        self.transmitted_past(ray, distance, inside, source, color, |world, ray, range, last, crossed| {
            if collects {
                world.obstacle_and_all(ray, range, last, crossed)
            } else {
                world.obstacle(ray, range, last)
            }
        })
    }

    /// The same, where `obstacle` says what stands in the way.
    #[inline]
    pub(super) fn transmitted_past(
        &mut self,
        ray: &Ray,
        distance: f64,
        inside: &Interiors,
        source: &WorldLight,
        color: Rgb,
        obstacle: impl FnOnce(&World, &Ray, Range, &mut Blocker, &mut Crossed) -> Obstacle<Hit>,
    ) -> Rgb {
        self.counters.shadow_rays += 1;
        let light = &source.light;
        let mut end = lamp_end(ray, distance);
        if let Some(index) = source.projected_through {
            match self.world.projector(index, ray, Range::new(0.0, end)) {
                Some(t) => end = end.min(t * (1.0 - SAFETY * EPSILON)),
                None => return Rgb::ZERO,
            }
        }
        if light.shadowless {
            return color;
        }
        let dims = self.dims(light);
        let last = &mut self.blockers[source.number as usize];
        self.crossed.forget();
        let crossed = &mut self.crossed;
        let met = if end > 0.0 {
            obstacle(self.world, ray, Range::new(0.0, end), last, crossed)
        } else {
            Obstacle::None
        };
        let worth = self.shadow_worth;
        if self.needs.clouds && !worth.is_known() && !self.settings.overrides.reference {
            self.shadow_worth = Worth::at_surface(color);
        }
        let left = match met {
            Obstacle::Opaque => Rgb::ZERO,
            Obstacle::None if dims => color * self.dimmed(ray, distance, inside),
            Obstacle::None => color,
            Obstacle::Filter(hit) => {
                let stretch = Stretch { ray: *ray, distance, end };
                self.filtered(stretch, hit, inside, (dims, light), color)
            }
        };
        self.shadow_worth = worth;
        left
    }

    /// Whether air dims the light.
    #[inline]
    pub(super) fn dims(&self, light: &Light) -> bool {
        light.media_attenuation && light.media_interaction && self.needs.atmosphere
    }

    /// Follows a ray that no opaque object stops from surface to surface; `hit` is the first.
    fn filtered(
        &mut self,
        mut to_lamp: Stretch,
        mut hit: Hit,
        inside: &Interiors,
        (dims, light): (bool, &Light),
        mut color: Rgb,
    ) -> Rgb {
        let mut inside = copied(inside);
        let (whole, mut passed) = (to_lamp.ray, 0.0);
        for number in 1..MAX_PASSED {
            if dims {
                color *= self.dimmed(&to_lamp.ray, hit.t, &inside);
            }
            if self.collects && self.bends_photons(&hit, light) {
                return Rgb::ZERO;
            }
            color *= self.surface_filter(&to_lamp.ray, &hit, &inside);
            if is_dark(color) {
                return Rgb::ZERO;
            }
            if self.needs.interiors {
                match inside.iter().position(|&i| i == hit.interior) {
                    Some(i) => {
                        inside.remove(i);
                    }
                    None => inside.push(hit.interior),
                }
            }
            to_lamp = to_lamp.behind(&hit);
            passed += hit.t;
            let next = match self.world.crossing(&whole, &self.crossed, number as usize) {
                Next::Hit(next) => Some(Hit { t: next.t - passed, ..next }),
                Next::Nothing => None,
                Next::Unknown => self.next_filter(&to_lamp),
            };
            match next {
                Some(next) => hit = next,
                None if dims => return color * self.dimmed(&to_lamp.ray, to_lamp.distance, &inside),
                None => return color,
            }
        }
        Rgb::ZERO
    }

    /// The next surface on the way; it is not known from the whole way's crossings, so no later one is either.
    fn next_filter(&mut self, to_lamp: &Stretch) -> Option<Hit> {
        self.crossed.forget();
        let range = Range::new(0.0, to_lamp.end);
        (to_lamp.end > 0.0).then(|| self.world.nearest(&to_lamp.ray, range, RayClass::Filtered))?
    }

    /// Whether light through the object comes as photons instead.
    fn bends_photons(&self, hit: &Hit, light: &Light) -> bool {
        let rules = self.world.photon_rules(hit);
        rules.target.is_some()
            && Kinds::new(light, rules).refraction
            && self.photons.as_ref().is_some_and(|p| !p.surface.is_empty())
    }

    /// What fog and atmospheric media leave of light over the first `length` of `ray`.
    fn dimmed(&mut self, ray: &Ray, length: f64, inside: &Interiors) -> Rgb {
        if !self.is_hollow(inside) || length <= 0.0 {
            return Rgb::ONE;
        }
        let fog = super::fog::attenuation(&self.world.scene.fogs, ray, length, self.context.noise);
        fog * self.media_shadow(ray, length, &[self.air])
    }

    /// What one surface and the stretch before it leave of the light.
    fn surface_filter(&mut self, ray: &Ray, hit: &Hit, inside: &Interiors) -> Rgb {
        let mut filter = if hit.opaque { Rgb::ZERO } else { self.texture_filter(ray, hit, inside) };
        if !self.needs.interiors || filter == Rgb::ZERO || inside.is_empty() {
            return filter;
        }
        let interior = self.world.interior(hit.interior);
        if inside.contains(&hit.interior) && interior.fade_power > 0.0 && refract::fades(interior) {
            filter *= refract::faded(interior, hit.t);
        }
        if self.needs.media && self.is_hollow(inside) {
            let ranges: SmallVec<[(u32, u32); 4]> =
                inside.iter().map(|i| self.media_of[i.0 as usize]).collect();
            filter *= self.media_shadow(ray, hit.t, &ranges);
        }
        filter
    }

    /// What the textures leave of light that passes them, with the brightening of `caustics`.
    fn texture_filter(&self, ray: &Ray, hit: &Hit, inside: &Interiors) -> Rgb {
        let caustics = if self.needs.caustics { self.world.interior(hit.interior).caustics } else { 0.0 };
        let mut surfaces = SmallVec::new();
        self.world.surfaces(hit, hit.normal.dot(ray.dir) > 0.0, &mut surfaces);
        if let [(share, Surface { filter: Some(filter), .. })] = &surfaces[..]
            && caustics == 0.0
        {
            return share * filter;
        }
        let path =
            Path { level: 0, weight: 1.0, class: RayClass::Shadow, wavelength: None, inside: copied(inside) };
        let site = Site::new(ray, hit, &path);
        let (mut sum, facing) = (Rgb::ZERO, Cell::new(site.facing));
        for &(share, surface) in &surfaces {
            let incidence = || site.incidence(self.world);
            layers::stacks(surface, hit, &self.context, incidence, &facing, |part, stack| {
                sum += share * part * self.stack_filter(&site, stack, caustics);
            });
        }
        sum
    }

    fn stack_filter(&self, site: &Site, stack: &[Placed], caustics: f32) -> Rgb {
        if stack.iter().any(|placed| placed.layer.pigment.is_opaque()) {
            return Rgb::ZERO;
        }
        let mut filter = Rgb::ONE;
        for placed in stack {
            let context = if placed.asks_hit { self.context_at(site) } else { self.context };
            let color = placed.layer.pigment.plain().or_else(|| placed.color(&context));
            if let Some(c) = color {
                filter *= c.transmittance();
            }
            if caustics != 0.0 {
                let c = placed.normal(site.facing, &context).dot(site.ray.dir).abs();
                filter *= 1.0 + c.powf(FOCUS * f64::from(caustics)) as f32;
            }
        }
        filter
    }

    fn context_at<'s>(&self, site: &'s Site) -> Context<'s> {
        Context { hit: Some(site.incidence(self.world)), ..self.context }
    }
}

/// Multiples of the rounding unit by which a lamp's distance may be off.
const SAFETY: f64 = 64.0;

/// Where blockers stop counting: the lamp, less the rounding error of its distance.
#[inline]
fn lamp_end(ray: &Ray, distance: f64) -> f64 {
    let size = ray.origin.abs().max_element() + distance.abs();
    distance - SAFETY * EPSILON * size
}
