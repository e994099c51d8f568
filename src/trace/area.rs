//! The soft shadow of an area light: lamps of its grid are tested, corners first, and quarters of the grid
//! where corners differ or where `adaptive` asks for it.

use super::path::{Departure, Interiors};
use super::tracer::Tracer;
use crate::color::Rgb;
use crate::light::{AreaLight, Arrival};
use crate::math::Vec3;
use crate::world::{RayClass, WorldLight};

/// Corners that differ by more than this (sum of components) are looked at closely.
const CONTRAST: f32 = 0.1;

/// Marks a lamp that has not been tested.
const UNTESTED: f32 = f32::NAN;

/// A part of the grid, ends included.
#[derive(Clone, Copy)]
struct Part {
    u: (u32, u32),
    v: (u32, u32),
}

impl Part {
    /// The four quarters, which overlap in the middle line of an odd side.
    fn quarters(self) -> [Part; 4] {
        let halves = |(a, b): (u32, u32)| ((a, (a + b) / 2), ((a + b).div_ceil(2), b));
        let ((ul, uh), (vl, vh)) = (halves(self.u), halves(self.v));
        [Part { u: ul, v: vl }, Part { u: uh, v: vl }, Part { u: ul, v: vh }, Part { u: uh, v: vh }]
    }

    fn is_wide(self) -> bool {
        self.u.1 - self.u.0 > 1 || self.v.1 - self.v.0 > 1
    }
}

/// What stays the same for all lamps of one light at one point.
struct Exposure<'a> {
    departure: &'a Departure,
    inside: &'a Interiors,
    source: &'a WorldLight,
    area: &'a AreaLight,
    axes: (Vec3, Vec3),
    /// The light's colour before shadows.
    color: Rgb,
}

impl Tracer<'_> {
    /// Whether area lights are more than points for rays of `class`.
    pub(super) fn uses_area(&self, class: RayClass) -> bool {
        self.settings.quality >= 5 && class != RayClass::Radiosity
    }

    /// The mean shadowed colour over the lamps.
    pub(super) fn area_shadowed(
        &mut self,
        departure: &Departure,
        inside: &Interiors,
        source: &WorldLight,
        area: &AreaLight,
        arrival: &Arrival,
    ) -> Rgb {
        let lamps = area.size1 as usize * area.size2 as usize;
        self.lamps.clear();
        self.lamps.resize(lamps, Rgb::splat(UNTESTED));
        let axes = area.axes(arrival.direction);
        let exposure = Exposure { departure, inside, source, area, axes, color: arrival.color };
        let whole = Part { u: (0, area.size1 - 1), v: (0, area.size2 - 1) };
        self.part(&exposure, whole, 0)
    }

    fn part(&mut self, e: &Exposure, part: Part, level: u32) -> Rgb {
        let (u, v) = (part.u, part.v);
        let mut corners = [(u.0, v.0), (u.1, v.0), (u.0, v.1), (u.1, v.1)].map(|(u, v)| self.lamp(e, u, v));
        if part.is_wide() && (level < e.area.adaptive || has_contrast(&corners)) {
            for (corner, quarter) in corners.iter_mut().zip(part.quarters()) {
                *corner = self.part(e, quarter, level + 1);
            }
        }
        corners.iter().sum::<Rgb>() * 0.25
    }

    /// The shadowed colour of one lamp, tested once.
    fn lamp(&mut self, e: &Exposure, u: u32, v: u32) -> Rgb {
        let place = (v * e.area.size1 + u) as usize;
        if !self.lamps[place].x.is_nan() {
            return self.lamps[place];
        }
        let (u, v) = self.lamp_place(e.area.jitter, u, v);
        let offset = e.area.offset(e.axes, u, v);
        let (direction, distance) = e.source.light.towards(e.departure.point, offset);
        let ray = e.departure.ray(direction);
        let color = self.transmitted(&ray, distance, e.inside, e.source, e.color);
        self.lamps[place] = color;
        color
    }

    /// The lamp's place in the grid, shaken if the light says so.
    pub(super) fn lamp_place(&mut self, jitter: bool, u: u32, v: u32) -> (f64, f64) {
        let mut shift = || if jitter { self.random.draw() - 0.5 } else { 0.0 };
        (f64::from(u) + shift(), f64::from(v) + shift())
    }
}

/// Whether two corners side by side differ.
fn has_contrast(c: &[Rgb; 4]) -> bool {
    [(0, 1), (1, 3), (3, 2), (2, 0)].iter().any(|&(a, b)| (c[a] - c[b]).abs().element_sum() > CONTRAST)
}
