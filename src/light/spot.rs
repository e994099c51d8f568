//! A spotlight's cone.
//!
//! With `c` the cosine between the axis and the ray from the lamp: `c^tightness` times a smooth step that
//! rises from the falloff angle (0) to the radius angle (1).
//!
//! | parameter | unit | default |
//! |---|---|---|
//! | radius | radians, half angle | 30 degrees |
//! | falloff | radians, half angle | 45 degrees |
//! | tightness | exponent | 0 |

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpotBeam {
    pub radius: f64,
    pub falloff: f64,
    pub tightness: f64,
}

impl Default for SpotBeam {
    fn default() -> Self {
        Self { radius: 30f64.to_radians(), falloff: 45f64.to_radians(), tightness: 0.0 }
    }
}

impl SpotBeam {
    /// The share of light at an angle with cosine `c` from the axis.
    pub fn factor(&self, c: f64) -> f64 {
        if c <= 0.0 {
            return 0.0;
        }
        let tight = if self.tightness == 0.0 { 1.0 } else { c.powf(self.tightness) };
        let inner = self.radius.cos();
        if inner > 0.0 && c < inner { tight * smooth_step(self.falloff.cos(), inner, c) } else { tight }
    }
}

/// 0 below `low`, 1 from `high` on, and a cubic with level ends between.
pub(super) fn smooth_step(low: f64, high: f64, x: f64) -> f64 {
    if x < low {
        0.0
    } else if x >= high {
        1.0
    } else {
        let u = (x - low) / (high - low);
        u * u * (3.0 - 2.0 * u)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn full_inside_radius_nothing_outside_falloff() {
        let beam = SpotBeam::default();
        assert_eq!(beam.factor(29f64.to_radians().cos()), 1.0);
        assert_eq!(beam.factor(46f64.to_radians().cos()), 0.0);
        let half = 0.5 * (30f64.to_radians().cos() + 45f64.to_radians().cos());
        assert!((beam.factor(half) - 0.5).abs() < 1e-12);
        assert_eq!(beam.factor(-1.0), 0.0);
    }

    #[test]
    fn wide_radius_has_no_falloff() {
        let beam = SpotBeam { radius: 95f64.to_radians(), falloff: 100f64.to_radians(), tightness: 2.0 };
        assert_eq!(beam.factor(0.25), 0.0625);
    }
}
