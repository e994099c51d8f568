//! A mixed command line in one syntax, for advice.

use super::super::args::Cli;
use super::super::povray::InGlint;
use super::sorted::{Given, Sorted};
use clap::CommandFactory;
use std::path::is_separator;

/// The command line in Glint's syntax, or in POV-Ray's if Glint's lacks something.
pub fn translated(line: &Sorted) -> String {
    let (glint, lost) = match to_glint(line) {
        Ok((command, lost)) if lost.is_empty() => return format!("In Glint's syntax: {command}"),
        Ok((command, lost)) => (Some(command), lost),
        Err(message) => (None, vec![message]),
    };
    let (povray, missing) = to_povray(line);
    let lost = lost.join(", ");
    match (povray, glint) {
        (Some(povray), _) if missing.is_empty() => {
            format!("Glint's syntax has nothing for {lost}. In POV-Ray's syntax: {povray}")
        }
        (Some(povray), _) => format!(
            "Neither has all of it: Glint's syntax has nothing for {lost}, POV-Ray's has nothing for {}.\n\
             In POV-Ray's syntax, without that: {povray}",
            missing.join(", ")
        ),
        (None, Some(glint)) => format!("It has nothing for {lost}. In Glint's syntax, without that: {glint}"),
        (None, None) => lost,
    }
}

/// Whether a command reads scenes, as POV-Ray's options suppose.
fn reads_scenes(command: &str) -> bool {
    matches!(command, "render" | "check" | "explain" | "crosscheck" | "trade")
}

/// The command, and what it lacks.
fn to_glint(line: &Sorted) -> Result<(String, Vec<String>), String> {
    let command = line.command.as_deref().unwrap_or("render");
    let mut words = vec!["glint".to_owned(), command.to_owned()];
    let mut lost = Vec::new();
    if !reads_scenes(command) {
        // `+a.png` is a file's name there.
        words.extend(line.either.iter().cloned());
        words.extend(
            line.povray.iter().map(|w| if w.starts_with('+') { format!("./{w}") } else { w.clone() }),
        );
    } else {
        let typed = line.command.is_some();
        let (names, options): (Vec<_>, Vec<_>) = line.either.iter().cloned().partition(|w| is_name(w, typed));
        // With a command, `-A` is Glint's.
        let (own, options): (Vec<_>, Vec<_>) = options.into_iter().partition(|w| typed && w == "-A");
        let options: Vec<_> = line.povray.iter().cloned().chain(options).collect();
        let first = names.first().filter(|_| !typed).map(|n| format!("+I{n}"));
        let options: Vec<_> = first.into_iter().chain(options).collect();
        let found = InGlint::of(&options, [line.value("-W"), line.value("-H")], !typed);
        let found = found.map_err(|failure| failure.message)?;
        let named = if typed || names.len() > 1 { names } else { Vec::new() };
        let scene = found.scene.filter(|s| !named.contains(s));
        words.extend(named.into_iter().chain(scene));
        for choice in
            found.choices.into_iter().filter(|c| c.name == "-L" || c.name == "-D" || !has(line, c.name))
        {
            if takes(command, choice.name) {
                words.extend(choice.words);
            } else {
                lost.push(format!("`{}` in `glint {command}`", choice.name));
            }
        }
        words.extend(own);
        lost.extend(found.lost);
    }
    words.extend(line.glint.iter().flat_map(|g| g.words.iter().cloned()));
    Ok((quoted(&words), lost))
}

fn has(line: &Sorted, name: &str) -> bool {
    line.glint.iter().any(|g| g.name == name)
}

/// A file rather than an option; folders are files where a command of Glint's was typed.
fn is_name(word: &str, typed: bool) -> bool {
    let option = word.len() > 1 && word.starts_with(['-', '+']);
    let keyword = word.split_once('=').is_some();
    let scene = word == "-" || word.to_ascii_lowercase().ends_with(".pov");
    !option && !keyword && (scene || typed) && (typed || !word.ends_with(is_separator))
}

/// Whether a command has an option.
fn takes(command: &str, option: &str) -> bool {
    let cli = Cli::command();
    let found = cli.find_subcommand(command);
    found.is_some_and(|c| {
        c.get_arguments().any(|a| match option.strip_prefix("--") {
            Some(long) => a.get_long() == Some(long),
            None => a.get_short().is_some_and(|s| option == format!("-{s}")),
        })
    })
}

/// The same with POV-Ray's switches, and what they lack. Only rendering can be asked for there.
fn to_povray(line: &Sorted) -> (Option<String>, Vec<String>) {
    if line.command.as_deref().is_some_and(|c| c != "render") {
        return (None, Vec::new());
    }
    let mut words = vec!["glint".to_owned(), "pov".to_owned()];
    words.extend(line.either.iter().chain(&line.povray).cloned());
    let mut missing = Vec::new();
    for given in &line.glint {
        match in_povray(given) {
            Some(switches) => words.extend(switches),
            None => missing.push(format!("`{}`", given.words.join(" "))),
        }
    }
    (Some(quoted(&words)), missing)
}

/// The switches for one of Glint's options.
fn in_povray(given: &Given) -> Option<Vec<String>> {
    let value = given.value.as_deref();
    let switch = |letters: &str| Some(vec![format!("{letters}{}", value.unwrap_or_default())]);
    match (given.name.as_str(), value) {
        ("-W", Some(_)) => switch("+W"),
        ("-H", Some(_)) => switch("+H"),
        ("-o", Some(_)) => switch("+O"),
        ("-L", Some(_)) => switch("+L"),
        ("-D", Some(_)) => switch("Declare="),
        ("-A", _) => switch("+A"),
        ("--aa-method", Some("1" | "2")) => switch("+AM"),
        ("--aa-depth", Some(_)) => switch("+R"),
        ("--jitter", Some(on)) => Some(vec![if on == "on" { "+J" } else { "-J" }.to_owned()]),
        ("--threads", Some(_)) => switch("+WT"),
        ("--clock", Some(_)) => switch("+K"),
        ("--quality", Some(_)) => switch("+Q"),
        ("--bits", Some(_)) => switch("Bits_Per_Color="),
        ("--alpha", None) => switch("+UA"),
        ("-q", None) => switch("-GA"),
        ("--allow-read" | "--allow-write", Some(folder)) => Some(vec![format!("{}={folder}", given.name)]),
        ("--region", Some(corners)) => {
            let corner: Vec<u32> = corners.split(',').filter_map(|n| n.trim().parse().ok()).collect();
            let [x0, y0, x1, y1] = corner.try_into().ok()?;
            let part = [("SC", x0 + 1), ("SR", y0 + 1), ("EC", x1), ("ER", y1)];
            Some(part.map(|(letters, n)| format!("+{letters}{n}")).to_vec())
        }
        _ => None,
    }
}

/// Words as a shell takes them.
fn quoted(words: &[String]) -> String {
    let plain = |c: char| c.is_alphanumeric() || "-_./+=,:@%".contains(c);
    let quote = |w: &String| {
        if !w.is_empty() && w.chars().all(plain) {
            w.clone()
        } else {
            format!("'{}'", w.replace('\'', r"'\''"))
        }
    };
    words.iter().map(quote).collect::<Vec<_>>().join(" ")
}
