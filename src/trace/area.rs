//! The soft shadow of an area light: lamps of its grid are tested, corners first, and quarters of the grid
//! where corners differ or where `adaptive` asks for it.

use super::media::Worth;
use super::path::{Departure, Interiors};
use super::tracer::Tracer;
use crate::color::Rgb;
use crate::light::{AreaLight, Arrival};
use crate::math::{Aabb, Shaft, Vec3};
use crate::world::{Between, RayClass, WorldLight};

/// Corners that differ by more than this (sum of components) are looked at closely.
const CONTRAST: f32 = 0.1;

/// Lamps that a point looks at for the truth.
const REFERENCE_LAMPS: u32 = 16;

/// Lights of fewer lamps are always tested as a whole.
const SPARSE_FROM: usize = 16;
/// One lamp of so many is tested where corners agree.
const SPARSE_SHARE: u32 = 12;

/// One lamp of so many is tested from a place in media: those of neighbouring places add up.
const SCATTERED_SHARE: u32 = 4;

/// Lights of fewer lamps look into uneven media for each, and are tested as a whole from places in media.
const SHARE_FROM: usize = 9;

/// So many lamps share one look into the media.
const SHARED_BY: usize = super::shared_dimming::SHARE as usize;

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

    /// Whether so many subdivisions reach every lamp.
    fn takes_all(self, levels: u32) -> bool {
        let side = (self.u.1 - self.u.0).max(self.v.1 - self.v.0);
        1u64.checked_shl(levels).is_none_or(|reached| reached >= u64::from(side))
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
    way: Way,
    /// What stands between the point and any lamp, if [`Way::Known`].
    between: Between,
}

/// What is known of the way to all lamps.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Way {
    Unknown,
    Known,
    /// Nothing is there.
    Clear,
}

/// Lights of fewer lamps are tested ray by ray.
const SHAFT_FROM: usize = 4;

impl Tracer<'_> {
    /// Whether area lights are more than points for rays of `class`.
    pub(super) fn uses_area(&self, class: RayClass) -> bool {
        self.settings.quality >= 5 && (class != RayClass::Radiosity || self.settings.overrides.reference)
    }

    /// The mean shadowed colour over the lamps.
    pub(super) fn area_shadowed(
        &mut self,
        departure: &Departure,
        inside: &Interiors,
        source: &WorldLight,
        area: &AreaLight,
        arrival: &Arrival,
        class: RayClass,
    ) -> Rgb {
        let lamps = area.size1 as usize * area.size2 as usize;
        let axes = area.axes(arrival.direction);
        let mut between = std::mem::take(&mut self.between);
        let way = if lamps < SHAFT_FROM {
            Way::Unknown
        } else {
            self.way_to_lamps(departure, source, area.reach(axes), &mut between)
        };
        let exposure = Exposure { departure, inside, source, area, axes, color: arrival.color, way, between };
        let color = self.mean_over_lamps(&exposure, lamps, class);
        self.between = exposure.between;
        color
    }

    /// Whatever stands between a place and the box that holds all lamps. They are to be on one side of the
    /// surface: then all rays start at one point.
    fn way_to_lamps(
        &self,
        departure: &Departure,
        source: &WorldLight,
        reach: Vec3,
        between: &mut Between,
    ) -> Way {
        let light = &source.light;
        if !light.is_aimed_at() || source.projected_through.is_some() {
            return Way::Unknown;
        }
        let center = light.location - departure.point;
        let height = center.dot(departure.normal);
        if departure.error > 0.0 && height.abs() <= 1.001 * departure.normal.abs().dot(reach) {
            return Way::Unknown;
        }
        let start = departure.ray(center).origin;
        // Rays end as far beside their lamps as they start beside the surface.
        let aside = reach + (start - departure.point).abs();
        let ends = Aabb { min: light.location - aside, max: light.location + aside };
        match self.world.stands_between(&Shaft::new(start, &ends), between) {
            false => Way::Unknown,
            true if between.is_empty() && !self.dims(light) => Way::Clear,
            true => Way::Known,
        }
    }

    fn mean_over_lamps(&mut self, exposure: &Exposure, lamps: usize, class: RayClass) -> Rgb {
        self.lamps.clear();
        self.lamps.resize(lamps, Rgb::splat(UNTESTED));
        let few = match (self.settings.overrides.reference, class) {
            (true, RayClass::Radiosity) => Some(1),
            (true, _) => Some(REFERENCE_LAMPS),
            _ if self.scatters && lamps >= SHARE_FROM => Some((lamps as u32 / SCATTERED_SHARE).max(2)),
            _ => self.settings.overrides.area_samples,
        };
        if let Some(few) = few.filter(|&n| (n as usize) < lamps) {
            self.shadow_worth = self.shadow_worth.shared(few as usize);
            return self.few_lamps(exposure, few.max(1));
        }
        let shares = self.needs.clouds && lamps >= SHARE_FROM && !self.settings.overrides.reference;
        if shares {
            let first = self.random.draw();
            self.shared_dimming.begin(first);
            let worth = self.shadow_worth;
            let whole = if worth.is_known() { worth } else { Worth::at_surface(exposure.color) };
            self.shadow_worth = whole.shared(lamps / SHARED_BY);
        }
        let color = self.all_lamps(exposure, lamps);
        self.shared_dimming.end();
        color
    }

    /// The mean over all lamps, or over a few where that does.
    fn all_lamps(&mut self, exposure: &Exposure, lamps: usize) -> Rgb {
        let area = exposure.area;
        let whole = Part { u: (0, area.size1 - 1), v: (0, area.size2 - 1) };
        if self.settings.sparse_lamps && lamps >= SPARSE_FROM && whole.takes_all(area.adaptive) {
            return self.sparsely(exposure, whole);
        }
        self.part(exposure, whole, 0)
    }

    /// The same in the mean over many samples. The edge of whatever is large passes over a corner before it
    /// passes over any other lamp: where corners agree, a few lamps by chance speak for all.
    fn sparsely(&mut self, e: &Exposure, whole: Part) -> Rgb {
        let (u, v) = (whole.u, whole.v);
        let corners = [(u.0, v.0), (u.1, v.0), (u.0, v.1), (u.1, v.1)].map(|(u, v)| self.lamp(e, u, v));
        if has_contrast(&corners) {
            return self.part(e, whole, 0);
        }
        self.few_lamps(e, (e.area.size1 * e.area.size2 / SPARSE_SHARE).max(2))
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
        if e.way == Way::Clear {
            self.lamps[place] = e.color;
            return e.color;
        }
        let offset = e.area.offset(e.axes, u, v);
        let (direction, distance) = e.source.light.towards(e.departure.point, offset);
        let ray = e.departure.ray(direction);
        self.shared_dimming.next_lamp();
        let color = if e.way == Way::Known {
            self.transmitted_past(&ray, distance, e.inside, e.source, e.color, |world, ray, range, _, _| {
                world.obstacle_between(&e.between, ray, range)
            })
        } else {
            self.transmitted(&ray, distance, e.inside, e.source, e.color)
        };
        self.lamps[place] = color;
        color
    }

    /// The mean over some lamps, each as likely as it weighs in the mean over all. They are spread over the
    /// grid by a shifted Hammersley set.
    fn few_lamps(&mut self, e: &Exposure, few: u32) -> Rgb {
        let (first, second) = (self.random.draw(), self.random.draw());
        let mut sum = Rgb::ZERO;
        for i in 0..few {
            let across = (f64::from(i) / f64::from(few) + first).fract();
            let along = (f64::from(i.reverse_bits()) / 4_294_967_296.0 + second).fract();
            sum += self.lamp(e, weighted(across, e.area.size1), weighted(along, e.area.size2));
        }
        sum / few as f32
    }

    /// The lamp's place in the grid, shaken if the light says so.
    pub(super) fn lamp_place(&mut self, jitter: bool, u: u32, v: u32) -> (f64, f64) {
        let mut shift = || if jitter { self.random.draw() - 0.5 } else { 0.0 };
        (f64::from(u) + shift(), f64::from(v) + shift())
    }
}

/// The lamp of a row at which a number in 0..1 arrives if halves of the row are as likely as they weigh in
/// [`Tracer::part`]: equally, whether or not they share the middle lamp.
fn weighted(mut x: f64, size: u32) -> u32 {
    let (mut a, mut b) = (0, size - 1);
    while a < b {
        x *= 2.0;
        let right = x >= 1.0;
        x -= f64::from(u8::from(right));
        (a, b) = match (b - a > 1, right) {
            (true, false) => (a, (a + b) / 2),
            (true, true) => ((a + b).div_ceil(2), b),
            (false, false) => (a, a),
            (false, true) => (b, b),
        };
    }
    a
}

/// Whether two corners side by side differ.
fn has_contrast(c: &[Rgb; 4]) -> bool {
    [(0, 1), (1, 3), (3, 2), (2, 0)].iter().any(|&(a, b)| (c[a] - c[b]).abs().element_sum() > CONTRAST)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// How much each lamp of a row weighs in the mean over all.
    fn weights(size: u32) -> Vec<f64> {
        fn part(a: u32, b: u32, weight: f64, out: &mut [f64]) {
            if b - a > 1 {
                part(a, (a + b) / 2, weight / 2.0, out);
                part((a + b).div_ceil(2), b, weight / 2.0, out);
            } else {
                out[a as usize] += weight / 2.0;
                out[b as usize] += weight / 2.0;
            }
        }
        let mut out = vec![0.0; size as usize];
        part(0, size - 1, 1.0, &mut out);
        out
    }

    #[test]
    fn lamps_are_as_likely_as_they_weigh() {
        for size in [1, 2, 3, 5, 8, 9] {
            let n = 1 << 12;
            let mut counts = vec![0.0; size as usize];
            for i in 0..n {
                counts[weighted((f64::from(i) + 0.5) / f64::from(n), size) as usize] += 1.0 / f64::from(n);
            }
            assert_eq!(counts, weights(size), "{size}");
        }
        assert_eq!(weights(3), [0.25, 0.5, 0.25]);
    }

    #[test]
    fn levels_that_reach_every_lamp() {
        let row = |size: u32| Part { u: (0, size - 1), v: (0, 0) };
        assert!(row(2).takes_all(0) && row(3).takes_all(1) && row(9).takes_all(3) && row(9).takes_all(100));
        assert!(!row(3).takes_all(0) && !row(9).takes_all(2) && !row(6).takes_all(2));
    }

    /// A room's floor under a lamp of 8x8 with a ball and a thin bar between: the mean over many samples is
    /// that of all lamps.
    #[test]
    fn chance_agrees_with_all_lamps_in_the_mean() {
        let text = "#version 3.7; global_settings { assumed_gamma 1 }
            camera { orthographic location 5*y look_at 0 right 4*x up 4*z }
            light_source { 4*y rgb 1 area_light 2*x, 2*z, 8, 8 }
            plane { y, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
            sphere { <-0.8, 1.5, 0>, 0.4 } cylinder { <1, 2, -2>, <1, 2, 2>, 0.03 }";
        let source = crate::interp::SceneSource::Text { name: "room".into(), text: text.into() };
        let scene = crate::interp::interpret(source, &Default::default()).scene.unwrap();
        let world = crate::world::World::prepare(scene);
        let settings = crate::trace::Settings { width: 16, height: 16, ..Default::default() };
        let sparse = crate::trace::Settings { sparse_lamps: true, ..settings.clone() };
        let (mut all, mut few) = (Tracer::new(&world, &settings), Tracer::new(&world, &sparse));
        for i in 0..256u32 {
            let (x, y) = (i % 16, i / 16);
            let place = (f64::from(x) + 0.5, f64::from(y) + 0.5);
            let exact = all.pixel(place.0, place.1).rgb.x;
            let n = 200;
            let mut mean = 0.0;
            for k in 0..n {
                few.seed(x, y, k);
                mean += few.pixel(place.0, place.1).rgb.x / n as f32;
            }
            assert!((mean - exact).abs() < 0.04, "{x} {y}: {mean} {exact}");
        }
        assert!(few.counters().shadow_rays < 200 * all.counters().shadow_rays / 2);
    }
}
