//! Whether there are many photons around a point, without looking for the nearest.

use super::map::{Metric, Part, PhotonMap};

impl PhotonMap {
    /// Whether at least so many photons lie within `radius`.
    pub(super) fn has(&self, count: usize, metric: &Metric, radius: f64) -> bool {
        let square = radius * radius;
        let touches = !self.is_empty() && self.parts[0].distance(metric.point) < square;
        let found = if touches { self.count_in(0, metric, square, count) } else { 0 };
        !self.is_empty() && found >= count
    }

    /// Photons of a part less than a squared distance away, or some of them if that is enough; the part's box is no
    /// farther. Parts that lie inside as a whole count at once.
    fn count_in(&self, at: usize, metric: &Metric, square: f64, enough: usize) -> usize {
        let part = &self.parts[at];
        if part.farthest_square(metric) < square {
            return part.count as usize;
        }
        let is_inside = |&i: &usize| metric.square(self.away(i, metric.point)) < square;
        if part.upper == 0 {
            return (part.first as usize..(part.first + part.count) as usize).filter(is_inside).count();
        }
        let middle = (part.first + (part.count - 1) / 2) as usize;
        let mut count = usize::from(is_inside(&middle));
        let distance = |child: usize| (self.parts[child].distance(metric.point), child);
        let (low, high) = (distance(at + 1), distance(part.upper as usize));
        for (away, child) in if low.0 <= high.0 { [low, high] } else { [high, low] } {
            if count >= enough || away >= square {
                break;
            }
            count += self.count_in(child, metric, square, enough - count);
        }
        count
    }
}

impl Part {
    /// No photon of the part is farther away.
    fn farthest_square(&self, metric: &Metric) -> f64 {
        let (low, high) = (self.low.as_dvec3(), self.high.as_dvec3());
        let (center, half) = (0.5 * (low + high) - metric.point, 0.5 * (high - low));
        let height = metric.normal.dot(center).abs() + metric.normal.abs().dot(half);
        (center.abs() + half).length_squared() * (1.0 + height)
    }
}

#[cfg(test)]
mod tests {
    use super::super::map::tests::{on_a_plane, scattered};
    use super::*;
    use crate::math::Vec3;

    #[test]
    fn counts_are_those_of_all_photons() {
        for photons in [scattered(3000), on_a_plane(3000)] {
            let map = PhotonMap::new(photons);
            for i in 0..200 {
                let f = f64::from(i);
                let point = Vec3::new((f * 0.9).sin() * 5.0, 0.1 * (f * 1.7).cos(), (f * 2.3).sin() * 3.0);
                let metric = Metric::new(point, (i % 2 == 0).then_some(Vec3::Y));
                let radius = 0.01 * f;
                let inside =
                    |p: &&crate::light::PackedPhoton| metric.square(p.point() - point) < radius * radius;
                let n = map.photons().iter().filter(inside).count();
                assert!(
                    map.has(n, &metric, radius) && !map.has(n + 1, &metric, radius),
                    "{point} {radius} {n}"
                );
            }
        }
    }
}
