//! The words of a command line, each with the syntax that it belongs to.

use super::super::args::{COMMANDS, Cli};
use clap::{Arg, CommandFactory};
use std::path::Path;

/// A command line taken apart.
#[derive(Debug, Default, PartialEq)]
pub struct Sorted {
    /// The command that was typed.
    pub command: Option<String>,
    /// Words that Glint's syntax alone has, with their values.
    pub glint: Vec<Given>,
    /// Words that POV-Ray's syntax alone has.
    pub povray: Vec<String>,
    /// Scenes and other files, `-A`, `-D`: words of both.
    pub either: Vec<String>,
}

/// An option of Glint's as it was typed.
#[derive(Clone, Debug, PartialEq)]
pub struct Given {
    /// `-W` also for `--width`.
    pub name: String,
    pub value: Option<String>,
    pub words: Vec<String>,
}

impl Sorted {
    /// Sorts the words behind the program's name. Where POV-Ray's syntax is meant from the start, a word
    /// that it has a meaning for is POV-Ray's.
    pub fn of(words: &[String], povray: bool) -> Sorted {
        let mut sorted = Sorted::default();
        let options = Options::new();
        let command = words.first().filter(|w| COMMANDS.contains(&w.as_str()));
        // There, a bare word names an INI file.
        sorted.command = command
            .filter(|w| !(povray && [w.as_str(), &format!("{w}.ini")].iter().any(|f| is_file(f))))
            .cloned();
        let mut rest = words[usize::from(sorted.command.is_some())..].iter().peekable();
        while let Some(word) = rest.next() {
            if let Some(mut given) = options.given(word, rest.peek().map(|w| w.as_str())) {
                if given.words.len() > 1 {
                    rest.next();
                }
                // Only the short form says that this is Glint's syntax where both have the word.
                given.name = options.short(&given.name);
                sorted.glint.push(given);
            } else if is_povray(word) {
                sorted.povray.push(word.clone());
            } else {
                sorted.either.push(word.clone());
            }
        }
        sorted
    }

    pub fn value(&self, name: &str) -> Option<&str> {
        self.glint.iter().rev().find(|g| g.name == name).and_then(|g| g.value.as_deref())
    }
}

fn is_file(name: &str) -> bool {
    Path::new(name).is_file()
}

/// Words that only POV-Ray's syntax has.
pub fn is_povray(word: &str) -> bool {
    let name = word.split('[').next().unwrap_or(word);
    word.starts_with('+') || (!word.starts_with('-') && name.to_ascii_lowercase().ends_with(".ini"))
}

/// The options of all of Glint's commands.
struct Options(Vec<Arg>);

impl Options {
    fn new() -> Options {
        let cli = Cli::command();
        let all = cli.get_subcommands().flat_map(|c| c.get_arguments().cloned());
        Options(all.filter(|a| !a.is_positional()).collect())
    }

    fn find(&self, name: &str) -> Option<&Arg> {
        self.0.iter().find(|a| match name.strip_prefix("--") {
            Some(long) => a.get_long() == Some(long),
            None => a.get_short().is_some_and(|s| name == format!("-{s}")),
        })
    }

    fn short(&self, name: &str) -> String {
        let short = self.find(name).and_then(Arg::get_short);
        short.map_or(name.to_owned(), |s| format!("-{s}"))
    }

    /// The word, if it is an option that POV-Ray's syntax does not have; with the next one if that is its
    /// value.
    fn given(&self, word: &str, next: Option<&str>) -> Option<Given> {
        let (name, value) = match word.split_once('=') {
            Some((name, value)) => (name, Some(value.to_owned())),
            None => (word, None),
        };
        let shared = match name {
            "--resume" | "--help" | "--version" => true,
            "--allow-read" | "--allow-write" => value.is_some(),
            "-A" => value.is_none(),
            "-D" => value.is_some() || !next.is_some_and(is_declaration),
            name => !name.starts_with("--") && !matches!(name, "-o" | "-W" | "-H" | "-L" | "-q"),
        };
        let option = self.find(name).filter(|_| !shared)?;
        let takes = option.get_action().takes_values() && !option.is_require_equals_set();
        let next = next.filter(|_| takes && value.is_none());
        let words = std::iter::once(word).chain(next).map(str::to_owned).collect();
        Some(Given { name: name.to_owned(), value: value.or(next.map(str::to_owned)), words })
    }
}

/// `NAME=VALUE` that is no keyword of POV-Ray's.
fn is_declaration(word: &str) -> bool {
    let name = word.split_once('=').map(|(name, _)| name);
    name.is_some_and(|n| !n.starts_with(['+', '-']) && !super::super::povray::is_keyword(n))
}
