//! The measuring itself, within a budget of wall time.
//!
//! | step | share of the budget |
//! |------|------|
//! | pilot: a small picture tells what a sample costs | little |
//! | size: as asked for, or as small as it takes for the whole grid to fit | - |
//! | reference, until its error is a quarter of the finest that is tried | at most 40 % |
//! | every way of the grid once, those left out that do not fit | the rest |
//! | again, up to three times, if there is time left: the shortest time counts | the rest |

use super::front::{front, knee};
use super::{Knobs, Reference, Sampling, Size, Stopwatch, Subject};
use crate::picture::compare::perceptual;
use crate::picture::light;
use crate::picture::load::Values;
use crate::picture::{Encoding, Picture};
use serde::Serialize;

/// What is to be measured.
#[derive(Clone, Debug)]
pub struct Plan {
    pub size: Size,
    /// The clock's time at which the measuring begins and ends.
    pub begin: f64,
    pub end: f64,
    pub knobs: Vec<Knobs>,
}

/// One way to render, measured.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    pub settings: Knobs,
    pub name: String,
    pub command: String,
    /// Shortest of `runs`.
    pub cpu_s: f64,
    pub wall_s: f64,
    pub runs: usize,
    pub rmse: f64,
    pub psnr_db: Option<f64>,
    /// Structural similarity with chroma, 1 for equal pictures.
    pub perceptual: Option<f64>,
    pub worst_tile_rmse: f64,
    pub on_front: bool,
    #[serde(skip)]
    pub picture: Picture,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ReferenceReport {
    pub samples: u64,
    pub rmse_estimate: f64,
}

/// Everything that was found out.
#[derive(Clone, Debug, Serialize)]
pub struct Measurement {
    /// Of the pictures that were compared.
    pub size: Size,
    /// Whether they are smaller than asked for.
    pub reduced: bool,
    pub reference: ReferenceReport,
    pub rows: Vec<Row>,
    /// The row from which on more time buys clearly less.
    pub knee: Option<usize>,
    /// Ways that did not fit into the budget.
    pub left_out: Vec<String>,
    #[serde(skip)]
    pub reference_picture: Picture,
}

/// A reference's error is this share of the finest that is tried.
const REFERENCE_SHARE: f64 = 0.25;
/// The share of the budget after which a reference is good enough.
const REFERENCE_TIME: f64 = 0.4;
/// The share of the budget that one run of every way is to take.
const ROWS_TIME: f64 = 0.45;
/// Nothing is begun that is expected to end later than this share of the budget,
const FULL: f64 = 1.0;
/// and what has not ended by this one is given up.
const OVERFULL: f64 = 1.1;
const RUNS: usize = 3;
/// Width of the pilot.
const PILOT: u32 = 96;
/// No picture is made narrower than this: it would say nothing about larger ones.
const NARROWEST: u32 = 80;

/// Measures. `say` is told what is being done.
pub fn sweep(
    subject: &dyn Subject,
    clock: &dyn Stopwatch,
    plan: &Plan,
    say: &dyn Fn(&str),
) -> Result<Measurement, String> {
    let mut sweep = Sweep { subject, clock, plan, say, pace: 0.0 };
    let size = sweep.pilot()?;
    let reference = sweep.reference(size)?;
    let (mut rows, left_out) = sweep.rows(size, &reference);
    if rows.is_empty() {
        return Err("the budget is too small to render the scene once: allow more".to_owned());
    }
    sweep.again(size, &mut rows);
    let points: Vec<(f64, f64)> = rows.iter().map(|r| (r.cpu_s, r.rmse)).collect();
    for (row, on_front) in rows.iter_mut().zip(front(&points)) {
        row.on_front = on_front;
    }
    Ok(Measurement {
        size,
        reduced: size != plan.size,
        reference: ReferenceReport { samples: reference.samples, rmse_estimate: reference.rmse },
        knee: knee(&points),
        rows,
        left_out,
        reference_picture: reference.picture,
    })
}

struct Sweep<'a> {
    subject: &'a dyn Subject,
    clock: &'a dyn Stopwatch,
    plan: &'a Plan,
    say: &'a dyn Fn(&str),
    /// Wall seconds of a sample, as it was last found.
    pace: f64,
}

impl Sweep<'_> {
    /// The clock's time when so much of the budget is spent.
    fn at(&self, share: f64) -> f64 {
        self.plan.begin + share * (self.plan.end - self.plan.begin)
    }

    fn budget(&self) -> f64 {
        self.plan.end - self.plan.begin
    }

    /// What a sample costs, and which size of picture fits the budget.
    fn pilot(&mut self) -> Result<Size, String> {
        let asked = self.plan.size;
        let small = scaled(asked, f64::from(PILOT) / f64::from(asked.width));
        self.subject.prepare(small)?;
        let begun = self.clock.seconds();
        let picture = self.subject.render(small, &Knobs::new(Sampling::Centre), self.at(OVERFULL));
        picture.ok_or("the budget is too small to render the scene once: allow more")?;
        self.pace = ((self.clock.seconds() - begun) / small.pixels()).max(1e-9);
        let samples: f64 = self.plan.knobs.iter().map(samples_per_pixel).sum();
        let needed = samples * self.pace * asked.pixels();
        Ok(scaled(asked, (ROWS_TIME * self.budget() / needed.max(1e-9)).sqrt()))
    }

    fn reference(&self, size: Size) -> Result<Reference, String> {
        let finest = |knobs: &Knobs| match knobs.sampling {
            Sampling::Adaptive { max_error } => max_error,
            _ => 0.01,
        };
        let finest = self.plan.knobs.iter().map(finest).fold(0.01, f64::min);
        (self.say)(&format!("the reference, {}x{}", size.width, size.height));
        self.subject.prepare(size)?;
        let reference = self.subject.reference(size, REFERENCE_SHARE * finest, self.at(REFERENCE_TIME));
        reference.ok_or_else(|| "the budget is too small for a reference: allow more".to_owned())
    }

    /// Every way once, as far as there is time; the names of the others.
    fn rows(&mut self, size: Size, reference: &Reference) -> (Vec<Row>, Vec<String>) {
        let truth = values(&reference.picture, &self.subject.encoding());
        let (mut rows, mut left_out) = (Vec::new(), Vec::new());
        for knobs in &self.plan.knobs {
            let expected = samples_per_pixel(knobs) * self.pace * size.pixels();
            let row = match self.clock.seconds() + expected <= self.at(FULL) {
                true => self.row(size, knobs, reference, &truth),
                false => None,
            };
            match row {
                Some(row) => {
                    (self.say)(&format!("{}: {:.3} CPU s, RMSE {:.5}", row.name, row.cpu_s, row.rmse));
                    rows.push(row);
                }
                None => left_out.push(knobs.name()),
            }
        }
        (rows, left_out)
    }

    fn row(&mut self, size: Size, knobs: &Knobs, reference: &Reference, truth: &Values) -> Option<Row> {
        let (picture, cpu_s, wall_s) = self.timed(size, knobs)?;
        self.pace = 0.5 * (self.pace + wall_s / (samples_per_pixel(knobs) * size.pixels()));
        let error = light::compare(&picture, &reference.picture, self.subject.light());
        Some(Row {
            settings: *knobs,
            name: knobs.name(),
            command: self.subject.command(size, knobs),
            cpu_s,
            wall_s,
            runs: 1,
            rmse: error.rmse,
            psnr_db: error.psnr_db,
            perceptual: perceptual(&values(&picture, &self.subject.encoding()), truth),
            worst_tile_rmse: error.worst_tile_rmse,
            on_front: false,
            picture,
        })
    }

    /// A picture with its CPU and wall seconds.
    fn timed(&self, size: Size, knobs: &Knobs) -> Option<(Picture, f64, f64)> {
        let (cpu, wall) = (self.clock.cpu_seconds(), self.clock.seconds());
        let picture = self.subject.render(size, knobs, self.at(OVERFULL))?;
        Some((picture, self.clock.cpu_seconds() - cpu, self.clock.seconds() - wall))
    }

    /// Uses what is left of the budget to measure times again.
    fn again(&self, size: Size, rows: &mut [Row]) {
        for _ in 1..RUNS {
            for row in rows.iter_mut() {
                if self.clock.seconds() + 1.2 * row.wall_s > self.at(FULL) {
                    continue;
                }
                let Some((_, cpu_s, wall_s)) = self.timed(size, &row.settings) else { return };
                row.cpu_s = row.cpu_s.min(cpu_s);
                row.wall_s = row.wall_s.min(wall_s);
                row.runs += 1;
            }
        }
    }
}

/// A size with the same proportions, not larger than asked for.
fn scaled(asked: Size, factor: f64) -> Size {
    let least = f64::from(NARROWEST.min(asked.width)) / f64::from(asked.width);
    let factor = factor.clamp(least, 1.0);
    let side = |s: u32| ((f64::from(s) * factor).round() as u32).max(1);
    Size { width: side(asked.width), height: side(asked.height) }
}

/// About how many samples a pixel gets: what ways to render cost before they have been tried.
fn samples_per_pixel(knobs: &Knobs) -> f64 {
    match knobs.sampling {
        Sampling::Centre => 1.0,
        Sampling::Fixed { method: crate::render::Method::Grid, threshold, depth } => {
            1.0 + f64::from(depth * depth) * busy(threshold)
        }
        Sampling::Fixed { depth, .. } => 1.0 + 0.7 * 4f64.powi(depth as i32 - 1) * 0.3,
        Sampling::Adaptive { max_error } => 1.0 + 0.02 / max_error,
    }
}

/// The share of pixels that a threshold finds something in.
fn busy(threshold: f32) -> f64 {
    if threshold >= 0.2 { 0.25 } else { 0.45 }
}

/// File values of a picture.
pub(super) fn values(picture: &Picture, encoding: &Encoding) -> Values {
    let encoding = Encoding { bits: 8, alpha: false, ..*encoding };
    let pixel = |p| encoding.pixel(p).map(f32::from);
    Values {
        width: picture.width,
        height: picture.height,
        pixels: picture.pixels.iter().map(|p| pixel(*p)).collect(),
    }
}
