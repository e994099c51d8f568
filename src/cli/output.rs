//! Where a picture goes and in which format.

use super::exit::Failure;
use crate::picture::other::{self, Kind};
use crate::picture::{Encoding, Output, Picture, PictureError, exr, png};
use std::path::{Path, PathBuf};

/// A picture's file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    Png,
    Exr,
    /// Those that only POV-Ray's command line writes.
    Other(Kind),
}

impl Format {
    /// The ending that POV-Ray gives to the file's name.
    pub fn extension(self) -> &'static str {
        match self {
            Format::Png => "png",
            Format::Exr => "exr",
            Format::Other(Kind::Targa | Kind::PackedTarga) => "tga",
            Format::Other(Kind::Ppm) => "ppm",
            Format::Other(Kind::Bmp) => "bmp",
            Format::Other(Kind::Jpeg(_)) => "jpg",
            Format::Other(Kind::Hdr) => "hdr",
        }
    }

    /// Refuses a name that promises anything but a PNG picture.
    pub fn png_only(path: &Path) -> Result<(), Failure> {
        match Format::of(path) {
            Ok(Format::Png) => Ok(()),
            _ => Err(Failure::usage(format!("{}: this picture is written as .png only", path.display()))),
        }
    }

    fn of(path: &Path) -> Result<Format, Failure> {
        let extension = path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
        match extension.as_str() {
            "png" => Ok(Format::Png),
            "exr" => Ok(Format::Exr),
            _ => Err(Failure::usage(format!(
                "{}: pictures are written as .png or .exr; give the output file one of these endings",
                path.display()
            ))),
        }
    }
}

/// A file (or standard output) with its format.
#[derive(Clone, Debug, PartialEq)]
pub struct Target {
    pub output: Output,
    pub format: Format,
}

impl Target {
    /// `given` is what `-o` said: nothing, `-`, a folder, or a file.
    pub fn new(scene: &Path, given: Option<&Path>) -> Result<Target, Failure> {
        match given {
            None => Ok(Target::png(base_name(scene))),
            Some(o) if o == Path::new("-") => Ok(Target { output: Output::Stdout, format: Format::Png }),
            Some(o) if is_folder(o) => Ok(Target::png(o.join(base_name(scene)))),
            Some(o) => Ok(Target { output: Output::File(o.to_owned()), format: Format::of(o)? }),
        }
    }

    fn png(path: PathBuf) -> Target {
        Target { output: Output::File(path), format: Format::Png }
    }

    /// Refuses a file in a folder that is not there.
    pub fn check_folder(&self) -> Result<(), Failure> {
        let Some(path) = self.output.path() else { return Ok(()) };
        match path.parent() {
            Some(folder) if folder != Path::new("") && !folder.is_dir() => {
                Err(Failure::unavailable(format!("{}: no such folder for the picture", folder.display())))
            }
            _ => Ok(()),
        }
    }

    pub fn write(&self, picture: &Picture, encoding: &Encoding) -> Result<(), PictureError> {
        if self.output == Output::Nowhere {
            return Ok(());
        }
        let bytes = match self.format {
            Format::Png => png::encode(picture, encoding)?,
            Format::Exr => exr::encode(picture, encoding)?,
            Format::Other(kind) => other::encode(picture, encoding, kind)?,
        };
        self.output.write(&bytes)
    }
}

/// Whether `-o` names a folder: it is one, or is written with a slash at its end.
pub fn is_folder(path: &Path) -> bool {
    path.is_dir() || path.to_string_lossy().ends_with(std::path::is_separator)
}

/// The name of a scene's picture.
fn base_name(scene: &Path) -> PathBuf {
    if scene == Path::new("-") {
        return "stdin.png".into();
    }
    let stem = scene.file_stem().unwrap_or_default();
    let mut name = stem.to_owned();
    name.push(".png");
    name.into()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn target(scene: &str, given: Option<&str>) -> Result<Target, Failure> {
        Target::new(Path::new(scene), given.map(Path::new))
    }

    #[test]
    fn names_follow_the_scene_or_the_option() {
        let path = |t: Target| t.output.path().unwrap().to_owned();
        assert_eq!(path(target("a/b.c.pov", None).unwrap()), Path::new("b.c.png"));
        assert_eq!(path(target("-", None).unwrap()), Path::new("stdin.png"));
        assert_eq!(path(target("a/b.pov", Some("out/")).unwrap()), Path::new("out/b.png"));
        assert_eq!(target("b.pov", Some("x.EXR")).unwrap().format, Format::Exr);
        assert_eq!(target("b.pov", Some("-")).unwrap().output, Output::Stdout);
    }

    #[test]
    fn unknown_endings_are_refused_with_advice() {
        let error = target("b.pov", Some("x.jpg")).unwrap_err();
        assert_eq!(error.exit, super::super::exit::Exit::Usage);
        assert!(error.message.contains(".png or .exr"));
    }
}
