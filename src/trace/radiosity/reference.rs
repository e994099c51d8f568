//! Diffuse light between surfaces by plain Monte Carlo: no cache, no reuse, every direction drawn anew.
//!
//! Each query averages rays whose density is that of the cosine; after the first surface one ray goes on.
//! The mean over many pictures is the light transport that the scene asks for, up to its recursion limit,
//! with no other bias.

use super::super::tracer::Tracer;
use super::directions::Frame;
use super::query::Query;
use crate::color::Rgb;
use crate::math::Vec3;
use std::f64::consts::TAU;

/// Rays of a gather at what the camera sees.
const RAYS: u32 = 16;

impl Tracer<'_> {
    /// The light over the hemisphere of a query.
    pub(super) fn gather_plainly(&mut self, query: &Query) -> Rgb {
        let Some(radiosity) = &mut self.radiosity else { return Rgb::ZERO };
        let depth = radiosity.depth;
        let mut path = radiosity.ray_path(depth);
        // No ray is cut off for the weight that the cache's rules would give it.
        path.weight = 1.0;
        radiosity.depth = depth + 1;
        let level = self.max_level;
        self.max_level = level.max(path.level + 1);
        let (rays, frame) = (if depth == 0 { RAYS } else { 1 }, Frame::new(query.normal));
        let mut sum = Rgb::ZERO;
        let shift = (self.random.draw(), self.random.draw());
        for i in 0..rays {
            // A shifted Hammersley set.
            let across = (f64::from(i) / f64::from(rays) + shift.0).fract();
            let around = (f64::from(i.reverse_bits()) / 4_294_967_296.0 + shift.1).fract();
            let direction = frame.to_world(cosine_direction(across, around));
            if direction.dot(query.facing) > 0.0 {
                self.counters.gather_rays += 1;
                sum += self.trace(&query.departure.ray(direction), &mut path.clone()).rgb;
            }
        }
        self.max_level = level;
        if let Some(radiosity) = &mut self.radiosity {
            radiosity.depth = depth;
        }
        sum / rays as f32
    }
}

/// A direction around +y, by two uniform numbers; its density is that of the cosine.
fn cosine_direction(square: f64, turn: f64) -> Vec3 {
    let (sin, cos) = (TAU * turn).sin_cos();
    let r = square.sqrt();
    Vec3::new(r * cos, (1.0 - square).sqrt(), r * sin)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_dense_like_the_cosine() {
        let n = 400;
        let at = |i: usize| (i as f64 + 0.5) / f64::from(n);
        let mean = (0..n as usize)
            .flat_map(|i| (0..n as usize).map(move |j| cosine_direction(at(i), at(j))))
            .sum::<Vec3>()
            / f64::from(n * n);
        assert!((mean - 2.0 / 3.0 * Vec3::Y).length() < 1e-4, "{mean}");
    }
}
