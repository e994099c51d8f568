//! Photons that are filed on the wrong side of a plane, and which of them a search passes by: it looks behind a plane
//! only where it has not found enough photons nearer than that.

use super::{LEAF, PhotonMap, split_axis};
use crate::light::PackedPhoton;
use crate::math::Vec3;
use smallvec::SmallVec;
use std::ops::Range;

/// Stands on the wrong side of several planes.
const OFTEN: i32 = i32::MAX;

/// Ranges of photons.
type Before = SmallVec<[Range<u32>; 32]>;

impl PhotonMap {
    /// Whether a search from `point` that ends at squared distance `limit` is sure to come by photon `i`: one that
    /// is filed on the far side of a plane though it stands on the near one is found only if the search goes as
    /// far as the plane.
    #[inline]
    pub(in crate::trace::photon) fn is_met(&self, i: usize, point: Vec3, limit: f64) -> bool {
        match self.astray[i] {
            0 => true,
            OFTEN => self.is_met_through_all(i, point, limit),
            n => !self.is_hidden(i, i.wrapping_add_signed(n as isize), point, limit),
        }
    }

    /// Whether photon `i` is filed behind the plane of another, at which the search ends.
    #[inline]
    fn is_hidden(&self, i: usize, plane: usize, point: Vec3, limit: f64) -> bool {
        let axis = split_axis(&self.photons[plane]);
        let along = f64::from(self.places[axis][plane]) - point[axis];
        (along > 0.0) == (i > plane) && along * along >= limit
    }

    /// Whether photon `i` stands on the right side of all planes.
    #[inline]
    pub(in crate::trace::photon) fn is_in_place(&self, i: usize) -> bool {
        self.astray[i] == 0
    }

    /// The photon on whose plane's wrong side `i` stands, and how far along its axis the plane is; `None` if there
    /// are several.
    pub(in crate::trace::photon) fn plane_before(&self, i: usize, point: Vec3) -> Option<(usize, f64)> {
        let n = self.astray[i];
        let plane = i.wrapping_add_signed(n as isize);
        (n != 0 && n != OFTEN).then(|| (plane, self.away(plane, point)[split_axis(&self.photons[plane])]))
    }

    /// The photons that a search from `point` comes to before it looks behind a plane; `None` if the plane does not
    /// divide a small part, where the search would look behind it for less.
    pub(in crate::trace::photon) fn before_behind(&self, plane: usize, point: Vec3) -> Option<Before> {
        let (mut before, mut first, mut end) = (Before::new(), 0, self.photons.len());
        loop {
            let middle = first + (end - first - 1) / 2;
            let along = self.away(middle, point)[split_axis(&self.photons[middle])];
            let (low, high) = (first..middle, middle + 1..end);
            let (near, far) = if along > 0.0 { (low, high) } else { (high, low) };
            before.push(middle as u32..middle as u32 + 1);
            if middle == plane || far.contains(&plane) {
                before.push(near.start as u32..near.end as u32);
            }
            if middle == plane {
                return (end - first <= LEAF).then_some(before);
            }
            (first, end) = if far.contains(&plane) { (far.start, far.end) } else { (near.start, near.end) };
        }
    }

    /// [`PhotonMap::is_met`] for any photon, by all planes above it.
    fn is_met_through_all(&self, i: usize, point: Vec3, limit: f64) -> bool {
        let (mut first, mut end) = (0, self.photons.len());
        loop {
            let middle = first + (end - first - 1) / 2;
            if middle == i {
                return true;
            }
            if self.is_hidden(i, middle, point, limit) {
                return false;
            }
            (first, end) = if i < middle { (first, middle) } else { (middle + 1, end) };
        }
    }
}

/// Marks photons that stand on the wrong side of a plane.
pub(super) fn find(photons: &[PackedPhoton], astray: &mut [i32]) {
    if photons.len() < 2 {
        return;
    }
    let middle = (photons.len() - 1) / 2;
    let axis = split_axis(&photons[middle]);
    for (i, p) in photons.iter().enumerate() {
        let (at, plane) = (p.place[axis], photons[middle].place[axis]);
        if if i < middle { at > plane } else { at < plane } {
            astray[i] = if astray[i] == 0 { middle as i32 - i as i32 } else { OFTEN };
        }
    }
    let (low, high) = astray.split_at_mut(middle);
    find(&photons[..middle], low);
    find(&photons[middle + 1..], &mut high[1..]);
}
