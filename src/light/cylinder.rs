//! A cylindrical beam: parallel sides, all rays along the axis.
//!
//! At distance `e` from the axis, with `u = 1 - e/falloff`: `u^tightness` times a smooth step that rises
//! from the falloff radius (0) to the radius (1). Nothing behind the lamp.
//!
//! | parameter | unit | default |
//! |---|---|---|
//! | radius | length | 0.75 |
//! | falloff | length | 1 |
//! | tightness | exponent | 0 |

use super::spot::smooth_step;
use crate::math::{Ray, Vec3};

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CylinderBeam {
    pub radius: f64,
    pub falloff: f64,
    pub tightness: f64,
}

impl Default for CylinderBeam {
    fn default() -> Self {
        Self { radius: 0.75, falloff: 1.0, tightness: 0.0 }
    }
}

impl CylinderBeam {
    /// The share of light at `from_lamp`, seen from the lamp, for the unit vector `axis`.
    pub fn factor(&self, from_lamp: Vec3, axis: Vec3) -> f64 {
        let along = from_lamp.dot(axis);
        if along <= 0.0 {
            return 0.0;
        }
        let e = (from_lamp - along * axis).length();
        if e >= self.falloff {
            return 0.0;
        }
        let u = 1.0 - e / self.falloff;
        let tight = if self.tightness == 0.0 { 1.0 } else { u.powf(self.tightness) };
        if self.radius > 0.0 && e > self.radius {
            tight * smooth_step(0.0, 1.0 - self.radius / self.falloff, u)
        } else {
            tight
        }
    }

    /// The stretch of `ray` inside the falloff cylinder; `None` if it misses it.
    pub fn section(&self, ray: &Ray, lamp: Vec3, axis: Vec3) -> Option<(f64, f64)> {
        let v = ray.origin - lamp;
        let across = |w: Vec3| w - w.dot(axis) * axis;
        let (v, d) = (across(v), across(ray.dir));
        let (qa, qb) = (d.length_squared(), v.dot(d));
        let qc = v.length_squared() - self.falloff * self.falloff;
        if qa == 0.0 {
            return (qc < 0.0).then_some((f64::NEG_INFINITY, f64::INFINITY));
        }
        let discriminant = qb * qb - qa * qc;
        if discriminant <= 0.0 {
            return None;
        }
        let q = -(qb + discriminant.sqrt().copysign(qb));
        let (r1, r2) = (q / qa, qc / q);
        Some((r1.min(r2), r1.max(r2)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn falls_off_with_distance_from_the_axis() {
        let beam = CylinderBeam { radius: 1.0, falloff: 2.0, tightness: 0.0 };
        assert_eq!(beam.factor(Vec3::new(0.9, 0.0, 5.0), Vec3::Z), 1.0);
        assert_eq!(beam.factor(Vec3::new(1.5, 0.0, 5.0), Vec3::Z), 0.5);
        assert_eq!(beam.factor(Vec3::new(0.0, 2.0, 5.0), Vec3::Z), 0.0);
        assert_eq!(beam.factor(Vec3::new(0.0, 0.0, -5.0), Vec3::Z), 0.0);
    }

    #[test]
    fn section_ends_lie_on_the_cylinder() {
        let beam = CylinderBeam { radius: 1.0, falloff: 2.0, tightness: 0.0 };
        let ray = Ray::new(Vec3::new(-9.0, 1.0, 4.0), Vec3::new(0.96, 0.0, 0.28));
        let (a, b) = beam.section(&ray, Vec3::ZERO, Vec3::Z).unwrap();
        for s in [a, b] {
            assert!((ray.at(s).truncate().length() - 2.0).abs() < 1e-12);
        }
        assert_eq!(beam.section(&ray, 4.0 * Vec3::Y, Vec3::Z), None);
    }

    #[test]
    fn tightness_is_a_power_of_the_distance_from_the_rim() {
        let beam = CylinderBeam { radius: 0.0, falloff: 4.0, tightness: 3.0 };
        assert_eq!(beam.factor(Vec3::new(2.0, 0.0, 5.0), Vec3::Z), 0.125);
    }
}
