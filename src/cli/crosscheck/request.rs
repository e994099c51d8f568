use crate::cli::args::{AaMethod, PictureArgs};
use crate::cli::exit::Failure;
use std::path::{Path, PathBuf};

/// The size of pictures that nobody asked for otherwise.
const DEFAULT_SIZE: (u32, u32) = (160, 120);

/// Where POV-Ray's standard include files are, apart from the folder beside the program.
const INCLUDE_FOLDERS: [&str; 4] = [
    "/usr/share/povray-3.7/include",
    "/usr/local/share/povray-3.7/include",
    "/usr/share/povray/include",
    "/opt/homebrew/share/povray-3.7/include",
];

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
    /// Glint's embedded include files instead of POV-Ray's.
    pub embedded: bool,
    pub library: Vec<PathBuf>,
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
            embedded: false,
            library: Vec::new(),
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
        words.extend(self.embedded.then(|| "--includes=embedded".into()));
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
        words.extend(INCLUDE_FOLDERS.iter().filter(|f| Path::new(f).is_dir()).map(|f| format!("+L{f}")));
        words
    }
}
