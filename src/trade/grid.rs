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
    RadiosityErrorBound,
    RadiosityRecursion,
    PretraceEnd,
    PhotonSpacing,
    PhotonGather,
    MediaSamples,
    MediaIntervals,
}

impl Axis {
    /// What decides about light between surfaces, photons and media: held against the truth.
    pub const LIGHT: [Axis; 8] = [
        Axis::RadiosityCount,
        Axis::RadiosityErrorBound,
        Axis::RadiosityRecursion,
        Axis::PretraceEnd,
        Axis::PhotonSpacing,
        Axis::PhotonGather,
        Axis::MediaSamples,
        Axis::MediaIntervals,
    ];
}

/// The scene's own radiosity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RadiosityAxes {
    pub count: Option<u32>,
    pub error_bound: Option<f64>,
    pub recursion: Option<u32>,
    pub pretrace_end: Option<f64>,
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
    /// The scene's own settings of light between surfaces.
    pub radiosity: Option<RadiosityAxes>,
    /// Whether the spacing of photons is varied.
    pub photon_spacing: bool,
    /// The most photons of a search.
    pub photon_gather: Option<u32>,
    /// Samples of the medium with most of them.
    pub media_samples: Option<u32>,
    /// Intervals of the medium with most of them.
    pub media_intervals: Option<u32>,
}

impl Axes {
    /// Only what was asked for.
    pub fn only(&self, wanted: &[Axis]) -> Axes {
        let has = |axis| wanted.contains(&axis);
        Axes {
            trace_level: self.trace_level.filter(|_| has(Axis::TraceLevel)),
            adc_bailout: self.adc_bailout.filter(|_| has(Axis::AdcBailout)),
            lamps: self.lamps.filter(|_| has(Axis::AreaSamples)),
            radiosity: self.radiosity.map(|r| RadiosityAxes {
                count: r.count.filter(|_| has(Axis::RadiosityCount)),
                error_bound: r.error_bound.filter(|_| has(Axis::RadiosityErrorBound)),
                recursion: r.recursion.filter(|_| has(Axis::RadiosityRecursion)),
                pretrace_end: r.pretrace_end.filter(|_| has(Axis::PretraceEnd)),
            }),
            photon_spacing: self.photon_spacing && has(Axis::PhotonSpacing),
            photon_gather: self.photon_gather.filter(|_| has(Axis::PhotonGather)),
            media_samples: self.media_samples.filter(|_| has(Axis::MediaSamples)),
            media_intervals: self.media_intervals.filter(|_| has(Axis::MediaIntervals)),
        }
    }

    /// Whether something is to be held against light found by plain Monte Carlo.
    pub fn needs_truth(&self) -> bool {
        !self.light().is_empty()
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
        all
    }

    /// Settings of light, cheaper and dearer than the scene's own, one at a time.
    fn light(&self) -> Vec<Overrides> {
        let none = Overrides::default();
        let mut all = Vec::new();
        let times = |own: u32| FACTORS.map(|f| ((f64::from(own) * f) as u32).max(1));
        if let Some(r) = &self.radiosity {
            let counts = r.count.into_iter().flat_map(times).map(|n| n.min(MOST_GATHERED));
            all.extend(counts.map(|n| Overrides { radiosity_count: Some(n), ..none }));
            let bounds = r.error_bound.into_iter().flat_map(|own| FACTORS.map(|f| own * f));
            all.extend(bounds.map(|x| Overrides { radiosity_error_bound: Some(x), ..none }));
            let limits = r.recursion.into_iter().flat_map(|own| 1..own);
            all.extend(limits.map(|n| Overrides { radiosity_recursion: Some(n), ..none }));
            let ends = r.pretrace_end.into_iter().flat_map(|own| FACTORS.map(|f| (own * f).min(1.0)));
            all.extend(ends.map(|x| Overrides { pretrace_end: Some(x), ..none }));
        }
        if self.photon_spacing {
            all.extend(FACTORS.map(|f| Overrides { photon_spacing: Some(f), ..none }));
        }
        let gathers = self.photon_gather.into_iter().flat_map(times);
        all.extend(gathers.map(|n| Overrides { photon_gather: Some(n), ..none }));
        let samples = MEDIA.iter().filter(|&&n| self.media_samples.is_some_and(|own| n < own));
        all.extend(samples.map(|&n| Overrides { media_samples: Some(n), ..none }));
        let intervals =
            self.media_intervals.into_iter().flat_map(|own| [2, 4].map(|f| own.saturating_mul(f)));
        all.extend(intervals.map(|n| Overrides { media_intervals: Some(n), ..none }));
        all
    }
}

const ERRORS: [f64; 5] = [0.04, 0.02, 0.01, 0.005, 0.0025];
const GRID: [(f32, u32); 6] = [(0.3, 2), (0.3, 3), (0.3, 5), (0.1, 3), (0.1, 5), (0.03, 4)];
const RECURSIVE: [(f32, u32); 6] = [(0.3, 2), (0.3, 3), (0.1, 3), (0.3, 4), (0.1, 4), (0.03, 4)];
const TRACE_LEVELS: [u32; 5] = [1, 2, 3, 5, 10];
const BAILOUTS: [f32; 3] = [0.01, 0.03, 0.1];
const LAMPS: [u32; 4] = [1, 4, 9, 25];
/// Times the scene's own.
const FACTORS: [f64; 4] = [0.25, 0.5, 2.0, 4.0];
/// Directions that radiosity has.
const MOST_GATHERED: u32 = 1600;
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
    let fine = adaptive(ERRORS[3]);
    all.extend(axes.light().into_iter().map(|overrides| Knobs { overrides, ..fine }));
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

    /// More is tried than the scene asks for, too, and all of it against the truth.
    #[test]
    fn settings_of_light_go_both_ways() {
        let radiosity =
            RadiosityAxes { count: Some(35), error_bound: Some(1.8), recursion: Some(3), pretrace_end: None };
        let axes = Axes { radiosity: Some(radiosity), photon_spacing: true, ..Axes::default() };
        let all = grid(&axes, false);
        let counts: Vec<u32> = all.iter().filter_map(|k| k.overrides.radiosity_count).collect();
        assert_eq!(counts, [8, 17, 70, 140]);
        let limits: Vec<u32> = all.iter().filter_map(|k| k.overrides.radiosity_recursion).collect();
        assert_eq!(limits, [1, 2]);
        assert_eq!(all.iter().filter(|k| k.overrides.photon_spacing.is_some()).count(), 4);
        assert!(axes.needs_truth() && !axes.only(&[Axis::Sampling]).needs_truth());
    }

    #[test]
    fn only_cheaper_values_than_the_scenes_own_are_tried() {
        let axes = Axes {
            trace_level: Some(5),
            adc_bailout: Some(1.0 / 255.0),
            lamps: Some(9),
            media_samples: Some(4),
            ..Axes::default()
        };
        let all = grid(&axes, false);
        let levels: Vec<u32> = all.iter().filter_map(|k| k.overrides.max_trace_level).collect();
        assert_eq!(levels, [1, 2, 3, 1, 2, 3, 1, 2, 3]);
        assert_eq!(all.iter().filter(|k| k.overrides.adc_bailout.is_some()).count(), 9);
        assert_eq!(all.iter().filter_map(|k| k.overrides.area_samples).max(), Some(4));
        assert_eq!(all.iter().filter_map(|k| k.overrides.media_samples).collect::<Vec<_>>(), [1, 2]);
        assert!(all.iter().all(|k| k.overrides.radiosity_count.is_none()));
        let only = axes.only(&[Axis::AdcBailout]);
        assert_eq!(only, Axes { adc_bailout: Some(1.0 / 255.0), ..Axes::default() });
    }
}
