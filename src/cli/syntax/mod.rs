//! Which of the two command-line syntaxes was typed.
//!
//! | POV-Ray's | the program is called `povray`; after `glint pov`; a word begins with `+` or names an .ini file |
//! | Glint's | everything else |
//!
//! They are never mixed: letters mean different things (`-A` is anti-aliasing here and no anti-aliasing
//! there).

mod sorted;
mod translate;

use super::args::COMMANDS;
use super::exit::Failure;
use sorted::Sorted;
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
        return povray(rest);
    }
    if rest.first().is_some_and(|w| w == "pov") {
        return povray(rest[1..].to_vec());
    }
    let sorted = Sorted::of(&rest, false);
    if let Some(word) = rest.first()
        && rest.len() > 1
        && sorted.povray.is_empty()
        && let Some(command) = mistyped(word)
    {
        return Err(Failure::usage(format!(
            "`{word}` is no command and no scene\n  did you mean `glint {command} {}`?",
            rest[1..].join(" ")
        )));
    }
    if sorted.povray.is_empty() {
        return Ok(Syntax::Glint(with_command(words)));
    }
    if sorted.command.is_none() && sorted.glint.is_empty() {
        return Ok(Syntax::Povray(rest));
    }
    Err(mixed(&sorted, &format!("`{}`", sorted.povray[0])))
}

/// POV-Ray's syntax was asked for.
fn povray(words: Vec<String>) -> Result<Syntax, Failure> {
    let sorted = Sorted::of(&words, true);
    if sorted.command.is_none() && sorted.glint.is_empty() {
        return Ok(Syntax::Povray(words));
    }
    Err(mixed(&sorted, "this"))
}

fn mixed(line: &Sorted, povray: &str) -> Failure {
    let option = line.glint.first().map(|g| g.words.join(" "));
    let glint = line.command.clone().or(option).unwrap_or_default();
    Failure::usage(format!(
        "{povray} is POV-Ray's command-line syntax and `{glint}` is Glint's; they cannot be mixed.\n{}",
        translate::translated(line),
    ))
}

/// The command that a word nearly is which names no file.
fn mistyped(word: &str) -> Option<&'static str> {
    let is_name = word.chars().all(|c| c.is_ascii_alphabetic());
    if !is_name || COMMANDS.contains(&word) || Path::new(word).exists() {
        return None;
    }
    crate::interp::nearest_word(word, COMMANDS.iter().copied())
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

    /// What is shown for a mixed line.
    fn advice(line: &str) -> String {
        let error = syntax(line).unwrap_err();
        assert_eq!(error.exit, Exit::Usage);
        error.message.rsplit('\n').next().unwrap().replace("In Glint's syntax: ", "")
    }

    #[test]
    fn mixing_shows_the_translated_command() {
        for (typed, translated) in [
            (
                "glint render a.pov +W320 +H200 +A0.1 +AM2 -o b.png +FN16",
                "glint render a.pov -W 320 -H 200 -A=0.1 --aa-method 2 --bits 16 -o b.png",
            ),
            ("glint +Iscene.pov +Oout.png +UA --json", "glint render scene.pov --alpha -o out.png --json"),
            ("glint pov good.pov --json", "glint render good.pov --json"),
            ("glint pov good.pov -W 20 -o x.png", "glint render good.pov -W 20 -o x.png"),
            ("povray dice.pov -W 20", "glint render dice.pov -W 20"),
            ("povray render good.pov -W 20", "glint render good.pov -W 20"),
            ("glint +Igood.pov +W20 -A0.3 --alpha", "glint render good.pov -W 20 --alpha"),
            ("glint +Igood.pov +A --alpha", "glint render good.pov -A --aa-method 1 --alpha"),
            ("glint render good.pov +W20 -A", "glint render good.pov -W 20 -A"),
            ("glint +Igood.pov +W20 -J --threads 2", "glint render good.pov -W 20 --jitter off --threads 2"),
            ("glint +Igood.pov Declare=X=3 --json", "glint render good.pov -D X=3 --json"),
            ("glint +Igood.pov -D X=3", "glint render good.pov -D X=3"),
            (
                "glint +Ia.pov +SC5 +EC10 +SR3 +ER8 --json",
                "glint render a.pov -W 160 -H 120 --region 4,2,10,8 --json",
            ),
            ("glint +Ia.pov +SC0.5 -W 20 -H 10", "glint render a.pov --region 10,0,20,10 -W 20 -H 10"),
            ("glint +Ia.pov +FE --json", "glint render a.pov -o a.exr --json"),
            ("glint compare a.png +b.png", "glint compare a.png ./+b.png"),
            ("glint check a.pov +W20", "glint check a.pov -W 20"),
            ("glint +Ia.pov +Lmy -Iit's.pov -q", "glint render 'it'\\''s.pov' -L my -q"),
        ] {
            let shown = advice(typed);
            assert!(shown.ends_with(translated), "{typed}\n{shown}\n{translated}");
        }
    }

    #[test]
    fn what_one_syntax_lacks_is_shown_in_the_other() {
        for (typed, translated) in [
            (
                "glint +Ia.pov +KFI1 +KFF3 -W 20 -o x",
                "In POV-Ray's syntax: glint pov +Ia.pov +KFI1 +KFF3 +W20 +Ox",
            ),
            ("glint a.pov +FT --region 1,2,3,4", "glint pov a.pov +FT +SC2 +SR3 +EC3 +ER4"),
            ("glint a.pov +KFF3 --json", "In POV-Ray's syntax, without that: glint pov a.pov +KFF3"),
            ("glint check a.pov +Q3", "In Glint's syntax, without that: glint check a.pov"),
        ] {
            let shown = advice(typed);
            assert!(shown.ends_with(translated), "{typed}\n{shown}\n{translated}");
        }
        assert!(syntax("glint a.pov +KFF3 --json").unwrap_err().message.contains("nothing for `--json`"));
        assert!(syntax("glint check a.pov +Q3").unwrap_err().message.contains("`--quality`"));
    }

    /// What an INI file says is read, so that nothing of it is lost.
    #[test]
    fn ini_files_are_translated() {
        let ini = std::env::temp_dir().join(format!("glint-mixed-{}.ini", std::process::id()));
        std::fs::write(&ini, "Input_File_Name=b.pov\n+W30 Quality=5\n").unwrap();
        let shown = advice(&format!("glint {} --json", ini.display()));
        assert!(shown.ends_with("glint render b.pov -W 30 --quality 5 --json"), "{shown}");
        std::fs::remove_file(&ini).unwrap();
        let shown = advice(&format!("glint {} --json", ini.display()));
        assert!(shown.ends_with(&format!("glint pov {}", ini.display())), "{shown}");
    }

    /// A value is no word of the other syntax.
    #[test]
    fn values_are_not_switches() {
        assert_eq!(syntax("glint a.pov -o +x.png"), glint("glint render a.pov -o +x.png"));
        assert_eq!(syntax("povray a.pov -D Width=3"), povray("a.pov -D Width=3"));
    }
}
