//! The options that POV-Ray knows: INI keywords, and switches with the keywords that they set.

use std::sync::LazyLock;

/// How a value is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Bool,
    Int,
    Float,
    String,
    /// Accepted and without meaning.
    Obsolete,
    /// Has rules of its own.
    Special,
    /// A switch without a value.
    None,
}

#[derive(Debug)]
pub struct Keyword {
    pub name: &'static str,
    pub kind: Kind,
}

#[derive(Debug)]
pub struct Switch {
    pub letters: &'static str,
    pub kind: Kind,
    /// The keyword that gets the value.
    pub keyword: &'static str,
    /// The keyword that `+` turns on and `-` turns off.
    pub toggles: &'static str,
}

pub struct Table {
    pub keywords: Vec<Keyword>,
    /// The longest first.
    pub switches: Vec<Switch>,
}

pub static TABLE: LazyLock<Table> = LazyLock::new(|| Table::parse(include_str!("options.csv")));

impl Table {
    fn parse(text: &'static str) -> Table {
        let mut table = Table { keywords: Vec::new(), switches: Vec::new() };
        for line in text.lines().filter(|l| !l.starts_with('#')) {
            let mut fields = line.split(',');
            let mut field = || fields.next().unwrap_or_default();
            let (what, name, kind) = (field(), field(), kind(field()));
            if what == "ini" {
                table.keywords.push(Keyword { name, kind });
            } else {
                // A trailing 0 tells fractions from whole numbers; the value tells that here.
                let letters = name.trim_end_matches('0');
                table.switches.push(Switch { letters, kind, keyword: field(), toggles: field() });
            }
        }
        table.switches.sort_by_key(|s| std::cmp::Reverse(s.letters.len()));
        table
    }

    /// The keyword by its name in any case.
    pub fn keyword(&self, name: &str) -> Option<&Keyword> {
        self.keywords.iter().find(|k| k.name.eq_ignore_ascii_case(name))
    }
}

fn kind(name: &str) -> Kind {
    match name {
        "bool" => Kind::Bool,
        "int" => Kind::Int,
        "float" => Kind::Float,
        "string" => Kind::String,
        "obsolete" => Kind::Obsolete,
        "none" => Kind::None,
        _ => Kind::Special,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn switches_set_keywords_that_exist() {
        assert!(TABLE.keywords.len() > 100 && TABLE.switches.len() > 60);
        for s in &TABLE.switches {
            for name in [s.keyword, s.toggles].into_iter().filter(|n| !n.is_empty()) {
                assert!(TABLE.keyword(name).is_some(), "+{} sets {name}", s.letters);
            }
        }
        assert_eq!(TABLE.keyword("antialias_DEPTH").unwrap().kind, Kind::Int);
    }
}
