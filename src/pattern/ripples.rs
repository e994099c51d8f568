use super::wave_sources::sources;
use super::{Pattern, Setting};
use crate::math::Vec3;
use std::f64::consts::PI;

/// Rings of one frequency around random points.
#[derive(Clone, Copy, Debug)]
pub struct Ripples;

impl Pattern for Ripples {
    fn value(&self, p: Vec3, setting: &Setting) -> f64 {
        let all = sources(setting.context.waves);
        let mut sum = 0.0;
        for source in all {
            let d = (p - source.point).length();
            let d = if d == 0.0 { 1.0 } else { d };
            sum += (2.0 * PI * (d * setting.frequency + setting.phase)).sin();
        }
        0.5 * (1.0 + sum / all.len() as f64)
    }

    fn perturb(&self, n: Vec3, amount: f64, p: Vec3, setting: &Setting) -> Option<Vec3> {
        let all = sources(setting.context.waves);
        let mut sum = n;
        for source in all {
            let delta = p - source.point;
            let d = delta.length();
            let d = if d == 0.0 { 1.0 } else { d };
            let height = (2.0 * PI * (d * setting.frequency + setting.phase)).sin();
            sum += delta * (amount * height / (d * all.len() as f64));
        }
        Some(sum)
    }
}
