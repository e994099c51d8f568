//! The scene as something that is rendered again and again.

use super::cache::Cache;
use super::reading_words;
use crate::cli::args::TradeArgs;
use crate::cli::clock::Wall;
use crate::cli::exit::Failure;
use crate::cli::interrupt;
use crate::cli::render::quoted;
use crate::cli::scene::{self, Options};
use crate::cli::streams::Streams;
use crate::color::Gamma;
use crate::picture::light::Light;
use crate::picture::{Encoding, Picture};
use crate::render::adaptive::{self, Adaptive, Clock, Ended, Outcome};
use crate::render::{Antialias, Observer, Region, Settings, indirect, render};
use crate::trace::{self, Tracer};
use crate::trade::{Axes, Knobs, RadiosityAxes, Reference, Sampling, Size, Subject};
use crate::world::World;
use std::cell::RefCell;
use std::sync::{Arc, Mutex};

/// References share no random numbers with what is held against them.
const REFERENCE_SEED: u32 = 0x5EED;

pub struct ScenePictures<'a> {
    args: &'a TradeArgs,
    options: Options,
    pool: &'a rayon::ThreadPool,
    wall: Wall,
    cache: Option<Cache>,
    light: Light,
    gamma: Gamma,
    axes: Axes,
    /// Whether the reference's light is found by plain Monte Carlo.
    truth: bool,
    /// The scene as it was read for a size of picture.
    ready: RefCell<(Size, Arc<World>)>,
    failure: RefCell<Option<Failure>>,
}

/// Ends a render at a time, or when the user wants to stop.
struct Until<'a> {
    clock: &'a Wall,
    end: f64,
}

impl Observer for Until<'_> {
    fn cancelled(&self) -> bool {
        self.clock.seconds() > self.end || interrupt::requested()
    }
}

impl<'a> ScenePictures<'a> {
    pub fn new(
        args: &'a TradeArgs,
        mut options: Options,
        pool: &'a rayon::ThreadPool,
        wall: Wall,
    ) -> Result<Self, Failure> {
        options.fingerprint = args.cache.is_some();
        let parsed = scene::parse(&args.scene_file, &options, &Streams::new(args.quiet))?;
        let cache = args.cache.clone().map(|folder| Cache::new(folder, parsed.fingerprint));
        let world = World::prepare(parsed.scene);
        let gamma = world.scene.globals.gamma;
        let size = Size { width: args.width, height: args.height };
        Ok(Self {
            args,
            options,
            pool,
            wall,
            cache,
            light: Light::new(gamma),
            gamma,
            axes: axes(&world),
            truth: false,
            ready: RefCell::new((size, Arc::new(world))),
            failure: RefCell::new(None),
        })
    }

    /// What there is to be varied.
    pub fn axes(&self) -> Axes {
        self.axes.clone()
    }

    /// Holds pictures against light found by plain Monte Carlo, or else against the scene's own.
    pub fn seek_truth(&mut self, truth: bool) {
        self.truth = truth;
        if let Some(cache) = self.cache.as_mut().filter(|_| truth) {
            cache.tell_apart();
        }
    }

    pub fn threads(&self) -> usize {
        self.pool.current_num_threads()
    }

    /// The whole story behind a message.
    pub fn failure(&self, message: String) -> Failure {
        self.failure.take().unwrap_or_else(|| Failure::failed(message))
    }

    fn world(&self) -> Arc<World> {
        self.ready.borrow().1.clone()
    }

    fn settings(&self, size: Size, antialias: Option<Antialias>) -> Settings {
        Settings { antialias, ..Settings::new(size.width, size.height) }
    }

    fn tracing(&self, size: Size, overrides: trace::Overrides) -> trace::Settings {
        trace::Settings { width: size.width, height: size.height, overrides, ..trace::Settings::default() }
    }

    /// For pictures whose noise is sampled away.
    fn sparse(&self, size: Size, overrides: trace::Overrides) -> trace::Settings {
        trace::Settings { sparse_lamps: true, ..self.tracing(size, overrides) }
    }

    fn adaptive(
        &self,
        tracing: &trace::Settings,
        sampling: &Adaptive,
        until: &Until,
    ) -> (Picture, Outcome<()>) {
        let world = self.world();
        let size = Size { width: tracing.width, height: tracing.height };
        let (light, _) = indirect(&world, tracing, &self.settings(size, None), self.pool, until);
        let canvas = Mutex::new(Picture::new(size.width, size.height));
        let tracer = || Tracer::lit(&world, tracing, &light);
        let outcome = adaptive::render(sampling, self.pool, &canvas, until, &self.wall, tracer);
        let Outcome { ended, samples, rounds, rmse, .. } = outcome;
        (taken(canvas), Outcome { samplers: Vec::new(), ended, samples, rounds, rmse })
    }

    fn sampling(&self, size: Size) -> Adaptive {
        Adaptive::new(Region::whole(size.width, size.height), self.light.clone())
    }
}

fn taken(canvas: Mutex<Picture>) -> Picture {
    canvas.into_inner().unwrap_or_else(|poisoned| poisoned.into_inner())
}

impl Subject for ScenePictures<'_> {
    fn prepare(&self, size: Size) -> Result<(), String> {
        if self.ready.borrow().0 == size {
            return Ok(());
        }
        // A scene may ask for the picture's size.
        let mut options = self.options.clone();
        (options.interp.image_width, options.interp.image_height) = (size.width, size.height);
        match scene::parse(&self.args.scene_file, &options, &Streams::new(true)) {
            Ok(parsed) => {
                *self.ready.borrow_mut() = (size, Arc::new(World::prepare(parsed.scene)));
                Ok(())
            }
            Err(failure) => {
                let message = failure.message.clone();
                *self.failure.borrow_mut() = Some(failure);
                Err(message)
            }
        }
    }

    fn render(&self, size: Size, knobs: &Knobs, until: f64) -> Option<Picture> {
        let tracing = self.tracing(size, knobs.overrides);
        let until = Until { clock: &self.wall, end: until };
        let antialias = match knobs.sampling {
            Sampling::Adaptive { max_error } => {
                let sampling = Adaptive { target: Some(max_error), sparse: true, ..self.sampling(size) };
                let tracing = self.sparse(size, knobs.overrides);
                let (picture, outcome) = self.adaptive(&tracing, &sampling, &until);
                return (outcome.ended != Ended::Cancelled).then_some(picture);
            }
            Sampling::Centre => None,
            Sampling::Fixed { method, threshold, depth } => {
                Some(Antialias { threshold, depth, ..Antialias::new(method, self.gamma) })
            }
        };
        let world = self.world();
        let settings = self.settings(size, antialias);
        let (light, _) = indirect(&world, &tracing, &settings, self.pool, &until);
        let canvas = Mutex::new(Picture::new(size.width, size.height));
        render(&settings, self.pool, &canvas, &until, || Tracer::lit(&world, &tracing, &light));
        (!until.cancelled()).then(|| taken(canvas))
    }

    fn reference(&self, size: Size, target: f64, until: f64) -> Option<Reference> {
        let kept = self.cache.as_ref().and_then(|c| c.load(size));
        if let Some(kept) = kept.filter(|k| k.rmse <= 1.01 * target) {
            return Some(kept);
        }
        let overrides = trace::Overrides { reference: self.truth, ..trace::Overrides::default() };
        let tracing = self.sparse(size, overrides);
        // Several samples everywhere, so that little is missed that one sample a pixel would not meet.
        let limits = Adaptive {
            target: Some(target),
            deadline: Some(until),
            base: 4,
            seed: REFERENCE_SEED,
            ..self.sampling(size)
        };
        let end = Until { clock: &self.wall, end: f64::INFINITY };
        let (picture, outcome) = self.adaptive(&tracing, &limits, &end);
        let reference = Reference { picture, samples: outcome.samples, rmse: outcome.rmse? };
        if let Some(Err(message)) = self.cache.as_ref().map(|c| c.store(&reference)) {
            eprintln!("warning: {message}");
        }
        Some(reference)
    }

    fn light(&self) -> &Light {
        &self.light
    }

    fn encoding(&self) -> Encoding {
        Encoding::new(self.gamma)
    }

    fn command(&self, size: Size, knobs: &Knobs) -> String {
        let scene = quoted(&self.args.scene_file.display().to_string());
        let mut words = vec!["glint".to_owned(), "render".to_owned(), scene];
        words.extend([format!("-W {}", size.width), format!("-H {}", size.height)]);
        words.extend(reading_words(self.args));
        words.extend(knobs.words());
        words.join(" ")
    }
}

/// What the scene has that can be had for less.
fn axes(world: &World) -> Axes {
    let globals = &world.scene.globals;
    let all = world.ingredients();
    let goes_on = all.reflecting_layers > 0 || all.transparent_layers > 0 && world.interior_counts().0 > 0;
    let lights = world.lights.iter().chain(&world.group_lights).filter_map(|l| l.light.area.as_ref());
    let lamps = lights.map(|a| a.size1 * a.size2).max().filter(|&n| n > 1);
    let inside = world.interiors().flat_map(|(_, i)| &i.media);
    let media: Vec<_> = inside.chain(world.scene.media.iter().map(|m| &m.value)).collect();
    let photons = globals.photons.as_ref().filter(|p| p.gather_max > 0);
    Axes {
        trace_level: goes_on.then_some(globals.max_trace_level),
        adc_bailout: goes_on.then_some(globals.adc_bailout),
        lamps,
        radiosity: globals.radiosity.as_ref().map(|r| RadiosityAxes {
            count: Some(r.count),
            error_bound: Some(r.error_bound),
            recursion: Some(r.recursion_limit),
            pretrace_end: Some(r.pretrace_end),
        }),
        photon_spacing: photons.is_some_and(|p| p.load.is_none()),
        photon_gather: photons.map(|p| p.gather_max),
        media_samples: media.iter().map(|m| m.samples.0.max(m.samples.1)).max(),
        media_intervals: media.iter().map(|m| m.intervals.max(1)).max(),
    }
}
