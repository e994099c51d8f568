//! `glint check`: parse and prepare, nothing else.

use super::args::CheckArgs;
use super::clock::{cpu_seconds, peak_rss_bytes};
use super::exit::{Exit, Failure};
use super::scene::{self, Options};
use super::streams::Streams;
use super::{interrupt, json, stack};
use crate::scene::Counts;
use crate::world::World;
use serde::Serialize;
use std::path::Path;

/// What `--json` prints for a scene.
#[derive(Serialize)]
struct Report {
    scene: String,
    /// Objects and lights as POV-Ray's statistics count them.
    finite_objects: usize,
    infinite_objects: usize,
    light_sources: usize,
    warnings: Vec<String>,
    unsupported: Vec<String>,
    /// Which included file was taken from where.
    includes: Vec<String>,
    parse_cpu_s: f64,
    prepare_cpu_s: f64,
    peak_rss_bytes: u64,
}

pub fn run(args: &CheckArgs) -> Result<Exit, Failure> {
    let options = Options::new(&args.scene, args.width, args.height)?;
    interrupt::end_at_once();
    let mut exit = Exit::Done;
    for path in &args.scenes {
        match stack::with_room(path, || check(path, &options, args.quiet)) {
            Ok(report) if args.json => json::print(&report)?,
            Ok(report) if !args.quiet || args.explain_includes => {
                json::print_text(&text(&report, args.explain_includes))?
            }
            Ok(_) => {}
            Err(failure) => {
                if args.json {
                    json::print(&json::Failed::new(path, &failure))?;
                }
                Streams::new(false).complain(&failure);
                exit = exit.max(failure.exit);
            }
        }
    }
    Ok(exit)
}

fn check(path: &Path, options: &Options, quiet: bool) -> Result<Report, Failure> {
    let start = cpu_seconds();
    let parsed = scene::parse(path, options, &Streams::new(quiet))?;
    let read = cpu_seconds();
    let counts = Counts::of(&parsed.scene);
    let _world = World::prepare(parsed.scene);
    Ok(Report {
        scene: path.display().to_string(),
        finite_objects: counts.finite_objects,
        infinite_objects: counts.infinite_objects,
        light_sources: counts.light_sources,
        warnings: parsed.warnings,
        unsupported: parsed.unsupported,
        includes: parsed.includes,
        parse_cpu_s: read - start,
        prepare_cpu_s: cpu_seconds() - read,
        peak_rss_bytes: peak_rss_bytes(),
    })
}

fn text(r: &Report, with_includes: bool) -> String {
    let mut text = format!(
        "{}: {} finite objects, {} infinite objects, {} light sources, {} warnings\n",
        r.scene,
        r.finite_objects,
        r.infinite_objects,
        r.light_sources,
        r.warnings.len()
    );
    if !r.unsupported.is_empty() {
        text.push_str(&format!("  not rendered yet: {}\n", r.unsupported.join(", ")));
    }
    if with_includes {
        r.includes.iter().for_each(|line| text.push_str(&format!("  {line}\n")));
    }
    text
}
