use super::warp::Warp;
use crate::math::{Transform, Vec3};
use glam::DAffine3;

/// The transformations and warps of a pattern.
///
/// The item written last acts first on the point, and later transformations of whatever encloses the pattern
/// act before those.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chain {
    /// In the order written.
    warps: Vec<Warp>,
}

impl Chain {
    pub fn is_empty(&self) -> bool {
        self.warps.is_empty()
    }

    /// Adds a transformation; it merges with one written just before it.
    pub fn transform(&mut self, t: &Transform) {
        if let Some(Warp::Transform(last)) = self.warps.last_mut() {
            *last = last.then(t);
        } else if !t.is_identity() {
            self.warps.push(Warp::Transform(*t));
        }
    }

    pub fn warp(&mut self, warp: Warp) {
        self.warps.push(warp);
    }

    /// A point outside to the pattern's own space.
    #[inline]
    pub fn apply(&self, p: Vec3) -> Vec3 {
        match &self.warps[..] {
            [] => p,
            [Warp::Transform(t)] => t.inverse_point(p),
            warps => warps.iter().rev().fold(p, |p, warp| warp.apply(p)),
        }
    }

    /// The chain as one transformation without its turbulence, and how far that mostly moves a place at the end:
    /// `None` if there are other warps.
    pub fn calmed(&self) -> Option<(DAffine3, f64)> {
        let (mut inward, mut shift) = (DAffine3::IDENTITY, 0.0);
        for warp in self.warps.iter().rev() {
            match warp {
                Warp::Transform(t) => {
                    inward = t.inverse * inward;
                    // The mean stretch of directions.
                    shift *=
                        (t.inverse.matrix3.to_cols_array().iter().map(|c| c * c).sum::<f64>() / 3.0).sqrt();
                }
                Warp::Turbulence(turbulence) => shift = f64::hypot(shift, turbulence.shift()),
                _ => return None,
            }
        }
        Some((inward, shift))
    }

    /// A surface normal outside to the pattern's own space; only plain transformations act. Not normalised.
    #[inline]
    pub fn inward_normal(&self, n: Vec3) -> Vec3 {
        self.warps.iter().rev().fold(n, |n, warp| match warp {
            Warp::Transform(t) => t.inverse_normal(n),
            _ => n,
        })
    }

    /// Undoes [`Chain::inward_normal`].
    #[inline]
    pub fn outward_normal(&self, n: Vec3) -> Vec3 {
        self.warps.iter().fold(n, |n, warp| match warp {
            Warp::Transform(t) => t.normal(n),
            _ => n,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_item_acts_first() {
        let mut chain = Chain::default();
        chain.transform(&Transform::scale(Vec3::splat(2.0)));
        chain.transform(&Transform::translate(Vec3::X));
        // Points move from the pattern outward by scaling, then translating.
        assert_eq!(chain.apply(Vec3::new(5.0, 0.0, 0.0)), Vec3::new(2.0, 0.0, 0.0));
        assert_eq!(chain.warps.len(), 1, "transformations merge");
    }

    #[test]
    fn normals_go_in_and_out_again() {
        let mut chain = Chain::default();
        chain.transform(&Transform::scale(Vec3::new(1.0, 2.0, 3.0)));
        chain.warp(Warp::Planar(crate::pattern::warp::Planar::new(Vec3::Z, 0.0)));
        chain.transform(&Transform::rotate(Vec3::new(10.0, 20.0, 30.0)));
        let n = Vec3::new(0.3, -0.5, 0.8);
        assert!((chain.outward_normal(chain.inward_normal(n)) - n).length() < 1e-15);
        assert_eq!(chain.warps.len(), 3);
    }
}
