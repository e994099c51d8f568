use super::limits::Limits;
use std::path::PathBuf;

/// Where a scene's text comes from.
#[derive(Clone, Debug)]
pub enum SceneSource {
    Path(PathBuf),
    /// A text already at hand, with the name that diagnostics show.
    Text {
        name: String,
        text: Vec<u8>,
    },
}

/// Which standard include files are used.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum IncludeMode {
    /// Those of an installed POV-Ray if there is one, else the embedded ones.
    #[default]
    Auto,
    Embedded,
    Installed,
}

/// What the command line says about reading a scene.
#[derive(Clone, Debug)]
pub struct Options {
    /// Folders searched for files, in order.
    pub library_paths: Vec<PathBuf>,
    /// Further folders that a scene may read.
    pub readable: Vec<PathBuf>,
    /// Further folders that a scene may read and write.
    pub writable: Vec<PathBuf>,
    pub includes: IncludeMode,
    /// A file read before the scene.
    pub include_header: Option<PathBuf>,
    /// `Declare=NAME=VALUE`: variables set before the scene.
    pub declares: Vec<(String, f64)>,
    pub declared_strings: Vec<(String, String)>,
    /// The language version to start with, times 100; it counts as declared.
    pub start_version: Option<u32>,
    pub frame: Frame,
    pub image_width: u32,
    pub image_height: u32,
    /// Whether the picture will have an alpha channel.
    pub output_alpha: bool,
    /// Refuse what the reference refuses, even where nobody is helped by it.
    pub strict: bool,
    pub limits: Limits,
}

/// Which frame of an animation is read; all 0 for a still picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Frame {
    pub clock: f32,
    /// Whether a clock or an animation was asked for.
    pub clock_on: bool,
    pub number: u32,
    pub initial: u32,
    pub last: u32,
    pub initial_clock: f64,
    pub final_clock: f64,
    pub clock_delta: f64,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            library_paths: Vec::new(),
            readable: Vec::new(),
            writable: Vec::new(),
            includes: IncludeMode::Auto,
            include_header: None,
            declares: Vec::new(),
            declared_strings: Vec::new(),
            start_version: None,
            frame: Frame::default(),
            image_width: 160,
            image_height: 120,
            output_alpha: false,
            strict: false,
            limits: Limits::default(),
        }
    }
}
