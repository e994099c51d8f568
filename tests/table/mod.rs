//! Tables of values that POV-Ray 3.7 printed, and the list of rows that Glint answers differently on
//! purpose.

use std::collections::HashMap;
use std::path::PathBuf;

/// One line: its number in the file (from 1) and its fields.
pub struct Row {
    pub number: usize,
    pub fields: Vec<String>,
}

impl Row {
    // Not every test reads numbers.
    #[allow(dead_code)]
    pub fn floats(&self, from: usize, count: usize) -> Vec<f64> {
        self.fields[from..from + count].iter().map(|f| f.parse().expect("a number")).collect()
    }
}

/// The rows of `tests/data/<name>`, without comments and without the heading if it begins with `heading`.
pub fn rows(name: &str, heading: &str) -> Vec<Row> {
    let text = std::fs::read_to_string(path("data").join(name)).expect("a table");
    let lines = text.lines().enumerate().map(|(i, l)| Row { number: i + 1, fields: fields(l) });
    lines
        .filter(|r| !r.fields[0].starts_with('#') && r.fields[0] != heading && !r.fields[0].is_empty())
        .collect()
}

/// Leaves the rows out that show texts in the fonts that come with POV-Ray's include files, where these are missing.
// Not every table has texts.
#[allow(dead_code)]
pub fn without_missing_fonts(mut rows: Vec<Row>, name: &str, is_text: impl Fn(&Row) -> bool) -> Vec<Row> {
    if !std::path::Path::new("/usr/share/povray-3.7/include/timrom.ttf").exists() {
        assert!(std::env::var_os("GLINT_REQUIRE_POVRAY").is_none(), "povray-includes is not installed");
        let all = rows.len();
        rows.retain(|row| !is_text(row));
        println!("skipped: {} rows of texts in {name}, for want of POV-Ray's fonts", all - rows.len());
    }
    rows
}

/// Row numbers of table `name` in `tests/deviations.csv`, with the reasons.
pub fn deviations(name: &str) -> HashMap<usize, String> {
    let text = std::fs::read_to_string(path("deviations.csv")).expect("a table");
    let rows = text.lines().map(fields).filter(|f| f[0] == name);
    rows.map(|f| (f[1].parse().expect("a row number"), f[4].clone())).collect()
}

fn path(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests").join(name)
}

/// The fields of one line of comma-separated values.
fn fields(line: &str) -> Vec<String> {
    let (mut fields, mut quoted) = (vec![String::new()], false);
    let mut chars = line.chars().peekable();
    while let Some(c) = chars.next() {
        let field = fields.last_mut().expect("one field at least");
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

/// Compares every row and reports: rows that deviate must be listed, listed ones must deviate.
#[allow(dead_code)]
pub fn check(name: &str, rows: &[Row], mut compare: impl FnMut(&Row) -> Result<(), String>) {
    let listed = deviations(name);
    let (mut passed, mut wrong) = (0, Vec::new());
    for row in rows {
        match (compare(row), listed.get(&row.number)) {
            (Ok(()), None) => passed += 1,
            (Ok(()), Some(_)) => wrong.push(format!("{name}:{}: listed, but agrees", row.number)),
            (Err(_), Some(_)) => {}
            (Err(e), None) => wrong.push(format!("{name}:{}: {e}", row.number)),
        }
    }
    println!("{name}: {passed} of {} rows agree, {} deviate on purpose", rows.len(), listed.len());
    assert!(wrong.is_empty(), "{} rows are wrong:\n{}", wrong.len(), wrong.join("\n"));
}
