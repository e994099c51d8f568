//! Which scenes are checked.

use crate::cli::args::CrosscheckArgs;
use crate::cli::exit::Failure;
use std::path::{Path, PathBuf};

/// A scene by the path that reports show, and where it is.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    pub name: String,
    pub path: PathBuf,
}

impl Scene {
    /// The folder from which both programs run.
    pub fn folder(&self) -> &Path {
        self.path.parent().unwrap_or(Path::new("/"))
    }

    /// The scene's file name, for a program that runs in its folder.
    pub fn file_name(&self) -> &std::ffi::OsStr {
        self.path.file_name().unwrap_or_default()
    }
}

/// The scenes that were asked for: files as they are, folders searched, or a list's lines in one folder.
pub fn find(args: &CrosscheckArgs) -> Result<Vec<Scene>, Failure> {
    if let Some(list) = &args.list {
        let [folder] = args.paths.as_slice() else {
            return Err(Failure::usage("--list goes with one folder: its lines are paths in that folder"));
        };
        return listed(list, folder);
    }
    let mut scenes = Vec::new();
    for path in &args.paths {
        if path.is_dir() {
            search(path, path, &mut scenes)?;
        } else {
            scenes.push(scene(path.display().to_string(), path)?);
        }
    }
    if scenes.is_empty() {
        return Err(Failure::unavailable("no .pov file was found in these folders"));
    }
    Ok(scenes)
}

fn scene(name: String, path: &Path) -> Result<Scene, Failure> {
    let path = path.canonicalize().map_err(|e| Failure::unavailable(format!("{}: {e}", path.display())))?;
    Ok(Scene { name, path })
}

/// Lines are paths; what follows a tab is ignored, and so are lines that begin with `#`.
fn listed(list: &Path, folder: &Path) -> Result<Vec<Scene>, Failure> {
    let text = std::fs::read_to_string(list);
    let text = text.map_err(|e| Failure::unavailable(format!("{}: {e}", list.display())))?;
    let names = text.lines().map(|l| l.split('\t').next().unwrap_or(l).trim());
    let names = names.filter(|l| !l.is_empty() && !l.starts_with('#'));
    names.map(|name| scene(name.to_owned(), &folder.join(name))).collect()
}

/// All `.pov` files below a folder, in the order of their names.
pub fn search(root: &Path, folder: &Path, scenes: &mut Vec<Scene>) -> Result<(), Failure> {
    let unreadable = |e: std::io::Error| Failure::unavailable(format!("{}: {e}", folder.display()));
    let mut paths = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(unreadable)? {
        paths.push(entry.map_err(unreadable)?.path());
    }
    paths.sort();
    for path in paths {
        if path.is_dir() && !path.is_symlink() {
            search(root, &path, scenes)?;
        } else if path.extension().is_some_and(|e| e.eq_ignore_ascii_case("pov")) {
            let name = path.strip_prefix(root).unwrap_or(&path).display().to_string();
            scenes.push(scene(name, &path)?);
        }
    }
    Ok(())
}
