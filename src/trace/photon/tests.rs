//! What the reference's way of searching does to its pictures.

use super::map::tests::{RULE, Rule};
use crate::trace::{Settings, Tracer};
use crate::world::World;

/// Rounding of 16-bit values and of single precision along the way.
const TOLERANCE: f64 = 2.5e-5;

/// The same for light of photons whose energies and directions are stored in steps of 1/256: some of a hundred may be
/// rounded the other way.
const STEPS: f64 = 4e-5;

struct Row {
    size: (u32, u32),
    place: (u32, u32),
    color: [f64; 3],
}

fn data(name: &str) -> String {
    std::fs::read_to_string(format!("{}/tests/data/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

fn rows(scene: &str) -> Vec<Row> {
    let text = data("3-oracle.csv");
    let fields = text.lines().map(|l| l.splitn(10, ',').collect::<Vec<_>>()).filter(|f| f[0] == scene);
    let row = |f: Vec<&str>| {
        let [w, h, x, y] = [1, 2, 3, 4].map(|i| f[i].parse().unwrap());
        Row { size: (w, h), place: (x, y), color: [5, 6, 7].map(|i| f[i].parse().unwrap()) }
    };
    fields.map(row).collect()
}

fn off(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| (a[i] - b[i]).abs()).fold(0.0, f64::max)
}

/// Colours at the rows' places, with photons searched by each rule.
fn seen(scene: &str, rows: &[Row]) -> [Vec<[f64; 3]>; 3] {
    let scene = crate::interp::interpret_str(&data(&format!("3-oracle-scenes/{scene}.pov"))).scene.unwrap();
    let world = World::prepare(scene);
    let (width, height) = rows[0].size;
    let settings = Settings { width, height, ..Settings::default() };
    let rendering = crate::render::Settings::new(width, height);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).stack_size(256 << 20).build().unwrap();
    let (light, _) =
        crate::render::indirect(&world, &settings, &rendering, &pool, &crate::render::Unobserved);
    [Rule::Own, Rule::Reference, Rule::Nearest].map(|rule| {
        RULE.set(rule);
        let mut tracer = Tracer::lit(&world, &settings, &light);
        let colors = rows.iter().map(|row| {
            tracer.begin_block(0);
            tracer.seed(row.place.0, row.place.1, 0);
            let pixel = tracer.pixel(f64::from(row.place.0) + 0.5, f64::from(row.place.1) + 0.5);
            pixel.rgb.to_array().map(|c| (f64::from(c.clamp(0.0, 1.0)) * 65535.0).round() / 65535.0)
        });
        let colors = colors.collect();
        RULE.set(Rule::Own);
        colors
    })
}

/// Rows of measured scenes that Glint does not meet: with the reference's rule it meets them, so that nothing but the
/// rule is different; and where the two rules differ Glint's own is nearer to the nearest photons of all.
#[test]
fn rows_differ_by_the_rule_of_the_search_alone() {
    for (scene, tolerance) in [("pho-lens", TOLERANCE), ("pho-m-nocol", TOLERANCE), ("pho-m-par", STEPS)] {
        let rows = rows(scene);
        let [own, reference, nearest] = seen(scene, &rows);
        let count = |colors: &[[f64; 3]]| {
            rows.iter().zip(colors).filter(|(row, c)| off(row.color, **c) > tolerance).count()
        };
        let error = |colors: &[[f64; 3]]| colors.iter().zip(&nearest).map(|(a, b)| off(*a, *b)).sum::<f64>();
        println!("{scene}: of {} rows {} differ, {} by the rule", rows.len(), count(&own), count(&reference));
        println!("from the nearest photons: {} and {}", error(&own), error(&reference));
        assert_eq!(count(&reference), 0, "{scene}");
        assert!(error(&own) <= error(&reference), "{scene}");
    }
}
