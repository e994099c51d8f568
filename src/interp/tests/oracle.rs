use super::{parser, read};
use crate::color::Color;
use crate::syntax::{Keyword, SPELLINGS};

const ORACLE: &str = include_str!("../../../tests/data/language-oracle.csv");
const RESERVED: &str = include_str!("../../../tests/data/reserved-words.csv");

/// The fields of one line of comma-separated values.
fn fields(line: &str) -> Vec<String> {
    let (mut fields, mut quoted) = (vec![String::new()], false);
    let mut chars = line.chars().peekable();
    while let Some(c) = chars.next() {
        let field = fields.last_mut().unwrap();
        match c {
            '"' if quoted && chars.peek() == Some(&'"') => {
                chars.next();
                field.push('"');
            }
            '"' => quoted = !quoted,
            ',' if !quoted => fields.push(String::new()),
            _ => field.push(c),
        }
    }
    fields
}

fn join(values: &[f64], digits: usize) -> String {
    values.iter().map(|v| format!("{v:.digits$}")).collect::<Vec<_>>().join(" ")
}

/// Prints in the way that the table was printed.
fn printed(kind: &str, expression: &str) -> String {
    let text = format!("#declare CC = rgb <1 1 1> filter 0.3 transmit 0.1; {expression}");
    match kind {
        "float" => read(&text, |p| p.float().map(|v| format!("{v:.15}"))),
        "vector" => read(&text, |p| p.vector().map(|v| join(&v.to_array(), 15))),
        "colour" => {
            let components = |c: Color| c.components().map(f64::from);
            read(&text, |p| p.color().map(|c| join(&components(c), 9)))
        }
        "string" => read(&text, |p| p.string()),
        "rand" => {
            let seed = expression.split(':').next().unwrap();
            let text = format!("#declare R = {seed}; {}", "rand(R) ".repeat(5));
            let mut p = parser(&text);
            join(&std::array::from_fn::<f64, 5, _>(|_| p.float().unwrap()), 15)
        }
        other => panic!("unknown kind {other}"),
    }
}

#[test]
fn every_row_of_the_language_oracle() {
    let mut rows = 0;
    for line in ORACLE.lines().filter(|l| !l.starts_with('#')) {
        let row = fields(line);
        let [kind, expression, expected] = &row[..] else { panic!("{line}") };
        let found = printed(kind, expression);
        let near = |a: &str, b: &str| match (a.parse::<f64>(), b.parse::<f64>()) {
            // The last digit printed may round differently.
            (Ok(a), Ok(b)) if kind != "string" => (a - b).abs() <= 1.1e-15 * a.abs().max(1.0),
            _ => a == b,
        };
        let (f, e): (Vec<&str>, Vec<&str>) = (found.split(' ').collect(), expected.split(' ').collect());
        assert!(f.len() == e.len() && f.iter().zip(&e).all(|(f, e)| near(f, e)), "{line}\nfound {found}");
        rows += 1;
    }
    assert!(rows > 130, "only {rows} rows");
}

#[test]
fn reserved_words_are_those_of_the_language() {
    let reserved: Vec<String> =
        RESERVED.lines().filter(|l| !l.starts_with('#')).map(|l| fields(l).remove(0)).collect();
    for word in &reserved {
        assert!(SPELLINGS.iter().any(|(text, _)| text == word), "{word} is missing");
    }
    for (text, _) in SPELLINGS {
        assert!(reserved.iter().any(|word| word == text), "{text} is no reserved word");
    }
    assert_eq!(Keyword::Color.text(), "color");
}
