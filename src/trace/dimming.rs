//! The optical depth of uneven media on a shadow ray.
//!
//! The places that a shadow ray samples, and their weights, do not hang on what is found there. What media leave is
//! a product of one factor for each, in any order: even media come first, then the places that weigh most, as it is
//! decided on the way whether so little light is left that it does not matter.

use super::media::Stretch;
use super::media_sampling::{Plan, is_opaque};
use super::tracer::Tracer;
use crate::color::Rgb;
use smallvec::SmallVec;

/// Media whose density is not the same everywhere: a place in `Tracer::media`, and extinction times length.
type Uneven = SmallVec<[(u32, Rgb); 4]>;

/// The samples of one interval.
#[derive(Clone, Copy, Debug)]
struct Places {
    method: u32,
    /// Steps of method 3, samples of the others.
    count: u32,
    jitter: f64,
}

impl Places {
    fn new(plan: &Plan) -> Self {
        let count = if plan.method == 3 { (plan.samples.0 / 2 + 1).max(2) } else { plan.samples.0 };
        Self { method: plan.method, count, jitter: plan.jitter }
    }

    /// How many places there are.
    fn len(&self) -> u32 {
        if self.method == 3 { 2 * self.count + 1 } else { self.count }
    }

    /// So many come first: where the ray starts, which is mostly known already, and those that weigh most.
    fn first(&self) -> u32 {
        self.count
    }

    /// Place `i` as a fraction of the interval, how far it is shaken, and its weight.
    fn place(&self, i: u32) -> (f64, f64, f32) {
        let n = f64::from(self.count);
        let at = f64::from(i);
        match self.method {
            1 => (0.5, 1.0, 1.0 / n as f32),
            3 => {
                // Steps of which the last is left out; each the mean of its ends and its middle.
                let step = 1.0 / (n + 1.0);
                let share = if 0 < i && i < self.count { 2.0 } else { 1.0 };
                let at = if i > self.count { at - n - 0.5 } else { at };
                (at * step, step * self.jitter, share / (3.0 * n as f32))
            }
            _ => ((at + 0.5 + 0.5 * self.jitter) / n, self.jitter / n, 1.0 / n as f32),
        }
    }
}

/// The media's optical depth along the stretch of a shadow ray.
pub(super) fn depth(tracer: &mut Tracer, stretch: &Stretch, plan: &Plan) -> Rgb {
    let (mut depth, mut uneven) = (Rgb::ZERO, Uneven::new());
    for &m in &stretch.media {
        let medium = &tracer.media[m as usize];
        let whole = medium.extinction() * stretch.length as f32;
        match medium.uniform() {
            Some(density) => depth += whole * density,
            None => uneven.push((m, whole)),
        }
    }
    let intervals = if plan.has_density { plan.intervals } else { 1 };
    let places = Places::new(plan);
    for part in [0..places.first(), places.first()..places.len()] {
        for interval in 0..intervals {
            if is_opaque(depth) || !tracer.goes_on(stretch, depth) {
                return depth;
            }
            for i in part.clone() {
                let (mut d, width, weight) = places.place(i);
                if width != 0.0 {
                    d += width * (tracer.random.draw() - 0.5);
                }
                let share = weight / intervals as f32;
                let s = (f64::from(interval) + d) * stretch.length / f64::from(intervals);
                let p = stretch.ray.at(s);
                for &(m, whole) in &uneven {
                    depth += share * whole * tracer.density(stretch, m, p);
                }
            }
        }
    }
    depth
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The places of every method stand for the whole interval.
    #[test]
    fn weights_add_up_to_one() {
        for method in [1, 2, 3] {
            for count in 2..9 {
                let places = Places { method, count, jitter: 0.0 };
                let all = || (0..places.len()).map(|i| places.place(i));
                assert!((all().map(|p| p.2).sum::<f32>() - 1.0).abs() < 1e-5, "{method} {count}");
                let lightest = all().take(places.first() as usize).skip(1).map(|p| p.2).fold(9.0, f32::min);
                assert!(all().all(|p| p.2 <= lightest && (0.0..1.0).contains(&p.0)));
            }
        }
    }

    /// Method 3: the trapezium's ends, and a middle for each step.
    #[test]
    fn places_of_method_three() {
        let places = Places { method: 3, count: 3, jitter: 0.0 };
        let mut all: Vec<(f64, f32)> =
            (0..7).map(|i| places.place(i)).map(|(d, _, w)| (8.0 * d, 9.0 * w)).collect();
        all.sort_by(|a, b| a.0.total_cmp(&b.0));
        let wanted = [(0.0, 1.0), (1.0, 1.0), (2.0, 2.0), (3.0, 1.0), (4.0, 2.0), (5.0, 1.0), (6.0, 1.0)];
        for (found, wanted) in all.iter().zip(wanted) {
            assert!((found.0 - wanted.0).abs() < 1e-12 && (found.1 - wanted.1).abs() < 1e-5, "{all:?}");
        }
    }
}
