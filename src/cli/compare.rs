//! `glint compare`.

use super::args::CompareArgs;
use super::exit::{Exit, Failure};
use super::json;
use super::output::Format;
use crate::picture::compare::{self, Difference};
use crate::picture::light::{self, LightError};
use crate::picture::{Output, load};
use serde::Serialize;

/// What `--json` prints.
#[derive(Serialize)]
struct Report {
    #[serde(flatten)]
    difference: Difference,
    /// Structural similarity with chroma, 1 for equal pictures; null for tiny ones.
    perceptual: Option<f64>,
    /// In linear light clipped to 0..1.
    light: LightError,
    width: u32,
    height: u32,
}

pub fn run(args: &CompareArgs) -> Result<Exit, Failure> {
    if let Some(path) = &args.diff {
        Format::png_only(path)?;
    }
    let (a, b) = (load::load(&args.a)?, load::load(&args.b)?);
    let difference = compare::compare(&a, &b).map_err(Failure::failed)?;
    let (perceptual, light) = (compare::perceptual(&a, &b), light::compare_values(&a, &b));
    let report = Report { difference, perceptual, light, width: a.width, height: a.height };
    if let Some(path) = &args.diff {
        let image = compare::difference_image(&a, &b).map_err(Failure::failed)?;
        Output::File(path.clone()).write(&compare::png_bytes(&image).map_err(Failure::failed)?)?;
    }
    if args.json {
        json::print(&report)?
    } else {
        json::print_text(&text(&report))?
    }
    match args.min_psnr {
        Some(min) if !difference.reaches(min) => {
            Err(Failure::failed(format!("{} dB is below {min} dB", decibels(difference.psnr_db))))
        }
        _ => Ok(Exit::Done),
    }
}

/// A PSNR for people.
pub fn decibels(psnr: Option<f64>) -> String {
    psnr.map_or("equal".into(), |db| format!("{db:.2}"))
}

fn text(report: &Report) -> String {
    let d = &report.difference;
    let in_words =
        |db: Option<f64>| db.map_or("infinite (the pictures are equal)".into(), |db| format!("{db:.2} dB"));
    let (psnr, light) = (in_words(d.psnr_db), in_words(report.light.psnr_db));
    let perceptual = report.perceptual.map_or("-".into(), |p| format!("{p:.4}"));
    format!(
        "PSNR                {psnr}\n\
         RMSE                {:.4} of 255\n\
         largest difference  {} of 255\n\
         off by more than 8  {:.3} % of pixels\n\
         perceptual          {perceptual} (structure and chroma, 1 = equal)\n\
         PSNR in light       {light} (RMSE {:.5}, worst tile {:.5})\n",
        d.rmse,
        (d.max_abs * 1000.0).round() / 1000.0,
        d.off_by_8_share * 100.0,
        report.light.rmse,
        report.light.worst_tile_rmse,
    )
}
