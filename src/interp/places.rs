//! Folders that a scene may read and write.
//!
//! | folder, with all below it | read | write |
//! |---|---|---|
//! | the scene's, the working folder | yes | yes |
//! | library folders, POV-Ray's include files, that of `Include_Header` | yes | no |
//! | `--allow-read` | yes | no |
//! | `--allow-write` | yes | yes |
//!
//! Links are followed first: what counts is where a file is, not what it is called. Nothing of a file elsewhere is
//! read, so no message can quote it.

use super::lookup::{INCLUDE_FOLDERS, Kind};
use super::{Parser, Result};
use crate::source::{Diagnostic, Span};
use std::path::{Component, Path, PathBuf};

/// What is to be done to a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Access {
    Read,
    Write,
}

impl Parser {
    /// Refuses files that are none of the scene's business.
    pub(crate) fn check_place(&self, path: &Path, access: Access, span: Span) -> Result<()> {
        if self.may_open(path, access) {
            return Ok(());
        }
        let (verb, hint) = match access {
            Access::Read => (
                "read",
                "the scene's own, the working folder, library folders (-L), and those of --allow-read=DIR",
            ),
            Access::Write => ("write", "the scene's own, the working folder, and those of --allow-write=DIR"),
        };
        let message = format!("`{}` lies outside the folders that a scene may {verb}", path.display());
        Err(Box::new(Diagnostic::error(span, message).with_hint(format!("they are {hint}"))))
    }

    /// Whether there is a file of that name that the scene may read.
    pub(super) fn may_see(&self, name: &str) -> bool {
        self.find_file(name, Kind::Data).is_some_and(|found| self.may_open(&found.path, Access::Read))
    }

    fn may_open(&self, path: &Path, access: Access) -> bool {
        if access == Access::Read && is_installed(path) {
            return true;
        }
        let Some(target) = resolved(path) else { return false };
        let mut roots = vec![PathBuf::from(".")];
        roots.extend(self.neighbour_folders().pop());
        roots.extend(self.options.writable.iter().cloned());
        if access == Access::Read {
            roots.extend(self.library_folders().into_iter().skip(1));
            roots.extend(self.options.readable.iter().cloned());
            roots.extend(self.options.include_header.as_deref().and_then(Path::parent).map(Path::to_owned));
        }
        roots.iter().filter_map(|root| resolved(root)).any(|root| target.starts_with(root))
    }
}

/// Whether the path names a file of an installed POV-Ray; some of them are links to files elsewhere.
fn is_installed(path: &Path) -> bool {
    let below = INCLUDE_FOLDERS.iter().find_map(|folder| path.strip_prefix(folder).ok());
    below.is_some_and(|rest| rest.components().all(|c| matches!(c, Component::Normal(_))))
}

/// The path with links followed as far as it exists, and no `..` behind that.
fn resolved(path: &Path) -> Option<PathBuf> {
    let path = std::path::absolute(path).ok()?;
    let existing = path.ancestors().find(|p| p.symlink_metadata().is_ok())?;
    let rest = path.strip_prefix(existing).ok()?;
    if rest.components().any(|c| !matches!(c, Component::Normal(_))) {
        return None;
    }
    Some(existing.canonicalize().ok()?.join(rest))
}
