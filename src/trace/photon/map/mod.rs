//! Photons by place: a balanced tree over an array, the middle of a range being its root.
//!
//! The search is that of the reference, not an exact nearest-n one: the reference's way of finding a median
//! leaves ranges of two the wrong way round, so that about one photon in a hundred on the rim of a search is
//! missed, as the search has come so near by then that it does not look behind their plane any more. Following it
//! costs little, and keeps its pictures.
//!
//! Reference: H. W. Jensen, "Realistic Image Synthesis Using Photon Mapping", 2001, chapter 6.

mod astray;

use super::neighbourhood::Scratch;
use super::order::ordered;
use crate::light::PackedPhoton;
use crate::math::Vec3;
use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};

/// The tree. Knows nothing of how photons came about.
#[derive(Debug, Default)]
pub struct PhotonMap {
    photons: Vec<PackedPhoton>,
    /// Coordinates once more, by axis: a search reads many and keeps few.
    places: [Vec<f32>; 3],
    /// Which photon's plane, counted from this one, it stands on the wrong side of; 0 if none.
    astray: Vec<i32>,
    /// Ranges of the tree, each before those below it, the lower one first.
    pub(super) parts: Vec<Part>,
    /// How far searches from the middles of small parts go, once one has asked.
    reaches: Vec<Reach>,
}

/// How far a search for so many photons goes that is not limited, in single precision; 0 if that is not known
/// yet. Whoever works it out finds the same.
#[derive(Debug, Default)]
struct Reach(AtomicU64);

impl Reach {
    fn known(&self, most: usize) -> Option<f64> {
        let bits = self.0.load(Ordering::Relaxed);
        (bits != 0 && bits >> 32 == most as u64).then(|| f64::from(f32::from_bits(bits as u32)))
    }

    fn keep(&self, most: usize, radius: f32) {
        self.0.store(((most as u64) << 32) | u64::from(radius.to_bits()), Ordering::Relaxed);
    }
}

/// A range of the tree and the box around its photons.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    pub low: glam::Vec3,
    pub high: glam::Vec3,
    pub first: u32,
    pub count: u32,
    /// The part of the upper half; 0 where photons are looked at one by one.
    pub upper: u32,
    /// Place in `PhotonMap::reaches`, of parts that are looked at one by one.
    reach: u32,
    /// What the middle photon's plane lies across.
    axis: u32,
}

/// Photons around a point.
#[derive(Clone, Debug, Default)]
pub struct Nearby {
    /// Squared distance, and place in the map, in the order in which the tree is visited.
    pub members: Vec<(f64, u32)>,
    /// How far the search went in the end.
    pub radius: f64,
    pub(super) scratch: Scratch,
}

/// Ranges up to this many photons are looked at one by one.
pub(super) const LEAF: usize = 16;

/// How far is looked first.
const MARGIN: f64 = 1.06;
const PART_OF_WAY: f64 = 0.25;

/// Searches for fewer photons begin with the whole radius, as the reference's do: from nearer by they pass by fewer.
const FEW: usize = 32;

/// No search goes farther.
pub(super) const EVERYWHERE: f64 = 1e15;

/// Parts of the largest squared distance, to find the farthest photons by.
pub(super) const BUCKETS: usize = 64;

/// More halvings than any tree has.
const DEEPEST: usize = 32;

/// How far photons are from a point.
pub(super) struct Metric {
    pub point: Vec3,
    /// 16 times the normal of a plane; photons off it count as farther away.
    pub normal: Vec3,
}

/// How much farther off-plane photons count.
const FLATTENING: f64 = 16.0;

impl Metric {
    pub fn new(point: Vec3, normal: Option<Vec3>) -> Self {
        Self { point, normal: FLATTENING * normal.unwrap_or(Vec3::ZERO) }
    }

    pub fn square(&self, away: Vec3) -> f64 {
        away.length_squared() * (1.0 + self.normal.dot(away).abs())
    }
}

/// A search on its way.
struct Search<'a> {
    map: &'a PhotonMap,
    metric: Metric,
    /// Squared distance from which photons do not count.
    limit: f64,
    /// The same, a little larger, for distances in single precision from `near`.
    reach: f32,
    near: glam::Vec3,
    /// The squared radius asked for.
    outermost: f64,
    most: usize,
    /// There were more than `most`.
    full: bool,
    found: &'a mut Vec<(f64, u32)>,
    keys: &'a mut Vec<f64>,
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
        astray::find(&photons, &mut astray);
        let small = parts.iter_mut().filter(|p| p.upper == 0);
        let count = small.enumerate().map(|(i, p)| p.reach = i as u32).count();
        let reaches = (0..count).map(|_| Reach::default()).collect();
        Self { photons, places, astray, parts, reaches }
    }

    pub fn photons(&self) -> &[PackedPhoton] {
        &self.photons
    }

    pub fn is_empty(&self) -> bool {
        self.photons.is_empty()
    }

    /// At most `most` photons within `radius` of `point`, into `found`.
    pub fn gather(&self, point: Vec3, radius: f64, most: usize, normal: Option<Vec3>, found: &mut Nearby) {
        self.gather_from(&Metric::new(point, normal), radius, most, f64::INFINITY, found);
    }

    /// The same, where `guess` is likely to reach enough photons.
    pub(super) fn gather_from(
        &self,
        metric: &Metric,
        radius: f64,
        most: usize,
        guess: f64,
        found: &mut Nearby,
    ) {
        found.members.clear();
        found.radius = radius;
        if most == 0 || self.photons.is_empty() {
            return;
        }
        if self.gathers_otherwise(metric, radius, most, found) {
            return;
        }
        let within =
            |hint: f64, found: &mut Nearby| hint < radius && self.search(metric, (hint, radius), most, found);
        if most >= FEW {
            if within(guess, found) {
                return;
            }
            let (reach, away) = self.reach_near(metric.point, most, found);
            if within(likely(reach, away), found) || within(reach + away, found) {
                return;
            }
        }
        found.radius = radius;
        self.search(metric, (radius, radius), most, found);
    }

    /// How far a search that is not limited mostly goes.
    pub(super) fn likely_reach(&self, point: Vec3, most: usize, found: &mut Nearby) -> f64 {
        let (reach, away) = self.reach_near(point, most, found);
        likely(reach, away)
    }

    /// How far a search from the middle of the part around `point` goes, and how far away the middle is. Their sum
    /// reaches enough photons, but for what their height over a surface changes; less mostly does.
    fn reach_near(&self, point: Vec3, most: usize, found: &mut Nearby) -> (f64, f64) {
        let (mut at, mut enclosing) = (0, 0);
        while self.parts[at].upper != 0 {
            let part = &self.parts[at];
            if part.count as usize > most {
                enclosing = at;
            }
            let (axis, middle) = (part.axis as usize, part.first + (part.count - 1) / 2);
            let is_low = f64::from(self.places[axis][middle as usize]) > point[axis];
            at = if is_low { at + 1 } else { part.upper as usize };
        }
        let part = &self.parts[at];
        let (center, reach) =
            (0.5 * (part.low.as_dvec3() + part.high.as_dvec3()), &self.reaches[part.reach as usize]);
        let radius = reach.known(most).unwrap_or_else(|| {
            let metric = Metric { point: center, normal: Vec3::ZERO };
            let around = self.parts[enclosing].farthest(center) * (1.0 + SINGLE);
            let enough = self.search(&metric, (around, EVERYWHERE), most, found);
            let radius = if enough { found.radius as f32 * (1.0 + SINGLE as f32) } else { f32::INFINITY };
            found.members.clear();
            reach.keep(most, radius);
            f64::from(radius)
        });
        (radius, (point - center).length())
    }

    /// Coordinates of a range of photons.
    #[inline]
    pub(super) fn places_of(&self, range: &Range<u32>) -> [&[f32]; 3] {
        let range = range.start as usize..range.end as usize;
        [&self.places[0][range.clone()], &self.places[1][range.clone()], &self.places[2][range]]
    }

    /// Whether there are more than `most` photons within the first radius; the second is the one asked for. What was
    /// found before is forgotten.
    pub(super) fn search(
        &self,
        metric: &Metric,
        (radius, whole): (f64, f64),
        most: usize,
        found: &mut Nearby,
    ) -> bool {
        found.members.clear();
        let (near, members, keys) = (metric.point.as_vec3(), &mut found.members, &mut found.scratch.keys);
        let metric = Metric { ..*metric };
        let mut search = Search {
            map: self,
            metric,
            limit: 0.0,
            reach: 0.0,
            near,
            outermost: whole * whole,
            most,
            full: false,
            found: members,
            keys,
        };
        search.shrink(radius * radius);
        search.run();
        if search.found.len() > most {
            search.choose();
        }
        if search.full {
            found.radius = search.limit.sqrt();
        }
        search.full
    }

    /// Where photon `i` lies, seen from `p`.
    #[inline]
    pub(super) fn away(&self, i: usize, p: Vec3) -> Vec3 {
        let [x, y, z] = &self.places;
        Vec3::new(f64::from(x[i]), f64::from(y[i]), f64::from(z[i])) - p
    }
}

impl Part {
    /// Distance of the farthest corner of the box from `p`.
    fn farthest(&self, p: Vec3) -> f64 {
        (self.low.as_dvec3() - p).abs().max((self.high.as_dvec3() - p).abs()).length()
    }

    /// Squared distances of the nearest and of the farthest point of the box from `p`.
    #[inline]
    pub fn distances(&self, p: glam::Vec3) -> (f32, f32) {
        let (low, high) = (self.low - p, p - self.high);
        let farthest = low.min(high);
        (low.max(high).max(glam::Vec3::ZERO).length_squared(), farthest.length_squared())
    }

    /// Squared distance of the box from `p`.
    #[inline]
    pub fn distance(&self, p: Vec3) -> f64 {
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
        let square = self.metric.square(away);
        if square < self.limit {
            self.found.push((square, place));
        }
        away[axis]
    }

    /// Looks at all photons of a small part: first at where they are in single precision.
    fn scan(&mut self, part: &Part) {
        let range = part.first as usize..(part.first + part.count) as usize;
        let [x, y, z] = &self.map.places;
        let (x, y, z) = (&x[range.clone()], &y[range.clone()], &z[range]);
        let mut squares = [0.0f32; LEAF];
        for (((square, x), y), z) in squares.iter_mut().zip(x).zip(y).zip(z) {
            let away = glam::Vec3::new(*x, *y, *z) - self.near;
            *square = away.length_squared();
        }
        let first = self.found.len();
        for (i, &square) in squares[..x.len()].iter().enumerate() {
            if square < self.reach {
                let place = part.first as usize + i;
                let square = self.metric.square(self.map.away(place, self.metric.point));
                if square >= self.limit {
                    continue;
                }
                if !self.map.is_met(place, self.metric.point, square) {
                    self.found.truncate(first);
                    self.walk(part.first, part.count);
                    break;
                }
                self.found.push((square, place as u32));
            }
        }
        self.make_room();
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
        if self.looks_behind(along * along) {
            self.walk(far.0, far.1);
        }
    }

    /// Whether the search still goes as far as a plane: there are not enough nearer photons so far.
    fn looks_behind(&self, square: f64) -> bool {
        let nearer = || self.found.iter().filter(|f| f.0 <= square).count();
        square < self.outermost && (self.found.len() < self.most || nearer() < self.most)
    }

    /// Drops the farthest photons if there are many.
    #[inline]
    fn make_room(&mut self) {
        if self.found.len() >= 2 * self.most + LEAF {
            self.choose();
        }
    }

    /// Keeps the nearest `most` of the photons so far, in their order.
    fn choose(&mut self) {
        let (farthest, mut room) = self.farthest();
        self.found.retain(|&(square, _)| {
            let last = square == farthest && room > 0;
            room -= usize::from(last);
            square < farthest || last
        });
        self.full = true;
        self.shrink(farthest);
    }

    /// The squared distance of photon `most` of those so far, counted from the nearest, and how many at just that
    /// distance there is room for. Distances are counted by bucket first: on a surface they fall evenly.
    fn farthest(&mut self) -> (f64, usize) {
        let scale = BUCKETS as f64 / self.limit;
        let bucket = |square: f64| ((square * scale) as i32 as usize).min(BUCKETS - 1);
        let mut counts = [0u32; BUCKETS];
        self.found.iter().for_each(|f| counts[bucket(f.0)] += 1);
        let (mut last, mut rank) = (0, self.most);
        while rank > counts[last] as usize && last + 1 < BUCKETS {
            rank -= counts[last] as usize;
            last += 1;
        }
        self.keys.clear();
        self.keys.extend(self.found.iter().map(|f| f.0).filter(|&s| bucket(s) == last));
        let (nearer, &mut farthest, _) = self.keys.select_nth_unstable_by(rank - 1, f64::total_cmp);
        (farthest, rank - nearer.iter().filter(|&&s| s < farthest).count())
    }

    fn shrink(&mut self, limit: f64) {
        self.limit = limit;
        let radius = limit.sqrt();
        let error = SINGLE * (self.metric.point.abs().max_element() + radius);
        self.reach = ((radius + error).powi(2) * (1.0 + SINGLE)) as f32;
    }
}

/// How far a search mostly goes, by one from a place nearby.
fn likely(reach: f64, away: f64) -> f64 {
    MARGIN * reach + PART_OF_WAY * away
}

/// More than rounding to single precision changes a distance by, as a share of the numbers that go into it.
pub(super) const SINGLE: f64 = 1e-6;

/// Appends the parts of a range of the tree that begins at `first`.
fn part(photons: &[PackedPhoton], first: usize, parts: &mut Vec<Part>) {
    let empty = (glam::Vec3::INFINITY, glam::Vec3::NEG_INFINITY);
    let around = |(low, high): (glam::Vec3, glam::Vec3), p: &PackedPhoton| {
        let p = glam::Vec3::from(p.place);
        (low.min(p), high.max(p))
    };
    let at = parts.len();
    let (low, high) = empty;
    parts.push(Part {
        low,
        high,
        first: first as u32,
        count: photons.len() as u32,
        upper: 0,
        reach: 0,
        axis: 0,
    });
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

fn split_axis(photon: &PackedPhoton) -> usize {
    usize::from(photon.axis.min(2))
}

#[cfg(not(test))]
impl PhotonMap {
    /// Tests search by other rules, too.
    #[inline(always)]
    pub(super) fn gathers_otherwise(&self, _: &Metric, _: f64, _: usize, _: &mut Nearby) -> bool {
        false
    }
}

#[cfg(test)]
pub(super) mod tests;
