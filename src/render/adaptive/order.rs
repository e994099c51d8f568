//! In which order pixels are sampled for the first time.

/// Side of the squares that are finished one after the other, so that rays of one square follow each other.
const TILE: usize = 16;
/// Where the first pass of a gradual order puts its samples: every so many pixels along both sides.
pub const COARSEST: usize = 16;

/// All pixels, square by square.
pub fn tiled(width: usize, height: usize) -> Vec<u32> {
    spaced(width, height, 1)
}

/// Every so many pixels along both sides one, square by square. Squares hold a whole number of them.
pub fn spaced(width: usize, height: usize, spacing: usize) -> Vec<u32> {
    let mut pixels = Vec::with_capacity(width.div_ceil(spacing) * height.div_ceil(spacing));
    for top in (0..height).step_by(TILE) {
        for left in (0..width).step_by(TILE) {
            for y in (top..(top + TILE).min(height)).step_by(spacing) {
                let row = (left..(left + TILE).min(width)).step_by(spacing);
                pixels.extend(row.map(|x| (y * width + x) as u32));
            }
        }
    }
    pixels
}

/// All pixels in passes, each of which halves the distance between the pixels that have been sampled: a
/// picture that ends early is coarse instead of unfinished.
pub fn gradual(width: usize, height: usize) -> Vec<u32> {
    let mut pixels: Vec<u32> = (0..(width * height) as u32).collect();
    pixels.sort_by_key(|&p| {
        let (x, y) = (p as usize % width, p as usize / width);
        (pass(x, y), y / TILE, x / TILE)
    });
    pixels
}

/// The pass that samples a pixel, from 0.
fn pass(x: usize, y: usize) -> u32 {
    let finest = (x | y | COARSEST).trailing_zeros();
    COARSEST.trailing_zeros() - finest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orders_hold_every_pixel_once() {
        for (width, height) in [(1, 1), (7, 40), (50, 33)] {
            for mut order in [tiled(width, height), gradual(width, height)] {
                order.sort_unstable();
                assert!(order.iter().enumerate().all(|(i, &p)| i == p as usize));
                assert_eq!(order.len(), width * height);
            }
        }
    }

    #[test]
    fn the_first_pass_is_coarse() {
        let order = gradual(64, 48);
        assert!(order[..12].iter().all(|p| p % 64 % 16 == 0 && p / 64 % 16 == 0));
        assert!(order[..48].iter().all(|p| p % 64 % 8 == 0 && p / 64 % 8 == 0));
    }
}
