//! Words of the command line, and lines of INI files, to settings.

use super::naming::FileType;
use super::settings::Settings;
use super::table::{Kind, Switch, TABLE};
use crate::cli::exit::Failure;
use crate::cli::scene::must_exist;
use std::path::{Path, PathBuf};

/// INI files that name INI files end here.
const MAX_DEPTH: usize = 10;

/// Applies one word: a switch, `Keyword=value`, a scene, a folder for included files, or an INI file.
pub fn apply(settings: &mut Settings, word: &str) -> Result<(), Failure> {
    apply_nested(settings, word, 0)
}

fn apply_nested(settings: &mut Settings, word: &str, depth: usize) -> Result<(), Failure> {
    if word == "--resume" {
        return settings.set("Continue_Trace", "on");
    }
    for (option, folders) in
        [("--allow-read", &mut settings.readable), ("--allow-write", &mut settings.writable)]
    {
        if let Some(folder) = word.strip_prefix(option).and_then(|rest| rest.strip_prefix('=')) {
            folders.push(folder.into());
            return must_exist(option, folders);
        }
    }
    if word.starts_with(['+', '-']) && word.len() > 1 {
        return switch(settings, word);
    }
    if let Some((keyword, value)) = word.split_once('=') {
        return keyword_value(settings, keyword.trim(), value, depth);
    }
    if word == "-" || word.to_ascii_lowercase().ends_with(".pov") {
        return settings.set("Input_File_Name", word);
    }
    if word.ends_with(std::path::is_separator) {
        return settings.set("Library_Path", word);
    }
    ini_file(settings, word, depth)
}

fn keyword_value(settings: &mut Settings, keyword: &str, value: &str, depth: usize) -> Result<(), Failure> {
    if keyword.eq_ignore_ascii_case("Include_Ini") {
        return ini_file(settings, value.trim().trim_matches('"'), depth + 1);
    }
    settings.set(keyword, value)
}

/// `+W320`, `-A`, `+FN16` …
fn switch(settings: &mut Settings, word: &str) -> Result<(), Failure> {
    let (sign, rest) = word.split_at(1);
    let fitting = |s: &&Switch| {
        let head = rest.get(..s.letters.len());
        head.is_some_and(|h| h.eq_ignore_ascii_case(s.letters)) && fits(s.kind, &rest[s.letters.len()..])
    };
    let Some(found) = TABLE.switches.iter().find(fitting) else {
        return Err(Failure::usage(format!("{word}: POV-Ray has no such switch, or its value is wrong")));
    };
    let value = &rest[found.letters.len()..];
    if found.keyword == "Output_File_Type" {
        settings.set(found.toggles, if sign == "+" { "on" } else { "off" })?;
        return file_type(settings, word, value);
    }
    if !found.toggles.is_empty() {
        settings.set(found.toggles, if sign == "+" { "on" } else { "off" })?;
    }
    // `+DGT` names a kind of window.
    let names_a_window = found.keyword == found.toggles;
    if !found.keyword.is_empty() && found.kind != Kind::None && !names_a_window {
        settings.set(found.keyword, value)?;
    }
    Ok(())
}

/// A letter, and the bits of a channel or `g` for grey.
fn file_type(settings: &mut Settings, word: &str, value: &str) -> Result<(), Failure> {
    let (letter, rest) = value.split_at(value.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(1).min(1));
    if letter.is_empty() && !rest.is_empty() {
        return Err(Failure::usage(format!("{word}: expected the letter of a file type, such as +FN")));
    }
    if !letter.is_empty() {
        settings.set("Output_File_Type", letter)?;
        FileType::of(settings)?;
    }
    match rest {
        "" => Ok(()),
        "g" | "G" => settings.set("Grayscale_Output", "on"),
        bits if bits.parse::<u32>().is_ok() => settings.set("Bits_Per_Color", bits),
        _ => Err(Failure::usage(format!(
            "{word}: expected a letter, and the bits of a channel or g for grey, such as +FN16 or +FNg"
        ))),
    }
}

/// Whether the rest of a switch can be its value.
fn fits(kind: Kind, value: &str) -> bool {
    match kind {
        Kind::None => value.is_empty(),
        Kind::Int | Kind::Float => value.parse::<f64>().is_ok_and(f64::is_finite),
        _ => !value.is_empty(),
    }
}

/// `name`, `name.ini`, `name[section]`.
fn ini_file(settings: &mut Settings, word: &str, depth: usize) -> Result<(), Failure> {
    if depth > MAX_DEPTH {
        return Err(Failure::usage(format!("{word}: INI files include each other")));
    }
    let (name, section) = match word.split_once('[') {
        Some((name, section)) => match section.strip_suffix(']') {
            Some(section) => (name, Some(section)),
            None => return Err(Failure::usage(format!("{word}: the section's name has no `]` behind it"))),
        },
        None => (word, None),
    };
    let path = find_ini(settings, name).ok_or_else(|| {
        Failure::unavailable(format!(
            "{word}: no such INI file (a scene's name ends in .pov, or is given as +I{word})"
        ))
    })?;
    read_file(settings, &path, section, depth)
}

/// Applies an INI file.
pub fn read_file(
    settings: &mut Settings,
    path: &Path,
    section: Option<&str>,
    depth: usize,
) -> Result<(), Failure> {
    let bytes = std::fs::read(path).map_err(|e| Failure::unavailable(format!("{}: {e}", path.display())))?;
    read_ini(settings, path, &String::from_utf8_lossy(&bytes), section, depth)
}

/// Looks in the current folder, then in the library's; `.ini` may be left away.
fn find_ini(settings: &Settings, name: &str) -> Option<PathBuf> {
    let folders = std::iter::once(PathBuf::new()).chain(settings.library.iter().cloned());
    let mut paths = folders.flat_map(|f| [f.join(name), f.join(format!("{name}.ini"))]);
    paths.find(|p| p.is_file())
}

/// Options before the first header always count, those behind a header only if it was asked for.
fn read_ini(
    settings: &mut Settings,
    path: &Path,
    text: &str,
    section: Option<&str>,
    depth: usize,
) -> Result<(), Failure> {
    let mut counts = true;
    let mut found = section.is_none_or(str::is_empty);
    let text = text.replace("\r\n", "\n");
    for (number, line) in text.split(['\n', '\r']).enumerate() {
        let mut line = without_comment(line).trim();
        if let Some(rest) = line.strip_prefix('[') {
            let (header, rest) = rest.split_once(']').map_or((None, ""), |(h, r)| (Some(h), r));
            counts = header.zip(section).is_some_and(|(h, asked)| h.eq_ignore_ascii_case(asked));
            line = rest.trim();
            found |= counts;
        }
        if line.is_empty() || !counts {
            continue;
        }
        if line.matches('"').count() % 2 == 1 {
            let place = format!("{}:{}", path.display(), number + 1);
            return Err(Failure::usage(format!("{place}: a quotation mark stands alone")));
        }
        let place =
            |f: Failure| Failure { message: format!("{}:{}: {}", path.display(), number + 1, f), ..f };
        ini_line(settings, line, depth).map_err(place)?;
    }
    if let (false, Some(section)) = (found, section) {
        settings.remarks.push(format!("{} has no section [{section}]", path.display()));
    }
    Ok(())
}

/// Switches, names of files, and one `Keyword=value` at the end.
fn ini_line(settings: &mut Settings, line: &str, depth: usize) -> Result<(), Failure> {
    let mut rest = line.trim_start();
    while !rest.is_empty() {
        if !rest.starts_with(['+', '-'])
            && let Some((keyword, value)) = rest.split_once('=')
        {
            return ini_value(settings, keyword.trim(), value.trim_start(), depth);
        }
        let end = unquoted(rest, |at, c| c.is_whitespace() && at > 0);
        let word = &rest[..end];
        if word == "-" {
            return Err(Failure::usage("-: a switch needs a letter".to_owned()));
        }
        apply_nested(settings, word, depth + 1)?;
        rest = rest[end..].trim_start();
    }
    Ok(())
}

/// A value goes on up to what looks like a switch; numbers, on and off are one word. What comes then is left out.
fn ini_value(settings: &mut Settings, keyword: &str, text: &str, depth: usize) -> Result<(), Failure> {
    let kind = TABLE.keyword(keyword).map(|k| k.kind);
    let single = matches!(kind, Some(Kind::Int | Kind::Float | Kind::Bool));
    let end = unquoted(text, |at, c| {
        c.is_whitespace() && (single || text[at..].trim_start().starts_with(['+', '-']))
    });
    let (value, rest) = (text[..end].trim_end(), text[end..].trim());
    if !rest.is_empty() {
        settings.remarks.push(format!("{keyword}={value}: what stands behind it, `{rest}`, is left out"));
    }
    keyword_value(settings, keyword, value, depth)
}

/// Where `ends` holds first outside of quotes, or the length.
fn unquoted(text: &str, ends: impl Fn(usize, char) -> bool) -> usize {
    let mut quoted = false;
    for (at, c) in text.char_indices() {
        quoted ^= c == '"';
        if !quoted && ends(at, c) {
            return at;
        }
    }
    text.len()
}

/// The line up to `;` or `#` outside of quotes.
fn without_comment(line: &str) -> &str {
    &line[..unquoted(line, |_, c| matches!(c, ';' | '#'))]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn settings(words: &[&str]) -> Settings {
        let mut settings = Settings::default();
        for word in words {
            apply(&mut settings, word).unwrap_or_else(|e| panic!("{word}: {e}"));
        }
        settings
    }

    #[test]
    fn switches_find_their_keywords() {
        let s = settings(&[
            "+Iscene", "+w320", "-H200", "+A0.1", "+AM2", "+R4", "-J", "+Q8", "+UA", "+FN16", "+KFF12",
            "+K0.5",
        ]);
        assert_eq!(s.text("Input_File_Name"), Some("scene"));
        assert_eq!((s.int("Width"), s.int("Height")), (Some(320), Some(200)));
        assert_eq!((s.float("Antialias_Threshold"), s.int("Sampling_Method")), (Some(0.1), Some(2)));
        assert!(s.flag("Antialias", false) && !s.flag("Jitter", true) && s.flag("Output_Alpha", false));
        assert_eq!((s.int("Final_Frame"), s.float("Clock")), (Some(12), Some(0.5)));
        assert_eq!((s.text("Output_File_Type"), s.int("Bits_Per_Color")), (Some("N"), Some(16)));
    }

    #[test]
    fn a_switch_without_a_value_only_toggles() {
        let s = settings(&["+A0.1", "-A", "+DGT", "-D", "-P", "+GAlog.txt", "+SC0.25", "+EC10"]);
        assert!(!s.flag("Antialias", true) && !s.flag("Display", true));
        assert_eq!((s.float("Antialias_Threshold"), s.text("All_File")), (Some(0.1), Some("log.txt")));
        assert_eq!((s.float("Start_Column"), s.float("End_Column")), (Some(0.25), Some(10.0)));
    }

    #[test]
    fn bare_words_are_told_apart() {
        let s = settings(&["a.pov", "inc/", "Width=64.9", "Declare=x=1.5"]);
        assert_eq!((s.text("Input_File_Name"), s.int("Width")), (Some("a.pov"), Some(64)));
        assert_eq!(s.library, [PathBuf::from("inc/")]);
        assert!(apply(&mut Settings::default(), "nosuchfile").is_err());
        for wrong in ["+Z", "+W", "+Wx", "+QQ", "Bogus=1", "+FS", "+FN16g", "+Fx"] {
            assert!(apply(&mut Settings::default(), wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn file_types_are_letters_with_bits_or_grey() {
        let s = settings(&["-FN16", "+FPg"]);
        assert_eq!((s.text("Output_File_Type"), s.int("Bits_Per_Color")), (Some("P"), Some(16)));
        assert!(s.flag("Grayscale_Output", false) && s.flag("Output_To_File", false));
        assert!(!settings(&["-F"]).flag("Output_To_File", true));
        assert!(settings(&["--resume"]).flag("Continue_Trace", false));
    }

    #[test]
    fn ini_sections_count_when_asked_for() {
        let text = "Width=8 ; a comment\n+H6 +A\n# more\n[Big]\nWidth=16\nOutput_File_Name=\"a;b\"\n[other]\nHeight=99\n";
        let read = |section: &'static str| {
            let mut s = Settings::default();
            let asked = Some(section).filter(|s| !s.is_empty());
            read_ini(&mut s, Path::new("x.ini"), text, asked, 0).unwrap();
            (s.int("Width"), s.int("Height"), s.text("Output_File_Name").map(String::from))
        };
        assert_eq!(read(""), (Some(8), Some(6), None));
        assert_eq!(read("BIG"), (Some(16), Some(6), Some("a;b".to_owned())));
        assert_eq!(read("other"), (Some(8), Some(99), None));
        let mut s = Settings::default();
        let error = read_ini(&mut s, Path::new("x.ini"), "Width=8\nBogus=1\n", None, 0).unwrap_err();
        assert!(error.message.starts_with("x.ini:2: "), "{error}");
    }
}
