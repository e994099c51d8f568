//! The Penrose tiling by pentagons, stars, boats and diamonds (P1).

use super::penrose::{G, PHI, degrees, fold, line, turn};

/// Tiles while they are divided. Pentagons are of three kinds by their neighbours; numbers tell the two ways of
/// dividing apart.
#[derive(Clone, Copy)]
enum Shape {
    A,
    B0,
    B1,
    C0,
    C1,
    Star,
    Boat0,
    Boat1,
    Diamond0,
    Diamond1,
}

use Shape::*;

type Point = (f64, f64);

/// The pentagon with side 1: radii of the circles through its sides' middles and its corners.
fn radii() -> (f64, f64) {
    (0.5 / degrees(36.0).tan(), 0.5 / degrees(36.0).sin())
}

/// Kind of tile, bevel and number of kinds.
pub(super) fn tile(x: f64, z: f64) -> (u32, f64, u32) {
    if x.hypot(z) <= 1e-10 {
        return (0, 1.0, 6);
    }
    let (x, z) = fold((x, z));
    let n = 4 * ((2.0 * x * degrees(36.0).tan()).ln() / (4.0 * PHI.ln())).ceil().max(0.0) as i32;
    let scale = PHI.powi(-n);
    let (mut shape, mut p) = (A, (x * scale, z * scale));
    for _ in 0..n {
        let (next, (x, z)) = divide(shape, entered(shape, p));
        (shape, p) = (next, (x * PHI, z * PHI));
    }
    let (kind, d) = outline(shape, entered(shape, p));
    (kind, 1.0 - 5.55 * G * d, 6)
}

/// Every tile is symmetric; the one at the centre in five ways.
fn entered(shape: Shape, p: Point) -> Point {
    match shape {
        A => fold(p),
        _ => (p.0, p.1.abs()),
    }
}

/// The smaller tile that holds the point, and the point in that tile's coordinates.
fn divide(shape: Shape, (x, z): Point) -> (Shape, Point) {
    let (a, r) = radii();
    let (cos72, sin72) = (degrees(72.0).cos(), degrees(72.0).sin());
    let tan = |angle: f64| degrees(angle).tan();
    // The corner of a pentagon that hangs on the tile by its tip.
    let hung = |(u, v): Point| (-u - r * cos72, v - r * sin72);
    match shape {
        A if z < (x - a) * tan(54.0) + 0.5 => (B0, (x - a - G * r * cos72, z)),
        A => (Star, turn((x, z), 36.0)),
        B1 if z < (x - G * G * r) * tan(54.0) => (A, (x - r, z)),
        B1 if z < (x - G * G * r) * tan(162.0) => (Diamond1, (-x, z)),
        B1 => {
            let (x, z) = turn((x, z), -108.0);
            (B1, (x + G * r, z))
        }
        B0 if z < (x + r) * tan(18.0) => (Diamond0, (x + r - G * G * r, z)),
        B0 => (C0, hung(turn((x, z), 36.0))),
        C1 if x > G * G * r * cos72 => (B1, (-(x - G * G * r * cos72 - G * a), z)),
        C1 => (Boat1, (x, z)),
        C0 if x < r * degrees(108.0).cos() => {
            let (x, z) = turn((x, z), 144.0);
            (B0, (x - r, z))
        }
        C0 if z > (x - G * G * r) * tan(126.0) => (C0, hung(turn((x, z), -36.0))),
        C0 => (Boat0, (x, z)),
        Star if x < G * a => (A, (x, z)),
        Star => (C1, (-(x - 2.0 * G * a), z)),
        Boat1 if x > PHI * r * degrees(108.0).cos() => (A, (-x, z)),
        Boat1 => (C1, (x + r, z)),
        Boat0 => {
            let (x, z) = turn((x, z), -72.0);
            (C1, (x + r, z))
        }
        Diamond1 => (A, (x, z)),
        Diamond0 => (C1, (x, z)),
    }
}

/// The kind of a tile and the distance to its outline.
fn outline(shape: Shape, p: Point) -> (u32, f64) {
    let (a, r) = radii();
    let pentagon = || (fold(p).0 - a).abs();
    let star = |p: Point| line(p, PHI * r, 162.0);
    match shape {
        A => (0, pentagon()),
        B0 | B1 => (1, pentagon()),
        C0 | C1 => (2, pentagon()),
        Star => (3, star(p)),
        Boat0 | Boat1 => {
            let flat = (p.0 - G * r * degrees(72.0).cos()).abs();
            (4, flat.min(star(fold((-p.0, p.1)))))
        }
        Diamond0 | Diamond1 => (5, line(p, -G * r, 18.0)),
    }
}
