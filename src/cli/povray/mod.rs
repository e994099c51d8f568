//! POV-Ray's command line: its switches, INI keywords and INI files, with its meanings.
//!
//! Sources in order, later ones override: the user's INI file, then the words as they were typed. What
//! changes nothing here is accepted with a note; what POV-Ray does not know is an error.

mod animation;
mod help;
mod in_glint;
mod naming;
mod notes;
mod settings;
mod table;
mod words;

use super::exit::{Exit, Failure};
use super::render::{Plan, RadiosityFiles, Task, pool, run_all};
use super::scene;
use super::streams::{Stream, Streams};
use crate::color::Gamma;
use crate::interp;
use crate::picture::{Dither, FileGamma, Output, Pixel};
use crate::render::{Antialias, Method, Region};
use animation::Animation;
pub use in_glint::InGlint;
use naming::FileType;
use settings::Settings;
use std::collections::BTreeSet;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

pub fn run(words: &[String]) -> Result<Exit, Failure> {
    if let Some(text) = help::asked_for(words) {
        super::json::print_text(&text)?;
        return Ok(Exit::Done);
    }
    let mut settings = Settings::default();
    if let Some(ini) = user_ini() {
        words::read_file(&mut settings, &ini, None, 0)?;
        settings.forget_who();
    }
    for word in words {
        words::apply(&mut settings, word)?;
    }
    let (plan, tasks) = (plan(&settings)?, tasks(&settings)?);
    for note in notes::of(&settings) {
        plan.streams.say(Stream::Render, &format!("note: {note}\n"));
    }
    if let Some(path) = settings.text("Create_Ini").filter(|p| !p.is_empty()) {
        Output::File(path.into()).write(settings.ini().as_bytes())?;
    }
    run_all(&plan, &tasks, false)
}

/// Whether an INI file may set something by this name.
pub fn is_keyword(name: &str) -> bool {
    table::TABLE.keyword(name.trim()).is_some()
}

/// The first of the files that POV-Ray reads without being asked.
fn user_ini() -> Option<PathBuf> {
    let named = std::env::var_os("POVINI").map(PathBuf::from);
    let home = std::env::var_os("HOME").map(|h| Path::new(&h).join(".povray/3.7/povray.ini"));
    let fixed = [PathBuf::from("povray.ini")];
    let system = [PathBuf::from("/etc/povray/3.7/povray.ini")];
    named.into_iter().chain(fixed).chain(home).chain(system).find(|p| p.is_file())
}

const DEFAULT_SIZE: (i64, i64) = (160, 120);

fn size(settings: &Settings) -> Result<(u32, u32), Failure> {
    let width = settings.int("Width").unwrap_or(DEFAULT_SIZE.0);
    let height = settings.int("Height").unwrap_or(DEFAULT_SIZE.1);
    let side = |n: i64| u32::try_from(n).ok().filter(|n| (1..=65535).contains(n));
    side(width)
        .zip(side(height))
        .ok_or_else(|| Failure::usage(format!("{width}x{height}: a side has 1 to 65535 pixels")))
}

fn plan(settings: &Settings) -> Result<Plan, Failure> {
    let (width, height) = size(settings)?;
    let threads = settings.int("Work_Threads").and_then(|n| usize::try_from(n).ok());
    let kind = FileType::of(settings)?;
    Ok(Plan {
        width,
        height,
        region: region(settings, width, height)?,
        antialias: antialias(settings),
        accuracy: None,
        block_size: settings
            .int("Render_Block_Size")
            .unwrap_or(32)
            .clamp(4, i64::from(width.max(height)).max(4)) as u32,
        quality: settings.int("Quality").unwrap_or(9).clamp(0, 9) as u8,
        overrides: Default::default(),
        accel: Default::default(),
        alpha: settings.flag("Output_Alpha", false),
        bits: kind.bits,
        grey: kind.grey,
        // As measured: black, also where the file has an alpha channel.
        untraced: Pixel::default(),
        file_gamma: file_gamma(settings)?,
        dither: dither(settings)?,
        radiosity: radiosity(settings),
        streams: streams(settings)?,
        partial: false,
        pool: pool(threads)?,
        command: Vec::new(),
        counted: Mutex::new(0.0),
    })
}

fn antialias(settings: &Settings) -> Option<Antialias> {
    if !settings.flag("Antialias", false) {
        return None;
    }
    let method = if settings.int("Sampling_Method") == Some(2) { Method::Recursive } else { Method::Grid };
    let defaults = Antialias::new(method, Gamma::Unmanaged);
    let depth = settings.int("Antialias_Depth").unwrap_or(i64::from(defaults.depth));
    let amount = settings.float("Jitter_Amount").unwrap_or(1.0).clamp(0.0, 1.0);
    Some(Antialias {
        threshold: settings
            .float("Antialias_Threshold")
            .map_or(defaults.threshold, |t| t.clamp(0.0, 1.0) as f32),
        depth: depth.clamp(1, i64::from(Antialias::MAX_DEPTH)) as u32,
        jitter: if settings.flag("Jitter", true) { amount } else { 0.0 },
        gamma: settings.float("Antialias_Gamma").unwrap_or(defaults.gamma),
        ..defaults
    })
}

fn file_gamma(settings: &Settings) -> Result<FileGamma, Failure> {
    let Some(text) = settings.text("File_Gamma") else { return Ok(FileGamma::Srgb) };
    if text.eq_ignore_ascii_case("srgb") {
        return Ok(FileGamma::Srgb);
    }
    let number = text.parse().ok().filter(|&g: &f64| g > 0.0);
    number
        .map(FileGamma::Power)
        .ok_or_else(|| Failure::usage(format!("File_Gamma={text}: expected sRGB or a positive number")))
}

fn dither(settings: &Settings) -> Result<Dither, Failure> {
    if !settings.flag("Dither", false) {
        return Ok(Dither::None);
    }
    let method = settings.text("Dither_Method").unwrap_or("FS");
    match method.to_ascii_uppercase().as_str() {
        "B2" => Ok(Dither::Bayer(2)),
        "B3" => Ok(Dither::Bayer(3)),
        "B4" => Ok(Dither::Bayer(4)),
        "D1" => Ok(Dither::Diffusion1),
        "D2" => Ok(Dither::Diffusion2),
        // Other names were refused where they were given.
        _ => Ok(Dither::FloydSteinberg),
    }
}

/// As measured: `All_Console` overrules the others, and a file that has no name of its own has the reference's.
fn streams(settings: &Settings) -> Result<Streams, Failure> {
    let all = settings.text("All_Console").map(|_| settings.flag("All_Console", true));
    let append = settings.flag("Append_File", false);
    let mut streams = Streams::new(false);
    let mut file = |stream, keyword: &str, usual: &str| {
        let Some(name) = settings.text(keyword) else { return Ok(()) };
        match name.to_ascii_lowercase().as_str() {
            "" | "on" | "yes" | "true" => streams.open(stream, Path::new(usual), append),
            "off" | "no" | "false" => Ok(()),
            _ => streams.open(stream, Path::new(name), append),
        }
    };
    file(None, "All_File", "alltext.out")?;
    file(Some(Stream::Debug), "Debug_File", "debug.out")?;
    file(Some(Stream::Warning), "Warning_File", "warning.out")?;
    file(Some(Stream::Fatal), "Fatal_File", "fatal.out")?;
    file(Some(Stream::Render), "Render_File", "render.out")?;
    file(Some(Stream::Statistic), "Statistic_File", "stats.out")?;
    let keywords =
        ["Debug_Console", "Warning_Console", "Fatal_Console", "Render_Console", "Statistic_Console"];
    for (stream, keyword) in Stream::ALL.into_iter().zip(keywords) {
        streams.set_console(stream, all.unwrap_or_else(|| settings.flag(keyword, true)));
    }
    Ok(streams)
}

/// The name is the reference's own where none is given.
fn radiosity(settings: &Settings) -> RadiosityFiles {
    let name = settings.text("Radiosity_File_Name").filter(|n| !n.is_empty()).unwrap_or("object.rca");
    let wanted = |keyword: &str| settings.flag(keyword, false).then(|| PathBuf::from(name));
    RadiosityFiles { load: wanted("Radiosity_From_File"), save: wanted("Radiosity_To_File") }
}

/// The part of the picture that is traced: rows and columns counted from 1, the last one included; numbers
/// below 1 are shares of the picture.
fn region(settings: &Settings, width: u32, height: u32) -> Result<Region, Failure> {
    let start = |keyword: &str, side: u32| match settings.float(keyword) {
        None => 0,
        Some(v) if v < 1.0 => (f64::from(side) * v.max(0.0)) as u32,
        Some(v) => v as u32 - 1,
    };
    let end = |keyword: &str, side: u32| match settings.float(keyword) {
        None => side,
        Some(v) if v <= 1.0 => (f64::from(side) * v.max(0.0)) as u32,
        Some(v) => v as u32,
    };
    let r = Region {
        x0: start("Start_Column", width),
        y0: start("Start_Row", height),
        x1: end("End_Column", width),
        y1: end("End_Row", height),
    };
    if r.x0 >= r.x1 || r.y0 >= r.y1 || r.x1 > width || r.y1 > height {
        return Err(Failure::usage(format!(
            "the part to render leaves the picture of {width}x{height}, or is empty"
        )));
    }
    Ok(r)
}

/// The scene, or its frames.
fn tasks(settings: &Settings) -> Result<Vec<Task>, Failure> {
    let Some(name) = settings.text("Input_File_Name").filter(|n| !n.is_empty()) else {
        return Err(Failure::usage("no scene was named: +Iscene.pov, or scene.pov alone"));
    };
    let scene = scene_file(settings, name);
    let options = options(settings)?;
    let kind = FileType::of(settings)?;
    let frames = Animation::of(settings)?.frames;
    let animated = frames.iter().any(|(_, digits)| !digits.is_empty());
    let task = |(frame, digits): (interp::Frame, String)| Task {
        scene: scene.clone(),
        target: naming::target(settings, name, kind, &digits),
        options: scene::Options {
            interp: interp::Options { frame, ..options.interp.clone() },
            ..options.clone()
        },
        siblings: [].into(),
        unfinished_apart: animated,
        resume: animated && settings.flag("Continue_Trace", false),
    };
    Ok(frames.into_iter().map(task).collect())
}

/// `.pov` may be left away; the library is searched after the current folder.
fn scene_file(settings: &Settings, name: &str) -> PathBuf {
    let folders = std::iter::once(PathBuf::new()).chain(settings.library.iter().cloned());
    let mut paths = folders.flat_map(|f| [f.join(name), f.join(format!("{name}.pov"))]);
    paths.find(|p| name != "-" && p.is_file()).unwrap_or_else(|| name.into())
}

fn options(settings: &Settings) -> Result<scene::Options, Failure> {
    let (width, height) = size(settings)?;
    let mut options = interp::Options {
        library_paths: settings.library.clone(),
        readable: settings.readable.clone(),
        writable: settings.writable.clone(),
        include_header: settings.text("Include_Header").map(PathBuf::from),
        start_version: settings.float("Version").map(|v| (v * 100.0 + 0.5) as u32),
        image_width: width,
        image_height: height,
        output_alpha: settings.flag("Output_Alpha", false),
        ..interp::Options::default()
    };
    let mut declared = BTreeSet::new();
    for (name, value) in &settings.declares {
        // The reference keeps the first.
        if !declared.insert(name) {
            continue;
        }
        let quoted = value.strip_prefix('"').and_then(|v| v.strip_suffix('"'));
        match (quoted, value.parse()) {
            (Some(text), _) => options.declared_strings.push((name.clone(), text.to_owned())),
            (None, Ok(number)) => options.declares.push((name.clone(), number)),
            (None, Err(_)) => {
                return Err(Failure::usage(format!(
                    "Declare={name}={value}: expected a number or a quoted text"
                )));
            }
        }
    }
    Ok(scene::Options {
        interp: options,
        strict: false,
        ascii: !std::io::stderr().is_terminal(),
        fingerprint: false,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn settings(line: &str) -> Settings {
        let mut settings = Settings::default();
        line.split_whitespace().for_each(|w| words::apply(&mut settings, w).unwrap());
        settings
    }

    /// As measured on 40 columns and 30 rows.
    #[test]
    fn parts_are_counted_as_the_reference_does() {
        let part = |line: &str| region(&settings(line), 40, 30).map(|r| (r.x0, r.x1, r.y0, r.y1));
        assert_eq!(part("").unwrap(), (0, 40, 0, 30));
        assert_eq!(part("+SC3 +EC10").unwrap(), (2, 10, 0, 30));
        assert_eq!(part("+SC0.25 +EC0.75 +SR0.25 +ER0.75").unwrap(), (10, 30, 7, 22));
        assert!(part("+SC41").is_err() && part("+SR9 +ER5").is_err());
    }

    #[test]
    fn letters_have_the_reference_meaning() {
        let plan = |line: &str| plan(&settings(line)).unwrap();
        assert!(plan("-A0.1 -D").antialias.is_none());
        let a = plan("+A +AM2 +R12 +J0.5 +AG1").antialias.unwrap();
        assert_eq!(
            (a.threshold, a.depth, a.jitter, a.gamma, a.method),
            (0.3, 9, 0.5, 1.0, Method::Recursive)
        );
        let p = plan("+Q11 +UA +FN16 File_Gamma=2.2 +BS16 +W64 +H48");
        assert_eq!(
            (p.quality, p.alpha, p.bits, p.file_gamma, p.block_size),
            (9, true, 16, FileGamma::Power(2.2), 16)
        );
        let silent = |line: &str, stream| !plan(line).streams.is_on_console(stream);
        assert!(
            Stream::ALL.iter().all(|&s| silent("-GA", s) && silent("-GA +GF", s) && !silent("-GF +GA", s))
        );
        let alone = |line: &str| Stream::ALL.into_iter().filter(|&s| silent(line, s)).collect::<Vec<_>>();
        assert_eq!(alone("-GD"), [Stream::Debug]);
        assert_eq!(alone("Warning_Console=off -GR"), [Stream::Warning, Stream::Render]);
        assert_eq!(alone("-GS -GF"), [Stream::Fatal, Stream::Statistic]);
    }

    #[test]
    fn declarations_may_be_texts() {
        let mut s = settings("Declare=a=1.5");
        s.set("Declare", "b=\"x\"").unwrap();
        let o = options(&s).unwrap().interp;
        assert_eq!(o.declares, [("a".to_owned(), 1.5)]);
        assert_eq!(o.declared_strings, [("b".to_owned(), "x".to_owned())]);
    }
}
