//! Tiles of squares on the whole numbers of x and z.

use super::{Corners, Paving, bevel};

/// The outline's bevel ends this far inside: the inradius.
const WIDTH: f64 = 0.5;

/// Whether the edge that leaves the corner (a, b) in direction `d` belongs to an outline: 0 for +x, 1 for +z, 2 for
/// -x, 3 for -z.
fn leaves(paving: &Paving, (a, b): (i64, i64), d: usize) -> bool {
    let (cell, bit) = match d % 4 {
        0 => ((a, b), 2),
        1 => ((a, b), 1),
        2 => ((a - 1, b), 2),
        _ => ((a, b - 1), 1),
    };
    paving.cell(cell) & bit != 0
}

pub(super) fn value(paving: &Paving, corners: &Corners, x: f64, z: f64) -> f64 {
    let (left, front) = (x.floor(), z.floor());
    let (a, b) = (left as i64, front as i64);
    let (fx, fz) = (x - left, z - front);
    // Corners of the cell counterclockwise, with the distances of the point from them along x and z; the cell's own
    // edges leave the `i`th one in directions i and i + 1.
    let around = [
        ((a, b), fx, fz),
        ((a + 1, b), 1.0 - fx, fz),
        ((a + 1, b + 1), 1.0 - fx, 1.0 - fz),
        ((a, b + 1), fx, 1.0 - fz),
    ];
    let edges: [bool; 4] = std::array::from_fn(|i| leaves(paving, around[i].0, i));
    let count = edges.iter().filter(|&&e| e).count();
    let mut value = 0.0f64;
    for (i, &(corner, dx, dz)) in around.iter().enumerate() {
        let to_edge = if i % 2 == 0 { dz } else { dx };
        let own = [edges[i], edges[(i + 3) % 4]];
        if own[0] {
            value = value.max(bevel(to_edge, WIDTH));
        }
        if own == [false, false] && (leaves(paving, corner, i + 2) || leaves(paving, corner, i + 3)) {
            value = value.max(bevel(inner(corners, dx, dz), WIDTH));
        }
        if own == [true, true] {
            value = value.max(outer(corners, count, dx, dz));
        }
    }
    value
}

/// Distance from the outline near a corner that it turns around.
fn inner(corners: &Corners, dx: f64, dz: f64) -> f64 {
    let look = if corners.form == 3 { corners.interior } else { corners.form };
    match look {
        0 => dx.max(dz),
        1 => dx + dz,
        _ => dx.hypot(dz),
    }
}

/// The value in a corner that `count` edges of the cell make, at these distances from its sides.
fn outer(corners: &Corners, count: usize, dx: f64, dz: f64) -> f64 {
    if count >= 3 || corners.form == 3 {
        return match corners.exterior {
            1 => bevel(dx + dz - 0.5, WIDTH),
            2 if dx < 0.5 && dz < 0.5 => bevel(0.5 - (0.5 - dx).hypot(0.5 - dz), WIDTH),
            _ => 0.0,
        };
    }
    match corners.form {
        1 => bevel(dx + dz - 1.0, WIDTH),
        2 => bevel(1.0 - (1.0 - dx).hypot(1.0 - dz), WIDTH),
        _ => 0.0,
    }
}
