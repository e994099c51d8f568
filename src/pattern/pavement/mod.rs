//! Pavement: the xz plane paved with one polyform, a tile of triangles, squares or hexagons of side 1.
//!
//! The value is 1 on the outline of a tile and falls to 0 inside, at the distance of the inradius of a triangle or
//! square.
//!
//! | parameter | default | meaning |
//! |---|---|---|
//! | number_of_sides | 3 | of the basic polygon: 3, 4 or 6 |
//! | number_of_tiles | 1 | basic polygons in a tile, up to 6 (5 hexagons) |
//! | pattern | 1 | which of the polyforms |
//! | exterior | 0 | pointed corners of triangles, ends of rows of squares: 0 sharp, 1 cut off, 2 round |
//! | interior | 0 | inner corners: 0 sharp, 1 cut off, 2 round |
//! | form | 0 | other corners: 0 sharp, 1 cut off, 2 round |
//!
//! Of squares, `form` stands for `interior` too; `form 3` leaves inner corners to `interior` and the others to
//! `exterior`.
//!
//! Where the tiles lie is data, measured: which edges of a lattice belong to outlines, for one period. Cell (a, b)
//! of a period with `columns` and `rows` is cell (a - shift * q, b - rows * q), where `q` is the whole part of
//! b / rows, counted around by columns. A digit has a bit for each edge that belongs to an outline: of squares 1 for
//! the side towards -x and 2 for that towards -z; of triangles and hexagons, whose lattice has the directions (1, 0)
//! and (1/2, √3/2), 1 for the edge along the first, 2 for that along the second, 4 for the one across.

mod squares;
mod triangles;

use super::{Modifier, Pattern, Setting};
use crate::math::Vec3;
use std::sync::{Arc, LazyLock};

#[derive(Clone, Copy, Debug)]
pub struct Pavement {
    sides: u32,
    tiles: u32,
    number: u32,
    corners: Corners,
    paving: &'static Paving,
}

/// How corners look: 0 sharp, 1 cut off, 2 round.
#[derive(Clone, Copy, Debug, Default)]
struct Corners {
    exterior: u32,
    interior: u32,
    /// Of squares also 3.
    form: u32,
}

/// One period of outlines.
#[derive(Debug)]
struct Paving {
    sides: u32,
    tiles: u32,
    number: u32,
    columns: i64,
    rows: i64,
    shift: i64,
    edges: Vec<u8>,
}

static PAVINGS: LazyLock<Vec<Paving>> = LazyLock::new(|| {
    let lines = include_str!("pavings.csv").lines().filter(|l| !l.starts_with('#'));
    lines.filter_map(Paving::read).collect()
});

impl Paving {
    fn read(line: &str) -> Option<Self> {
        let fields: Vec<&str> = line.split(',').collect();
        let [sides, tiles, number, columns, rows, shift, edges] = fields[..] else { return None };
        Some(Self {
            sides: sides.parse().ok()?,
            tiles: tiles.parse().ok()?,
            number: number.parse().ok()?,
            columns: columns.parse().ok()?,
            rows: rows.parse().ok()?,
            shift: shift.parse().ok()?,
            edges: edges.bytes().map(|digit| digit - b'0').collect(),
        })
    }

    /// The paving of that name, or else the last one before it.
    fn find(sides: u32, tiles: u32, number: u32) -> &'static Self {
        let wanted = (sides, tiles, number);
        let after = PAVINGS.partition_point(|p| (p.sides, p.tiles, p.number) <= wanted);
        &PAVINGS[after.max(1) - 1]
    }

    /// The bits of a cell.
    fn cell(&self, (a, b): (i64, i64)) -> u8 {
        let q = b.div_euclid(self.rows);
        let column = (a - self.shift * q).rem_euclid(self.columns);
        self.edges[((b - self.rows * q) * self.columns + column) as usize]
    }
}

impl Default for Pavement {
    fn default() -> Self {
        let (sides, tiles, number) = (3, 1, 1);
        let paving = Paving::find(sides, tiles, number);
        Self { sides, tiles, number, corners: Corners::default(), paving }
    }
}

/// Coordinates beyond this count as this, so that cells have numbers.
const FAR: f64 = 1e15;

impl Pattern for Pavement {
    fn value(&self, p: Vec3, _setting: &Setting) -> f64 {
        let (x, z) = (p.x.clamp(-FAR, FAR), p.z.clamp(-FAR, FAR));
        let value = if self.sides == 4 {
            squares::value(self.paving, &self.corners, x, z)
        } else {
            triangles::value(self.paving, &self.corners, x, z)
        };
        value.max(0.0)
    }

    fn modified(&self, modifier: Modifier) -> Option<Arc<dyn Pattern>> {
        let mut changed = *self;
        match modifier {
            Modifier::Sides(sides @ (3 | 4 | 6)) => changed.sides = sides,
            Modifier::Tiles(tiles @ 1..=6) => changed.tiles = tiles,
            Modifier::Number(number @ 1..) => changed.number = number,
            Modifier::Exterior(kind, _) => changed.corners.exterior = kind % 3,
            Modifier::Interior(kind, _) => changed.corners.interior = kind % 3,
            Modifier::Form(form) => changed.corners.form = form.x.clamp(0.0, 99.0) as u32 % 4,
            _ => return None,
        }
        changed.paving = Paving::find(changed.sides, changed.tiles, changed.number);
        Some(Arc::new(changed))
    }
}

/// What a corner's look makes of its value; all that lies beyond the corner is as the outline.
fn bevel(distance: f64, width: f64) -> f64 {
    1.0 - distance.max(0.0) / width
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_are_as_many_pavings_as_polyforms() {
        let counts: [(u32, &[u32]); 3] =
            [(3, &[1, 1, 1, 3, 4, 12]), (4, &[1, 1, 2, 5, 12, 35]), (6, &[1, 1, 3, 7, 22])];
        let mut all = 0;
        for (sides, counts) in counts {
            for (tiles, &count) in (1..).zip(counts) {
                for number in 1..=count {
                    let p = Paving::find(sides, tiles, number);
                    assert_eq!((p.sides, p.tiles, p.number), (sides, tiles, number));
                    assert_eq!(p.edges.len() as i64, p.columns * p.rows);
                    all += 1;
                }
            }
        }
        assert_eq!(all, PAVINGS.len());
        assert_eq!(Paving::find(4, 3, 9).number, 2, "there are two pavings of three squares");
    }

    /// A tile of `tiles` cells has as many outline edges more than inner ones as Euler's formula says; counted
    /// over a period, every edge lies between two cells.
    #[test]
    fn tiles_are_connected_and_of_the_right_size() {
        for p in PAVINGS.iter().filter(|p| p.sides == 4) {
            let cells = p.columns * p.rows;
            let edges: u32 = p.edges.iter().map(|e| e.count_ones()).sum();
            let inner = 2 * cells - i64::from(edges);
            let tiles = cells / i64::from(p.tiles);
            assert_eq!(cells % i64::from(p.tiles), 0, "{p:?}");
            assert!(inner >= cells - tiles, "{p:?}");
        }
    }
}
