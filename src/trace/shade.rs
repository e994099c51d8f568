//! The colour of a surface where a ray meets it: layers from top to bottom, then what passes through them,
//! then what each layer reflects.

use super::direct::Look;
use super::layers::{self, Placed};
use super::path::{Departure, Interiors, Path, Radiance, copied};
use super::photon::Nearby;
use super::radiosity::Query;
use super::refract::{self, Passage};
use super::tracer::Tracer;
use super::{iridescence, reflect};
use crate::color::{Color, Rgb, grey};
use crate::material::Finish;
use crate::math::{Ray, Vec3};
use crate::pattern::{Context, Incidence};
use crate::world::{Hit, RayClass, Surface, World};
use smallvec::SmallVec;
use std::cell::{Cell, OnceCell};

/// Normals whose components differ by less count as one.
const SAME_NORMAL: f64 = 1e-10;

/// A surface's colour so far, and the way on if the ray passes it straight.
pub(super) struct Shaded {
    pub light: Radiance,
    pub onward: Option<Onward>,
}

/// The same ray behind a surface that it passed without bending.
pub(super) struct Onward {
    pub ray: Ray,
    /// What reaches the front of the surface of light from behind.
    pub factor: Rgb,
    pub clear: f32,
    pub weight: f32,
    pub inside: Interiors,
}

/// The place being shaded.
pub(super) struct Site<'a> {
    pub ray: &'a Ray,
    pub hit: &'a Hit,
    pub path: &'a Path,
    /// Unit geometric normal towards the viewer.
    pub facing: Vec3,
    /// Where this hit's shadowed light colours are kept, if several layers ask for them.
    pub lit: Option<usize>,
    incidence: OnceCell<Incidence>,
    /// Diffuse light on the front and on the back, once asked for.
    diffuse: [Cell<Option<Rgb>>; 2],
    /// Photons around the hit, once asked for.
    pub photons: Cell<Option<Nearby>>,
}

/// What the layers leave to be traced.
struct Plan<'w> {
    rgb: Rgb,
    through: SmallVec<[Through<'w>; 1]>,
    bounces: SmallVec<[Bounce<'w>; 2]>,
}

/// Light passing through one stack of layers.
struct Through<'w> {
    /// Share of the stack in the hit's colour.
    share: f32,
    filter: Rgb,
    clear: f32,
    weight: f32,
    /// Normal of the top layer.
    normal: Vec3,
    /// Of the top layer.
    finish: Option<&'w Finish>,
    all_reflected: bool,
}

/// Reflection by one layer.
pub(super) struct Bounce<'w> {
    pub share: f32,
    pub k: Rgb,
    pub weight: f32,
    pub normal: Vec3,
    pub finish: &'w Finish,
    /// The stack's place in `Plan::through`, if anything passes it.
    pub through: Option<usize>,
}

impl<'a> Site<'a> {
    #[inline]
    pub fn new(ray: &'a Ray, hit: &'a Hit, path: &'a Path) -> Self {
        let facing = if hit.normal.dot(ray.dir) > 0.0 { -hit.normal } else { hit.normal };
        Self {
            ray,
            hit,
            path,
            facing,
            lit: None,
            incidence: OnceCell::new(),
            diffuse: Default::default(),
            photons: Cell::default(),
        }
    }

    /// Where rays leave the surface.
    #[inline(always)]
    pub fn departure(&self) -> Departure {
        Departure::from_hit(self.hit)
    }

    /// Whether the side is seen that the normal points away from.
    #[inline]
    pub fn is_back(&self) -> bool {
        self.hit.normal.dot(self.ray.dir) > 0.0
    }

    #[inline]
    pub fn incidence(&self, world: &World) -> &Incidence {
        self.incidence.get_or_init(|| Incidence {
            point: self.hit.point,
            normal: self.facing,
            direction: self.ray.dir,
            uv: world.uv(self.hit),
        })
    }
}

impl<'w> Tracer<'w> {
    #[inline]
    pub(super) fn shade(&mut self, ray: &Ray, hit: &Hit, path: &Path) -> Shaded {
        match self.plain(ray, hit, path) {
            Some(rgb) => Shaded { light: Radiance { rgb, transmit: 0.0 }, onward: None },
            None => self.shade_fully(ray, hit, path),
        }
    }

    /// The same for surfaces of any kind.
    #[inline(never)]
    fn shade_fully(&mut self, ray: &Ray, hit: &Hit, path: &Path) -> Shaded {
        let mut site = Site::new(ray, hit, path);
        let mut plan = Plan { rgb: Rgb::ZERO, through: SmallVec::new(), bounces: SmallVec::new() };
        self.plan(&mut site, &mut plan);
        let mut light = Radiance { rgb: plan.rgb, transmit: 0.0 };
        let mut onward = None;
        if !plan.through.is_empty() {
            onward = self.pass(&site, &mut plan.through, &mut light);
        }
        for bounce in &plan.bounces {
            let stack = bounce.through.map(|i| &plan.through[i]);
            if stack.is_some_and(|s| s.all_reflected && s.normal.abs_diff_eq(bounce.normal, SAME_NORMAL)) {
                continue;
            }
            light.rgb += bounce.share * self.bounce(&site, bounce);
        }
        Shaded { light, onward }
    }

    /// All light that needs no further rays of colour, and which such rays there are.
    #[inline(never)]
    fn plan(&mut self, site: &mut Site, plan: &mut Plan<'w>) {
        let (world, normal) = (self.world, Cell::new(site.facing));
        match world.sole_surface(site.hit, site.is_back()) {
            Some(surface) if surface.sole_layer().is_some() => {
                self.plan_part(site, (1.0, surface), &normal, plan);
            }
            sole => {
                let base = self.lit.len();
                site.lit = Some(base);
                self.lit.resize(base + world.lights.len(), None);
                self.plan_parts(site, sole, &normal, plan);
                self.lit.truncate(base);
            }
        }
        self.spare_nearby.extend(site.photons.take());
    }

    /// All surfaces that show at the hit, `sole` if that is the only one.
    fn plan_parts(
        &mut self,
        site: &Site,
        sole: Option<&'w Surface>,
        normal: &Cell<Vec3>,
        plan: &mut Plan<'w>,
    ) {
        let mut surfaces: SmallVec<[(f32, &'w Surface); 2]> = SmallVec::new();
        match sole {
            Some(surface) => surfaces.push((1.0, surface)),
            None => self.world.surfaces(site.hit, site.is_back(), &mut surfaces),
        }
        for &part in &surfaces {
            if surfaces.len() == 1 || part.0 >= self.adc_bailout {
                self.plan_part(site, part, normal, plan);
            }
        }
    }

    #[inline]
    fn plan_part(
        &mut self,
        site: &Site,
        (share, surface): (f32, &'w Surface),
        normal: &Cell<Vec3>,
        plan: &mut Plan<'w>,
    ) {
        let (world, context) = (self.world, self.context);
        let incidence = || site.incidence(world);
        layers::stacks(surface, site.hit, &context, incidence, normal, |part, stack| {
            self.stack(site, share * part, stack, normal, plan);
        });
    }

    /// One stack of layers, top first. `last` is the normal after the most recent perturbation at this hit.
    fn stack(
        &mut self,
        site: &Site,
        share: f32,
        layers: &[Placed<'w, '_>],
        last: &Cell<Vec3>,
        plan: &mut Plan<'w>,
    ) {
        let first_bounce = plan.bounces.len();
        let (mut filter, mut clear, mut found, mut refraction) = (Rgb::ONE, 1.0f32, false, 1.0);
        let mut top = None;
        for placed in layers {
            if clear <= self.adc_bailout {
                break;
            }
            let normal = self.normal(site, placed, last);
            let color = self.pigment(site, placed, last.get());
            let finish: &'w Finish = &placed.layer.finish;
            top = top.or(Some((normal, finish)));
            refraction = finish.refraction;
            if self.settings.quality <= 1 {
                plan.rgb += share * color.unwrap_or_default().rgb;
                return;
            }
            let c = color.unwrap_or(NOT_FOUND);
            let k = self.reflectivity(site, finish, normal, c.rgb);
            if k != Rgb::ZERO {
                let weight = site.path.weight * clear * declared_maximum(finish, k);
                plan.bounces.push(Bounce { share, k, weight, normal, finish, through: None });
            }
            let opacity = self.opacity(c);
            let look = Look { finish, color: c.rgb, opacity, normal };
            plan.rgb += share * filter * self.own_light(site, &look, filter);
            if color.is_some() {
                found = true;
                filter *= c.transmittance();
                if finish.conserve_energy {
                    filter *= (Rgb::ONE - k).min(Rgb::ONE);
                }
            }
            clear = grey(filter).abs().min(1.0);
        }
        if clear > self.adc_bailout && self.settings.quality >= 6 {
            let bounces = plan.bounces[first_bounce..].iter_mut();
            bounces.for_each(|b| b.through = Some(plan.through.len()));
            plan.through.push(Through {
                share,
                filter: refraction * if found { filter } else { Rgb::ONE },
                clear: refraction * clear,
                weight: site.path.weight * filter.abs().max_element(),
                normal: top.map_or(site.facing, |(normal, _)| normal),
                finish: top.map(|(_, finish)| finish),
                all_reflected: false,
            });
        }
    }

    /// The layer's shading normal; `last` is the one left by the layers before, which this one replaces if
    /// it perturbs.
    #[inline]
    pub(super) fn normal(&self, site: &Site, placed: &Placed, last: &Cell<Vec3>) -> Vec3 {
        if placed.layer.normal.is_none() || self.settings.quality < 8 {
            return site.facing;
        }
        let normal = if placed.asks_hit {
            let incidence = Incidence { normal: last.get(), ..*site.incidence(self.world) };
            placed.normal(site.facing, &Context { hit: Some(&incidence), ..self.context })
        } else {
            placed.normal(site.facing, &self.context)
        };
        last.set(normal);
        normal
    }

    #[inline]
    pub(super) fn pigment(&self, site: &Site, placed: &Placed, normal: Vec3) -> Option<Color> {
        let pigment = &placed.layer.pigment;
        if self.settings.quality <= 5 && pigment.quick_color.is_some() {
            return pigment.quick_color;
        }
        if let Some(plain) = pigment.plain() {
            return Some(plain);
        }
        if !placed.asks_hit {
            return placed.color(&self.context);
        }
        let incidence = Incidence { normal, ..*site.incidence(self.world) };
        placed.color(&Context { hit: Some(&incidence), ..self.context })
    }

    #[inline]
    pub(super) fn reflectivity(&self, site: &Site, finish: &Finish, normal: Vec3, color: Rgb) -> Rgb {
        if self.settings.quality < 8 {
            return Rgb::ZERO;
        }
        let c = -site.ray.dir.dot(normal);
        reflect::reflectivity(&finish.reflection, c, color, || {
            refract::relative_index(self.world, &site.path.inside, site.hit.interior)
        })
    }

    /// The layer's own opacity.
    #[inline]
    pub(super) fn opacity(&self, c: Color) -> f32 {
        let filter = if self.modern { c.filter } else { c.filter * c.rgb.max_element() };
        1.0 - filter - c.transmit
    }

    /// Light that the layer itself sends to the viewer, through what `filter` leaves of it.
    fn own_light(&mut self, site: &Site, look: &Look, filter: Rgb) -> Rgb {
        let finish = look.finish;
        let mut glow = finish.emission;
        let mut diffuse = Rgb::ZERO;
        match &self.radiosity {
            Some(radiosity) => {
                let dry = radiosity.is_dry();
                if !self.modern {
                    glow += finish.ambient * self.world.scene.globals.ambient_light;
                }
                if !self.gathers_below(look) {
                    diffuse = self.diffuse(site, look, filter);
                }
                if dry {
                    return Rgb::ZERO;
                }
            }
            None => glow += finish.ambient * self.world.scene.globals.ambient_light,
        }
        let caustics = if self.photons.is_some() { self.caustics(site, look) } else { Rgb::ZERO };
        let below = if self.subsurface.is_some() { self.light_from_below(site, look) } else { Rgb::ZERO };
        below + look.color * (glow * look.opacity + diffuse) + self.direct(site, look) + caustics
    }

    /// Diffuse light from other surfaces, on the front and through from the back.
    fn diffuse(&mut self, site: &Site, look: &Look, filter: Rgb) -> Rgb {
        let bumpy = self.world.scene.globals.radiosity.as_ref().is_some_and(|r| r.normal);
        let normal = if bumpy { look.normal } else { site.facing };
        let sides = [(look.finish.raw_diffuse, 1.0), (look.finish.raw_diffuse_back, -1.0)];
        let mut sum = Rgb::ZERO;
        for (kept, (share, sign)) in site.diffuse.iter().zip(sides) {
            let part = grey(filter * look.color) * look.opacity * share;
            if share == 0.0 || part <= self.adc_bailout {
                continue;
            }
            if kept.get().is_none() {
                let query = Query {
                    departure: &site.departure(),
                    normal: sign * normal,
                    facing: sign * site.facing,
                    weight: site.path.weight * part,
                };
                kept.set(Some(self.diffuse_light(&query).unwrap_or(Rgb::ZERO)));
            }
            sum += kept.get().unwrap_or(Rgb::ZERO) * (look.opacity * share);
        }
        sum
    }

    /// Light from behind the surface. Straight on it is left to the caller's loop, for all stacks at once.
    fn pass(&mut self, site: &Site, stacks: &mut [Through], light: &mut Radiance) -> Option<Onward> {
        let straight = site.departure().ray(site.ray.dir);
        if !self.needs.interiors {
            return Some(joined(stacks, straight, Interiors::new(), Rgb::ONE));
        }
        let passage = Passage::new(self.world, &site.path.inside, site.hit.interior);
        let interior = self.world.interior(site.hit.interior);
        let fade = passage.leaves && refract::fades(interior);
        let faded = if fade { refract::faded(interior, site.hit.t) } else { Rgb::ONE };
        if passage.is_straight() {
            return Some(joined(stacks, straight, passage.inside, faded));
        }
        for stack in stacks {
            let (seen, filter) = self.refracted(site, &passage, stack);
            light.rgb += stack.share * faded * filter * seen.rgb;
            light.transmit += stack.share * grey(faded) * stack.clear * seen.transmit;
        }
        None
    }

    /// The reflected light of one layer.
    pub(super) fn bounce(&mut self, site: &Site, bounce: &Bounce) -> Rgb {
        let (ray, path) = (site.ray, site.path);
        self.counters.reflected_rays += 1;
        let direction = reflect::mirrored(ray.dir, bounce.normal, site.facing);
        let mut child = Path { weight: bounce.weight, class: mirrored_class(path.class), ..path.clone() };
        let mut rgb = self.trace(&site.departure().ray(direction), &mut child).rgb;
        let finish = bounce.finish;
        rgb *= self.film_factor(site, finish, bounce.normal, direction);
        if finish.reflection.power != 1.0 {
            rgb = rgb.max(Rgb::ZERO).powf(finish.reflection.power);
        }
        bounce.k * rgb
    }

    /// What a thin film does to light reflected from `direction`.
    fn film_factor(&self, site: &Site, finish: &Finish, normal: Vec3, direction: Vec3) -> Rgb {
        if finish.irid == 0.0 {
            return Rgb::ONE;
        }
        let film = iridescence::film(finish, site.hit.point, self.context.noise);
        let cosines = normal.dot(direction).abs() + normal.dot(site.ray.dir).abs();
        iridescence::factor(finish.irid, film, cosines, self.world.scene.globals.irid_wavelength)
    }

    /// Light from behind a bending surface through one stack, and the filter on it. Where all is reflected
    /// it is that light, unfiltered, and the stack is marked.
    fn refracted(&mut self, site: &Site, passage: &Passage, stack: &mut Through) -> (Radiance, Rgb) {
        let wavelength = site.path.wavelength;
        if passage.disperses() && wavelength.is_none() {
            let seen = self.dispersed(site, passage, stack);
            return (seen, stack.filter);
        }
        let ratio = match wavelength {
            Some(w) => passage.ratio_at(w),
            None => passage.ratio,
        };
        let (seen, all_reflected) = self.bend(site, passage, stack, ratio, wavelength);
        stack.all_reflected = all_reflected;
        (seen, if all_reflected { Rgb::ONE } else { stack.filter })
    }

    /// The mean over all bands of the spectrum.
    fn dispersed(&mut self, site: &Site, passage: &Passage, stack: &Through) -> Radiance {
        let bands = passage.dispersion_samples;
        let mut sum = Radiance::BLACK;
        for (wavelength, hue) in super::spectrum::bands(bands) {
            let ratio = passage.ratio_at(wavelength);
            let (seen, _) = self.bend(site, passage, stack, ratio, Some(wavelength));
            sum.rgb += hue * seen.rgb / bands as f32;
            sum.transmit += seen.transmit / bands as f32;
        }
        sum
    }

    /// The refracted ray's light, or that of the totally reflected ray and true.
    fn bend(
        &mut self,
        site: &Site,
        passage: &Passage,
        stack: &Through,
        ratio: f64,
        wavelength: Option<f64>,
    ) -> (Radiance, bool) {
        let mut child = Path { weight: stack.weight, wavelength, ..site.path.clone() };
        match refract::bent(site.ray.dir, stack.normal, ratio) {
            Some(direction) => {
                self.counters.refracted_rays += 1;
                child.inside = copied(&passage.inside);
                (self.trace(&site.departure().ray(direction), &mut child), false)
            }
            None => {
                self.counters.reflected_rays += 1;
                let direction = reflect::mirrored(site.ray.dir, stack.normal, site.facing);
                child.class = mirrored_class(child.class);
                let mut seen = self.trace(&site.departure().ray(direction), &mut child);
                if let Some(finish) = stack.finish {
                    seen.rgb *= self.film_factor(site, finish, stack.normal, direction);
                }
                (seen, true)
            }
        }
    }
}

/// What a layer shows outside of an image that is used once.
const NOT_FOUND: Color = Color::new(0.0, 0.0, 0.0, 0.0, 1.0);

/// All stacks passed by one straight ray.
fn joined(stacks: &[Through], ray: Ray, inside: Interiors, faded: Rgb) -> Onward {
    let mut onward = Onward { ray, factor: Rgb::ZERO, clear: 0.0, weight: 0.0, inside };
    for stack in stacks {
        onward.factor += stack.share * faded * stack.filter;
        onward.clear += stack.share * grey(faded) * stack.clear;
        onward.weight = onward.weight.max(stack.weight);
    }
    onward
}

/// The largest component of the reflection as declared, or for fresnel as it is.
pub(super) fn declared_maximum(finish: &Finish, k: Rgb) -> f32 {
    let r = &finish.reflection;
    if r.fresnel { k.max_element() } else { r.min.max_element().max(r.max.max_element()) }
}

#[inline]
fn mirrored_class(class: RayClass) -> RayClass {
    if class == RayClass::Image { RayClass::Reflected } else { class }
}
