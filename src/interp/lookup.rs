//! Where a file that a scene names is looked for.

use super::options::IncludeMode;
use super::places::Access;
use super::suggest::nearest_file;
use super::{Parser, Result, embedded};
use crate::source::{Diagnostic, Span};
use std::path::{Component, Path, PathBuf};

/// What a file is for; it decides the extensions that are tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Include,
    /// Text read by `#fopen`, and whatever has no extension of its own.
    Data,
    Tga,
    Png,
    Ppm,
    Pgm,
    Gif,
    Jpeg,
    Tiff,
    Bmp,
    Exr,
    Hdr,
    Pot,
    Df3,
    Font,
}

impl Kind {
    fn extensions(self) -> &'static [&'static str] {
        match self {
            Kind::Include => &[".inc", ".INC"],
            Kind::Data => &[],
            Kind::Tga => &[".tga", ".TGA"],
            Kind::Png => &[".png", ".PNG"],
            Kind::Ppm => &[".ppm", ".PPM"],
            Kind::Pgm => &[".pgm", ".PGM"],
            Kind::Gif => &[".gif", ".GIF"],
            Kind::Jpeg => &[".jpg", ".JPG", ".jpeg", ".JPEG"],
            Kind::Tiff => &[".tif", ".TIF", ".tiff", ".TIFF"],
            Kind::Bmp => &[".bmp", ".BMP"],
            Kind::Exr => &[".exr", ".EXR"],
            Kind::Hdr => &[".hdr", ".HDR"],
            Kind::Pot => &[".pot", ".POT"],
            Kind::Df3 => &[".df3", ".DF3"],
            Kind::Font => &[".ttf", ".TTF"],
        }
    }
}

/// Where an installed POV-Ray has its standard include files: the first of these that is there.
pub const INCLUDE_FOLDERS: [&str; 4] = [
    "/usr/share/povray-3.7/include",
    "/usr/local/share/povray-3.7/include",
    "/usr/share/povray/include",
    "/opt/homebrew/share/povray-3.7/include",
];

/// Why the reference would not find a file that is found without regard to case.
pub(super) const OTHER_CASE: &str = "capitals and small letters differ";

/// A file that was found.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Found {
    pub path: PathBuf,
    /// Why the reference would not have found it, if so.
    pub leniency: Option<&'static str>,
}

impl Parser {
    /// The file that `name` means, by the reference's rules: its candidates in the working folder and in the
    /// library paths. Failing that, beside the text that names it and beside the scene, then with slashes
    /// for backslashes and without regard to case.
    pub(super) fn find_file(&self, name: &str, kind: Kind) -> Option<Found> {
        let strict = self.library_folders();
        let beside = self.neighbour_folders();
        let exact = |folders: &[PathBuf], name: &str| {
            let all = candidates(name, kind);
            all.iter().find_map(|candidate| in_folders(folders, candidate))
        };
        if let Some(path) = exact(&strict, name) {
            return Some(Found { path, leniency: None });
        }
        if let Some(path) = exact(&beside, name) {
            return Some(Found {
                path,
                leniency: Some("it stands beside the scene, not in the working folder"),
            });
        }
        let slashed = name.replace('\\', "/");
        let folders: Vec<PathBuf> = strict.into_iter().chain(beside).collect();
        if slashed != name
            && let Some(path) = exact(&folders, &slashed)
        {
            return Some(Found { path, leniency: Some("backslashes were read as slashes") });
        }
        let path = candidates(&slashed, kind).iter().find_map(|c| without_case(&folders, c))?;
        Some(Found { path, leniency: Some(OTHER_CASE) })
    }

    /// The file that `name` means, with a warning if the reference would not find it, or the error: there is none,
    /// or it is none of the scene's business.
    pub(crate) fn require_file(&mut self, name: &str, kind: Kind, span: Span) -> Result<PathBuf> {
        match self.find_file(name, kind) {
            Some(found) => {
                self.check_place(&found.path, Access::Read, span)?;
                self.lenient_about(&found, name, span)?;
                Ok(found.path)
            }
            None => {
                self.refuse_special(name, span)?;
                Err(self.no_such_file(name, span))
            }
        }
    }

    /// The error for a folder, a device or a pipe by this name.
    pub(super) fn refuse_special(&self, name: &str, span: Span) -> Result<()> {
        if name.is_empty() {
            return Ok(());
        }
        let folders = self.library_folders().into_iter().chain(self.neighbour_folders());
        let Some(path) = folders.map(|folder| folder.join(name)).find(|path| path.exists()) else {
            return Ok(());
        };
        self.check_place(&path, Access::Read, span)?;
        Err(Box::new(Diagnostic::error(span, format!("cannot open `{name}`: it is no plain file"))))
    }

    pub(super) fn lenient_about(&mut self, found: &Found, name: &str, span: Span) -> Result<()> {
        let Some(why) = found.leniency else { return Ok(()) };
        let message = format!("`{name}` is taken to be {}: {why}", found.path.display());
        self.lenient(Diagnostic::warning(span, message))
    }

    pub(super) fn no_such_file(&self, name: &str, span: Span) -> Box<Diagnostic> {
        let folders: Vec<String> =
            self.library_folders().iter().skip(1).map(|f| f.display().to_string()).collect();
        let hint = match folders.is_empty() {
            _ if is_standard(name) => {
                "it comes with POV-Ray: install its include files (package `povray-includes`), or name their folder with -L"
                    .to_owned()
            }
            true => "looked in the working folder and beside the scene; name more folders with -L".to_owned(),
            false => format!("looked in the working folder, {} and beside the scene", folders.join(", ")),
        };
        let hint = match self.nearest_file(name) {
            Some(near) => format!("did you mean `{near}`? ({hint})"),
            None => hint,
        };
        Box::new(Diagnostic::error(span, format!("cannot find the file `{name}`")).with_hint(hint))
    }

    /// The file most like `name` where it was looked for, among those carried along too.
    fn nearest_file(&self, name: &str) -> Option<String> {
        let mut known: Vec<String> = match self.options.includes {
            IncludeMode::Installed => Vec::new(),
            _ => embedded::names().map(str::to_owned).collect(),
        };
        for folder in self.library_folders().into_iter().chain(self.neighbour_folders()) {
            let listed = if folder.as_os_str().is_empty() { Path::new(".") } else { &folder };
            let entries = std::fs::read_dir(listed).into_iter().flatten().flatten();
            let files = entries.filter(|entry| entry.file_type().is_ok_and(|t| !t.is_dir()));
            known.extend(files.filter_map(|entry| entry.file_name().into_string().ok()));
        }
        nearest_file(name, known.into_iter())
    }

    /// The working folder, the library paths and the installed include files.
    pub(super) fn library_folders(&self) -> Vec<PathBuf> {
        let mut folders = vec![PathBuf::new()];
        folders.extend(self.options.library_paths.iter().cloned());
        if self.options.includes != IncludeMode::Embedded {
            folders.extend(INCLUDE_FOLDERS.iter().map(PathBuf::from).find(|f| f.is_dir()));
        }
        folders
    }

    /// The folders of the text being read and of the texts that include it.
    pub(super) fn neighbour_folders(&self) -> Vec<PathBuf> {
        let mut folders: Vec<PathBuf> = Vec::new();
        for frame in self.frames.iter().rev() {
            let path = frame.file_id().and_then(|id| self.files.path(id));
            if let Some(folder) = path.and_then(|p| p.parent())
                && folders.last().is_none_or(|last| last != folder)
            {
                folders.push(folder.to_owned());
            }
        }
        folders
    }
}

/// Files that come with POV-Ray and are not carried here because they are design and not fact. Include files are without
/// their ending.
const DESIGNS: [&str; 42] = [
    "chars",
    "glass",
    "glass_old",
    "golds",
    "logo",
    "makegrass",
    "metals",
    "skies",
    "stage1",
    "stars",
    "stdcam",
    "stoneold",
    "stones",
    "stones1",
    "stones2",
    "textures",
    "woodmaps",
    "woods",
    "ash.map",
    "benediti.map",
    "bubinga.map",
    "cedar.map",
    "marbteal.map",
    "orngwood.map",
    "pinkmarb.map",
    "rdgranit.map",
    "teak.map",
    "whiteash.map",
    "bumpmap_.png",
    "fract003.png",
    "mount1.png",
    "mount2.png",
    "mtmandj.png",
    "plasma2.png",
    "plasma3.png",
    "povmap.png",
    "mtmand.pot",
    "spiral.df3",
    "crystal.ttf",
    "cyrvetic.ttf",
    "povlogo.ttf",
    "timrom.ttf",
];

/// Whether a file of that name comes with POV-Ray.
fn is_standard(name: &str) -> bool {
    let name = name.to_ascii_lowercase();
    let stem = name.strip_suffix(".inc").unwrap_or(&name);
    DESIGNS.contains(&stem) || embedded::lookup(&format!("{stem}.inc")).is_some()
}

/// The names to try, in order.
fn candidates(name: &str, kind: Kind) -> Vec<String> {
    let extensions = kind.extensions();
    let complete = extensions.iter().any(|e| name.ends_with(e));
    let mut all = Vec::with_capacity(extensions.len() + 1);
    if complete {
        all.push(name.to_owned());
    }
    all.extend(extensions.iter().map(|e| format!("{name}{e}")));
    if !complete {
        all.push(name.to_owned());
    }
    all
}

fn in_folders(folders: &[PathBuf], name: &str) -> Option<PathBuf> {
    folders.iter().map(|folder| folder.join(name)).find(|path| path.is_file())
}

/// As [`in_folders`], but every part of the name may differ in case.
fn without_case(folders: &[PathBuf], name: &str) -> Option<PathBuf> {
    let name = Path::new(name);
    if name.is_absolute() {
        return None;
    }
    folders.iter().find_map(|folder| {
        let mut path = folder.clone();
        for part in name.components() {
            path = match part {
                Component::Normal(part) => same_letters(&path, &part.to_string_lossy())?,
                other => path.join(other),
            };
        }
        path.is_file().then_some(path)
    })
}

fn same_letters(folder: &Path, part: &str) -> Option<PathBuf> {
    let listed = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let mut names: Vec<String> = std::fs::read_dir(listed)
        .ok()?
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .filter(|name| name.eq_ignore_ascii_case(part))
        .collect();
    names.sort();
    Some(folder.join(names.into_iter().next()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is carried is not called design, and the design files of the include files' list are known.
    #[test]
    fn files_are_carried_or_known() {
        for name in embedded::names() {
            let stem = name.strip_suffix(".inc").unwrap();
            assert!(is_standard(name) && is_standard(stem) && !DESIGNS.contains(&stem), "{name}");
        }
        assert!(is_standard("Woods.inc") && is_standard("timrom.ttf") && !is_standard("mine.inc"));
    }

    #[test]
    fn extensions_are_tried_before_the_bare_name() {
        assert_eq!(candidates("colors", Kind::Include), ["colors.inc", "colors.INC", "colors"]);
        assert_eq!(
            candidates("colors.inc", Kind::Include),
            ["colors.inc", "colors.inc.inc", "colors.inc.INC"]
        );
        assert_eq!(candidates("data.txt", Kind::Data), ["data.txt"]);
        assert_eq!(candidates("a.gif", Kind::Png), ["a.gif.png", "a.gif.PNG", "a.gif"]);
    }
}
