//! Whole pictures: every scene of the project against its stored pictures, twins against each other, and scenes
//! whose answer is known on paper.

use glint::picture::compare::compare;
use glint::picture::load::{Values, load};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

const WIDTH: usize = 160;
const HEIGHT: usize = 120;

/// Two texts for one picture may differ in the last place of their arithmetic, and so in a pixel on an edge.
const TWIN_PSNR: f64 = 45.0;

/// How far a 16-bit picture may be from paper, in steps of 1/255: colours are kept in single precision.
const PAPER_STEPS: f64 = 0.02;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn glint() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_glint"));
    command.current_dir(root()).stdin(Stdio::null()).env("NO_COLOR", "1");
    command
}

/// Renders a scene into the target folder.
fn render(scene: &Path, more: &[&str]) -> Values {
    let name = scene.strip_prefix(root()).unwrap().to_string_lossy().replace(['/', '\\'], "-");
    let picture = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name).with_extension("png");
    let mut command = glint();
    command.arg("render").arg(scene).arg("-o").arg(&picture);
    command.args(["-W", "160", "-H", "120", "--includes", "embedded", "--quiet"]).args(more);
    let done = command.output().unwrap();
    assert!(done.status.success(), "{}: {}", scene.display(), String::from_utf8_lossy(&done.stderr));
    let values = load(&picture).unwrap();
    assert_eq!((values.width as usize, values.height as usize), (WIDTH, HEIGHT));
    values
}

/// `glint golden check` compares every scene with Glint's own earlier picture and with POV-Ray's.
#[test]
fn stored_pictures() {
    let done = glint().args(["golden", "check"]).output().unwrap();
    let said = String::from_utf8_lossy(&done.stdout);
    let complaints: Vec<&str> = said.lines().filter(|l| !l.starts_with("ok ")).collect();
    let errors = String::from_utf8_lossy(&done.stderr);
    assert!(done.status.success(), "{errors}\n{}", complaints.join("\n"));
    assert!(said.lines().filter(|l| l.starts_with("ok ")).count() >= 200, "{said}");
}

#[test]
fn twins() {
    let folder = root().join("tests/scenes/twins");
    let mut pairs: Vec<PathBuf> = fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    pairs.sort();
    assert!(pairs.len() >= 15);
    let mut wrong = Vec::new();
    for pair in pairs {
        let difference =
            compare(&render(&pair.join("a.pov"), &[]), &render(&pair.join("b.pov"), &[])).unwrap();
        if !difference.reaches(TWIN_PSNR) {
            wrong.push(format!("{}: {:?} dB", pair.display(), difference.psnr_db));
        }
    }
    assert!(wrong.is_empty(), "twins that differ:\n{}", wrong.join("\n"));
}

/// Pictures do not depend on the number of threads.
#[test]
fn threads() {
    let scene = root().join("tests/scenes/light/area_adaptive.pov");
    let one = render(&scene, &["--threads", "1"]);
    let three = render(&scene, &["--threads", "3"]);
    assert_eq!(one.pixels, three.pixels);
}

/// What a linear value becomes in an 8-bit file.
fn encoded(linear: f64) -> f64 {
    let v = linear.clamp(0.0, 1.0);
    if v <= 0.003_130_8 { 12.92 * v } else { 1.055 * v.powf(1.0 / 2.4) - 0.055 }
}

/// Middle of a pixel in the orthographic window of 4 by 3 units that the paper scenes look through.
fn place(column: usize, row: usize) -> (f64, f64) {
    let x = ((column as f64 + 0.5) / WIDTH as f64 - 0.5) * 4.0;
    let y = (0.5 - (row as f64 + 0.5) / HEIGHT as f64) * 3.0;
    (x, y)
}

/// Compares a picture with a formula for each place; the formula is silent (`None`) where pixels lie on an edge.
fn on_paper(name: &str, formula: impl Fn(f64, f64) -> Option<[f64; 3]>) {
    let scene = root().join("tests/scenes/paper").join(name).with_extension("pov");
    let picture = render(&scene, &["--bits", "16"]);
    let mut asked = 0;
    for (row, column) in (0..HEIGHT).flat_map(|r| (0..WIDTH).map(move |c| (r, c))) {
        let (x, y) = place(column, row);
        let Some(expected) = formula(x, y) else { continue };
        asked += 1;
        let found = picture.pixels[row * WIDTH + column];
        for (linear, found) in expected.into_iter().zip(found) {
            let told = 255.0 * encoded(linear);
            let off = (f64::from(found) - told).abs();
            assert!(off < PAPER_STEPS, "{name} at ({x:.3}, {y:.3}): {found}, on paper {told}");
        }
    }
    assert!(asked > WIDTH * HEIGHT / 2, "{name}: too few pixels were asked");
}

#[test]
fn furnace() {
    on_paper("furnace", |_, _| Some([0.5, 0.25, 0.125]));
}

#[test]
fn lambert() {
    on_paper("lambert", |x, y| {
        let r2 = x * x + y * y;
        let near_rim = (r2.sqrt() - 1.0).abs() < 0.02;
        (!near_rim).then(|| [(1.0 - r2).max(0.0).sqrt(); 3])
    });
}

#[test]
fn inverse_square() {
    on_paper("inverse_square", |x, y| {
        let d2: f64 = 1.0 + x * x + y * y;
        Some([0.8 * 2.0 / (1.0 + d2) / d2.sqrt(); 3])
    });
}

#[test]
fn beer() {
    on_paper("beer", |x, _| Some([(-(x + 2.0) / 2.0).exp(); 3]));
}

#[test]
fn slab() {
    let shift = (0.5f64.sqrt()) * (1.0 - 0.5f64.sqrt() / (1.5f64 * 1.5 - 0.5).sqrt());
    on_paper("slab", |x, y| {
        // Under the slab the edge is seen where a ray, shifted, meets x = 0.
        let edge = if y.abs() < 0.75 { -shift } else { 0.0 };
        let near_edge = (x - edge).abs() < 0.02 || (y.abs() - 0.75).abs() < 0.02;
        (!near_edge).then_some([if x < edge { 1.0 } else { 0.0 }; 3])
    });
}

#[test]
fn fog() {
    on_paper("fog", |x, _| {
        let wall = ((x + 2.0) * 2.0).floor();
        let near_edge = ((x + 2.0) * 2.0 - wall - 0.5).abs() > 0.47;
        (!near_edge).then(|| [(-(wall + 1.0) / 3.0).exp(); 3])
    });
}
