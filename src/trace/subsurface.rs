//! Light that enters a surface, is scattered below it and leaves it elsewhere.
//!
//! Three parts: diffuse light from around, by the dipole of two point sources; light scattered once on the
//! way of the refracted view ray; and light straight through. With `s` the reduced scattering and `a` the
//! reduced albedo, `t = s/a` is the extinction, all per millimetre and colour channel; the albedo is that
//! which gives the surface's diffuse reflectance.
//!
//! Reference: H. W. Jensen, S. Marschner, M. Levoy, P. Hanrahan, "A Practical Model for Subsurface Light
//! Transport", SIGGRAPH 2001.

use super::direct::Look;
use super::path::{Departure, Interiors, Path};
use super::photon::Stream;
use super::radiosity::Query;
use super::reflect::fresnel;
use super::refract;
use super::shade::Site;
use super::tracer::Tracer;
use crate::color::Rgb;
use crate::math::{Range, Ray, Vec3};
use crate::world::{Hit, RayClass, World, WorldLight};
use std::f64::consts::{PI, TAU};

/// Steps of the table of albedos.
const STEPS: usize = 100;

/// Directions and draws before they repeat.
const CYCLE: usize = 32767;

/// Surfaces seen at a lower cosine count as at this one.
const LEAST_COSINE: f64 = 0.01;

/// Cosines below this count as unlit.
const LIT: f64 = 1e-10;

/// A tracer's part in subsurface light.
#[derive(Clone, Debug)]
pub(super) struct Subsurface {
    diffuse_samples: u32,
    single_samples: u32,
    radiosity: bool,
    mm_per_unit: f64,
    /// Evaluations that hang on each other: the second takes single samples, a third none.
    nested: usize,
    /// The next direction and draw, by nesting.
    directions: [usize; 2],
    draws: [Stream; 2],
    /// Albedos by diffuse reflectance, for the indices of refraction met so far.
    albedos: Vec<(f64, Box<[f64; STEPS + 1]>)>,
}

impl Subsurface {
    /// `None` if the picture has none.
    pub fn new(world: &World, quality: u8) -> Option<Self> {
        let globals = &world.scene.globals;
        let settings = globals.subsurface.as_ref().filter(|_| quality >= 9)?;
        Some(Self {
            diffuse_samples: settings.diffuse_samples,
            single_samples: settings.single_samples,
            radiosity: settings.radiosity,
            mm_per_unit: globals.mm_per_unit,
            nested: 0,
            directions: [0; 2],
            draws: [Stream::default(); 2],
            albedos: Vec::new(),
        })
    }

    /// What is kept from sample to sample depends on the block alone.
    pub fn begin_block(&mut self, serial: usize) {
        let first = serial.wrapping_mul(7919) % CYCLE;
        self.directions = [first; 2];
        self.draws = [Stream::at(first, CYCLE); 2];
    }

    fn samples(&self) -> (u32, u32) {
        if self.nested == 0 { (self.diffuse_samples, self.single_samples) } else { (1, 1) }
    }

    /// The next direction, evenly over the sphere.
    fn direction(&mut self) -> Vec3 {
        let next = &mut self.directions[self.nested];
        let i = *next as u32 + 1;
        *next = (*next + 1) % CYCLE;
        let x = 2.0 * radical_inverse(i, 2) - 1.0;
        let r = (1.0 - x * x).max(0.0).sqrt();
        let (sin, cos) = (TAU * radical_inverse(i, 3)).sin_cos();
        Vec3::new(x, r * cos, r * sin)
    }

    /// The reduced albedo that gives diffuse reflectance `x`.
    fn albedo(&mut self, ior: f64, x: f64) -> f64 {
        let place = self.albedos.iter().position(|(index, _)| *index == ior).unwrap_or_else(|| {
            self.albedos.push((ior, Box::new(std::array::from_fn(|i| albedo(ior, i)))));
            self.albedos.len() - 1
        });
        let table = &self.albedos[place].1;
        let x = x.clamp(0.0, 1.0) * STEPS as f64;
        let i = (x as usize).min(STEPS - 1);
        table[i] + (table[i + 1] - table[i]) * (x - i as f64)
    }
}

fn radical_inverse(mut i: u32, base: u32) -> f64 {
    let (mut value, mut digit) = (0.0, 1.0);
    while i > 0 {
        digit /= f64::from(base);
        value += f64::from(i % base) * digit;
        i /= base;
    }
    value
}

/// How much larger the boundary makes the dipole, for relative index `m`.
fn boundary(m: f64) -> f64 {
    let diffuse = if m >= 1.0 {
        let u = 1.0 - 1.0 / m;
        0.25 * (u + 3.0 * u.powf(4.5))
    } else {
        m * m - m.powf(2.25)
    };
    (1.0 + diffuse) / (1.0 - diffuse)
}

/// Solves `a/2 (1 + exp(-4/3 Z q)) exp(-q) = i/100`, `q = sqrt(3 (1 - a))`, by halving.
fn albedo(ior: f64, i: usize) -> f64 {
    let z = boundary(ior);
    let reflectance = |a: f64| {
        let q = (3.0 * (1.0 - a)).sqrt();
        0.5 * a * (1.0 + (-4.0 / 3.0 * z * q).exp()) * (-q).exp()
    };
    let (mut low, mut high) = (0.0, 1.0);
    let wanted = i as f64 / STEPS as f64;
    if i == 0 || i == STEPS {
        return wanted;
    }
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if reflectance(middle) < wanted { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// The medium below the surface, per channel and millimetre.
struct Medium {
    albedo: [f64; 3],
    scattering: [f64; 3],
    extinction: [f64; 3],
    /// Whether the channel scatters at all.
    clear: [bool; 3],
    /// Relative index, and what it makes of the dipole.
    index: f64,
    boundary: f64,
    mm_per_unit: f64,
}

impl Medium {
    fn new(subsurface: &mut Subsurface, ior: f64, index: f64, reflectance: Rgb, translucency: Rgb) -> Self {
        let albedo = reflectance.to_array().map(|x| subsurface.albedo(ior, f64::from(x)));
        let scattering = translucency.to_array().map(|t| 1.0 / f64::from(t));
        let clear = std::array::from_fn(|i| !(albedo[i] > 0.0 && scattering[i].is_finite()));
        let extinction = std::array::from_fn(|i| scattering[i] / albedo[i]);
        let mm_per_unit = subsurface.mm_per_unit;
        Self { albedo, scattering, extinction, clear, index, boundary: boundary(index), mm_per_unit }
    }

    /// Mean free length, in scene units.
    fn free_length(&self) -> f64 {
        // Absorption and scattering together are the extinction.
        let part = |i: usize| if self.clear[i] { 0.0 } else { self.extinction[i] };
        let sum = Vec3::new(part(0), part(1), part(2)).dot(crate::color::GREY_WEIGHTS.as_dvec3());
        if sum > 0.0 { 1.0 / (sum * self.mm_per_unit) } else { 0.0 }
    }

    /// The share of light that passes the surface at a cosine.
    fn passes(&self, cosine: f64) -> f64 {
        1.0 - fresnel(self.index, cosine).unwrap_or(1.0)
    }

    /// Light that leaves `distance` units away from where it enters, per area.
    fn dipole(&self, channel: usize, distance: f64) -> f64 {
        if self.clear[channel] {
            return 0.0;
        }
        let (t, r) = (self.extinction[channel], distance * self.mm_per_unit);
        let k = (3.0 * (t - self.scattering[channel]).max(0.0) * t).sqrt();
        let real = 1.0 / t;
        let image = real * (1.0 + 4.0 / 3.0 * self.boundary);
        let source = |z: f64| {
            let d = z.hypot(r);
            z * (k + 1.0 / d) * (-k * d).exp() / (d * d)
        };
        self.albedo[channel] / (4.0 * PI) * (source(real) + source(image))
    }

    /// The cosine below the surface.
    fn bent_cosine(&self, cosine: f64) -> f64 {
        (1.0 - (1.0 - cosine * cosine) / (self.index * self.index)).max(0.0).sqrt()
    }
}

/// Light that arrives at a point of the surface around.
struct Entry {
    color: Rgb,
    cosine: f64,
}

impl<'w> Tracer<'w> {
    /// Whether light below the surface takes the place of the layer's diffuse light.
    pub(super) fn is_translucent(&self, look: &Look) -> bool {
        let seen = self.radiosity.as_ref().is_none_or(|r| r.sees_subsurface());
        look.finish.subsurface.is_some() && self.subsurface.is_some() && seen
    }

    /// Whether diffuse light between surfaces is looked for where light enters, not where it leaves.
    pub(super) fn gathers_below(&self, look: &Look) -> bool {
        self.is_translucent(look) && self.subsurface.as_ref().is_some_and(|s| s.radiosity)
    }

    /// Light that the layer sends out from below.
    pub(super) fn light_from_below(&mut self, site: &Site, look: &Look) -> Rgb {
        let (Some(translucency), true) = (look.finish.subsurface, self.is_translucent(look)) else {
            return Rgb::ZERO;
        };
        let ior = f64::from(self.world.interior(site.hit.interior).ior);
        let ior = if ior == 0.0 { 1.0 } else { ior };
        let index = refract::relative_index(self.world, &site.path.inside, site.hit.interior);
        let Some(subsurface) = self.subsurface.as_mut().filter(|s| s.nested < 2) else { return Rgb::ZERO };
        let reflectance = look.color * look.finish.raw_diffuse;
        let medium = Medium::new(subsurface, ior, index, reflectance, translucency);
        let (diffuse_samples, single_samples) = subsurface.samples();
        let collects = std::mem::replace(&mut self.collects, false);
        let mut sum = self.diffused(site, look, &medium, diffuse_samples);
        if let Some(direction) = refract::bent(site.ray.dir, look.normal, 1.0 / index) {
            let inner = site.departure().ray(direction);
            let end = self.world.nearest(&inner, Range::FORWARD, RayClass::Image);
            sum += self.scattered_once(site, look, &medium, (direction, end.as_ref()), single_samples);
            sum += self.straight_through(site, &medium, direction, end.as_ref());
        }
        self.collects = collects;
        sum
    }

    /// Light that came in around and was scattered many times.
    fn diffused(&mut self, site: &Site, look: &Look, medium: &Medium, samples: u32) -> Rgb {
        let base = self.base_point(site, look, medium);
        let out = medium.passes(-site.ray.dir.dot(look.normal));
        let (mut sum, mut count) = (Rgb::ZERO, 0u32);
        for _ in 0..samples {
            let Some(subsurface) = &mut self.subsurface else { break };
            let direction = subsurface.direction();
            let ray = Ray::new(base, direction);
            let Some(hit) = self.world.nearest(&ray, Range::FORWARD, RayClass::Image) else { continue };
            count += 1;
            if hit.interior != site.hit.interior {
                continue;
            }
            let mm = hit.t * medium.mm_per_unit;
            let area = 4.0 * PI * mm * mm / direction.dot(hit.normal).abs().max(LEAST_COSINE);
            let apart = (hit.point - site.hit.point).length();
            let weight = Vec3::from_array([0, 1, 2].map(|i| medium.dipole(i, apart))) * (area * out);
            let mut light = Rgb::ZERO;
            for source in self.lights_of(site.hit) {
                if let Some(entry) = self.entry(&hit, source, &site.path.inside) {
                    light += entry.color * (entry.cosine * medium.passes(entry.cosine)) as f32;
                }
            }
            if self.gathers_below(look) {
                let departure = Departure::from_hit(&hit);
                let query = Query {
                    departure: &departure,
                    normal: hit.normal,
                    facing: hit.normal,
                    weight: area as f32,
                };
                let ambient = self.diffuse_light(&query).unwrap_or(Rgb::ZERO);
                light += ambient * medium.passes(1.0) as f32;
            }
            sum += light * weight.as_vec3a();
        }
        if count > 0 { sum / count as f32 } else { Rgb::ZERO }
    }

    /// From where light is looked for: a free length below the surface, or half-way through what is thin.
    fn base_point(&self, site: &Site, look: &Look, medium: &Medium) -> Vec3 {
        let free = medium.free_length();
        let ray = site.departure().ray(-look.normal);
        let depth = match self.world.nearest(&ray, Range::new(0.0, 2.0 * free), RayClass::Image) {
            Some(hit) if hit.interior == site.hit.interior => 0.5 * hit.t,
            Some(hit) => free.min(hit.t * (1.0 - 1e-10)),
            None => free,
        };
        site.hit.point - depth * look.normal
    }

    fn lights_of(&self, hit: &Hit) -> impl Iterator<Item = &'w WorldLight> + use<'w> {
        let world = self.world;
        let global = if hit.ignores_global_lights { &[][..] } else { &world.lights[..] };
        let (first, end) = hit.group_lights;
        global.iter().chain(&world.group_lights[first as usize..end as usize])
    }

    /// The light that enters at a hit, after shadows.
    fn entry(&mut self, hit: &Hit, source: &WorldLight, inside: &Interiors) -> Option<Entry> {
        let arrival = source.light.arrival(hit.point, Vec3::ZERO)?;
        let cosine = hit.normal.dot(arrival.direction).abs();
        if cosine < LIT {
            return None;
        }
        let departure = Departure::from_hit(hit);
        let color = self.shadowed(&departure, inside, source, &arrival, RayClass::Image);
        (!crate::light::is_dark(color)).then_some(Entry { color, cosine })
    }

    /// Light scattered once on the way of the refracted view ray.
    fn scattered_once(
        &mut self,
        site: &Site,
        look: &Look,
        medium: &Medium,
        (direction, end): (Vec3, Option<&Hit>),
        samples: u32,
    ) -> Rgb {
        let length = end.map_or(f64::INFINITY, |h| h.t * medium.mm_per_unit);
        let out = -site.ray.dir.dot(look.normal);
        let mut sum = [0.0; 3];
        for i in 0..3 * samples as usize {
            let channel = i % 3;
            let Some(subsurface) = &mut self.subsurface else { break };
            let nested = subsurface.nested;
            let random = subsurface.draws[nested].draw_of(CYCLE);
            if medium.clear[channel] {
                continue;
            }
            let depth = random.ln().abs() / medium.extinction[channel];
            if depth < length {
                let place = site.hit.point + direction * (depth / medium.mm_per_unit);
                sum[channel] += self.single(site, medium, (place, depth, out), channel);
            }
        }
        Vec3::from_array(sum.map(|s| s / f64::from(samples))).as_vec3a()
    }

    /// Light of one channel that is scattered to the viewer at a place below the surface.
    fn single(
        &mut self,
        site: &Site,
        medium: &Medium,
        (place, depth, out): (Vec3, f64, f64),
        channel: usize,
    ) -> f64 {
        let (s, t) = (medium.scattering[channel], medium.extinction[channel]);
        let mut sum = 0.0;
        for source in self.lights_of(site.hit) {
            let ray = Ray::new(place, source.light.towards(place, Vec3::ZERO).0);
            let Some(hit) = self.world.nearest(&ray, Range::FORWARD, RayClass::Image) else { continue };
            if hit.interior != site.hit.interior {
                continue;
            }
            let Some(entry) = self.entry(&hit, source, &site.path.inside) else { continue };
            let (inward, outward) = (medium.bent_cosine(entry.cosine), medium.bent_cosine(out));
            if inward == 0.0 {
                continue;
            }
            let way_in = hit.t * medium.mm_per_unit * entry.cosine / inward;
            let passes = medium.passes(entry.cosine) * medium.passes(out);
            let color = f64::from(entry.color[channel]) * entry.cosine;
            let angle = 1.0 + (outward / inward).abs();
            sum += color * s * passes * 0.25 / (t * angle) * (-(way_in + depth) * t).exp();
        }
        sum
    }

    /// Light from behind that is not scattered.
    fn straight_through(&mut self, site: &Site, medium: &Medium, direction: Vec3, end: Option<&Hit>) -> Rgb {
        let Some(end) = end.filter(|h| h.interior == site.hit.interior) else { return Rgb::ZERO };
        let mm = end.t * medium.mm_per_unit;
        let left = |i: usize| if medium.clear[i] { 0.0 } else { (-medium.extinction[i] * mm).exp() as f32 };
        let left = Rgb::new(left(0), left(1), left(2));
        let weight = left.max_element();
        if weight <= self.adc_bailout {
            return Rgb::ZERO;
        }
        let Some(outward) = refract::bent(direction, end.normal, medium.index) else { return Rgb::ZERO };
        if let Some(subsurface) = &mut self.subsurface {
            subsurface.nested += 1;
        }
        let mut path = Path { weight, inside: Interiors::new(), ..site.path.clone() };
        let seen = self.trace(&Departure::from_hit(end).ray(outward), &mut path).rgb;
        if let Some(subsurface) = &mut self.subsurface {
            subsurface.nested -= 1;
        }
        left * seen
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The albedo's own equation, and its ends.
    #[test]
    fn albedos_give_their_reflectance() {
        let z = boundary(1.3);
        for i in [1, 20, 50, 99] {
            let a = albedo(1.3, i);
            let q = (3.0 * (1.0 - a)).sqrt();
            let x = 0.5 * a * (1.0 + (-4.0 / 3.0 * z * q).exp()) * (-q).exp();
            assert!((x - i as f64 / 100.0).abs() < 1e-10);
        }
        assert_eq!((albedo(1.3, 0), albedo(1.3, STEPS)), (0.0, 1.0));
    }

    /// The dipole sends out what the surface reflects diffusely: its integral over the plane is the
    /// reflectance that the albedo was chosen for.
    #[test]
    fn the_dipole_gives_back_the_reflectance() {
        let reflectance = 0.6;
        let a = albedo(1.3, 60);
        let m = Medium {
            albedo: [a; 3],
            scattering: [2.0; 3],
            extinction: [2.0 / a; 3],
            clear: [false; 3],
            index: 1.3,
            boundary: boundary(1.3),
            mm_per_unit: 10.0,
        };
        let step = 1e-4;
        // Rings of an area, in square millimetres.
        let ring = |i: u32| {
            let r = (f64::from(i) + 0.5) * step;
            m.dipole(0, r) * TAU * r * step * m.mm_per_unit * m.mm_per_unit
        };
        let sum: f64 = (0..40_000).map(ring).sum();
        assert!((sum - reflectance).abs() < 1e-3, "{sum}");
    }
}
