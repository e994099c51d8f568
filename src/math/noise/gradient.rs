//! Gradient noise: unit gradients at the corners of a unit cell, faded together.

use super::cell::{Form, blended};
use super::split;
use crate::math::Vec3;
use crate::math::random::Lcg;
use std::sync::LazyLock;

/// Entries in each table; a power of two.
const ENTRIES: usize = 2048;
const MASK: u32 = ENTRIES as u32 - 1;

struct Tables {
    index: [u16; ENTRIES],
    /// As forms without an offset.
    gradients: [Form; ENTRIES],
}

static TABLES: LazyLock<Box<Tables>> = LazyLock::new(|| {
    let mut random = Lcg::new(1);
    let gradients = std::array::from_fn(|_| direction(&mut random));
    Box::new(Tables { gradients, index: shuffled(&mut random) })
});

/// A random unit vector: a point of the unit ball, pushed out to its surface.
fn direction(random: &mut Lcg) -> Form {
    loop {
        let v: [f64; 3] = std::array::from_fn(|_| (f64::from(random.draw() % 4096) - 2048.0) / 2048.0);
        let square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        if (1e-5..=1.0).contains(&square) {
            let [x, y, z] = v.map(|c| c / square.sqrt());
            return [0.0, x, y, z];
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

/// The forms at the corners of a cell, given by the low bits of its coordinates.
#[inline(always)]
pub(super) fn corners([bx, by, bz]: [u32; 3]) -> [&'static Form; 8] {
    let tables: &'static Tables = &TABLES;
    let index = |i: u32| u32::from(tables.index[(i & MASK) as usize]);
    let (qx, qx1) = (index(bx), index(bx.wrapping_add(1)));
    let (by, bz) = (by & MASK, bz & MASK);
    let form = |i: u32| &tables.gradients[(i & MASK) as usize];
    let (a, b) = (index(qx + by) + bz, index(qx + by + 1) + bz);
    let (c, d) = (index(qx1 + by) + bz, index(qx1 + by + 1) + bz);
    [form(a), form(a + 1), form(b), form(b + 1), form(c), form(c + 1), form(d), form(d + 1)]
}

/// About -1 ..= 1.
#[inline(always)]
pub(super) fn sum(p: Vec3) -> f64 {
    let ((bx, fx), (by, fy), (bz, fz)) = (split(p.x + SHIFT), split(p.y + SHIFT), split(p.z + SHIFT));
    let corners = corners([bx, by, bz]);
    blended(|corner| *corners[corner], [fx, fy, fz])
}

/// The linear forms at the corners of the cell around a point.
pub(super) fn forms(p: Vec3) -> [Form; 8] {
    corners(p.to_array().map(|v| split(v + SHIFT).0)).map(|form| *form)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_start_as_measured() {
        assert_eq!(TABLES.index[..4], [0, 1, 386, 3]);
        assert!(!TABLES.index.contains(&1017), "the lost number");
        let first = [0.6044250694264234, 0.7052602895441197, 0.3705108088045583];
        for (got, want) in TABLES.gradients[0][1..].iter().zip(first) {
            assert!((got - want).abs() < 1e-15);
        }
    }
}
