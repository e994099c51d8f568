//! Shapes against tables of hits, normals, insides and surface parameters that POV-Ray 3.7 printed.

mod table;

use glint::interp::interpret_str;
use glint::math::{Range, Ray, Vec3};
use glint::scene::{Object, Scene};
use glint::world::{ObjectQuery, RayClass, World};
use std::collections::HashMap;
use std::sync::Arc;
use table::Row;

/// Objects read so far, by their text.
#[derive(Default)]
struct Objects(HashMap<String, Result<Arc<ObjectQuery>, String>>);

impl Objects {
    fn get(&mut self, text: &str) -> Result<Arc<ObjectQuery>, String> {
        let read = || Ok(Arc::new(ObjectQuery::new(&*object(text)?)));
        self.0.entry(text.to_owned()).or_insert_with(read).clone()
    }
}

fn scene(text: &str) -> Result<Scene, String> {
    let outcome = interpret_str(&format!("#version 3.7; global_settings {{ assumed_gamma 1 }} {text}"));
    outcome.scene.map_err(|e| format!("{}: {text}", e.message))
}

fn object(text: &str) -> Result<Arc<Object>, String> {
    scene(text)?.objects.first().cloned().ok_or_else(|| format!("no object: {text}"))
}

fn vector(row: &Row, from: usize) -> Vec3 {
    let v = row.floats(from, 3);
    vector_of(&v[..2], v[2])
}

fn vector_of(xy: &[f64], z: f64) -> Vec3 {
    Vec3::new(xy[0], xy[1], z)
}

/// How far hits may differ from the table's, in parts of their distance from the origin. Normals may differ
/// by a hundred times as much.
fn tolerance(name: &str) -> f64 {
    match name {
        // Found up to the scene's `accuracy` behind the surface.
        "isosurface_all" => 1e-3,
        "isosurface_sphere_in_box" | "isosurface_open_thresh" => 1e-4,
        // Bisected down to steps of 1e-7.
        _ if name.starts_with("julia") => 2e-7,
        // Corners and planes in single precision.
        _ if name.starts_with("mesh") => 1e-7,
        // Roots of polynomials of degree 5 and more end at about 1e-8.
        _ if name.starts_with("lathe") || name.starts_with("poly") => 5e-8,
        _ => 1e-9,
    }
}

/// Compares a hit with the columns from `from` on: hit, point, normal.
fn compare_hit(row: &Row, objects: &mut Objects, from: usize, tolerance: f64) -> Result<(), String> {
    let object = objects.get(&row.fields[from - 7])?;
    let direction = vector(row, from - 3).normalize();
    let found = object.trace(&Ray::new(vector(row, from - 6), direction));
    let (hit, point, normal) = (row.fields[from] == "1", vector(row, from + 1), vector(row, from + 4));
    let Some((p, n)) = found else {
        return if hit { Err(format!("{}: no hit, expected {point}", row.fields[0])) } else { Ok(()) };
    };
    let near = p.distance(point) <= tolerance * (1.0 + point.length());
    let same = normal.is_nan() || n.distance(normal) <= 100.0 * tolerance;
    if hit && near && same {
        return Ok(());
    }
    Err(format!("{}: {p} {n}, expected {hit} {point} {normal}", row.fields[0]))
}

/// The rows of a table, but for texts where the fonts are missing that come with POV-Ray's include files.
fn rows(name: &str, heading: &str) -> Vec<Row> {
    let is_text = |row: &Row| row.fields.iter().any(|field| field.contains("text{"));
    table::without_missing_fonts(table::rows(name, heading), name, is_text)
}

#[test]
fn nearest_hits() {
    let rows = rows("trace-oracle.csv", "name");
    let mut objects = Objects::default();
    table::check("trace-oracle.csv", &rows, |row| {
        compare_hit(row, &mut objects, 8, tolerance(&row.fields[0]))
    });
}

#[test]
fn insides() {
    let rows = rows("inside-oracle.csv", "name");
    let mut objects = Objects::default();
    table::check("inside-oracle.csv", &rows, |row| {
        let inside = objects.get(&row.fields[1])?.contains(vector(row, 2));
        let expected = row.fields[5] == "1";
        if inside == expected { Ok(()) } else { Err(format!("{}: {inside}", row.fields[0])) }
    });
}

#[test]
fn exact_edges() {
    let rows = rows("edge-oracle.csv", "object");
    let mut objects = Objects::default();
    table::check("edge-oracle.csv", &rows, |row| compare_hit(row, &mut objects, 7, 1e-6));
}

#[test]
fn text_hits() {
    let rows = rows("text-oracle.csv", "name");
    let mut objects = Objects::default();
    table::check("text-oracle.csv", &rows, |row| {
        compare_hit(row, &mut objects, 8, tolerance(&row.fields[0]))
    });
}

#[test]
fn surface_parameters() {
    let rows = rows("uv-oracle.csv", "name");
    let mut worlds: HashMap<String, World> = HashMap::new();
    table::check("uv-oracle.csv", &rows, |row| {
        let text = row.fields[1].replace("UVTEXTURE", "uv_mapping pigment { rgb 1 }");
        let world =
            worlds.entry(text.clone()).or_insert_with(|| World::prepare(scene(&text).expect("a scene")));
        let ray = Ray::new(vector_of(&row.floats(2, 2), -5.0), Vec3::Z);
        let Some(hit) = world.nearest(&ray, Range::FORWARD, RayClass::Image) else {
            return Err(format!("{}: no hit", row.fields[0]));
        };
        let (uv, expected) = (world.uv(&hit), row.floats(4, 2));
        let near = |a: f64, b: f64| ((a - b + 0.5).rem_euclid(1.0) - 0.5).abs() < 2e-4;
        match near(uv.x, expected[0]) && near(uv.y, expected[1]) {
            true => Ok(()),
            false => Err(format!("{}: {uv}, expected {expected:?}", row.fields[0])),
        }
    });
}
