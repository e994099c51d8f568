//! All rays from one place between four directions.

use super::Vec3;

/// A cone with four flat sides, whole to infinity: everything that is seen through a part of the picture.
#[derive(Clone, Copy, Debug)]
pub struct Beam {
    pub apex: Vec3,
    /// Where the sides meet, in order.
    edges: [Vec3; 4],
    /// Of the sides, inward, of unit length.
    pub normals: [Vec3; 4],
}

/// Neighbouring edges that are nearer to each other than this angle have no plane between them that could be
/// told well.
const LEAST_ANGLE: f64 = 1e-6;
/// Bound on the rounding of an edge's distance from a plane, relative to its length.
const ROUNDING: f64 = 1e-9;

impl Beam {
    /// `edges` in order around the beam. `None` unless it is convex and neither flat nor too narrow.
    pub fn new(apex: Vec3, edges: [Vec3; 4]) -> Option<Beam> {
        let middle: Vec3 = edges.iter().map(|e| e.normalize_or_zero()).sum();
        let mut normals = [Vec3::ZERO; 4];
        for (i, normal) in normals.iter_mut().enumerate() {
            let (a, b) = (edges[i], edges[(i + 1) % 4]);
            let across = a.cross(b);
            let length = across.length();
            if !(length > LEAST_ANGLE * a.length() * b.length()) {
                return None;
            }
            *normal = across * (1.0 / length).copysign(across.dot(middle));
            let inward = |e: &Vec3| normal.dot(*e) >= -ROUNDING * e.length();
            if !(normal.dot(middle) > LEAST_ANGLE * middle.length() && edges.iter().all(inward)) {
                return None;
            }
        }
        Some(Beam { apex, edges, normals })
    }

    /// The beam in another space, where its apex is `apex` and a direction what `direction` makes of it.
    pub fn mapped(&self, apex: Vec3, direction: impl Fn(Vec3) -> Vec3) -> Option<Beam> {
        Beam::new(apex, self.edges.map(direction))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::strategy::vector;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]
        /// Directions between the edges are on the inner side of every plane.
        #[test]
        fn holds_what_is_between_its_edges(
            forward in vector(1.0), right in vector(1.0), up in vector(1.0), s in 0.0..1.0f64, t in 0.0..1.0f64,
            size in -5.0..1.0f64,
        ) {
            let size = 10f64.powf(size);
            let at = |s: f64, t: f64| forward + size * (s * right + t * up);
            let edges = [at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)];
            if let Some(beam) = Beam::new(Vec3::ZERO, edges) {
                for n in beam.normals {
                    prop_assert!(n.dot(at(s, t)) >= -1e-9 * at(s, t).length());
                    prop_assert!((n.length() - 1.0).abs() < 1e-12);
                }
            }
        }
    }

    #[test]
    fn what_is_no_beam_is_refused() {
        let edge = |x: f64, y: f64| Vec3::new(x, y, 1.0);
        let square = [edge(-1.0, -1.0), edge(1.0, -1.0), edge(1.0, 1.0), edge(-1.0, 1.0)];
        assert!(Beam::new(Vec3::ZERO, square).is_some());
        let crossed = [square[0], square[2], square[1], square[3]];
        assert!(Beam::new(Vec3::ZERO, crossed).is_none());
        assert!(Beam::new(Vec3::ZERO, [Vec3::Z; 4]).is_none());
        assert!(Beam::new(Vec3::ZERO, [square[0], square[1], -square[0], -square[1]]).is_none());
        assert!(Beam::new(Vec3::ZERO, [Vec3::NAN; 4]).is_none());
    }
}
