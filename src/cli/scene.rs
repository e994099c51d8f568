//! Scene text to a scene, with all that is said about it.

use super::args::{Includes, SceneArgs, Strict};
use super::diagnostic;
use super::exit::Failure;
use super::streams::{Stream, Streams};
use crate::interp::{self, IncludeMode, Limits, Outcome, SceneSource};
use crate::scene::Scene;
use crate::source::{Diagnostic, Files};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::Read;
use std::path::{Path, PathBuf};

/// How scenes are read, the same for all scenes of a batch.
#[derive(Clone, Debug)]
pub struct Options {
    pub interp: interp::Options,
    /// Features that are not rendered yet are errors.
    pub strict: bool,
    /// Whoever reads the diagnostics decodes them as ASCII.
    pub ascii: bool,
    /// Whether somebody wants [`Parsed::fingerprint`].
    pub fingerprint: bool,
}

impl Options {
    pub fn new(args: &SceneArgs, width: u32, height: u32) -> Result<Options, Failure> {
        let mut options = interp::Options {
            library_paths: args.library.clone(),
            readable: args.allow_read.clone(),
            writable: args.allow_write.clone(),
            includes: match args.includes {
                Includes::Auto => IncludeMode::Auto,
                Includes::Embedded => IncludeMode::Embedded,
                Includes::Installed => IncludeMode::Installed,
            },
            image_width: width,
            image_height: height,
            ..interp::Options::default()
        };
        let named =
            [("-L", &args.library), ("--allow-read", &args.allow_read), ("--allow-write", &args.allow_write)];
        for (option, folders) in named {
            must_exist(option, folders)?;
        }
        for text in &args.declare {
            options.declares.push(declaration(text)?);
        }
        for text in &args.limit {
            set_limit(&mut options.limits, text)?;
        }
        options.strict = args.strict.contains(&Strict::Reference);
        options.frame.clock = args.clock as f32;
        options.frame.clock_on = args.clock != 0.0;
        let strict = args.strict.contains(&Strict::Features);
        Ok(Options { interp: options, strict, ascii: false, fingerprint: false })
    }
}

/// Folders named on the command line.
pub fn must_exist(option: &str, folders: &[PathBuf]) -> Result<(), Failure> {
    match folders.iter().find(|f| !f.is_dir()) {
        None => Ok(()),
        Some(folder) => {
            Err(Failure::unavailable(format!("{option} {}: there is no such folder", folder.display())))
        }
    }
}

/// `NAME=VALUE`.
fn declaration(text: &str) -> Result<(String, f64), Failure> {
    let wrong =
        || Failure::usage(format!("-D {text}: expected NAME=VALUE with a number, such as -D Detail=3"));
    let (name, value) = text.split_once('=').ok_or_else(wrong)?;
    let (name, value) = (name.trim(), value.trim().parse().map_err(|_| wrong())?);
    let letters = |c: char| c == '_' || c.is_ascii_alphanumeric();
    if name.is_empty() || name.starts_with(|c: char| c.is_ascii_digit()) || !name.chars().all(letters) {
        return Err(wrong());
    }
    Ok((name.to_owned(), value))
}

/// `NAME=N`.
fn set_limit(limits: &mut Limits, text: &str) -> Result<(), Failure> {
    let known = text.split_once('=').and_then(|(name, value)| {
        let value = value.trim().parse().ok()?;
        limits.set(name.trim(), value).then_some(())
    });
    known.ok_or_else(|| {
        let names = Limits::NAMES.join(", ");
        Failure::usage(format!("--limit {text}: expected NAME=N with N from 1, and one of the names {names}"))
    })
}

/// A scene that was read.
pub struct Parsed {
    pub scene: Scene,
    /// One line each: place and message.
    pub warnings: Vec<String>,
    pub unsupported: Vec<String>,
    /// Files that the scene includes or reads as text: where each was taken from.
    pub includes: Vec<String>,
    /// Of all text that was read, and of what the scene was told; 0 if nobody asked for it.
    pub fingerprint: u64,
}

/// Reads a scene; it and what is wrong with it speak to the streams.
pub fn parse(path: &Path, options: &Options, streams: &Streams) -> Result<Parsed, Failure> {
    let outcome = interp::interpret(source(path)?, &options.interp);
    let Outcome { scene, files, warnings, unsupported, debug } = outcome;
    streams.say(Stream::Debug, &debug);
    show_all(&warnings, &files, options.ascii, streams);
    let scene = scene.map_err(|error| {
        streams.show(&error, &files, options.ascii);
        Failure::reported(diagnostic::line(&error, &files))
    })?;
    if options.strict && !unsupported.is_empty() {
        return Err(Failure::failed(format!(
            "{}: not rendered yet: {} (an error with --strict)",
            path.display(),
            unsupported.join(", ")
        )));
    }
    let warnings = warnings.iter().map(|w| diagnostic::line(w, &files)).collect();
    let fingerprint = if options.fingerprint { fingerprint(&files, &options.interp) } else { 0 };
    let includes =
        files.names().skip(1).map(|(name, path)| origin(name, path.map(PathBuf::as_path))).collect();
    Ok(Parsed { scene, warnings, unsupported, includes, fingerprint })
}

/// `colors.inc: embedded` or `colors.inc: /usr/share/…/colors.inc`.
fn origin(name: &str, path: Option<&Path>) -> String {
    let file = Path::new(name).file_name().map_or(name.into(), |f| f.to_string_lossy());
    match path {
        Some(path) => format!("{file}: {}", path.display()),
        None => format!("{file}: embedded in Glint"),
    }
}

fn fingerprint(files: &Files, told: &interp::Options) -> u64 {
    let mut hasher = DefaultHasher::new();
    env!("CARGO_PKG_VERSION").hash(&mut hasher);
    for text in files.texts() {
        text.hash(&mut hasher);
    }
    for (name, value) in &told.declares {
        (name, value.to_bits()).hash(&mut hasher);
    }
    told.frame.clock.to_bits().hash(&mut hasher);
    hasher.finish()
}

fn source(path: &Path) -> Result<SceneSource, Failure> {
    if path == Path::new("-") {
        let mut text = Vec::new();
        let read = std::io::stdin().lock().read_to_end(&mut text);
        read.map_err(|e| Failure::unavailable(format!("standard input: {e}")))?;
        return Ok(SceneSource::Text { name: "<stdin>".into(), text });
    }
    match std::fs::File::open(path).and_then(|f| f.metadata()) {
        Ok(data) if data.is_dir() => {
            Err(Failure::unavailable(format!("{}: this is a folder", path.display())))
        }
        Ok(_) => Ok(SceneSource::Path(path.to_owned())),
        Err(error) => Err(Failure::unavailable(format!("{}: {error}", path.display()))),
    }
}

/// At most this many warnings of one scene are drawn.
const MAX_WARNINGS: usize = 50;

fn show_all(warnings: &[Diagnostic], files: &Files, ascii: bool, streams: &Streams) {
    for warning in warnings.iter().take(MAX_WARNINGS) {
        streams.show(warning, files, ascii);
    }
    if warnings.len() > MAX_WARNINGS {
        let rest = format!("... and {} more warnings\n", warnings.len() - MAX_WARNINGS);
        streams.say(Stream::Warning, &rest);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_are_set_by_name() {
        let mut limits = Limits::default();
        set_limit(&mut limits, "calls=20").unwrap();
        set_limit(&mut limits, "seconds = 2.5").unwrap();
        assert_eq!((limits.symbol_tables, limits.seconds), (22, 2.5));
        for name in Limits::NAMES {
            set_limit(&mut limits, &format!("{name}=7")).unwrap();
        }
        for wrong in ["calls", "calls=0", "depth=3", "calls=x", "seconds=inf"] {
            assert!(set_limit(&mut limits, wrong).unwrap_err().message.contains("NAME=N"), "{wrong}");
        }
    }

    #[test]
    fn declarations_are_names_with_numbers() {
        assert_eq!(declaration("Detail=3.5").unwrap(), ("Detail".into(), 3.5));
        for wrong in ["Detail", "=3", "3d=1", "a b=1", "a=x"] {
            assert!(declaration(wrong).unwrap_err().message.contains("NAME=VALUE"), "{wrong}");
        }
    }
}
