//! Which of the two command-line syntaxes was typed.
//!
//! | POV-Ray's | the program is called `povray`; after `glint pov`; a word begins with `+` or names an .ini file |
//! | Glint's | everything else |
//!
//! They are never mixed: letters mean different things (`-A` is anti-aliasing here and no anti-aliasing
//! there).

mod translate;

use super::args::COMMANDS;
use super::exit::Failure;
use std::ffi::OsString;
use std::path::Path;

/// A command line in one of the syntaxes.
#[derive(Debug, PartialEq)]
pub enum Syntax {
    /// With the program's name and the command.
    Glint(Vec<OsString>),
    /// Without the program's name.
    Povray(Vec<String>),
}

/// Tells the syntax of a command line whose first word is the program's name.
pub fn of(words: &[OsString]) -> Result<Syntax, Failure> {
    let program = words.first().map(Path::new).and_then(Path::file_stem).unwrap_or_default();
    let rest: Vec<String> = words.iter().skip(1).map(|w| w.to_string_lossy().into_owned()).collect();
    if program == "povray" {
        return Ok(Syntax::Povray(rest));
    }
    if rest.first().is_some_and(|w| w == "pov") {
        return Ok(Syntax::Povray(rest[1..].to_vec()));
    }
    if rest.iter().any(|w| is_povray(w)) {
        return match rest.iter().position(|w| is_glint(w)) {
            Some(at) => Err(mixed(&rest, at)),
            None => Ok(Syntax::Povray(rest)),
        };
    }
    Ok(Syntax::Glint(with_command(words)))
}

/// Words that only POV-Ray's syntax has.
fn is_povray(word: &str) -> bool {
    let name = word.split('[').next().unwrap_or(word);
    word.starts_with('+') || (!word.starts_with('-') && name.to_ascii_lowercase().ends_with(".ini"))
}

/// Words that only Glint's syntax has: commands, long options, options whose value is a word of its own.
fn is_glint(word: &str) -> bool {
    COMMANDS.contains(&word)
        || (word.starts_with("--") && !matches!(word, "--resume" | "--help" | "--version"))
        || matches!(word, "-o" | "-W" | "-H" | "-L")
        || word.starts_with("-A=")
}

fn mixed(words: &[String], glint: usize) -> Failure {
    let povray = words.iter().find(|w| is_povray(w)).map_or("", String::as_str);
    Failure::usage(format!(
        "`{povray}` is POV-Ray's command-line syntax and `{}` is Glint's; they cannot be mixed.\n\
         In Glint's syntax: {}",
        words[glint],
        translate::to_glint(words),
    ))
}

/// Puts the default command where none was typed.
fn with_command(words: &[OsString]) -> Vec<OsString> {
    let mut words = words.to_vec();
    let command = |w: &OsString| {
        let w = w.to_string_lossy();
        COMMANDS.contains(&w.as_ref()) || matches!(w.as_ref(), "--help" | "-h" | "--version" | "-V")
    };
    if words.len() > 1 && !command(&words[1]) {
        words.insert(1, "render".into());
    }
    words
}

#[cfg(test)]
mod tests {
    use super::super::exit::Exit;
    use super::*;

    fn syntax(line: &str) -> Result<Syntax, Failure> {
        of(&line.split(' ').map(OsString::from).collect::<Vec<_>>())
    }

    fn glint(line: &str) -> Result<Syntax, Failure> {
        Ok(Syntax::Glint(line.split(' ').map(OsString::from).collect()))
    }

    fn povray(line: &str) -> Result<Syntax, Failure> {
        Ok(Syntax::Povray(line.split(' ').map(String::from).collect()))
    }

    #[test]
    fn render_is_the_default_command() {
        assert_eq!(syntax("glint a.pov"), glint("glint render a.pov"));
        assert_eq!(syntax("glint -W 320 a.pov"), glint("glint render -W 320 a.pov"));
        assert_eq!(syntax("glint check a.pov"), glint("glint check a.pov"));
        assert_eq!(syntax("glint --version"), glint("glint --version"));
    }

    #[test]
    fn povray_syntax_is_recognised() {
        assert_eq!(syntax("/usr/bin/povray a.pov -A"), povray("a.pov -A"));
        assert_eq!(syntax("glint pov a.pov -W320"), povray("a.pov -W320"));
        assert_eq!(syntax("glint +Ia.pov -A -D"), povray("+Ia.pov -A -D"));
        assert_eq!(syntax("glint a.INI[big] -A"), povray("a.INI[big] -A"));
        assert_eq!(syntax("glint a.ini --resume"), povray("a.ini --resume"));
    }

    #[test]
    fn mixing_shows_the_translated_command() {
        let error = syntax("glint render a.pov +W320 +H200 +A0.1 +AM2 -o b.png +FN16").unwrap_err();
        assert_eq!(error.exit, Exit::Usage);
        let translated = "glint render a.pov -W 320 -H 200 -A=0.1 --aa-method 2 -o b.png --bits 16";
        assert!(error.message.ends_with(translated), "{error}");
        let error = syntax("glint +Iscene.pov +Oout.png +UA --json").unwrap_err();
        assert!(error.message.ends_with("glint render scene.pov -o out.png --alpha --json"), "{error}");
    }
}
