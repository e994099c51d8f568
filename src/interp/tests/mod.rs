//! The language through the real parser.

mod again;
mod directives;
mod errors;
mod functions;
mod images;
mod lists;
mod macros;
mod oracle;
mod programs;
mod queries;
mod surface;
mod textfiles;
mod vocabulary;

use super::options::{Options, SceneSource};
use super::parser::{Parser, SceneBuilder};
use super::{Outcome, Result, interpret};
use crate::color::Gamma;

/// A parser at the start of `text`, with `#version 3.7` and `assumed_gamma 1` in force.
fn parser(text: &str) -> Parser {
    let mut parser =
        Parser::new(Options { start_version: Some(370), ..Options::default() }, SceneBuilder::new());
    parser.scene.gamma_given = true;
    parser.scene.scene.globals.gamma = Gamma::Power(1.0);
    let source = SceneSource::Text { name: "test".to_owned(), text: text.as_bytes().to_vec() };
    parser.open_main(&source).expect("a text in memory opens");
    parser
}

/// Reads `text` by one of the parser's methods.
fn read<T>(text: &str, production: impl FnOnce(&mut Parser) -> Result<T>) -> T {
    production(&mut parser(text)).unwrap_or_else(|e| panic!("{text}: {}", e.message))
}

/// A scene's outcome under `#version 3.7`; it may read temporary files.
fn outcome(text: &str) -> Outcome {
    let source = SceneSource::Text { name: "test".to_owned(), text: text.as_bytes().to_vec() };
    let readable = vec![std::env::temp_dir()];
    interpret(source, &Options { start_version: Some(370), readable, ..Options::default() })
}

/// What a scene prints; it must not fail.
fn debug(text: &str) -> String {
    let outcome = outcome(text);
    if let Err(e) = &outcome.scene {
        panic!("{text}: {} {:?}", e.message, e.span);
    }
    outcome.debug
}

/// The message of the error that a scene must give.
fn error(text: &str) -> String {
    match outcome(text).scene {
        Ok(_) => panic!("no error: {text}"),
        Err(e) => e.message,
    }
}

/// A text that prints each expression, a space between them.
fn shown(expressions: &[&str]) -> String {
    expressions.iter().map(|e| format!("#debug concat(str({e},0,-1),\" \") ")).collect()
}
