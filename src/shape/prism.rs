//! Prism: a closed outline in the x-z plane, moved along y or blown up from the origin.
//!
//! | parameter | unit | default | meaning |
//! |---|---|---|---|
//! | pieces | length | | closed curves; an odd number of them around a point makes it inside |
//! | low, high | length | | where the ends are |
//! | sweep | – | linear | conic: at height y the section is y times the outline, which is the section at 1 |
//! | open | – | off | leaves the ends out; the inside stays |
//!
//! A linear prism's wall is met where the ray's trace in the x-z plane meets the outline; a conic one's where
//! the plane through the origin that holds the ray does. Both are a cubic in the outline's parameter.
//!
//! Both ends' normals are +y, as they always were. The sides' point outward where the outline runs
//! counter-clockwise, seen with x to the right and z up; for outlines of bezier pieces it is the other way
//! round.
//!
//! Numerical care: neighbouring pieces agree about the point where they meet, so no ray slips between them.

use super::curve::{Piece, surround};
use super::span::within;
use super::{COINCIDENT, Crossing, Shape, rounding};
use crate::math::{Aabb, Range, Ray, Vec2, Vec3};

/// Parts of the ends; the sides follow, one part for each piece.
pub(super) const LOW: u32 = 0;
pub(super) const HIGH: u32 = 1;
const SIDES: u32 = 2;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sweep {
    Linear,
    Conic,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Prism {
    pieces: Vec<Piece>,
    low: f64,
    high: f64,
    sweep: Sweep,
    open: bool,
    /// Corners of a box around the outline.
    corners: [Vec2; 2],
    bounds: Aabb,
}

impl Prism {
    pub(crate) fn new(pieces: Vec<Piece>, heights: [f64; 2], sweep: Sweep, open: bool) -> Self {
        let [a, b] = heights;
        let least = pieces.iter().fold(Vec2::INFINITY, |m, p| m.min(p.min));
        let most = pieces.iter().fold(Vec2::NEG_INFINITY, |m, p| m.max(p.max));
        let (low, high) = (a.min(b), a.max(b));
        let section = |y: f64, k: f64| {
            Aabb::new(Vec3::new(k * least.x, y, k * least.y), Vec3::new(k * most.x, y, k * most.y))
        };
        let bounds = match sweep {
            Sweep::Linear => section(low, 1.0).union(section(high, 1.0)),
            Sweep::Conic => section(low, low).union(section(high, high)),
        };
        Self { pieces, low, high, sweep, open, corners: [least, most], bounds }
    }

    /// Coefficients of the line in the outline's plane that a ray meets the sides along.
    fn trace(&self, ray: &Ray) -> (f64, f64, f64) {
        let (o, d) = (ray.origin, ray.dir);
        match self.sweep {
            Sweep::Linear => (d.z, -d.x, o.z * d.x - o.x * d.z),
            Sweep::Conic => {
                let m = o.cross(d);
                (m.x, m.z, m.y)
            }
        }
    }

    /// Distance at which the ray meets the line above the outline's point `p`.
    fn distance(&self, ray: &Ray, p: Vec2) -> f64 {
        let (o, d) = (ray.origin, ray.dir);
        match self.sweep {
            Sweep::Linear => {
                let across = Vec2::new(d.x, d.z);
                (p - Vec2::new(o.x, o.z)).dot(across) / across.length_squared()
            }
            Sweep::Conic => {
                let along = Vec3::new(p.x, 1.0, p.y);
                let across = d.cross(along);
                -o.cross(along).dot(across) / across.length_squared()
            }
        }
    }

    /// The place in the outline that stands for a point.
    fn section(&self, p: Vec3) -> Vec2 {
        let q = Vec2::new(p.x, p.z);
        match self.sweep {
            Sweep::Linear => q,
            Sweep::Conic => q / p.y,
        }
    }

    /// Calls `found` with crossings; it says up to where more are wanted.
    fn visit(&self, ray: &Ray, range: Range, mut found: impl FnMut(Crossing) -> f64) {
        let (o, d) = (ray.origin.y, ray.dir.y);
        let (a, b, c) = self.trace(ray);
        let Some(way) = within(ray, range, &self.bounds) else { return };
        let on_the_way = self.sections(ray, way);
        let mut wanted = range;
        if (a != 0.0 || b != 0.0) && self.corners_part(a, b, c) {
            for (i, piece) in self.pieces.iter().enumerate() {
                let [least, most] = on_the_way;
                let beside = piece.max.cmplt(least).any() || piece.min.cmpgt(most).any();
                if beside || !piece.may_cross(a, b, c) {
                    continue;
                }
                for w in piece.crossings(a, b, c) {
                    let t = self.distance(ray, piece.at(w));
                    let height = o + t * d;
                    if range.contains(t) && height >= self.low && height <= self.high {
                        let uv = Vec2::new(w, 0.0);
                        wanted.max =
                            wanted.max.min(found(Crossing { t, part: SIDES + i as u32, uv }).next_up());
                    }
                }
            }
        }
        if self.open || d == 0.0 {
            return;
        }
        for (part, height) in [(LOW, self.low), (HIGH, self.high)] {
            let t = (height - o) / d;
            let is_apex = self.sweep == Sweep::Conic && height == 0.0;
            if !is_apex && wanted.contains(t) && self.holds(self.section(ray.at(t).with_y(height))) {
                wanted.max = wanted.max.min(found(Crossing::on_part(t, part)).next_up());
            }
        }
    }

    /// Corners of a box in the outline's plane around what stands for a part of a ray.
    fn sections(&self, ray: &Ray, way: Range) -> [Vec2; 2] {
        let ends = [way.min, way.max].map(|t| ray.at(t));
        // Through the apex the way has no ends in the outline's plane.
        let apex = self.sweep == Sweep::Conic && !(ends[0].y * ends[1].y > 0.0);
        let (a, b) = (self.section(ends[0]), self.section(ends[1]));
        if apex || !(a.is_finite() && b.is_finite()) {
            return [Vec2::NEG_INFINITY, Vec2::INFINITY];
        }
        let nearest = if self.sweep == Sweep::Conic { ends[0].y.abs().min(ends[1].y.abs()) } else { 1.0 };
        let far = ray.origin.abs().max_element() + way.max.abs();
        let slack = 1e-9 * (a.abs() + b.abs()).max_element() + rounding(64.0 * far) / nearest;
        [a.min(b) - slack, a.max(b) + slack]
    }

    /// Whether a line in the outline's plane passes the box around the outline.
    fn corners_part(&self, a: f64, b: f64, c: f64) -> bool {
        let [least, most] = self.corners;
        let (middle, half) = (0.5 * (least + most), 0.5 * (most - least));
        let reach = a.abs() * half.x + b.abs() * half.y;
        let size = a.abs() * middle.x.abs() + b.abs() * middle.y.abs() + c.abs() + reach;
        (a * middle.x + b * middle.y + c).abs() <= reach + rounding(size)
    }

    /// Whether the outline holds a point.
    fn holds(&self, p: Vec2) -> bool {
        let [least, most] = self.corners;
        p.cmpge(least).all() && p.cmple(most).all() && surround(&self.pieces, p)
    }

    fn size(&self) -> f64 {
        let b = self.bounds();
        b.min.abs().max(b.max.abs()).max_element()
    }
}

impl Shape for Prism {
    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        self.visit(ray, range, |c| {
            out.push(c);
            f64::INFINITY
        });
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let mut best: Option<Crossing> = None;
        self.visit(ray, range, |c| {
            if best.is_none_or(|b| c.t <= b.t) {
                best = Some(c);
            }
            best.map_or(c.t, |b| b.t)
        });
        best
    }

    fn contains(&self, p: Vec3) -> bool {
        let margin = COINCIDENT * (self.high - self.low);
        p.y >= self.low - margin && p.y < self.high - margin && self.holds(self.section(p))
    }

    fn normal(&self, p: Vec3, crossing: &Crossing) -> Vec3 {
        if crossing.part < SIDES {
            return Vec3::Y;
        }
        let slope = self.pieces[(crossing.part - SIDES) as usize].slope(crossing.uv.x);
        let (x, z) = (slope.y, -slope.x);
        let y = match self.sweep {
            Sweep::Linear => 0.0,
            Sweep::Conic => -(p.x * x + p.z * z) / p.y,
        };
        Vec3::new(x, y, z).normalize_or(Vec3::Y)
    }

    fn locate(&self, ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        let p = ray.at(crossing.t);
        let p = match crossing.part {
            LOW => p.with_y(self.low),
            HIGH => p.with_y(self.high),
            side => {
                let q = self.pieces[(side - SIDES) as usize].at(crossing.uv.x);
                let scale = if self.sweep == Sweep::Conic { p.y } else { 1.0 };
                Vec3::new(scale * q.x, p.y, scale * q.y)
            }
        };
        (p, rounding(4.0 * self.size()))
    }

    fn kind(&self) -> &'static str {
        "prism"
    }

    fn heap_bytes(&self) -> usize {
        self.pieces.capacity() * size_of::<Piece>()
    }
}
