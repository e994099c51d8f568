//! Tiles of triangles or hexagons, whose edges all lie on one lattice of triangles.

use super::{Corners, Paving, bevel};
use std::f64::consts::FRAC_PI_3;

const SQRT_3: f64 = 1.732_050_807_568_877_2;

/// Height of a triangle of side 1.
const HEIGHT: f64 = SQRT_3 / 2.0;
/// The outline's bevel ends this far inside: the inradius.
const WIDTH: f64 = SQRT_3 / 6.0;

/// A corner of the lattice, in steps along its two directions.
type Corner = (i64, i64);

/// Whether the edge that leaves a corner at an angle of `d` times 60 degrees belongs to an outline.
fn leaves(paving: &Paving, (a, b): Corner, d: usize) -> bool {
    let (cell, bit) = match d % 6 {
        0 => ((a, b), 1),
        1 => ((a, b), 2),
        2 => ((a - 1, b), 4),
        3 => ((a - 1, b), 1),
        4 => ((a, b - 1), 2),
        _ => ((a, b - 1), 4),
    };
    paving.cell(cell) & bit != 0
}

/// The triangle around a point.
struct Triangle {
    /// Counterclockwise.
    corners: [Corner; 3],
    /// Where the triangle's first edge leaves each corner, in steps of 60 degrees.
    first: [usize; 3],
    /// The point's distances from the sides opposite the corners.
    heights: [f64; 3],
    /// The point.
    at: (f64, f64),
}

impl Triangle {
    fn around(x: f64, z: f64) -> Self {
        let v = z / HEIGHT;
        let u = x - 0.5 * v;
        let (a, b) = (u.floor() as i64, v.floor() as i64);
        let (fu, fv) = (u - u.floor(), v - v.floor());
        let (corners, first, shares) = if fu + fv < 1.0 {
            ([(a, b), (a + 1, b), (a, b + 1)], [0, 2, 4], [1.0 - fu - fv, fu, fv])
        } else {
            ([(a + 1, b + 1), (a, b + 1), (a + 1, b)], [3, 5, 1], [fu + fv - 1.0, 1.0 - fu, 1.0 - fv])
        };
        Self { corners, first, heights: shares.map(|s| s * HEIGHT), at: (x, z) }
    }

    /// The point seen from a corner: distance, and angle from the triangle's first edge there.
    fn polar(&self, i: usize) -> (f64, f64) {
        let (a, b) = self.corners[i];
        let (x, z) = (self.at.0 - (a as f64 + 0.5 * b as f64), self.at.1 - b as f64 * HEIGHT);
        (x.hypot(z), z.atan2(x) - FRAC_PI_3 * self.first[i] as f64)
    }
}

pub(super) fn value(paving: &Paving, corners: &Corners, x: f64, z: f64) -> f64 {
    let triangle = Triangle::around(x, z);
    let mut value = 0.0f64;
    for i in 0..3 {
        let leaves = |d: usize| leaves(paving, triangle.corners[i], triangle.first[i] + d);
        let own = [leaves(0), leaves(1)];
        if own[0] {
            value = value.max(bevel(triangle.heights[(i + 2) % 3], WIDTH));
        }
        let near = match own {
            [false, false] if (2..6).any(leaves) => bevel(inner(corners, &triangle, i), WIDTH),
            [true, false] if leaves(2) => blunt(corners, &triangle, i, FRAC_PI_3, (i + 1) % 3),
            [false, true] if leaves(5) => blunt(corners, &triangle, i, 0.0, (i + 2) % 3),
            [true, true] if paving.sides == 3 => pointed(corners, &triangle, i),
            _ => 0.0,
        };
        value = value.max(near);
    }
    value
}

/// Distance from the outline near a corner that it turns around.
fn inner(corners: &Corners, triangle: &Triangle, i: usize) -> f64 {
    if corners.interior == 0 {
        return HEIGHT - triangle.heights[i];
    }
    let (r, angle) = triangle.polar(i);
    match corners.interior {
        1 => HEIGHT * r * angle.cos().max((angle - FRAC_PI_3).cos()),
        _ => HEIGHT * r,
    }
}

/// The value near a corner of 120 degrees, whose middle line lies at the angle `middle`; corner `end` is the other
/// end of the triangle's edge on the outline.
fn blunt(corners: &Corners, triangle: &Triangle, i: usize, middle: f64, end: usize) -> f64 {
    let form = corners.form % 3;
    if form == 0 {
        return 0.0;
    }
    let (r, angle) = triangle.polar(i);
    let along = r * (angle - middle).cos();
    if form == 1 {
        return bevel(4.0 * along - 1.0, 1.0);
    }
    if triangle.heights[i] < triangle.heights[end] {
        return 0.0;
    }
    let from_center = (1.0 - along).hypot(r * (angle - middle).sin());
    bevel(HEIGHT - from_center, WIDTH)
}

/// The value near a corner of 60 degrees.
fn pointed(corners: &Corners, triangle: &Triangle, i: usize) -> f64 {
    let h = triangle.heights;
    match corners.exterior {
        1 => bevel(2.0 * WIDTH - h[i], WIDTH),
        2 if h.iter().all(|&other| other <= h[i]) => {
            let square: f64 = h.iter().map(|h| (h - WIDTH) * (h - WIDTH)).sum();
            bevel(WIDTH - (square / 1.5).sqrt(), WIDTH)
        }
        _ => 0.0,
    }
}
