//! Intersections of convex shapes and of what lies outside of convex shapes: where they are plainly met, a few
//! comparisons tell. Wherever two surfaces come close to each other on the ray, it is left to the careful way.

use super::compound::{Compound, Op};
use super::geometry::{Found, Geometry, Solid};
use super::intersection::margin;
use super::probe::Probe;
use crate::math::Range;
use smallvec::SmallVec;

/// What is found at a glance.
#[derive(Clone, Copy, Debug)]
pub(super) enum Glance {
    /// Ask more carefully.
    Unsure,
    Nothing,
    Nearest(Found),
}

/// Where a ray enters or leaves a child: the distance in the world and in the child's space, and the part.
#[derive(Clone, Copy)]
struct End {
    t: f64,
    local: f64,
    part: u32,
    leaf: u32,
}

/// Of the children that the ray must be inside of: the last entry and the first exit, and the next to those.
struct Common {
    enter: End,
    leave: End,
    enter_before: f64,
    leave_behind: f64,
}

impl Common {
    fn line() -> Common {
        let end = |t: f64| End { t, local: t, part: 0, leaf: 0 };
        let (first, last) = (f64::NEG_INFINITY, f64::INFINITY);
        Common { enter: end(first), leave: end(last), enter_before: first, leave_behind: last }
    }

    #[inline]
    fn cut(&mut self, enter: End, leave: End) {
        if enter.t > self.enter.t {
            (self.enter_before, self.enter) = (self.enter.t, enter);
        } else if enter.t > self.enter_before {
            self.enter_before = enter.t;
        }
        if leave.t < self.leave.t {
            (self.leave_behind, self.leave) = (self.leave.t, leave);
        } else if leave.t < self.leave_behind {
            self.leave_behind = leave.t;
        }
    }
}

/// What the children say along one ray.
struct Chords {
    common: Common,
    /// Children that the ray must be outside of.
    holes: SmallVec<[(End, End); 8]>,
    size: f64,
}

impl Chords {
    /// Whether the holes but number `own` let a crossing at `t` stand; `None` if it is close to an end of one.
    #[inline]
    fn stands(&self, t: f64, own: usize) -> Option<bool> {
        let margin = margin(self.size, t);
        let mut sure = true;
        for (i, (enter, leave)) in self.holes.iter().enumerate() {
            if i != own && t > enter.t - margin && t < leave.t + margin {
                if t > enter.t + margin && t < leave.t - margin {
                    return Some(false);
                }
                sure = false;
            }
        }
        sure.then_some(true)
    }

    /// The same for the children that the ray must be inside of.
    #[inline]
    fn is_common(&self, t: f64) -> Option<bool> {
        let margin = margin(self.size, t);
        let (behind, ahead) = (t - self.common.enter.t, self.common.leave.t - t);
        if behind < -margin || ahead < -margin {
            return Some(false);
        }
        (behind > margin && ahead > margin).then_some(true)
    }

    #[inline]
    fn are_close(&self, a: End, b: End) -> bool {
        let margin = margin(self.size, b.t);
        margin.is_finite() && (a.t - b.t).abs() <= margin
    }

    fn of(probe: &Probe) -> Chords {
        Chords { common: Common::line(), holes: SmallVec::new(), size: probe.size() }
    }

    /// Appends all crossings; false if they are not plain.
    fn all(&self, range: Range, all: &mut Vec<Found>) -> bool {
        let Common { enter, leave, enter_before, leave_behind } = self.common;
        if self.are_close(enter, leave) {
            return false;
        }
        if enter.t > leave.t {
            return true;
        }
        let mut take = |end: End| all.push(Found::on_part(end.t, end.leaf, end.local, end.part));
        for (end, alone) in [(enter, enter.t - enter_before), (leave, leave_behind - leave.t)] {
            if range.contains(end.t) {
                match self.stands(end.t, usize::MAX) {
                    Some(false) => {}
                    Some(true) if alone > margin(self.size, end.t) => take(end),
                    _ => return false,
                }
            }
        }
        for (i, &(enter, leave)) in self.holes.iter().enumerate() {
            for end in [enter, leave] {
                if range.contains(end.t) {
                    match (self.is_common(end.t), self.stands(end.t, i)) {
                        (Some(false), _) | (_, Some(false)) => {}
                        (Some(true), Some(true)) => take(end),
                        _ => return false,
                    }
                }
            }
        }
        true
    }

    fn nearest(&self, range: Range) -> Glance {
        let Common { enter, leave, enter_before, leave_behind } = self.common;
        if self.are_close(enter, leave) {
            return Glance::Unsure;
        }
        if enter.t > leave.t {
            return Glance::Nothing;
        }
        let mut best: Option<End> = None;
        let mut within = range;
        let own = [(enter, enter.t - enter_before), (leave, leave_behind - leave.t)];
        for (end, alone) in own {
            if within.contains(end.t) {
                match self.stands(end.t, usize::MAX) {
                    Some(false) => {}
                    Some(true) if alone > margin(self.size, end.t) => {
                        (best, within.max) = (Some(end), end.t);
                    }
                    _ => return Glance::Unsure,
                }
            }
        }
        for (i, &(enter, leave)) in self.holes.iter().enumerate() {
            for end in [enter, leave] {
                if within.contains(end.t) {
                    match (self.is_common(end.t), self.stands(end.t, i)) {
                        (Some(false), _) | (_, Some(false)) => {}
                        (Some(true), Some(true)) => (best, within.max) = (Some(end), end.t),
                        _ => return Glance::Unsure,
                    }
                }
            }
        }
        match best {
            None => Glance::Nothing,
            Some(end) => Glance::Nearest(Found::on_part(end.t, end.leaf, end.local, end.part)),
        }
    }
}

impl Compound {
    /// The nearest crossing of an intersection inside `range`, where that is plain.
    pub fn glance(&self, geometry: &Geometry, probe: &Probe, range: Range) -> Glance {
        let mut chords = Chords::of(probe);
        self.gather(geometry, probe, range, &mut chords).unwrap_or_else(|| chords.nearest(range))
    }

    /// Appends all crossings of an intersection inside `range`, in no order; false if they are not plain.
    pub fn plain_crossings(
        &self,
        geometry: &Geometry,
        probe: &Probe,
        range: Range,
        all: &mut Vec<Found>,
    ) -> bool {
        if self.op != Op::Intersection || !self.gates.is_empty() {
            return false;
        }
        let Some(range) = self.within(probe, range) else { return true };
        let mut chords = Chords::of(probe);
        match self.gather(geometry, probe, range, &mut chords) {
            None => chords.all(range, all),
            Some(Glance::Nothing) => true,
            Some(_) => false,
        }
    }

    /// Takes in what the children say, unless that tells already what there is.
    #[inline(always)]
    fn gather(
        &self,
        geometry: &Geometry,
        probe: &Probe,
        range: Range,
        chords: &mut Chords,
    ) -> Option<Glance> {
        if !self.clips.is_empty() {
            return Some(Glance::Unsure);
        }
        for child in &self.children {
            let Solid::Leaf(leaf) = child.solid else { return Some(Glance::Unsure) };
            if child.tight && !probe.meets(&child.reach, range) {
                if child.extent.outside {
                    continue;
                }
                return Some(Glance::Nothing);
            }
            let Some((chord, length)) = geometry.chord(child.solid, probe.ray, range) else {
                return Some(Glance::Unsure);
            };
            let end = |(local, part): (f64, u32)| End { t: local / length, local, part, leaf };
            let (enter, leave) = (end(chord.span.enter), end(chord.span.leave));
            if enter.t > leave.t {
                // Nothing of the line is in the span.
                if !chord.beyond {
                    return Some(Glance::Nothing);
                }
            } else if chords.are_close(enter, leave) {
                return Some(Glance::Unsure);
            } else if chord.beyond {
                chords.holes.push((enter, leave));
            } else {
                chords.common.cut(enter, leave);
            }
        }
        None
    }
}
