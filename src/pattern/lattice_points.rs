//! One random point in every unit cell, for crackle and facets.

use crate::math::Vec3;
use crate::math::noise::hash3;
use crate::math::random::{UNIFORM_ENTRIES, uniform, uniform_table};

/// Cells around the middle one: offsets -2 ..= 2, at most one of them being 2 or -2.
pub(super) const NEIGHBOURS: usize = 81;

/// The neighbours in the order in which ties are decided: x slowest, z fastest.
pub(super) static OFFSETS: [[i8; 3]; NEIGHBOURS] = offsets();

/// Places in [`OFFSETS`], nearest cells first.
pub(super) static NEAREST_FIRST: [u8; NEIGHBOURS] = nearest_first();

const fn offsets() -> [[i8; 3]; NEIGHBOURS] {
    let mut all = [[0; 3]; NEIGHBOURS];
    let (mut n, mut code) = (0, 0);
    while code < 125 {
        let o = [code / 25 - 2, code / 5 % 5 - 2, code % 5 - 2];
        let far = (o[0] / 2 != 0) as u8 + (o[1] / 2 != 0) as u8 + (o[2] / 2 != 0) as u8;
        if far <= 1 {
            all[n] = [o[0] as i8, o[1] as i8, o[2] as i8];
            n += 1;
        }
        code += 1;
    }
    all
}

const fn nearest_first() -> [u8; NEIGHBOURS] {
    let mut order = [0; NEIGHBOURS];
    let (mut n, mut square) = (0, 0);
    while square <= 6 {
        let mut i = 0;
        while i < NEIGHBOURS {
            let o = OFFSETS[i];
            if o[0] * o[0] + o[1] * o[1] + o[2] * o[2] == square {
                order[n] = i as u8;
                n += 1;
            }
            i += 1;
        }
        square += 1;
    }
    order
}

/// The cells around a point.
pub(super) struct Neighbourhood {
    base: [i64; 3],
    corner: Vec3,
    table: &'static [f64; UNIFORM_ENTRIES],
}

impl Neighbourhood {
    /// Around the cell whose lowest corner is `corner`.
    pub fn new(corner: Vec3) -> Self {
        Self { base: corner.to_array().map(|c| c as i64), corner, table: uniform_table() }
    }

    /// The point in the cell at an offset.
    pub fn point(&self, [i, j, k]: [i8; 3]) -> Vec3 {
        let [a, b, c] = self.base;
        let s = hash3(a.wrapping_add(i.into()), b.wrapping_add(j.into()), c.wrapping_add(k.into()));
        let random =
            Vec3::new(uniform(self.table, s), uniform(self.table, s + 1), uniform(self.table, s + 2));
        self.corner + Vec3::new(i.into(), j.into(), k.into()) + random
    }
}
