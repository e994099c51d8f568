//! Photons by place: a balanced tree over an array, the middle of a range being its root.
//!
//! The search is that of the reference, not an exact nearest-n one. The limit begins to shrink only with
//! the photon after the last that there was room for, which always takes the place of the farthest. And the
//! reference's way of finding a median leaves ranges of two the wrong way round, so that about one photon
//! in a hundred on the rim of a search is missed; following it costs nothing, and keeps its pictures.
//!
//! Reference: H. W. Jensen, "Realistic Image Synthesis Using Photon Mapping", 2001, chapter 6.

use crate::light::PackedPhoton;
use crate::math::Vec3;

/// The tree. Knows nothing of how photons came about.
#[derive(Clone, Debug, Default)]
pub struct PhotonMap {
    photons: Vec<PackedPhoton>,
    /// What searches read of them.
    places: Vec<Place>,
}

/// Sixteen bytes of a photon: a search reads many and keeps few.
#[derive(Clone, Copy, Debug)]
#[repr(align(16))]
struct Place {
    point: glam::Vec3,
    axis: u32,
}

/// Photons around a point.
#[derive(Clone, Debug, Default)]
pub struct Nearby {
    /// Squared distance, and place in the map.
    pub members: Vec<(f64, u32)>,
    /// How far the search went in the end.
    pub radius: f64,
}

/// A range of the tree that is still to be searched.
#[derive(Clone, Copy)]
struct Part {
    first: u32,
    count: u32,
    /// Distance of the plane that parts it from the point, squared.
    beyond: f64,
}

/// Parts that wait in a search of the largest tree.
type Parts = smallvec::SmallVec<[Part; 32]>;

/// How far photons are from a point.
struct Metric {
    point: Vec3,
    /// 16 times the normal of a plane; photons off it count as farther away.
    normal: Vec3,
}

/// How much farther off-plane photons count.
const FLATTENING: f64 = 16.0;

impl Metric {
    fn square(&self, away: Vec3) -> f64 {
        away.length_squared() * (1.0 + self.normal.dot(away).abs())
    }
}

impl PhotonMap {
    /// Sorts photons, in order of storage, into a tree.
    pub fn new(mut photons: Vec<PackedPhoton>) -> Self {
        build(&mut photons);
        Self::from_sorted(photons)
    }

    /// Photons as a file kept them, in the order of the tree already.
    pub fn from_sorted(photons: Vec<PackedPhoton>) -> Self {
        let place = |p: &PackedPhoton| Place { point: p.place.into(), axis: u32::from(p.axis) };
        Self { places: photons.iter().map(place).collect(), photons }
    }

    pub fn photons(&self) -> &[PackedPhoton] {
        &self.photons
    }

    pub fn is_empty(&self) -> bool {
        self.photons.is_empty()
    }

    /// At most `most` photons within `radius` of `point`, into `found`.
    pub fn gather(&self, point: Vec3, radius: f64, most: usize, normal: Option<Vec3>, found: &mut Nearby) {
        found.members.clear();
        found.radius = radius;
        if most == 0 {
            return;
        }
        let metric = Metric { point, normal: FLATTENING * normal.unwrap_or(Vec3::ZERO) };
        let limit = self.search(&metric, radius * radius, most, &mut found.members);
        if let Some(limit) = limit {
            found.radius = limit.sqrt();
        }
    }

    /// Photons nearer than `limit` (squared), the near side of each plane first. If there are more than
    /// `most`, how far the farthest of those that are kept is.
    fn search(&self, m: &Metric, mut limit: f64, most: usize, found: &mut Vec<(f64, u32)>) -> Option<f64> {
        let mut full = false;
        let mut parts = Parts::new();
        parts.push(Part { first: 0, count: self.photons.len() as u32, beyond: 0.0 });
        while let Some(part) = parts.pop() {
            if part.count == 0 || part.beyond >= limit {
                continue;
            }
            let (away, beyond, middle) = self.split(m, part, limit, &mut parts);
            if beyond > limit {
                continue;
            }
            let square = m.square(away);
            if square >= limit {
                continue;
            }
            if found.len() < most {
                found.push((square, middle));
                continue;
            }
            if !full {
                (0..most / 2).rev().for_each(|i| sift_down(found, i));
                full = true;
            }
            found[0] = (square, middle);
            sift_down(found, 0);
            limit = found[0].0;
        }
        full.then_some(limit)
    }

    /// Takes a part asunder: its middle photon, and the sides of its plane, the near one to be taken first.
    #[inline]
    fn split(&self, m: &Metric, part: Part, limit: f64, parts: &mut Parts) -> (Vec3, f64, u32) {
        let half = (part.count - 1) / 2;
        let middle = part.first + half;
        let place = &self.places[middle as usize];
        let away = place.point.as_dvec3() - m.point;
        let along = away[place.axis as usize];
        let beyond = along * along;
        let low = Part { first: part.first, count: half, beyond: 0.0 };
        let high = Part { first: middle + 1, count: part.count - 1 - half, beyond: 0.0 };
        let (near, far) = if along > 0.0 { (low, high) } else { (high, low) };
        if beyond < limit {
            parts.push(Part { beyond, ..far });
        }
        parts.push(near);
        (away, beyond, middle)
    }
}

/// Restores the heap, the farthest first, below `i`.
fn sift_down(heap: &mut [(f64, u32)], mut i: usize) {
    let moved = heap[i];
    loop {
        let mut child = 2 * i + 1;
        if child >= heap.len() {
            break;
        }
        if child + 1 < heap.len() && heap[child + 1].0 > heap[child].0 {
            child += 1;
        }
        if heap[child].0 <= moved.0 {
            break;
        }
        heap[i] = heap[child];
        i = child;
    }
    heap[i] = moved;
}

/// Orders a range: along the axis of its largest extent, the median in the middle.
fn build(photons: &mut [PackedPhoton]) {
    let count = photons.len();
    if count < 2 {
        photons.iter_mut().for_each(|p| p.axis = 0);
        return;
    }
    let axis = widest(photons);
    let middle = (count - 1) / 2;
    // Two photons stay as they are.
    if count > 2 {
        partition(photons, middle, axis);
    }
    photons[middle].axis = axis as u8;
    let (low, high) = photons.split_at_mut(middle);
    build(low);
    build(&mut high[1..]);
}

/// Of equal extents the first axis counts.
fn widest(photons: &[PackedPhoton]) -> usize {
    let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    for p in photons {
        for a in 0..3 {
            low[a] = low[a].min(p.place[a]);
            high[a] = high[a].max(p.place[a]);
        }
    }
    let extent = [0, 1, 2].map(|a| high[a] - low[a]);
    (1..3).fold(0, |best, a| if extent[a] > extent[best] { a } else { best })
}

/// Quickselect with the median of three as pivot; which photon goes where is that of the reference, as
/// searches that overflow depend on it.
fn partition(p: &mut [PackedPhoton], middle: usize, axis: usize) {
    let (mut left, mut right) = (0, p.len() - 1);
    while left < right {
        p.swap((left + right) / 2, left + 1);
        let v = |p: &[PackedPhoton], i: usize| p[i].place[axis];
        if v(p, left + 1) > v(p, right) {
            p.swap(left + 1, right);
        }
        if v(p, left) > v(p, right) {
            p.swap(left, right);
        }
        if v(p, left + 1) > v(p, left) {
            p.swap(left + 1, left);
        }
        let pivot = v(p, left);
        let (mut j, mut k) = (left + 1, right);
        while j <= k {
            j += 1;
            while j <= right && v(p, j) < pivot {
                j += 1;
            }
            while k > left {
                k -= 1;
                if v(p, k) <= pivot {
                    break;
                }
            }
            if j < k {
                p.swap(j, k);
            }
        }
        p.swap(left, k);
        if middle < k && k > left {
            right = k - 1;
        } else if middle > k {
            left = k + 1;
        } else {
            return;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::Rgb;

    fn scattered(count: u32) -> Vec<PackedPhoton> {
        let place = |i: u32| {
            let f = f64::from(i);
            Vec3::new((f * 0.71).sin() * 5.0, (f * 0.37).cos(), (f * 1.93).sin() * 3.0)
        };
        (0..count).map(|i| PackedPhoton::new(place(i), Rgb::ONE, Vec3::Y)).collect()
    }

    #[test]
    fn nearly_all_within_the_radius_are_found() {
        let photons = scattered(700);
        let map = PhotonMap::new(photons.clone());
        assert_eq!(map.photons().len(), 700);
        let mut found = Nearby::default();
        for i in 0..40 {
            let p = Vec3::new(f64::from(i) * 0.2 - 4.0, 0.1, 0.5);
            map.gather(p, 0.8, 10_000, None, &mut found);
            let expected = photons.iter().filter(|q| (q.point() - p).length() < 0.8).count();
            let n = found.members.len();
            assert!(n <= expected && n + expected / 4 + 1 >= expected, "{n} of {expected}");
            assert_eq!(found.radius, 0.8);
        }
    }

    /// More than there is room for: the search shrinks to about the nearest ones.
    #[test]
    fn a_full_search_keeps_near_photons() {
        let map = PhotonMap::new(scattered(700));
        let mut found = Nearby::default();
        map.gather(Vec3::new(1.0, 0.2, 0.0), 5.0, 30, None, &mut found);
        assert_eq!(found.members.len(), 30);
        assert!(found.radius < 2.0 && found.members.iter().all(|m| m.0 <= found.radius.powi(2) * 1.000001));
    }

    /// The rule of the reference, photon by photon.
    #[test]
    fn a_full_search_is_that_of_the_reference() {
        let map = PhotonMap::new(scattered(3000));
        let mut found = Nearby::default();
        for i in 0..60 {
            let p = Vec3::new(f64::from(i) * 0.15 - 4.0, 0.1, 0.5);
            let normal = (i % 2 == 0).then_some(Vec3::Y);
            map.gather(p, 1.5, 40, normal, &mut found);
            let mut slow = Slow { p, normal, square: 2.25, radius: 1.5, kept: Vec::new() };
            slow.visit(&map.photons, 0);
            let sorted = |list: &[(f64, u32)]| {
                let mut places: Vec<u32> = list.iter().map(|m| m.1).collect();
                places.sort_unstable();
                places
            };
            assert_eq!(sorted(&found.members), sorted(&slow.kept));
            assert_eq!(found.radius, slow.radius);
        }
    }

    struct Slow {
        p: Vec3,
        normal: Option<Vec3>,
        square: f64,
        radius: f64,
        kept: Vec<(f64, u32)>,
    }

    impl Slow {
        fn visit(&mut self, range: &[PackedPhoton], first: u32) {
            if range.is_empty() {
                return;
            }
            let middle = (range.len() - 1) / 2;
            let away = range[middle].point() - self.p;
            let along = away[usize::from(range[middle].axis)];
            let d = away.length_squared() * (1.0 + self.normal.map_or(0.0, |n| (16.0 * n).dot(away).abs()));
            if along * along <= self.square && d < self.square {
                self.kept.push((d, first + middle as u32));
                if self.kept.len() > 40 {
                    let old = &self.kept[..40];
                    let far = (0..40).fold(0, |f, i| if old[i].0 > old[f].0 { i } else { f });
                    self.kept.swap_remove(far);
                    self.square = self.kept.iter().map(|m| m.0).fold(0.0, f64::max);
                    self.radius = self.square.sqrt();
                }
            }
            let (low, high) = (&range[..middle], &range[middle + 1..]);
            let after = first + middle as u32 + 1;
            if along > 0.0 {
                self.visit(low, first);
                if along < self.radius {
                    self.visit(high, after);
                }
            } else {
                self.visit(high, after);
                if -along < self.radius {
                    self.visit(low, first);
                }
            }
        }
    }

    #[test]
    fn photons_off_the_plane_count_as_farther() {
        let above = PackedPhoton::new(Vec3::new(0.0, 0.5, 0.0), Rgb::ONE, Vec3::Y);
        let beside = PackedPhoton::new(Vec3::new(0.5, 0.0, 0.0), Rgb::ONE, Vec3::Y);
        let map = PhotonMap::new(vec![above, beside]);
        let mut found = Nearby::default();
        map.gather(Vec3::ZERO, 1.0, 9, Some(Vec3::Y), &mut found);
        assert_eq!(found.members.len(), 1);
        assert_eq!(map.photons()[found.members[0].1 as usize].point(), beside.point());
    }
}
