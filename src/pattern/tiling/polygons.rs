//! Periodic tilings by convex polygons.

use std::collections::HashMap;
use std::sync::LazyLock;

/// One period of every tiling.
const TABLE: &str = include_str!("tiles.csv");

type Point = [f64; 2];

#[derive(Debug)]
struct Tiles {
    kinds: u32,
    /// Where the bevel ends.
    width: f64,
    periods: [Point; 2],
    /// The tiles that reach into one period, which begins at the origin.
    tiles: Vec<Tile>,
}

#[derive(Debug)]
struct Tile {
    kind: u32,
    edges: Vec<Edge>,
}

/// The line `normal · p = offset`; its distance is positive inside.
#[derive(Debug)]
struct Edge {
    normal: Point,
    offset: f64,
    width: f64,
    /// The bevel of this edge acts above this height only.
    above: f64,
}

static TILINGS: LazyLock<HashMap<u32, Tiles>> = LazyLock::new(|| {
    let mut tilings = HashMap::new();
    for line in TABLE.lines().filter(|line| !line.starts_with('#')) {
        read(line, &mut tilings);
    }
    tilings
});

/// The value of tiling `number` at a point.
pub(super) fn value(number: u32, x: f64, z: f64) -> f64 {
    let Some(tiling) = TILINGS.get(&number) else { return 0.0 };
    let p = tiling.reduced([x, z]);
    let inside = |tile: &Tile| tile.edges.iter().map(|e| e.distance(p)).fold(f64::INFINITY, f64::min);
    let mut best: Option<(&Tile, f64)> = None;
    for tile in &tiling.tiles {
        let distance = inside(tile);
        if best.is_none_or(|(_, d)| distance > d) {
            best = Some((tile, distance));
        }
        if distance > 0.0 {
            break;
        }
    }
    let Some((tile, _)) = best else { return 0.0 };
    let bevel = tile.edges.iter().filter(|e| p[1] > e.above).map(|e| 1.0 - e.distance(p) / e.width);
    let least = if tile.kind > 0 { super::FLAT } else { 0.0 };
    let bevel = bevel.fold(0.0, f64::max).clamp(least, 1.0);
    (f64::from(tile.kind) + bevel) / f64::from(tiling.kinds)
}

impl Edge {
    fn distance(&self, p: Point) -> f64 {
        self.offset - (self.normal[0] * p[0] + self.normal[1] * p[1])
    }
}

impl Tiles {
    /// Whole periods that lie between the origin and `p`.
    fn whole_periods(&self, p: Point) -> Point {
        let [a, b] = self.periods;
        let area = a[0] * b[1] - a[1] * b[0];
        [((p[0] * b[1] - p[1] * b[0]) / area).floor(), ((a[0] * p[1] - a[1] * p[0]) / area).floor()]
    }

    fn shifted(&self, p: Point, [i, j]: Point) -> Point {
        let [a, b] = self.periods;
        [p[0] + i * a[0] + j * b[0], p[1] + i * a[1] + j * b[1]]
    }

    fn reduced(&self, p: Point) -> Point {
        let [i, j] = self.whole_periods(p);
        self.shifted(p, [-i, -j])
    }

    /// Adds all copies of a tile that may reach into the first period.
    fn add(&mut self, number: u32, kind: u32, corners: &[Point]) {
        let dodecagon = number == 22 && corners.len() == 12;
        for i in -4..=4 {
            for j in -4..=4 {
                let by = [f64::from(i), f64::from(j)];
                let moved: Vec<Point> = corners.iter().map(|&c| self.shifted(c, by)).collect();
                if !self.reaches(&moved) {
                    continue;
                }
                let edges = edges(&moved, self.width, dodecagon);
                self.tiles.push(Tile { kind, edges });
            }
        }
    }

    /// Whether the bounding box of a tile in units of the periods overlaps the first one.
    fn reaches(&self, corners: &[Point]) -> bool {
        let [a, b] = self.periods;
        let area = a[0] * b[1] - a[1] * b[0];
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for p in corners {
            let q = [(p[0] * b[1] - p[1] * b[0]) / area, (a[0] * p[1] - a[1] * p[0]) / area];
            for k in 0..2 {
                (low[k], high[k]) = (low[k].min(q[k]), high[k].max(q[k]));
            }
        }
        (0..2).all(|k| low[k] < 1.0 + 1e-9 && high[k] > -1e-9)
    }
}

/// The outline of a convex polygon in either order. Dodecagons have some wider bevels, and two that act only
/// high up.
fn edges(corners: &[Point], width: f64, dodecagon: bool) -> Vec<Edge> {
    let n = corners.len() as f64;
    let sum = corners.iter().fold([0.0; 2], |s, c| [s[0] + c[0], s[1] + c[1]]);
    let centre = [sum[0] / n, sum[1] / n];
    let next = corners.iter().cycle().skip(1);
    let edges = |(p, q): (&Point, &Point)| {
        let length = (q[0] - p[0]).hypot(q[1] - p[1]);
        let mut normal = [(q[1] - p[1]) / length, (p[0] - q[0]) / length];
        let mut offset = normal[0] * p[0] + normal[1] * p[1];
        if offset < normal[0] * centre[0] + normal[1] * centre[1] {
            normal = normal.map(|c| -c);
            offset = -offset;
        }
        let edge = |width, above| Edge { normal, offset, width, above };
        let plain = edge(width, f64::NEG_INFINITY);
        match wide_bevel(normal) {
            Some(height) if dodecagon => vec![plain, edge(1.0 / 3.0, centre[1] + height)],
            _ => vec![plain],
        }
    };
    corners.iter().zip(next).flat_map(edges).collect()
}

/// Height above the centre of a dodecagon from which the edge with this normal has a wider bevel, as the
/// language has it.
fn wide_bevel([x, z]: Point) -> Option<f64> {
    if x.abs() > 0.99 || z < -0.99 {
        Some(f64::NEG_INFINITY)
    } else if x.abs() > 0.8 && z > 0.4 {
        Some((1.0 + 3.0_f64.sqrt()) / 2.0)
    } else {
        None
    }
}

fn read(line: &str, tilings: &mut HashMap<u32, Tiles>) {
    let mut fields = line.split(',');
    let mut number = || fields.next().and_then(|f| f.parse::<f64>().ok()).expect("the table has numbers");
    let (tiling, kinds, width) = (number() as u32, number() as u32, number());
    let mut point = || {
        let (x, z) = fields.next()?.split_once(' ')?;
        Some([x.parse().ok()?, z.parse().ok()?])
    };
    let periods = [(); 2].map(|()| point().expect("the table has periods"));
    let kind = fields.next().and_then(|f| f.parse().ok()).expect("the table has kinds");
    let corners: Vec<Point> = fields
        .filter_map(|f| f.split_once(' '))
        .map(|(x, z)| [x, z].map(|v| v.parse().expect("the table has corners")))
        .collect();
    let tiles = tilings.entry(tiling).or_insert(Tiles { kinds, width, periods, tiles: Vec::new() });
    tiles.add(tiling, kind, &corners);
}
