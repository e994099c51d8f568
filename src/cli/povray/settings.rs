//! Options as they were given, the last one winning.

use super::table::{Kind, TABLE};
use crate::cli::exit::Failure;
use std::collections::HashMap;
use std::path::PathBuf;

#[derive(Clone, Debug, Default)]
pub struct Settings {
    /// By keyword in lower case.
    values: HashMap<String, String>,
    pub library: Vec<PathBuf>,
    pub declares: Vec<(String, String)>,
}

impl Settings {
    /// `keyword=value`, from an INI file or the command line.
    pub fn set(&mut self, keyword: &str, value: &str) -> Result<(), Failure> {
        let unknown = || Failure::usage(format!("{keyword}={value}: POV-Ray has no option `{keyword}`"));
        let known = TABLE.keyword(keyword).ok_or_else(unknown)?;
        let value = unquoted(value);
        let good = match known.kind {
            Kind::Bool => boolean(value).is_some(),
            Kind::Int => value.parse::<i64>().is_ok(),
            Kind::Float => value.parse::<f64>().is_ok(),
            Kind::String | Kind::Obsolete | Kind::Special | Kind::None => true,
        };
        if !good {
            return Err(Failure::usage(format!("{}={value}: {}", known.name, expected(known.kind))));
        }
        match known.name {
            "Library_Path" => self.library.push(value.into()),
            "Declare" => self.declares.push(declaration(value)?),
            name => {
                self.values.insert(name.to_ascii_lowercase(), value.to_owned());
            }
        }
        Ok(())
    }

    pub fn text(&self, keyword: &str) -> Option<&str> {
        debug_assert!(TABLE.keyword(keyword).is_some(), "{keyword}");
        self.values.get(&keyword.to_ascii_lowercase()).map(String::as_str)
    }

    pub fn flag(&self, keyword: &str, default: bool) -> bool {
        self.text(keyword).and_then(boolean).unwrap_or(default)
    }

    pub fn float(&self, keyword: &str) -> Option<f64> {
        self.text(keyword)?.parse().ok()
    }

    pub fn int(&self, keyword: &str) -> Option<i64> {
        self.text(keyword)?.parse().ok()
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

/// `on`, `yes`, `true`, `1` and their opposites.
pub fn boolean(text: &str) -> Option<bool> {
    let is = |words: [&str; 4]| words.iter().any(|w| text.eq_ignore_ascii_case(w));
    if is(["on", "yes", "true", "1"]) {
        Some(true)
    } else if is(["off", "no", "false", "0"]) {
        Some(false)
    } else {
        None
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
    }

    #[test]
    fn wrong_values_are_refused() {
        for (keyword, value) in [("Widht", "3"), ("Width", "x"), ("Antialias", "maybe"), ("Declare", "a")] {
            assert!(Settings::default().set(keyword, value).is_err(), "{keyword}={value}");
        }
    }
}
