//! What a scene says about its own test.

use crate::cli::args::{Includes, PictureArgs};
use crate::cli::crosscheck::Request;
use clap::Parser;
use std::path::{Path, PathBuf};

/// From here on Glint's picture is as good as POV-Ray's.
const MIN_PSNR: f64 = 38.0;
/// A golden picture may be off by so many steps of 1/255 in any channel: other processors round otherwise.
const MAX_STEPS: f64 = 1.0;

/// The options that a scene may ask for.
#[derive(Parser, Clone, Debug)]
#[command(name = "options", disable_help_flag = true, no_binary_name = true)]
struct Options {
    #[command(flatten)]
    picture: PictureArgs,
    #[arg(long)]
    alpha: bool,
    /// Folders for included files, from the scene's own folder on.
    #[arg(short = 'L', long)]
    library: Vec<PathBuf>,
    #[arg(short = 'D', long)]
    declare: Vec<String>,
    #[arg(long, allow_negative_numbers = true)]
    clock: Option<f64>,
    /// Nothing that is installed takes part unless the scene wants it.
    #[arg(long, value_enum, default_value = "embedded")]
    includes: Includes,
}

/// The lines of a scene that begin with `//!`.
#[derive(Clone, Debug)]
pub struct Header {
    options: Options,
    /// How near Glint must come to POV-Ray's picture; `None` where there cannot be one.
    pub min_psnr: Option<f64>,
    /// How far Glint may be from its own earlier picture, in steps of 1/255.
    pub max_steps: f64,
}

impl Header {
    pub fn of(scene: &Path) -> Result<Header, String> {
        let bytes = std::fs::read(scene).map_err(|e| format!("{}: {e}", scene.display()))?;
        Header::parse(&String::from_utf8_lossy(&bytes))
    }

    fn parse(text: &str) -> Result<Header, String> {
        let mut words = Vec::new();
        let mut min_psnr = Some(MIN_PSNR);
        let mut max_steps = MAX_STEPS;
        for line in text.lines().filter_map(|l| l.strip_prefix("//!")).map(str::trim) {
            match line.split_once(':').map(|(name, value)| (name.trim(), value.trim())) {
                Some(("options", value)) => words.extend(value.split_whitespace().map(String::from)),
                Some(("tolerance", value)) => min_psnr = Some(tolerance(value)?),
                Some(("golden", value)) => max_steps = steps(value)?,
                Some(("no reference", reason)) if !reason.is_empty() => min_psnr = None,
                _ => {
                    return Err(format!(
                        "`//! {line}`: expected options:, tolerance:, golden: or no reference:"
                    ));
                }
            }
        }
        let options = Options::try_parse_from(words).map_err(|e| e.to_string())?;
        Ok(Header { options, min_psnr, max_steps })
    }

    /// What both programs are asked for; `size` holds where the scene does not say otherwise.
    pub fn request(&self, size: (u32, u32)) -> Request {
        let mut picture = self.options.picture.clone();
        picture.width = picture.width.or(Some(size.0));
        picture.height = picture.height.or(Some(size.1));
        let o = &self.options;
        Request {
            alpha: o.alpha,
            library: o.library.clone(),
            declares: o.declare.clone(),
            clock: o.clock,
            includes: o.includes,
            ..Request::of(&picture)
        }
    }
}

/// `34 dB, because …`: the reason is not optional.
fn tolerance(text: &str) -> Result<f64, String> {
    reasoned(text, "dB")
        .ok_or_else(|| format!("`//! tolerance: {text}`: expected decibels and a reason: 34 dB, because …"))
}

/// `3 of 255, because …`.
fn steps(text: &str) -> Result<f64, String> {
    reasoned(text, "of 255").ok_or_else(|| {
        format!("`//! golden: {text}`: expected steps of a channel and a reason: 3 of 255, because …")
    })
}

/// A number, its unit and a reason.
fn reasoned(text: &str, unit: &str) -> Option<f64> {
    let (number, reason) = text.split_once(unit)?;
    let given = !reason.trim_matches([',', ':', ' ']).is_empty();
    number.trim().parse().ok().filter(|n: &f64| given && *n >= 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_may_say_nothing() {
        let header = Header::parse("// a sphere\nsphere { 0, 1 }\n").unwrap();
        assert_eq!(header.min_psnr, Some(38.0));
        let request = header.request((160, 120));
        assert_eq!((request.width, request.height, request.antialias), (160, 120, None));
        assert_eq!((header.max_steps, request.includes), (1.0, Includes::Embedded));
        assert!(!request.alpha);
    }

    #[test]
    fn scenes_may_ask() {
        let text = "//! options: -A=0.1 --aa-method 2 --jitter off -W 80\n//! tolerance: 34.5 dB, because of noise\n";
        let header = Header::parse(text).unwrap();
        assert_eq!(header.min_psnr, Some(34.5));
        let r = header.request((160, 120));
        assert_eq!((r.width, r.height, r.antialias, r.aa_method, r.jitter), (80, 120, Some(0.1), 2, false));
        let text = "//! options: -L ../inc -D Detail=3 --clock -0.5 --includes auto\n//! golden: 4 of 255, because of crand\n";
        let header = Header::parse(text).unwrap();
        let r = header.request((160, 120));
        assert_eq!((header.max_steps, r.library, r.clock), (4.0, vec!["../inc".into()], Some(-0.5)));
        assert_eq!((r.declares, r.includes), (vec!["Detail=3".to_owned()], Includes::Auto));
        assert_eq!(Header::parse("//! no reference: obj meshes are ours\n").unwrap().min_psnr, None);
    }

    #[test]
    fn mistakes_are_refused() {
        for wrong in [
            "//! tolerance: 34 dB",
            "//! tolerance: low",
            "//! golden: 3 of 255",
            "//! golden: 3, because",
            "//! option: -A",
            "//! options: --json",
        ] {
            assert!(Header::parse(wrong).is_err(), "{wrong}");
        }
    }
}
