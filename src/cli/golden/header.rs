//! What a scene says about its own test.

use crate::cli::args::PictureArgs;
use crate::cli::crosscheck::Request;
use clap::Parser;
use std::path::Path;

/// From here on Glint's picture is as good as POV-Ray's.
const MIN_PSNR: f64 = 38.0;

/// The options that a scene may ask for.
#[derive(Parser, Clone, Debug)]
#[command(name = "options", disable_help_flag = true, no_binary_name = true)]
struct Options {
    #[command(flatten)]
    picture: PictureArgs,
    #[arg(long)]
    alpha: bool,
}

/// The lines of a scene that begin with `//!`.
#[derive(Clone, Debug)]
pub struct Header {
    options: Options,
    /// How near Glint must come to POV-Ray's picture; `None` where there cannot be one.
    pub min_psnr: Option<f64>,
}

impl Header {
    pub fn of(scene: &Path) -> Result<Header, String> {
        let bytes = std::fs::read(scene).map_err(|e| format!("{}: {e}", scene.display()))?;
        Header::parse(&String::from_utf8_lossy(&bytes))
    }

    fn parse(text: &str) -> Result<Header, String> {
        let mut words = Vec::new();
        let mut min_psnr = Some(MIN_PSNR);
        for line in text.lines().filter_map(|l| l.strip_prefix("//!")).map(str::trim) {
            match line.split_once(':').map(|(name, value)| (name.trim(), value.trim())) {
                Some(("options", value)) => words.extend(value.split_whitespace().map(String::from)),
                Some(("tolerance", value)) => min_psnr = Some(tolerance(value)?),
                Some(("no reference", reason)) if !reason.is_empty() => min_psnr = None,
                _ => return Err(format!("`//! {line}`: expected options:, tolerance: or no reference:")),
            }
        }
        let options = Options::try_parse_from(words).map_err(|e| e.to_string())?;
        Ok(Header { options, min_psnr })
    }

    /// What both programs are asked for; `size` holds where the scene does not say otherwise.
    pub fn request(&self, size: (u32, u32)) -> Request {
        let mut picture = self.options.picture.clone();
        picture.width = picture.width.or(Some(size.0));
        picture.height = picture.height.or(Some(size.1));
        Request { alpha: self.options.alpha, embedded: true, ..Request::of(&picture) }
    }
}

/// `34 dB, because …`: the reason is not optional.
fn tolerance(text: &str) -> Result<f64, String> {
    let wrong = || format!("`//! tolerance: {text}`: expected decibels and a reason: 34 dB, because …");
    let (number, reason) = text.split_once("dB").ok_or_else(wrong)?;
    if reason.trim_matches([',', ':', ' ']).is_empty() {
        return Err(wrong());
    }
    number.trim().parse().map_err(|_| wrong())
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
        assert!(request.embedded && !request.alpha);
    }

    #[test]
    fn scenes_may_ask() {
        let text = "//! options: -A=0.1 --aa-method 2 --jitter off -W 80\n//! tolerance: 34.5 dB, because of noise\n";
        let header = Header::parse(text).unwrap();
        assert_eq!(header.min_psnr, Some(34.5));
        let r = header.request((160, 120));
        assert_eq!((r.width, r.height, r.antialias, r.aa_method, r.jitter), (80, 120, Some(0.1), 2, false));
        assert_eq!(Header::parse("//! no reference: obj meshes are ours\n").unwrap().min_psnr, None);
    }

    #[test]
    fn mistakes_are_refused() {
        for wrong in ["//! tolerance: 34 dB", "//! tolerance: low", "//! option: -A", "//! options: --json"] {
            assert!(Header::parse(wrong).is_err(), "{wrong}");
        }
    }
}
