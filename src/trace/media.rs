//! Participating media over a stretch of a ray: absorption, emission, and light scattered towards the eye.
//!
//! The stretch is cut into intervals, lit and unlit ones; in each the medium is sampled ([`sampling`]);
//! front to back, what an interval sends is dimmed by the optical depth before it.

use super::Overrides;
use super::dimming;
use super::media_sampling::{self as sampling, Plan};
use super::path::{Departure, Path, Veil};
use super::tracer::Tracer;
use crate::color::{Rgb, grey};
use crate::light::is_dark;
use crate::material::{Media, Rough};
use crate::math::{Ray, Transform, Vec3, chi_square};
use crate::world::{Hit, RayClass, WorldLight};
use glam::DAffine3;
use smallvec::SmallVec;
use std::cell::Cell;

/// A medium where it stands.
#[derive(Debug)]
pub(super) struct Medium<'w> {
    pub media: &'w Media,
    world_to_medium: DAffine3,
    /// The density if it is the same everywhere.
    uniform: Option<Rgb>,
    /// The last place asked for and the density there: light is followed from where it is scattered.
    last: Cell<(Vec3, Rgb)>,
    /// The brightest colour of each density, and their product; empty if one is not known.
    brightest: Vec<f32>,
    /// What helps to find each density roughly.
    rough: Vec<Option<Rough>>,
    largest: f32,
    /// Variances below which an interval has samples enough, by number of samples less 1.
    pub thresholds: Vec<f32>,
}

impl<'w> Medium<'w> {
    pub fn new(media: &'w Media, place: &Transform) -> Self {
        let plain = |d: &std::sync::Arc<crate::material::Pigment>| d.plain().map(|c| c.rgb);
        let brightest: Option<Vec<f32>> = media.densities.iter().map(|d| d.brightest()).collect();
        let brightest = brightest.unwrap_or_default();
        let world_to_medium = media.transform.then(place).inverse;
        let rough =
            |d: &std::sync::Arc<crate::material::Pigment>| Some(d.rough()?.seen_from(&world_to_medium));
        Self {
            media,
            rough: media.densities.iter().map(rough).collect(),
            largest: brightest.iter().product(),
            brightest,
            world_to_medium,
            uniform: media.densities.iter().map(plain).product(),
            last: Cell::new((Vec3::NAN, Rgb::ZERO)),
            thresholds: thresholds(media),
        }
    }

    /// The density if it is the same everywhere.
    pub fn uniform(&self) -> Option<Rgb> {
        self.uniform
    }

    pub fn extinction(&self) -> Rgb {
        self.media.absorption + self.media.extinction * self.media.scattering
    }
}

fn thresholds(media: &Media) -> Vec<f32> {
    let (min, max) = media.samples;
    if max <= min || media.method == 3 {
        return Vec::new();
    }
    let confidence = f64::from(media.confidence);
    let last = chi_square::quantile(max - 1, confidence);
    let unit = if last == 0.0 { 1e-10 } else { 1.0 / last };
    (1..=max)
        .map(|n| (f64::from(media.variance) * unit * chi_square::quantile(n, confidence)) as f32)
        .collect()
}

/// How much light a shadow ray may bring to the picture.
#[derive(Clone, Copy, Debug)]
pub(super) struct Worth {
    most: f32,
    /// Less is little.
    faint: f32,
}

impl Worth {
    pub const UNKNOWN: Worth = Worth { most: f32::INFINITY, faint: 0.0 };

    /// Of light that falls on a surface.
    pub fn at_surface(color: Rgb) -> Self {
        let most = color.abs().max_element();
        Self { most, faint: FAINT.min(FAINT_AT_SURFACES * most) }
    }

    pub fn is_known(&self) -> bool {
        self.most < f32::INFINITY
    }

    /// One of `count` rays that share it.
    pub fn shared(self, count: usize) -> Self {
        Self { most: self.most / count.max(1) as f32, faint: self.faint / count.max(1) as f32 }
    }
}

/// A light whose beam crosses the stretch.
pub(super) struct Beam<'w> {
    source: &'w WorldLight,
    /// Where it begins and ends on the ray's line.
    from: f64,
    to: f64,
}

/// The stretch being looked through.
pub(super) struct Stretch<'a, 'w> {
    pub ray: &'a Ray,
    pub length: f64,
    /// Places in `Tracer::media`.
    pub media: SmallVec<[u32; 4]>,
    /// `None` for shadow rays, which ask for the dimming alone.
    pub path: Option<&'a Path>,
    pub beams: SmallVec<[Beam<'w>; 4]>,
    /// At most this share of the light sent from where is sampled now reaches the picture, per unit length.
    pub share: Cell<f32>,
    /// One sample's part of that.
    pub sample_share: Cell<f32>,
    /// What a shadow ray means to the picture.
    pub worth: Worth,
    /// The most that a light has been worth so far.
    strongest: Cell<f32>,
    /// The light that it stands for besides its own, 0 if it is given up; see [`Tracer::goes_on`].
    pub boost: Cell<f32>,
    /// Error of the optical depth that makes no difference; 0 for the truth.
    pub slack: Cell<f32>,
}

/// Light of samples that adds less than this to a pixel is not looked for.
const UNSEEN: f32 = 1e-6;

/// A shadow ray in which less light is left, of what reaches the picture, goes on by chance: but no light counts
/// as little that is this share of the most that one place sends, and less at surfaces.
const FAINT: f32 = 0.03;
const FAINT_IN_MEDIA: f32 = 0.3;
const FAINT_AT_SURFACES: f32 = 0.02;

/// Error of a shadow ray's light in the picture, times its optical depth's, that makes no difference.
const ALIKE: f32 = 1.0;

/// The largest error of an optical depth: a bound that errors hardly ever come near.
const MOST_SLACK: f32 = 2.0;

/// Error of the optical depth that the camera looks through, times what is seen of it, that makes no difference.
/// Errors of single samples are far smaller than their bounds, and add up by chance.
pub(super) const ALIKE_IN_SIGHT: f32 = 0.05;

impl<'a, 'w> Stretch<'a, 'w> {
    pub fn new(
        ray: &'a Ray,
        length: f64,
        media: SmallVec<[u32; 4]>,
        path: Option<&'a Path>,
        beams: SmallVec<[Beam<'w>; 4]>,
    ) -> Self {
        Self {
            ray,
            length,
            media,
            path,
            beams,
            share: Cell::new(f32::INFINITY),
            sample_share: Cell::new(f32::INFINITY),
            worth: Worth::UNKNOWN,
            strongest: Cell::new(0.0),
            boost: Cell::new(1.0),
            slack: Cell::new(0.0),
        }
    }

    pub fn is_shadow(&self) -> bool {
        self.path.is_none()
    }

    /// The lit parts, sorted and merged.
    pub fn lit_parts(&self) -> SmallVec<[(f64, f64); 4]> {
        let mut parts: SmallVec<[(f64, f64); 4]> =
            self.beams.iter().map(|b| (b.from.max(0.0), b.to.min(self.length))).collect();
        parts.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut merged: SmallVec<[(f64, f64); 4]> = SmallVec::new();
        for part in parts {
            match merged.last_mut() {
                Some(last) if part.0 <= last.1 => last.1 = last.1.max(part.1),
                _ => merged.push(part),
            }
        }
        merged
    }
}

/// What a medium does at one point, per unit length.
#[derive(Clone, Copy, Debug)]
pub(super) struct Local {
    /// Light sent to the eye.
    pub glow: Rgb,
    pub extinction: Rgb,
}

impl<'w> Tracer<'w> {
    /// Media of the interiors that the ray is inside of, up to its hit.
    pub(super) fn interior_media(&mut self, ray: &Ray, hit: &Hit, path: &Path) -> Veil {
        let ranges: SmallVec<[(u32, u32); 4]> =
            path.inside.iter().map(|i| self.media_of[i.0 as usize]).collect();
        self.media_veil(ray, hit.t, Some(hit), path, &ranges)
    }

    /// Media of the atmosphere.
    pub(super) fn air_media(&mut self, ray: &Ray, length: f64, hit: Option<&Hit>, path: &Path) -> Veil {
        self.media_veil(ray, length, hit, path, &[self.air])
    }

    fn media_veil(
        &mut self,
        ray: &Ray,
        length: f64,
        hit: Option<&Hit>,
        path: &Path,
        ranges: &[(u32, u32)],
    ) -> Veil {
        let media: SmallVec<[u32; 4]> = ranges.iter().flat_map(|r| r.0..r.1).collect();
        if media.is_empty() {
            return Veil::NONE;
        }
        let beams = self.beams(ray, length, hit);
        let stretch = Stretch::new(ray, length, media, Some(path), beams);
        let plan = self.plan_of(&stretch);
        let (glow, depth) = sampling::sampled(self, &stretch, &plan);
        let factor = exp(-depth);
        Veil { factor, added: glow, clear: grey(factor) }
    }

    /// What media leave of light over the first `length` of a shadow ray.
    pub(super) fn media_shadow(&mut self, ray: &Ray, length: f64, ranges: &[(u32, u32)]) -> Rgb {
        let all = ranges.iter().flat_map(|r| r.0..r.1);
        let media: SmallVec<[u32; 4]> =
            all.filter(|&m| self.media[m as usize].extinction() != Rgb::ZERO).collect();
        if media.is_empty() {
            return Rgb::ONE;
        }
        let uniform = |m: &u32| {
            let medium = &self.media[*m as usize];
            medium.uniform.map(|d| d * medium.extinction())
        };
        if let Some(extinction) = media.iter().map(uniform).sum::<Option<Rgb>>() {
            return exp(-extinction * length as f32);
        }
        if let Some(left) = self.shared_dimming.recall(&media) {
            return left;
        }
        let mut stretch = Stretch::new(ray, length, media, None, SmallVec::new());
        stretch.worth = self.shadow_worth;
        let plan = self.plan_of(&stretch);
        let depth = dimming::depth(self, &stretch, &plan);
        let left = exp(-depth) * stretch.boost.get();
        self.shared_dimming.keep(stretch.media, left);
        left
    }

    /// Settings of the medium with most intervals.
    pub(super) fn plan_of(&self, stretch: &Stretch) -> Plan {
        let all = || stretch.media.iter().map(|&m| &self.media[m as usize]);
        let mut first = stretch.media[0];
        for &m in &stretch.media {
            if self.media[m as usize].media.intervals > self.media[first as usize].media.intervals {
                first = m;
            }
        }
        let threshold = all().map(|m| m.media.aa_threshold).fold(f32::INFINITY, f32::min);
        let plan = Plan::new(first, &self.media[first as usize], threshold);
        if self.settings.overrides.reference {
            return plan.fine();
        }
        let Overrides { media_samples, media_intervals, .. } = self.settings.overrides;
        plan.with(media_samples, media_intervals)
    }

    /// The lights that light the stretch: those that light the object at its end.
    pub(super) fn beams(&self, ray: &Ray, length: f64, hit: Option<&Hit>) -> SmallVec<[Beam<'w>; 4]> {
        let world = self.world;
        let global = if hit.is_some_and(|h| h.ignores_global_lights) { &[][..] } else { &world.lights[..] };
        let (first, end) = hit.map_or((0, 0), |h| h.group_lights);
        let group = &world.group_lights[first as usize..end as usize];
        let beam = |source: &'w WorldLight| {
            let light = &source.light;
            if !light.media_interaction || light.shadowless {
                return None;
            }
            let (from, to) = light.section(ray)?;
            (from.max(0.0) < to.min(length)).then_some(Beam { source, from, to })
        };
        global.iter().chain(group).filter_map(beam).collect()
    }

    /// The medium at distance `s` along the stretch.
    pub(super) fn local(&mut self, stretch: &Stretch, s: f64, lit: bool) -> Local {
        let p = stretch.ray.at(s);
        let mut local = Local { glow: Rgb::ZERO, extinction: Rgb::ZERO };
        let mut scattering = Rgb::ZERO;
        for &m in &stretch.media {
            let density = self.density(stretch, m, p);
            let medium = &self.media[m as usize];
            local.glow += medium.media.emission * density;
            local.extinction += medium.extinction() * density;
            scattering += medium.media.scattering * density;
        }
        if scattering == Rgb::ZERO || stretch.is_shadow() {
            return local;
        }
        if lit {
            local.glow += scattering * self.scattered(stretch, p, s, scattering);
        }
        if self.photons.is_some() {
            local.glow += scattering * self.scattered_photons(stretch, p);
        }
        local
    }

    /// Whether a shadow ray goes on behind optical depth `depth`. Where little light is left of what reaches the
    /// picture, chance decides, and the rays that go on stand for those that do not.
    ///
    /// Reference: J. Vorba, J. Krivanek, "Adjoint-Driven Russian Roulette and Splitting in Light Transport
    /// Simulation", ACM Transactions on Graphics 35, 2016.
    pub(super) fn goes_on(&mut self, stretch: &Stretch, depth: Rgb) -> bool {
        let Worth { most, faint } = stretch.worth;
        if !stretch.worth.is_known() {
            return true;
        }
        let boost = stretch.boost.get();
        let left = most * boost * (-depth.min_element()).exp();
        stretch.slack.set((ALIKE / left).min(MOST_SLACK));
        if left < faint {
            let stays = self.random.draw() as f32 * faint < left;
            stretch.boost.set(if stays { boost * faint / left } else { 0.0 });
            return stays;
        }
        true
    }

    pub(super) fn density(&self, stretch: &Stretch, m: u32, p: Vec3) -> Rgb {
        let medium = &self.media[m as usize];
        if let Some(uniform) = medium.uniform {
            return uniform;
        }
        let (place, density) = medium.last.get();
        if place == p {
            return density;
        }
        let depth = medium.extinction().max_element() * stretch.length as f32 * medium.largest;
        let tolerance = if depth > 0.0 { stretch.slack.get() / depth } else { 0.0 };
        let density = self.density_at(medium, p, tolerance);
        if !stretch.is_shadow() {
            medium.last.set((p, density));
        }
        density
    }

    /// The product of all densities; of each, errors up to `tolerance` times its brightest make no difference.
    fn density_at(&self, medium: &Medium, p: Vec3, tolerance: f32) -> Rgb {
        let mut product = Rgb::ONE;
        for (i, density) in medium.media.densities.iter().enumerate() {
            let tolerance = tolerance * medium.brightest.get(i).unwrap_or(&0.0);
            let rough = medium.rough[i].as_ref();
            let calm = rough.filter(|_| tolerance > 0.0);
            let calm = calm.and_then(|rough| density.calm_color(rough, p, &self.context, tolerance));
            let color = calm.or_else(|| {
                let p = medium.world_to_medium.transform_point3(p);
                match rough {
                    Some(rough) => density.rough_color(rough, p, &self.context, tolerance),
                    None => density.color(p, &self.context),
                }
            });
            product *= color.map_or(Rgb::ZERO, |c| c.rgb);
            if product == Rgb::ZERO {
                break;
            }
        }
        product
    }

    /// Light that arrives at `p` and is scattered to the eye, for scattering 1.
    fn scattered(&mut self, stretch: &Stretch, p: Vec3, s: f64, scattering: Rgb) -> Rgb {
        let Some(path) = stretch.path else { return Rgb::ZERO };
        let mut sum = Rgb::ZERO;
        for beam in stretch.beams.iter().filter(|b| b.from < s && s < b.to) {
            let Some(arrival) = beam.source.light.arrival(p, Vec3::ZERO) else { continue };
            let phase = self.phase(stretch, arrival.direction.dot(stretch.ray.dir));
            let most = (scattering * arrival.color * phase * stretch.share.get()).abs().max_element();
            if most < UNSEEN {
                continue;
            }
            let Some(boost) = self.picks(stretch, most * stretch.sample_share.get()) else { continue };
            self.scatters = true;
            let color =
                self.shadowed(&Departure::free(p), &path.inside, beam.source, &arrival, RayClass::Image);
            self.shadow_worth = Worth::UNKNOWN;
            self.scatters = false;
            if !is_dark(color) {
                sum += boost * phase * color;
            }
        }
        sum
    }

    /// Whether a light is looked for that adds no more than `worth` to the picture; where it is little, chance
    /// decides, and the light found stands for so many.
    fn picks(&mut self, stretch: &Stretch, worth: f32) -> Option<f32> {
        if !self.needs.clouds || self.settings.overrides.reference || !worth.is_finite() {
            return Some(1.0);
        }
        let strongest = stretch.strongest.get().max(worth);
        stretch.strongest.set(strongest);
        let faint = FAINT.min(FAINT_IN_MEDIA * strongest);
        self.shadow_worth = Worth { most: worth.max(faint), faint };
        if worth >= faint {
            return Some(1.0);
        }
        (self.random.draw() as f32 * faint < worth).then(|| faint / worth)
    }

    /// The mean phase factor of the media; `cosine` is 1 when looking towards the light.
    pub(super) fn phase(&self, stretch: &Stretch, cosine: f64) -> f32 {
        let all = stretch.media.iter().map(|&m| phase(self.media[m as usize].media, cosine));
        (all.sum::<f64>() / stretch.media.len() as f64) as f32
    }
}

/// How strongly light is scattered by an angle with the given cosine, against the mean.
///
/// References: T. Nishita et al., "A Shading Model for Atmospheric Scattering", 1987 (hazy, murky); Lord
/// Rayleigh 1871; L. Henyey, J. Greenstein, "Diffuse Radiation in the Galaxy", 1941.
fn phase(media: &Media, cosine: f64) -> f64 {
    let half = 0.5 * (1.0 + cosine);
    match media.scattering_type {
        2 => 0.576655375 * (1.0 + 9.0 * half.powi(8)),
        3 => 0.495714547 * (1.0 + 50.0 * half.powi(32)),
        4 => 0.799372013 * (1.0 + cosine * cosine),
        5 => {
            let g = f64::from(media.eccentricity);
            (1.0 - g * g) / (1.0 + g * g - 2.0 * g * cosine).powf(1.5)
        }
        _ => 1.0,
    }
}

pub(super) fn exp(c: Rgb) -> Rgb {
    Rgb::new(c.x.exp(), c.y.exp(), c.z.exp())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Henyey-Greenstein and Rayleigh scattering conserve light: their mean over the sphere is 1.
    #[test]
    fn henyey_greenstein_has_mean_one() {
        let mut media = crate::trace::media_sampling::tests::medium();
        media.scattering_type = 5;
        media.eccentricity = 0.6;
        let n = 100_000;
        let mean =
            (0..n).map(|i| phase(&media, 2.0 * (f64::from(i) + 0.5) / f64::from(n) - 1.0)).sum::<f64>()
                / f64::from(n);
        assert!((mean - 1.0).abs() < 1e-6, "{mean}");
    }
}
