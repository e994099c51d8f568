//! How fast means come near the truth: variance falls like n^-1 for noise, n^-3/2 at edges and n^-3 where
//! colours are smooth. Which of them a picture has is measured while it is made
//! ([`super::calibration::Calibration::convergence`]).

/// Number of doublings that are told apart.
pub const LEVELS: usize = 24;

/// The level of a pixel with 2^level samples.
pub fn level(count: u32) -> usize {
    (count.max(1).ilog2() as usize).min(LEVELS - 1)
}

/// By how much the variance of a mean falls with each doubling of its samples.
#[derive(Clone, Debug)]
pub struct Convergence {
    /// Variance of the mean of 2^(k+1) samples over that of 2^k.
    pub ratio: [f32; LEVELS],
}

impl Default for Convergence {
    /// Edges of random place and direction through a pixel.
    fn default() -> Self {
        let mut ratio = [0.36; LEVELS];
        ratio[..4].copy_from_slice(&[0.29, 0.31, 0.33, 0.35]);
        Self { ratio }
    }
}

impl Convergence {
    /// The squared error of a mean of 2^level samples, where the mean of as many new ones is off by the root
    /// of `jump`. Of independent halves it would be half the jump; stratified together they repel each other.
    pub fn error_from_jump(&self, level: usize, jump: f32) -> f32 {
        jump / (4.0 - 4.0 * self.ratio[level])
    }

    /// Variance of the mean of 2^k samples over that of one.
    pub fn gain(&self) -> [f32; LEVELS] {
        let mut gain = [1.0; LEVELS];
        for k in 1..LEVELS {
            gain[k] = gain[k - 1] * self.ratio[k - 1];
        }
        gain
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::adaptive::Sequence;

    /// The preset values, measured: lines of random place and direction through a pixel.
    #[test]
    fn edges_converge_as_preset() {
        let preset = Convergence::default();
        let (mut errors, mut jumps) = ([0.0f64; 5], [0.0f64; 5]);
        let trials = 12_000u32;
        for t in 0..trials {
            let (sin, cos) = (f64::from(t) * 2.399_963).sin_cos();
            let place = f64::from(t % 997) / 997.0 - 0.5;
            let inside = |(x, y): (f64, f64)| if cos * x + sin * y < place { 1.0 } else { 0.0 };
            let sequence = Sequence::new(t, 3, 0);
            let values: Vec<f64> = (0..32).map(|i| inside(sequence.offset(i))).collect();
            let side = 40;
            let middle = |i: i32| (f64::from(i) + 0.5) / f64::from(side) - 0.5;
            let truth = (0..side * side).map(|i| inside((middle(i % side), middle(i / side)))).sum::<f64>()
                / f64::from(side * side);
            for k in 0..5 {
                let mean =
                    |from: usize| values[from..from + (1 << k)].iter().sum::<f64>() / f64::from(1 << k);
                errors[k] += (mean(0) - truth).powi(2);
                jumps[k] += (mean(0) - mean(1 << k)).powi(2);
            }
        }
        for k in 0..4 {
            let ratio = errors[k + 1] / errors[k];
            assert!((ratio / f64::from(preset.ratio[k]) - 1.0).abs() < 0.1, "{k}: {ratio}");
            let told = f64::from(preset.error_from_jump(k, jumps[k] as f32));
            assert!((told / errors[k] - 1.0).abs() < 0.15, "{k}: {}", told / errors[k]);
        }
    }

    #[test]
    fn levels_are_doublings() {
        assert_eq!([0, 1, 2, 3, 4, 1 << 20, u32::MAX].map(level), [0, 0, 1, 1, 2, 20, 23]);
        let gain = Convergence { ratio: [0.5; LEVELS] }.gain();
        assert_eq!((gain[0], gain[3]), (1.0, 0.125));
    }
}
