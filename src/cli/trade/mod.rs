//! `glint trade`: what each setting costs for a scene, and what error it leaves.

mod cache;
mod subject;
mod table;

use super::args::{SceneArgs, TradeArgs, TradeSetting};
use super::clock::{Wall, cpu_seconds};
use super::exit::{Exit, Failure};
use super::render::{pool, quoted};
use super::scene::Options;
use super::{interrupt, json, stack};
use crate::picture::Output;
use crate::render::adaptive::Clock;
use crate::trade::report;
use crate::trade::sweep::{Measurement, Plan, sweep};
use crate::trade::{Axis, Size, Stopwatch, Subject, grid};
use serde::Serialize;
use std::path::Path;
use subject::ScenePictures;

/// What `--json` prints.
#[derive(Serialize)]
struct Report<'a> {
    scene: String,
    budget_s: f64,
    wall_s: f64,
    threads: usize,
    #[serde(flatten)]
    measurement: &'a Measurement,
}

impl Stopwatch for Wall {
    fn cpu_seconds(&self) -> f64 {
        cpu_seconds()
    }
}

pub fn run(args: &TradeArgs) -> Result<Exit, Failure> {
    let wall = Wall::start();
    if args.scene_file == Path::new("-") {
        return Err(Failure::usage("the scene is read more than once: give a file, not `-`"));
    }
    interrupt::listen();
    stack::with_room(&args.scene_file, || measure(args, &wall))
}

fn measure(args: &TradeArgs, wall: &Wall) -> Result<Exit, Failure> {
    let size = Size { width: args.width, height: args.height };
    let pool = pool(args.threads.map(usize::from))?;
    let options = Options::new(&args.scene, size.width, size.height)?;
    let mut subject = ScenePictures::new(args, options, &pool, *wall)?;
    let wanted: Vec<Axis> = args.settings.iter().flat_map(|s| axes(*s)).collect();
    let (axes, sampling) = match wanted.is_empty() {
        true => (subject.axes(), true),
        false => (subject.axes().only(&wanted), wanted.contains(&Axis::Sampling)),
    };
    subject.seek_truth(axes.needs_truth());
    let plan = Plan { size, begin: 0.0, end: args.budget, knobs: grid(&axes, sampling) };
    let say = |text: &str| {
        if !args.quiet {
            eprintln!("{text}");
        }
    };
    let result = sweep(&subject, wall, &plan, &say);
    if interrupt::requested() {
        return Err(Failure::interrupted("interrupted; nothing was written"));
    }
    let measurement = result.map_err(|message| subject.failure(message))?;
    finish(args, &subject, &measurement, wall)
}

fn finish(
    args: &TradeArgs,
    subject: &ScenePictures,
    measurement: &Measurement,
    wall: &Wall,
) -> Result<Exit, Failure> {
    let scene = args.scene_file.display().to_string();
    if let Some(path) = &args.report {
        let page = report::page(&scene, measurement, &subject.encoding());
        Output::File(path.clone()).write(page.as_bytes())?;
    }
    let threads = subject.threads();
    let wall_s = wall.seconds();
    if args.json {
        json::print(&Report { scene, budget_s: args.budget, wall_s, threads, measurement })?;
    } else {
        json::print_text(&table::text(&scene, measurement))?;
    }
    Ok(Exit::Done)
}

fn axes(setting: TradeSetting) -> Vec<Axis> {
    let one = match setting {
        TradeSetting::Light => return Axis::LIGHT.to_vec(),
        TradeSetting::Aa => Axis::Sampling,
        TradeSetting::TraceLevel => Axis::TraceLevel,
        TradeSetting::AdcBailout => Axis::AdcBailout,
        TradeSetting::AreaSamples => Axis::AreaSamples,
        TradeSetting::RadiosityCount => Axis::RadiosityCount,
        TradeSetting::RadiosityErrorBound => Axis::RadiosityErrorBound,
        TradeSetting::RadiosityRecursion => Axis::RadiosityRecursion,
        TradeSetting::PretraceEnd => Axis::PretraceEnd,
        TradeSetting::PhotonSpacing => Axis::PhotonSpacing,
        TradeSetting::PhotonGather => Axis::PhotonGather,
        TradeSetting::MediaSamples => Axis::MediaSamples,
        TradeSetting::MediaIntervals => Axis::MediaIntervals,
    };
    vec![one]
}

/// The options that make `glint render` read the scene as it was read here.
fn reading_words(args: &TradeArgs) -> Vec<String> {
    let mut words = Vec::new();
    let SceneArgs { library, allow_read, allow_write, .. } = &args.scene;
    for (option, folders) in [("-L", library), ("--allow-read", allow_read), ("--allow-write", allow_write)] {
        for folder in folders {
            words.extend([option.to_owned(), quoted(&folder.display().to_string())]);
        }
    }
    for text in &args.scene.declare {
        words.extend(["-D".to_owned(), quoted(text)]);
    }
    if args.scene.clock != 0.0 {
        words.push(format!("--clock={}", args.scene.clock));
    }
    match args.scene.includes {
        super::args::Includes::Auto => {}
        super::args::Includes::Embedded => words.push("--includes=embedded".to_owned()),
        super::args::Includes::Installed => words.push("--includes=installed".to_owned()),
    }
    words
}
