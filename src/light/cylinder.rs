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
use crate::math::Vec3;

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
    fn tightness_is_a_power_of_the_distance_from_the_rim() {
        let beam = CylinderBeam { radius: 0.0, falloff: 4.0, tightness: 3.0 };
        assert_eq!(beam.factor(Vec3::new(2.0, 0.0, 5.0), Vec3::Z), 0.125);
    }
}
