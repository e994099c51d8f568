//! Options as they were given, the last one winning.

use super::table::{Kind, TABLE};
use crate::cli::exit::Failure;
use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

#[derive(Clone, Debug, Default)]
pub struct Settings {
    /// By keyword as the table writes it.
    values: BTreeMap<&'static str, String>,
    /// Keywords that the user gave, not a file that is read unasked.
    given: BTreeSet<&'static str>,
    pub library: Vec<PathBuf>,
    /// Folders that scenes may read, and those that they may write, besides the usual ones.
    pub readable: Vec<PathBuf>,
    pub writable: Vec<PathBuf>,
    pub declares: Vec<(String, String)>,
    /// What INI files say in vain.
    pub remarks: Vec<String>,
}

impl Settings {
    /// `keyword=value`, from an INI file or the command line.
    pub fn set(&mut self, keyword: &str, value: &str) -> Result<(), Failure> {
        let unknown = || Failure::usage(format!("{keyword}={value}: POV-Ray has no option `{keyword}`"));
        let known = TABLE.keyword(keyword).ok_or_else(unknown)?;
        let value = unquoted(value);
        let good = match known.kind {
            Kind::Bool => boolean(value).is_some(),
            Kind::Int | Kind::Float => value.parse::<f64>().is_ok_and(f64::is_finite),
            Kind::String | Kind::Obsolete | Kind::Special | Kind::None => true,
        };
        if !good {
            return Err(Failure::usage(format!("{}={value}: {}", known.name, expected(known.kind))));
        }
        if let Some(range) = out_of_range(known.name, value) {
            return Err(Failure::usage(format!("{}={value}: expected {range}", known.name)));
        }
        self.given.insert(known.name);
        match known.name {
            "Library_Path" => self.library.push(value.into()),
            "Declare" => self.declares.push(declaration(value)?),
            "Bits_Per_Colour" => {
                self.values.insert("Bits_Per_Color", value.to_owned());
            }
            name => {
                self.values.insert(name, value.to_owned());
            }
        }
        Ok(())
    }

    /// What has been set so far was not given by the user.
    pub fn forget_who(&mut self) {
        self.given.clear();
    }

    /// Keywords that the user gave, with their values.
    pub fn given(&self) -> impl Iterator<Item = (&'static str, &str)> {
        self.given.iter().map(|&name| (name, self.text(name).unwrap_or_default()))
    }

    /// The lines of an INI file that asks for the same.
    pub fn ini(&self) -> String {
        let line = |(&name, value): (&&str, &String)| match TABLE.keyword(name).map(|k| k.kind) {
            Some(Kind::String) => format!("{name}=\"{value}\"\n"),
            _ => format!("{name}={value}\n"),
        };
        let declares = self.declares.iter().map(|(name, value)| format!("Declare={name}={value}\n"));
        let library = self.library.iter().map(|path| format!("Library_Path=\"{}\"\n", path.display()));
        self.values.iter().map(line).chain(declares).chain(library).collect()
    }

    pub fn text(&self, keyword: &str) -> Option<&str> {
        debug_assert!(TABLE.keyword(keyword).is_some_and(|k| k.name == keyword), "{keyword}");
        self.values.get(keyword).map(String::as_str)
    }

    pub fn flag(&self, keyword: &str, default: bool) -> bool {
        self.text(keyword).and_then(boolean).unwrap_or(default)
    }

    pub fn float(&self, keyword: &str) -> Option<f64> {
        self.text(keyword)?.parse().ok()
    }

    /// A whole number; fractions are cut off.
    pub fn int(&self, keyword: &str) -> Option<i64> {
        self.float(keyword).map(|v| v as i64)
    }
}

/// What a value should be that its option cannot take.
fn out_of_range(name: &str, value: &str) -> Option<&'static str> {
    let number = value.parse::<f64>();
    match name {
        "Start_Column" | "Start_Row" | "End_Column" | "End_Row" => {
            number.is_ok_and(|v| v < 0.0).then_some("a number from 0 up")
        }
        "Render_Block_Size" => number.is_ok_and(|v| v < 4.0).then_some("at least 4"),
        "Dither_Method" => {
            let known = ["B2", "B3", "B4", "D1", "D2", "FS"].iter().any(|m| value.eq_ignore_ascii_case(m));
            (!known).then_some("B2, B3, B4, D1, D2 or FS")
        }
        "Display_Gamma" => {
            let good = value.eq_ignore_ascii_case("sRGB") || number.is_ok_and(|v| v > 0.0);
            (!good).then_some("sRGB or a number above 0")
        }
        _ => None,
    }
}

fn expected(kind: Kind) -> &'static str {
    match kind {
        Kind::Bool => "expected on or off",
        Kind::Int => "expected a whole number",
        _ => "expected a number",
    }
}

/// The value without its quotes.
fn unquoted(value: &str) -> &str {
    let value = value.trim();
    let inner = |q: char| value.strip_prefix(q).and_then(|v| v.strip_suffix(q));
    inner('"').or_else(|| inner('\'')).unwrap_or(value)
}

/// `on`, `yes`, `true`, `1`, nothing, and their opposites; the beginning of a word is enough.
pub fn boolean(text: &str) -> Option<bool> {
    let text = text.to_ascii_lowercase();
    let begins = |words: [&str; 3]| words.iter().any(|w| w.starts_with(&text));
    match text.as_str() {
        "1" | "" => Some(true),
        "0" => Some(false),
        _ if begins(["on", "yes", "true"]) => Some(true),
        _ if begins(["off", "no", "false"]) => Some(false),
        _ => None,
    }
}

fn declaration(text: &str) -> Result<(String, String), Failure> {
    let parts = text.split_once('=').map(|(name, value)| (name.trim().to_owned(), value.trim().to_owned()));
    parts.ok_or_else(|| Failure::usage(format!("Declare={text}: expected Declare=NAME=VALUE")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_value_wins() {
        let mut s = Settings::default();
        s.set("width", "320").unwrap();
        s.set("WIDTH", "\"160\"").unwrap();
        s.set("Library_Path", "a").unwrap();
        s.set("library_path", "b/").unwrap();
        s.set("Declare", "Detail=3").unwrap();
        assert_eq!(s.int("Width"), Some(160));
        assert_eq!(s.library, [PathBuf::from("a"), PathBuf::from("b/")]);
        assert_eq!(s.declares, [("Detail".to_owned(), "3".to_owned())]);
        assert!(s.flag("Antialias", true) && !s.flag("Antialias", false));
        let ini = "Width=160\nDeclare=Detail=3\nLibrary_Path=\"a\"\nLibrary_Path=\"b/\"\n";
        assert_eq!(s.ini(), ini);
        assert_eq!(s.given().count(), 3);
        s.forget_who();
        assert_eq!(s.given().count(), 0);
    }

    /// As measured: `o` is `on`, and nothing at all is `on`.
    #[test]
    fn booleans_have_many_names() {
        for on in ["on", "ON", "y", "Yes", "tru", "1", "", "o"] {
            assert_eq!(boolean(on), Some(true), "{on}");
        }
        for off in ["off", "of", "n", "No", "F", "0"] {
            assert_eq!(boolean(off), Some(false), "{off}");
        }
        assert_eq!((boolean("maybe"), boolean("2")), (None, None));
    }

    #[test]
    fn wrong_values_are_refused() {
        for (keyword, value) in [("Widht", "3"), ("Width", "x"), ("Antialias", "maybe"), ("Declare", "a")] {
            assert!(Settings::default().set(keyword, value).is_err(), "{keyword}={value}");
        }
    }
}
