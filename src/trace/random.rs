//! Random numbers that depend on the place on the picture and the sample, never on what was traced before
//! or on which thread.
//!
//! A counter is hashed with the finaliser of SplitMix64.
//!
//! Reference: G. L. Steele, D. Lea, C. H. Flood, "Fast Splittable Pseudorandom Number Generators", 2014.

/// Draws for one sample of one pixel.
#[derive(Clone, Copy, Debug)]
pub(super) struct Random {
    state: u64,
}

const STEP: u64 = 0x9e37_79b9_7f4a_7c15;

impl Random {
    pub fn new(x: u32, y: u32, sample: u32) -> Self {
        let place = (u64::from(x) << 32) | u64::from(y);
        Self { state: mixed(mixed(place).wrapping_add(u64::from(sample).wrapping_mul(STEP))) }
    }

    /// The next number in 0..1.
    pub fn draw(&mut self) -> f64 {
        self.state = self.state.wrapping_add(STEP);
        (mixed(self.state) >> 11) as f64 * (1.0 / (1u64 << 53) as f64)
    }
}

fn mixed(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::Random;

    #[test]
    fn place_and_sample_decide() {
        let first = |x, y, s| Random::new(x, y, s).draw();
        assert_eq!(first(3, 7, 0), first(3, 7, 0));
        assert_ne!(first(3, 7, 0), first(7, 3, 0));
        assert_ne!(first(3, 7, 0), first(3, 7, 1));
    }

    #[test]
    fn mean_and_variance_are_those_of_uniform_numbers() {
        let draws: Vec<f64> = (0..20_000).map(|i| Random::new(i % 160, i / 160, 2).draw()).collect();
        let mean = draws.iter().sum::<f64>() / draws.len() as f64;
        let variance = draws.iter().map(|d| (d - mean).powi(2)).sum::<f64>() / draws.len() as f64;
        assert!((mean - 0.5).abs() < 0.01 && (variance - 1.0 / 12.0).abs() < 0.003, "{mean} {variance}");
    }
}
