//! Photons by place: a balanced tree over an array, the middle of a range being its root.
//!
//! The search is that of the reference, not an exact nearest-n one. The limit begins to shrink only with
//! the photon after the last that there was room for, which always takes the place of the farthest. And the
//! reference's way of finding a median leaves ranges of two the wrong way round, so that about one photon
//! in a hundred on the rim of a search is missed; following it costs nothing, and keeps its pictures.
//!
//! Reference: H. W. Jensen, "Realistic Image Synthesis Using Photon Mapping", 2001, chapter 6.

use super::order::ordered;
use crate::light::PackedPhoton;
use crate::math::Vec3;

/// The tree. Knows nothing of how photons came about.
#[derive(Clone, Debug, Default)]
pub struct PhotonMap {
    photons: Vec<PackedPhoton>,
    /// Coordinates once more, by axis: a search reads many and keeps few.
    places: [Vec<f32>; 3],
    /// In small parts: which photon's plane, counted from 1, this one stands on the wrong side of.
    astray: Vec<u8>,
    /// Ranges of the tree, each before those below it, the lower one first.
    parts: Vec<Part>,
}

/// A range of the tree and the box around its photons.
#[derive(Clone, Copy, Debug)]
struct Part {
    low: glam::Vec3,
    high: glam::Vec3,
    first: u32,
    count: u32,
    /// The part of the upper half; 0 where photons are looked at one by one.
    upper: u32,
    /// What the middle photon's plane lies across.
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

/// Ranges up to this many photons are looked at one by one.
const LEAF: usize = 12;

/// The limit does not shrink by more while a small part is looked at, or hardly ever.
const SURELY: f64 = 0.5;

/// Stands on the wrong side of several planes.
const OFTEN: u8 = u8::MAX;

/// More halvings than any tree has.
const DEEPEST: usize = 32;

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

/// A search on its way.
struct Search<'a> {
    map: &'a PhotonMap,
    metric: Metric,
    /// Squared distance of the farthest photon that still counts.
    limit: f64,
    most: usize,
    /// There were more than `most`.
    full: bool,
    found: &'a mut Vec<(f64, u32)>,
}

impl PhotonMap {
    /// Sorts photons, in order of storage, into a tree.
    pub fn new(mut photons: Vec<PackedPhoton>) -> Self {
        ordered(&mut photons);
        Self::from_sorted(photons)
    }

    /// Photons as a file kept them, in the order of the tree already.
    pub fn from_sorted(photons: Vec<PackedPhoton>) -> Self {
        let places = [0, 1, 2].map(|axis| photons.iter().map(|p| p.place[axis]).collect());
        let (mut parts, mut astray) = (Vec::new(), vec![0; photons.len()]);
        part(&photons, 0, &mut parts);
        for leaf in parts.iter().filter(|p| p.upper == 0) {
            let range = leaf.first as usize..(leaf.first + leaf.count) as usize;
            find_astray(&photons[range.clone()], 0, &mut astray[range]);
        }
        Self { photons, places, astray, parts }
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
        if most == 0 || self.photons.is_empty() {
            return;
        }
        let metric = Metric { point, normal: FLATTENING * normal.unwrap_or(Vec3::ZERO) };
        let limit = radius * radius;
        let mut search = Search { map: self, metric, limit, most, full: false, found: &mut found.members };
        search.run();
        if search.full {
            found.radius = search.limit.sqrt();
        }
    }

    /// Where photon `i` lies, seen from `p`.
    #[inline]
    fn away(&self, i: usize, p: Vec3) -> Vec3 {
        let [x, y, z] = &self.places;
        Vec3::new(f64::from(x[i]), f64::from(y[i]), f64::from(z[i])) - p
    }
}

impl Part {
    /// Squared distance of the box from `p`.
    #[inline]
    fn distance(&self, p: Vec3) -> f64 {
        let outside = (self.low.as_dvec3() - p).max(p - self.high.as_dvec3()).max(Vec3::ZERO);
        outside.length_squared()
    }
}

impl Search<'_> {
    /// The middle photon of each part, then the side of its plane where the point lies, then the other.
    fn run(&mut self) {
        let map = self.map;
        let mut waiting = [(0u32, 0.0); DEEPEST];
        let (mut top, mut at) = (0, 0u32);
        loop {
            let part = &map.parts[at as usize];
            if part.distance(self.metric.point) < self.limit {
                if part.upper != 0 {
                    let middle = part.first + (part.count - 1) / 2;
                    let along = self.middle(middle, part.axis as usize);
                    let (near, far) = if along > 0.0 { (at + 1, part.upper) } else { (part.upper, at + 1) };
                    if along * along < self.limit {
                        waiting[top] = (far, along * along);
                        top += 1;
                    }
                    at = near;
                    continue;
                }
                self.scan(part);
            }
            loop {
                if top == 0 {
                    return;
                }
                top -= 1;
                at = waiting[top].0;
                if waiting[top].1 < self.limit {
                    break;
                }
            }
        }
    }

    /// Looks at a middle photon; how far its plane is above the point.
    #[inline]
    fn middle(&mut self, place: u32, axis: usize) -> f64 {
        let away = self.map.away(place as usize, self.metric.point);
        let along = away[axis];
        let square = self.metric.square(away);
        if square < self.limit && along * along <= self.limit {
            self.take(square, place);
        }
        along
    }

    /// Looks at all photons of a small part. Their order counts only while there is room, and for those that
    /// the search may miss.
    fn scan(&mut self, part: &Part) {
        let (first, count) = (part.first as usize, part.count as usize);
        let mut squares = [0.0; LEAF];
        for (i, square) in squares[..count].iter_mut().enumerate() {
            *square = self.metric.square(self.map.away(first + i, self.metric.point));
        }
        let squares = &squares[..count];
        let near = squares.iter().filter(|&&s| s < self.limit).count();
        if near == 0 {
            return;
        }
        if !self.full && self.found.len() + near > self.most {
            return self.walk(part.first, part.count);
        }
        let mut missed = 0u32;
        for (i, _) in squares.iter().enumerate().filter(|(_, s)| **s < self.limit) {
            match self.is_missed(first, i) {
                Some(skip) => missed |= u32::from(skip) << i,
                None => return self.walk(part.first, part.count),
            }
        }
        for (i, &square) in squares.iter().enumerate() {
            if square < self.limit && missed >> i & 1 == 0 {
                self.take(square, (first + i) as u32);
            }
        }
    }

    /// Whether the search passes by photon `i` of the part at `first`, because it is filed on the far side of a
    /// plane though it stands on the near one. `None` where that hangs on the order.
    #[inline]
    fn is_missed(&self, first: usize, i: usize) -> Option<bool> {
        let plane = match self.map.astray[first + i] {
            0 => return Some(false),
            OFTEN => return None,
            n => usize::from(n) - 1,
        };
        let axis = split_axis(&self.map.photons[first + plane]);
        let along = f64::from(self.map.places[axis][first + plane]) - self.metric.point[axis];
        let is_far = (along > 0.0) == (i > plane);
        let square = along * along;
        match is_far && square >= SURELY * self.limit {
            false => Some(false),
            true if square >= self.limit || !self.full => Some(square >= self.limit),
            true => None,
        }
    }

    /// The photons of a small part in the order of the tree.
    fn walk(&mut self, first: u32, count: u32) {
        if count == 0 {
            return;
        }
        let half = (count - 1) / 2;
        let middle = first + half;
        let along = self.middle(middle, split_axis(&self.map.photons[middle as usize]));
        let (low, high) = ((first, half), (middle + 1, count - 1 - half));
        let (near, far) = if along > 0.0 { (low, high) } else { (high, low) };
        self.walk(near.0, near.1);
        if along * along < self.limit {
            self.walk(far.0, far.1);
        }
    }

    /// Keeps a photon nearer than the limit. From the one after the last that there is room for, each takes
    /// the place of the farthest.
    fn take(&mut self, square: f64, place: u32) {
        let found = &mut *self.found;
        if found.len() < self.most {
            return found.push((square, place));
        }
        if !self.full {
            (0..self.most / 2).rev().for_each(|i| sift_down(found, i));
            self.full = true;
        }
        found[0] = (square, place);
        sift_down(found, 0);
        self.limit = found[0].0;
    }
}

/// Appends the parts of a range of the tree that begins at `first`.
fn part(photons: &[PackedPhoton], first: usize, parts: &mut Vec<Part>) {
    let empty = (glam::Vec3::INFINITY, glam::Vec3::NEG_INFINITY);
    let around = |(low, high): (glam::Vec3, glam::Vec3), p: &PackedPhoton| {
        let p = glam::Vec3::from(p.place);
        (low.min(p), high.max(p))
    };
    let at = parts.len();
    let (low, high) = empty;
    parts.push(Part { low, high, first: first as u32, count: photons.len() as u32, upper: 0, axis: 0 });
    if photons.len() <= LEAF {
        (parts[at].low, parts[at].high) = photons.iter().fold(empty, around);
        return;
    }
    let middle = (photons.len() - 1) / 2;
    parts[at].axis = split_axis(&photons[middle]) as u32;
    part(&photons[..middle], first, parts);
    let upper = parts.len();
    part(&photons[middle + 1..], first + middle + 1, parts);
    let own = around(empty, &photons[middle]);
    let (a, b) = (parts[at + 1], parts[upper]);
    parts[at].low = own.0.min(a.low).min(b.low);
    parts[at].high = own.1.max(a.high).max(b.high);
    parts[at].upper = upper as u32;
}

/// Marks photons of a small part that stand on the wrong side of a plane in it; `first` is the place in the part
/// where this range of it begins.
fn find_astray(photons: &[PackedPhoton], first: u8, astray: &mut [u8]) {
    if photons.len() < 2 {
        return;
    }
    let middle = (photons.len() - 1) / 2;
    let axis = split_axis(&photons[middle]);
    for (i, p) in photons.iter().enumerate() {
        let (at, plane) = (p.place[axis], photons[middle].place[axis]);
        if if i < middle { at > plane } else { at < plane } {
            astray[i] = if astray[i] == 0 { first + middle as u8 + 1 } else { OFTEN };
        }
    }
    let (low, high) = astray.split_at_mut(middle);
    find_astray(&photons[..middle], first, low);
    find_astray(&photons[middle + 1..], first + middle as u8 + 1, &mut high[1..]);
}

fn split_axis(photon: &PackedPhoton) -> usize {
    usize::from(photon.axis.min(2))
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
