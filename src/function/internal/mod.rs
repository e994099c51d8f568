//! `function { internal(n) }`: the functions that `functions.inc` names.
//!
//! A formula is written once, for numbers and for ranges of numbers alike.

mod curve;
mod fractal;
mod polynomial;
mod solid;
mod winding;

use super::interval::Interval;
use super::number::Number;
use super::slope::Slope;
use super::surroundings::Surroundings;
use crate::math::noise::NoiseGenerator;
use std::sync::Arc;

/// What a formula computes with: the point, further parameters, the scene's noise generator.
struct Arguments<'a, N> {
    x: N,
    y: N,
    z: N,
    p: &'a [N],
    generator: NoiseGenerator,
}

/// One internal function.
struct Row {
    number: u32,
    name: &'static str,
    /// Besides x, y, z.
    parameters: usize,
    number_formula: fn(&Arguments<f64>) -> f64,
    range_formula: fn(&Arguments<Interval>) -> Interval,
    slope_formula: fn(&Arguments<Slope>) -> Slope,
}

/// A table's lines: number, name in `functions.inc` without its `f_`, parameters besides x, y, z.
macro_rules! rows {
    ($($number:literal $name:ident $parameters:literal;)*) => {
        pub(super) const ROWS: &[super::Row] = &[$(super::Row {
            number: $number,
            name: concat!("f_", stringify!($name)),
            parameters: $parameters,
            number_formula: $name::<f64>,
            range_formula: $name::<super::Interval>,
            slope_formula: $name::<super::Slope>,
        }),*];
    };
}
use rows;

fn find(number: u32) -> Option<&'static Row> {
    let tables = [curve::ROWS, fractal::ROWS, polynomial::ROWS, solid::ROWS, winding::ROWS];
    tables.into_iter().flatten().find(|row| row.number == number)
}

/// An internal function in a scene.
#[derive(Clone)]
pub struct Internal {
    row: &'static Row,
    surroundings: Arc<Surroundings>,
}

impl Internal {
    /// `None` if there is no function of that number.
    pub fn new(number: u32, surroundings: &Arc<Surroundings>) -> Option<Self> {
        Some(Self { row: find(number)?, surroundings: surroundings.clone() })
    }

    pub fn number(&self) -> u32 {
        self.row.number
    }

    /// As `functions.inc` has it.
    pub fn name(&self) -> &'static str {
        self.row.name
    }

    /// The number of arguments, x, y, z included.
    pub fn arity(&self) -> usize {
        3 + self.row.parameters
    }

    /// `arguments` are as many as [`Internal::arity`] says.
    #[inline]
    pub(super) fn value<N: Number>(&self, arguments: &[N]) -> N {
        N::internal(self, arguments)
    }

    #[inline]
    pub(super) fn number_value(&self, arguments: &[f64]) -> f64 {
        (self.row.number_formula)(&self.arguments(arguments))
    }

    #[inline]
    pub(super) fn range_value(&self, arguments: &[Interval]) -> Interval {
        (self.row.range_formula)(&self.arguments(arguments))
    }

    pub(super) fn slope_value(&self, arguments: &[Slope]) -> Slope {
        (self.row.slope_formula)(&self.arguments(arguments))
    }

    #[inline]
    fn arguments<'a, N: Number>(&self, a: &'a [N]) -> Arguments<'a, N> {
        Arguments { x: a[0], y: a[1], z: a[2], p: &a[3..], generator: self.surroundings.generator() }
    }
}

impl std::fmt::Debug for Internal {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        write!(f, "internal({}) {}", self.row.number, self.row.name)
    }
}

impl<N: Number> Arguments<'_, N> {
    /// The squares of x, y and z.
    fn squares(&self) -> [N; 3] {
        [self.x.square(), self.y.square(), self.z.square()]
    }

    /// The square of the distance from the origin.
    fn r2(&self) -> N {
        self.x.square() + self.y.square() + self.z.square()
    }

    /// `p0` times a value, kept within -10 .. 10.
    fn scaled(&self, value: N) -> N {
        (self.p[0] * value).max(N::from(-10.0)).min(N::from(10.0))
    }

    /// `p0` times a value, kept within -`p1` .. `p1`.
    fn scaled_within(&self, value: N) -> N {
        (self.p[0] * value).max(-self.p[1]).min(self.p[1])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn surroundings() -> Arc<Surroundings> {
        Arc::new(Surroundings::default())
    }

    /// Number, arguments and value of each row of the table.
    fn oracle() -> impl Iterator<Item = (u32, Vec<f64>, f64)> {
        let text = include_str!("../../../tests/data/internal-functions-oracle.csv");
        text.lines().filter(|l| !l.starts_with('#')).map(|line| {
            let fields: Vec<&str> = line.split(',').collect();
            let arguments = fields[2].split(' ').map(|a| a.parse().unwrap()).collect();
            (fields[0].parse().unwrap(), arguments, fields[3].parse().unwrap())
        })
    }

    #[test]
    fn agree_with_the_reference() {
        let surroundings = surroundings();
        let mut wrong = Vec::new();
        for (number, arguments, expected) in oracle() {
            let f = Internal::new(number, &surroundings).unwrap();
            assert_eq!(f.arity(), arguments.len(), "{f:?}");
            let value: f64 = f.value(&arguments);
            if (value - expected).abs() > 1e-9 * expected.abs().max(1.0) {
                wrong.push(format!("{f:?} at {arguments:?}: {value} instead of {expected}"));
            }
        }
        assert!(wrong.is_empty(), "{wrong:#?}");
    }

    #[test]
    fn every_number_is_there() {
        let surroundings = surroundings();
        for number in (0..=76).chain([78]) {
            let f = Internal::new(number, &surroundings).unwrap();
            assert!(oracle().any(|row| row.0 == f.number()), "{f:?}");
        }
        assert!(Internal::new(77, &surroundings).is_none());
        assert!(Internal::new(79, &surroundings).is_none());
    }

    #[test]
    fn ranges_enclose_values() {
        let surroundings = surroundings();
        for (number, arguments, _) in oracle() {
            let f = Internal::new(number, &surroundings).unwrap();
            for radius in [0.0, 1e-3, 0.1, 2.0] {
                let mut ranges: Vec<Interval> = arguments.iter().map(|&a| Interval::from(a)).collect();
                for i in 0..3 {
                    ranges[i] = Interval::new(arguments[i] - radius, arguments[i] + radius);
                }
                let range = f.value(&ranges);
                for step in 0..125 {
                    let mut inner = arguments.clone();
                    for (i, digit) in [step % 5, step / 5 % 5, step / 25].into_iter().enumerate() {
                        inner[i] += radius * 0.5 * (f64::from(digit) - 2.0);
                    }
                    let value: f64 = f.value(&inner);
                    assert!(
                        range == Interval::WHOLE || range.contains(value),
                        "{f:?} at {inner:?}: {value} outside {range:?}"
                    );
                }
            }
        }
    }
}
