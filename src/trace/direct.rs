//! Light that comes to a surface straight from lights: diffuse reflection and highlights.

use super::shade::Site;
use super::tracer::Tracer;
use super::{highlight, iridescence};
use crate::color::Rgb;
use crate::light::is_dark;
use crate::material::Finish;
use crate::math::Vec3;
use crate::world::{RayClass, WorldLight};

/// Cosines below this count as unlit.
pub(super) const LIT: f64 = 1e-10;

/// One layer as light sees it.
pub(super) struct Look<'a> {
    pub finish: &'a Finish,
    /// The pigment.
    pub color: Rgb,
    pub opacity: f32,
    /// Unit shading normal towards the viewer.
    pub normal: Vec3,
}

impl Look<'_> {
    /// `Some(true)` if light from `l` falls on the back and shines through, `Some(false)` on the front;
    /// `None` if it does not count.
    #[inline]
    pub(super) fn is_lit_from_behind(&self, l: Vec3, both_sides: bool) -> Option<bool> {
        if both_sides || self.normal.dot(l) >= LIT {
            Some(false)
        } else {
            (self.finish.diffuse_back != 0.0).then_some(true)
        }
    }
}

impl Tracer<'_> {
    /// The sum over all lights of a layer.
    pub(super) fn direct(&mut self, site: &Site, look: &Look) -> Rgb {
        let f = look.finish;
        if f.diffuse == 0.0 && f.diffuse_back == 0.0 && f.specular == 0.0 && f.phong == 0.0 {
            return Rgb::ZERO;
        }
        let world = self.world;
        self.collects = self.photons.is_some() && world.photon_rules(site.hit).collect;
        let global = if site.hit.ignores_global_lights { &[][..] } else { &world.lights[..] };
        let (first, end) = site.hit.group_lights;
        let group = &world.group_lights[first as usize..end as usize];
        if self.may_choose(site, look, global.len() + group.len()) {
            return self.chosen(site, look, global.iter().chain(group));
        }
        let mut sum = Rgb::ZERO;
        for (i, light) in global.iter().enumerate() {
            if light.plain && site.lit.is_none() {
                sum += self.by_plain_light(site, look, light);
                continue;
            }
            sum += self.by_light(site, look, light, site.lit.map(|base| base + i));
        }
        for light in group {
            sum += self.by_light(site, look, light, None);
        }
        sum
    }

    /// A light that needs nothing but its place and colour.
    #[inline]
    fn by_plain_light(&mut self, site: &Site, look: &Look, source: &WorldLight) -> Rgb {
        let (direction, distance) = source.light.from_point(site.hit.point);
        let Some(behind) = look.is_lit_from_behind(direction, site.hit.double_illuminate) else {
            return Rgb::ZERO;
        };
        if !self.may_answer(site, look, direction, behind, false) {
            return Rgb::ZERO;
        }
        let mut color = source.light.color;
        if self.settings.quality >= 4 {
            let ray = site.departure().ray(direction);
            color = self.transmitted(&ray, distance, &site.path.inside, source, color);
            if is_dark(color) {
                return Rgb::ZERO;
            }
        }
        self.answer(site, look, direction, color, behind, false)
    }

    /// `kept` is the place of the light's shadowed colour among those of this hit.
    fn by_light(&mut self, site: &Site, look: &Look, source: &WorldLight, kept: Option<usize>) -> Rgb {
        let point = site.hit.point;
        let light = &source.light;
        let lamps = light.area.as_ref().filter(|a| a.illumination && self.uses_area(site.path.class));
        if lamps.is_some() {
            return self.by_lamps(site, look, source);
        }
        let towards = light.towards(point, Vec3::ZERO);
        let Some(behind) = look.is_lit_from_behind(towards.0, site.hit.double_illuminate) else {
            return Rgb::ZERO;
        };
        if !self.may_answer(site, look, towards.0, behind, light.shadowless) {
            return Rgb::ZERO;
        }
        let Some(arrival) = light.arrival_from(point, Vec3::ZERO, towards) else { return Rgb::ZERO };
        let color = match kept.and_then(|k| self.lit[k]) {
            Some(color) => color,
            None => {
                let inside = &site.path.inside;
                let color = self.shadowed(&site.departure(), inside, source, &arrival, site.path.class);
                if let Some(k) = kept {
                    self.lit[k] = Some(color);
                }
                color
            }
        };
        if is_dark(color) {
            return Rgb::ZERO;
        }
        self.answer(site, look, arrival.direction, color, behind, light.shadowless)
    }

    /// Every lamp of an area light with its own direction; the shadow is that of the whole.
    fn by_lamps(&mut self, site: &Site, look: &Look, source: &WorldLight) -> Rgb {
        let (light, point) = (&source.light, site.hit.point);
        let Some(area) = &light.area else { return Rgb::ZERO };
        let (direction, distance) = light.towards(point, Vec3::ZERO);
        let whole = crate::light::Arrival { direction, distance, strength: 1.0, color: light.color };
        let inside = &site.path.inside;
        let shadowed = self.shadowed(&site.departure(), inside, source, &whole, site.path.class);
        if is_dark(shadowed) {
            return Rgb::ZERO;
        }
        let share = 1.0 / (area.size1 * area.size2) as f32;
        let axes = area.axes(direction);
        let mut sum = Rgb::ZERO;
        for v in 0..area.size2 {
            for u in 0..area.size1 {
                let (u, v) = self.lamp_place(area.jitter, u, v);
                let Some(lamp) = light.arrival(point, area.offset(axes, u, v)) else { continue };
                let both = site.hit.double_illuminate;
                let Some(behind) = look.is_lit_from_behind(lamp.direction, both) else { continue };
                let color = shadowed * (lamp.strength * share);
                sum += self.answer(site, look, lamp.direction, color, behind, light.shadowless);
            }
        }
        sum
    }

    /// Whether the layer sends anything to the viewer of light from direction `l`: clear glass mostly does not, and
    /// then it is of no account what stands in the light's way.
    #[inline]
    fn may_answer(&self, site: &Site, look: &Look, l: Vec3, behind: bool, shadowless: bool) -> bool {
        let f = look.finish;
        let diffuse = if behind { f.diffuse_back } else { f.diffuse };
        let scatters = f.crand != 0.0 || (look.opacity != 0.0 && look.color != Rgb::ZERO);
        if diffuse > 0.0 && scatters && !self.is_translucent(look) {
            return true;
        }
        highlight_of(site, look, l, behind, shadowless) > 0.0
    }

    /// What the layer sends to the viewer of light `color` from direction `l`.
    pub(super) fn answer(
        &mut self,
        site: &Site,
        look: &Look,
        l: Vec3,
        color: Rgb,
        behind: bool,
        shadowless: bool,
    ) -> Rgb {
        let f = look.finish;
        let c = look.normal.dot(l);
        let mut sum = Rgb::ZERO;
        let diffuse = match behind {
            _ if self.is_translucent(look) => 0.0,
            true => f.diffuse_back,
            false => f.diffuse,
        };
        if diffuse > 0.0 {
            let cosine = c.abs() as f32;
            let falloff = if f.brilliance == 1.0 { cosine } else { cosine.powf(f.brilliance) };
            let mut share = falloff * diffuse * look.opacity;
            if f.crand != 0.0 {
                share -= f.crand * self.random.draw() as f32;
            }
            sum += look.color * color * share;
        }
        let strength = highlight_of(site, look, l, behind, shadowless);
        if strength > 0.0 {
            let tint = if f.metallic == 0.0 {
                Rgb::ONE
            } else {
                highlight::metallic_tint(f.metallic, c, look.color)
            };
            sum += strength * color * tint;
        }
        if f.irid > 0.0 {
            let film = iridescence::film(f, site.hit.point, self.context.noise);
            let cosines = c.abs() + look.normal.dot(site.ray.dir).abs();
            let wavelength = self.world.scene.globals.irid_wavelength;
            sum *= iridescence::factor(f.irid, film, cosines, wavelength);
        }
        sum
    }
}

/// The strength of a layer's highlights for light from direction `l`.
#[inline]
fn highlight_of(site: &Site, look: &Look, l: Vec3, behind: bool, shadowless: bool) -> f32 {
    let f = look.finish;
    let shines = f.phong > 0.0 || f.specular > 0.0;
    if !shines || shadowless || behind || site.path.class == RayClass::Radiosity {
        return 0.0;
    }
    highlight::strength(f, site.ray.dir, look.normal, l)
}
