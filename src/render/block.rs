use super::Region;
use crate::picture::Pixel;

/// A square of pixels that one thread traces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Block {
    pub region: Region,
}

impl Block {
    /// The pixels of the block, row by row.
    pub fn places(&self) -> impl Iterator<Item = (u32, u32)> + use<> {
        let r = self.region;
        (r.y0..r.y1).flat_map(move |y| (r.x0..r.x1).map(move |x| (x, y)))
    }

    /// Pixels of which none has been traced.
    pub fn unfinished(&self) -> Vec<Pixel> {
        vec![Pixel::NONE; self.region.pixels() as usize]
    }
}

/// The blocks of a region, row by row from its first pixel on.
pub fn blocks(region: Region, size: u32) -> Vec<Block> {
    let size = size.max(1);
    let steps = |from: u32, to: u32| (from..to).step_by(size as usize);
    let block = |x: u32, y: u32| Block {
        region: Region {
            x0: x,
            y0: y,
            x1: x.saturating_add(size).min(region.x1),
            y1: y.saturating_add(size).min(region.y1),
        },
    };
    steps(region.y0, region.y1).flat_map(|y| steps(region.x0, region.x1).map(move |x| block(x, y))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_cover_every_pixel_once() {
        let region = Region { x0: 3, y0: 5, x1: 80, y1: 41 };
        let mut seen = vec![0; 80 * 41];
        for block in blocks(region, 32) {
            for (x, y) in block.places() {
                seen[(y * 80 + x) as usize] += 1;
            }
        }
        for y in 0..41 {
            for x in 0..80 {
                let inside = (3..80).contains(&x) && (5..41).contains(&y);
                assert_eq!(seen[(y * 80 + x) as usize], u32::from(inside), "{x} {y}");
            }
        }
        assert_eq!(blocks(region, 32).len(), 6);
    }
}
