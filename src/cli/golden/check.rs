//! `glint golden check`: what changed, with pictures.

use super::header::Header;
use super::project::{Entry, Project};
use super::{glint, report, stopped};
use crate::cli::args::GoldenArgs;
use crate::cli::compare::decibels;
use crate::cli::exit::{Exit, Failure};
use crate::cli::in_order::{cores, in_order};
use crate::cli::json;
use crate::picture::Output;
use crate::picture::compare::{Difference, compare, difference_image, png_bytes};
use crate::picture::load::{Values, from_bytes};
use std::path::Path;

/// What was found about a scene, or about a picture without one.
pub struct Finding {
    pub name: String,
    /// What is well, or what is wrong.
    pub said: Result<String, String>,
    /// The stored picture, the new one and their difference, where they differ too much.
    pub pictures: Option<[Vec<u8>; 3]>,
}

impl Finding {
    fn of(entry: &Entry, said: Result<String, String>) -> Finding {
        Finding { name: entry.name.clone(), said, pictures: None }
    }

    fn line(&self) -> String {
        let (word, said) = match &self.said {
            Ok(said) => ("ok", said),
            Err(said) => ("FAILED", said),
        };
        format!("{word:<8}{}: {said}\n", self.name)
    }
}

pub fn run(project: &Project, entries: &[Entry], args: &GoldenArgs) -> Result<Exit, Failure> {
    // A reader that has gone away does not stop the work.
    let show = |_: &Entry, finding: &Finding| drop(json::print_text(&finding.line()));
    let look = |entry: &Entry| {
        examine(project, entry).unwrap_or_else(|complaint| Finding::of(entry, Err(complaint)))
    };
    let mut findings = in_order(entries, cores(), look, show);
    if args.names.is_empty() {
        for orphan in project.orphans(entries)? {
            let said = Err("no scene owns this picture".to_owned());
            findings.push(Finding { name: orphan.display().to_string(), said, pictures: None });
            json::print_text(&findings[findings.len() - 1].line())?;
        }
    }
    if let Some(path) = &args.report {
        Output::File(path.clone()).write(report::page(&findings).as_bytes())?;
    }
    stopped()?;
    let failed = findings.iter().filter(|f| f.said.is_err()).count();
    if failed == 0 {
        eprintln!("{} scenes match their pictures", entries.len());
        return Ok(Exit::Done);
    }
    Err(Failure::failed(format!("{failed} complaints about {} scenes", entries.len())))
}

fn examine(project: &Project, entry: &Entry) -> Result<Finding, String> {
    let header = Header::of(&entry.scene.path)?;
    let png = glint(entry, &header)?.png;
    if !entry.golden.is_file() {
        return Err(format!("there is no picture yet: `glint golden bless {}` makes it", entry.name));
    }
    let golden = Stored::read(&entry.golden, &png)?;
    if golden.difference.max_abs > header.max_steps {
        let said = format!(
            "differs from Glint's earlier picture: PSNR {} dB, largest difference {} of 255",
            decibels(golden.difference.psnr_db),
            golden.difference.max_abs
        );
        return golden.complaint(project, entry, png, &said);
    }
    let mut said = format!("golden {}", decibels(golden.difference.psnr_db));
    if let Some(min) = header.min_psnr.filter(|_| project.has_reference()) {
        let povray = Stored::read(&entry.povray, &png)?;
        let psnr = decibels(povray.difference.psnr_db);
        if !povray.difference.reaches(min) {
            let said = format!("differs from POV-Ray's picture: PSNR {psnr} dB, below {min} dB");
            return povray.complaint(project, entry, png, &said);
        }
        said.push_str(&format!(", povray {psnr}"));
    }
    Ok(Finding::of(entry, Ok(said)))
}

/// A stored picture beside the new one.
struct Stored {
    png: Vec<u8>,
    values: [Values; 2],
    difference: Difference,
}

impl Stored {
    fn read(path: &Path, new: &[u8]) -> Result<Stored, String> {
        let place = |e: &dyn std::fmt::Display| format!("{}: {e}", path.display());
        let png = std::fs::read(path).map_err(|e| place(&e))?;
        let values = [from_bytes(&png).map_err(|e| place(&e))?, from_bytes(new)?];
        let difference = compare(&values[0], &values[1])?;
        Ok(Stored { png, values, difference })
    }

    /// Keeps the pictures where they can be looked at.
    fn complaint(
        self,
        project: &Project,
        entry: &Entry,
        new: Vec<u8>,
        said: &str,
    ) -> Result<Finding, String> {
        let difference = png_bytes(&difference_image(&self.values[0], &self.values[1])?)?;
        let trace = project.leave_evidence(entry, &new, &difference)?;
        let said = Err(format!("{said}; see {}", trace.display()));
        Ok(Finding { pictures: Some([self.png, new, difference]), ..Finding::of(entry, said) })
    }
}
