//! Light that mirrors and lenses gather: photons shot from lights at the objects that the scene names,
//! kept where they land, and looked up around the places that are shaded.
//!
//! [`Shooting`] plans rings of photons, one salvo at a time; the photons of a salvo may be followed by any
//! number of threads in any order. They are stored in the order of their rings, and rings after the one
//! that ends a pair are thrown away, so the maps do not depend on threads. They are those of the
//! reference's one-thread order.

mod aim;
mod crowd;
mod estimate;
mod follow;
mod map;
mod media;
mod neighbourhood;
mod order;
mod radius;

pub use aim::{Kinds, Stream};
pub use map::{Nearby, PhotonMap};
pub use neighbourhood::Neighbourhoods;

use super::{Settings, Tracer};
use crate::light::{PackedPhoton, PhotonFile};
use crate::scene::PhotonSettings;
use crate::world::World;
use aim::{Aim, Shot};
use std::sync::Arc;

/// The finished maps.
#[derive(Debug)]
pub struct Photons {
    pub(super) settings: PhotonSettings,
    pub surface: PhotonMap,
    pub media: PhotonMap,
    /// How far is looked for photons.
    pub surface_radius: f64,
    pub media_radius: f64,
}

/// Photons that one shot left.
#[derive(Clone, Debug, Default)]
pub struct Landed {
    surface: Vec<PackedPhoton>,
    media: Vec<PackedPhoton>,
    hit_target: bool,
}

/// Photons of a salvo, about.
const SALVO: usize = 1 << 13;

/// The shooting of all photons.
#[derive(Debug)]
pub struct Shooting<'w> {
    world: &'w World,
    settings: Settings,
    photons: PhotonSettings,
    aims: Vec<Aim>,
    /// The pair being shot.
    pair: usize,
    /// Place of the next ring; whether an earlier one of the pair has hit.
    next: f64,
    has_hit: bool,
    random: Stream,
    media_draws: Stream,
    shots: Vec<Shot>,
    rings: Vec<Ring>,
    surface: Vec<PackedPhoton>,
    media: Vec<PackedPhoton>,
}

/// A ring of the present salvo.
#[derive(Clone, Copy, Debug)]
struct Ring {
    at: f64,
    /// Draws after it.
    random: Stream,
}

impl<'w> Shooting<'w> {
    /// `None` if the picture has no photons.
    pub fn new(world: &'w World, settings: &Settings) -> Option<Self> {
        let photons = world.scene.globals.photons.clone();
        let photons = photons.filter(|p| settings.quality >= 9 && p.gather_max > 0)?;
        let mut photons = settings.overrides.photons(&photons);
        if settings.overrides.reference {
            refine(&mut photons);
        }
        let aims = if photons.load.is_some() { Vec::new() } else { aim::aims(world, &photons) };
        Some(Self {
            world,
            settings: settings.clone(),
            photons,
            aims,
            pair: 0,
            next: 0.0,
            has_hit: false,
            random: Stream::default(),
            media_draws: Stream::default(),
            shots: Vec::new(),
            rings: Vec::new(),
            surface: Vec::new(),
            media: Vec::new(),
        })
    }

    /// A tracer for [`Shooting::follow`]; one per thread.
    pub fn tracer(&self) -> Tracer<'w> {
        let mut tracer = Tracer::new(self.world, &self.settings);
        tracer.adc_bailout = self.photons.adc_bailout.unwrap_or(tracer.adc_bailout);
        tracer.max_level = self.photons.max_trace_level.unwrap_or(tracer.max_level);
        tracer
    }

    /// Whether photons stay in media: then all draw from one row of numbers, and each must wait for the
    /// one before it.
    pub fn is_serial(&self) -> bool {
        self.photons.media_steps > 0
    }

    /// Plans the next salvo and says how many shots it has; `None` when all is done.
    pub fn aim(&mut self) -> Option<usize> {
        self.shots.clear();
        self.rings.clear();
        while let Some(aim) = self.aims.get(self.pair) {
            if aim.reaches(self.next) {
                self.plan_rings();
                return Some(self.shots.len());
            }
            self.end_pair();
        }
        None
    }

    fn end_pair(&mut self) {
        self.pair += 1;
        self.next = 0.0;
        self.has_hit = false;
    }

    fn plan_rings(&mut self) {
        let aim = &self.aims[self.pair];
        let light = &self.world.lights[aim.light].light;
        let most = if self.is_serial() { 1 } else { SALVO };
        while self.shots.len() < most && aim.reaches(self.next) {
            let (ring, at) = (self.rings.len(), self.next);
            let shots = &mut self.shots;
            aim.ring(light, at, self.photons.jitter, &mut self.random, |ray, strength| {
                shots.push(Shot { ray, strength, ring });
            });
            self.rings.push(Ring { at, random: self.random });
            self.next += aim.step();
            if self.is_serial() {
                break;
            }
        }
    }

    /// Follows the shots of a range of the salvo.
    pub fn follow(&self, tracer: &mut Tracer, shots: std::ops::Range<usize>) -> Vec<(usize, Landed)> {
        let aim = &self.aims[self.pair];
        let landed = |shot: &Shot| {
            let mut landed = Landed::default();
            tracer.follow(shot, aim, None, &mut landed);
            (shot.ring, landed)
        };
        joined(self.shots[shots].iter().map(landed))
    }

    /// Follows the whole salvo, one shot after the other.
    pub fn follow_serially(&mut self, tracer: &mut Tracer) -> Vec<(usize, Landed)> {
        let (aim, draws) = (&self.aims[self.pair], &mut self.media_draws);
        let landed = |shot: &Shot| {
            let mut landed = Landed::default();
            tracer.follow(shot, aim, Some(&mut *draws), &mut landed);
            (shot.ring, landed)
        };
        joined(self.shots.iter().map(landed))
    }

    /// Takes up what the salvo left, in the order of its shots.
    pub fn land(&mut self, salvo: impl IntoIterator<Item = (usize, Landed)>) {
        let mut salvo = salvo.into_iter().peekable();
        let rings = std::mem::take(&mut self.rings);
        for (number, ring) in rings.iter().enumerate() {
            let mut hit = false;
            while let Some((_, landed)) = salvo.next_if(|(of, _)| *of == number) {
                hit |= landed.hit_target;
                self.surface.extend(landed.surface);
                self.media.extend(landed.media);
            }
            let stops = self.aims[self.pair].stops(ring.at, self.photons.autostop);
            if !hit && self.has_hit && stops {
                self.random = ring.random;
                return self.end_pair();
            }
            self.has_hit |= hit;
        }
    }

    /// The maps as trees, with their radii.
    pub fn finish(self) -> Arc<Photons> {
        let (surface, media) = match &self.photons.load {
            Some(file) => {
                (PhotonMap::from_sorted(file.surface.clone()), PhotonMap::from_sorted(file.media.clone()))
            }
            None => (PhotonMap::new(self.surface), PhotonMap::new(self.media)),
        };
        Arc::new(Photons::new(self.photons, surface, media))
    }
}

/// Many more photons, looked for half as far: what is left of the bias is a quarter of the area of a search.
fn refine(photons: &mut PhotonSettings) {
    photons.spacing /= FINER;
    photons.count = (f64::from(photons.count) * FINER * FINER) as u32;
    photons.gather_max = photons.gather_max.saturating_mul(FINER as u32);
    photons.gather_min = photons.gather_min.saturating_mul(FINER as u32);
    photons.surface_radius.0 *= 0.5;
    photons.media_radius.0 *= 0.5;
    photons.load = None;
}

/// How much closer photons lie for the truth.
const FINER: f64 = 4.0;

/// Shots of one ring as one.
fn joined(all: impl Iterator<Item = (usize, Landed)>) -> Vec<(usize, Landed)> {
    let mut out: Vec<(usize, Landed)> = Vec::new();
    for (ring, landed) in all {
        match out.last_mut() {
            Some((last, sum)) if *last == ring => {
                sum.surface.extend(landed.surface);
                sum.media.extend(landed.media);
                sum.hit_target |= landed.hit_target;
            }
            _ => out.push((ring, landed)),
        }
    }
    out
}

impl Photons {
    fn new(settings: PhotonSettings, surface: PhotonMap, media: PhotonMap) -> Self {
        let mut random = radius::Feedback::new();
        let mut radius = |map: &PhotonMap, (given, factor): (f64, f64), in_media: bool| {
            let most = settings.gather_max as usize;
            let radius = match () {
                () if given > 0.0 => given,
                () if map.is_empty() => 0.0,
                () => radius::automatic(map, most, in_media, &mut random),
            };
            radius * factor
        };
        let surface_radius = radius(&surface, settings.surface_radius, false);
        let media_radius = 2.0 * radius(&media, settings.media_radius, true);
        Self { settings, surface, media, surface_radius, media_radius }
    }

    /// Both maps as a file.
    pub fn to_file(&self) -> Vec<u8> {
        PhotonFile::written(self.surface.photons(), self.media.photons())
    }
}

#[cfg(test)]
mod tests;
