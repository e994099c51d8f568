use super::wave_sources::sources;
use super::{Pattern, Setting};
use crate::math::Vec3;
use std::f64::consts::PI;

/// Rings around random points, each with a frequency of its own; low ones are higher.
#[derive(Clone, Copy, Debug)]
pub struct Waves;

impl Pattern for Waves {
    fn value(&self, p: Vec3, setting: &Setting) -> f64 {
        let all = sources(setting.context.waves);
        let mut sum = 0.0;
        for source in all {
            let d = (p - source.point).length();
            let d = if d == 0.0 { 1.0 } else { d };
            let f = source.frequency;
            sum += (2.0 * PI * (d * setting.frequency * f + setting.phase)).sin() / f;
        }
        0.2 * (2.5 + sum / all.len() as f64)
    }

    fn perturb(&self, n: Vec3, amount: f64, p: Vec3, setting: &Setting) -> Option<Vec3> {
        let all = sources(setting.context.waves);
        let mut sum = n;
        for source in all {
            let delta = p - source.point;
            let d = delta.length();
            let d = if d == 0.0 { 1.0 } else { d };
            let f = source.frequency;
            let height = (2.0 * PI * (d * setting.frequency * f + setting.phase)).sin();
            sum += delta * (amount * height / (f * d * all.len() as f64));
        }
        Some(sum)
    }
}
