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

use crate::math::{Ray, Vec3};

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpotBeam {
    pub radius: f64,
    pub falloff: f64,
    pub tightness: f64,
    /// Cosines of both angles, once worked out.
    cosines: Option<(f64, f64)>,
}

impl Default for SpotBeam {
    fn default() -> Self {
        Self { radius: 30f64.to_radians(), falloff: 45f64.to_radians(), tightness: 0.0, cosines: None }
    }
}

impl SpotBeam {
    /// The share of light at an angle with cosine `c` from the axis.
    pub fn factor(&self, c: f64) -> f64 {
        if c <= 0.0 {
            return 0.0;
        }
        let tight = match self.tightness {
            0.0 => 1.0,
            1.0 => c,
            tightness => c.powf(tightness),
        };
        let (inner, outer) = self.cosines.unwrap_or_else(|| self.work_out());
        if inner > 0.0 && c < inner { tight * smooth_step(outer, inner, c) } else { tight }
    }

    fn work_out(&self) -> (f64, f64) {
        (self.radius.cos(), self.falloff.cos())
    }

    /// The same beam, quicker to ask. Its angles are not to be changed any more.
    pub fn prepared(self) -> Self {
        Self { cosines: Some(self.work_out()), ..self }
    }
}

impl SpotBeam {
    /// The stretch of `ray` inside the falloff cone of a lamp at `apex`; `None` if it misses it.
    ///
    /// With v the origin from the apex, inside means `((v + s d).a)^2 > cos^2 |v + s d|^2` on the side
    /// that the unit vector `axis` (a) points to: a quadratic in s.
    pub fn section(&self, ray: &Ray, apex: Vec3, axis: Vec3) -> Option<(f64, f64)> {
        let c = self.falloff.cos();
        if c <= 0.0 {
            return Some((f64::NEG_INFINITY, f64::INFINITY));
        }
        let v = ray.origin - apex;
        let (va, da) = (v.dot(axis), ray.dir.dot(axis));
        let qa = da * da - c * c;
        let qb = va * da - c * c * v.dot(ray.dir);
        let qc = va * va - c * c * v.length_squared();
        let discriminant = qb * qb - qa * qc;
        if discriminant < 0.0 && qa < 0.0 {
            return None;
        }
        // One root each way without cancellation.
        let q = -(qb + discriminant.max(0.0).sqrt().copysign(qb));
        let (r1, r2) = (q / qa, if q == 0.0 { 0.0 } else { qc / q });
        let (low, high) = (r1.min(r2), r1.max(r2));
        if qa < 0.0 {
            return (va + 0.5 * (low + high) * da > 0.0).then_some((low, high));
        }
        // The line leaves through one sheet and comes in through the other.
        Some(if da > 0.0 { (high, f64::INFINITY) } else { (f64::NEG_INFINITY, low) })
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
    fn section_ends_lie_on_the_cone() {
        let beam = SpotBeam::default();
        let apex = Vec3::new(1.0, 5.0, -2.0);
        for (origin, dir) in [((-9.0, 1.0, 0.0), (1.0, 0.1, -0.1)), ((0.5, 9.0, -3.0), (0.1, -1.0, 0.2))] {
            let ray = Ray::new(Vec3::from(origin), Vec3::from(dir).normalize());
            let (a, b) = beam.section(&ray, apex, -Vec3::Y).unwrap();
            for s in [a, b].into_iter().filter(|s| s.is_finite()) {
                let cosine = -(ray.at(s) - apex).normalize().y;
                assert!((cosine - beam.falloff.cos()).abs() < 1e-9, "{s}: {cosine}");
            }
            let inside = ray.at(if b.is_finite() { 0.5 * (a + b) } else { a + 1.0 });
            assert!(-(inside - apex).normalize().y > beam.falloff.cos());
        }
        let above = Ray::new(Vec3::new(-9.0, 6.0, 0.0), Vec3::X);
        assert_eq!(beam.section(&above, apex, -Vec3::Y), None);
    }

    #[test]
    fn wide_radius_has_no_falloff() {
        let beam = SpotBeam {
            radius: 95f64.to_radians(),
            falloff: 100f64.to_radians(),
            tightness: 2.0,
            ..SpotBeam::default()
        };
        assert_eq!(beam.factor(0.25), 0.0625);
    }
}
