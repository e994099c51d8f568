//! `glint render`: scenes to pictures, one after the other.

mod accuracy;
mod job;
mod monitor;
mod plan;
mod radiosity;
mod report;

pub use accuracy::{parse_error, parse_seconds, quoted};
pub use job::Task;
pub use plan::{Plan, accel, pool};
pub use radiosity::RadiosityFiles;

use super::streams::Stream;
use accuracy::Reached;

use super::args::RenderArgs;
use super::exit::{Exit, Failure};
use super::output::{self, Target};
use super::scene::Options;
use super::{interrupt, json};
use std::path::{Path, PathBuf};
use std::sync::Arc;

pub fn run(args: &RenderArgs) -> Result<Exit, Failure> {
    check(args)?;
    let plan = Plan::new(args)?;
    let mut options = Options::new(&args.scene, plan.width, plan.height)?;
    options.interp.output_alpha = args.alpha;
    let siblings: Arc<[PathBuf]> = args.scenes.clone().into();
    let task = |scene: &Path| {
        let target = Target::new(scene, args.output.as_deref())?;
        let siblings = siblings.clone();
        let scene = scene.to_owned();
        Ok(Task { scene, target, options: options.clone(), siblings, unfinished_apart: false, resume: false })
    };
    let tasks = args.scenes.iter().map(|s| task(s)).collect::<Result<Vec<_>, Failure>>()?;
    run_all(&plan, &tasks, args.json)
}

/// Does all tasks. A bad one does not stop the others; the exit code remembers it.
pub fn run_all(plan: &Plan, tasks: &[Task], as_json: bool) -> Result<Exit, Failure> {
    // A long batch must not find out at each of its ends that nothing can be written.
    tasks.iter().try_for_each(|task| task.target.check_folder())?;
    interrupt::listen();
    let mut exit = Exit::Done;
    for (i, task) in tasks.iter().enumerate() {
        let count = if tasks.len() > 1 { format!("[{}/{}] ", i + 1, tasks.len()) } else { String::new() };
        if task.is_done(plan) {
            plan.streams.say(Stream::Render, &format!("{count}{} is there already\n", task.target.output));
            continue;
        }
        match monitor::render(plan, task) {
            Ok(report) => {
                if as_json {
                    json::print(&report)?;
                }
                plan.streams.say(Stream::Statistic, &format!("{count}{}\n", report.line()));
                for note in report.adaptive.iter().flat_map(Reached::notes) {
                    plan.streams.say(Stream::Statistic, &format!("{note}\n"));
                }
            }
            Err(failure) if failure.exit == Exit::Interrupted => return Err(failure),
            Err(failure) => {
                if as_json {
                    json::print(&json::Failed::new(&task.scene, &failure))?;
                }
                plan.streams.complain(&failure);
                exit = exit.max(failure.exit);
            }
        }
    }
    Ok(exit)
}

/// Combinations that make no sense.
fn check(args: &RenderArgs) -> Result<(), Failure> {
    let output = args.output.as_deref();
    if args.scenes.len() > 1 && output.is_some_and(|o| !output::is_folder(o)) {
        return Err(Failure::usage(
            "several scenes need several pictures: give -o a folder, or leave it away",
        ));
    }
    if args.json && output == Some(Path::new("-")) {
        return Err(Failure::usage("--json and -o - both want standard output: write the picture to a file"));
    }
    if args.partial && output == Some(Path::new("-")) {
        return Err(Failure::usage("--partial needs a file that it can write again and again"));
    }
    Ok(())
}
