//! Where what is difficult is edges, and where it is noise or texture.
//!
//! Next to an edge a plane explains most of how nine pixels differ, in noise it does not. Square by square with those
//! around, the share that is explained tells which of the two it is: at edges a pixel's second sample goes where the
//! edge is expected ([`super::heading`]), elsewhere three more are spread over the pixel.

/// Side of a square.
const SIDE: usize = 8;
/// Differences are those of edges if a plane explains this share of them.
const LEAST_EXPLAINED: f32 = 0.6;
/// And this share of a pixel's own.
const LEAST_OWN: f32 = 0.5;
/// Neighbourhoods of fewer sampled pixels say nothing: colours that lie between others are on planes.
const LEAST_SAMPLED: u8 = 6;

/// How the pixels around one differ from their mean, squared and summed up.
#[derive(Clone, Copy, Debug, Default)]
pub struct Differences {
    pub all: f32,
    /// What a plane leaves.
    pub left: f32,
    /// Pixels that have samples.
    pub sampled: u8,
}

/// Which squares have edges.
#[derive(Clone, Debug, Default)]
pub struct Edges {
    width: usize,
    columns: usize,
    squares: Vec<bool>,
    /// Pixels around which a plane explains enough.
    pixels: Vec<bool>,
}

impl Edges {
    pub fn new(width: usize, differences: impl ExactSizeIterator<Item = Differences>) -> Self {
        let width = width.max(1);
        let (columns, rows) = (width.div_ceil(SIDE), (differences.len() / width).div_ceil(SIDE));
        let mut pixels = Vec::with_capacity(differences.len());
        let mut sums = vec![(0.0f32, 0.0f32); columns * rows];
        for (i, d) in differences.enumerate() {
            pixels.push(d.left <= (1.0 - LEAST_OWN) * d.all);
            if d.sampled >= LEAST_SAMPLED {
                let sum = &mut sums[i / width / SIDE * columns + i % width / SIDE];
                *sum = (sum.0 + d.all, sum.1 + d.left);
            }
        }
        let has_edges = |x: usize, y: usize| {
            let (mut all, mut left) = (0.0, 0.0);
            for row in y.saturating_sub(1)..(y + 2).min(rows) {
                for sum in &sums[row * columns..][x.saturating_sub(1)..(x + 2).min(columns)] {
                    (all, left) = (all + sum.0, left + sum.1);
                }
            }
            left <= (1.0 - LEAST_EXPLAINED) * all
        };
        let squares = (0..columns * rows).map(|i| has_edges(i % columns, i / columns)).collect();
        Self { width, columns, squares, pixels }
    }

    /// Whether pixel `i` lies in a square of edges.
    #[inline]
    pub fn is_near(&self, i: usize) -> bool {
        self.pixels[i] && self.squares[i / self.width / SIDE * self.columns + i % self.width / SIDE]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Edges on the left, noise on the right, in which every fifth pixel is on a plane by chance.
    #[test]
    fn squares_are_told_apart() {
        let of = |i: usize| match i % 64 {
            0..32 => Differences { all: 1.0, left: 0.3, sampled: 9 },
            x if x % 5 == 0 => Differences { all: 1.0, left: 0.1, sampled: 9 },
            _ => Differences { all: 1.0, left: 0.8, sampled: 9 },
        };
        let edges = Edges::new(64, (0..64 * 16).map(of));
        let clear = (0..64 * 16).filter(|i| !(24..40).contains(&(i % 64)));
        clear.for_each(|i| assert_eq!(edges.is_near(i), i % 64 < 32, "{i}"));
        // What too few samples say of a square does not count.
        let few = Edges::new(64, (0..64 * 16).map(|i| Differences { sampled: 5, ..of(i) }));
        assert!(few.is_near(60) && !few.is_near(61));
    }
}
