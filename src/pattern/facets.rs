//! Facets: normals only. A normal becomes the direction of the nearest of the random points that fill space.
//!
//! | parameter | default | meaning |
//! |---|---|---|
//! | size | 0.1 | of the facets |
//! | coords | 0 | 0: facets of the normal's direction; else of the place, tilted by this much |
//! | metric | 2 | which point is nearest; 1 compares signed sums, as the language defines it |

use super::lattice_points::{GROUPS, Neighbourhood};
use super::{EDGE, Modifier, Pattern, Setting};
use crate::math::noise::vector_noise;
use crate::math::{Vec3, floor_of};
use std::sync::Arc;

#[derive(Clone, Copy, Debug)]
pub struct Facets {
    pub size: f64,
    pub coords: f64,
    pub metric: f64,
}

impl Default for Facets {
    fn default() -> Self {
        Self { size: 0.1, coords: 0.0, metric: 2.0 }
    }
}

impl Facets {
    fn distance(&self, delta: Vec3) -> f64 {
        if self.metric == 2.0 {
            delta.length_squared()
        } else if self.metric == 1.0 {
            delta.element_sum()
        } else {
            let power = |d: f64| d.abs().powf(self.metric);
            power(delta.x) + power(delta.y) + power(delta.z)
        }
    }

    fn nearest(&self, b: Vec3) -> Vec3 {
        let (mut least, mut at) = (f64::INFINITY, b);
        Neighbourhood::around(floor_of(b - Vec3::splat(EDGE)), |cells| {
            for group in 0..GROUPS {
                if group > 0 && self.metric == 2.0 && cells.gap(group, b).powi(2) >= least {
                    continue;
                }
                let places = cells.group(group);
                for [x, y, z] in cells.fours(places) {
                    for i in 0..4 {
                        let point = Vec3::new(x[i], y[i], z[i]);
                        let distance = self.distance(point - b);
                        // Empty places are infinitely far, which is near where powers fall with distance.
                        if distance < least && point.x < f64::INFINITY {
                            (least, at) = (distance, point);
                        }
                    }
                }
            }
        });
        at
    }
}

impl Pattern for Facets {
    fn value(&self, _p: Vec3, _setting: &Setting) -> f64 {
        0.0
    }

    fn is_for_normals_only(&self) -> bool {
        true
    }

    fn perturb(&self, n: Vec3, _amount: f64, p: Vec3, _setting: &Setting) -> Option<Vec3> {
        let n = n.normalize_or_zero();
        let base = if self.coords != 0.0 { p } else { n };
        let scale = if self.size < 1e-6 { 1e6 } else { 1.0 / self.size };
        let nearest = self.nearest(base * scale);
        if self.coords == 0.0 {
            return Some(nearest);
        }
        let d = vector_noise(nearest);
        Some(n + self.coords * (d - d.dot(n) * n))
    }

    fn modified(&self, modifier: Modifier) -> Option<Arc<dyn Pattern>> {
        let mut changed = *self;
        match modifier {
            Modifier::Size(size) => changed.size = size,
            Modifier::Coords(coords) => changed.coords = coords,
            Modifier::Metric(metric) => changed.metric = metric,
            _ => return None,
        }
        Some(Arc::new(changed))
    }
}
