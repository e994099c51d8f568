//! `glint golden`: the project's scenes against their stored pictures.
//!
//! Scenes are in `scenes/` (pictures of 320x240) and `tests/scenes/` (160x120). The picture of a scene has
//! the scene's path below `reference-images/glint/` (made by Glint, blessed by hand) and
//! `reference-images/povray/` (made by POV-Ray 3.7). A scene may say in its own text
//!
//! ```text
//! //! options: -A=0.3 --aa-method 2
//! //! tolerance: 34 dB, because crackle's cells end where rounding says
//! //! golden: 3 of 255, because crand draws by pixel
//! ```
//!
//! how it is rendered (the picture options of `glint render`, `--alpha`, `-L`, `-D`, `--clock` and
//! `--includes`), how near it must come to POV-Ray's picture, with the reason, 38 dB otherwise, and how near
//! to Glint's own, 1 of 255 otherwise. `//! no reference: REASON` stands where POV-Ray cannot render the
//! scene. Without a folder of POV-Ray's pictures there is no comparison with them.

mod check;
mod header;
mod project;
mod report;

use super::args::{GoldenArgs, GoldenCommand};
use super::crosscheck::{Glint, NoPicture, Program, Rendering};
use super::exit::{Exit, Failure};
use super::in_order::{cores, in_order};
use super::{interrupt, json};
use crate::picture::Output;
use header::Header;
use project::{Entry, Project};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// A scene may take so long.
const LIMIT: Duration = Duration::from_secs(300);

pub fn run(command: &GoldenCommand) -> Result<Exit, Failure> {
    let (GoldenCommand::Check(args) | GoldenCommand::Bless(args) | GoldenCommand::Reference(args)) = command;
    let project = Project::find(args)?;
    let entries = project.entries(&args.names)?;
    interrupt::listen();
    match command {
        GoldenCommand::Check(_) => check::run(&project, &entries, args),
        GoldenCommand::Bless(_) => bless(&entries),
        GoldenCommand::Reference(_) => reference(&entries, args),
    }
}

/// What is said about a scene, and whether that is good.
type Verdict = Result<String, String>;

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
    message(glint.reading(entry.root()).picture(&entry.scene))
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
