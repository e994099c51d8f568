//! The part of space that several half-spaces have in common.

use super::{Aabb, Vec3};

/// More half-spaces are not looked at: triples of them would take long.
const MOST: usize = 24;
/// Normals that lie this near to one plane do.
const FLAT: f64 = 1e-12;
/// Normals that lie nearer to one plane than this, but not in it, put corners where rounding has a say.
const NEARLY_FLAT: f64 = 1e-6;
/// Corners count as kept if they miss a half-space by this part of their size, and boxes are wider by it.
const SLACK: f64 = 1e-9;

/// A box around all points with `n · p <= d` for every (n, d), n being unit vectors; infinite if they reach to
/// infinity, or if it is not clear.
pub fn bounds(half_spaces: &[(Vec3, f64)]) -> Aabb {
    let count = half_spaces.len();
    if !(4..=MOST).contains(&count) || is_open(half_spaces) {
        return Aabb::INFINITE;
    }
    let mut found = Aabb::EMPTY;
    for i in 0..count {
        for j in i + 1..count {
            for k in j + 1..count {
                let [(a, p), (b, q), (c, r)] = [half_spaces[i], half_spaces[j], half_spaces[k]];
                let (bc, ca, ab) = (b.cross(c), c.cross(a), a.cross(b));
                let volume = a.dot(bc);
                if volume.abs() < FLAT {
                    continue;
                }
                if volume.abs() < NEARLY_FLAT {
                    return Aabb::INFINITE;
                }
                let corner = (p * bc + q * ca + r * ab) / volume;
                let size = corner.abs().max_element();
                if half_spaces.iter().all(|&(n, d)| n.dot(corner) <= d + SLACK * (size + d.abs())) {
                    found = found.extended(corner);
                }
            }
        }
    }
    if found.is_empty() || !found.is_finite() {
        return Aabb::INFINITE;
    }
    found.grown(SLACK * found.min.abs().max(found.max.abs()).max_element())
}

/// Whether one can go on for ever without leaving any of them: along an edge, if at all.
fn is_open(half_spaces: &[(Vec3, f64)]) -> bool {
    let mut edges = 0;
    for (i, &(a, _)) in half_spaces.iter().enumerate() {
        for &(b, _) in &half_spaces[i + 1..] {
            let Some(edge) = a.cross(b).try_normalize().filter(|_| a.cross(b).length() > NEARLY_FLAT) else {
                continue;
            };
            edges += 1;
            for way in [edge, -edge] {
                if half_spaces.iter().all(|(n, _)| n.dot(way) <= NEARLY_FLAT) {
                    return true;
                }
            }
        }
    }
    edges == 0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tetrahedron_has_its_corners_box() {
        let n = Vec3::ONE.normalize();
        let faces = [(Vec3::NEG_X, 0.0), (Vec3::NEG_Y, 0.0), (Vec3::NEG_Z, 0.0), (n, 2.0 / 3f64.sqrt())];
        let b = bounds(&faces);
        assert!(b.min.abs().max_element() < 1e-8 && (b.max - 2.0).abs().max_element() < 1e-8, "{b:?}");
    }

    #[test]
    fn a_slanted_block_far_away() {
        let at = Vec3::new(1e4, -2e3, 5.0);
        let axes = [Vec3::new(0.6, 0.8, 0.0), Vec3::new(-0.8, 0.6, 0.0), Vec3::Z];
        let faces: Vec<_> =
            axes.iter().flat_map(|&n| [(n, n.dot(at) + 1.0), (-n, 1.0 - n.dot(at))]).collect();
        let b = bounds(&faces);
        assert!((b.center() - at).length() < 1e-4 && (b.size().x - 2.8).abs() < 1e-4, "{b:?}");
    }

    #[test]
    fn what_is_open_has_no_box() {
        let tube = [(Vec3::X, 1.0), (Vec3::NEG_X, 1.0), (Vec3::Y, 1.0), (Vec3::NEG_Y, 1.0)];
        assert_eq!(bounds(&tube), Aabb::INFINITE);
        let cup = [(Vec3::X, 1.0), (Vec3::NEG_X, 1.0), (Vec3::Y, 1.0), (Vec3::NEG_Y, 1.0), (Vec3::Z, 1.0)];
        assert_eq!(bounds(&cup), Aabb::INFINITE);
        assert_eq!(
            bounds(&[(Vec3::X, 1.0), (Vec3::X, 2.0), (Vec3::X, 3.0), (Vec3::NEG_X, 1.0)]),
            Aabb::INFINITE
        );
    }
}
