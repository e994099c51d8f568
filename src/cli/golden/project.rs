//! The project's folder: scenes and where their pictures are.

use super::with_folder;
use crate::cli::args::GoldenArgs;
use crate::cli::crosscheck::{Scene, search};
use crate::cli::exit::Failure;
use std::collections::HashSet;
use std::path::{Path, PathBuf};

/// Folders of scenes with the size of their pictures.
const FOLDERS: [(&str, (u32, u32)); 2] = [("scenes", (320, 240)), ("tests/scenes", (160, 120))];
/// The size of pictures of other folders' scenes.
const SIZE: (u32, u32) = (320, 240);
const IMAGES: &str = "reference-images";

pub struct Project {
    root: PathBuf,
    /// Below the root, with `/`.
    folders: Vec<(String, (u32, u32))>,
    keep: PathBuf,
}

/// A scene and its pictures.
#[derive(Debug)]
pub struct Entry {
    /// The path below the project's folder.
    pub name: String,
    pub scene: Scene,
    pub golden: PathBuf,
    pub povray: PathBuf,
    pub size: (u32, u32),
}

impl Entry {
    /// The project's folder, in which all of its scenes may read.
    pub fn root(&self) -> Option<&Path> {
        self.scene.path.ancestors().nth(Path::new(&self.name).components().count())
    }
}

impl Project {
    /// The folder given, or the nearest one above that has stored pictures.
    pub fn find(args: &GoldenArgs) -> Result<Project, Failure> {
        let given = args.root.as_deref();
        let here =
            std::env::current_dir().map_err(|e| Failure::unavailable(format!("current folder: {e}")))?;
        let above = || here.ancestors().find(|f| f.join(IMAGES).is_dir()).map(Path::to_owned);
        let root = given.map(Path::to_owned).or_else(above);
        let root = root.ok_or_else(|| {
            Failure::unavailable(format!(
                "no folder above has {IMAGES}: name the project's folder with --root"
            ))
        })?;
        let root =
            root.canonicalize().map_err(|e| Failure::unavailable(format!("{}: {e}", root.display())))?;
        let fixed = || FOLDERS.map(|(folder, size)| (folder.to_owned(), size)).to_vec();
        let named = args.scenes.iter().map(|f| named_folder(&root, f)).collect::<Result<Vec<_>, _>>()?;
        let folders = if named.is_empty() { fixed() } else { named };
        let keep = args.keep.clone().unwrap_or_else(|| root.join("target").join("golden"));
        Ok(Project { root, folders, keep })
    }

    /// The scenes named, or all.
    pub fn entries(&self, names: &[String]) -> Result<Vec<Entry>, Failure> {
        let mut entries = Vec::new();
        for (folder, size) in &self.folders {
            let path = self.root.join(folder);
            let mut scenes = Vec::new();
            if path.is_dir() {
                search(&path, &path, &mut scenes)?;
            }
            entries.extend(scenes.into_iter().map(|scene| self.entry(folder, *size, scene)));
        }
        let all = entries.len();
        entries.retain(|e| names.is_empty() || names.iter().any(|n| is_named(&e.name, n)));
        if let Some(name) = names.iter().find(|n| !entries.iter().any(|e| is_named(&e.name, n))) {
            return Err(Failure::usage(format!("`{name}` is none of the project's {all} scenes")));
        }
        Ok(entries)
    }

    fn entry(&self, folder: &str, size: (u32, u32), scene: Scene) -> Entry {
        let name = format!("{folder}/{}", scene.name.replace('\\', "/"));
        let picture = Path::new(&name).with_extension("png");
        let images = self.root.join(IMAGES);
        Entry {
            golden: images.join("glint").join(&picture),
            povray: images.join("povray").join(&picture),
            name,
            scene,
            size,
        }
    }

    /// Whether anybody has made POV-Ray's pictures.
    pub fn has_reference(&self) -> bool {
        self.root.join(IMAGES).join("povray").is_dir()
    }

    /// Stored pictures that belong to none of the scenes.
    pub fn orphans(&self, entries: &[Entry]) -> Result<Vec<PathBuf>, Failure> {
        let owned: HashSet<&Path> =
            entries.iter().flat_map(|e| [e.golden.as_path(), e.povray.as_path()]).collect();
        let images = |made_by: &str| {
            let folder = self.root.join(IMAGES).join(made_by);
            self.folders.iter().map(move |(f, _)| folder.join(f)).collect::<Vec<_>>()
        };
        let mut open = [images("glint"), images("povray")].concat();
        open.retain(|folder| folder.is_dir());
        let mut orphans = Vec::new();
        while let Some(folder) = open.pop() {
            let unreadable = |e: std::io::Error| Failure::unavailable(format!("{}: {e}", folder.display()));
            for file in std::fs::read_dir(&folder).map_err(unreadable)? {
                let path = file.map_err(unreadable)?.path();
                if path.is_dir() {
                    open.push(path);
                } else if path.extension().is_some_and(|e| e == "png") && !owned.contains(path.as_path()) {
                    orphans.push(path);
                }
            }
        }
        orphans.sort();
        Ok(orphans)
    }

    /// Keeps a picture that differs, and its difference, where they can be looked at.
    pub fn leave_evidence(&self, entry: &Entry, png: &[u8], difference: &[u8]) -> Result<PathBuf, String> {
        let base = self.keep.join(Path::new(&entry.name).with_extension(""));
        let write = |ending: &str, bytes: &[u8]| {
            let mut name = base.clone().into_os_string();
            name.push(ending);
            let path = with_folder(name.into())?;
            std::fs::write(&path, bytes).map_err(|e| format!("{}: {e}", path.display()))?;
            Ok(path)
        };
        write(".difference.png", difference)?;
        write(".png", png)
    }
}

/// A folder of the project by its path below the root.
fn named_folder(root: &Path, folder: &Path) -> Result<(String, (u32, u32)), Failure> {
    let lost = || Failure::unavailable(format!("--scenes {}: no folder of the project", folder.display()));
    let path = root.join(folder).canonicalize().ok().filter(|p| p.is_dir()).ok_or_else(lost)?;
    let below = path.strip_prefix(root).map_err(|_| lost())?.to_string_lossy().replace('\\', "/");
    let known = FOLDERS.iter().find(|(name, _)| *name == below);
    let size = known.map_or(SIZE, |(_, size)| *size);
    Ok((below, size))
}

/// A scene is named by its path with or without `.pov`, from any folder on, or by a folder.
fn is_named(path: &str, name: &str) -> bool {
    let name = name.trim_start_matches("./").trim_end_matches('/');
    let bare = path.strip_suffix(".pov").unwrap_or(path);
    let name = name.strip_suffix(".pov").unwrap_or(name);
    let ends = |p: &str| p == name || p.strip_suffix(name).is_some_and(|before| before.ends_with('/'));
    ends(bare) || path.strip_prefix(name).is_some_and(|rest| rest.starts_with('/'))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_are_named_in_several_ways() {
        let path = "tests/scenes/shape/sphere.pov";
        for name in [
            "sphere",
            "sphere.pov",
            "shape/sphere",
            "./tests/scenes/shape/sphere.pov",
            "tests/scenes",
            "tests/scenes/shape/",
        ] {
            assert!(is_named(path, name), "{name}");
        }
        for name in ["here", "box", "tests/scene", "scenes"] {
            assert!(!is_named(path, name), "{name}");
        }
    }
}
