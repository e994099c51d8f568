//! Torus about the y axis: `(sqrt(x² + z²) - major)² + y² = minor²`.
//!
//! | parameter | unit | meaning |
//! |---|---|---|
//! | major | length | radius of the center circle |
//! | minor | length | radius of the tube; larger than `major` it makes a spindle |
//!
//! Along a ray the surface is a quartic, `(|p|² + R² - r²)² = 4 R² (x² + z²)`. For a spindle its roots
//! include the inner lemon; all of it is solid.
//!
//! Numerical care: the ray is cut to the box around the torus and the quartic is set up from its origin,
//! or, when that is far away, from the point nearest to the center. A crossing's point is moved onto the
//! tube.

use super::span::slab;
use super::{Crossing, Shape, rounding};
use crate::math::polynomial::{Roots, Touching, roots};
use crate::math::{Aabb, Range, Ray, Vec2, Vec3};
use std::f64::consts::PI;

#[derive(Clone, Debug, PartialEq)]
pub struct Torus {
    major: f64,
    minor: f64,
}

impl Torus {
    pub fn new(major: f64, minor: f64) -> Self {
        Self { major, minor }
    }

    /// The center circle's point nearest to `p`; for the lemon's points the one farthest away.
    fn core(&self, p: Vec3) -> Vec3 {
        let flat = Vec3::new(p.x, 0.0, p.z).normalize_or(Vec3::X) * self.major;
        let (near, far) = (p.distance(flat), p.distance(-flat));
        if (far - self.minor).abs() < (near - self.minor).abs() { -flat } else { flat }
    }

    fn distances(&self, ray: &Ray, range: Range) -> Roots {
        let Some((enter, leave)) = self.stretch(ray) else { return Roots::new() };
        let range = Range::new(range.min.max(enter), range.max.min(leave));
        if range.min >= range.max || self.is_missed(ray, enter, leave) {
            return Roots::new();
        }
        let reach = self.major.abs() + self.minor;
        let shift =
            if ray.origin.length_squared() > 16.0 * reach * reach { -ray.origin.dot(ray.dir) } else { 0.0 };
        let c = self.quartic(&Ray::new(ray.at(shift), ray.dir));
        let local = Range::new(range.min - shift, range.max - shift);
        let mut found = roots(&c, local, Touching::Skip);
        found.iter_mut().for_each(|t| *t += shift);
        found.retain(|t| range.contains(*t));
        found
    }

    /// Where the line is inside a box slightly larger than the torus.
    fn stretch(&self, ray: &Ray) -> Option<(f64, f64)> {
        let b = self.bounds().grown(1e-6 * (self.major.abs() + self.minor));
        let mut span = (f64::NEG_INFINITY, f64::INFINITY);
        for axis in 0..3 {
            let (near, far) = slab(ray.origin[axis], ray.dir[axis], b.min[axis], b.max[axis])?;
            span = (span.0.max(near), span.1.min(far));
        }
        (span.0 < span.1).then_some(span)
    }

    /// Whether the line goes through the hole or past the rim on its stretch through the box: the squared
    /// distance from the axis is largest at an end of the stretch, and least where its slope is zero.
    fn is_missed(&self, ray: &Ray, enter: f64, leave: f64) -> bool {
        const SLACK: f64 = 1e-6;
        let square = |t: f64| {
            let (x, z) = (ray.origin.x + t * ray.dir.x, ray.origin.z + t * ray.dir.z);
            x * x + z * z
        };
        let major = self.major.abs();
        let hole = (major - self.minor - SLACK * major).max(0.0);
        if square(enter).max(square(leave)) < hole * hole {
            return true;
        }
        let slope = ray.dir.x * ray.dir.x + ray.dir.z * ray.dir.z;
        let nearest = -(ray.origin.x * ray.dir.x + ray.origin.z * ray.dir.z) / slope;
        let rim = (major + self.minor) * (1.0 + SLACK);
        square(nearest.max(enter).min(leave)) > rim * rim
    }

    /// Lowest power first, for a unit direction.
    fn quartic(&self, ray: &Ray) -> [f64; 5] {
        let (o, d) = (ray.origin, ray.dir);
        let r2 = 4.0 * self.major * self.major;
        let k = o.length_squared() + (self.major - self.minor) * (self.major + self.minor);
        let b = o.dot(d);
        let (oo, od, dd) = (o.x * o.x + o.z * o.z, o.x * d.x + o.z * d.z, d.x * d.x + d.z * d.z);
        [k * k - r2 * oo, 4.0 * k * b - 2.0 * r2 * od, 4.0 * b * b + 2.0 * k - r2 * dd, 4.0 * b, 1.0]
    }
}

impl Shape for Torus {
    fn bounds(&self) -> Aabb {
        if self.minor <= 0.0 {
            return Aabb::EMPTY;
        }
        let wide = self.major.abs() + self.minor;
        let reach = Vec3::new(wide, self.minor, wide);
        Aabb { min: -reach, max: reach }
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        out.extend(self.distances(ray, range).into_iter().map(Crossing::new));
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        self.distances(ray, range).first().map(|&t| Crossing::new(t))
    }

    fn contains(&self, p: Vec3) -> bool {
        let across = p.x.hypot(p.z) - self.major;
        self.minor > 0.0 && across * across + p.y * p.y <= self.minor * self.minor
    }

    fn normal(&self, p: Vec3, _crossing: &Crossing) -> Vec3 {
        let near = Vec3::new(p.x, 0.0, p.z).normalize_or(Vec3::X) * self.major;
        (p - near).normalize_or(Vec3::Y)
    }

    fn face_normal(&self, p: Vec3, _crossing: &Crossing) -> Option<Vec3> {
        (self.minor > self.major.abs()).then(|| (p - self.core(p)).normalize_or(Vec3::Y))
    }

    fn locate(&self, ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        let p = ray.at(crossing.t);
        let core = self.core(p);
        let on = core + (p - core).normalize_or(Vec3::Y) * self.minor;
        let reach = self.major.abs() + self.minor;
        // The quartic's terms are of size reach⁴ where its slope is of size reach² times the tube.
        (on, rounding(4.0 * reach * (reach / self.minor).max(1.0)))
    }

    fn uv(&self, p: Vec3, _crossing: &Crossing) -> Option<Vec2> {
        let u = 1.0 - (p.z.atan2(p.x) + PI) / (2.0 * PI);
        let v = (p.y.atan2(p.x.hypot(p.z) - self.major) + PI) / (2.0 * PI);
        Some(Vec2::new(u, v))
    }

    fn kind(&self) -> &'static str {
        "torus"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_through_the_middle_meets_it_four_times() {
        let t = Torus::new(2.0, 0.25);
        let mut out = Vec::new();
        t.crossings(&Ray::new(Vec3::new(-50.0, 0.0, 0.0), Vec3::X), Range::FORWARD, &mut out);
        let xs: Vec<f64> = out.iter().map(|c| c.t - 50.0).collect();
        for (x, e) in xs.iter().zip([-2.25, -1.75, 1.75, 2.25]) {
            assert!((x - e).abs() < 1e-13, "{xs:?}");
        }
        assert_eq!(xs.len(), 4);
    }

    /// Lines that a box lets through are left out only where the quartic has no root either.
    #[test]
    fn no_crossing_is_left_out() {
        let mut random = crate::math::random::Lcg::new(5);
        let mut part = || f64::from(random.draw()) / 16383.5 - 1.0;
        let t = Torus::new(2.0, 0.3);
        let (mut left_out, mut met) = (0, 0);
        for _ in 0..20_000 {
            let origin = Vec3::new(part(), part(), part()) * 3.0;
            let ray = Ray::new(origin, Vec3::new(part(), part(), part()).normalize_or(Vec3::X));
            let Some((enter, leave)) = t.stretch(&ray) else { continue };
            let found = roots(&t.quartic(&ray), Range::new(enter, leave), Touching::Skip);
            if t.is_missed(&ray, enter, leave) {
                left_out += 1;
                assert!(found.is_empty(), "{ray:?} {found:?}");
            }
            met += usize::from(!found.is_empty());
        }
        assert!(left_out > 1000 && met > 1000, "{left_out} {met}");
    }

    #[test]
    fn without_a_tube_there_is_nothing() {
        let ray = Ray::new(Vec3::new(1.0, 3.0, 0.0), Vec3::NEG_Y);
        assert!(Torus::new(1.0, -0.25).nearest(&ray, Range::FORWARD).is_none());
        assert!(Torus::new(1.0, 0.0).nearest(&ray, Range::FORWARD).is_none());
    }
}
