//! The points that waves and ripples start from.

use crate::math::Vec3;
use crate::math::noise::vector_noise;
use crate::math::random::Lcg;
use std::sync::OnceLock;

/// A point on the unit sphere, and the frequency of its waves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Source {
    pub point: Vec3,
    pub frequency: f64,
}

/// More sources than this are not kept ready.
const MOST: usize = 4096;

/// The first `number_of_waves` sources.
pub(super) fn sources(number_of_waves: usize) -> &'static [Source] {
    static FEW: OnceLock<Vec<Source>> = OnceLock::new();
    static MANY: OnceLock<Vec<Source>> = OnceLock::new();
    const FEWEST: usize = 10;
    let n = number_of_waves.clamp(1, MOST);
    if n <= FEWEST { &FEW.get_or_init(|| first(FEWEST))[..n] } else { &MANY.get_or_init(|| first(MOST))[..n] }
}

fn first(n: usize) -> Vec<Source> {
    let mut random = Lcg::new(-560_851_967_i32 as u32);
    let source = |i: usize| Source {
        point: vector_noise(Vec3::new(i as f64, 0.0, 0.0)).normalize(),
        frequency: f64::from(random.draw()) * 0.000030518509476 + 0.01,
    };
    (0..n).map(source).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sources_are_as_measured() {
        let text = include_str!("../../tests/data/2-wave-sources.csv");
        let mut count = 0;
        for line in text.lines().filter(|l| !l.starts_with('#')) {
            let row: Vec<f64> = line.split(',').map(|f| f.parse().unwrap()).collect();
            let source = sources(100)[row[0] as usize];
            let want = Vec3::new(row[1], row[2], row[3]);
            assert!((source.point - want).length() < 1e-12, "source {}: {} not {want}", row[0], source.point);
            assert!((source.frequency - row[4]).abs() < 1e-14);
            count += 1;
        }
        assert_eq!(count, 100);
    }
}
