//! Photons by place: a balanced tree over an array, the middle of a range being its root.
//!
//! The search is that of the reference, not an exact nearest-n one: the limit begins to shrink only with
//! the photon after the last that there was room for, which always takes the place of the farthest.
//!
//! Reference: H. W. Jensen, "Realistic Image Synthesis Using Photon Mapping", 2001, chapter 6.

use crate::light::PackedPhoton;
use crate::math::Vec3;

/// The tree. Knows nothing of how photons came about.
#[derive(Clone, Debug, Default)]
pub struct PhotonMap {
    photons: Vec<PackedPhoton>,
}

/// Photons around a point.
#[derive(Clone, Debug, Default)]
pub struct Nearby {
    /// Squared distance, and place in the map.
    pub members: Vec<(f64, u32)>,
    /// How far the search went in the end.
    pub radius: f64,
}

/// What one search asks for.
struct Search {
    point: Vec3,
    /// Photons off the plane across this normal count as farther away.
    normal: Option<Vec3>,
    most: usize,
    radius: f64,
    square: f64,
    /// Whether the members stand as a heap, the farthest first.
    full: bool,
}

/// How much farther off-plane photons count.
const FLATTENING: f64 = 16.0;

impl PhotonMap {
    /// Sorts photons, in order of storage, into a tree.
    pub fn new(mut photons: Vec<PackedPhoton>) -> Self {
        build(&mut photons);
        Self { photons }
    }

    /// Photons as a file kept them, in the order of the tree already.
    pub fn from_sorted(photons: Vec<PackedPhoton>) -> Self {
        Self { photons }
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
        let mut search = Search { point, normal, most, radius, square: radius * radius, full: false };
        if most > 0 {
            self.visit(&self.photons, 0, &mut search, &mut found.members);
        }
        found.radius = search.radius;
    }

    fn visit(&self, range: &[PackedPhoton], first: u32, search: &mut Search, found: &mut Vec<(f64, u32)>) {
        if range.is_empty() {
            return;
        }
        let middle = (range.len() - 1) / 2;
        let photon = &range[middle];
        let away = photon.point() - search.point;
        let along = away[usize::from(photon.axis)];
        search.consider(away, along, first + middle as u32, found);
        let (low, high) = (&range[..middle], &range[middle + 1..]);
        let after = first + middle as u32 + 1;
        if along > 0.0 {
            self.visit(low, first, search, found);
            if along < search.radius {
                self.visit(high, after, search, found);
            }
        } else {
            self.visit(high, after, search, found);
            if -along < search.radius {
                self.visit(low, first, search, found);
            }
        }
    }
}

impl Search {
    fn consider(&mut self, away: Vec3, along: f64, place: u32, found: &mut Vec<(f64, u32)>) {
        if along * along > self.square {
            return;
        }
        let mut square = away.length_squared();
        if let Some(normal) = self.normal {
            square *= 1.0 + FLATTENING * normal.dot(away).abs();
        }
        if square >= self.square {
            return;
        }
        if found.len() < self.most {
            found.push((square, place));
            return;
        }
        if !self.full {
            (0..found.len() / 2).rev().for_each(|i| sift_down(found, i));
            self.full = true;
        }
        found[0] = (square, place);
        sift_down(found, 0);
        self.square = found[0].0;
        self.radius = self.square.sqrt();
    }
}

/// Restores the heap below `i`.
fn sift_down(heap: &mut [(f64, u32)], mut i: usize) {
    loop {
        let mut child = 2 * i + 1;
        if child >= heap.len() {
            return;
        }
        if child + 1 < heap.len() && heap[child + 1].0 > heap[child].0 {
            child += 1;
        }
        if heap[child].0 <= heap[i].0 {
            return;
        }
        heap.swap(i, child);
        i = child;
    }
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
    fn all_within_the_radius_are_found() {
        let photons = scattered(700);
        let map = PhotonMap::new(photons.clone());
        assert_eq!(map.photons().len(), 700);
        let mut found = Nearby::default();
        for i in 0..40 {
            let p = Vec3::new(f64::from(i) * 0.2 - 4.0, 0.1, 0.5);
            map.gather(p, 0.8, 10_000, None, &mut found);
            let expected = photons.iter().filter(|q| (q.point() - p).length() < 0.8).count();
            assert_eq!((found.members.len(), found.radius), (expected, 0.8));
        }
    }

    /// More than there is room for: the search shrinks to about the nearest ones.
    #[test]
    fn a_full_search_keeps_near_photons() {
        let map = PhotonMap::new(scattered(700));
        let mut found = Nearby::default();
        map.gather(Vec3::new(1.0, 0.2, 0.0), 5.0, 30, None, &mut found);
        assert_eq!(found.members.len(), 30);
        assert!(found.radius < 2.0 && found.members.iter().all(|m| m.0 <= found.radius.powi(2)));
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
