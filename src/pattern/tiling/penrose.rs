//! The Penrose tilings by kites and darts, and by rhombs.
//!
//! Both come from half-kites and half-darts: a point is scaled down until it lies in one large tile at the
//! centre, which is then divided again and again.

use std::f64::consts::PI;

/// The golden ratio, and its inverse.
pub(super) const PHI: f64 = 1.618033988749895;
pub(super) const G: f64 = PHI - 1.0;

pub(super) fn degrees(a: f64) -> f64 {
    a * PI / 180.0
}

/// Turns a point by minus `a` degrees.
pub(super) fn turn((x, z): (f64, f64), a: f64) -> (f64, f64) {
    let (s, c) = degrees(a).sin_cos();
    (x * c + z * s, z * c - x * s)
}

/// Distance to the line through (x0, 0) in direction `a` degrees.
pub(super) fn line((x, z): (f64, f64), x0: f64, a: f64) -> f64 {
    let (s, c) = degrees(a).sin_cos();
    (s * (x - x0) - c * z).abs()
}

/// Folds the plane into one tenth of a full turn.
pub(super) fn fold((x, z): (f64, f64)) -> (f64, f64) {
    let z = z.abs();
    let r = x.hypot(z);
    let (x, z) = if x >= r * degrees(36.0).cos() {
        (x, z)
    } else if x < r * degrees(108.0).cos() {
        turn((x, z), 144.0)
    } else {
        turn((x, z), 72.0)
    };
    (x, z.abs())
}

/// Kind of tile, bevel and number of kinds.
pub(super) fn tile(x: f64, z: f64, rhombs: bool) -> (u32, f64, u32) {
    if x.hypot(z) <= 1e-10 {
        return (1, 1.0, 2);
    }
    let (mut x, mut z) = fold((x, z));
    if rhombs {
        (x, z) = (x * G, z * G);
    }
    let d = line((x, z), 0.0, 108.0) / degrees(18.0).cos();
    let n = (d.ln() / (2.0 * PHI.ln())).ceil().max(0.0) as i32;
    let scale = PHI.powi(-2 * n);
    let mut p = (x * scale, z * scale);
    if n % 2 == 1 {
        let (x, z) = turn(p, 36.0);
        p = (x, z.abs());
    }
    let (kite, p) = divided(p, 2 * n);
    let (kind, d, slope) = if rhombs { rhomb(kite, p) } else { kite_or_dart(kite, p) };
    (kind, 1.0 - slope * d, 2)
}

/// Whether the point lies in a half-kite after `n` divisions, and where in it.
fn divided(mut p: (f64, f64), n: i32) -> (bool, (f64, f64)) {
    let mut kite = true;
    for _ in 0..n {
        let (x, z) = (p.0, p.1.abs());
        let (was_kite, steep) = (kite, if kite { 144.0 } else { 108.0 });
        let first = z < (x - G) * degrees(steep).tan();
        let next = match (was_kite, first) {
            (true, true) => {
                kite = false;
                (x, z)
            }
            (true, false) => turn((x - degrees(36.0).cos(), z - degrees(36.0).sin()), -108.0),
            (false, true) => {
                kite = true;
                turn((x, z), 36.0)
            }
            (false, false) => turn((x - 1.0, z), 144.0),
        };
        p = (next.0 * PHI, next.1 * PHI);
    }
    (kite, (p.0, p.1.abs()))
}

/// Kind, distance to the outline, slope of the bevel.
fn kite_or_dart(kite: bool, p: (f64, f64)) -> (u32, f64, f64) {
    match kite {
        true => (0, line(p, 0.0, 36.0).min(line(p, 1.0, 108.0)), 4.46),
        false => (1, p.1.min(line(p, 1.0, 144.0)), 4.46),
    }
}

fn rhomb(kite: bool, p: (f64, f64)) -> (u32, f64, f64) {
    let (kind, d) = match kite {
        true if p.1 < (p.0 - G) * degrees(72.0).tan() => (1, line(p, G, 72.0).min(line(p, 1.0, 108.0))),
        true => (0, p.1.min(line(p, G, 72.0))),
        false => (0, line(p, 0.0, 36.0).min(line(p, 1.0, 144.0))),
    };
    (kind, d, 5.55)
}
