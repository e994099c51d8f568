//! Which settings are tried on a scene: only what it has.

use super::{Knobs, Sampling};
use crate::render::Method;

/// Something that can be varied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Anti-aliasing method, threshold and depth.
    Sampling,
    TraceLevel,
    AdcBailout,
    /// Lamps of area lights.
    AreaSamples,
}

impl Axis {
    pub const ALL: [(&'static str, Axis); 4] = [
        ("aa", Axis::Sampling),
        ("trace-level", Axis::TraceLevel),
        ("adc-bailout", Axis::AdcBailout),
        ("area-samples", Axis::AreaSamples),
    ];
}

/// What a scene has to be varied, apart from its sampling.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Axes {
    /// The scene's own level, if any ray goes deeper than the first.
    pub trace_level: Option<u32>,
    /// The scene's own value, if there are rays that it can end.
    pub adc_bailout: Option<f32>,
    /// Lamps of the largest area light.
    pub lamps: Option<u32>,
}

impl Axes {
    /// Only what was asked for.
    pub fn only(&self, wanted: &[Axis]) -> Axes {
        let has = |axis| wanted.contains(&axis);
        Axes {
            trace_level: self.trace_level.filter(|_| has(Axis::TraceLevel)),
            adc_bailout: self.adc_bailout.filter(|_| has(Axis::AdcBailout)),
            lamps: self.lamps.filter(|_| has(Axis::AreaSamples)),
        }
    }
}

const ERRORS: [f64; 5] = [0.04, 0.02, 0.01, 0.005, 0.0025];
const GRID: [(f32, u32); 6] = [(0.3, 2), (0.3, 3), (0.3, 5), (0.1, 3), (0.1, 5), (0.03, 4)];
const RECURSIVE: [(f32, u32); 6] = [(0.3, 2), (0.3, 3), (0.1, 3), (0.3, 4), (0.1, 4), (0.03, 4)];
const TRACE_LEVELS: [u32; 5] = [1, 2, 3, 5, 10];
const BAILOUTS: [f32; 3] = [0.01, 0.03, 0.1];
const LAMPS: [u32; 4] = [1, 4, 9, 25];

/// All ways to be tried, the quick ones first within each kind. Without `sampling`, only adaptive sampling is
/// used.
pub fn grid(axes: &Axes, sampling: bool) -> Vec<Knobs> {
    let fixed = |method: Method, list: &[(f32, u32)]| -> Vec<Knobs> {
        let knobs = |&(threshold, depth)| Knobs::new(Sampling::Fixed { method, threshold, depth });
        list.iter().map(knobs).collect()
    };
    let adaptive = |max_error: f64| Knobs::new(Sampling::Adaptive { max_error });
    let mut all = Vec::new();
    if sampling {
        all.push(Knobs::new(Sampling::Centre));
    }
    all.extend(ERRORS.map(adaptive));
    if sampling {
        all.extend(fixed(Method::Grid, &GRID));
        all.extend(fixed(Method::Recursive, &RECURSIVE));
    }
    for own in ERRORS[1..4].iter().map(|&e| adaptive(e)) {
        let levels = TRACE_LEVELS.iter().filter(|&&l| axes.trace_level.is_some_and(|own| l < own));
        all.extend(levels.map(|&l| Knobs { trace_level: Some(l), ..own }));
        let bailouts = BAILOUTS.iter().filter(|&&b| axes.adc_bailout.is_some_and(|own| b > own));
        all.extend(bailouts.map(|&b| Knobs { adc_bailout: Some(b), ..own }));
        let lamps = LAMPS.iter().filter(|&&n| axes.lamps.is_some_and(|own| n < own));
        all.extend(lamps.map(|&n| Knobs { area_samples: Some(n), ..own }));
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plain_scene_has_only_its_sampling() {
        let all = grid(&Axes::default(), true);
        assert_eq!(all.len(), 1 + 5 + 6 + 6);
        assert!(all.iter().all(|k| k.trace_level.is_none() && k.area_samples.is_none()));
    }

    #[test]
    fn only_cheaper_values_than_the_scenes_own_are_tried() {
        let axes = Axes { trace_level: Some(5), adc_bailout: Some(1.0 / 255.0), lamps: Some(9) };
        let all = grid(&axes, false);
        let levels: Vec<u32> = all.iter().filter_map(|k| k.trace_level).collect();
        assert_eq!(levels, [1, 2, 3, 1, 2, 3, 1, 2, 3]);
        assert_eq!(all.iter().filter(|k| k.adc_bailout.is_some()).count(), 9);
        assert_eq!(all.iter().filter_map(|k| k.area_samples).max(), Some(4));
        let only = axes.only(&[Axis::AdcBailout]);
        assert_eq!(only, Axes { adc_bailout: Some(1.0 / 255.0), ..Axes::default() });
    }
}
