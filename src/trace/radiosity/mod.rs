//! Diffuse light between surfaces: gathered over the hemisphere at few places, kept in a cache and blended
//! in between.
//!
//! First the picture is traced coarsely, pass by pass ([`Pretrace`]), to fill the cache. Every tile of a pass is
//! a step, which sees what all steps before it gathered, but for the last few, and what it gathers itself. The
//! blocks of the picture see the finished cache and what they themselves add. So nothing depends on the order
//! in which threads take them.

mod cache;
mod directions;
pub mod file;
mod gather;
mod pretrace;
mod query;
mod reference;
mod table;

pub use cache::{Cache, Sample};
pub use pretrace::{Gathered, Pretrace, Progress, Tile};
pub(super) use query::Query;

use super::Settings;
use crate::scene::RadiositySettings;
use crate::world::World;
use directions::Directions;
use std::sync::Arc;

/// What the pretrace found, for the tracers of the picture; cheap to clone.
#[derive(Clone, Debug)]
pub struct Lighting {
    pub(super) cache: Arc<Cache>,
    directions: Arc<Directions>,
}

impl Lighting {
    /// Nothing gathered yet; `None` if the picture has no radiosity.
    pub(super) fn unknown(world: &World, settings: &Settings) -> Option<Self> {
        let radiosity = world.scene.globals.radiosity.as_ref().filter(|_| settings.quality >= 9)?;
        Some(Self { cache: Arc::default(), directions: Arc::new(Directions::new(radiosity.pool)) })
    }

    /// Files what is known already, for settings that reuse it as they say.
    fn with_known(mut self, samples: &[Sample], settings: &RadiositySettings) -> Self {
        let cache = Arc::make_mut(&mut self.cache);
        for sample in samples.iter().filter(|s| s.depth < settings.recursion_limit) {
            let reach = reach(settings, sample.depth, f64::from(sample.radius));
            cache.insert(Sample { reach, ..sample.clone() });
        }
        self
    }

    /// Samples of all depths.
    pub fn samples(&self) -> &[Sample] {
        self.cache.samples()
    }
}

/// How far around itself a sample is filed.
fn reach(settings: &RadiositySettings, depth: u32, radius: f64) -> f64 {
    let spread = if depth == 0 { 1.0 } else { 0.125 };
    radius * settings.error_bound * f64::from(1u32 << depth) * spread
}

/// A tracer's part in radiosity.
pub(super) struct Radiosity {
    settings: RadiositySettings,
    /// What all tracers see.
    lighting: Lighting,
    /// What this one has added for its block.
    own: Cache,
    /// The next direction, by depth.
    next: Vec<usize>,
    /// How far samples are blended, lowered in the pretrace.
    error_bound: f64,
    pretrace: bool,
    /// Whether nothing is kept or blended.
    plain: bool,
    /// Gathers that the present ray hangs on.
    pub depth: u32,
    /// How well founded the present ray's answers were.
    quality: f32,
    /// Queries of depth 0 and the weight that they found, for the pretrace.
    queries: u32,
    weight: f64,
}

impl Radiosity {
    pub fn new(world: &World, tracing: &Settings, lighting: Lighting, pretrace: bool) -> Self {
        let own = world.scene.globals.radiosity.clone().unwrap_or_default();
        let settings = tracing.overrides.radiosity(&own);
        let factor = if pretrace { settings.low_error_factor } else { 1.0 };
        Self {
            lighting,
            own: Cache::default(),
            next: vec![0; settings.recursion_limit as usize],
            error_bound: settings.error_bound * factor,
            settings,
            pretrace,
            plain: tracing.overrides.reference,
            depth: 0,
            quality: 1.0,
            queries: 0,
            weight: 0.0,
        }
    }

    /// Whether colours of camera rays are thrown away.
    pub fn is_dry(&self) -> bool {
        self.pretrace && self.depth == 0
    }

    /// Whether rays see media and fog.
    pub fn sees_media(&self) -> bool {
        self.depth == 0 || self.settings.media
    }

    /// Whether rays see light from below surfaces.
    pub fn sees_subsurface(&self) -> bool {
        self.depth == 0 || self.settings.subsurface
    }

    /// A ray from the camera starts.
    pub fn begin_ray(&mut self) {
        self.quality = 1.0;
    }

    /// Forgets what was added; a block's directions begin where its number says.
    pub fn begin_block(&mut self, serial: usize) {
        self.own.clear();
        let first = first_direction(serial, self.lighting.directions.len());
        self.next.fill(first);
    }
}

/// Blocks begin at different directions, the first one with the first.
fn first_direction(serial: usize, count: usize) -> usize {
    serial.wrapping_mul(STRIDE) % count.max(1)
}

/// A prime far from any gather's number of rays.
const STRIDE: usize = 7919;
