//! What the children of an intersection leave of each other's crossings along one ray.
//!
//! Most children are solids that a line enters at most once ([`Chord`]): two distances say all about such a
//! child, and the ray is cut to them before the next one is asked. A crossing is only held against a child's own
//! rule for points ([`Child::contains`]) where it comes close to one of those ends.

use super::compound::{Child, Compound};
use super::geometry::{Found, Geometry, Solid};
use super::probe::Probe;
use super::scratch::Lists;
use crate::math::{EPSILON, Range, Ray};
use crate::shape::{Chord, Span};
use smallvec::SmallVec;

/// All crossings of the children of an intersection along one ray: a stretch of the list of
/// crossings, and whose each is.
pub(super) struct Candidates {
    pub first: usize,
    owners: SmallVec<[u32; 16]>,
    /// What each child says of the range.
    says: SmallVec<[Says; 8]>,
    /// Where there may be anything of the intersection.
    range: Range,
}

/// What a child says of the points of a ray.
#[derive(Clone, Copy, Debug)]
enum Says {
    /// Inside in between, or, with the flag, everywhere else. Ends are not to be trusted to the last digits.
    Chord(f64, f64, bool),
    /// Crossed somewhere: every point is to be asked about.
    Crossed,
    /// Not crossed: the same everywhere.
    Constant,
    Inside,
}

/// Distances from the ends of chords within which points are asked about: far more than roundings, relative to
/// the coordinates.
const CLOSE: f64 = 1e-9;

#[inline]
pub(super) fn margin(size: f64, t: f64) -> f64 {
    CLOSE * (size + t.abs())
}

impl Candidates {
    #[inline]
    fn new(first: usize, range: Range) -> Self {
        Self { first, owners: SmallVec::new(), says: SmallVec::new(), range }
    }

    pub fn count(&self) -> usize {
        self.owners.len()
    }

    /// Takes the crossings that were appended to the list since it had `before`.
    #[inline]
    fn own(&mut self, child: usize, count: usize) {
        for _ in 0..count {
            self.owners.push(child as u32);
        }
    }

    /// Cuts the range to where a chord's child may be inside; false if that is nowhere.
    #[inline]
    fn cut(&mut self, near: f64, far: f64, beyond: bool, size: f64) -> bool {
        if near > far {
            return beyond;
        }
        let range = &mut self.range;
        let (low, high) = (margin(size, near), margin(size, far));
        if !beyond {
            (range.min, range.max) = (greater(range.min, near - low), lesser(range.max, far + high));
        } else if range.min > near + low {
            range.min = greater(range.min, far - high);
        } else if range.max < far - high {
            range.max = lesser(range.max, near + low);
        }
        range.min < range.max
    }
}

#[inline]
fn greater(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

#[inline]
fn lesser(a: f64, b: f64) -> f64 {
    if b < a { b } else { a }
}

impl Compound {
    /// All children's crossings, appended to the list. `None` (and nothing appended) if the ray plainly stays
    /// outside.
    pub fn candidates(
        &self,
        geometry: &Geometry,
        probe: &Probe,
        range: Range,
        lists: &mut Lists,
    ) -> Option<Candidates> {
        let range = self.unclipped(geometry, probe, range)?;
        let mut candidates = Candidates::new(lists.found.len(), range);
        for (i, child) in self.children.iter().enumerate() {
            if !self.ask(geometry, probe, (i, child), &mut candidates, lists) {
                lists.found.truncate(candidates.first);
                return None;
            }
        }
        (candidates.count() > 0).then_some(candidates)
    }

    /// The part of `range` that the clips leave, as far as boxes and chords tell.
    #[inline]
    pub fn unclipped(&self, geometry: &Geometry, probe: &Probe, range: Range) -> Option<Range> {
        if self.clips.is_empty() {
            return Some(range);
        }
        let mut left = Candidates::new(0, range);
        for clip in &self.clips {
            if !clip.extent.outside && !probe.meets(&clip.reach, left.range) {
                return None;
            }
            // What is bounded has had its say.
            if !clip.tight
                && let Some((chord, length)) = geometry.chord(clip.solid, probe.ray, left.range)
            {
                let (near, far) = (chord.span.enter.0 / length, chord.span.leave.0 / length);
                if !left.cut(near, far, chord.beyond, probe.size()) {
                    return None;
                }
            }
        }
        Some(left.range)
    }

    /// Takes in what one child says; false if the ray stays outside of it.
    #[inline]
    fn ask(
        &self,
        geometry: &Geometry,
        probe: &Probe,
        (i, child): (usize, &Child),
        candidates: &mut Candidates,
        lists: &mut Lists,
    ) -> bool {
        let range = candidates.range;
        let meets = probe.meets(&child.reach, range);
        if !meets && child.tight {
            candidates.says.push(Says::Inside);
            return child.extent.outside;
        }
        if let Some((chord, length)) = geometry.chord(child.solid, probe.ray, range) {
            return Self::take_chord(probe, (i, child), (chord, length), candidates, lists);
        }
        let before = lists.found.len();
        if meets {
            geometry.crossings(child.solid, probe, range, lists);
        }
        let count = lists.found.len() - before;
        candidates.own(i, count);
        candidates.says.push(if count > 0 { Says::Crossed } else { Says::Constant });
        // If uncrossed and outside in the middle: outside all the way.
        count > 0 || !geometry.is_upright_leaf(child.solid) || child.contains(geometry, probe.middle(range))
    }

    #[inline]
    fn take_chord(
        probe: &Probe,
        (i, child): (usize, &Child),
        (chord, length): (Chord, f64),
        candidates: &mut Candidates,
        lists: &mut Lists,
    ) -> bool {
        let Solid::Leaf(leaf) = child.solid else { return true };
        let world = |t: f64| if length == 1.0 { t } else { t / length };
        let Span { enter, leave } = chord.span;
        let (near, far) = (world(enter.0), world(leave.0));
        candidates.says.push(Says::Chord(near, far, chord.beyond));
        if !candidates.cut(near, far, chord.beyond, probe.size()) {
            return false;
        }
        for (t, (local, part)) in [(near, enter), (far, leave)] {
            if candidates.range.contains(t) {
                candidates.owners.push(i as u32);
                lists.found.push(Found::on_part(t, leaf, local, part));
            }
        }
        true
    }

    /// The nearest candidate that stands, of equal ones the last; takes all of them off the list.
    pub fn nearest_kept(
        &self,
        geometry: &Geometry,
        probe: &Probe,
        mut candidates: Candidates,
        lists: &mut Lists,
    ) -> Option<Found> {
        let first = candidates.first;
        let found = &lists.found[first..];
        // By distance; of equal ones the last first.
        let mut order: SmallVec<[u32; 16]> = SmallVec::new();
        for (i, f) in found.iter().enumerate() {
            order.push(i as u32);
            let mut place = i;
            while place > 0 && f.t <= found[order[place - 1] as usize].t {
                order[place] = order[place - 1];
                place -= 1;
            }
            order[place] = i as u32;
        }
        let stands = |&i: &u32| self.keeps(geometry, probe, i as usize, &mut candidates, lists);
        let kept = order.into_iter().find(stands).map(|i| lists.found[first + i as usize]);
        lists.found.truncate(first);
        kept
    }

    /// Whether any candidate stands; takes all of them off the list.
    pub fn any_kept(
        &self,
        geometry: &Geometry,
        probe: &Probe,
        mut candidates: Candidates,
        lists: &mut Lists,
    ) -> bool {
        let met = (0..candidates.count()).any(|i| self.keeps(geometry, probe, i, &mut candidates, lists));
        lists.found.truncate(candidates.first);
        met
    }

    /// Takes the candidates that do not stand off the list.
    pub fn keep(&self, geometry: &Geometry, probe: &Probe, mut candidates: Candidates, lists: &mut Lists) {
        let first = candidates.first;
        let stands: SmallVec<[bool; 16]> =
            (0..candidates.count()).map(|i| self.keeps(geometry, probe, i, &mut candidates, lists)).collect();
        let mut kept = first;
        for (i, &stands) in stands.iter().enumerate() {
            if stands {
                lists.found[kept] = lists.found[first + i];
                kept += 1;
            }
        }
        lists.found.truncate(kept);
    }

    /// Whether the other children and the clips let candidate number `i` stand.
    fn keeps(
        &self,
        geometry: &Geometry,
        probe: &Probe,
        i: usize,
        candidates: &mut Candidates,
        lists: &Lists,
    ) -> bool {
        let Candidates { first, owners, says, range } = candidates;
        let all = &lists.found[*first..*first + owners.len()];
        let (found, owner) = (&all[i], owners[i]);
        if !range.contains(found.t) {
            return false;
        }
        let p = probe.ray.at(found.t);
        let tolerance = tie_tolerance(probe.ray, found.t);
        let tied = |o: usize| {
            let same = |(f, &c): (&Found, &u32)| c as usize == o && (f.t - found.t).abs() <= tolerance;
            all.iter().zip(owners.iter()).any(same)
        };
        let holds = |o: usize| self.children[o].contains(geometry, p);
        let margin = margin(probe.size(), found.t);
        let clear = found.t - range.min > tolerance && range.max - found.t > tolerance;
        for (o, says) in says.iter_mut().enumerate() {
            if o == owner as usize {
                continue;
            }
            let inside = match *says {
                Says::Inside => true,
                Says::Chord(near, far, beyond) => {
                    let (behind, ahead) = (found.t - near, far - found.t);
                    if behind > margin && ahead > margin {
                        !beyond
                    } else if behind < -margin || ahead < -margin {
                        beyond
                    } else {
                        holds(o) || tied(o)
                    }
                }
                Says::Crossed => holds(o) || tied(o),
                Says::Constant => {
                    let inside = holds(o);
                    if inside && clear {
                        *says = Says::Inside;
                    }
                    inside
                }
            };
            if !inside {
                return false;
            }
        }
        self.is_unclipped(geometry, p)
    }
}

/// Distances this close are the same point: a few roundings of everything that went into them.
pub(super) fn tie_tolerance(ray: &Ray, t: f64) -> f64 {
    16.0 * EPSILON * (ray.origin.abs().max_element() + t.abs())
}
