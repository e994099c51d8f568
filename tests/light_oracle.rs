//! Colours of small scenes against measured ones, through the whole pipeline.
//!
//! `3-oracle-classes.csv` says how each scene is to be compared. `closed`: row by row. `sampled` (random
//! draws): by the mean over the picture. `order` (the reference visits tiles in turn, and each sees what
//! those before it gathered; random sequences run on from pixel to pixel): by the mean, and pictures of one
//! block row by row, as they leave no choice of order. `tolerance`: such scenes show a built-in tolerance
//! of the reference that Glint does not have, and stand in `deviations.csv`.

use glint::interp::interpret_str;
use glint::render::{Settings as Rendering, Unobserved, indirect, render};
use glint::trace::{Settings, Tracer};
use glint::world::World;
use std::collections::BTreeMap;
use std::fs;

/// Rounding of 16-bit values and of single precision along the way.
const TOLERANCE: f64 = 2.5e-5;

/// Renderings of a sampled scene that are averaged.
const SAMPLES: u32 = 64;

/// Mean difference of scenes whose order of work is not the reference's. It differs from itself by 0.001
/// with two threads, and by 0.0016 with another block size, in pictures larger than these.
const ORDER_TOLERANCE: f64 = 5e-3;

struct Row {
    x: u32,
    y: u32,
    color: [f64; 3],
    alpha: Option<f64>,
}

struct Oracle {
    class: String,
    width: u32,
    height: u32,
    block_size: u32,
    text: String,
    rows: Vec<Row>,
}

fn data(name: &str) -> String {
    let path = format!("{}/tests/data/{name}", env!("CARGO_MANIFEST_DIR"));
    fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"))
}

/// The scenes of one class.
fn oracles(class: &str) -> BTreeMap<String, Oracle> {
    let classes = classes();
    let mut all: BTreeMap<String, Oracle> = BTreeMap::new();
    for line in data("3-oracle.csv").lines().skip(2) {
        let f: Vec<&str> = line.splitn(10, ',').collect();
        if classes[f[0]] != class {
            continue;
        }
        let number = |i: usize| f[i].parse::<f64>().unwrap();
        let oracle = all.entry(f[0].to_owned()).or_insert_with(|| {
            let text = data(&format!("3-oracle-scenes/{}.pov", f[0]));
            let (width, height) = (number(1) as u32, number(2) as u32);
            let block_size = block_size(&text);
            Oracle { class: class.to_owned(), width, height, block_size, text, rows: Vec::new() }
        });
        let color = [number(5), number(6), number(7)];
        oracle.rows.push(Row { x: number(3) as u32, y: number(4) as u32, color, alpha: f[8].parse().ok() });
    }
    assert!(!all.is_empty());
    all
}

fn classes() -> BTreeMap<String, String> {
    let rows = data("3-oracle-classes.csv");
    let fields = rows.lines().skip(2).map(|l| l.split(',').collect::<Vec<_>>());
    fields.map(|f| (f[0].to_owned(), f[1].to_owned())).collect()
}

/// Block size of the reference's picture, written in the scene's first line.
fn block_size(text: &str) -> u32 {
    let first = text.lines().next().unwrap_or_default();
    first.split_once("block size ").map_or(32, |(_, size)| size.trim().parse().unwrap())
}

impl Oracle {
    /// Colours and alphas in the order of the rows, as a 16-bit file keeps them. `draws` picks other random
    /// numbers.
    fn rendered(&self, name: &str, draws: u32, threads: usize) -> Vec<([f64; 3], f64)> {
        let scene = interpret_str(&self.text).scene.unwrap_or_else(|e| panic!("{name}: {}", e.message));
        let world = World::prepare(scene);
        let alpha = self.rows[0].alpha.is_some();
        let settings = Settings { width: self.width, height: self.height, alpha, ..Settings::default() };
        let rendering = Rendering { block_size: self.block_size, ..Rendering::new(self.width, self.height) };
        let pool =
            rayon::ThreadPoolBuilder::new().num_threads(threads).stack_size(256 << 20).build().unwrap();
        let (light, _) = indirect(&world, &settings, &rendering, &pool, &Unobserved);
        let picture = std::sync::Mutex::new(glint::picture::Picture::new(self.width, self.height));
        let sampler = || Redrawn { tracer: Tracer::lit(&world, &settings, &light), draws };
        render(&rendering, &pool, &picture, &Unobserved, sampler);
        let picture = picture.into_inner().unwrap();
        let stored = |c: f32| (f64::from(c.clamp(0.0, 1.0)) * 65535.0).round() / 65535.0;
        let pixel = |row: &Row| {
            let p = picture.get(row.x, row.y);
            (p.rgb.to_array().map(stored), 1.0 - f64::from(p.transmit))
        };
        self.rows.iter().map(pixel).collect()
    }

    fn is_one_block(&self) -> bool {
        self.width <= self.block_size && self.height <= self.block_size
    }
}

/// A tracer with other random numbers.
struct Redrawn<'w> {
    tracer: Tracer<'w>,
    draws: u32,
}

impl glint::render::Sampler for Redrawn<'_> {
    fn seed(&mut self, x: u32, y: u32, sample: u32) {
        self.tracer.seed(x, y, sample + self.draws);
    }

    fn sample(&mut self, x: f64, y: f64) -> glint::trace::Pixel {
        self.tracer.pixel(x + 0.5, y + 0.5)
    }

    fn begin_block(&mut self, serial: usize) {
        self.tracer.begin_block(serial);
    }

    fn rays(&self) -> u64 {
        0
    }
}

impl Row {
    fn difference(&self, (color, alpha): &([f64; 3], f64)) -> f64 {
        let off = (0..3).map(|i| (self.color[i] - color[i]).abs()).fold(0.0, f64::max);
        off.max(self.alpha.map_or(0.0, |a| (a - alpha).abs()))
    }
}

/// Rows that agree, of how many, by the first word of the scenes' names.
#[derive(Default)]
struct Tally(BTreeMap<String, (u32, u32)>);

impl Tally {
    fn count(&mut self, name: &str, agrees: bool) {
        let group = name.split('-').next().unwrap_or(name).to_owned();
        let count = self.0.entry(group).or_default();
        count.0 += u32::from(agrees);
        count.1 += 1;
    }

    fn print(&self, class: &str) {
        let sum = self.0.values().fold((0, 0), |a, b| (a.0 + b.0, a.1 + b.1));
        println!("{class}: {} of {} rows agree; {:?}", sum.0, sum.1, self.0);
    }
}

#[test]
fn closed_scenes_agree_row_by_row() {
    let (mut tally, mut failures) = (Tally::default(), Vec::new());
    for (name, oracle) in &oracles("closed") {
        for (row, pixel) in oracle.rows.iter().zip(oracle.rendered(name, 0, 1)) {
            let agrees = row.difference(&pixel) <= TOLERANCE;
            tally.count(name, agrees);
            if !agrees {
                failures.push(format!("{name} ({}, {}): {:?}, got {pixel:?}", row.x, row.y, row.color));
            }
        }
    }
    tally.print("closed");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn sampled_scenes_agree_in_the_mean() {
    let (mut scenes, mut failures) = (0, Vec::new());
    for (name, oracle) in &oracles("sampled") {
        let samples: Vec<_> = (0..SAMPLES).map(|i| oracle.rendered(name, i, 1)).collect();
        let n = oracle.rows.len() as f64;
        scenes += 1;
        for i in 0..3 {
            let expected = oracle.rows.iter().map(|r| r.color[i]).sum::<f64>() / n;
            let drawn = samples.iter().flatten().map(|p| p.0[i]);
            let mean = drawn.clone().sum::<f64>() / (n * f64::from(SAMPLES));
            let variance = drawn.map(|c| (c - mean).powi(2)).sum::<f64>() / (n * f64::from(SAMPLES));
            // Standard error of the measured mean, whose rows are that many draws.
            let error = (variance / n).sqrt();
            if (mean - expected).abs() >= 3.0 * error + TOLERANCE {
                failures.push(format!("{name}: {expected}, got {mean}, standard error {error}"));
            }
        }
    }
    println!("sampled: {scenes} scenes, {} means differ", failures.len());
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// Scenes of one block that need not agree row by row, and why.
const OTHERWISE: [(&str, &str); 7] = [
    (
        "rad-pb-imp",
        "in the reference rays that stand for others lose that weight where they gather in turn, so that \
         objects of small importance come out too dark",
    ),
    ("pho-m-auto", LAST_BIT),
    ("pho-m-dense", LAST_BIT),
    ("pho-m-two", LAST_BIT),
    ("pho-lens", RIM),
    ("pho-m-nocol", RIM),
    ("pho-m-par", RIM),
];

const RIM: &str = "of photons on the rim of a search that has more than it keeps a few are passed by in the \
    reference, by how far it still looked when it came there; a search that begins nearer finds them";

const LAST_BIT: &str = "the photons are those of the reference, but whether a plane's photons lie at 0 or at 2e-16 \
    decides how the tree is split, and so which of too many photons a search keeps";

#[test]
fn ordered_scenes_agree() {
    let (mut tally, mut failures) = (Tally::default(), Vec::new());
    for (name, oracle) in &oracles("order") {
        assert_eq!(oracle.class, "order");
        let pixels = oracle.rendered(name, 0, 1);
        let exact = oracle.is_one_block() && !OTHERWISE.iter().any(|(other, _)| other == name);
        let n = 3.0 * oracle.rows.len() as f64;
        let pairs = || {
            let rows = oracle.rows.iter().zip(&pixels);
            rows.flat_map(|(row, p)| (0..3).map(move |i| (row.color[i], p.0[i])))
        };
        let mean = pairs().map(|(a, _)| a).sum::<f64>() / n;
        let deviation = (pairs().map(|(a, _)| (a - mean).powi(2)).sum::<f64>() / n).sqrt();
        let shift = pairs().map(|(a, b)| b - a).sum::<f64>() / n;
        let difference = pairs().map(|(a, b)| (b - a).abs()).sum::<f64>() / n;
        let rows = oracle.rows.iter().zip(&pixels).map(|(row, p)| row.difference(p));
        let differing = rows.clone().filter(|d| *d > TOLERANCE).count();
        let largest = rows.clone().fold(0.0, f64::max);
        rows.for_each(|d| tally.count(name, d <= TOLERANCE));
        let line = format!("{name}: {differing} rows differ, mean {difference:.6}, largest {largest:.6}");
        println!("{line}");
        let in_the_mean = shift.abs() <= 3.0 * deviation / n.sqrt() + TOLERANCE;
        if !in_the_mean || difference > ORDER_TOLERANCE || exact && differing > 0 {
            failures.push(format!("{line}, shift {shift:.6}"));
        }
    }
    tally.print("order");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// Radiosity over several blocks, photons, jitter.
#[test]
fn threads_do_not_matter() {
    for (class, name) in
        [("order", "rad-pb-tiles"), ("order", "pho-m-two"), ("sampled", "lig-area-5x5-jitter")]
    {
        let oracle = &oracles(class)[name];
        assert_eq!(oracle.rendered(name, 0, 3), oracle.rendered(name, 0, 1), "{name}");
    }
}

/// Rows that show a built-in tolerance of the reference stand in `deviations.csv` with Glint's own value.
#[test]
fn deviations_are_as_noted() {
    let mut seen = Vec::new();
    for (name, oracle) in &oracles("tolerance") {
        for (row, (color, _)) in oracle.rows.iter().zip(oracle.rendered(name, 0, 1)) {
            let text = |c: [f64; 3]| format!("{:.6} {:.6} {:.6}", c[0], c[1], c[2]);
            if (0..3).any(|i| (row.color[i] - color[i]).abs() > TOLERANCE) {
                let place = format!("{name} {} {}", row.x, row.y);
                seen.push(format!("3-oracle.csv,{place},{},{}", text(row.color), text(color)));
            }
        }
    }
    assert_eq!(seen, deviations(), "\n{}", seen.join("\n"));
}

/// The rows of `deviations.csv` that belong to `3-oracle.csv`, without their reasons.
fn deviations() -> Vec<String> {
    let path = format!("{}/tests/deviations.csv", env!("CARGO_MANIFEST_DIR"));
    let all = fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"));
    let ours = all.lines().filter(|l| l.starts_with("3-oracle.csv,"));
    ours.filter_map(|l| l.rsplit_once(',').map(|(row, _)| row.to_owned())).collect()
}

/// The film of the top layer colours light that is reflected inside of glass as well, whatever the layer
/// reflects itself. Values of the reference, first pixel of 4x2.
#[test]
fn films_act_on_total_reflection() {
    const FILM: &str = "irid { 0.65 thickness 0.8 turbulence 0.1 }";
    let layer =
        |film: &str| format!("texture {{ pigment {{ rgbf 1 }} finish {{ ambient 0 diffuse 0 {film} }} }}");
    let colored = [0.400656, 0.804440, 0.822003];
    let cases = [
        (layer(""), [0.5; 3]),
        (layer(FILM), colored),
        (layer("") + &layer(FILM), colored),
        (layer(FILM) + &layer(""), [0.5; 3]),
    ];
    for (textures, expected) in cases {
        let scene = format!(
            "#version 3.7; global_settings {{ assumed_gamma 1 }} background {{ rgb 0.5 }} \
             camera {{ location <0, -1, 0> look_at <0, 0, 4> angle 10 }} \
             plane {{ y, 0 hollow {textures} interior {{ ior 1.5 }} }}"
        );
        let world = World::prepare(interpret_str(&scene).scene.unwrap());
        let settings = Settings { width: 4, height: 2, ..Settings::default() };
        let seen = Tracer::new(&world, &settings).pixel(0.5, 0.5).rgb.to_array();
        assert!(seen.iter().zip(expected).all(|(a, b)| (a - b).abs() < 2e-5), "{textures}: {seen:?}");
    }
}
