//! `glint explain`: what a scene required, what was built for it, and what was left out.

mod left_out;
mod required;

use super::args::ExplainArgs;
use super::clock::{Lap, peak_rss_bytes};
use super::exit::{Exit, Failure};
use super::render::accel;
use super::scene::{self, Options};
use super::streams::Streams;
use super::{interrupt, json, stack};
use crate::world::World;
use left_out::LeftOut;
use required::Required;
use serde::Serialize;
use std::fmt::Write;
use std::sync::Mutex;

/// What `--json` prints.
#[derive(Serialize)]
struct Report {
    scene: String,
    required: Required,
    built: Built,
    left_out: Vec<LeftOut>,
    warnings: Vec<String>,
    unsupported: Vec<String>,
}

#[derive(Serialize)]
struct Built {
    /// Objects at the top with bounds, and without.
    finite_objects: usize,
    infinite_objects: usize,
    /// Nodes of the tree over the finite ones; 0 where there is none.
    accel: &'static str,
    tree_nodes: usize,
    tree_bytes: usize,
    /// Textures as they sit on objects.
    surfaces: usize,
    interiors: usize,
    /// What meshes, height fields and their like keep, trees of their own included.
    shape_bytes: usize,
    parse_cpu_s: f64,
    prepare_cpu_s: f64,
    peak_rss_bytes: u64,
}

/// The picture's size as the scene sees it.
const SIZE: (u32, u32) = (640, 480);

pub fn run(args: &ExplainArgs) -> Result<Exit, Failure> {
    let options = Options::new(&args.scene, SIZE.0, SIZE.1)?;
    interrupt::end_at_once();
    let report = stack::with_room(&args.scene_file, || explain(args, &options))?;
    if args.json {
        json::print(&report)?
    } else {
        json::print_text(&report.text())?
    }
    Ok(Exit::Done)
}

fn explain(args: &ExplainArgs, options: &Options) -> Result<Report, Failure> {
    let counted = Mutex::new(0.0);
    let mut lap = Lap::new(&counted);
    let parsed = scene::parse(&args.scene_file, options, &Streams::new(true))?;
    let parse_cpu_s = lap.next();
    let world = World::prepare_with(parsed.scene, accel(args.accel));
    let prepare_cpu_s = lap.next();
    let stats = world.stats();
    let required = Required::of(&world, &stats);
    Ok(Report {
        scene: args.scene_file.display().to_string(),
        left_out: left_out::all(&world, &stats, &required),
        required,
        built: Built {
            finite_objects: stats.finite_objects,
            infinite_objects: stats.infinite_objects,
            accel: stats.accel,
            tree_nodes: stats.tree_nodes,
            tree_bytes: stats.tree_bytes,
            surfaces: stats.surfaces,
            interiors: stats.interiors,
            shape_bytes: stats.shape_bytes,
            parse_cpu_s,
            prepare_cpu_s,
            peak_rss_bytes: peak_rss_bytes(),
        },
        warnings: parsed.warnings,
        unsupported: parsed.unsupported,
    })
}

impl Report {
    fn text(&self) -> String {
        let mut text = format!("{}\n\nrequired\n", self.scene);
        self.required.write(&mut text);
        let b = &self.built;
        let lines = [
            ("objects", format!("{} finite, {} infinite, at the top", b.finite_objects, b.infinite_objects)),
            ("kept in", format!("{}: {} nodes, {}", b.accel, b.tree_nodes, bytes(b.tree_bytes as u64))),
            ("surfaces", b.surfaces.to_string()),
            ("interiors", b.interiors.to_string()),
            ("shapes keep", bytes(b.shape_bytes as u64)),
            ("CPU", format!("parse {:.3} s, prepare {:.3} s", b.parse_cpu_s, b.prepare_cpu_s)),
            ("memory", bytes(b.peak_rss_bytes)),
        ];
        text.push_str("\nbuilt\n");
        for (what, value) in lines {
            let _ = writeln!(text, "  {what:<18} {value}");
        }
        text.push_str("\nleft out\n");
        for LeftOut { what, why } in &self.left_out {
            let _ = writeln!(text, "  {what:<18} {why}");
        }
        for (title, list) in [("not rendered yet", &self.unsupported), ("warnings", &self.warnings)] {
            if !list.is_empty() {
                let _ = writeln!(text, "\n{title}\n  {}", list.join("\n  "));
            }
        }
        text
    }
}

/// A size for people.
fn bytes(n: u64) -> String {
    match n {
        0..1_000 => format!("{n} bytes"),
        1_000..1_000_000 => format!("{:.1} kB", n as f64 / 1e3),
        _ => format!("{:.1} MB", n as f64 / 1e6),
    }
}
