use super::{Bozo, Chain, Context, NoiseGenerator, Pattern, Setting, Turbulence, Wave};
use crate::function::Surroundings;
use crate::math::field::Field;
use crate::math::{Transform, Vec3, floor};
use std::sync::Arc;

/// A pattern as pigments, normals and textures use it: warped, repeated by a frequency, shaped by a wave.
///
/// | setting | default | meaning |
/// |---|---|---|
/// | chain | empty | transformations and warps |
/// | turbulence | none | acts after the chain |
/// | frequency, phase | 1, 0 | the value becomes `value * frequency + phase`, wrapped |
/// | wave | ramp | shape of each period |
/// | noise_generator | 0 | generator; 0 for the scene's |
///
/// Settings stay when the pattern changes, except those that the new pattern's keyword sets.
#[derive(Clone, Debug)]
pub struct Signal {
    pub pattern: Arc<dyn Pattern>,
    pub chain: Chain,
    pub turbulence: Turbulence,
    pub frequency: f64,
    pub phase: f64,
    pub wave: Wave,
    /// What `poly_wave` means without a number.
    pub poly_exponent: f64,
    /// Bits of all generators written; 0 for the scene's.
    pub noise_generator: u32,
    /// Whether turbulence moves points before the pattern sees them.
    displaced: bool,
}

impl Default for Signal {
    fn default() -> Self {
        Self {
            pattern: Arc::new(Bozo),
            chain: Chain::default(),
            turbulence: Turbulence::default(),
            frequency: 1.0,
            phase: 0.0,
            wave: Wave::Ramp,
            poly_exponent: 1.0,
            noise_generator: 0,
            displaced: true,
        }
    }
}

/// Patterns are not asked farther out than this.
const FARTHEST: f64 = 1e17;

#[inline]
fn within_reach(p: Vec3) -> Vec3 {
    let is_near = |c: f64| c.abs() <= FARTHEST;
    if is_near(p.x) && is_near(p.y) && is_near(p.z) {
        p
    } else {
        p.clamp(Vec3::splat(-FARTHEST), Vec3::splat(FARTHEST))
    }
}

/// Values wrap around here, not at 1: 1 itself stays, 2 becomes 0.99999.
const PERIOD: f64 = 1.00001;

/// `v % PERIOD`, to the bit.
///
/// Everything that is computed here is a multiple of 2^-52 below 2, thus free of rounding: the period's upper part has
/// 26 bits and its lower part is a multiple of 2^-52, as are all numbers above 1.
#[inline]
fn remainder(v: f64) -> f64 {
    /// The upper bits of the period, and the others.
    const PARTS: [f64; 2] = {
        let high = f64::from_bits(PERIOD.to_bits() & !0x07ff_ffff);
        [high, PERIOD - high]
    };
    const LARGEST: f64 = 16_777_216.0;
    let size = v.abs();
    if size < PERIOD {
        return v;
    }
    if !(size < LARGEST) {
        return v % PERIOD;
    }
    let count = f64::from((size * (1.0 / PERIOD)) as i32);
    let rest = (size - count * PARTS[0]) - count * PARTS[1];
    // The count may be wrong by one.
    let rest = if rest < 0.0 { rest + PERIOD } else { rest };
    let rest = if rest >= PERIOD { rest - PERIOD } else { rest };
    rest.copysign(v)
}

impl Signal {
    pub fn new(pattern: Arc<dyn Pattern>) -> Self {
        let mut signal = Self::default();
        signal.set_pattern(pattern);
        signal
    }

    /// Changes the pattern and what its keyword sets.
    pub fn set_pattern(&mut self, pattern: Arc<dyn Pattern>) {
        let character = pattern.character();
        if !character.periodic {
            self.frequency = 0.0;
        }
        if let Some(wave) = character.wave {
            self.wave = wave;
        }
        self.displaced = !character.absorbs_turbulence;
        self.pattern = pattern;
    }

    /// Moves the pattern.
    pub fn transform(&mut self, t: &Transform) {
        self.chain.transform(t);
    }

    fn setting<'a>(&'a self, context: &'a Context<'a>) -> Setting<'a> {
        Setting {
            noise: NoiseGenerator::from_number(self.noise_generator).unwrap_or(context.noise),
            turbulence: &self.turbulence,
            frequency: self.frequency,
            phase: self.phase,
            context,
        }
    }

    /// A point outside to the pattern's own space, where [`Signal::value`] and the items of maps are taken.
    #[inline]
    pub fn warp(&self, p: Vec3) -> Vec3 {
        let p = self.chain.apply(p);
        let p = if self.displaced { self.turbulence.displace(p) } else { p };
        within_reach(p)
    }

    /// The same for a signal whose pattern is not used: averages, images, plain containers.
    #[inline]
    pub fn warp_alone(&self, p: Vec3) -> Vec3 {
        within_reach(self.turbulence.displace(self.chain.apply(p)))
    }

    /// The map value at a warped point.
    #[inline]
    pub fn value(&self, warped: Vec3, context: &Context) -> f64 {
        self.shaped(self.pattern.value(warped, &self.setting(context)))
    }

    #[inline]
    fn shaped(&self, mut v: f64) -> f64 {
        if self.frequency != 0.0 {
            v = v * self.frequency + self.phase;
            v = remainder(v);
        }
        if v < 0.0 {
            v -= floor(v);
        }
        self.wave.shape(v)
    }

    /// The same, or a value near it as soon as `settles` says of a range that it lies in that no value there
    /// makes a difference.
    pub fn value_within(&self, warped: Vec3, context: &Context, settles: &dyn Fn(f64, f64) -> bool) -> f64 {
        if !self.is_even() {
            return self.value(warped, context);
        }
        let inside = |low: f64, high: f64| low >= 0.0 && high < 1.0 && settles(low, high);
        self.shaped(self.pattern.value_within(warped, &self.setting(context), &inside))
    }

    /// Whether the pattern's values below 1 stay as they are.
    fn is_even(&self) -> bool {
        (self.frequency == 0.0 || (self.frequency == 1.0 && self.phase == 0.0)) && self.wave == Wave::Ramp
    }

    /// See [`Chain::calmed`]; with the turbulence that acts after the chain.
    pub fn calmed(&self) -> Option<(glam::DAffine3, f64)> {
        let (inward, shift) = self.chain.calmed().filter(|_| self.is_even())?;
        let own = if self.displaced { self.turbulence.shift() } else { 0.0 };
        Some((inward, f64::hypot(shift, own)))
    }

    /// The normal perturbed by the pattern's own rule, if it has one.
    pub fn perturb(&self, n: Vec3, amount: f64, warped: Vec3, context: &Context) -> Option<Vec3> {
        self.pattern.perturb(n, amount, warped, &self.setting(context))
    }
}

/// A pattern as a function of space, away from any surface.
#[derive(Clone, Debug)]
pub struct PatternField {
    pub signal: Signal,
    pub surroundings: Arc<Surroundings>,
}

impl Field for PatternField {
    fn value(&self, p: Vec3) -> f64 {
        let context = Context::away(&self.surroundings);
        self.signal.value(self.signal.warp(p), &context)
    }

    fn depth(&self) -> u32 {
        1 + self.signal.pattern.depth()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn remainders_have_no_rounding() {
        let mut random = crate::math::random::Lcg::new(7);
        let odd = [0.0, -0.0, 1.0, PERIOD, -PERIOD, 2.0 * PERIOD, 1e17, -1e300, f64::INFINITY, f64::NAN];
        let mut values = odd.to_vec();
        for i in 0..100_000 {
            let part = f64::from(random.draw()) / 32767.0 + f64::from(random.draw()) / 1e9;
            values.push((part - 0.5) * [4.0, 100.0, 1e5, 4e7][i % 4]);
        }
        for k in 0..3000 {
            let whole = f64::from(k * 37) * PERIOD;
            values.extend([whole.next_down(), whole, whole.next_up()]);
        }
        for v in values {
            let (found, right) = (remainder(v), v % PERIOD);
            assert!(
                found.to_bits() == right.to_bits() || (found.is_nan() && right.is_nan()),
                "{v}: {found} {right}"
            );
        }
    }
}
