//! A text is read as a scene and prepared: no panic, no hang, no memory without end.
//!
//! `fuzz/run.sh` starts it with our scenes and the reserved words; docs/LANGUAGE.md says what it found.

#![no_main]

use glint::interp::{IncludeMode, Limits, Options, SceneSource, interpret};
use glint::world::World;
use libfuzzer_sys::fuzz_target;
use std::path::Path;
use std::sync::OnceLock;

/// Small enough that what outlasts or outgrows them is a finding.
fn options() -> &'static Options {
    static OPTIONS: OnceLock<Options> = OnceLock::new();
    OPTIONS.get_or_init(|| {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the crate is in a folder");
        let limits = Limits {
            passes: 20_000,
            array_elements: 100_000,
            kept_tokens: 100_000,
            seconds: 5.0,
            memory: Some(1 << 30),
            ..Limits::default()
        };
        let library_paths = ["data/images", "language", "bad"].map(|f| root.join("tests").join(f)).to_vec();
        // Scenes write files where they stand.
        let place = std::env::temp_dir().join(format!("glint-fuzz-{}", std::process::id()));
        std::fs::create_dir_all(&place).expect("a folder for what scenes write");
        std::env::set_current_dir(&place).expect("that folder");
        Options { library_paths, includes: IncludeMode::Embedded, limits, ..Options::default() }
    })
}

fuzz_target!(|text: &[u8]| {
    let source = SceneSource::Text { name: "scene".into(), text: text.to_vec() };
    let _ = interpret(source, options()).scene.map(World::prepare);
});
