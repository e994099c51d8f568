use super::light_choice::FEW;
use super::light_row::LightRow;
use super::media::{Medium, Worth};
use super::path::{Interiors, Path, Radiance, Veil, copied};
use super::photon::{Nearby, Neighbourhoods, Photons};
use super::radiosity::{Lighting, Radiosity};
use super::random::Random;
use super::shade::{Onward, Shaded};
use super::shared_dimming::SharedDimming;
use super::sights::Sights;
use super::sky::{self, Leaving};
use super::subsurface::Subsurface;
use super::{Counters, NotNumber, Pixel, Settings, rainbow};
use crate::camera::Lens;
use crate::color::Rgb;
use crate::math::{Range, Ray, Vec3};
use crate::pattern::Context;
use crate::world::{Between, Blocker, Crossed, Hit, InteriorId, RayClass, World};
use std::sync::Arc;

/// Stands for the length of a ray that meets nothing.
const FAR: f64 = 2e10;

/// Surfaces that one ray passes straight through before it is given up.
const MAX_PASSED: u32 = 1 << 16;

/// Rays through the lens that are worked out at once.
const SIDE_BY_SIDE: usize = 4;

/// Light that was spread over the scene before the picture is traced.
#[derive(Clone, Debug, Default)]
pub struct Indirect {
    pub photons: Option<Arc<Photons>>,
    pub radiosity: Option<Lighting>,
}

/// Follows rays through one world; one per thread.
pub struct Tracer<'w> {
    pub(super) world: &'w World,
    pub(super) settings: Settings,
    pub(super) counters: Counters,
    not_number: Option<NotNumber>,
    pub(super) random: Random,
    pub(super) needs: Needs,
    pub(super) adc_bailout: f32,
    pub(super) max_level: u32,
    /// Rules since version 3.7.
    pub(super) modern: bool,
    pub(super) context: Context<'static>,
    pub(super) radiosity: Option<Radiosity>,
    pub(super) subsurface: Option<Subsurface>,
    /// The photon maps, unless they are empty.
    pub(super) photons: Option<Arc<Photons>>,
    /// Lists of photons to be used again.
    pub(super) spare_nearby: Vec<Nearby>,
    /// Where photons on surfaces were looked for in this block.
    pub(super) photons_of_late: Neighbourhoods,
    /// Whether the surface being lit takes photons: what refracts them casts a full shadow on it.
    pub(super) collects: bool,
    lens: Option<Arc<Lens>>,
    sights: Sights,
    /// What the camera stands in, once found; for cameras with one viewpoint.
    camera_inside: Option<Interiors>,
    /// The place where the last photon started, and what it stands in.
    photon_inside: Option<(Vec3, Interiors)>,
    /// Every medium, those of one interior side by side; last those of the atmosphere.
    pub(super) media: Vec<Medium<'w>>,
    /// Media of each interior, as ranges of `media`.
    pub(super) media_of: Vec<(u32, u32)>,
    pub(super) air: (u32, u32),
    /// Light that reaches the hits being shaded, shared by their layers: a stack.
    pub(super) lit: Vec<Option<Rgb>>,
    /// What stopped the last shadow ray towards each light.
    pub(super) blockers: Vec<Blocker>,
    /// What the shadow ray under way crosses, as far as that is known.
    pub(super) crossed: Crossed,
    /// Whether light is looked for from a place in media.
    pub(super) scatters: bool,
    /// How much light a shadow ray may bring to the picture, if that is known.
    pub(super) shadow_worth: Worth,
    /// All global lights at once, where a few speak for all.
    pub(super) light_row: Option<LightRow>,
    /// Lamps of the area light being sampled.
    pub(super) lamps: Vec<Rgb>,
    /// What stands between it and the place that it lights.
    pub(super) between: Between,
    /// What media leave of their light.
    pub(super) shared_dimming: SharedDimming,
}

/// Which steps the scene needs at all.
#[derive(Clone, Copy, Debug)]
pub(super) struct Needs {
    /// Some interior bends, fades or fills, or hollowness matters: rays keep their lists of interiors.
    pub interiors: bool,
    /// Fog, rainbows or atmospheric media.
    pub atmosphere: bool,
    /// Some interior has media.
    pub media: bool,
    /// Some medium has a density that is not the same everywhere.
    pub clouds: bool,
    pub caustics: bool,
    /// Light may be changed on its way: some object lets it through, or there is something in the air.
    pub filters: bool,
}

impl Needs {
    fn new(world: &World, quality: u8) -> Self {
        let scene = &world.scene;
        let mut needs = Needs {
            interiors: false,
            atmosphere: quality >= 9
                && !(scene.fogs.is_empty() && scene.rainbows.is_empty() && scene.media.is_empty()),
            media: false,
            clouds: false,
            caustics: false,
            filters: true,
        };
        for (_, i) in world.interiors() {
            needs.interiors |= i.ior != 1.0 || i.dispersion != 1.0 || i.fade_distance != 0.0;
            needs.media |= quality >= 9 && !i.media.is_empty();
            needs.caustics |= i.caustics != 0.0;
        }
        needs.interiors |= needs.atmosphere || needs.media;
        needs.filters = needs.atmosphere || !world.stops_or_passes();
        needs
    }
}

impl<'w> Tracer<'w> {
    pub fn new(world: &'w World, settings: &Settings) -> Self {
        let globals = &world.scene.globals;
        let mut tracer = Self {
            world,
            settings: settings.clone(),
            counters: Counters::default(),
            not_number: None,
            random: Random::new(0, 0, 0),
            needs: Needs::new(world, settings.quality),
            adc_bailout: settings.overrides.adc_bailout.unwrap_or(globals.adc_bailout),
            max_level: settings.overrides.max_trace_level.unwrap_or(globals.max_trace_level).clamp(1, 256),
            modern: globals.effective_version >= 370,
            context: Context { noise: globals.noise_generator, waves: globals.number_of_waves, hit: None },
            radiosity: None,
            subsurface: Subsurface::new(world, settings.quality),
            photons: None,
            spare_nearby: Vec::new(),
            photons_of_late: Neighbourhoods::default(),
            collects: false,
            lens: None,
            sights: Sights::new(world, (f64::from(settings.width), f64::from(settings.height))),
            camera_inside: None,
            photon_inside: None,
            media: Vec::new(),
            media_of: Vec::new(),
            air: (0, 0),
            lit: Vec::new(),
            crossed: Crossed::default(),
            blockers: vec![Blocker::default(); world.lights.len() + world.group_lights.len()],
            scatters: false,
            shadow_worth: Worth::UNKNOWN,
            light_row: None,
            lamps: Vec::new(),
            between: Between::default(),
            shared_dimming: SharedDimming::default(),
        };
        tracer.lens = Lens::new(&world.scene.camera, &tracer.context).map(Arc::new);
        if tracer.needs.media || tracer.needs.atmosphere {
            tracer.list_media();
            tracer.needs.clouds = tracer.media.iter().any(|m| m.uniform().is_none());
        }
        tracer.radiosity =
            Lighting::unknown(world, settings).map(|l| Radiosity::new(world, settings, l, false));
        if tracer.radiosity.is_some() && world.lights.len() > FEW {
            tracer.light_row = LightRow::new(world.lights.iter().map(|l| &l.light));
        }
        tracer
    }

    /// A tracer that makes use of photons and of what a [`Pretrace`](super::Pretrace) found.
    pub fn lit(world: &'w World, settings: &Settings, indirect: &Indirect) -> Self {
        let mut tracer = Self::new(world, settings);
        if let (Some(_), Some(lighting)) = (&tracer.radiosity, &indirect.radiosity) {
            tracer.radiosity = Some(Radiosity::new(world, settings, lighting.clone(), false));
        }
        tracer.take_photons(indirect.photons.as_ref());
        tracer
    }

    pub(super) fn take_photons(&mut self, photons: Option<&Arc<Photons>>) {
        self.photons = photons.filter(|p| !(p.surface.is_empty() && p.media.is_empty())).cloned();
    }

    /// Called before each block of the picture: what is kept from pixel to pixel depends on it alone.
    pub fn begin_block(&mut self, serial: usize) {
        self.photons_of_late.clear();
        if let Some(radiosity) = &mut self.radiosity {
            radiosity.begin_block(serial);
        }
        if let Some(subsurface) = &mut self.subsurface {
            subsurface.begin_block(serial);
        }
    }

    fn list_media(&mut self) {
        for (id, interior) in self.world.interiors() {
            let first = self.media.len() as u32;
            let place = self.world.interior_to_world(id);
            self.media.extend(interior.media.iter().map(|m| Medium::new(m, place)));
            self.media_of.push((first, self.media.len() as u32));
        }
        let first = self.media.len() as u32;
        self.media.extend(self.world.scene.media.iter().map(|a| Medium::new(&a.value, &a.transform)));
        self.air = (first, self.media.len() as u32);
    }

    /// Called before each pixel or sample: all random draws until the next call depend on it alone.
    pub fn seed(&mut self, x: u32, y: u32, sample: u32) {
        self.random = Random::new(x, y, sample);
    }

    /// The colour seen through picture position (x, y): pixel (i, j) has its centre at (i+0.5, j+0.5), y
    /// runs down.
    pub fn pixel(&mut self, x: f64, y: f64) -> Pixel {
        let size = (f64::from(self.settings.width), f64::from(self.settings.height));
        match &self.lens {
            Some(lens) => self.blurred(&lens.clone(), (x, y), size),
            None if self.world.scene.camera.rays() > 1 => self.averaged((x, y), size),
            None => {
                let ray = self.world.scene.camera.ray(x, y, size, &self.context);
                self.seen(ray.as_ref(), |tracer, ray| tracer.sharp_ray(ray, (x, y), size))
            }
        }
    }

    /// The mean over those of the camera's rays that it has here.
    fn averaged(&mut self, (x, y): (f64, f64), size: (f64, f64)) -> Pixel {
        let camera = &self.world.scene.camera;
        let (mut sum, mut count) = (Pixel { rgb: Rgb::ZERO, transmit: 0.0 }, 0);
        for k in 0..camera.rays() {
            let Some(ray) = camera.nth_ray(k, x, y, size, &self.context) else { continue };
            let seen = self.seen_along(Some(ray));
            sum.rgb += seen.rgb;
            sum.transmit += seen.transmit;
            count += 1;
        }
        match count {
            0 => self.seen_along(None),
            n => Pixel { rgb: sum.rgb / n as f32, transmit: sum.transmit / n as f32 },
        }
    }

    /// The mean over rays from all over the lens.
    fn blurred(&mut self, lens: &Lens, place: (f64, f64), size: (f64, f64)) -> Pixel {
        let camera = &self.world.scene.camera;
        let (mut sums, mut squares) = ([0.0; 4], [0.0; 4]);
        let mut n = 0;
        for &end in lens.batches() {
            while n < end {
                // Rays need long chains of looking up: some are worked out side by side.
                let several = (end - n).min(SIDE_BY_SIDE);
                let ray = |k: usize| lens.ray(camera, n + k, place, size, &self.context);
                let rays: [_; SIDE_BY_SIDE] =
                    std::array::from_fn(|k| (k < several).then(|| ray(k)).flatten());
                for ray in rays.into_iter().take(several) {
                    let seen = self.seen_along(ray);
                    let channels = [seen.rgb.x, seen.rgb.y, seen.rgb.z, seen.transmit];
                    for (i, c) in channels.into_iter().enumerate() {
                        sums[i] += c;
                        squares[i] += c * c;
                    }
                }
                n += several;
            }
            if lens.is_enough(n, &sums, &squares) {
                break;
            }
        }
        let [r, g, b, transmit] = sums.map(|s| s / n as f32);
        Pixel { rgb: Rgb::new(r, g, b), transmit }
    }

    fn seen_along(&mut self, ray: Option<Ray>) -> Pixel {
        self.seen(ray.as_ref(), Self::camera_ray)
    }

    #[inline(always)]
    fn seen(&mut self, ray: Option<&Ray>, trace: impl FnOnce(&mut Self, &Ray) -> Radiance) -> Pixel {
        let nothing = Radiance { rgb: Rgb::ZERO, transmit: 1.0 };
        let mut seen = ray.map_or(nothing, |ray| trace(self, ray));
        if seen.rgb.is_nan() || seen.transmit.is_nan() {
            self.counters.not_numbers += 1;
            seen = Radiance::BLACK;
        }
        Pixel { rgb: seen.rgb, transmit: seen.transmit }
    }

    /// A camera's only ray through a place.
    fn sharp_ray(&mut self, ray: &Ray, place: (f64, f64), size: (f64, f64)) -> Radiance {
        // Cameras that do not see to any distance have no beams.
        let hit = match self.sights.at(self.world, place, size) {
            Some(sight) => self.world.nearest_in_sight(sight, ray, Range::FORWARD, RayClass::Image),
            None => return self.camera_ray(ray),
        };
        self.seen_by_camera(ray, hit.as_ref())
    }

    pub(super) fn camera_ray(&mut self, ray: &Ray) -> Radiance {
        let range = Range { max: self.world.scene.camera.max_distance(), ..Range::FORWARD };
        let hit = self.world.nearest(ray, range, RayClass::Image);
        self.seen_by_camera(ray, hit.as_ref())
    }

    /// A ray of the camera whose hit is known.
    fn seen_by_camera(&mut self, ray: &Ray, hit: Option<&Hit>) -> Radiance {
        self.counters.camera_rays += 1;
        if let Some(radiosity) = &mut self.radiosity {
            radiosity.begin_ray();
        }
        let inside = self.camera_interiors(ray);
        let mut path = Path { level: 0, weight: 1.0, class: RayClass::Image, wavelength: None, inside };
        self.trace_from(ray, &mut path, hit)
    }

    fn camera_interiors(&mut self, ray: &Ray) -> Interiors {
        if !self.needs.interiors {
            return Interiors::new();
        }
        if !self.world.scene.camera.has_fixed_origin() {
            return self.world.interiors_at(ray.origin);
        }
        copied(self.camera_inside.get_or_insert_with(|| self.world.interiors_at(ray.origin)))
    }

    /// What a photon starts in: mostly the same as the one before.
    pub(super) fn photon_interiors(&mut self, start: Vec3) -> Interiors {
        if !self.needs.interiors {
            return Interiors::new();
        }
        match &self.photon_inside {
            Some((place, inside)) if *place == start => copied(inside),
            _ => {
                let inside = self.world.interiors_at(start);
                self.photon_inside = Some((start, copied(&inside)));
                inside
            }
        }
    }

    /// Where a colour first came out as no number, if one did.
    pub fn not_number(&self) -> Option<NotNumber> {
        self.not_number
    }

    /// Draws what is no number black, and keeps where it came from: rays from further on were here before.
    #[cold]
    fn refuse(&mut self, hit: &Hit, shaded: &mut Shaded) {
        self.counters.not_numbers += 1;
        self.not_number.get_or_insert(NotNumber { kind: self.world.kind(hit), point: hit.point });
        *shaded = Shaded { light: Radiance::BLACK, onward: None };
    }

    pub fn counters(&self) -> Counters {
        self.counters
    }

    /// The colour that `ray` brings back.
    pub(super) fn trace(&mut self, ray: &Ray, path: &mut Path) -> Radiance {
        if path.level >= self.max_level || path.weight < self.adc_bailout {
            return Radiance::BLACK;
        }
        let hit = self.world.nearest(ray, Range::FORWARD, path.class);
        self.trace_from(ray, path, hit.as_ref())
    }

    /// The same, for a ray whose hit is known.
    pub(super) fn trace_from(&mut self, ray: &Ray, path: &mut Path, hit: Option<&Hit>) -> Radiance {
        if path.level >= self.max_level || path.weight < self.adc_bailout {
            return Radiance::BLACK;
        }
        path.level += 1;
        let Some(hit) = hit else { return self.leave(ray, path) };
        // What is no number comes out again below, and is noted there.
        if let Some(rgb) = self.plain(ray, hit, path).filter(|rgb| !rgb.is_nan()) {
            let light = Radiance { rgb, transmit: 0.0 };
            return if self.needs.interiors { self.segment_veil(ray, hit, path).over(light) } else { light };
        }
        let shaded = self.shaded(ray, hit, path);
        let front = if self.needs.interiors { self.segment_veil(ray, hit, path) } else { Veil::NONE };
        match shaded.onward {
            Some(onward) => self.trace_on(onward, shaded.light, path, front),
            None if self.needs.interiors => front.over(shaded.light),
            None => shaded.light,
        }
    }

    /// Behind a surface that was passed without bending; such surfaces are followed in a loop, and cost no
    /// level. `light` is that of the surface, `front` what lies before it.
    #[inline(never)]
    fn trace_on(
        &mut self,
        mut onward: Onward,
        mut light: Radiance,
        path: &mut Path,
        mut front: Veil,
    ) -> Radiance {
        for _ in 1..MAX_PASSED {
            let behind = Veil { factor: onward.factor, added: light.rgb, clear: onward.clear };
            front = behind.under(front);
            let ray = onward.ray;
            (path.weight, path.inside) = (onward.weight, onward.inside);
            if path.level >= self.max_level || path.weight < self.adc_bailout {
                return front.over(Radiance::BLACK);
            }
            let hit = self.world.nearest(&ray, Range::FORWARD, path.class);
            let Some(hit) = &hit else { return front.over(self.leave(&ray, path)) };
            let shaded = self.shaded(&ray, hit, path);
            if self.needs.interiors {
                front = self.segment_veil(&ray, hit, path).under(front);
            }
            let Some(further) = shaded.onward else { return front.over(shaded.light) };
            (onward, light) = (further, shaded.light);
        }
        front.over(Radiance::BLACK)
    }

    #[inline]
    fn shaded(&mut self, ray: &Ray, hit: &Hit, path: &Path) -> Shaded {
        let mut shaded = self.shade(ray, hit, path);
        if shaded.light.rgb.is_nan() || shaded.light.transmit.is_nan() {
            self.refuse(hit, &mut shaded);
        }
        shaded
    }

    /// The sky behind the air.
    fn leave(&mut self, ray: &Ray, path: &Path) -> Radiance {
        let leaving = Leaving {
            shows_alpha: self.settings.alpha && path.class == RayClass::Image,
            alpha: self.settings.alpha,
            modern: self.modern,
        };
        let scene = &self.world.scene;
        let sky = sky::sky(scene.background, scene.sky_sphere.as_ref(), ray.dir, leaving, &self.context);
        if self.needs.atmosphere && self.sees_media() && self.is_hollow(&path.inside) {
            self.atmosphere(ray, FAR, None, path).over(sky)
        } else {
            sky
        }
    }

    /// Interior media, then rainbows, atmospheric media and fog, between the ray's origin and its hit.
    fn segment_veil(&mut self, ray: &Ray, hit: &Hit, path: &Path) -> Veil {
        let filled = (self.needs.media || self.needs.atmosphere) && self.sees_media();
        if !filled || !self.is_hollow(&path.inside) {
            return Veil::NONE;
        }
        let mut veil = Veil::NONE;
        if self.needs.media && !path.inside.is_empty() {
            veil = self.interior_media(ray, hit, path);
        }
        if self.needs.atmosphere {
            veil = veil.under(self.atmosphere(ray, hit.t, Some(hit), path));
        }
        veil
    }

    fn atmosphere(&mut self, ray: &Ray, length: f64, hit: Option<&Hit>, path: &Path) -> Veil {
        let scene = &self.world.scene;
        let mut veil = Veil::NONE;
        if !scene.rainbows.is_empty() {
            veil = rainbow::veil(&scene.rainbows, ray, length, &mut self.random);
        }
        if self.air.0 < self.air.1 {
            veil = veil.under(self.air_media(ray, length, hit, path));
        }
        if !scene.fogs.is_empty() {
            veil = veil.under(super::fog::veil(&scene.fogs, ray, length, self.context.noise));
        }
        veil
    }

    /// Whether the ray being traced sees media and fog.
    fn sees_media(&self) -> bool {
        self.radiosity.as_ref().is_none_or(Radiosity::sees_media)
    }

    pub(super) fn is_hollow(&self, inside: &[InteriorId]) -> bool {
        inside.iter().all(|&i| self.world.is_hollow(i))
    }
}
