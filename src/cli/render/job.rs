//! One scene from text to file, with the time that each part takes.

use super::accuracy::{Accuracy, Reached};
use super::plan::Plan;
use super::report::RenderReport;
use crate::cli::clock::{Lap, Wall, cpu_seconds, peak_rss_bytes};
use crate::cli::exit::Failure;
use crate::cli::output::Target;
use crate::cli::progress::Canvas;
use crate::cli::scene;
use crate::picture::light::Light;
use crate::picture::{Encoding, Output, Picture, PictureError, load};
use crate::render::adaptive::{self, Clock};
use crate::render::{indirect, render};
use crate::trace::{Counters, Indirect, Tracer};
use crate::world::World;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, OnceLock};
use std::time::Instant;

/// What others may look at while the picture is traced.
pub struct Live {
    pub canvas: Canvas,
    encoding: Encoding,
    target: Target,
    /// Where the picture goes until it is finished.
    unfinished: Target,
    /// What was said when the picture was left unfinished.
    left: OnceLock<String>,
}

impl Live {
    /// Writes the picture as it is now.
    pub fn write(&self) -> Result<(), PictureError> {
        self.unfinished.write(&self.canvas.snapshot(), &self.encoding)
    }

    /// Writes the unfinished picture and says so. Whoever asks while it is written waits, and no second
    /// one is written.
    pub fn leave(&self) -> &str {
        self.left.get_or_init(|| self.write_and_say())
    }

    /// Nothing is traced any more, so the picture need not be copied.
    fn write_and_say(&self) -> String {
        let percent = self.canvas.percent();
        let output = &self.unfinished.output;
        let written = output.path().map(|_| self.unfinished.write(&self.canvas.lock(), &self.encoding));
        match written {
            None => format!("interrupted at {percent} %; nothing was written"),
            Some(Ok(())) => format!("interrupted; {output} holds the {percent} % that were traced"),
            Some(Err(error)) => {
                format!("interrupted at {percent} %; the picture could not be written: {error}")
            }
        }
    }
}

/// One scene of a batch, or one frame.
#[derive(Clone, Debug)]
pub struct Task {
    pub scene: PathBuf,
    pub target: Target,
    pub options: scene::Options,
    /// All scenes of the batch.
    pub siblings: Arc<[PathBuf]>,
    /// The unfinished picture has a name of its own, so that a picture under the frame's name is whole.
    pub unfinished_apart: bool,
    /// A finished picture is left as it is.
    pub resume: bool,
}

impl Task {
    /// Whether the picture is there and has the right size.
    pub fn is_done(&self, plan: &Plan) -> bool {
        let size = self.target.output.path().and_then(load::size);
        self.resume && size == Some((plan.width, plan.height))
    }

    fn unfinished(&self) -> Target {
        match &self.target.output {
            Output::File(path) if self.unfinished_apart => {
                let path = path.with_extension(format!("unfinished.{}", self.target.format.extension()));
                Target { output: Output::File(path), ..self.target }
            }
            _ => self.target.clone(),
        }
    }

    /// The command line that does this task alone: other scenes' names are left out.
    fn command(&self, words: &[String]) -> Vec<String> {
        let others = |w: &&String| {
            let path = PathBuf::from(w);
            path == self.scene || !self.siblings.contains(&path)
        };
        words.iter().filter(others).cloned().collect()
    }
}

/// A task being done.
pub struct Job<'a> {
    plan: &'a Plan,
    task: &'a Task,
    live: Mutex<Option<Arc<Live>>>,
}

impl<'a> Job<'a> {
    pub fn new(plan: &'a Plan, task: &'a Task) -> Self {
        Self { plan, task, live: Mutex::new(None) }
    }

    /// The picture, once tracing has begun.
    pub fn live(&self) -> Option<Arc<Live>> {
        self.live.lock().unwrap_or_else(|poisoned| poisoned.into_inner()).clone()
    }

    /// The first scene's time begins with the process.
    fn wall(&self) -> Wall {
        let counted = *self.plan.counted.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        if counted == 0.0 { Wall::of_process() } else { Wall::start() }
    }

    pub fn run(&self) -> Result<RenderReport, Failure> {
        let wall = self.wall();
        let mut lap = Lap::new(&self.plan.counted);
        let parsed = scene::parse(&self.task.scene, &self.task.options, &self.plan.streams)?;
        let parse_cpu_s = lap.next();
        let world = World::prepare_with(parsed.scene, self.plan.accel);
        let prepare_cpu_s = lap.next();
        let traced = Instant::now();
        let live = self.start(&world);
        let (counters, adaptive) = match self.plan.accuracy {
            None => (self.trace(&world, &live)?, None),
            Some(accuracy) => self.trace_adaptively(&world, &live, &accuracy, &wall)?,
        };
        let (trace_cpu_s, trace_wall_s) = (lap.next(), traced.elapsed().as_secs_f64());
        if live.canvas.was_cancelled() {
            return Err(Failure::interrupted(live.leave()));
        }
        live.target.write(&live.canvas.lock(), &live.encoding)?;
        if let Some(leftover) = live.unfinished.output.path().filter(|_| live.unfinished != live.target) {
            // Mostly there is none.
            let _ = std::fs::remove_file(leftover);
        }
        let write_cpu_s = lap.next();
        Ok(RenderReport {
            scene: self.task.scene.display().to_string(),
            output: self.task.target.output.to_string(),
            width: self.plan.width,
            height: self.plan.height,
            threads: self.plan.pool.current_num_threads(),
            parse_cpu_s,
            prepare_cpu_s,
            trace_cpu_s,
            write_cpu_s,
            process_cpu_s: lap.total(),
            wall_s: wall.seconds(),
            trace_wall_s,
            camera_rays: counters.camera_rays,
            shadow_rays: counters.shadow_rays,
            reflected_rays: counters.reflected_rays,
            refracted_rays: counters.refracted_rays,
            not_numbers: counters.not_numbers,
            gather_rays: counters.gather_rays,
            photons: counters.photons,
            peak_rss_bytes: peak_rss_bytes(),
            adaptive,
            warnings: parsed.warnings,
            unsupported: parsed.unsupported,
        })
    }

    /// Opens the picture to others.
    fn start(&self, world: &World) -> Arc<Live> {
        let mut picture = Picture::new(self.plan.width, self.plan.height);
        picture.pixels.fill(self.plan.untraced);
        let live = Arc::new(Live {
            canvas: Canvas::new(picture, self.plan.region.pixels()),
            encoding: self.plan.encoding(world.scene.globals.gamma),
            target: self.task.target.clone(),
            unfinished: self.task.unfinished(),
            left: OnceLock::new(),
        });
        *self.live.lock().unwrap_or_else(|poisoned| poisoned.into_inner()) = Some(live.clone());
        live
    }

    fn trace(&self, world: &World, live: &Live) -> Result<Counters, Failure> {
        let settings = self.plan.trace_settings()?;
        let rendering = self.plan.settings(world.scene.globals.gamma);
        let canvas = &live.canvas;
        let pool = &self.plan.pool;
        let (light, counters) = indirect(world, &settings, &rendering, pool, canvas);
        self.save_light(world, &light)?;
        let sampler = || Tracer::lit(world, &settings, &light);
        let tracers = render(&rendering, pool, &canvas.picture, canvas, sampler);
        Ok(total(counters, &tracers))
    }

    fn trace_adaptively(
        &self,
        world: &World,
        live: &Live,
        accuracy: &Accuracy,
        wall: &Wall,
    ) -> Result<(Counters, Option<Reached>), Failure> {
        let settings = self.plan.trace_settings()?;
        let rendering = self.plan.settings(world.scene.globals.gamma);
        // A processor that others use as well will be as slow at the end as it has been so far.
        let busy = (wall.seconds() / cpu_seconds().max(1e-3)).clamp(1.0, BUSIEST);
        let late = accuracy.time_limit.map(|limit| limit - busy * writing_seconds(self.plan));
        let sampling = accuracy.settings(self.plan.region, Light::new(world.scene.globals.gamma), late);
        let (pool, canvas) = (&self.plan.pool, &live.canvas);
        let (light, counters) = indirect(world, &settings, &rendering, pool, canvas);
        self.save_light(world, &light)?;
        let tracer = || Tracer::lit(world, &settings, &light);
        let outcome = adaptive::render(&sampling, pool, &canvas.picture, canvas, wall, tracer);
        let words = self.task.command(&self.plan.command);
        let reached = Reached::new(&outcome, self.plan.region, &words);
        Ok((total(counters, &outcome.samplers), Some(reached)))
    }

    /// Writes what was found before the picture began to the files that are to keep it.
    fn save_light(&self, world: &World, light: &Indirect) -> Result<(), Failure> {
        self.save_photons(world, light)?;
        self.plan.radiosity.write(light.radiosity.as_ref().map_or(&[], |lighting| lighting.samples()))
    }

    /// Writes the photon maps where the scene wants them kept, if they are those that it asks for.
    fn save_photons(&self, world: &World, light: &Indirect) -> Result<(), Failure> {
        let path = world.scene.globals.photons.as_ref().and_then(|p| p.save_file.as_ref());
        let path = path.filter(|_| !self.plan.overrides.reference);
        let (Some(path), Some(photons)) = (path, &light.photons) else { return Ok(()) };
        std::fs::write(path, photons.to_file())
            .map_err(|e| Failure::unavailable(format!("cannot write {}: {e}", path.display())))
    }
}

/// Times are not stretched by more than this for a busy processor.
const BUSIEST: f64 = 8.0;

/// About how long it takes to encode and write a picture.
fn writing_seconds(plan: &Plan) -> f64 {
    /// Of a compressed PNG file, measured with a margin.
    const PER_PIXEL: f64 = 5e-8;
    const AT_LEAST: f64 = 0.005;
    let channels = f64::from(plan.bits) / 8.0;
    AT_LEAST + PER_PIXEL * channels * f64::from(plan.width) * f64::from(plan.height)
}

fn total(mut total: Counters, tracers: &[Tracer]) -> Counters {
    for tracer in tracers {
        total += tracer.counters();
    }
    if let Some(first) = tracers.iter().find_map(Tracer::not_number) {
        let (n, kind, p) = (total.not_numbers, first.kind, first.point);
        eprintln!(
            "{n} colours are no numbers and were drawn black; the first is on a {kind} at <{}, {}, {}>",
            p.x, p.y, p.z
        );
    }
    total
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::output::Format;
    use crate::color::Gamma;

    /// The render and its monitor may both leave it: a large picture takes a while.
    #[test]
    fn an_unfinished_picture_is_written_once() {
        let path = std::env::temp_dir().join(format!("glint-left-{}.png", std::process::id()));
        let target = Target { output: Output::File(path.clone()), format: Format::Png };
        let live = Live {
            canvas: Canvas::new(Picture::new(4, 3), 12),
            encoding: Encoding::new(Gamma::Srgb),
            target: target.clone(),
            unfinished: target,
            left: OnceLock::new(),
        };
        let said = live.leave().to_owned();
        assert!(said.contains("holds the 0 % that were traced"), "{said}");
        std::fs::remove_file(&path).unwrap();
        assert_eq!(live.leave(), said);
        assert!(!path.exists());
    }
}
