//! For small boxes of space, the points that can be among the three nearest somewhere in them.
//!
//! Neighbouring rays, and the samples along one ray, ask about much the same places. A box, a quarter of a cell
//! wide, that is asked about again and again gets a list: about ten points of the 81 around its cell. What is
//! left out is farther from all of the box than three points are, so that answers are the same to the bit.

use super::EDGE;
use super::lattice_points::{GROUPS, INNER, Neighbourhood, gap_of};
use crate::math::Vec3;
use crate::math::noise::split;
use std::cell::RefCell;

/// Boxes to a cell along each axis.
const DIVISION: f64 = 4.0;

/// Most points of a list; a multiple of four.
const MOST: usize = 16;

/// Boxes that a thread keeps in mind; a power of two.
const KEPT: usize = 256;

/// Questions before a list is made. Making one costs as much as several answers without it.
const PATIENCE: u8 = 8;

/// Coordinates up to this fit the key, and round by far less than [`MARGIN`].
const LARGEST: f64 = 131_072.0;

/// By how much boxes are made larger, for rounding.
const MARGIN: f64 = 1e-9;

/// Coordinates of four points.
pub(super) type Four = [[f64; 4]; 3];

const NOWHERE: Four = [[f64::INFINITY; 4]; 3];

/// A box of space, and the points around it if there is a list of them.
pub(super) struct Nook {
    key: u64,
    metric: f64,
    asked: u8,
    /// How many fours the list has; 0 if there is none.
    length: u8,
    points: [Four; MOST / 4],
}

thread_local! {
    static NOOKS: RefCell<Vec<Nook>> = const { RefCell::new(Vec::new()) };
}

/// The points that can be among the three nearest to `p`, if there is a list for its box; `power` belongs to the
/// metric and grows with distance.
#[inline(always)]
pub(super) fn around<R>(
    p: Vec3,
    metric: f64,
    power: impl Fn(f64) -> f64 + Copy,
    work: impl FnOnce(&[Four]) -> R,
) -> Option<R> {
    if !(p.abs().max_element() < LARGEST) {
        return None;
    }
    let scaled = DIVISION * (p - Vec3::splat(EDGE));
    let ((a, x), (b, y), (c, z)) = (split(scaled.x), split(scaled.y), split(scaled.z));
    let [a, b, c] = [a, b, c].map(|v| u64::from(v) & 0x1f_ffff);
    let key = a | b << 21 | c << 42 | 1 << 63;
    let place = key.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> (64 - KEPT.trailing_zeros());
    NOOKS.with_borrow_mut(|kept| {
        if kept.is_empty() {
            let nook = || Nook { key: 0, metric: 0.0, asked: 0, length: 0, points: [NOWHERE; MOST / 4] };
            kept.resize_with(KEPT, nook);
        }
        let nook = &mut kept[place as usize & (KEPT - 1)];
        if nook.key != key || nook.metric != metric {
            (nook.key, nook.metric, nook.asked, nook.length) = (key, metric, 0, 0);
        }
        if nook.length == 0 && !nook.is_made((scaled - Vec3::new(x, y, z)) / DIVISION, power) {
            return None;
        }
        Some(work(&nook.points[..usize::from(nook.length)]))
    })
}

impl Nook {
    /// Makes the list if the box was asked about often enough.
    #[inline(never)]
    fn is_made(&mut self, low: Vec3, power: impl Fn(f64) -> f64 + Copy) -> bool {
        self.asked = self.asked.saturating_add(1);
        if self.asked != PATIENCE {
            return false;
        }
        let ends = [low - MARGIN, low + (1.0 / DIVISION + MARGIN)];
        let near = |q: Vec3| (ends[0] - q).max(q - ends[1]).max(Vec3::ZERO);
        let far = |q: Vec3| (q - ends[0]).abs().max((q - ends[1]).abs());
        let sum = |d: Vec3| power(d.x) + power(d.y) + power(d.z);
        // Within this, three points lie wherever in the box one looks from.
        let mut reach = [f64::INFINITY; 3];
        let corner = low.floor();
        let count = Neighbourhood::around(corner, |cells| {
            cells.group(0);
            for (_, q) in cells.points(0..INNER) {
                super::crackle::insert(&mut reach, sum(far(q)));
            }
            let limit = reach[2] * (1.0 + 1e-9);
            let mut count = 0;
            let mut add = |q: Vec3| {
                if sum(near(q)) <= limit {
                    if count < MOST {
                        let four = &mut self.points[count / 4];
                        (four[0][count % 4], four[1][count % 4], four[2][count % 4]) = (q.x, q.y, q.z);
                    }
                    count += 1;
                }
            };
            cells.points(0..INNER).for_each(|(_, q)| add(q));
            for group in 1..GROUPS {
                let gap = gap_of(group, ends[0] - corner).min(gap_of(group, ends[1] - corner));
                if power(gap.max(0.0)) <= limit {
                    let places = cells.group(group);
                    cells.points(places).for_each(|(_, q)| add(q));
                }
            }
            count
        });
        if count > MOST {
            return false;
        }
        let fours = count.div_ceil(4);
        for empty in count..4 * fours {
            self.points[empty / 4].iter_mut().for_each(|c| c[empty % 4] = f64::INFINITY);
        }
        self.length = fours as u8;
        true
    }
}
