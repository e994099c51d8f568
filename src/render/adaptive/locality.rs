//! Where expectations fall short: parts of a picture differ in kind.
//!
//! Noise (soft shadows, say) converges slower than edges, and a picture often has its noise in one place and
//! its edges in another. What the last doubling of each pixel has shown is compared with what was expected,
//! square by square, and smoothed over neighbouring squares.

use super::tally::Tally;

/// Side of a square.
const SIDE: usize = 8;
/// So many pixels of the mean kind are added to every square and its neighbours.
const TRUST: f64 = 12.0;

/// The last doubling of one pixel: squared errors of the old half.
#[derive(Clone, Copy, Debug, Default)]
pub struct Shown {
    pub expected: f32,
    pub measured: f32,
}

/// What expectations are to be multiplied by, square by square.
#[derive(Clone, Debug)]
pub struct Locality {
    columns: usize,
    factors: Vec<f32>,
}

impl Locality {
    pub fn new(tally: &Tally, shown: &[Shown]) -> Self {
        let (width, height) = (tally.width(), tally.height());
        let (columns, rows) = (width.div_ceil(SIDE), height.div_ceil(SIDE));
        let mut squares = vec![Sum::default(); columns * rows];
        for (i, s) in shown.iter().enumerate().filter(|(_, s)| s.expected > 0.0) {
            squares[i / width / SIDE * columns + i % width / SIDE].add(s);
        }
        let mut factors = Vec::with_capacity(squares.len());
        for row in 0..rows {
            for column in 0..columns {
                factors.push(Sum::around(&squares, columns, rows, column, row).factor());
            }
        }
        Self { columns, factors }
    }

    pub fn factor(&self, x: usize, y: usize) -> f32 {
        self.factors[y / SIDE * self.columns + x / SIDE]
    }
}

#[derive(Clone, Copy, Debug, Default)]
struct Sum {
    count: f64,
    expected: f64,
    measured: f64,
}

impl Sum {
    fn add(&mut self, s: &Shown) {
        self.count += 1.0;
        self.expected += f64::from(s.expected);
        self.measured += f64::from(s.measured);
    }

    /// A square with its eight neighbours.
    fn around(squares: &[Sum], columns: usize, rows: usize, column: usize, row: usize) -> Sum {
        let mut sum = Sum::default();
        for r in row.saturating_sub(1)..(row + 2).min(rows) {
            for c in column.saturating_sub(1)..(column + 2).min(columns) {
                let s = &squares[r * columns + c];
                sum.count += s.count;
                sum.expected += s.expected;
                sum.measured += s.measured;
            }
        }
        sum
    }

    fn factor(&self) -> f32 {
        if self.count == 0.0 {
            return 1.0;
        }
        let trust = TRUST * self.expected / self.count;
        ((self.measured + trust) / (self.expected + trust)) as f32
    }
}
