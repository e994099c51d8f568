//! Settings of adaptive sampling as they are typed, and what it came to.

use crate::cli::args::{AaMethod, AccuracyArgs, PictureArgs};
use crate::cli::exit::Failure;
use crate::picture::light::{Light, decibels, rmse_from_decibels};
use crate::render::Region;
use crate::render::adaptive::{Adaptive, Ended, Outcome};
use serde::Serialize;

/// How good a picture is to be, and what it may cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accuracy {
    /// RMSE in light.
    pub max_error: Option<f64>,
    /// Seconds from the start to the finished file.
    pub time_limit: Option<f64>,
    pub max_samples: Option<u64>,
    /// Samples that are enough whatever the error, as a mean of all pixels.
    pub most_per_pixel: Option<f64>,
    /// Of every pixel.
    pub min_samples: u32,
    /// Whether pixels may go without samples: where nothing but the error is asked for.
    pub sparse: bool,
    pub seed: u32,
}

impl Accuracy {
    /// Where only time or samples are limited, a picture that is so good is not made better: no change would
    /// show in 8 bits.
    const FINEST: f64 = 2e-4;

    /// What was asked for, if sampling is to be adaptive at all.
    pub fn of(picture: &PictureArgs, args: &AccuracyArgs) -> Result<Option<Accuracy>, Failure> {
        let limited = args.max_error.is_some() || args.time_limit.is_some() || args.max_samples.is_some();
        let named = limited || args.min_samples.is_some();
        let adaptive = !matches!(picture.aa_method, Some(AaMethod::Grid | AaMethod::Recursive));
        if named && !adaptive {
            return Err(Failure::usage(
                "--max-error, --time-limit, --max-samples and --min-samples belong to --aa-method adaptive",
            ));
        }
        if !adaptive || !(named || picture.antialias.is_some()) {
            return Ok(None);
        }
        // Samples for all alone are an order for just these.
        let only_base = named && !limited;
        let fineness = picture.antialias.filter(|_| !named).map(fineness_of_threshold);
        let error = fineness.map(|f| (Adaptive::TARGET / f).max(Self::FINEST));
        Ok(Some(Accuracy {
            max_error: args.max_error.or(error).or(only_base.then_some(1.0)),
            time_limit: args.time_limit,
            max_samples: args.max_samples,
            most_per_pixel: fineness.map(|f| Adaptive::MOST_PER_PIXEL * f),
            min_samples: args.min_samples.unwrap_or(1),
            sparse: args.max_error.is_some() && args.min_samples.is_none(),
            seed: args.seed,
        }))
    }

    /// `late` is the clock's time at which tracing has to end, if time is limited.
    pub fn settings(&self, region: Region, light: Light, late: Option<f64>) -> Adaptive {
        Adaptive {
            target: Some(self.max_error.unwrap_or(Self::FINEST)),
            max_samples: self
                .max_samples
                .or(self.most_per_pixel.map(|n| (n * region.pixels() as f64) as u64)),
            deadline: late,
            base: self.min_samples,
            sparse: self.sparse,
            seed: self.seed,
            ..Adaptive::new(region, light)
        }
    }
}

/// POV-Ray's thresholds as what error is divided and samples are multiplied by: its default of 0.3 stands for 1.
fn fineness_of_threshold(threshold: f32) -> f64 {
    0.3 / f64::from(threshold).max(1e-3)
}

/// `0.01` or `40dB`.
pub fn parse_error(text: &str) -> Result<f64, String> {
    let lower = text.trim().to_ascii_lowercase();
    let number = |t: &str| t.trim().parse::<f64>().ok().filter(|v| v.is_finite() && *v > 0.0);
    let error = match lower.strip_suffix("db") {
        Some(db) => number(db).map(rmse_from_decibels),
        None => number(&lower),
    };
    error.filter(|e| *e < 1.0).ok_or_else(|| "expected an RMSE between 0 and 1, or decibels: 40dB".to_owned())
}

/// `10`, `10s`, `1.5min`.
pub fn parse_seconds(text: &str) -> Result<f64, String> {
    let text = text.trim();
    let (number, unit) = text.split_at(text.find(|c: char| c.is_ascii_alphabetic()).unwrap_or(text.len()));
    let scale = match unit {
        "" | "s" => 1.0,
        "ms" => 0.001,
        "m" | "min" => 60.0,
        "h" => 3600.0,
        _ => return Err("units are ms, s, min and h".to_owned()),
    };
    let seconds = number.trim().parse::<f64>().ok().map(|n| n * scale);
    seconds.filter(|s| s.is_finite() && *s > 0.0).ok_or_else(|| "expected a time: 10, 10s, 1.5min".to_owned())
}

/// What an adaptive render came to.
#[derive(Clone, Debug, Serialize)]
pub struct Reached {
    /// Why it ended: `converged`, `samples` or `time`.
    pub ended: &'static str,
    pub samples: u64,
    pub samples_per_pixel: f64,
    /// Expected RMSE in light; null for a coarse picture.
    pub rmse_estimate: Option<f64>,
    pub psnr_estimate_db: Option<f64>,
    /// Makes the same picture again, where the clock had a say.
    pub repeat: Option<String>,
}

impl Reached {
    /// `words` is the command line.
    pub fn new<S>(outcome: &Outcome<S>, region: Region, words: &[String]) -> Self {
        let timed = outcome.ended == Ended::Time;
        Self {
            ended: match outcome.ended {
                Ended::Converged => "converged",
                Ended::Samples => "samples",
                Ended::Time => "time",
                Ended::Cancelled => "cancelled",
            },
            samples: outcome.samples,
            samples_per_pixel: outcome.samples as f64 / region.pixels().max(1) as f64,
            rmse_estimate: outcome.rmse,
            psnr_estimate_db: outcome.rmse.and_then(decibels),
            repeat: timed.then(|| repeated(words, outcome.samples)),
        }
    }

    /// What is worth a line of its own.
    pub fn notes(&self) -> Vec<String> {
        let coarse = "warning: there was no time for one sample a pixel: the picture is coarser; \
                      allow more time, or ask for a smaller picture";
        let coarse = self.rmse_estimate.is_none().then(|| coarse.to_owned());
        let repeat = self.repeat.as_ref().map(|command| format!("the same picture again: {command}"));
        coarse.into_iter().chain(repeat).collect()
    }

    /// For people.
    pub fn text(&self) -> String {
        let rate = format!("{:.2} samples a pixel", self.samples_per_pixel);
        match (self.rmse_estimate, self.psnr_estimate_db) {
            (Some(rmse), Some(db)) => format!("{rate}, expected error {rmse:.5} ({db:.1} dB)"),
            (Some(_), None) => format!("{rate}, no error expected"),
            (None, _) => format!("{rate}: a coarser picture, whose error is unknown"),
        }
    }
}

/// The command line with the time limit replaced by the samples that were taken.
fn repeated(words: &[String], samples: u64) -> String {
    let mut kept: Vec<String> = Vec::new();
    let mut words = words.iter();
    while let Some(word) = words.next() {
        match word.as_str() {
            "--time-limit" | "--max-samples" => {
                words.next();
            }
            w if w.starts_with("--time-limit=") || w.starts_with("--max-samples=") => {}
            w => kept.push(quoted(w)),
        }
    }
    kept.push(format!("--max-samples={samples}"));
    kept.join(" ")
}

/// A word as a shell takes it.
pub fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_=+./,:%@".contains(c);
    if !word.is_empty() && word.chars().all(plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::args::{Cli, Command};
    use clap::Parser;

    #[test]
    fn errors_are_numbers_or_decibels() {
        assert_eq!(parse_error("0.01"), Ok(0.01));
        assert!((parse_error("40dB").unwrap() - 0.01).abs() < 1e-12);
        assert!((parse_error("46 DB").unwrap() - 0.00501).abs() < 1e-5);
        for wrong in ["0", "-1", "2", "dB", "-3dB", "x", "inf"] {
            assert!(parse_error(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn times_have_units() {
        let times = [("10", 10.0), ("2.5s", 2.5), ("1.5min", 90.0), ("400ms", 0.4), ("1h", 3600.0)];
        assert!(times.iter().all(|(text, seconds)| parse_seconds(text) == Ok(*seconds)));
        assert!(["", "s", "0", "-1", "3 weeks"].iter().all(|t| parse_seconds(t).is_err()));
    }

    /// `-A` alone, a threshold, limits, and samples for all.
    #[test]
    fn what_is_typed_makes_sampling_adaptive() {
        let of = |words: &[&str]| {
            let words = [&["glint", "render", "a.pov"], words].concat();
            match Cli::try_parse_from(words).unwrap().command {
                Command::Render(args) => Accuracy::of(&args.picture, &args.accuracy).map(|a| {
                    a.map(|a| {
                        (
                            a.max_error.map(|e| (e * 1e4).round()),
                            a.most_per_pixel.map(f64::round),
                            a.min_samples,
                        )
                    })
                }),
                other => panic!("{other:?}"),
            }
        };
        assert_eq!(of(&[]), Ok(None));
        assert_eq!(of(&["-A"]), Ok(Some((Some(100.0), Some(9.0), 1))));
        assert_eq!(of(&["-A=0.15"]), Ok(Some((Some(50.0), Some(18.0), 1))));
        assert_eq!(of(&["-A", "--max-error=40dB"]), Ok(Some((Some(100.0), None, 1))));
        assert_eq!(of(&["--max-samples=7"]), Ok(Some((None, None, 1))));
        assert_eq!(of(&["--min-samples=64"]), Ok(Some((Some(10000.0), None, 64))));
        assert_eq!(of(&["-A", "--aa-method=1"]), Ok(None));
        assert!(of(&["--aa-method=2", "--max-error=0.1"]).is_err());
    }

    #[test]
    fn a_repeated_command_counts_samples_instead_of_seconds() {
        let words = ["glint", "a b.pov", "--time-limit", "3", "-W320", "--time-limit=5"].map(String::from);
        assert_eq!(repeated(&words, 1234), "glint 'a b.pov' -W320 --max-samples=1234");
    }
}
