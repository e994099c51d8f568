//! Which settings are tried on a scene: only what it has.

use super::{Knobs, Sampling};
use crate::render::Method;
use crate::trace::Overrides;

/// Something that can be varied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Anti-aliasing method, threshold and depth.
    Sampling,
    TraceLevel,
    AdcBailout,
    /// Lamps of area lights.
    AreaSamples,
    RadiosityCount,
    MediaSamples,
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
    /// Rays of a radiosity gather.
    pub radiosity_count: Option<u32>,
    /// Samples of the medium with most of them.
    pub media_samples: Option<u32>,
}

impl Axes {
    /// Only what was asked for.
    pub fn only(&self, wanted: &[Axis]) -> Axes {
        let has = |axis| wanted.contains(&axis);
        Axes {
            trace_level: self.trace_level.filter(|_| has(Axis::TraceLevel)),
            adc_bailout: self.adc_bailout.filter(|_| has(Axis::AdcBailout)),
            lamps: self.lamps.filter(|_| has(Axis::AreaSamples)),
            radiosity_count: self.radiosity_count.filter(|_| has(Axis::RadiosityCount)),
            media_samples: self.media_samples.filter(|_| has(Axis::MediaSamples)),
        }
    }
}

impl Axes {
    /// What is cheaper than the scene's own, one thing at a time.
    fn economies(&self) -> Vec<Overrides> {
        fn below(list: &[u32], own: Option<u32>) -> impl Iterator<Item = Option<u32>> {
            list.iter().filter(move |&&n| own.is_some_and(|own| n < own)).map(|&n| Some(n))
        }
        let none = Overrides::default();
        let mut all = Vec::new();
        let levels = below(&TRACE_LEVELS, self.trace_level);
        all.extend(levels.map(|max_trace_level| Overrides { max_trace_level, ..none }));
        let bailouts = BAILOUTS.iter().filter(|&&b| self.adc_bailout.is_some_and(|own| b > own));
        all.extend(bailouts.map(|&b| Overrides { adc_bailout: Some(b), ..none }));
        let lamps = below(&LAMPS, self.lamps);
        all.extend(lamps.map(|area_samples| Overrides { area_samples, ..none }));
        let gathers = below(&GATHERS, self.radiosity_count);
        all.extend(gathers.map(|radiosity_count| Overrides { radiosity_count, ..none }));
        let media = below(&MEDIA, self.media_samples);
        all.extend(media.map(|media_samples| Overrides { media_samples, ..none }));
        all
    }
}

const ERRORS: [f64; 5] = [0.04, 0.02, 0.01, 0.005, 0.0025];
const GRID: [(f32, u32); 6] = [(0.3, 2), (0.3, 3), (0.3, 5), (0.1, 3), (0.1, 5), (0.03, 4)];
const RECURSIVE: [(f32, u32); 6] = [(0.3, 2), (0.3, 3), (0.1, 3), (0.3, 4), (0.1, 4), (0.03, 4)];
const TRACE_LEVELS: [u32; 5] = [1, 2, 3, 5, 10];
const BAILOUTS: [f32; 3] = [0.01, 0.03, 0.1];
const LAMPS: [u32; 4] = [1, 4, 9, 25];
const GATHERS: [u32; 4] = [10, 35, 100, 300];
const MEDIA: [u32; 4] = [1, 2, 4, 8];

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
        all.extend(axes.economies().into_iter().map(|overrides| Knobs { overrides, ..own }));
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
        assert!(all.iter().all(|k| k.overrides == Overrides::default()));
    }

    #[test]
    fn only_cheaper_values_than_the_scenes_own_are_tried() {
        let axes = Axes {
            trace_level: Some(5),
            adc_bailout: Some(1.0 / 255.0),
            lamps: Some(9),
            radiosity_count: Some(35),
            media_samples: None,
        };
        let all = grid(&axes, false);
        let levels: Vec<u32> = all.iter().filter_map(|k| k.overrides.max_trace_level).collect();
        assert_eq!(levels, [1, 2, 3, 1, 2, 3, 1, 2, 3]);
        assert_eq!(all.iter().filter(|k| k.overrides.adc_bailout.is_some()).count(), 9);
        assert_eq!(all.iter().filter_map(|k| k.overrides.area_samples).max(), Some(4));
        assert_eq!(all.iter().filter_map(|k| k.overrides.radiosity_count).collect::<Vec<_>>(), [10; 3]);
        assert!(all.iter().all(|k| k.overrides.media_samples.is_none()));
        let only = axes.only(&[Axis::AdcBailout]);
        assert_eq!(only, Axes { adc_bailout: Some(1.0 / 255.0), ..Axes::default() });
    }
}
