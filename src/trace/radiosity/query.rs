//! The diffuse light that arrives at a point: blended from samples around it, or gathered.

use super::super::path::Departure;
use super::super::tracer::Tracer;
use super::{Radiosity, Sample};
use crate::color::{Rgb, grey};
use crate::math::Vec3;

/// A question for the diffuse light at a surface.
#[derive(Clone, Copy)]
pub(in crate::trace) struct Query<'a> {
    pub departure: &'a Departure,
    /// Unit normal of the side in question; geometric, unless the scene wants bumps to count.
    pub normal: Vec3,
    /// The same, geometric in any case.
    pub facing: Vec3,
    /// At most this much of the answer reaches the picture.
    pub weight: f32,
}

/// Distances below are no distance at all.
const HERE: f64 = 1e-6;

/// Samples that lie lower than this in front of the point do not count.
const IN_FRONT: f64 = 0.05;

/// Weights up to this do not count.
const LEAST_WEIGHT: f64 = 0.001;

/// Weighted sum of samples.
#[derive(Clone, Copy, Default)]
struct Blend {
    weight: f64,
    color: Rgb,
}

impl Tracer<'_> {
    /// The diffuse light at a surface, or `None` at the recursion limit.
    pub(in crate::trace) fn diffuse_light(&mut self, query: &Query) -> Option<Rgb> {
        let radiosity = self.radiosity.as_mut()?;
        let depth = radiosity.depth;
        if depth >= radiosity.settings.recursion_limit {
            return None;
        }
        if radiosity.plain {
            let color = self.gather_plainly(query);
            return self.radiosity.as_ref().map(|r| r.finished(color));
        }
        let mut blend = radiosity.blended(query);
        let needed = radiosity.needed_weight(depth);
        if depth == 0 {
            radiosity.queries += 1;
            radiosity.weight += 4.0 * blend.weight;
        }
        let good_enough = !radiosity.pretrace && !radiosity.settings.always_sample && blend.weight > 0.0;
        if 4.0 * blend.weight < needed && !good_enough {
            let (color, quality) = self.gather(query);
            blend.color += quality * color;
            blend.weight += f64::from(quality);
        }
        let radiosity = self.radiosity.as_mut()?;
        radiosity.quality = radiosity.quality.min((4.0 * blend.weight / needed) as f32);
        let color = if blend.weight > 0.0 { blend.color / blend.weight as f32 } else { Rgb::ZERO };
        Some(radiosity.finished(color))
    }
}

impl Radiosity {
    /// An answer as the surface gets it.
    fn finished(&self, color: Rgb) -> Rgb {
        let g = self.settings.gray_threshold;
        (color * (1.0 - g) + Rgb::splat(g * grey(color))) * self.settings.brightness
    }

    fn needed_weight(&self, depth: u32) -> f64 {
        let most = match depth {
            0 => u32::MAX,
            1 => 2,
            _ => 1,
        };
        f64::from(self.settings.nearest_count.min(most))
    }

    fn blended(&self, query: &Query) -> Blend {
        let depth = self.depth;
        let dark = (0.25 - f64::from(query.weight)).max(0.0);
        let bound = (self.error_bound + dark) * f64::from(1u32 << depth);
        let smooth = !self.pretrace && depth == 0;
        let p = query.departure.point;
        let mut blend = Blend::default();
        let mut add = |sample: &Sample| {
            if let Some(z) = error(sample, p, query.normal, bound) {
                let weight = falloff(z.share, smooth) * z.front;
                if weight > LEAST_WEIGHT {
                    let weight = weight * f64::from(sample.quality);
                    blend.weight += weight;
                    blend.color += weight as f32 * sample.color;
                }
            }
        };
        self.lighting.cache.around(p, query.normal, depth, bound, &mut add);
        self.own.around(p, query.normal, depth, bound, &mut add);
        blend
    }
}

/// How a sample fits.
struct Fit {
    /// Its error as a share of the bound.
    share: f64,
    /// Factor for samples that lie in front of the surface.
    front: f64,
}

/// How well `sample` serves at `p`; `None` if it does not.
fn error(sample: &Sample, p: Vec3, normal: Vec3, bound: f64) -> Option<Fit> {
    let v = p - sample.point;
    let distance = v.length();
    let mut radius = f64::from(sample.radius);
    if distance >= radius * bound {
        return None;
    }
    let apart = distance > HERE;
    if apart {
        let c = sample.towards.dot(v) / distance;
        if c > 0.0 {
            radius = c * f64::from(sample.nearest) + (1.0 - c) * radius;
        }
        if distance >= radius * bound {
            return None;
        }
    }
    let error = distance / radius + 2.0 * (1.0 - normal.dot(sample.normal)).abs().sqrt();
    if error >= bound {
        return None;
    }
    let mut front = 1.0;
    if apart {
        let middle = normal + sample.normal;
        let length = middle.length();
        let height = (v / distance).dot(middle) / length;
        if !(height > -IN_FRONT) {
            return None;
        }
        if height <= 0.0 {
            front += height / IN_FRONT;
        }
    }
    Some(Fit { share: error / bound, front })
}

/// From 1 without error to 0 at the bound.
fn falloff(share: f64, smooth: bool) -> f64 {
    if !smooth {
        1.0 - share
    } else if share < 0.5 {
        1.0 - 2.0 * share * share
    } else {
        2.0 * (1.0 - share) * (1.0 - share)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample() -> Sample {
        Sample {
            depth: 0,
            point: Vec3::ZERO,
            normal: Vec3::Y,
            color: Rgb::ONE,
            quality: 1.0,
            radius: 2.0,
            nearest: 0.5,
            towards: Vec3::X,
            reach: 2.0,
        }
    }

    #[test]
    fn error_grows_with_distance_and_turn() {
        let at = |p: Vec3, n: Vec3| error(&sample(), p, n, 0.8).map(|f| f.share * 0.8);
        assert_eq!(at(Vec3::ZERO, Vec3::Y), Some(0.0));
        assert_eq!(at(-Vec3::X, Vec3::Y), Some(0.5));
        // Towards the nearest thing seen the radius shrinks to its distance.
        assert_eq!(at(0.25 * Vec3::X, Vec3::Y), Some(0.5));
        assert_eq!(at(0.5 * Vec3::X, Vec3::Y), None);
        assert_eq!(at(Vec3::ZERO, Vec3::X), None);
    }

    #[test]
    fn points_behind_a_sample_do_not_use_it() {
        let fit = |y: f64| error(&sample(), Vec3::new(-1.0, y, 0.0), Vec3::Y, 0.8);
        assert_eq!(fit(0.01).unwrap().front, 1.0);
        assert!(fit(-0.02).unwrap().front < 1.0);
        assert!(fit(-0.2).is_none());
    }

    #[test]
    fn falloffs_end_at_zero() {
        assert_eq!((falloff(0.0, true), falloff(0.5, true), falloff(1.0, true)), (1.0, 0.5, 0.0));
        assert_eq!((falloff(0.0, false), falloff(1.0, false)), (1.0, 0.0));
    }
}
