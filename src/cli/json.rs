//! What goes to standard output.

use super::exit::Failure;
use serde::Serialize;
use std::io::{self, Write};
use std::path::Path;

/// Prints one object on one line.
pub fn print(value: &impl Serialize) -> Result<(), Failure> {
    let mut line = serde_json::to_string(value).map_err(|e| Failure::failed(e.to_string()))?;
    line.push('\n');
    print_text(&line)
}

/// Prints text. A reader that has gone away is no error.
pub fn print_text(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(e) if e.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure::unavailable(format!("standard output: {e}")))
        }
        _ => Ok(()),
    }
}

/// What is printed for a scene that failed.
#[derive(Serialize)]
pub struct Failed {
    scene: String,
    exit: u8,
    error: String,
}

impl Failed {
    pub fn new(scene: &Path, failure: &Failure) -> Self {
        let error = failure.message.lines().next().unwrap_or_default().to_owned();
        Self { scene: scene.display().to_string(), exit: failure.exit.code(), error }
    }
}
