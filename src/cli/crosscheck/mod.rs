//! `glint crosscheck`: the same scenes by POV-Ray and by Glint, compared.
//!
//! Both programs run as processes of their own with a time limit each, from the scene's folder and on one
//! thread, so that a crash or a hang costs one scene and times can be compared.

mod cache;
mod glint;
mod html;
mod povray;
mod process;
mod request;
mod row;
mod scenes;

use super::args::CrosscheckArgs;
use super::exit::{Exit, Failure};
use super::in_order::{cores, in_order};
use super::{interrupt, json};
use crate::picture::Output;
use crate::picture::compare::{compare, difference_image, png_bytes};
use crate::picture::load::from_bytes;
pub use glint::Glint;
pub use povray::Program;
use povray::Reference;
pub use request::Request;
use row::{Row, Status, Summary};
pub use scenes::{Scene, search};
use serde::Serialize;
use std::time::Duration;

/// One program's answer for a scene.
pub struct Rendering {
    /// The picture file.
    pub png: Vec<u8>,
    parse_cpu_s: Option<f64>,
    prepare_cpu_s: Option<f64>,
    trace_cpu_s: Option<f64>,
    unsupported: Vec<String>,
}

/// Why there is no picture.
pub struct NoPicture {
    status: Status,
    pub message: String,
}

#[derive(Serialize)]
struct Report<'a> {
    scenes: &'a [Row],
    summary: &'a Summary,
}

pub fn run(args: &CrosscheckArgs) -> Result<Exit, Failure> {
    let request = Request::with_library(&args.picture, &args.library)?;
    let scenes = scenes::find(args)?;
    let work = Work {
        glint: Glint::new(&request, seconds(args.timeout, "--timeout")?, args.keep.clone())?,
        reference: Reference::new(args, &request)?,
        min_psnr: args.min_psnr,
        pictures: args.report.is_some(),
    };
    interrupt::listen();
    let jobs = args.jobs.map_or_else(cores, usize::from);
    let rows = in_order(&scenes, jobs, |scene| work.row(scene), |_, row| show(row, args));
    let summary = Summary::of(&rows);
    if let Some(path) = &args.report {
        Output::File(path.clone()).write(html::page(&rows, &summary, args.min_psnr).as_bytes())?;
    }
    if args.json {
        json::print(&Report { scenes: &rows, summary: &summary })?;
    } else {
        json::print_text(&summary.text())?;
    }
    if interrupt::requested() {
        return Err(Failure::interrupted(format!(
            "interrupted after {} of {} scenes",
            rows.len(),
            scenes.len()
        )));
    }
    match args.min_match {
        Some(min) if summary.matches() < min => {
            Err(Failure::failed(format!("{} scenes match, fewer than {min}", summary.matches())))
        }
        _ => Ok(Exit::Done),
    }
}

struct Work {
    glint: Glint,
    reference: Reference,
    min_psnr: f64,
    /// Whether rows keep pictures for a report.
    pictures: bool,
}

impl Work {
    fn row(&self, scene: &Scene) -> Row {
        let mut row = Row::new(scene.name.clone());
        let reference = match self.reference.picture(scene) {
            Ok(rendering) => rendering,
            Err(why) => return row.without(why),
        };
        row.povray_parse_cpu_s = reference.parse_cpu_s;
        row.povray_prepare_cpu_s = reference.prepare_cpu_s;
        row.povray_trace_cpu_s = reference.trace_cpu_s;
        let glint = match self.glint.picture(scene) {
            Ok(rendering) => rendering,
            Err(why) => {
                row.keep(self.pictures, Some(&reference.png), None, None);
                return row.without(why);
            }
        };
        row.glint_parse_cpu_s = glint.parse_cpu_s;
        row.glint_prepare_cpu_s = glint.prepare_cpu_s;
        row.glint_trace_cpu_s = glint.trace_cpu_s;
        row.unsupported = glint.unsupported;
        row.set_ratio();
        let difference = match self.measure(&mut row, &reference.png, &glint.png) {
            Ok(difference) => difference,
            Err(message) => return row.without(NoPicture { status: Status::Error, message }),
        };
        row.keep(self.pictures, Some(&reference.png), Some(&glint.png), Some(&difference));
        row
    }

    /// Compares; gives the difference as a picture file.
    fn measure(&self, row: &mut Row, reference: &[u8], glint: &[u8]) -> Result<Vec<u8>, String> {
        let (a, b) = (from_bytes(reference)?, from_bytes(glint)?);
        let difference = compare(&a, &b)?;
        row.psnr_db = difference.psnr_db;
        row.off_by_8_share = Some(difference.off_by_8_share);
        row.status = Status::of(&difference, self.min_psnr);
        if self.pictures { png_bytes(&difference_image(&a, &b)?) } else { Ok(Vec::new()) }
    }
}

/// A time limit as it was typed.
fn seconds(value: f64, option: &str) -> Result<Duration, Failure> {
    let positive = Some(value).filter(|&v| v > 0.0);
    let limit = positive.and_then(|v| Duration::try_from_secs_f64(v).ok());
    limit.ok_or_else(|| Failure::usage(format!("{option} {value}: expected a positive number of seconds")))
}

/// Shows a row: on stdout if that is what was asked for.
fn show(row: &Row, args: &CrosscheckArgs) {
    if args.json && !args.quiet {
        eprintln!("{}", row.line());
    } else if !args.json {
        // A reader that has gone away does not stop the check: the report is still to come.
        let _ = json::print_text(&format!("{}\n", row.line()));
    }
}
