//! `glint golden`: the project's scenes against their stored pictures.
//!
//! Scenes are in `scenes/` (pictures of 320x240) and `tests/scenes/` (160x120). The picture of a scene has
//! the scene's path below `reference-images/glint/` (made by Glint, blessed by hand) and
//! `reference-images/povray/` (made by POV-Ray 3.7). A scene may say in its own text
//!
//! ```text
//! //! options: -A=0.3 --aa-method 2
//! //! tolerance: 34 dB, because crackle's cells end where rounding says
//! ```
//!
//! how it is rendered (the picture options of `glint render`, and `--alpha`), and how near it must come to
//! POV-Ray's picture, with the reason; 38 dB otherwise. `//! no reference: REASON` stands where POV-Ray
//! cannot render the scene.

mod header;
mod project;

use super::args::{GoldenArgs, GoldenCommand};
use super::compare::decibels;
use super::crosscheck::{Glint, NoPicture, Program, Rendering};
use super::exit::{Exit, Failure};
use super::in_order::{cores, in_order};
use super::{interrupt, json};
use crate::picture::compare::{Difference, compare, difference_image};
use crate::picture::load::{Values, from_bytes, load};
use crate::picture::{Output, compare::png_bytes};
use header::Header;
use project::{Entry, Project};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// A golden picture may be off by this many steps of 1/255 in any channel: other processors round otherwise.
const MAX_STEPS: f64 = 1.0;
/// A scene may take so long.
const LIMIT: Duration = Duration::from_secs(300);

pub fn run(command: &GoldenCommand) -> Result<Exit, Failure> {
    let (GoldenCommand::Check(args) | GoldenCommand::Bless(args) | GoldenCommand::Reference(args)) = command;
    let project = Project::find(args.root.as_deref())?;
    let entries = project.entries(&args.names)?;
    interrupt::listen();
    match command {
        GoldenCommand::Check(_) => check(&project, &entries, args.names.is_empty()),
        GoldenCommand::Bless(_) => bless(&entries),
        GoldenCommand::Reference(_) => reference(&entries, args),
    }
}

/// What is said about a scene, and whether that is good.
type Verdict = Result<String, String>;

fn check(project: &Project, entries: &[Entry], all: bool) -> Result<Exit, Failure> {
    let mut failed = each(entries, |entry| check_one(project, entry));
    if all {
        for orphan in project.orphans(entries)? {
            json::print_text(&format!("FAILED  {}: no scene owns this picture\n", orphan.display()))?;
            failed += 1;
        }
    }
    stopped()?;
    if failed == 0 {
        eprintln!("{} scenes match their pictures", entries.len());
        return Ok(Exit::Done);
    }
    Err(Failure::failed(format!("{failed} complaints about {} scenes", entries.len())))
}

fn check_one(project: &Project, entry: &Entry) -> Verdict {
    let header = Header::of(&entry.scene.path)?;
    let png = glint(entry, &header)?.png;
    let picture = from_bytes(&png)?;
    let mut said = Vec::new();
    if !entry.golden.is_file() {
        return Err(format!("there is no picture yet: `glint golden bless {}` makes it", entry.name));
    }
    let golden = against(&entry.golden, &picture)?;
    if golden.max_abs > MAX_STEPS {
        let trace = project.leave_evidence(entry, &png, &evidence(&entry.golden, &picture)?);
        return Err(format!(
            "differs from Glint's earlier picture: PSNR {} dB, largest difference {} of 255; see {}",
            decibels(golden.psnr_db),
            golden.max_abs,
            trace?.display()
        ));
    }
    said.push(format!("golden {}", decibels(golden.psnr_db)));
    if let Some(min) = header.min_psnr {
        let povray = against(&entry.povray, &picture)?;
        if !povray.reaches(min) {
            let trace = project.leave_evidence(entry, &png, &evidence(&entry.povray, &picture)?);
            return Err(format!(
                "differs from POV-Ray's picture: PSNR {} dB, below {min} dB; see {}",
                decibels(povray.psnr_db),
                trace?.display()
            ));
        }
        said.push(format!("povray {}", decibels(povray.psnr_db)));
    }
    Ok(said.join(", "))
}

fn against(stored: &Path, picture: &Values) -> Result<Difference, String> {
    compare(&load(stored).map_err(|e| e.to_string())?, picture)
}

/// The stored picture's difference from the new one, as a PNG file.
fn evidence(stored: &Path, picture: &Values) -> Result<Vec<u8>, String> {
    png_bytes(&difference_image(&load(stored).map_err(|e| e.to_string())?, picture)?)
}

fn bless(entries: &[Entry]) -> Result<Exit, Failure> {
    each(entries, |entry| {
        let picture = glint(entry, &Header::of(&entry.scene.path)?)?.png;
        store(&entry.golden, &picture)
    });
    stopped()?;
    Err(Failure::failed(
        "pictures were blessed: look at them, and commit them with the reason for the change",
    ))
}

fn reference(entries: &[Entry], args: &GoldenArgs) -> Result<Exit, Failure> {
    let failed = each(entries, |entry| {
        let header = Header::of(&entry.scene.path)?;
        if header.min_psnr.is_none() {
            return Ok("none: the scene says that POV-Ray cannot render it".into());
        }
        let program = Program::new(&args.povray, &header.request(entry.size), LIMIT, None);
        let picture = message(program.map_err(|e| e.message)?.picture(&entry.scene))?.png;
        store(&entry.povray, &picture)
    });
    stopped()?;
    if failed == 0 {
        Ok(Exit::Done)
    } else {
        Err(Failure::failed(format!("{failed} pictures could not be made")))
    }
}

fn glint(entry: &Entry, header: &Header) -> Result<Rendering, String> {
    let glint = Glint::new(&header.request(entry.size), LIMIT, None).map_err(|e| e.message)?;
    message(glint.picture(&entry.scene))
}

fn message(result: Result<Rendering, NoPicture>) -> Result<Rendering, String> {
    result.map_err(|why| why.message)
}

fn store(path: &Path, png: &[u8]) -> Verdict {
    let folder = path.parent().unwrap_or(Path::new("."));
    std::fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    if std::fs::read(path).is_ok_and(|old| old == png) {
        return Ok("unchanged".into());
    }
    Output::File(path.to_owned()).write(png).map_err(|e| e.to_string())?;
    Ok(format!("written: {} bytes", png.len()))
}

/// Does the work for all scenes and prints one line each; gives the number of bad ones.
fn each(entries: &[Entry], work: impl Fn(&Entry) -> Verdict + Sync) -> usize {
    let show = |entry: &Entry, verdict: &Verdict| {
        let (word, said) = match verdict {
            Ok(said) => ("ok", said),
            Err(said) => ("FAILED", said),
        };
        // A reader that has gone away does not stop the work.
        let _ = json::print_text(&format!("{word:<8}{}: {said}\n", entry.name));
    };
    in_order(entries, cores(), work, show).iter().filter(|v| v.is_err()).count()
}

fn stopped() -> Result<(), Failure> {
    if interrupt::requested() { Err(Failure::interrupted("interrupted")) } else { Ok(()) }
}

/// The folder of a path, made if need be.
fn with_folder(path: PathBuf) -> Result<PathBuf, String> {
    let folder = path.parent().unwrap_or(Path::new("."));
    std::fs::create_dir_all(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    Ok(path)
}
