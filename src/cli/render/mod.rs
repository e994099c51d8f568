//! `glint render`: scenes to pictures, one after the other.

mod job;
mod monitor;
mod plan;
mod report;

use plan::Plan;

use super::args::RenderArgs;
use super::exit::{Exit, Failure};
use super::output::Target;
use super::{interrupt, json};
use std::path::Path;

pub fn run(args: &RenderArgs) -> Result<Exit, Failure> {
    check(args)?;
    let plan = Plan::new(args)?;
    interrupt::listen();
    let mut exit = Exit::Done;
    for scene in &args.scenes {
        let target = Target::new(scene, args.output.as_deref());
        match target.and_then(|target| monitor::render(&plan, scene, target)) {
            Ok(report) => {
                if args.json {
                    json::print(&report)?;
                }
                if !args.quiet {
                    eprintln!("{}", report.line());
                }
            }
            Err(failure) if failure.exit == Exit::Interrupted => return Err(failure),
            Err(failure) => {
                if args.json {
                    json::print(&json::Failed::new(scene, &failure))?;
                }
                super::complain(&failure);
                exit = exit.max(failure.exit);
            }
        }
    }
    Ok(exit)
}

/// Combinations that make no sense.
fn check(args: &RenderArgs) -> Result<(), Failure> {
    let output = args.output.as_deref();
    Target::new(Path::new("scene.pov"), output)?;
    if args.scenes.len() > 1 && output.is_some_and(|o| !super::output::is_folder(o)) {
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
