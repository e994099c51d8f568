//! POV-Ray's side: its pictures, made now, kept from an earlier check, or stored in a folder.

use super::cache::{Cache, Entry};
use super::glint::Temporary;
use super::process::{self, Ending};
use super::scenes::Scene;
use super::{NoPicture, Rendering, Request, Status};
use crate::cli::args::CrosscheckArgs;
use crate::cli::exit::Failure;
use std::path::{Component, Path, PathBuf};
use std::process::Command;
use std::time::Duration;

/// A source of POV-Ray's pictures.
pub enum Reference {
    /// Pictures by the scene's path.
    Stored(PathBuf),
    Program(Box<Program>),
}

impl Reference {
    pub fn new(args: &CrosscheckArgs, request: &Request) -> Result<Self, Failure> {
        match &args.reference {
            Some(folder) if folder.is_dir() => Ok(Reference::Stored(folder.clone())),
            Some(folder) => Err(Failure::unavailable(format!(
                "--reference {}: there is no such folder",
                folder.display()
            ))),
            None => {
                let limit = super::seconds(args.povray_timeout, "--povray-timeout")?;
                let cache = (!args.no_cache).then(|| Cache::new(args.cache.as_deref()));
                Ok(Reference::Program(Box::new(Program::new(&args.povray, request, limit, cache)?)))
            }
        }
    }

    pub fn picture(&self, scene: &Scene) -> Result<Rendering, NoPicture> {
        match self {
            Reference::Stored(folder) => stored(folder, scene),
            Reference::Program(program) => program.picture(scene),
        }
    }
}

fn failed(message: impl Into<String>) -> NoPicture {
    NoPicture { status: Status::ReferenceFailed, message: message.into() }
}

/// The stored picture of a scene: the longest end of its path that leads to one.
fn stored(folder: &Path, scene: &Scene) -> Result<Rendering, NoPicture> {
    let picture = scene.path.with_extension("png");
    let named = Path::new(&scene.name).with_extension("png");
    let mut parts: Vec<_> = picture.components().filter(|c| matches!(c, Component::Normal(_))).collect();
    let mut candidates = vec![folder.join(named)];
    while !parts.is_empty() {
        candidates.push(folder.join(parts.iter().collect::<PathBuf>()));
        parts.remove(0);
    }
    let path = candidates.into_iter().find(|p| p.is_file());
    let path = path.ok_or_else(|| failed(format!("no picture in {}", folder.display())))?;
    let png = std::fs::read(&path).map_err(|e| failed(format!("{}: {e}", path.display())))?;
    Ok(Rendering { png, parse_cpu_s: None, prepare_cpu_s: None, trace_cpu_s: None, unsupported: Vec::new() })
}

/// The installed program.
pub struct Program {
    program: PathBuf,
    version: String,
    request: Request,
    limit: Duration,
    folder: Temporary,
    cache: Option<Cache>,
}

impl Program {
    pub fn new(
        program: &Path,
        request: &Request,
        limit: Duration,
        cache: Option<Cache>,
    ) -> Result<Self, Failure> {
        Ok(Self {
            program: program.to_owned(),
            version: version(program)?,
            request: request.clone(),
            limit,
            folder: Temporary::new("povray")?,
            cache,
        })
    }

    pub fn picture(&self, scene: &Scene) -> Result<Rendering, NoPicture> {
        let options = self.request.povray();
        let key =
            self.cache.as_ref().map(|c| c.key(scene, &[&[self.version.clone()][..], &options].concat()));
        let kept = self.cache.as_ref().zip(key.as_deref()).and_then(|(cache, key)| cache.get(key));
        if let Some(entry) = kept {
            return entry.into_rendering();
        }
        let entry = self.render(scene, &options)?;
        if let Some((cache, key)) = self.cache.as_ref().zip(key) {
            cache.put(&key, &entry);
        }
        entry.into_rendering()
    }

    fn render(&self, scene: &Scene, options: &[String]) -> Result<Entry, NoPicture> {
        let output = self.folder.file("png");
        let mut command = Command::new(&self.program);
        command.current_dir(scene.folder()).arg(format!("+I{}", scene.file_name().to_string_lossy()));
        command.arg(format!("+O{}", output.display())).args(options);
        let done = process::run(&mut command, self.limit).map_err(|e| failed(e.to_string()))?;
        let text = String::from_utf8_lossy(&done.stderr);
        match done.ending {
            Ending::TimedOut => Err(failed(format!("stopped after {} s", self.limit.as_secs_f64()))),
            Ending::Interrupted => Err(failed("interrupted")),
            Ending::Exited(status) if status.success() => {
                let png = std::fs::read(&output).map_err(|e| failed(format!("no picture: {e}")))?;
                let _ = std::fs::remove_file(&output);
                Ok(Entry { png: Some(png), message: String::new(), times: Times::of(&text) })
            }
            Ending::Exited(_) => Ok(Entry { png: None, message: error_of(&text), times: Times::default() }),
        }
    }
}

impl Entry {
    fn into_rendering(self) -> Result<Rendering, NoPicture> {
        let Some(png) = self.png else { return Err(failed(self.message)) };
        Ok(Rendering {
            png,
            parse_cpu_s: self.times.parse,
            prepare_cpu_s: self.times.bounding,
            trace_cpu_s: self.times.trace,
            unsupported: Vec::new(),
        })
    }
}

/// The first line about itself that the program prints.
fn version(program: &Path) -> Result<String, Failure> {
    let done = process::run(Command::new(program).arg("--version"), Duration::from_secs(20));
    let done = done.map_err(|e| {
        Failure::unavailable(format!(
            "{}: {e}; name POV-Ray's program with --povray, or a folder of its pictures with --reference",
            program.display()
        ))
    })?;
    let text = [done.stdout, done.stderr].concat();
    let text = String::from_utf8_lossy(&text);
    Ok(text
        .lines()
        .find(|l| l.contains("Version") || l.contains("POV-Ray"))
        .unwrap_or_default()
        .trim()
        .to_owned())
}

/// CPU seconds that POV-Ray's statistics name.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Times {
    pub parse: Option<f64>,
    pub bounding: Option<f64>,
    /// With photons and radiosity.
    pub trace: Option<f64>,
}

impl Times {
    /// Each time's line is followed by one with the CPU seconds.
    pub fn of(text: &str) -> Times {
        let mut times = Times::default();
        let mut part = "";
        for line in text.split(['\n', '\r']).map(str::trim) {
            if let Some((name, _)) = line.split_once(" Time:") {
                part = name;
            } else if let Some(seconds) = cpu_seconds(line) {
                match part {
                    "Parse" => times.parse = Some(seconds),
                    "Bounding" => times.bounding = Some(seconds),
                    "Trace" | "Photon" | "Radiosity" => {
                        times.trace = Some(times.trace.unwrap_or(0.0) + seconds);
                    }
                    _ => {}
                }
            }
        }
        times
    }
}

/// `using 1 thread(s) with 0.007 CPU-seconds total`
fn cpu_seconds(line: &str) -> Option<f64> {
    let (before, _) = line.split_once(" CPU-seconds")?;
    before.rsplit(' ').next()?.parse().ok()
}

/// What POV-Ray objected to; its messages are broken into lines.
fn error_of(text: &str) -> String {
    let flat = text.split(['\n', '\r']).collect::<Vec<_>>().join(" ");
    let start = ["Parse Error:", "Fatal error", "Fatal Error"].iter().filter_map(|p| flat.find(p)).min();
    let message = start.map_or("POV-Ray failed", |at| &flat[at..]);
    let end = message.char_indices().nth(160).map_or(message.len(), |(i, _)| i);
    message[..end].split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_read_from_the_statistics() {
        let text = "Parser Time\n  Parse Time:       0 hours  0 minutes  0 seconds (0.701 seconds)\n\
                    \x20             using 1 thread(s) with 0.690 CPU-seconds total\n\
                    \x20 Bounding Time:    0 hours  0 minutes  0 seconds (0.020 seconds)\n\
                    \x20             using 1 thread(s) with 0.020 CPU-seconds total\n\
                    Render Time:\n  Photon Time:      No photons\n\
                    \x20 Radiosity Time:   0 hours  0 minutes  0 seconds (0.500 seconds)\n\
                    \x20             using 1 thread(s) with 0.500 CPU-seconds total\n\
                    \x20 Trace Time:       0 hours  0 minutes  1 seconds (1.010 seconds)\n\
                    \x20             using 1 thread(s) with 1.007 CPU-seconds total\n";
        let times = Times::of(text);
        assert_eq!((times.parse, times.bounding), (Some(0.69), Some(0.02)));
        assert!((times.trace.unwrap() - 1.507).abs() < 1e-9);
        assert_eq!(Times::of("POV-Ray finished"), Times::default());
    }

    #[test]
    fn errors_are_read_from_the_text() {
        let text = "==== [Parsing...] ====\nFile 'a.pov' line 19: Parse Error: Cannot open include file\n x.inc.\nFatal";
        assert!(error_of(text).starts_with("Parse Error: Cannot open include file x.inc."));
        assert_eq!(error_of(""), "POV-Ray failed");
    }
}
