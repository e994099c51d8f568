use super::builtin::format_general;
use super::options::{Options, SceneSource};
use super::parser::{Parser, SceneBuilder};
use super::symbols::{Binding, GLOBAL};
use super::{Result, Value};
use crate::camera::Camera;
use crate::color::Gamma;
use crate::function::patience;
use crate::material::Layer;
use crate::pattern::NoiseGenerator;
use crate::scene::{Background, Body, Globals, Object, Scene};
use crate::source::{Diagnostic, Files, Severity, Span};
use std::collections::HashMap;
use std::sync::Arc;

/// What reading a scene gave.
#[derive(Debug)]
pub struct Outcome {
    pub scene: std::result::Result<Scene, Box<Diagnostic>>,
    /// Every text read; diagnostics point into them.
    pub files: Files,
    /// One repeated at one place is kept once.
    pub warnings: Vec<Diagnostic>,
    /// Features that the scene uses and that are not rendered yet.
    pub unsupported: Vec<String>,
    /// Output of `#debug` and its like.
    pub debug: String,
}

/// Stack for reading a scene: nesting is limited, but each level may take a few kilobytes.
const STACK: usize = 256 << 20;

/// Reads a scene, on a thread with a stack that fits the nesting limit.
pub fn interpret(source: SceneSource, options: &Options) -> Outcome {
    let read = || run(&source, options);
    std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().name("interpret".to_owned()).stack_size(STACK);
        match thread.spawn_scoped(scope, read) {
            Ok(thread) => thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)),
            Err(_) => read(),
        }
    })
}

/// Reads a scene from a text, with default options.
pub fn interpret_str(text: &str) -> Outcome {
    let source = SceneSource::Text { name: "scene".to_owned(), text: text.as_bytes().to_vec() };
    interpret(source, &Options::default())
}

fn run(source: &SceneSource, options: &Options) -> Outcome {
    let mut parser = Parser::new(options.clone(), SceneBuilder::new());
    parser.predeclare(source);
    parser.bound_functions();
    let read = parser.read(source).map_err(|mut diagnostic| {
        if diagnostic.trace.is_empty() {
            diagnostic.trace = parser.call_chain();
        }
        diagnostic
    });
    let scene = match read {
        Ok(()) => parser.finish(),
        Err(diagnostic) => Err(diagnostic),
    };
    patience::give_up_at(None);
    Outcome {
        scene,
        files: parser.files,
        warnings: parser.messages.warnings,
        unsupported: parser.messages.unsupported,
        debug: parser.messages.debug,
    }
}

impl SceneBuilder {
    pub(super) fn new() -> Self {
        let camera = Camera::default();
        let scene = Scene {
            globals: Globals::default(),
            camera: camera.clone(),
            objects: Vec::new(),
            background: Background::None,
            sky_sphere: None,
            fogs: Vec::new(),
            rainbows: Vec::new(),
            media: Vec::new(),
        };
        Self {
            scene,
            default_layer: Layer::default(),
            default_camera: camera,
            gamma_given: false,
            recent_texture: None,
            noise_given: false,
            surroundings: Arc::default(),
        }
    }
}

impl Parser {
    fn read(&mut self, source: &SceneSource) -> Result<()> {
        self.open_main(source)?;
        self.open_header()?;
        self.scene_statements()?;
        self.close_all()
    }

    /// Variables that stand before the scene.
    fn predeclare(&mut self, source: &SceneSource) {
        let name = match source {
            SceneSource::Path(path) => path.display().to_string(),
            SceneSource::Text { name, .. } => name.clone(),
        };
        self.predeclare_value("input_file_name", Value::String(Arc::from(name)));
        let frame = self.options.frame;
        let mut numbers = vec![
            ("image_width".to_owned(), f64::from(self.options.image_width)),
            ("image_height".to_owned(), f64::from(self.options.image_height)),
            ("frame_number".to_owned(), f64::from(frame.number)),
            ("initial_frame".to_owned(), f64::from(frame.initial)),
            ("final_frame".to_owned(), f64::from(frame.last)),
            ("initial_clock".to_owned(), frame.initial_clock),
            ("final_clock".to_owned(), frame.final_clock),
            ("clock_delta".to_owned(), frame.clock_delta),
        ];
        numbers.append(&mut self.options.declares);
        for (name, value) in numbers {
            // They pass through a text of 6 digits.
            let value = format_general(value).parse().unwrap_or(value);
            self.predeclare_value(&name, Value::Float(value));
        }
        for (name, text) in std::mem::take(&mut self.options.declared_strings) {
            self.predeclare_value(&name, Value::String(Arc::from(text)));
        }
    }

    fn predeclare_value(&mut self, name: &str, value: Value) {
        let symbol = self.names.name(name.as_bytes());
        self.symbols.bind(symbol, GLOBAL, Binding::Value(value));
    }

    /// Tells functions about to be called what holds here.
    pub(super) fn settle_surroundings(&self) {
        let original = !self.scene.noise_given && self.syntax_version() < 350;
        let generator = self.scene.scene.globals.noise_generator;
        self.scene.surroundings.set_generator(if original { NoiseGenerator::Original } else { generator });
    }

    /// Objects in objects multiply: what the scene comes to must fit into memory.
    fn count_objects(&self, whole: Span) -> Result<()> {
        let mut known = HashMap::new();
        let all = self.scene.scene.objects.iter();
        let leaves = all.fold(0u64, |n, object| n.saturating_add(leaves(object, &mut known)));
        self.reserve(leaves.saturating_mul(BYTES_PER_OBJECT), whole)
    }

    /// What the end of the text decides, and the scene.
    fn finish(&mut self) -> Result<Scene> {
        let whole = Span { file: self.last.file, start: 0, end: 0 };
        self.count_objects(whole)?;
        if !self.version.is_declared() {
            let text = "no `#version`: the scene is rendered by the rules before 3.7";
            self.warn(Diagnostic::warning(whole, text).with_hint("say `#version 3.7;` on the first line"));
        }
        if self.syntax_version() < 350 {
            let text = "the scene ends with a language version before 3.5: it is rendered as 3.5";
            self.warn(Diagnostic::warning(whole, text));
        }
        if self.scene.scene.objects.is_empty() {
            self.warn(Diagnostic::warning(whole, "there is no object in the scene"));
        }
        let effective = self.effective_version().max(350);
        let syntax = self.syntax_version();
        let has_gamma = self.version.has_gamma();
        if !self.scene.gamma_given && has_gamma {
            let text = "no `assumed_gamma`: 1.0 is taken";
            self.warn(
                Diagnostic::warning(whole, text).with_hint("say `global_settings { assumed_gamma 1.0 }`"),
            );
        }
        let given = (self.scene.gamma_given, self.scene.noise_given);
        let globals = &mut self.scene.scene.globals;
        globals.effective_version = effective;
        if !given.0 {
            globals.gamma = if has_gamma { Gamma::Power(1.0) } else { Gamma::Unmanaged };
        }
        if !given.1 && syntax < 350 {
            globals.noise_generator = NoiseGenerator::Original;
        }
        self.scene.surroundings.set_generator(globals.noise_generator);
        self.scene.surroundings.set_waves(globals.number_of_waves);
        let empty = SceneBuilder::new().scene;
        Ok(std::mem::replace(&mut self.scene.scene, empty))
    }
}

/// About what an object takes when the scene is prepared.
const BYTES_PER_OBJECT: u64 = 500;

/// How many objects that are no combinations an object consists of; shared ones are counted each time, but
/// looked at once.
fn leaves(object: &Object, known: &mut HashMap<*const Vec<Arc<Object>>, u64>) -> u64 {
    let Body::Csg { children, .. } = &object.body else { return 1 };
    if let Some(&n) = known.get(&Arc::as_ptr(children)) {
        return n;
    }
    let n = children.iter().fold(0u64, |n, child| n.saturating_add(leaves(child, known)));
    known.insert(Arc::as_ptr(children), n);
    n
}

impl Outcome {
    /// The error, then the warnings.
    pub fn diagnostics(&self) -> impl Iterator<Item = &Diagnostic> {
        self.scene.as_ref().err().map(|e| &**e).into_iter().chain(&self.warnings)
    }

    /// Whether anything but notes was said.
    pub fn is_clean(&self) -> bool {
        self.diagnostics().all(|d| d.severity == Severity::Note)
    }
}
