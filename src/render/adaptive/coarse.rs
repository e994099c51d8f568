//! A picture of which only some pixels were sampled.

use super::order::COARSEST;
use super::tally::Tally;

/// For each pixel without samples the one whose colour it shows: the nearest above and to the left on the
/// finest grid that was sampled there. `None` where there is none.
pub fn stand_ins(tally: &Tally) -> Vec<Option<u32>> {
    let width = tally.width();
    let sampled = |i: usize| tally.pixels[i].count > 0;
    let any = (0..tally.pixels.len()).find(|&i| sampled(i)).map(|i| i as u32);
    let stand_in = |i: usize| {
        let (x, y) = (i % width, i / width);
        let mut step = 1;
        while step <= COARSEST {
            let j = (y - y % step) * width + x - x % step;
            if sampled(j) {
                return Some(j as u32);
            }
            step *= 2;
        }
        any
    };
    (0..tally.pixels.len()).map(stand_in).collect()
}

#[cfg(test)]
mod tests {
    use super::super::order::gradual;
    use super::super::tally::Samples;
    use super::*;
    use crate::render::Region;

    #[test]
    fn pixels_show_the_finest_grid_around_them() {
        let mut tally = Tally::new(Region::whole(40, 20));
        assert!(stand_ins(&tally).iter().all(Option::is_none));
        // The passes with steps of 16 and 8, and pixel (4, 0) of the next.
        let order = gradual(40, 20);
        for &p in &order[..5 * 3 + 1] {
            tally.pixels[p as usize] = Samples { count: 1, ..Samples::default() };
        }
        let shown = stand_ins(&tally);
        let at = |x: usize, y: usize| shown[y * 40 + x].map(|i| (i as usize % 40, i as usize / 40));
        assert_eq!(at(16, 0), Some((16, 0)));
        assert_eq!(at(31, 19), Some((24, 16)));
        assert_eq!(at(7, 7), Some((0, 0)));
        assert_eq!((order[15], at(5, 3)), (4, Some((4, 0))));
    }
}
