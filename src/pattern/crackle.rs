//! Crackle: distances to the nearest of the random points that fill space, one in each unit cell.
//!
//! With `d1 <= d2 <= d3` the distances to the three nearest points, the value is `form . (d1, d2, d3)`, clamped
//! to 0..=1. Distances are `(Σ|δ|^metric + offset^metric) ^ (1/metric)`.
//!
//! | parameter | default | meaning |
//! |---|---|---|
//! | form | <-1, 1, 0> | weights of the three distances |
//! | metric | 2 | exponent; 1 gives octahedra, 2 spheres |
//! | offset | 0 | distance in a fourth dimension |
//! | solid | off | the value is the noise at the nearest point |
//!
//! Cells are visited nearest first, and left out once they lie beyond the third nearest point so far.
//!
//! Reference: S. Worley, "A Cellular Texture Basis Function", SIGGRAPH 1996.

use super::lattice_points::{NEAREST_FIRST, Neighbourhood, OFFSETS};
use super::{EDGE, Modifier, Pattern, Setting};
use crate::math::Vec3;
use crate::math::noise::noise;
use std::sync::Arc;

#[derive(Clone, Copy, Debug)]
pub struct Crackle {
    pub form: Vec3,
    pub metric: f64,
    pub offset: f64,
    pub solid: bool,
}

impl Default for Crackle {
    fn default() -> Self {
        Self { form: Vec3::new(-1.0, 1.0, 0.0), metric: 2.0, offset: 0.0, solid: false }
    }
}

impl Crackle {
    #[inline(always)]
    fn power(&self, d: f64) -> f64 {
        if self.metric == 2.0 {
            d * d
        } else if self.metric == 1.0 {
            d.abs()
        } else {
            d.abs().powf(self.metric)
        }
    }

    fn root(&self, s: f64) -> f64 {
        if self.metric == 2.0 {
            s.sqrt()
        } else if self.metric == 1.0 {
            s
        } else {
            s.powf(1.0 / self.metric)
        }
    }

    /// The three smallest power sums, and the nearest point.
    fn nearest(&self, p: Vec3) -> ([f64; 3], Vec3) {
        let corner = (p - Vec3::splat(EDGE)).floor();
        let cells = Neighbourhood::new(corner);
        let gaps = self.gaps(p - corner);
        let (mut s, mut at) = ([f64::INFINITY; 3], p);
        for &n in &NEAREST_FIRST {
            let offset = OFFSETS[usize::from(n)];
            let [gx, gy, gz] = offset.map(|o| (o + 2) as usize);
            if gaps[0][gx] + gaps[1][gy] + gaps[2][gz] >= s[2] {
                continue;
            }
            let point = cells.point(offset);
            let delta = point - p;
            let sum = self.power(delta.x) + self.power(delta.y) + self.power(delta.z);
            if sum < s[0] {
                s = [sum, s[0], s[1]];
                at = point;
            } else if sum < s[1] {
                s = [s[0], sum, s[1]];
            } else if sum < s[2] {
                s[2] = sum;
            }
        }
        (s, at)
    }

    /// For each axis and each cell offset along it, the least power of the distance to the cell; 0 where the
    /// metric does not grow with distance.
    fn gaps(&self, f: Vec3) -> [[f64; 5]; 3] {
        f.to_array().map(|f| {
            let gaps = [1.0 + f, f, 0.0, 1.0 - f, 2.0 - f];
            if self.metric > 0.0 { gaps.map(|g| self.power(g.max(0.0))) } else { [f64::NEG_INFINITY; 5] }
        })
    }
}

impl Pattern for Crackle {
    fn value(&self, p: Vec3, setting: &Setting) -> f64 {
        let (sums, nearest) = self.nearest(p);
        if self.solid {
            return noise(nearest, setting.noise);
        }
        let lift = if self.offset != 0.0 { self.offset.powf(self.metric) } else { 0.0 };
        let mut value = 0.0;
        for (weight, sum) in self.form.to_array().into_iter().zip(sums) {
            if weight != 0.0 {
                value += weight * self.root(sum + lift);
            }
        }
        value.clamp(0.0, 1.0)
    }

    fn modified(&self, modifier: Modifier) -> Option<Arc<dyn Pattern>> {
        let mut changed = *self;
        match modifier {
            Modifier::Form(form) => changed.form = form,
            Modifier::Metric(metric) => changed.metric = metric,
            Modifier::Offset(offset) => changed.offset = offset,
            Modifier::Solid(solid) => changed.solid = solid,
            _ => return None,
        }
        Some(Arc::new(changed))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn leaving_cells_out_changes_nothing() {
        for metric in [0.7, 1.0, 2.0, 3.0] {
            let crackle = Crackle { metric, ..Crackle::default() };
            for i in 0..300 {
                let t = f64::from(i);
                let p = Vec3::new((t * 0.37).sin() * 4.0, t * 0.013 - 2.0, (t * 0.73).cos() * 3.0);
                let cells = Neighbourhood::new((p - Vec3::splat(EDGE)).floor());
                let power = |o| (cells.point(o) - p).to_array().map(|d| crackle.power(d)).iter().sum::<f64>();
                let mut all: Vec<f64> = OFFSETS.iter().map(|&o| power(o)).collect();
                all.sort_by(f64::total_cmp);
                let (found, _) = crackle.nearest(p);
                assert!(found.iter().zip(&all).all(|(a, b)| (a - b).abs() < 1e-15), "{p} metric {metric}");
            }
        }
    }
}
