//! Ovus: two spheres joined by a part of a torus-like surface, like an egg.
//!
//! | parameter | unit | meaning |
//! |---|---|---|
//! | bottom_radius | length | of the sphere about the origin |
//! | top_radius | length | of the sphere about (0, bottom_radius, 0), less than twice the other |
//!
//! The joint turns an arc of radius K about the y axis, whose center lies at height V and at distance H on
//! the far side: `(rho + H)² + (y - V)² = K²` for heights between where it touches the two spheres.
//!
//! Numerical care: the solid is convex, so a line is inside between the first and the last crossing that
//! any of the three parts has, and none can be lost where two parts meet.

use super::sphere::{sphere_span, turn_about_y};
use super::{COINCIDENT, Crossing, Shape, rounding};
use crate::math::polynomial::{Touching, roots};
use crate::math::{Aabb, Range, Ray, Vec2, Vec3};
use std::f64::consts::PI;

const BOTTOM: u32 = 0;
const TOP: u32 = 1;
const JOINT: u32 = 2;

#[derive(Clone, Debug, PartialEq)]
pub struct Ovus {
    bottom: f64,
    top: f64,
    joint: Option<Joint>,
}

#[derive(Clone, Debug, PartialEq)]
struct Joint {
    /// Radius of the arc.
    arc: f64,
    /// Distance of its center from the axis, on the far side.
    far: f64,
    /// Height of its center.
    height: f64,
    /// Heights where it meets the bottom and the top sphere.
    low: f64,
    high: f64,
}

impl Joint {
    fn new(bottom: f64, top: f64) -> Self {
        if top < bottom {
            let arc = 2.0 * bottom;
            let height = 2.0 * top - bottom - top * top / (2.0 * bottom);
            let far = (bottom * bottom - height * height).max(0.0).sqrt();
            let high = (bottom - height) * top / (arc - top) + bottom;
            return Self { arc, far, height, low: -height, high };
        }
        let arc = 2.0 * top;
        let height = -2.0 * top + bottom + 1.5 * top * top / bottom;
        let far = (top * top - (height - bottom) * (height - bottom)).max(0.0).sqrt();
        Self { arc, far, height, low: -height * bottom / (arc - bottom), high: 2.0 * bottom - height }
    }

    /// The part of a line next to the surface: in its heights, and no further from the axis than it gets.
    fn span(&self, ray: &Ray, slack: f64) -> Option<(f64, f64)> {
        let slack = 1e-6 * self.arc + slack;
        let (mut from, mut to) = (f64::NEG_INFINITY, f64::INFINITY);
        let (o, d) = (ray.origin, ray.dir);
        if d.y != 0.0 {
            let ends = [self.low - slack, self.high + slack].map(|y| (y - o.y) / d.y);
            (from, to) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        } else if o.y < self.low - slack || o.y > self.high + slack {
            return None;
        }
        let widest = self.arc - self.far + slack;
        let (across, along) = (o.x * d.x + o.z * d.z, d.x * d.x + d.z * d.z);
        if along > 0.0 {
            let middle = -across / along;
            let (x, z) = (o.x + middle * d.x, o.z + middle * d.z);
            let half = ((widest * widest - x * x - z * z) / along).sqrt();
            if half.is_nan() {
                return None;
            }
            (from, to) = (from.max(middle - half), to.min(middle + half));
        }
        (from < to).then_some((from, to))
    }

    /// Distance from the arc's center, seen in the plane of the axis and `p`.
    fn reach(&self, p: Vec3) -> f64 {
        (p.x.hypot(p.z) + self.far).hypot(p.y - self.height)
    }
}

impl Ovus {
    /// Radii that are not negative. From twice the bottom radius on, the top sphere holds everything.
    pub fn new(bottom: f64, top: f64) -> Self {
        let joint = (top < 2.0 * bottom).then(|| Joint::new(bottom, top));
        Self { bottom, top, joint }
    }

    fn top_center(&self) -> Vec3 {
        self.bottom * Vec3::Y
    }

    fn size(&self) -> f64 {
        self.bottom + self.top
    }

    /// The first and the last crossing of the line.
    fn ends(&self, ray: &Ray) -> Option<[Crossing; 2]> {
        let mut ends: Option<[Crossing; 2]> = None;
        let mut add = |t: f64, part: u32| {
            let c = Crossing::on_part(t, part);
            ends = Some(match ends {
                None => [c, c],
                Some([a, b]) => [if t < a.t { c } else { a }, if t > b.t { c } else { b }],
            });
        };
        let slack = COINCIDENT * self.size();
        let (low, high) = match &self.joint {
            None => (f64::NEG_INFINITY, f64::NEG_INFINITY),
            Some(j) => (j.low, j.high),
        };
        let mut sphere = |center: Vec3, radius: f64, part: u32| {
            let Some((t0, t1)) = sphere_span(ray.origin - center, ray.dir, radius) else { return };
            for t in [t0, t1] {
                let y = ray.origin.y + t * ray.dir.y;
                if if part == BOTTOM { y <= low + slack } else { y >= high - slack } {
                    add(t, part);
                }
            }
        };
        sphere(Vec3::ZERO, self.bottom, BOTTOM);
        sphere(self.top_center(), self.top, TOP);
        if let Some(joint) = &self.joint {
            self.joint_roots(joint, ray, |t| add(t, JOINT));
        }
        ends
    }

    fn joint_roots(&self, joint: &Joint, ray: &Ray, mut add: impl FnMut(f64)) {
        let o = ray.origin - joint.height * Vec3::Y;
        let shift = -o.dot(ray.dir);
        let near = o + shift * ray.dir;
        let c = arc_quartic(joint, near, ray.dir);
        let size = 2.0 * (self.size() + joint.arc);
        let slack = COINCIDENT * self.size();
        let Some((from, to)) = joint.span(ray, slack) else { return };
        for s in roots(&c, Range::new((from - shift).max(-size), (to - shift).min(size)), Touching::Skip) {
            let t = s + shift;
            let p = ray.at(t);
            // The quartic has the mirrored arc as well.
            let own = (joint.reach(p) - joint.arc).abs() < 1e-6 * joint.arc;
            if own && p.y >= joint.low - slack && p.y <= joint.high + slack {
                add(t);
            }
        }
    }
}

/// `(|p|² + H² - K²)² - 4 H² (x² + z²)` along a line, lowest power first.
fn arc_quartic(joint: &Joint, o: Vec3, d: Vec3) -> [f64; 5] {
    let h2 = 4.0 * joint.far * joint.far;
    let k = o.length_squared() + (joint.far - joint.arc) * (joint.far + joint.arc);
    let b = o.dot(d);
    let (oo, od, dd) = (o.x * o.x + o.z * o.z, o.x * d.x + o.z * d.z, d.x * d.x + d.z * d.z);
    [k * k - h2 * oo, 4.0 * k * b - 2.0 * h2 * od, 4.0 * b * b + 2.0 * k - h2 * dd, 4.0 * b, 1.0]
}

impl Shape for Ovus {
    fn bounds(&self) -> Aabb {
        let (mut low, mut wide) = ((self.bottom - self.top).min(-self.bottom), self.bottom.max(self.top));
        if self.joint.is_none() {
            (low, wide) = (self.bottom - self.top, self.top);
        }
        if let Some(j) = &self.joint
            && j.height > j.low
            && j.height < j.high
        {
            wide = wide.max(j.arc - j.far);
        }
        let margin = rounding(self.size());
        let low = if self.joint.is_some() { -self.bottom } else { low };
        Aabb {
            min: Vec3::new(-wide, low, -wide) - margin,
            max: Vec3::new(wide, self.bottom + self.top, wide) + margin,
        }
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        if let Some(ends) = self.ends(ray) {
            out.extend(ends.into_iter().filter(|c| range.contains(c.t)));
        }
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        self.ends(ray)?.into_iter().find(|c| range.contains(c.t))
    }

    fn contains(&self, p: Vec3) -> bool {
        let within = |center: Vec3, r: f64| p.distance_squared(center) < r * r;
        if within(self.top_center(), self.top) || (self.joint.is_some() && within(Vec3::ZERO, self.bottom)) {
            return true;
        }
        self.joint.as_ref().is_some_and(|j| p.y > j.low && p.y < j.high && j.reach(p) < j.arc)
    }

    fn normal(&self, p: Vec3, crossing: &Crossing) -> Vec3 {
        match (crossing.part, &self.joint) {
            (JOINT, Some(j)) => {
                let out = Vec3::new(p.x, 0.0, p.z).normalize_or(Vec3::X);
                (p + j.far * out - j.height * Vec3::Y).normalize_or(Vec3::Y)
            }
            (BOTTOM, _) => p.normalize_or(Vec3::NEG_Y),
            _ => (p - self.top_center()).normalize_or(Vec3::Y),
        }
    }

    fn locate(&self, ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        let p = ray.at(crossing.t);
        let n = self.normal(p, crossing);
        let on = match (crossing.part, &self.joint) {
            (JOINT, Some(j)) => p + (j.arc - j.reach(p)) * n,
            (BOTTOM, _) => self.bottom * n,
            _ => self.top_center() + self.top * n,
        };
        let arc = self.joint.as_ref().map_or(0.0, |j| j.arc + j.far);
        (on, rounding(16.0 * (self.size() + arc)))
    }

    fn uv(&self, p: Vec3, _crossing: &Crossing) -> Option<Vec2> {
        let q = (p - 0.5 * self.top * Vec3::Y).normalize_or(Vec3::Y);
        Some(Vec2::new(turn_about_y(q), 0.5 + q.y.clamp(-1.0, 1.0).asin() / PI))
    }

    fn kind(&self) -> &'static str {
        "ovus"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_egg_is_slightly_wider_than_its_bottom_sphere() {
        let b = Ovus::new(1.0, 0.65).bounds();
        assert!((b.max.x - 1.003946).abs() < 1e-6 && (b.max.y - 1.65).abs() < 1e-12);
        assert!((b.min.y + 1.0).abs() < 1e-12);
    }

    #[test]
    fn a_large_top_is_just_a_sphere() {
        let o = Ovus::new(0.4, 0.9);
        let ray = Ray::new(Vec3::new(0.0, -3.0, 0.0), Vec3::Y);
        assert!((o.nearest(&ray, Range::FORWARD).unwrap().t - 2.5).abs() < 1e-15);
    }
}
