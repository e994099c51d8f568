//! Intervals of a line inside simple convex regions, and the crossings at their ends.

use super::Crossing;
use crate::math::{Aabb, EPSILON, Range, Ray};

/// An interval of ray parameters with the part of the surface at each end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    pub enter: (f64, u32),
    pub leave: (f64, u32),
}

impl Span {
    /// No part of the line.
    pub const NOWHERE: Span = Span { enter: (f64::INFINITY, 0), leave: (f64::NEG_INFINITY, 0) };

    #[inline]
    pub fn new(enter: f64, leave: f64, part: u32) -> Self {
        Self { enter: (enter, part), leave: (leave, part) }
    }

    /// The whole line.
    #[inline]
    pub fn line(part: u32) -> Self {
        Self::new(f64::NEG_INFINITY, f64::INFINITY, part)
    }

    /// What lies in both. At equal ends `other`'s part shows.
    #[inline]
    pub fn intersection(self, other: Span) -> Self {
        let before = |a: f64, b: f64| a < b - tie(a, b);
        let enter = if before(other.enter.0, self.enter.0) { self.enter } else { other.enter };
        let leave = if before(self.leave.0, other.leave.0) { self.leave } else { other.leave };
        Self { enter, leave }
    }

    #[inline]
    pub fn is_empty(&self) -> bool {
        self.enter.0 > self.leave.0 || self.enter.0.is_nan() || self.leave.0.is_nan()
    }

    /// Both ends in order as crossings inside `range`, unless `skip` names their part.
    pub fn ends(self, range: Range, skip: Option<u32>) -> impl Iterator<Item = Crossing> {
        [self.enter, self.leave]
            .into_iter()
            .filter(move |&(t, part)| range.contains(t) && Some(part) != skip)
            .map(|(t, part)| Crossing::on_part(t, part))
    }
}

/// What a line has of a solid that it is inside of once, or all along but once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chord {
    pub span: Span,
    /// Whether the line is inside everywhere but in the span.
    pub beyond: bool,
}

impl Chord {
    pub const OUTSIDE: Chord = Chord { span: Span::NOWHERE, beyond: false };
    pub const INSIDE: Chord = Chord { span: Span::NOWHERE, beyond: true };

    /// The inside is in the span, or there is none.
    #[inline]
    pub fn within(span: Option<Span>) -> Chord {
        Chord { span: span.unwrap_or(Span::NOWHERE), beyond: false }
    }
}

/// Distances nearer to each other than this meet on an edge.
#[inline]
pub(super) fn tie(a: f64, b: f64) -> f64 {
    if a.is_finite() && b.is_finite() { 8.0 * EPSILON * a.abs().max(b.abs()) } else { 0.0 }
}

/// The part of `range` in which a ray may be inside a box: never less than that, more by a few roundings.
#[inline(always)]
pub(super) fn within(ray: &Ray, range: Range, bounds: &Aabb) -> Option<Range> {
    let inverse = ray.dir.recip();
    let size = ray.origin.abs() + bounds.min.abs().max(bounds.max.abs());
    let pad = 4.0 * EPSILON * size + f64::MIN_POSITIVE;
    let low = (bounds.min - pad - ray.origin) * inverse;
    let high = (bounds.max + pad - ray.origin) * inverse;
    let (near, far) = (low.min(high).max_element(), low.max(high).min_element());
    let near = (near - 4.0 * EPSILON * near.abs()).max(range.min);
    let far = (far + 4.0 * EPSILON * far.abs()).min(range.max);
    (near <= far).then(|| Range::new(near, far))
}

/// Where a coordinate that starts at `origin` and changes by `speed` lies in `min..=max`.
#[inline]
pub(super) fn slab(origin: f64, speed: f64, min: f64, max: f64) -> Option<(f64, f64)> {
    if speed == 0.0 {
        return (origin >= min && origin <= max).then_some((f64::NEG_INFINITY, f64::INFINITY));
    }
    let (a, b) = ((min - origin) / speed, (max - origin) / speed);
    Some(if speed > 0.0 { (a, b) } else { (b, a) })
}
