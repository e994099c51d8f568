//! Glint's side: this very program, as a process of its own.

use super::process::{self, Ending, Finished};
use super::scenes::Scene;
use super::{NoPicture, Rendering, Request, Status};
use crate::cli::exit::{Exit, Failure};
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

pub struct Glint {
    program: PathBuf,
    request: Request,
    limit: Duration,
    folder: Temporary,
    keep: Option<PathBuf>,
    /// Scenes may read here, as they might if they were rendered from here.
    readable: Option<PathBuf>,
}

impl Glint {
    /// `keep` is a folder that gets a copy of each picture.
    pub fn new(request: &Request, limit: Duration, keep: Option<PathBuf>) -> Result<Self, Failure> {
        let program = std::env::current_exe();
        Ok(Self {
            program: program.map_err(|e| Failure::unavailable(format!("this program's own file: {e}")))?,
            request: request.clone(),
            limit,
            folder: Temporary::new("glint")?,
            keep,
            readable: std::env::current_dir().ok(),
        })
    }

    /// Scenes may read in this folder, and no longer in the working folder.
    pub fn reading(self, folder: Option<&Path>) -> Self {
        Self { readable: folder.map(Path::to_owned), ..self }
    }

    pub fn picture(&self, scene: &Scene) -> Result<Rendering, NoPicture> {
        let output = self.folder.file("png");
        let done = process::run(&mut self.command(scene, &output), self.limit);
        let done = done.map_err(|e| NoPicture { status: Status::Crash, message: e.to_string() })?;
        judge(&done, self.limit)?;
        let png = std::fs::read(&output);
        let png =
            png.map_err(|e| NoPicture { status: Status::Crash, message: format!("no picture: {e}") })?;
        let _ = std::fs::remove_file(&output);
        self.keep(scene, &png);
        let report: Value = serde_json::from_slice(&done.stdout).unwrap_or_default();
        let unsupported = report["unsupported"].as_array().map_or(&[][..], Vec::as_slice);
        Ok(Rendering {
            png,
            parse_cpu_s: report["parse_cpu_s"].as_f64(),
            prepare_cpu_s: report["prepare_cpu_s"].as_f64(),
            trace_cpu_s: report["trace_cpu_s"].as_f64(),
            unsupported: unsupported.iter().filter_map(|f| f.as_str().map(String::from)).collect(),
        })
    }

    fn command(&self, scene: &Scene, output: &Path) -> Command {
        let mut command = Command::new(&self.program);
        command.current_dir(scene.folder()).env("NO_COLOR", "1").arg("render").arg(scene.file_name());
        command.arg("-o").arg(output).args(self.request.glint());
        if let Some(folder) = &self.readable {
            command.arg("--allow-read").arg(folder);
        }
        command
    }

    /// Copies the picture to the folder that was asked for. A copy that fails is no reason to stop.
    fn keep(&self, scene: &Scene, png: &[u8]) {
        let Some(folder) = &self.keep else { return };
        let path = folder.join(Path::new(&scene.name).with_extension("png"));
        let written =
            path.parent().map_or(Ok(()), std::fs::create_dir_all).and_then(|()| std::fs::write(&path, png));
        if let Err(error) = written {
            eprintln!("warning: {}: {error}", path.display());
        }
    }
}

/// Whether the process ended well.
fn judge(done: &Finished, limit: Duration) -> Result<(), NoPicture> {
    let (status, message) = match &done.ending {
        Ending::TimedOut => (Status::Timeout, format!("stopped after {} s", limit.as_secs_f64())),
        Ending::Interrupted => (Status::Timeout, "interrupted".into()),
        Ending::Exited(s) if s.success() => return Ok(()),
        Ending::Exited(s) => {
            let refused = |e: Exit| s.code() == Some(i32::from(e.code()));
            let text = String::from_utf8_lossy(&done.stderr).into_owned();
            if refused(Exit::Failed) && !text.contains("internal error") || refused(Exit::Unavailable) {
                (Status::Error, first_error(&text))
            } else {
                (Status::Crash, format!("{s}: {}", panic_message(&text)))
            }
        }
    };
    Err(NoPicture { status, message })
}

/// The first error's message with its place.
fn first_error(text: &str) -> String {
    let mut lines = text.lines().skip_while(|l| !l.starts_with("error"));
    let message = lines.next().unwrap_or("no message").trim_start_matches("error: ").to_owned();
    let place = lines.next().and_then(|l| l.split_once("┌─ ")).map(|(_, place)| place.trim().to_owned());
    place.map_or(message.clone(), |place| format!("{message} ({place})"))
}

/// What a panic says, without the thread's name.
fn panic_message(text: &str) -> String {
    let mut lines =
        text.lines().skip_while(|l| !l.contains("panicked at") && !l.contains("overflowed its stack"));
    let place = lines.next().unwrap_or_default();
    let place = place.split_once("panicked at ").map_or(place, |(_, place)| place);
    format!("{place} {}", lines.next().unwrap_or_default()).trim().to_owned()
}

/// A folder that goes when it is no longer needed.
pub struct Temporary {
    path: PathBuf,
    files: AtomicUsize,
}

impl Temporary {
    pub fn new(name: &str) -> Result<Self, Failure> {
        static FOLDERS: AtomicUsize = AtomicUsize::new(0);
        let n = FOLDERS.fetch_add(1, Ordering::Relaxed);
        let path = std::env::temp_dir().join(format!("glint-crosscheck-{name}-{}-{n}", std::process::id()));
        let made = std::fs::create_dir_all(&path);
        made.map_err(|e| Failure::unavailable(format!("{}: {e}", path.display())))?;
        Ok(Self { path, files: 0.into() })
    }

    /// A new file name in the folder.
    pub fn file(&self, extension: &str) -> PathBuf {
        let n = self.files.fetch_add(1, Ordering::Relaxed);
        self.path.join(format!("{n}.{extension}"))
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.path);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_are_found_in_the_text() {
        let text = "warning: w\nerror: unknown word `spere`\n  ┌─ a.pov:2:3\n  │\n";
        assert_eq!(first_error(text), "unknown word `spere` (a.pov:2:3)");
        assert_eq!(first_error("error: a.pov: no such file\n"), "a.pov: no such file");
    }

    #[test]
    fn panics_are_found_in_the_text() {
        let text = "thread 'scene' (12) panicked at src/a.rs:3:5:\nindex out of bounds\nnote: run with\n";
        assert_eq!(panic_message(text), "src/a.rs:3:5: index out of bounds");
        assert_eq!(
            panic_message("thread 'scene' has overflowed its stack\n"),
            "thread 'scene' has overflowed its stack"
        );
    }
}
