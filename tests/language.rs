//! The scene language from outside: what scenes print, beside what POV-Ray prints for them; a table of every
//! reserved word; functions by name.

use glint::interp::{IncludeMode, Options, Outcome, SceneSource, interpret};
use glint::syntax::SPELLINGS;
use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests").join(name)
}

/// Whether POV-Ray's include files are installed: their fonts and images are not ours to carry.
fn is_installed() -> bool {
    let found = Path::new("/usr/share/povray-3.7/include/colors.inc").exists();
    assert!(found || std::env::var_os("GLINT_REQUIRE_POVRAY").is_none(), "povray-includes is not installed");
    if !found {
        println!("skipped: POV-Ray's include files are not installed");
    }
    found
}

fn read(text: &str, includes: IncludeMode) -> Outcome {
    read_as(text, includes, false)
}

fn read_as(text: &str, includes: IncludeMode, strict: bool) -> Outcome {
    let source = SceneSource::Text { name: "scene.pov".to_owned(), text: text.as_bytes().to_vec() };
    let library_paths = vec![folder("language"), folder("data/images")];
    interpret(source, &Options { library_paths, includes, strict, ..Options::default() })
}

/// Scenes print, text for text, what POV-Ray 3.7 printed (`tests/language/make_expected.sh` asks it again).
/// Those that use standard include files do so with the installed and with the embedded ones.
#[test]
fn scenes_print_what_the_reference_prints() {
    let mut scenes: Vec<PathBuf> =
        fs::read_dir(folder("language")).unwrap().map(|e| e.unwrap().path()).collect();
    scenes.retain(|path| path.extension().is_some_and(|e| e == "pov"));
    scenes.sort();
    assert!(scenes.len() >= 60);
    let modes: &[IncludeMode] = match is_installed() {
        true => &[IncludeMode::Embedded, IncludeMode::Installed],
        false => &[IncludeMode::Embedded],
    };
    let (mut wrong, mut values) = (Vec::new(), 0);
    for scene in scenes {
        let expected = fs::read_to_string(scene.with_extension("expected")).unwrap();
        values += expected.lines().count();
        for &includes in modes {
            let name = scene.file_name().unwrap().to_string_lossy().into_owned();
            if let Err(why) = prints(&scene, &name, includes, &expected) {
                wrong.push(format!("{name}, {includes:?}: {why}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(values > 1000, "only {values} lines were compared");
}

fn prints(scene: &Path, name: &str, includes: IncludeMode, expected: &str) -> Result<(), String> {
    let source = SceneSource::Text { name: name.to_owned(), text: fs::read(scene).unwrap() };
    let options = Options {
        library_paths: vec![folder("language")],
        includes,
        image_width: 4,
        image_height: 3,
        ..Options::default()
    };
    let outcome = interpret(source, &options);
    if let Err(error) = &outcome.scene {
        return Err(format!("{} ({:?})", error.message, error.span));
    }
    // The macros of meshes say how far they are; only the values are compared.
    let said = match name {
        "standard_meshes.pov" => {
            outcome.debug.lines().filter(|line| line.starts_with('>')).collect::<Vec<_>>().join("\n")
        }
        _ => outcome.debug.clone(),
    };
    // The reference ends its file with a line end.
    let found = said.trim_end_matches('\n');
    let expected = expected.trim_end_matches('\n');
    match found.lines().zip(expected.lines()).position(|(f, e)| f != e) {
        Some(at) => Err(format!(
            "line {}: {:?}, the reference {:?}",
            at + 1,
            found.lines().nth(at).unwrap_or_default(),
            expected.lines().nth(at).unwrap_or_default()
        )),
        None if found.len() != expected.len() => {
            Err(format!("{} lines, the reference {}", found.lines().count(), expected.lines().count()))
        }
        None => Ok(()),
    }
}

/// One line of `coverage.txt`.
struct Row {
    words: Vec<String>,
    refused: bool,
    text: String,
}

fn coverage() -> Vec<Row> {
    let table = fs::read_to_string(folder("language/coverage.txt")).unwrap();
    let rows = table.lines().filter(|line| !line.starts_with('#') && !line.is_empty());
    rows.map(|line| {
        let (words, text) = line.split_once(" :: ").unwrap_or_else(|| panic!("no `::` in {line}"));
        let refused = words.starts_with('-');
        let words = words.trim_start_matches('-').split(' ').map(str::to_owned).collect();
        let text = text.replace("$O", "sphere { 0, 1 pigment { rgb 1 } }");
        let text = match text.split_once("$C(") {
            Some((before, after)) => {
                let (items, rest) = after.split_once(')').unwrap();
                format!("{before}camera {{ location -5*z look_at 0 {items} }}{rest}")
            }
            None => text,
        };
        Row {
            words,
            refused,
            text: format!("#version 3.7;\nglobal_settings {{ assumed_gamma 1 }}\n{text}\n"),
        }
    })
    .collect()
}

#[test]
fn every_reserved_word_is_covered() {
    if !is_installed() {
        return;
    }
    fs::create_dir_all("target").unwrap();
    let (mut covered, mut wrong) = (HashSet::new(), Vec::new());
    for row in coverage() {
        let in_text: HashSet<&str> =
            row.text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').collect();
        for word in &row.words {
            if !in_text.contains(word.as_str()) {
                wrong.push(format!("`{word}` does not stand in its own scene"));
            }
        }
        let refusal = read(&row.text, IncludeMode::Auto).scene.err();
        match (row.refused, refusal) {
            (true, None) => wrong.push(format!("{:?} should be refused", row.words)),
            (false, Some(error)) => wrong.push(format!("{:?}: {}", row.words, error.message)),
            _ => {}
        }
        covered.extend(row.words);
    }
    let missing = SPELLINGS.iter().filter(|(word, _)| !covered.contains(*word));
    wrong.extend(missing.map(|(word, _)| format!("`{word}` has no line in tests/language/coverage.txt")));
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Every internal function by its name in functions.inc, the embedded one and the installed one.
#[test]
fn internal_functions_by_name() {
    let table = fs::read_to_string(folder("data/internal-functions-oracle.csv")).unwrap();
    let rows: Vec<Vec<&str>> =
        table.lines().filter(|l| !l.starts_with('#')).map(|l| l.split(',').collect()).collect();
    let mut text = "#version 3.7; #include \"functions.inc\"\n".to_owned();
    // The unnamed internal pattern is not for scenes.
    let named: Vec<&Vec<&str>> = rows.iter().filter(|row| row[1].starts_with("f_")).collect();
    for row in &named {
        text.push_str(&format!(
            "#debug concat(str({}({}),0,15),\"\\n\")\n",
            row[1],
            row[2].replace(' ', ",")
        ));
    }
    assert!(named.len() > 200);
    for includes in [IncludeMode::Embedded, IncludeMode::Auto] {
        let outcome = read(&text, includes);
        if let Err(error) = outcome.scene {
            panic!("{includes:?}: {} {:?}", error.message, error.span);
        }
        for (row, found) in named.iter().zip(outcome.debug.lines()) {
            let (expected, found): (f64, f64) = (row[3].parse().unwrap(), found.parse().unwrap());
            let near = (found - expected).abs() <= 1e-9 * expected.abs().max(1.0);
            assert!(near, "{row:?}: {found}");
        }
    }
}

/// Values of settings, accepted and refused: `tests/data/ranges.txt`.
#[test]
fn settings_have_the_ranges_of_the_table() {
    if !is_installed() {
        return;
    }
    const VALUES: [&str; 11] = ["-1", "0", "0.5", "1", "1.5", "2", "5", "100", "1e10", "-1e10", "-1e-9"];
    let table = fs::read_to_string(folder("data/ranges.txt")).unwrap();
    let (mut wrong, mut asked) = (Vec::new(), 0);
    for (signs, text) in table.lines().filter(|l| !l.starts_with('#')).filter_map(|l| l.split_once(' ')) {
        let text = text
            .replace("@V", "#version 3.7; global_settings{assumed_gamma 1}")
            .replace("@O", "camera{location -4*z look_at 0} light_source{<3,5,-4> rgb 1}")
            .replace("@S", "sphere{0,1 pigment{rgb 1}}");
        assert_eq!(signs.len(), VALUES.len(), "{text}");
        for (sign, value) in signs.chars().zip(VALUES).filter(|&(sign, _)| sign != '.') {
            let text = text.replace('$', value);
            let accepts = |strict| read_as(&text, IncludeMode::Auto, strict).scene.is_ok();
            let expected = match sign {
                '+' | 'r' => (true, true),
                's' => (true, false),
                _ => (false, false),
            };
            asked += 1;
            if (accepts(false), accepts(true)) != expected {
                wrong.push(format!("{sign} {value}: {text}"));
            }
        }
    }
    assert!(asked > 3900, "{asked} values");
    assert!(wrong.is_empty(), "{} values\n{}", wrong.len(), wrong.join("\n"));
}

/// Every standard include file: carried, or refused with the name of the package that has it.
#[test]
fn standard_include_files_are_carried_or_named() {
    const CARRIED: &str = "arrays colors consts debug finish functions ior math meshmaker rad_def rand screen shapes shapes2 shapes3 \
        shapes_old shapesq stdinc strings sunpos transforms";
    const NAMED: &str = "chars glass glass_old golds logo makegrass metals skies stage1 stars stdcam stoneold stones \
        stones1 stones2 textures woodmaps woods";
    let read = |name: &str| {
        let text = format!("#version 3.7; #include \"{name}.inc\"");
        read(&text, IncludeMode::Embedded).scene
    };
    for name in CARRIED.split_whitespace() {
        if let Err(error) = read(name) {
            panic!("{name}: {} {:?}", error.message, error.span);
        }
    }
    for number in 0..11 {
        let settings = format!("radiosity {{ Rad_Settings({number}, on, off) }}");
        let text = format!("#version 3.7; #include \"rad_def.inc\"\nglobal_settings {{ {settings} }}");
        assert!(read_as(&text, IncludeMode::Embedded, true).scene.is_ok(), "{settings}");
    }
    for name in NAMED.split_whitespace() {
        let error = read(name).expect_err(name);
        assert_eq!(error.message, format!("cannot find the file `{name}.inc`"));
        let hint = error.hint.as_deref().unwrap_or_default();
        assert!(hint.contains("package `povray-includes`") && hint.contains("-L"), "{name}: {hint}");
    }
    // No file of the package is forgotten.
    let Ok(folder) = fs::read_dir("/usr/share/povray-3.7/include") else { return };
    let known: HashSet<&str> = CARRIED.split_whitespace().chain(NAMED.split_whitespace()).collect();
    for entry in folder {
        let name = entry.unwrap().file_name().into_string().unwrap();
        if let Some(stem) = name.strip_suffix(".inc") {
            assert!(known.contains(stem), "{name} is neither carried nor named");
        }
    }
}
