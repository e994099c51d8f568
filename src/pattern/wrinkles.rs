use super::{NoiseGenerator, Pattern, Setting};
use crate::math::Vec3;
use crate::math::noise::{octaves, vector_octaves};

const OCTAVES: usize = 10;

/// So many octaves at a time are added before they are looked at.
const STEPS: [usize; 5] = [3, 1, 2, 2, 2];

/// The weight of the last octave.
const SMALLEST: f64 = 1.0 / 512.0;

/// See [`Pattern::steepness`].
const STEEPNESS: f64 = 0.8;

#[inline]
fn wrinkled(n: f64, generator: NoiseGenerator) -> f64 {
    if generator == NoiseGenerator::Original { n } else { (2.0 * n - 0.5).clamp(0.0, 1.0) }
}

/// Ten octaves of noise.
#[derive(Clone, Copy, Debug)]
pub struct Wrinkles;

impl Pattern for Wrinkles {
    fn value(&self, p: Vec3, setting: &Setting) -> f64 {
        let mut noise = [0.0; OCTAVES];
        octaves(p, 1.0, 2.0, setting.noise, &mut noise);
        let (mut sum, mut weight) = (0.0, 1.0);
        for &n in &noise {
            sum += wrinkled(n, setting.noise) * weight;
            weight *= 0.5;
        }
        0.5 * sum
    }

    /// What octaves that are left out may add has a middle, which stands for them.
    fn value_within(&self, p: Vec3, setting: &Setting, settles: &dyn Fn(f64, f64) -> bool) -> f64 {
        let (mut sum, mut weight) = (0.0, 1.0);
        for count in STEPS {
            let mut noise = [0.0; STEPS[0]];
            let noise = &mut noise[..count];
            octaves(p, 1.0 / weight, 2.0, setting.noise, noise);
            for &mut n in noise {
                sum += wrinkled(n, setting.noise) * weight;
                weight *= 0.5;
            }
            let rest = 2.0 * weight - SMALLEST;
            if rest > 0.0 && settles(0.5 * sum, 0.5 * (sum + rest)) {
                return 0.5 * (sum + 0.5 * rest);
            }
        }
        0.5 * sum
    }

    fn steepness(&self) -> Option<f64> {
        Some(STEEPNESS)
    }

    fn perturb(&self, n: Vec3, amount: f64, p: Vec3, _setting: &Setting) -> Option<Vec3> {
        Some(n + amount * vector_octaves(p, [2.0, 0.5], OCTAVES, true))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::random::Lcg;
    use crate::pattern::{Context, Turbulence};

    #[test]
    fn steepness_is_as_measured() {
        let context = Context { noise: NoiseGenerator::RangeCorrected, waves: 10, hit: None };
        let turbulence = Turbulence::default();
        let (noise, mut random) = (NoiseGenerator::RangeCorrected, Lcg::new(5));
        let setting =
            Setting { noise, turbulence: &turbulence, frequency: 1.0, phase: 0.0, context: &context };
        let mut part = || f64::from(random.draw()) / 32767.0 - 0.5;
        let mut sum = 0.0;
        for _ in 0..4000 {
            let p = 100.0 * Vec3::new(part(), part(), part());
            let away = 0.002 * Vec3::new(part(), part(), part()).normalize_or(Vec3::X);
            let change = Wrinkles.value(p + away, &setting) - Wrinkles.value(p, &setting);
            sum += (change / 0.002).powi(2);
        }
        let steepness = (sum / 4000.0_f64).sqrt();
        assert!((steepness - STEEPNESS).abs() < 0.3 * STEEPNESS, "{steepness}");
    }

    #[test]
    fn values_within_a_range_lie_in_it() {
        let context = Context { noise: NoiseGenerator::RangeCorrected, waves: 10, hit: None };
        let turbulence = Turbulence::default();
        for noise in [NoiseGenerator::Original, NoiseGenerator::RangeCorrected] {
            let setting =
                Setting { noise, turbulence: &turbulence, frequency: 1.0, phase: 0.0, context: &context };
            for i in 0..300 {
                let f = f64::from(i);
                let p = Vec3::new(0.37 * f, (0.7 * f).sin() * 9.0, -0.11 * f);
                let value = Wrinkles.value(p, &setting);
                assert_eq!(Wrinkles.value_within(p, &setting, &|_, _| false), value);
                for width in [0.4, 0.1, 0.01] {
                    let near = Wrinkles.value_within(p, &setting, &|low, high| {
                        assert!(low <= value && value <= high + 1e-12, "{low} {value} {high}");
                        high - low <= width
                    });
                    assert!((near - value).abs() <= 0.5 * width + 1e-12);
                }
            }
        }
    }
}
