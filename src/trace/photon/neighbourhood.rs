//! Searches for photons near those before.
//!
//! Points near each other ask for nearly the same photons. Where two searches in a row were near each other, the
//! ranges of the tree that a ball around them touches are kept. Later searches inside the ball look through those,
//! four photons at a time in single precision, count distances by bucket, and measure exactly only the photons on
//! the rim. What is found is what the search through the tree finds; where that is not sure, it is left to it.

use super::map::{BUCKETS, Metric, Nearby, PhotonMap, SINGLE};
use crate::math::Vec3;
use std::ops::Range;

/// The photons in a ball.
#[derive(Debug)]
struct Neighbourhood {
    center: Vec3,
    /// Of the ball.
    reach: f64,
    /// Searches in the ball mostly go this far; infinite if they did not find as many photons as wanted.
    radius: f64,
    /// Searches are for so many photons.
    most: usize,
    /// Places in the map of all photons of the ball, and of some beside it, in order.
    members: Vec<u32>,
    /// Their coordinates, by axis.
    coordinates: [Vec<f32>; 3],
}

/// Neighbourhoods of late; forgotten at the beginning of every block, as they decide in which order light is added.
#[derive(Debug, Default)]
pub struct Neighbourhoods {
    kept: Vec<Neighbourhood>,
    /// The next to be given up.
    oldest: usize,
    /// Where the last search through the tree was, and how far it went.
    last: Option<(Vec3, f64)>,
}

/// Neighbourhoods that are kept.
const KEPT: usize = 12;

/// A ball's radius, in radii of the search in its middle.
const BALL: f64 = 1.25;

/// Searches go at most so much farther than the one in the middle, or nearly.
const GROWTH: f64 = 1.03;

/// A search for the nearest begins so much farther out than it must: what is filed on the wrong side of a plane on
/// the rim is found as the reference finds it.
const GUESS: f64 = 1.15;

/// With more photons than this many searches find, a neighbourhood does not pay.
const CROWDED: usize = 10;

/// A search in a neighbourhood is given up where that through the tree passes by more photons.
const MOST_PASSED_BY: usize = 4;

/// What searches use again and again.
#[derive(Clone, Debug, Default)]
pub(super) struct Scratch {
    /// Squared distances in the way of a search through the tree.
    pub keys: Vec<f64>,
    squares: Vec<f32>,
    rim: Vec<(f64, u32)>,
}

impl Neighbourhoods {
    pub fn clear(&mut self) {
        (self.oldest, self.last) = (0, None);
        self.kept.clear();
    }

    /// The smallest that holds what a search from `point` is likely to find.
    fn around(&self, point: Vec3, radius: f64, most: usize) -> Option<(&Neighbourhood, f64)> {
        let reaching = self.kept.iter().filter_map(|n| {
            let complete = n.reach - (point - n.center).length();
            (n.most == most && complete >= radius.min(GROWTH * n.radius)).then_some((n, complete))
        });
        reaching.min_by_key(|(n, _)| n.members.len())
    }

    fn keep(&mut self, new: Neighbourhood) {
        if self.kept.len() < KEPT {
            self.kept.push(new);
        } else {
            self.kept[self.oldest] = new;
            self.oldest = (self.oldest + 1) % KEPT;
        }
    }
}

impl PhotonMap {
    /// As [`PhotonMap::gather`], with what searches before this one learned.
    pub fn gather_near(
        &self,
        point: Vec3,
        radius: f64,
        most: usize,
        normal: Option<Vec3>,
        found: &mut Nearby,
        late: &mut Neighbourhoods,
    ) {
        if self.gathers_otherwise(&Metric::new(point, normal), radius, most, found) {
            return;
        }
        let metric = Metric::new(point, normal);
        let known = match late.around(point, radius, most) {
            Some((around, complete)) => self.gather_in(around, complete, &metric, radius, found),
            None => Answer::Short,
        };
        if known == Answer::Found {
            return;
        }
        let near = late.last.map(|(p, r)| (r, (p - point).length())).filter(|(r, away)| away < r);
        if known == Answer::Short {
            let expected = match near {
                Some((r, _)) => r,
                None => self.likely_reach(point, most, found),
            };
            let new = self.neighbourhood(point, expected.min(radius), radius, most);
            let answer = new.as_ref().map(|new| self.gather_in(new, new.reach, &metric, radius, found));
            if let Some(mut new) = new
                && answer == Some(Answer::Found)
            {
                new.radius = if found.members.len() >= most { found.radius } else { f64::INFINITY };
                late.keep(new);
                late.last = Some((point, found.radius));
                return;
            }
        }
        let guess = near.map_or(f64::INFINITY, |(r, away)| GUESS * (r + away));
        self.gather_from(&metric, radius, most, guess, found);
        late.last = Some((point, found.radius));
    }

    /// [`PhotonMap::has`], by the photons of a neighbourhood if there is one that is large enough.
    pub(super) fn has_near(
        &self,
        count: usize,
        metric: &Metric,
        radius: f64,
        found: &mut Nearby,
        late: &Neighbourhoods,
    ) -> bool {
        let covers = |n: &&Neighbourhood| n.reach - (metric.point - n.center).length() >= radius;
        let Some(around) = late.kept.iter().filter(covers).min_by_key(|n| n.members.len()) else {
            return self.has(count, metric, radius);
        };
        around.members.len() >= count
            && BallSearch { map: self, metric, around, square: radius * radius }.has(count, found)
    }

    /// The photons around a point, where searches seem to go `expected` far; `None` if they are too many.
    fn neighbourhood(&self, center: Vec3, expected: f64, radius: f64, most: usize) -> Option<Neighbourhood> {
        let reach = BALL * expected.min(radius);
        let ranges = self.near_ranges(center, reach);
        let count: usize = ranges.iter().map(Range::len).sum();
        if count > CROWDED * most {
            return None;
        }
        let mut coordinates = [(); 3].map(|()| Vec::with_capacity(count));
        for range in &ranges {
            for (all, part) in coordinates.iter_mut().zip(self.places_of(range)) {
                all.extend_from_slice(part);
            }
        }
        let members = ranges.into_iter().flatten().collect();
        Some(Neighbourhood { center, reach, radius: f64::INFINITY, most, members, coordinates })
    }

    /// The search in a neighbourhood, which is complete as far as `complete`.
    fn gather_in(
        &self,
        around: &Neighbourhood,
        complete: f64,
        metric: &Metric,
        radius: f64,
        found: &mut Nearby,
    ) -> Answer {
        found.radius = radius;
        let limit = radius.min(complete);
        let search = BallSearch { map: self, metric, around, square: limit * limit };
        search.run(limit == radius, found)
    }

    /// Ranges of photons that a ball may hold, those side by side as one.
    fn near_ranges(&self, center: Vec3, reach: f64) -> Vec<Range<u32>> {
        let reach = reach + SINGLE * (center.abs().max_element() + reach);
        let ball = (center.as_vec3(), (reach * reach * (1.0 + SINGLE)) as f32);
        let mut ranges = Vec::with_capacity(16);
        self.add_near(0, &ball, &mut ranges);
        ranges
    }

    /// Those of a part; the ball is told by its centre and its squared radius.
    fn add_near(&self, at: usize, ball: &(glam::Vec3, f32), ranges: &mut Vec<Range<u32>>) {
        let part = &self.parts[at];
        let (nearest, farthest) = part.distances(ball.0);
        if nearest > ball.1 {
            return;
        }
        if part.upper == 0 || farthest <= ball.1 {
            add(ranges, part.first..part.first + part.count);
            return;
        }
        let middle = part.first + (part.count - 1) / 2;
        self.add_near(at + 1, ball, ranges);
        add(ranges, middle..middle + 1);
        self.add_near(part.upper as usize, ball, ranges);
    }
}

/// Appends a range, or lengthens the last.
fn add(ranges: &mut Vec<Range<u32>>, new: Range<u32>) {
    match ranges.last_mut() {
        Some(last) if last.end == new.start => last.end = new.end,
        _ => ranges.push(new),
    }
}

/// What comes of a search in a neighbourhood.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Answer {
    Found,
    /// It would have to go farther.
    Short,
    /// Whether the search through the tree finds the same is not sure.
    Doubtful,
    /// The search through the tree does not find this one.
    PassedBy(u32),
}

/// One search.
struct BallSearch<'a> {
    map: &'a PhotonMap,
    metric: &'a Metric,
    around: &'a Neighbourhood,
    /// All photons less than this squared distance away are members.
    square: f64,
}

impl BallSearch<'_> {
    /// `is_whole` if the search asked for goes no farther.
    fn run(&self, is_whole: bool, found: &mut Nearby) -> Answer {
        self.measure(&mut found.scratch.squares);
        let radius = found.radius;
        for _ in 0..=MOST_PASSED_BY {
            found.radius = radius;
            let answer = self.choose(is_whole, found);
            let Answer::PassedBy(place) = answer else { return answer };
            if let Some(square) = self.square_of(place, &mut found.scratch.squares) {
                *square = f32::INFINITY;
            }
        }
        Answer::Doubtful
    }

    /// The nearest photons by what was measured.
    fn choose(&self, is_whole: bool, found: &mut Nearby) -> Answer {
        let counts = by_bucket(&found.scratch.squares, BUCKETS as f32 / self.square as f32);
        let most = self.around.most;
        let sure: u32 = counts[..BUCKETS - 1].iter().sum();
        let error = self.error();
        if sure as usize <= most {
            return if is_whole { self.all(found) } else { Answer::Short };
        }
        let (mut last, mut rank) = (0, most as u32);
        while rank > counts[last] {
            rank -= counts[last];
            last += 1;
        }
        let width = self.square / BUCKETS as f64;
        let rim = (last as f64 * width - error) as f32..((last + 1) as f64 * width + error) as f32;
        let inner = self.collect(rim, found);
        let Nearby { scratch, members, radius } = found;
        let rim = &mut scratch.rim;
        if inner >= most || inner + rim.len() < most {
            return Answer::Doubtful;
        }
        let missing = most - inner;
        let (_, &mut (farthest, _), others) =
            rim.select_nth_unstable_by(missing - 1, |a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        // Of equal ones the tree keeps those that it meets first.
        if others.iter().any(|o| o.0 == farthest) {
            return Answer::Doubtful;
        }
        rim[..missing].sort_unstable_by_key(|r| r.1);
        members.extend_from_slice(&rim[..missing]);
        *radius = farthest.sqrt();
        self.certain(farthest, is_whole, found)
    }

    /// All photons of a search that finds no more than wanted.
    fn all(&self, found: &mut Nearby) -> Answer {
        let (most, error) = (self.around.most, self.error());
        let inner = self.collect((self.square - error) as f32..(self.square + error) as f32, found);
        let Nearby { scratch, members, .. } = found;
        members.extend(scratch.rim.iter().filter(|r| r.0 < self.square));
        if inner > most || members.len() > most {
            return Answer::Doubtful;
        }
        // A search that never fills up looks behind all planes that it touches, and only those.
        members.retain(|&(_, place)| self.map.is_met(place as usize, self.metric.point, self.square));
        Answer::Found
    }

    /// Whether so many photons are nearer than the squared distance.
    fn has(&self, count: usize, found: &mut Nearby) -> bool {
        self.measure(&mut found.scratch.squares);
        let (error, squares) = (self.error(), &found.scratch.squares);
        let nearer = |limit: f32| squares.iter().map(|&s| u32::from(s < limit)).sum::<u32>() as usize;
        let (low, high) = ((self.square - error) as f32, (self.square + error) as f32);
        if nearer(low) >= count {
            return true;
        }
        if nearer(high) < count {
            return false;
        }
        let square = |&&place: &&u32| self.metric.square(self.map.away(place as usize, self.metric.point));
        self.around.members.iter().filter(|place| square(place) < self.square).count() >= count
    }

    /// Bound on the error of squared distances in single precision.
    fn error(&self) -> f64 {
        let radius = self.square.sqrt();
        let slope = 1.0 + self.metric.normal.length() * radius;
        let shift = SINGLE * (self.metric.point.abs().max_element() + radius);
        (2.0 * slope * shift * (radius + shift) + SINGLE * slope * self.square) * 2.0
    }

    /// Squared distances of all photons.
    fn measure(&self, squares: &mut Vec<f32>) {
        let (p, n) = (self.metric.point.as_vec3(), self.metric.normal.as_vec3());
        let [x, y, z] = &self.around.coordinates;
        squares.clear();
        squares.extend(x.iter().zip(y).zip(z).map(|((x, y), z)| {
            let (x, y, z) = (x - p.x, y - p.y, z - p.z);
            (x * x + y * y + z * z) * (1.0 + (n.x * x + n.y * y + n.z * z).abs())
        }));
    }

    /// Takes photons nearer than the rim; those on the rim are measured and set aside. How many there were.
    fn collect(&self, rim: Range<f32>, found: &mut Nearby) -> usize {
        let Nearby { scratch, members, .. } = found;
        members.clear();
        scratch.rim.clear();
        for (&place, &square) in self.around.members.iter().zip(&scratch.squares) {
            if square < rim.start {
                members.push((f64::from(square), place));
            } else if square <= rim.end {
                let away = self.map.away(place as usize, self.metric.point);
                scratch.rim.push((self.metric.square(away), place));
            }
        }
        members.len()
    }

    /// Whether the search through the tree, which ends at squared distance `limit`, passes one of these by.
    fn certain(&self, limit: f64, is_whole: bool, found: &Nearby) -> Answer {
        let is_met = |place: u32| self.map.is_met(place as usize, self.metric.point, limit);
        for &(_, place) in found.members.iter().filter(|m| !is_met(m.1)) {
            match self.is_passed_by(place, is_whole, &found.scratch.squares) {
                Some(true) => return Answer::PassedBy(place),
                Some(false) => {}
                None => return Answer::Doubtful,
            }
        }
        Answer::Found
    }

    /// Whether the search through the tree finds enough photons on this side of a plane before it looks behind it,
    /// where `place` is filed. `None` if that is not known.
    fn is_passed_by(&self, place: u32, is_whole: bool, squares: &[f32]) -> Option<bool> {
        let (map, most) = (self.map, self.around.most);
        let (plane, away) = map.plane_before(place as usize, self.metric.point)?;
        let square = away * away;
        if is_whole && square >= self.square {
            return Some(true);
        }
        let before = map.before_behind(plane, self.metric.point)?;
        let error = self.error();
        let (low, high) = ((square.min(self.square) - error) as f32, (square + error) as f32);
        let (mut least, mut greatest) = (0, 0);
        for (&i, &s) in self.around.members.iter().zip(squares).filter(|(_, s)| **s <= high) {
            if before.iter().any(|range| range.contains(&i)) {
                greatest += 1;
                least += usize::from(s < low && map.is_in_place(i as usize));
            }
        }
        let all_known = square + error < self.square;
        match () {
            () if least >= most => Some(true),
            () if all_known && greatest < most => Some(false),
            () => None,
        }
    }

    fn square_of<'s>(&self, place: u32, squares: &'s mut [f32]) -> Option<&'s mut f32> {
        squares.get_mut(self.around.members.binary_search(&place).ok()?)
    }
}

/// How many squared distances fall in each bucket; the last counter is for those beyond.
fn by_bucket(squares: &[f32], scale: f32) -> [u32; BUCKETS + 1] {
    // A number so large that it has no fraction: what is added to it is rounded, and stands in its last bits.
    const WHOLE: f32 = 12_582_912.0;
    let mut counts = [0; 2 * BUCKETS];
    for &square in squares {
        let place = square * scale;
        let place = if place < BUCKETS as f32 { place } else { BUCKETS as f32 };
        counts[(WHOLE + (place - 0.5)).to_bits() as usize % (2 * BUCKETS)] += 1;
    }
    std::array::from_fn(|i| counts[i])
}

#[cfg(test)]
mod tests {
    use super::super::map::tests::{on_a_plane, scattered};
    use super::*;
    use crate::light::PackedPhoton;

    /// Searches that a neighbourhood answers, and how many of them differ from those through the tree.
    fn answered(
        photons: Vec<PackedPhoton>,
        radius: f64,
        most: usize,
        normal: Option<Vec3>,
    ) -> (usize, usize) {
        let map = PhotonMap::new(photons);
        let (mut late, mut answered, mut different) = (Neighbourhoods::default(), 0, 0);
        // Used again and again, as the tracer does.
        let mut quick = Nearby::default();
        for i in 0..600 {
            let f = f64::from(i);
            let point = Vec3::new((f * 0.02).sin() * 3.0, 0.0, (f * 0.013).sin() * 2.0);
            let mut slow = Nearby { radius, ..Nearby::default() };
            let metric = Metric::new(point, normal);
            let known = late.around(point, radius, most);
            let is_known = known.is_some_and(|(around, complete)| {
                map.gather_in(around, complete, &metric, radius, &mut quick) == Answer::Found
            });
            answered += usize::from(is_known);
            map.gather_near(point, radius, most, normal, &mut quick, &mut late);
            map.search(&metric, (radius, radius), most, &mut slow);
            let places = |n: &Nearby| {
                let mut places: Vec<u32> = n.members.iter().map(|m| m.1).collect();
                places.sort_unstable();
                places
            };
            different += usize::from(places(&quick) != places(&slow) || quick.radius != slow.radius);
        }
        (answered, different)
    }

    #[test]
    fn neighbourhoods_find_what_the_tree_finds() {
        for normal in [None, Some(Vec3::Y)] {
            for (radius, most) in
                [(0.3, 40), (1.0, 40), (10.0, 40), (2.0, 100), (1.0, 1), (1.0, 5), (2.0, 20)]
            {
                let on_a_plane = answered(on_a_plane(4000), radius, most, normal);
                let in_space = answered(scattered(5000), radius, most, normal);
                assert!(on_a_plane.0 > 200 || most < 10, "{radius} {most} {normal:?}: {on_a_plane:?}");
                // Searches through the tree that begin near by pass by fewer photons, once in a thousand times.
                let different = on_a_plane.1 + in_space.1;
                assert!(different <= usize::from(most > 20), "{radius} {most} {normal:?}: {different}");
            }
        }
    }

    /// What is kept of the map for all threads does not hang on what one found before.
    #[test]
    fn reaches_are_the_same_for_everybody() {
        let reach = |mut found: Nearby| {
            let map = PhotonMap::new(on_a_plane(4000));
            (0..50)
                .map(|i| map.likely_reach(Vec3::X * (0.1 * f64::from(i)), 40, &mut found))
                .collect::<Vec<_>>()
        };
        let filled =
            Nearby { members: (0..200).map(|i| (1e-6 * f64::from(i), i)).collect(), ..Nearby::default() };
        assert_eq!(reach(Nearby::default()), reach(filled));
    }
}
