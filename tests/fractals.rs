//! Hypercomplex Julia fractals where the reference's answers are not followed: proofs in arithmetic of a thousand
//! bits for every row that `deviations.csv` lists.
//!
//! A point belongs to the set if none of its first iterates has a squared size above 16. For a listed row one of
//! these is shown, with Glint's crossing on the set's border in each case:
//! - the reference's point has no border near it;
//! - Glint's crossing is nearer;
//! - the reference sees none;
//! - both are at the same place and the reference's normal is not perpendicular to the border.

mod exact;
mod table;

use exact::Exact;
use glint::interp::interpret_str;
use glint::math::{Ray, Vec3};
use glint::world::ObjectQuery;
use std::collections::HashMap;
use table::Row;

/// What is iterated, with the constant.
struct Fractal {
    sine: bool,
    c: [f64; 4],
    iterations: usize,
}

impl Fractal {
    fn of(name: &str) -> Self {
        match name {
            "julia_hyper_recip" => Self { sine: false, c: [0.3, -0.2, 0.4, -0.1], iterations: 6 },
            "julia_hyper_sin" => Self { sine: true, c: [0.2, 0.1, 0.0, 0.3], iterations: 5 },
            _ => panic!("{name} has no proof"),
        }
    }

    /// One iteration of a complex number.
    fn next(&self, [re, im]: &[Exact; 2], c: &[Exact; 2]) -> [Exact; 2] {
        let value = if self.sine {
            [&re.sin() * &im.cosh(), &re.cos() * &im.sinh()]
        } else {
            let size = &(re * re) + &(im * im);
            [re / &size, -&(im / &size)]
        };
        [&value[0] + &c[0], &value[1] + &c[1]]
    }

    /// Whether the point belongs to the set. With w = 0 the two complex numbers are x ± ….
    fn holds(&self, [x, y, z]: &[Exact; 3]) -> bool {
        let [cx, cy, cz, cw] = self.c.map(Exact::from);
        let constants = [[&cx - &cw, &cy + &cz], [&cx + &cw, &cy - &cz]];
        let mut pair = [[x.clone(), y + z], [x.clone(), y - z]];
        let limit = Exact::from(32.0);
        for _ in 0..self.iterations {
            let size = pair.iter().flatten().fold(Exact::from(0.0), |sum, v| &sum + &(v * v));
            if size > limit {
                return false;
            }
            pair = [self.next(&pair[0], &constants[0]), self.next(&pair[1], &constants[1])];
        }
        true
    }

    /// The same at a distance along a line.
    fn holds_at(&self, line: &Line, t: f64) -> bool {
        self.holds(&line.at(&Exact::from(t)))
    }

    /// Whether the set is entered or left within `reach` of `t`, looked at in 40 places.
    fn changes_near(&self, line: &Line, t: f64, reach: f64) -> bool {
        let first = self.holds_at(line, t - reach);
        (1..=40).any(|i| self.holds_at(line, t + reach * (f64::from(i) / 20.0 - 1.0)) != first)
    }
}

struct Line {
    origin: Vec3,
    dir: Vec3,
}

impl Line {
    fn at(&self, t: &Exact) -> [Exact; 3] {
        [0, 1, 2].map(|i| &Exact::from(self.origin[i]) + &(t * &Exact::from(self.dir[i])))
    }
}

fn objects(rows: &[&Row], text: usize) -> HashMap<String, ObjectQuery> {
    let mut found = HashMap::new();
    for row in rows {
        let object = |text: &str| {
            let text = format!("#version 3.7; global_settings {{ assumed_gamma 1 }} {text}");
            let scene = interpret_str(&text).scene.expect("a scene");
            ObjectQuery::new(&scene.objects[0])
        };
        found.entry(row.fields[text].clone()).or_insert_with_key(|text| object(text));
    }
    found
}

fn vector(row: &Row, from: usize) -> Vec3 {
    let v = row.floats(from, 3);
    Vec3::new(v[0], v[1], v[2])
}

/// Whether the border at `p` runs within a thousandth of perpendicular to `normal`.
fn is_perpendicular(fractal: &Fractal, p: Vec3, normal: Vec3) -> bool {
    const STEP: f64 = 1e-6;
    let (u, v) = normal.any_orthonormal_pair();
    [u, v, -u, -v].into_iter().all(|across| {
        let side = Line { origin: p + STEP * across, dir: normal };
        fractal.holds_at(&side, 2e-3 * STEP) != fractal.holds_at(&side, -2e-3 * STEP)
    })
}

#[test]
fn listed_hits() {
    let listed = table::deviations("trace-oracle.csv");
    let all = table::rows("trace-oracle.csv", "name");
    let rows: Vec<&Row> =
        all.iter().filter(|r| r.fields[0].starts_with("julia") && listed.contains_key(&r.number)).collect();
    let objects = objects(&rows, 1);
    let mut kinds: HashMap<&str, usize> = HashMap::new();
    for row in &rows {
        let fractal = Fractal::of(&row.fields[0]);
        let line = Line { origin: vector(row, 2), dir: vector(row, 5).normalize() };
        let hit = objects[&row.fields[1]].trace(&Ray::new(line.origin, line.dir));
        let reference = (row.fields[8] == "1").then(|| (vector(row, 9), vector(row, 12)));
        let own = hit.map(|(p, n)| ((p - line.origin).dot(line.dir), p, n));
        if let Some((t, ..)) = own {
            assert!(fractal.changes_near(&line, t, 1e-9), "row {}: no border at {t}", row.number);
        }
        let kind = match (own, reference) {
            (Some(_), None) => "no crossing is seen",
            (None, None) => panic!("row {} agrees", row.number),
            (own, Some((q, m))) => {
                let s = (q - line.origin).dot(line.dir);
                match own {
                    Some((t, p, n)) if (s - t).abs() < 1e-6 => {
                        assert!(is_perpendicular(&fractal, p, n), "row {}: {n}", row.number);
                        assert!(n.dot(m.normalize()).abs() < 0.9999, "row {}: {n} {m}", row.number);
                        "the normal is another one"
                    }
                    _ if !fractal.changes_near(&line, s, 1e-6) => "no border there",
                    Some((t, ..)) if t < s => "a nearer border is lost",
                    _ => panic!("row {}: the reference is right", row.number),
                }
            }
        };
        println!("{}: {kind}", row.number);
        *kinds.entry(kind).or_default() += 1;
    }
    println!("{kinds:?}");
    assert_eq!(kinds.values().sum::<usize>(), rows.len());
}

#[test]
fn listed_insides() {
    let listed = table::deviations("inside-oracle.csv");
    let all = table::rows("inside-oracle.csv", "name");
    let rows: Vec<&Row> =
        all.iter().filter(|r| r.fields[0].starts_with("julia") && listed.contains_key(&r.number)).collect();
    let objects = objects(&rows, 1);
    for row in &rows {
        let (fractal, p) = (Fractal::of(&row.fields[0]), vector(row, 2));
        let exact = |p: Vec3| fractal.holds(&p.to_array().map(Exact::from));
        assert_eq!(exact(p), objects[&row.fields[1]].contains(p), "row {}", row.number);
        // The reference takes the second coordinate for the third.
        let reference = row.fields[5] == "1";
        assert!(exact(p) != reference && exact(p.with_z(p.y)) == reference, "row {}", row.number);
    }
}
