//! Parametric surface: the points (fx(u, v), fy(u, v), fz(u, v)) inside a container.
//!
//! | parameter | unit | default | meaning |
//! |---|---|---|---|
//! | functions | length | | of u and v |
//! | domain | – | | a rectangle of parameters |
//! | contained_by | length | the box from -1 to 1 | |
//! | accuracy | – | 0.001 | size of the smallest rectangle, step of the normal's differences |
//! | max_gradient | – | 1 | bound on the functions' slopes; too small a one makes holes |
//!
//! The rectangle is halved again and again; halves whose bounds, from the corner values and the slopes'
//! bound, the ray cannot meet are left out. The crossing is at the near side of the bounds of the last
//! rectangle, whose first corner gives the parameters. One crossing of a ray is found, and none within four
//! times the accuracy of its start. Never an inside.
//!
//! Numerical care: the accuracy is the scene's; the crossing lies within it. The point is not moved onto
//! the surface.

use super::{Container, Crossing, Shape};
use crate::math::field::Field;
use crate::math::{Aabb, Range, Ray, Vec2, Vec3};
use smallvec::SmallVec;
use std::sync::Arc;

/// Directions with a component smaller than this run along its coordinate planes.
const PARALLEL: f64 = 1e-10;
/// A rectangle is never halved more often.
const MAX_DEPTH: u32 = 120;

#[derive(Clone, Debug)]
pub struct Parametric {
    pub functions: [Arc<dyn Field>; 3],
    pub low: Vec2,
    pub high: Vec2,
    pub container: Container,
    pub accuracy: f64,
    pub max_gradient: f64,
}

/// A rectangle of parameters with the surface's points at its corners: (u0, v0), (u0, v1), (u1, v0), (u1, v1).
#[derive(Clone, Copy)]
struct Rectangle {
    low: Vec2,
    high: Vec2,
    corners: [Vec3; 4],
    depth: u32,
}

/// The best crossing so far while a ray is followed.
struct Search<'a> {
    ray: &'a Ray,
    from: f64,
    to: f64,
    best: Option<(f64, Vec2)>,
}

impl Parametric {
    fn at(&self, uv: Vec2) -> Vec3 {
        let p = Vec3::new(uv.x, uv.y, 0.0);
        Vec3::new(self.functions[0].value(p), self.functions[1].value(p), self.functions[2].value(p))
    }

    fn rectangle(&self, low: Vec2, high: Vec2) -> Rectangle {
        let corners = [low, Vec2::new(low.x, high.y), Vec2::new(high.x, low.y), high].map(|uv| self.at(uv));
        Rectangle { low, high, corners, depth: 0 }
    }

    /// The two halves along the longer side, the lower one first.
    fn halves(&self, r: &Rectangle) -> [Rectangle; 2] {
        let size = r.high - r.low;
        let middle = 0.5 * (r.low + r.high);
        let depth = r.depth + 1;
        let [a, b, c, d] = r.corners;
        if size.x >= size.y {
            let (near, far) = (Vec2::new(middle.x, r.low.y), Vec2::new(middle.x, r.high.y));
            let (p, q) = (self.at(near), self.at(far));
            [
                Rectangle { high: far, corners: [a, b, p, q], depth, ..*r },
                Rectangle { low: near, corners: [p, q, c, d], depth, ..*r },
            ]
        } else {
            let (near, far) = (Vec2::new(r.low.x, middle.y), Vec2::new(r.high.x, middle.y));
            let (p, q) = (self.at(near), self.at(far));
            [
                Rectangle { high: far, corners: [a, p, c, q], depth, ..*r },
                Rectangle { low: near, corners: [p, b, q, d], depth, ..*r },
            ]
        }
    }

    /// Bounds of one coordinate over a rectangle.
    fn coordinate_bounds(&self, r: &Rectangle, axis: usize) -> (f64, f64) {
        let size = r.high - r.low;
        let spread = |step: f64, a: f64, b: f64| (0.5 * (self.max_gradient * step - (a - b).abs())).max(0.0);
        let pair = |a: f64, b: f64| {
            let s = spread(size.y, a, b);
            (a.min(b) - s, a.max(b) + s)
        };
        let [a, b, c, d] = r.corners.map(|p| p[axis] - self.accuracy);
        let (first, second) = (pair(a, b), pair(c, d));
        let low = first.0.min(second.0) - spread(size.x, first.0, second.0);
        let high = first.1.max(second.1) + spread(size.x, first.1, second.1);
        (low, high)
    }

    /// Where the ray may meet a rectangle, and the longest stretch of it in one coordinate's bounds; `None`
    /// if it cannot.
    fn meet(&self, r: &Rectangle, search: &Search) -> Option<(f64, f64)> {
        let best = search.best.map_or(f64::INFINITY, |b| b.0);
        let mut met: SmallVec<[(f64, f64); 3]> = SmallVec::new();
        let mut longest = 0.0f64;
        for axis in 0..3 {
            let (low, high) = self.coordinate_bounds(r, axis);
            let (o, d) = (search.ray.origin[axis], search.ray.dir[axis]);
            if d.abs() < PARALLEL {
                if o < low || o > high {
                    return None;
                }
                continue;
            }
            let (a, b) = ((low - o) / d, (high - o) / d);
            let (near, far) = (a.min(b), a.max(b));
            let apart = met.iter().any(|&(n, f)| near > f || far < n);
            if near > search.to || far < search.from || near > best || apart {
                return None;
            }
            met.push((near, far));
            longest = longest.max(far - near);
        }
        met.last().map(|&(near, _)| (near, longest))
    }

    fn follow(&self, search: &mut Search) {
        let mut todo: SmallVec<[Rectangle; 32]> = SmallVec::new();
        todo.push(self.rectangle(self.low, self.high));
        while let Some(r) = todo.pop() {
            let Some((t, longest)) = self.meet(&r, search) else { continue };
            let side = (r.high - r.low).abs().max_element();
            if side.min(longest) < self.accuracy || r.depth >= MAX_DEPTH {
                if t > search.from && search.best.is_none_or(|b| t < b.0) {
                    search.best = Some((t, r.low));
                }
                continue;
            }
            let [lower, upper] = self.halves(&r);
            todo.push(upper);
            todo.push(lower);
        }
    }
}

impl Shape for Parametric {
    fn bounds(&self) -> Aabb {
        self.container.bounds()
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        out.extend(self.nearest(ray, range));
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let clip = self.container.clip(ray, range)?;
        let mut search = Search { ray, from: clip.from + 4.0 * self.accuracy, to: clip.to, best: None };
        if search.from <= search.to {
            self.follow(&mut search);
        }
        let (t, uv) = search.best.filter(|b| b.0 < search.to)?;
        Some(Crossing { t, part: 0, uv })
    }

    fn contains(&self, _p: Vec3) -> bool {
        false
    }

    fn is_solid(&self) -> bool {
        false
    }

    fn normal(&self, _p: Vec3, crossing: &Crossing) -> Vec3 {
        let (uv, h) = (crossing.uv, self.accuracy);
        let here = self.at(uv);
        let along_u = self.at(uv + Vec2::new(h, 0.0)) - here;
        let along_v = self.at(uv + Vec2::new(0.0, h)) - here;
        along_u.cross(along_v).normalize_or(Vec3::Y)
    }

    fn locate(&self, ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        (ray.at(crossing.t), self.accuracy)
    }

    fn uv(&self, _p: Vec3, crossing: &Crossing) -> Option<Vec2> {
        Some(crossing.uv)
    }

    fn kind(&self) -> &'static str {
        "parametric"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Debug)]
    struct Plane(usize);

    impl Field for Plane {
        fn value(&self, p: Vec3) -> f64 {
            [p.x, p.y, 0.25][self.0]
        }
    }

    #[test]
    fn a_flat_sheet() {
        let sheet = Parametric {
            functions: [0, 1, 2].map(|i| Arc::new(Plane(i)) as Arc<dyn Field>),
            low: Vec2::new(-0.5, -0.5),
            high: Vec2::new(0.5, 0.5),
            container: Container::default(),
            accuracy: 0.0005,
            max_gradient: 1.0,
        };
        let hit = |x: f64| sheet.nearest(&Ray::new(Vec3::new(x, 0.1, -3.0), Vec3::Z), Range::FORWARD);
        let c = hit(0.3).unwrap();
        assert!((c.t - 3.25).abs() < 0.002 && c.uv.distance(Vec2::new(0.3, 0.1)) < 0.002, "{c:?}");
        assert!(hit(0.6).is_none());
        assert_eq!(sheet.normal(Vec3::ZERO, &c), Vec3::Z);
    }
}
