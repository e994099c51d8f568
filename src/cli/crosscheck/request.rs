use crate::cli::args::{AaMethod, Includes, PictureArgs};
use crate::cli::exit::Failure;
use crate::interp::INCLUDE_FOLDERS;
use std::path::{Path, PathBuf};

/// The size of pictures that nobody asked for otherwise.
const DEFAULT_SIZE: (u32, u32) = (160, 120);

/// What both programs are asked for.
#[derive(Clone, Debug)]
pub struct Request {
    pub width: u32,
    pub height: u32,
    pub antialias: Option<f32>,
    pub aa_method: u8,
    pub aa_depth: u32,
    pub jitter: bool,
    pub quality: u8,
    pub alpha: bool,
    /// Where Glint's standard include files come from.
    pub includes: Includes,
    pub library: Vec<PathBuf>,
    /// `NAME=VALUE`.
    pub declares: Vec<String>,
    pub clock: Option<f64>,
}

impl Request {
    pub fn of(picture: &PictureArgs) -> Request {
        Request {
            width: picture.width.unwrap_or(DEFAULT_SIZE.0),
            height: picture.height.unwrap_or(DEFAULT_SIZE.1),
            antialias: picture.antialias,
            // POV-Ray knows no other method: adaptive sampling is compared with its method 1.
            aa_method: if picture.aa_method == Some(AaMethod::Recursive) { 2 } else { 1 },
            aa_depth: picture.aa_depth,
            jitter: picture.antialias.is_some() && picture.jitter == "on",
            quality: picture.quality,
            alpha: false,
            includes: Includes::Auto,
            library: Vec::new(),
            declares: Vec::new(),
            clock: None,
        }
    }

    /// With folders for included files.
    pub fn with_library(picture: &PictureArgs, library: &[PathBuf]) -> Result<Request, Failure> {
        let absolute = |folder: &PathBuf| {
            folder.canonicalize().map_err(|e| Failure::unavailable(format!("-L {}: {e}", folder.display())))
        };
        Ok(Request {
            library: library.iter().map(absolute).collect::<Result<_, _>>()?,
            ..Request::of(picture)
        })
    }

    /// The options of `glint render`.
    pub fn glint(&self) -> Vec<String> {
        let mut words: Vec<String> =
            vec!["--json".into(), "--quiet".into(), "--threads=1".into(), "-L.".into()];
        words.extend([format!("-W{}", self.width), format!("-H{}", self.height)]);
        words.push(format!("--quality={}", self.quality));
        words.extend(self.library.iter().map(|l| format!("-L{}", l.display())));
        if let Some(threshold) = self.antialias {
            words.extend([format!("-A={threshold}"), format!("--aa-method={}", self.aa_method)]);
            words.push(format!("--aa-depth={}", self.aa_depth));
            words.push(format!("--jitter={}", if self.jitter { "on" } else { "off" }));
        }
        words.extend(self.alpha.then(|| "--alpha".into()));
        words.extend(match self.includes {
            Includes::Auto => None,
            Includes::Embedded => Some("--includes=embedded".into()),
            Includes::Installed => Some("--includes=installed".into()),
        });
        words.extend(self.declares.iter().map(|d| format!("-D{d}")));
        words.extend(self.clock.map(|c| format!("--clock={c}")));
        words
    }

    /// The same for POV-Ray.
    pub fn povray(&self) -> Vec<String> {
        let mut words = vec![format!("+W{}", self.width), format!("+H{}", self.height)];
        match self.antialias {
            None => words.extend(["-A".into(), "-J".into()]),
            Some(threshold) => {
                words.extend([format!("+A{threshold}"), format!("+AM{}", self.aa_method)]);
                words.push(format!("+R{}", self.aa_depth));
                words.push(if self.jitter { "+J1.0".into() } else { "-J".into() });
            }
        }
        words.push(format!("+Q{}", self.quality.min(9)));
        words.extend(["-D".into(), "+WT1".into(), "+FN8".into(), "+L.".into()]);
        words.push(if self.alpha { "+UA".into() } else { "-UA".into() });
        words.extend(self.library.iter().map(|l| format!("+L{}", l.display())));
        words.extend(self.declares.iter().map(|d| format!("Declare={d}")));
        words.extend(self.clock.map(|c| format!("+K{c}")));
        words.extend(INCLUDE_FOLDERS.iter().filter(|f| Path::new(f).is_dir()).map(|f| format!("+L{f}")));
        words
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::args::{Cli, Command};
    use clap::Parser;

    #[test]
    fn both_programs_are_asked_for_the_same() {
        let line = ["glint", "crosscheck", "a.pov", "-W8", "-H6", "-A=0.1", "--aa-method", "2"];
        let Command::Crosscheck(args) = Cli::try_parse_from(line).unwrap().command else { panic!() };
        let request = Request {
            declares: vec!["Detail=3".into()],
            clock: Some(0.5),
            includes: Includes::Embedded,
            library: vec!["lib".into()],
            ..Request::of(&args.picture)
        };
        let (glint, povray) = (request.glint().join(" "), request.povray().join(" "));
        for part in ["-W8 -H6", "-A=0.1 --aa-method=2", "-Llib", "-DDetail=3", "--clock=0.5", "=embedded"] {
            assert!(glint.contains(part), "{part}: {glint}");
        }
        for part in ["+W8 +H6", "+A0.1 +AM2", "+Llib", "Declare=Detail=3", "+K0.5"] {
            assert!(povray.contains(part), "{part}: {povray}");
        }
    }
}
