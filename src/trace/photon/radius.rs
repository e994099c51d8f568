//! How far to look for photons where the scene does not say: so far that on average as many as wanted are
//! found, and farther where the map is uneven.
//!
//! `R0 = sqrt(G / (pi rho))` for the mean density rho around random photons, `G` the photons wanted; then
//! `R0 (1 + 20 p)`, p being the share of random photons around which the density is much lower than rho.
//! In media the same with spheres. The random photons are drawn in order, and looked around by all threads.

use super::map::{Nearby, PhotonMap};
use rayon::prelude::*;
use std::collections::VecDeque;
use std::f64::consts::PI;

/// The largest search.
const EVERYWHERE: f64 = 1e7;

/// Densities between these shares of the mean make the radius grow.
const SPARSE: std::ops::Range<f64> = 0.05..0.7;
const GROWTH: f64 = 20.0;

/// Additive feedback generator of 31-bit numbers, with the seed 1.
///
/// Reference: the trinomial `x^31 + x^3 + 1`; D. Knuth, "The Art of Computer Programming", section 3.2.2.
#[derive(Debug)]
pub struct Feedback {
    last: VecDeque<u32>,
}

impl Feedback {
    const WARM_UP: usize = 310;

    pub fn new() -> Self {
        let mut first = vec![1u32];
        for i in 1..31 {
            first.push((16807 * u64::from(first[i - 1]) % 0x7fff_ffff) as u32);
        }
        for i in 31..34 {
            first.push(first[i - 31]);
        }
        let mut feedback = Self { last: first.split_off(3).into() };
        (0..Self::WARM_UP).for_each(|_| {
            feedback.draw();
        });
        feedback
    }

    pub fn draw(&mut self) -> u32 {
        let next = self.last[28].wrapping_add(self.last[0]);
        self.last.pop_front();
        self.last.push_back(next);
        next >> 1
    }
}

/// Photons per area (of surfaces) or per volume (in media).
fn density(found: &Nearby, in_media: bool) -> Option<f64> {
    let (n, r) = (found.members.len() as f64, found.radius);
    let size = if in_media { 4.0 / 3.0 * PI * r * r * r } else { PI * r * r };
    (r > 0.0).then(|| n / size)
}

/// The radius for `most` photons.
pub fn automatic(map: &PhotonMap, most: usize, in_media: bool, random: &mut Feedback) -> f64 {
    let count = map.photons().len();
    let trials = (count / 20).clamp(100, 1000);
    let mut densities_at = |radius: f64| -> Vec<Option<f64>> {
        let drawn: Vec<usize> = (0..trials).map(|_| random.draw() as usize % count).collect();
        let density_at = |found: &mut Nearby, &i: &usize| {
            map.gather(map.photons()[i].point(), radius, most, None, found);
            density(found, in_media)
        };
        drawn.par_iter().map_init(Nearby::default, density_at).collect()
    };
    let (mut sum, mut n) = (0.0, 0.0);
    for density in densities_at(EVERYWHERE) {
        sum += density.unwrap_or(if n > 0.0 { sum / n } else { 0.0 });
        n += 1.0;
    }
    let mean = sum / n;
    let ideal = if in_media {
        (3.0 * most as f64 / (4.0 * PI * mean)).powf(0.3333)
    } else {
        (most as f64 / (PI * mean)).sqrt()
    };
    let sparse = |d: &f64| (SPARSE.start * mean < *d) && (*d < SPARSE.end * mean);
    let few = densities_at(ideal).iter().flatten().filter(|d| sparse(d)).count();
    ideal * (1.0 + GROWTH * few as f64 / trials as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_generator_repeats_its_known_numbers() {
        let mut random = Feedback::new();
        assert_eq!([random.draw(), random.draw()], [1804289383, 846930886]);
    }
}
