//! Gradient noise: unit gradients at the corners of a unit cell, faded together.

use super::{fade, split};
use crate::math::Vec3;
use crate::math::random::Lcg;
use std::sync::LazyLock;

/// Entries in each table; a power of two.
const ENTRIES: usize = 2048;
const MASK: u32 = ENTRIES as u32 - 1;

struct Tables {
    index: [u16; ENTRIES],
    /// Each with a 0 after it, which makes four doubles of it.
    gradients: [[f64; 4]; ENTRIES],
}

static TABLES: LazyLock<Box<Tables>> = LazyLock::new(|| {
    let mut random = Lcg::new(1);
    let gradients = std::array::from_fn(|_| direction(&mut random));
    Box::new(Tables { gradients, index: shuffled(&mut random) })
});

/// A random unit vector: a point of the unit ball, pushed out to its surface.
fn direction(random: &mut Lcg) -> [f64; 4] {
    loop {
        let v: [f64; 3] = std::array::from_fn(|_| (f64::from(random.draw() % 4096) - 2048.0) / 2048.0);
        let square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        if (1e-5..=1.0).contains(&square) {
            let [x, y, z] = v.map(|c| c / square.sqrt());
            return [x, y, z, 0.0];
        }
    }
}

/// Exchanges half of the entries with any others. There is one entry more while that goes on, so that one
/// number is lost and 0 stands twice.
fn shuffled(random: &mut Lcg) -> [u16; ENTRIES] {
    let mut table: [u16; ENTRIES + 1] = std::array::from_fn(|i| (i % ENTRIES) as u16);
    for i in (2..=ENTRIES).rev().step_by(2) {
        table.swap(i, random.draw() as usize % ENTRIES);
    }
    std::array::from_fn(|i| table[i])
}

/// Keeps the lattice away from the origin. It costs some digits of the coordinate, which is part of the
/// noise's definition.
pub(super) const SHIFT: f64 = 10_000_000.023157213;

/// The linear forms at the corners of the cell around a point: no offset, and a gradient. Bit 0 of the index
/// goes with z, bit 1 with y, bit 2 with x.
pub(super) fn forms(p: Vec3) -> [[f64; 4]; 8] {
    let tables: &Tables = &TABLES;
    let [bx, by, bz] = p.to_array().map(|v| split(v + SHIFT).0);
    let index = |i: u32| u32::from(tables.index[(i & MASK) as usize]);
    std::array::from_fn(|corner| {
        let [dx, dy, dz] = [2, 1, 0].map(|bit| (corner as u32 >> bit) & 1);
        let column = index(index(bx.wrapping_add(dx)).wrapping_add((by & MASK) + dy));
        let [x, y, z, _] = tables.gradients[(column.wrapping_add((bz & MASK) + dz) & MASK) as usize];
        [0.0, x, y, z]
    })
}

/// The gradients at the corners of a cell: of the lower corners by z, then of the upper ones. Bit 0 of the
/// index goes with x, bit 1 with y.
#[inline(always)]
pub(super) fn corners([bx, by, bz]: [u32; 3]) -> ([&'static [f64; 4]; 4], [&'static [f64; 4]; 4]) {
    let tables: &'static Tables = &TABLES;
    let index = |i: u32| u32::from(tables.index[(i & MASK) as usize]);
    let (qx, qx1) = (index(bx), index(bx.wrapping_add(1)));
    let (by, bz) = (by & MASK, bz & MASK);
    let columns = [index(qx + by), index(qx1 + by), index(qx + by + 1), index(qx1 + by + 1)];
    let gradient = |i: u32| &tables.gradients[(i & MASK) as usize];
    (columns.map(|c| gradient(c + bz)), columns.map(|c| gradient(c + bz + 1)))
}

/// About -1 ..= 1.
#[inline(always)]
pub(super) fn sum(p: Vec3) -> f64 {
    let ((bx, fx), (by, fy), (bz, fz)) = (split(p.x + SHIFT), split(p.y + SHIFT), split(p.z + SHIFT));
    let (low, high) = corners([bx, by, bz]);
    let dot = |g: &[f64; 4], column: usize, dz: f64| {
        let (dx, dy) = ((column & 1) as f64, (column >> 1) as f64);
        g[0] * (fx - dx) + g[1] * (fy - dy) + g[2] * (fz - dz)
    };
    let (sx, sy, sz) = (fade(fx), fade(fy), fade(fz));
    let lerp = |t: f64, a: f64, b: f64| a + t * (b - a);
    let row = |corners: &[&[f64; 4]; 4], first: usize, dz: f64| {
        lerp(sx, dot(corners[first], first, dz), dot(corners[first + 1], first + 1, dz))
    };
    let low = lerp(sy, row(&low, 0, 0.0), row(&low, 2, 0.0));
    let high = lerp(sy, row(&high, 0, 1.0), row(&high, 2, 1.0));
    lerp(sz, low, high)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_start_as_measured() {
        assert_eq!(TABLES.index[..4], [0, 1, 386, 3]);
        assert!(!TABLES.index.contains(&1017), "the lost number");
        let first = [0.6044250694264234, 0.7052602895441197, 0.3705108088045583];
        for (got, want) in TABLES.gradients[0].iter().zip(first) {
            assert!((got - want).abs() < 1e-15);
        }
    }
}
