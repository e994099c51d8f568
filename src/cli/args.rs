//! What was typed.

use super::render::{parse_error, parse_seconds};
use clap::builder::PossibleValuesParser;
use clap::{Args, Parser, Subcommand, ValueEnum};
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  glint scene.pov                        render to scene.png in the current folder
  glint render scene.pov -W 1920 -H 1080 -A -o big.png
  glint check --json scene.pov           parse and prepare only
  glint compare a.png b.png --diff d.png
  glint crosscheck scenes/ --report report.html
  glint trade scene.pov --budget 60s --report trade.html

Exit codes: 0 done, 1 a scene was wrong or a comparison fell short, 2 usage, 3 a file or a needed
program cannot be read, written or found, 130 after Ctrl-C.

Words that begin with `+`, .ini files, `glint pov …` or a link named `povray` switch to POV-Ray's
command-line syntax.";

/// A batch ray tracer driven by POV-Ray's scene language
#[derive(Parser, Debug)]
#[command(name = "glint", version, after_help = EXAMPLES, max_term_width = 100)]
pub struct Cli {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Subcommand, Debug)]
#[allow(clippy::large_enum_variant)] // There is one in a process.
pub enum Command {
    /// Render scenes to pictures (the default command)
    Render(Box<RenderArgs>),
    /// Parse and prepare scenes without rendering them
    Check(CheckArgs),
    /// Say what a scene required and what was built for it
    Explain(ExplainArgs),
    /// Measure how far two pictures are apart
    Compare(CompareArgs),
    /// Render scenes with POV-Ray and with Glint and compare the pictures
    Crosscheck(CrosscheckArgs),
    /// Measure what each setting costs for a scene, and what error it leaves
    Trade(TradeArgs),
    /// Compare the project's scenes with their stored pictures
    #[command(subcommand)]
    Golden(GoldenCommand),
    /// Print a shell's completion script
    Completions(CompletionsArgs),
}

/// The names of all subcommands, for telling `glint SCENE` from `glint COMMAND`.
pub const COMMANDS: &[&str] =
    &["render", "check", "explain", "compare", "crosscheck", "trade", "golden", "completions", "help"];

/// How scene text is found and read.
#[derive(Args, Clone, Debug, Default)]
pub struct SceneArgs {
    /// A folder in which included files are looked for; may be repeated
    #[arg(short = 'L', long = "library", value_name = "DIR")]
    pub library: Vec<PathBuf>,
    /// A folder that scenes may read, besides their own, the working folder and libraries; may be repeated
    #[arg(long, value_name = "DIR")]
    pub allow_read: Vec<PathBuf>,
    /// A folder that scenes may write (and read), besides their own and the working folder; may be repeated
    #[arg(long, value_name = "DIR")]
    pub allow_write: Vec<PathBuf>,
    /// Declare a number before the scene begins; may be repeated
    #[arg(short = 'D', long = "declare", value_name = "NAME=VALUE")]
    pub declare: Vec<String>,
    /// The value of `clock`
    #[arg(long, value_name = "X", default_value_t = 0.0, allow_negative_numbers = true)]
    pub clock: f64,
    /// Where standard include files come from
    #[arg(long, value_enum, default_value_t, value_name = "SOURCE")]
    pub includes: Includes,
    /// Refuse more: features that are not rendered yet, or whatever POV-Ray refuses
    #[arg(long, value_enum, value_name = "WHAT", num_args = 0..=1, require_equals = true, default_missing_value = "features")]
    pub strict: Vec<Strict>,
    /// How far a scene may go: includes, calls, blocks, nesting, tokens, passes, elements, written (MB), seconds,
    /// memory (MB); may be repeated
    #[arg(long, value_name = "NAME=N")]
    pub limit: Vec<String>,
}

/// What is refused though it could be read.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum Strict {
    /// Features that are not rendered yet
    Features,
    /// What POV-Ray refuses for a reason that helps nobody: a newer `#version`, a missing `;`, the case of a file's name
    Reference,
}

/// Where standard include files come from.
#[derive(ValueEnum, Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Includes {
    /// POV-Ray's own if they are installed, else the embedded ones
    #[default]
    Auto,
    /// Only the embedded ones
    Embedded,
    /// Only POV-Ray's own
    Installed,
}

/// The picture's size and how finely it is sampled.
#[derive(Args, Clone, Debug)]
pub struct PictureArgs {
    /// Width of the picture
    #[arg(short = 'W', long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(1..=65535))]
    pub width: Option<u32>,
    /// Height of the picture
    #[arg(short = 'H', long, value_name = "PIXELS", value_parser = clap::value_parser!(u32).range(1..=65535))]
    pub height: Option<u32>,
    /// Anti-aliasing; the smaller the threshold, the finer: 0.3, the default, aims at an error of 0.01 (40 dB)
    #[arg(
        short = 'A',
        long = "antialias",
        value_name = "THRESHOLD",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = "0.3"
    )]
    pub antialias: Option<f32>,
    /// How pixels are sampled [default: adaptive; 1 for crosscheck]
    #[arg(long, value_name = "adaptive|1|2", hide_possible_values = true)]
    pub aa_method: Option<AaMethod>,
    /// Samples along a pixel's side (method 1), or levels of division (method 2)
    #[arg(long, value_name = "N", default_value_t = 3, value_parser = clap::value_parser!(u32).range(1..=9))]
    pub aa_depth: u32,
    /// Shake anti-aliasing samples
    #[arg(long, value_name = "on|off", default_value = "on", value_parser = PossibleValuesParser::new(["on", "off"]))]
    pub jitter: String,
    /// 0 (flat colours) to 11 (everything)
    #[arg(long, value_name = "0..11", default_value_t = 11, value_parser = clap::value_parser!(u8).range(0..=11))]
    pub quality: u8,
    /// Threads that trace [default: one per core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
}

/// How pixels are sampled.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum AaMethod {
    /// Samples go where they take most error away
    Adaptive,
    /// A fixed grid where neighbours differ, as in POV-Ray
    #[value(name = "1")]
    Grid,
    /// Quarters of quarters where corners differ, as in POV-Ray
    #[value(name = "2")]
    Recursive,
}

/// How good a picture is to be, and what it may cost. Any of these makes sampling adaptive.
#[derive(Args, Clone, Copy, Debug, Default)]
pub struct AccuracyArgs {
    /// Sample until the picture's error is expected to be no larger: an RMSE in light clipped to 0..1, or
    /// decibels (40dB)
    #[arg(long, value_name = "X", value_parser = parse_error)]
    pub max_error: Option<f64>,
    /// Make the best picture that can be finished in this time: 10, 10s, 1.5min
    #[arg(long, value_name = "T", value_parser = parse_seconds)]
    pub time_limit: Option<f64>,
    /// Take no more samples for the whole picture
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub max_samples: Option<u64>,
    /// Samples that every pixel gets before any gets more; a power of two
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1 << 16))]
    pub min_samples: Option<u32>,
    /// Which random numbers are drawn
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub seed: u32,
}

/// What replaces words of the scene.
#[derive(Args, Clone, Copy, Debug, Default)]
pub struct OverrideArgs {
    /// Instead of the scene's max_trace_level
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=256))]
    pub trace_level: Option<u32>,
    /// Instead of the scene's adc_bailout
    #[arg(long, value_name = "X", value_parser = not_negative)]
    pub adc_bailout: Option<f32>,
    /// Lamps of an area light that a point looks at, picked by chance
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub area_samples: Option<u32>,
    /// Instead of radiosity's count
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1600))]
    pub radiosity_count: Option<u32>,
    /// Instead of radiosity's error_bound
    #[arg(long, value_name = "X", value_parser = positive)]
    pub radiosity_error_bound: Option<f64>,
    /// Instead of radiosity's recursion_limit
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=20))]
    pub radiosity_recursion: Option<u32>,
    /// Instead of radiosity's pretrace_end, up to 1
    #[arg(long, value_name = "X", value_parser = share)]
    pub pretrace_end: Option<f64>,
    /// Photons so many times as far apart as the scene says
    #[arg(long, value_name = "FACTOR", value_parser = positive)]
    pub photon_spacing: Option<f64>,
    /// The most photons of a search, instead of gather's second number
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub photon_gather: Option<u32>,
    /// Instead of the intervals of all media
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=4096))]
    pub media_intervals: Option<u32>,
    /// The most samples that an interval of a medium gets
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub media_samples: Option<u32>,
    /// How indirect light is found: as the scene says, or by plain Monte Carlo, slowly, as a truth to hold
    /// the scene's settings against; give --max-error with it
    #[arg(long, value_enum, default_value_t, value_name = "scene|reference")]
    pub gi: Gi,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Gi {
    #[default]
    Scene,
    Reference,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Accelerator {
    /// A tree of boxes
    Bvh,
    /// A uniform grid
    Grid,
    /// A plain list
    None,
}

fn positive(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|v: &f64| v.is_finite() && *v > 0.0);
    number.ok_or_else(|| "expected a number above 0".to_owned())
}

fn share(text: &str) -> Result<f64, String> {
    positive(text).ok().filter(|v| *v <= 1.0).ok_or_else(|| "expected a number above 0, up to 1".to_owned())
}

fn not_negative(text: &str) -> Result<f32, String> {
    let number = text.parse().ok().filter(|v: &f32| v.is_finite() && *v >= 0.0);
    number.ok_or_else(|| "expected a number that is not negative".to_owned())
}

/// Columns and rows `x0, y0, x1, y1`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Corners(pub [u32; 4]);

fn corners(text: &str) -> Result<Corners, String> {
    let numbers: Result<Vec<u32>, _> = text.split(',').map(|n| n.trim().parse()).collect();
    let four = numbers.ok().and_then(|n| n.try_into().ok());
    four.map(Corners).ok_or_else(|| "expected four whole numbers: x0,y0,x1,y1".to_owned())
}

#[derive(Args, Clone, Debug)]
pub struct RenderArgs {
    /// Scene files; `-` reads a scene from standard input
    #[arg(required = true, value_name = "SCENE")]
    pub scenes: Vec<PathBuf>,
    /// The picture: a .png or .exr file, a folder, or `-` for a PNG on standard output
    /// [default: the scene's base name with .png in the current folder]
    #[arg(short = 'o', long, value_name = "FILE", verbatim_doc_comment)]
    pub output: Option<PathBuf>,
    #[command(flatten)]
    pub picture: PictureArgs,
    #[command(flatten)]
    pub accuracy: AccuracyArgs,
    #[command(flatten)]
    pub overrides: OverrideArgs,
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Trace only columns x0 to x1-1 of rows y0 to y1-1, counted from 0 at the upper left; the picture
    /// keeps its size
    #[arg(long, value_name = "x0,y0,x1,y1", value_parser = corners)]
    pub region: Option<Corners>,
    /// What the scene's objects are kept in; pictures do not depend on it [default: what suits their number]
    #[arg(long, value_enum, value_name = "bvh|grid|none")]
    pub accel: Option<Accelerator>,
    /// Write an alpha channel
    #[arg(long)]
    pub alpha: bool,
    /// Bits of a channel in a PNG file
    #[arg(long, value_name = "8|16", default_value = "8", value_parser = PossibleValuesParser::new(["8", "16"]))]
    pub bits: String,
    /// A file of radiosity samples to begin with; it need not be there yet
    #[arg(long, value_name = "FILE")]
    pub load_radiosity: Option<PathBuf>,
    /// Write radiosity's samples to a file, those that were loaded among them
    #[arg(long, value_name = "FILE")]
    pub save_radiosity: Option<PathBuf>,
    /// Also write the unfinished picture every few seconds
    #[arg(long)]
    pub partial: bool,
    /// Print one JSON object a scene
    #[arg(long)]
    pub json: bool,
    /// Say nothing but errors
    #[arg(long, short = 'q')]
    pub quiet: bool,
}

#[derive(Args, Clone, Debug)]
pub struct CheckArgs {
    /// Scene files; `-` reads a scene from standard input
    #[arg(required = true, value_name = "SCENE")]
    pub scenes: Vec<PathBuf>,
    #[command(flatten)]
    pub scene: SceneArgs,
    /// The width that the scene is told
    #[arg(short = 'W', long, value_name = "PIXELS", default_value_t = 640, value_parser = clap::value_parser!(u32).range(1..=65535))]
    pub width: u32,
    /// The height that the scene is told
    #[arg(short = 'H', long, value_name = "PIXELS", default_value_t = 480, value_parser = clap::value_parser!(u32).range(1..=65535))]
    pub height: u32,
    /// Say which included file was taken from where
    #[arg(long)]
    pub explain_includes: bool,
    /// Print one JSON object a scene
    #[arg(long)]
    pub json: bool,
    /// Say nothing but errors
    #[arg(long, short = 'q')]
    pub quiet: bool,
}

#[derive(Args, Clone, Debug)]
pub struct ExplainArgs {
    /// A scene file; `-` reads a scene from standard input
    #[arg(value_name = "SCENE")]
    pub scene_file: PathBuf,
    #[command(flatten)]
    pub scene: SceneArgs,
    /// What the scene's objects are kept in [default: what suits their number]
    #[arg(long, value_enum, value_name = "bvh|grid|none")]
    pub accel: Option<Accelerator>,
    /// Print a JSON object
    #[arg(long)]
    pub json: bool,
}

#[derive(Args, Clone, Debug)]
pub struct CompareArgs {
    /// A picture
    pub a: PathBuf,
    /// The picture that it is compared with
    pub b: PathBuf,
    /// Write the absolute difference, brightened 8 times
    #[arg(long, value_name = "PNG")]
    pub diff: Option<PathBuf>,
    /// Exit with 1 below this peak signal-to-noise ratio, in decibels
    #[arg(long, value_name = "DB")]
    pub min_psnr: Option<f64>,
    /// Print a JSON object
    #[arg(long)]
    pub json: bool,
}

#[derive(Args, Clone, Debug)]
pub struct CrosscheckArgs {
    /// Scene files, and folders that are searched for them
    #[arg(required = true, value_name = "FILE|DIR")]
    pub paths: Vec<PathBuf>,
    /// Take scenes from a list, one path a line, relative to the folder given
    #[arg(long, value_name = "FILE")]
    pub list: Option<PathBuf>,
    /// The POV-Ray program
    #[arg(long, value_name = "PATH", default_value = "povray")]
    pub povray: PathBuf,
    /// Use the pictures of this folder (a scene's relative path with .png) instead of running POV-Ray
    #[arg(long, value_name = "DIR")]
    pub reference: Option<PathBuf>,
    /// A scene matches from this peak signal-to-noise ratio on, in decibels
    #[arg(long, value_name = "DB", default_value_t = 38.0)]
    pub min_psnr: f64,
    /// Exit with 1 if fewer scenes match
    #[arg(long, value_name = "N")]
    pub min_match: Option<usize>,
    /// Write a self-contained HTML report
    #[arg(long, value_name = "HTML")]
    pub report: Option<PathBuf>,
    /// Print a JSON object
    #[arg(long)]
    pub json: bool,
    #[command(flatten)]
    pub picture: PictureArgs,
    /// A folder in which both programs look for included files; may be repeated
    #[arg(short = 'L', long = "library", value_name = "DIR")]
    pub library: Vec<PathBuf>,
    /// Seconds that Glint may take for a scene
    #[arg(long, value_name = "SECONDS", default_value_t = 60.0)]
    pub timeout: f64,
    /// Seconds that POV-Ray may take for a scene
    #[arg(long, value_name = "SECONDS", default_value_t = 300.0)]
    pub povray_timeout: f64,
    /// Scenes rendered at a time [default: one per core]
    #[arg(short = 'j', long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub jobs: Option<u16>,
    /// Where POV-Ray's pictures are kept [default: the user's cache folder]
    #[arg(long, value_name = "DIR")]
    pub cache: Option<PathBuf>,
    /// Run POV-Ray for every scene
    #[arg(long)]
    pub no_cache: bool,
    /// Keep Glint's pictures in this folder
    #[arg(long, value_name = "DIR")]
    pub keep: Option<PathBuf>,
    /// Say nothing but errors
    #[arg(long, short = 'q')]
    pub quiet: bool,
}

#[derive(Args, Clone, Debug)]
pub struct TradeArgs {
    /// A scene file
    #[arg(value_name = "SCENE")]
    pub scene_file: PathBuf,
    /// What is varied, so far as the scene has it [default: all]
    #[arg(long, value_enum, value_delimiter = ',', value_name = "LIST")]
    pub settings: Vec<TradeSetting>,
    /// The wall time that the measuring may take: 60, 60s, 2min
    #[arg(long, value_name = "T", default_value = "60s", value_parser = parse_seconds)]
    pub budget: f64,
    /// Write a self-contained HTML report
    #[arg(long, value_name = "HTML")]
    pub report: Option<PathBuf>,
    /// Keep the reference picture in this folder, and use it again while scene and size are the same
    #[arg(long, value_name = "DIR")]
    pub cache: Option<PathBuf>,
    /// Print a JSON object
    #[arg(long)]
    pub json: bool,
    /// Width of the picture; measured is a smaller one if the budget is small
    #[arg(short = 'W', long, value_name = "PIXELS", default_value_t = 640, value_parser = clap::value_parser!(u32).range(1..=65535))]
    pub width: u32,
    /// Height of the picture
    #[arg(short = 'H', long, value_name = "PIXELS", default_value_t = 480, value_parser = clap::value_parser!(u32).range(1..=65535))]
    pub height: u32,
    #[command(flatten)]
    pub scene: SceneArgs,
    /// Threads that trace [default: one per core]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
    /// Say nothing but errors and results
    #[arg(long, short = 'q')]
    pub quiet: bool,
}

/// What `glint trade` can vary.
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub enum TradeSetting {
    /// Anti-aliasing method, threshold and depth
    Aa,
    TraceLevel,
    AdcBailout,
    AreaSamples,
    RadiosityCount,
    RadiosityErrorBound,
    RadiosityRecursion,
    PretraceEnd,
    PhotonSpacing,
    PhotonGather,
    MediaSamples,
    MediaIntervals,
    /// All of radiosity, photons and media
    Light,
}

#[derive(Subcommand, Clone, Debug)]
pub enum GoldenCommand {
    /// Compare with the pictures that Glint made earlier
    Check(GoldenArgs),
    /// Replace the stored pictures by new ones; always exits with 1
    Bless(GoldenArgs),
    /// Make POV-Ray's pictures of the scenes anew
    Reference(GoldenArgs),
}

#[derive(Args, Clone, Debug)]
pub struct GoldenArgs {
    /// Scenes by their path with or without .pov, or a folder of them [default: all]
    #[arg(value_name = "NAME")]
    pub names: Vec<String>,
    /// The project's folder [default: the nearest one above that has `reference-images`]
    #[arg(long, value_name = "DIR")]
    pub root: Option<PathBuf>,
    /// A folder of scenes in the project; may be repeated [default: scenes and tests/scenes]
    #[arg(long, value_name = "DIR")]
    pub scenes: Vec<PathBuf>,
    /// Where pictures that differ are kept [default: target/golden in the project]
    #[arg(long, value_name = "DIR")]
    pub keep: Option<PathBuf>,
    /// Write what `check` found as a self-contained HTML page
    #[arg(long, value_name = "HTML")]
    pub report: Option<PathBuf>,
    /// The POV-Ray program
    #[arg(long, value_name = "PATH", default_value = "povray")]
    pub povray: PathBuf,
}

#[derive(Args, Clone, Debug)]
pub struct CompletionsArgs {
    /// The shell
    pub shell: clap_complete::Shell,
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory;

    #[test]
    fn the_definition_is_sound() {
        Cli::command().debug_assert();
    }

    #[test]
    fn all_commands_are_known_by_name() {
        let names: Vec<_> = Cli::command().get_subcommands().map(|c| c.get_name().to_owned()).collect();
        for name in &names {
            assert!(COMMANDS.contains(&name.as_str()), "{name}");
        }
    }

    fn render(args: &[&str]) -> RenderArgs {
        match Cli::try_parse_from([&["glint", "render"], args].concat()).unwrap().command {
            Command::Render(r) => *r,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn antialiasing_takes_a_value_only_after_an_equals_sign() {
        assert_eq!(render(&["a.pov"]).picture.antialias, None);
        assert_eq!(render(&["-A", "a.pov"]).picture.antialias, Some(0.3));
        assert_eq!(render(&["-A=0.1", "a.pov"]).picture.antialias, Some(0.1));
    }

    #[test]
    fn regions_have_four_numbers() {
        assert_eq!(render(&["--region", "1,2,3,4", "a.pov"]).region, Some(Corners([1, 2, 3, 4])));
        assert!(Cli::try_parse_from(["glint", "render", "--region", "1,2,3", "a.pov"]).is_err());
    }
}
