//! One random point in every unit cell, for crackle and facets.
//!
//! Neighbouring rays ask about the same cells again and again, so every thread keeps the points around the
//! cells that it met last.

use crate::math::Vec3;
use crate::math::noise::hash3;
use crate::math::random::{uniform, uniform_table};
use std::cell::RefCell;
use std::ops::Range;

/// The 27 inner cells, those at offsets -1 ..= 1, and a place that stays empty.
pub(super) const INNER: usize = 28;
/// The nine cells two steps away on one side, and places that stay empty.
const SIDE: usize = 12;
/// Groups of cells: the inner ones, then the sides -x, +x, -y, +y, -z, +z.
pub(super) const GROUPS: usize = 7;
const PLACES: usize = INNER + 6 * SIDE;

/// The offset of each place's cell, nearest first in each group; `None` for empty places.
static OFFSETS: [Option<[i8; 3]>; PLACES] = offsets();

const fn offsets() -> [Option<[i8; 3]>; PLACES] {
    let mut places = [None; PLACES];
    let (mut n, mut square) = (0, 0);
    while square <= 3 {
        let mut code = 0;
        while code < 27 {
            let o = [code / 9 - 1, code / 3 % 3 - 1, code % 3 - 1];
            if o[0] * o[0] + o[1] * o[1] + o[2] * o[2] == square {
                places[n] = Some([o[0] as i8, o[1] as i8, o[2] as i8]);
                n += 1;
            }
            code += 1;
        }
        square += 1;
    }
    let mut side = 0;
    while side < 6 {
        let (axis, far) = (side / 2, if side % 2 == 0 { -2 } else { 2 });
        let mut i = 0;
        while i < 9 {
            let mut o = [0; 3];
            o[axis] = far;
            // The middle cell first.
            let code = (i + 4) % 9;
            o[(axis + 1) % 3] = (code / 3) as i8 - 1;
            o[(axis + 2) % 3] = (code % 3) as i8 - 1;
            places[INNER + SIDE * side + i] = Some(o);
            i += 1;
        }
        side += 1;
    }
    places
}

/// The points in the cells around one cell, as far as they were asked for.
pub(super) struct Neighbourhood {
    cell: [i64; 3],
    corner: Vec3,
    /// A bit for each group that is known.
    known: u8,
    /// Coordinates by place; infinite where a place is empty.
    x: [f64; PLACES],
    y: [f64; PLACES],
    z: [f64; PLACES],
}

/// Neighbourhoods that a thread keeps; a power of two.
const KEPT: usize = 32;

thread_local! {
    static NEIGHBOURHOODS: RefCell<Vec<Neighbourhood>> = const { RefCell::new(Vec::new()) };
}

impl Neighbourhood {
    fn new() -> Self {
        let nowhere = [f64::INFINITY; PLACES];
        Self { cell: [0; 3], corner: Vec3::ZERO, known: 0, x: nowhere, y: nowhere, z: nowhere }
    }

    /// Runs `work` with the points around the cell whose lowest corner is `corner`. `work` must not ask for
    /// another cell's.
    #[inline]
    pub fn around<R>(corner: Vec3, work: impl FnOnce(&mut Neighbourhood) -> R) -> R {
        let cell = corner.to_array().map(|c| c as i64);
        let [a, b, c] = cell;
        let place = a.wrapping_add(b.wrapping_mul(5)).wrapping_add(c.wrapping_mul(17)) as usize % KEPT;
        NEIGHBOURHOODS.with_borrow_mut(|kept| {
            if kept.is_empty() {
                kept.resize_with(KEPT, Neighbourhood::new);
            }
            let neighbourhood = &mut kept[place];
            if neighbourhood.cell != cell || neighbourhood.corner != corner {
                (neighbourhood.cell, neighbourhood.corner, neighbourhood.known) = (cell, corner, 0);
            }
            work(neighbourhood)
        })
    }

    /// The places of a group, with its points filled in.
    #[inline]
    pub fn group(&mut self, group: usize) -> Range<usize> {
        let places = if group == 0 { 0..INNER } else { INNER + SIDE * (group - 1)..INNER + SIDE * group };
        if self.known & 1 << group == 0 {
            self.fill(places.clone());
            self.known |= 1 << group;
        }
        places
    }

    #[inline(never)]
    fn fill(&mut self, places: Range<usize>) {
        let [a, b, c] = self.cell;
        let table = uniform_table();
        for place in places {
            let Some([i, j, k]) = OFFSETS[place] else { continue };
            let s = hash3(a.wrapping_add(i.into()), b.wrapping_add(j.into()), c.wrapping_add(k.into()));
            let point = self.corner
                + Vec3::new(i.into(), j.into(), k.into())
                + Vec3::new(uniform(table, s), uniform(table, s + 1), uniform(table, s + 2));
            (self.x[place], self.y[place], self.z[place]) = (point.x, point.y, point.z);
        }
    }

    /// Coordinates of the points in some places, whose number is a multiple of four.
    #[inline]
    pub fn fours(&self, places: Range<usize>) -> impl Iterator<Item = [&[f64; 4]; 3]> {
        let [x, y, z] = [&self.x, &self.y, &self.z].map(|c| c[places.clone()].as_chunks::<4>().0);
        x.iter().zip(y).zip(z).map(|((x, y), z)| [x, y, z])
    }

    /// The points in some places with the offsets of their cells; empty places are left out.
    pub fn points(&self, places: Range<usize>) -> impl Iterator<Item = ([i8; 3], Vec3)> {
        places.filter_map(|i| Some((OFFSETS[i]?, Vec3::new(self.x[i], self.y[i], self.z[i]))))
    }

    /// Every point.
    #[cfg(test)]
    pub fn all(&mut self) -> impl Iterator<Item = ([i8; 3], Vec3)> {
        for group in 0..GROUPS {
            self.group(group);
        }
        self.points(0..PLACES)
    }

    /// How far `p`, which is in the middle cell, is from the cells of a side at least.
    #[inline]
    pub fn gap(&self, group: usize, p: Vec3) -> f64 {
        gap_of(group, p - self.corner)
    }
}

/// How far a point at `f` in the middle cell is from the cells of a side at least.
#[inline]
pub(super) fn gap_of(group: usize, f: Vec3) -> f64 {
    let f = f[(group - 1) / 2];
    if group % 2 == 1 { 1.0 + f } else { 2.0 - f }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_are_81_cells_no_two_alike() {
        let mut offsets: Vec<[i8; 3]> = OFFSETS.into_iter().flatten().collect();
        assert_eq!(offsets.len(), 81);
        assert!(offsets.iter().all(|o| o.iter().filter(|c| c.abs() == 2).count() <= 1));
        offsets.sort_unstable();
        offsets.dedup();
        assert_eq!(offsets.len(), 81);
    }

    #[test]
    fn what_is_kept_is_what_is_made_anew() {
        let corners: Vec<Vec3> = (0..500)
            .map(|i| Vec3::new(f64::from(i % 7) - 3.0, f64::from(i % 5), f64::from(i % 11)))
            .collect();
        for &corner in corners.iter().chain(corners.iter().rev()) {
            let kept: Vec<_> = Neighbourhood::around(corner, |n| n.all().collect());
            let mut anew = Neighbourhood::new();
            (anew.corner, anew.cell) = (corner, corner.to_array().map(|c| c as i64));
            assert!(kept == anew.all().collect::<Vec<_>>(), "{corner}");
            assert_eq!(kept.len(), 81);
        }
    }
}
