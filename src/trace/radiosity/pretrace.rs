//! Filling the cache: passes of growing density over the picture, each tile by tile.

use super::super::random::Random;
use super::super::tracer::Tracer;
use super::{Lighting, Radiosity, Sample, first_direction};
use crate::math::random::{uniform, uniform_table};
use crate::scene::RadiositySettings;
use crate::trace::{Photons, Settings};
use crate::world::World;
use std::sync::Arc;

/// A rectangle of pixels: columns x0..x1, rows y0..y1.
pub type Tile = [u32; 4];

/// The plan of all passes: their tiles one after the other, as steps.
#[derive(Debug)]
pub struct Pretrace<'w> {
    world: &'w World,
    settings: Settings,
    photons: Option<Arc<Photons>>,
    radiosity: RadiositySettings,
    lighting: Lighting,
    spacings: Vec<f64>,
    tiles: Vec<Progress>,
}

/// How far a tile has come.
#[derive(Clone, Debug)]
pub struct Progress {
    tile: Tile,
    /// Parts that are not finished, on a grid of `cells` parts each way.
    parts: Vec<(u32, u32)>,
    cells: (u32, u32),
    /// The next direction, by depth.
    next: Vec<usize>,
}

/// What one tile gave in one pass.
#[derive(Debug)]
pub struct Gathered {
    pub samples: Arc<[Sample]>,
    pub progress: Progress,
}

/// A part with fewer points is never finished.
const FEWEST_POINTS: u32 = 9;

/// Steps that may be taken side by side, at most: so many, or a share of a pass. Fewer keep closer to the
/// reference's one-thread order, and gather less twice; more keep more threads busy. The number does not depend
/// on threads.
const ABREAST: usize = 8;
const ABREAST_SHARE: usize = 32;

/// The first steps go one by one, after so many two abreast, and so on: what lies behind the first bounce is
/// gathered by the first tiles for all others.
const STEPS_PER_RANK: usize = 4;

/// Numbers drawn before they repeat.
const CYCLE: usize = 2047;

impl<'w> Pretrace<'w> {
    /// `None` if the picture has no radiosity.
    pub fn new(
        world: &'w World,
        settings: &Settings,
        photons: Option<Arc<Photons>>,
        tiles: impl Iterator<Item = Tile>,
    ) -> Option<Self> {
        let lighting = Lighting::unknown(world, settings).filter(|_| !settings.overrides.reference)?;
        let radiosity = settings.overrides.radiosity(world.scene.globals.radiosity.as_ref()?);
        let lighting = lighting.with_known(&settings.known_light, &radiosity);
        let pool = lighting.directions.len();
        let next = |serial: usize| vec![first_direction(serial, pool); radiosity.recursion_limit as usize];
        let progress = |(serial, tile): (usize, Tile)| Progress {
            tile,
            parts: vec![(0, 0)],
            cells: (1, 1),
            next: next(serial),
        };
        let tiles = tiles.enumerate().map(progress).collect();
        let spacings = spacings(settings.width.max(settings.height), &radiosity);
        Some(Self { world, settings: settings.clone(), photons, radiosity, lighting, spacings, tiles })
    }

    /// Tiles times passes.
    pub fn steps(&self) -> usize {
        self.spacings.len() * self.tiles.len()
    }

    /// How many steps a step must have seen: all but those just before it, so that a few can be taken at a
    /// time. The tile's own last step is always among them.
    pub fn seen_by(&self, step: usize) -> usize {
        let count = self.tiles.len();
        let most = (count / ABREAST_SHARE).max(ABREAST).min(count);
        (step + 1).saturating_sub(most.min(1 + step / STEPS_PER_RANK))
    }

    /// The step that took the same tile in the pass before.
    pub fn same_tile_before(&self, step: usize) -> Option<usize> {
        step.checked_sub(self.tiles.len())
    }

    /// A tracer for [`Pretrace::trace`] that knows of no step yet; one per thread.
    pub fn tracer(&self) -> Tracer<'w> {
        let mut tracer = Tracer::new(self.world, &self.settings);
        tracer.radiosity = Some(Radiosity::new(self.world, &self.settings, self.lighting.clone(), true));
        tracer.take_photons(self.photons.as_ref());
        tracer
    }

    /// One tile of one pass, which is at `progress` if this is not the first.
    pub fn trace(&self, tracer: &mut Tracer, step: usize, progress: Option<Progress>) -> Gathered {
        let (pass, serial) = (step / self.tiles.len(), step % self.tiles.len());
        let mut progress = progress.unwrap_or_else(|| self.tiles[serial].clone());
        tracer.begin_tile(&progress.next);
        let spacing = self.spacings[pass];
        let mut shake = Shake { index: (17 * (pass + 1) + 13 * serial) % CYCLE };
        tracer.random = Random::new(serial as u32, pass as u32, u32::MAX);
        let following = self.spacings.get(pass + 1).copied();
        let split = following.map_or((1, 1), |s| progress.split(s, self.radiosity.adaptive_count > 0));
        let mut left = Vec::new();
        for part in std::mem::take(&mut progress.parts) {
            if !self.trace_part(tracer, &progress, part, spacing, &mut shake) {
                left.extend(
                    (0..split.1).flat_map(|j| {
                        (0..split.0).map(move |i| (part.0 * split.0 + i, part.1 * split.1 + j))
                    }),
                );
            }
        }
        progress.parts = left;
        progress.cells = (progress.cells.0 * split.0, progress.cells.1 * split.1);
        let samples = tracer.take_samples(&mut progress.next);
        Gathered { samples, progress }
    }

    /// Whether the part is finished.
    fn trace_part(
        &self,
        tracer: &mut Tracer,
        progress: &Progress,
        part: (u32, u32),
        spacing: f64,
        shake: &mut Shake,
    ) -> bool {
        let (columns, rows) = progress.extent(part);
        let jitter = (0.5 * spacing).min(1.0);
        let mut points = 0;
        tracer.start_counting();
        for y in steps(progress.tile[1], rows, spacing) {
            for x in steps(progress.tile[0], columns, spacing) {
                let dy = shake.draw();
                let dx = shake.draw();
                let middle = 0.5 * (spacing - 1.0);
                tracer.pretrace_point(x + middle + jitter * dx, y + middle + jitter * dy);
                points += 1;
            }
        }
        let (queries, mean) = tracer.counted();
        let wanted = self.radiosity.adaptive_count;
        points >= FEWEST_POINTS && (queries == 0 || (wanted > 0 && mean >= f64::from(wanted)))
    }
}

impl Progress {
    /// Columns and rows of a part, from the tile's first on.
    fn extent(&self, part: (u32, u32)) -> ((f64, f64), (f64, f64)) {
        let [x0, y0, x1, y1] = self.tile;
        let side = |from: u32, to: u32, i: u32, n: u32| {
            let length = f64::from(to - from) / f64::from(n);
            let start = f64::from(from) + length * f64::from(i);
            (start, start + length)
        };
        (side(x0, x1, part.0, self.cells.0), side(y0, y1, part.1, self.cells.1))
    }

    /// Into how many each unfinished part falls before a pass of `spacing`.
    fn split(&self, spacing: f64, adaptive: bool) -> (u32, u32) {
        if !adaptive {
            return (1, 1);
        }
        let part = |length: u32, cells: u32| {
            let points = ((f64::from(length) + spacing - 1.0) / spacing).floor();
            ((points / f64::from(4 * cells)).floor() as u32).max(1)
        };
        let [x0, y0, x1, y1] = self.tile;
        (part(x1 - x0, self.cells.0), part(y1 - y0, self.cells.1))
    }
}

/// Distances of the points in each pass, in pixels.
fn spacings(size: u32, r: &RadiositySettings) -> Vec<f64> {
    let size = f64::from(size);
    let (start, end) = (size * r.pretrace_start, (size * r.pretrace_end).max(1.0));
    let last = ((start / end).log2() + (1.0 - 1e-10)).floor();
    if last < 0.0 {
        return Vec::new();
    }
    (0..=last as u32).map(|p| (start / f64::from(p).exp2()).max(end)).collect()
}

/// Multiples of `spacing` (counted from a tile's `first` pixel on) inside a part, by repeated addition: its
/// rounding decides about a point on the far edge, and so about all random shifts after it.
fn steps(first: u32, (from, to): (f64, f64), spacing: f64) -> impl Iterator<Item = f64> {
    let start = ((f64::from(first) - 0.5) / spacing).ceil() * spacing;
    std::iter::successors(Some(start), move |x| Some(x + spacing))
        .skip_while(move |&x| x < from)
        .take_while(move |&x| x < to)
}

/// Random shifts of the points, -1 to 1.
struct Shake {
    index: usize,
}

impl Shake {
    fn draw(&mut self) -> f64 {
        self.index = (self.index + 1) % CYCLE;
        2.0 * uniform(uniform_table(), self.index) - 1.0
    }
}

impl Tracer<'_> {
    /// Takes up what a step gathered; steps in their order.
    pub fn learn(&mut self, samples: &[Sample]) {
        if let Some(r) = &mut self.radiosity {
            let cache = Arc::make_mut(&mut r.lighting.cache);
            samples.iter().for_each(|s| cache.insert(s.clone()));
        }
    }

    /// What the tracer has learned.
    pub fn lighting(self) -> Option<Lighting> {
        self.radiosity.map(|r| r.lighting)
    }

    fn begin_tile(&mut self, next: &[usize]) {
        self.photons_of_late.clear();
        if let Some(r) = &mut self.radiosity {
            r.own.clear();
            r.next.copy_from_slice(next);
        }
    }

    /// What the tile gathered, and where its directions stand now.
    fn take_samples(&mut self, next: &mut [usize]) -> Arc<[Sample]> {
        let Some(r) = &mut self.radiosity else { return Arc::default() };
        next.copy_from_slice(&r.next);
        let samples = r.own.samples().into();
        r.own.clear();
        samples
    }

    fn start_counting(&mut self) {
        if let Some(r) = &mut self.radiosity {
            (r.queries, r.weight) = (0, 0.0);
        }
    }

    /// Queries since [`Tracer::start_counting`], and the mean weight that they found.
    fn counted(&self) -> (u32, f64) {
        let Some(r) = &self.radiosity else { return (0, 0.0) };
        (r.queries, r.weight / f64::from(r.queries.max(1)))
    }

    /// Traces a picture position, with pixel centres at whole numbers, for its samples alone.
    fn pretrace_point(&mut self, x: f64, y: f64) {
        let size = (f64::from(self.settings.width), f64::from(self.settings.height));
        let camera = &self.world.scene.camera;
        if let Some(ray) = camera.ray(x + 0.5, y + 0.5, size, &self.context) {
            self.camera_ray(&ray);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn passes_end_with_the_wanted_spacing() {
        let r = RadiositySettings::default();
        assert_eq!(spacings(100, &r), [8.0, 4.0]);
        let fine = RadiositySettings { pretrace_end: 0.01, ..r.clone() };
        assert_eq!(spacings(160, &fine), [12.8, 6.4, 3.2, 1.6]);
        let inverted = RadiositySettings { pretrace_start: 0.01, pretrace_end: 0.5, ..r };
        assert!(spacings(100, &inverted).is_empty());
    }

    #[test]
    fn points_of_neighbouring_tiles_do_not_overlap() {
        let left: Vec<f64> = steps(0, (0.0, 32.0), 5.0).collect();
        let right: Vec<f64> = steps(32, (32.0, 64.0), 5.0).collect();
        assert_eq!(left.len() + right.len(), 13);
        assert!(left.last() < right.first());
    }
}
