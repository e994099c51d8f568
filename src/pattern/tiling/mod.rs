//! Tilings of the xz plane.
//!
//! With C kinds of tiles, the value of kind k is `(k + e) / C`, where the bevel `e` is 1 on the outline of a tile
//! and falls to 0 inside.
//!
//! | parameter | meaning |
//! |---|---|
//! | number | 1 ..= 24 periodic, 25 ..= 27 Penrose |
//!
//! Reference for the Penrose tilings: B. Grünbaum, G. C. Shephard, "Tilings and Patterns" (1987), chapter 10.

mod penrose;
mod penrose_pentagons;
mod polygons;

use super::{Pattern, Setting};
use crate::math::Vec3;
use std::f64::consts::SQRT_2;

/// A tiling by its number, 1 ..= 27.
#[derive(Clone, Copy, Debug)]
pub struct Tiling {
    number: u32,
}

impl Tiling {
    /// How many tilings there are.
    pub const COUNT: u32 = 27;

    /// `None` if there is no tiling of that number.
    pub fn new(number: u32) -> Option<Self> {
        (1..=Self::COUNT).contains(&number).then_some(Self { number })
    }
}

impl Pattern for Tiling {
    fn value(&self, p: Vec3, _setting: &Setting) -> f64 {
        let (x, z) = (p.x, p.z);
        let (kind, bevel, kinds) = match self.number {
            12 => {
                let fold = |v: f64| (v.rem_euclid(6.0) - 3.0).abs();
                return polygons::value(11, fold(x), fold(z));
            }
            13 => squares_and_hexagons(x, z),
            14 => squares_and_turned_hexagons(x, z),
            25 => penrose_pentagons::tile(x, z),
            26 | 27 => penrose::tile(x, z, self.number == 27),
            number => return polygons::value(number, x, z),
        };
        // A flat middle must not fall to the kind below.
        let bevel = if kind > 0 { bevel.clamp(FLAT, 1.0) } else { bevel.clamp(0.0, 1.0) };
        (f64::from(kind) + bevel) / f64::from(kinds)
    }
}

/// The least bevel of all kinds but the first.
const FLAT: f64 = 1e-7;

/// Kind of tile, bevel, number of kinds; before kinds are told apart by direction.
fn squares_and_hexagons(x: f64, z: f64) -> (u32, f64, u32) {
    let (a, b) = turned(x, z);
    let (x, z) = (a.abs(), b.abs());
    let slanted = 1.0 - SQRT_2 * (x - z).abs();
    if x < 1.0 && z < 1.0 {
        (0, 2.0 * (x - 0.5).max(z - 0.5), 3)
    } else if x >= 1.0 && (z < 1.0 || x > z) {
        let e = 2.0 * (1.5 - x).abs();
        (2, if z > 0.5 { e.max(slanted) } else { e }, 3)
    } else {
        let e = 2.0 * (1.5 - z).abs();
        (1, if x > 0.5 { e.max(slanted) } else { e }, 3)
    }
}

fn squares_and_turned_hexagons(x: f64, z: f64) -> (u32, f64, u32) {
    let (a, b) = turned(x, z);
    let (kind, bevel, _) = squares_and_hexagons(x, z);
    let kind = match kind {
        0 => 4,
        2 => u32::from(a < 0.0),
        _ => 2 + u32::from(b >= 0.0),
    };
    (kind, bevel, 5)
}

/// Coordinates in one period, -2 .. 2.
fn turned(x: f64, z: f64) -> (f64, f64) {
    let reduced = |v: f64| (SQRT_2 * v).rem_euclid(4.0) - 2.0;
    (reduced(x), reduced(z))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::{Context, NoiseGenerator, Turbulence};

    #[test]
    fn tilings_are_as_measured() {
        let text = include_str!("../../../tests/data/2-tiling-pavement-oracle.csv");
        let numbers = |line: &str| -> Vec<f64> { line.split(',').map(|f| f.parse().unwrap()).collect() };
        let row = |name: &str| {
            numbers(
                text.lines().find_map(|l| l.strip_prefix(name).and_then(|l| l.strip_prefix(','))).unwrap(),
            )
        };
        let (xs, zs) = (row("x"), row("z"));
        let turbulence = Turbulence::default();
        let context = Context { noise: NoiseGenerator::RangeCorrected, waves: 10, hit: None };
        let setting = Setting {
            noise: NoiseGenerator::RangeCorrected,
            turbulence: &turbulence,
            frequency: 1.0,
            phase: 0.0,
            context: &context,
        };
        let mut bad = Vec::new();
        for number in 1..=Tiling::COUNT {
            let tiling = Tiling::new(number).unwrap();
            let mut wrong = 0;
            let mut first = String::new();
            for ((&x, &z), want) in xs.iter().zip(&zs).zip(row(&format!("tiling {number}"))) {
                let got = tiling.value(Vec3::new(x, 0.0, z), &setting);
                if (got - want).abs() > 4e-6 {
                    if wrong == 0 {
                        first = format!("{got} not {want} at {x}, {z}");
                    }
                    wrong += 1;
                }
            }
            if wrong > 0 {
                bad.push(format!("tiling {number}: {wrong} points, {first}"));
            }
        }
        assert!(bad.is_empty(), "{}", bad.join("\n"));
    }
}
