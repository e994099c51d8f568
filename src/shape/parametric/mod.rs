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
//! Boxes around parts of the surface, made for the first ray, tell the patches that a ray may meet
//! ([`patches`]). Their rectangles are halved again and again; halves whose bounds, from the corner values and the slopes'
//! bound, the ray cannot meet are left out. The crossing is at the near side of the bounds of the last
//! rectangle, whose first corner gives the parameters. One crossing of a ray is found, and none within four
//! times the accuracy of its start. Never an inside.
//!
//! Numerical care: the accuracy is the scene's; the crossing lies within it. The point is not moved onto
//! the surface.

mod patches;

use super::{Container, Crossing, Shape};
use crate::math::field::Field;
use crate::math::{Aabb, Range, Ray, Vec2, Vec3};
use patches::{Grid, Patches};
use smallvec::SmallVec;
use std::sync::{Arc, OnceLock};

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
    patches: Arc<OnceLock<Patches>>,
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
    inverse: Vec3,
    from: f64,
    to: f64,
    best: Option<(f64, Vec2)>,
}

impl Search<'_> {
    /// Where the ray may meet something between two corners, and the longest stretch of it in one coordinate's
    /// bounds; `None` if it cannot.
    #[inline(always)]
    fn meet(&self, low: Vec3, high: Vec3) -> Option<(f64, f64)> {
        let (mut last, mut longest) = (None, 0.0f64);
        let best = self.best.map_or(f64::INFINITY, |b| b.0);
        let (mut enter, mut leave) = (self.from, self.to);
        for axis in 0..3 {
            let (o, d) = (self.ray.origin[axis], self.ray.dir[axis]);
            if d.abs() < PARALLEL {
                if o < low[axis] || o > high[axis] {
                    return None;
                }
                continue;
            }
            let (a, b) = ((low[axis] - o) * self.inverse[axis], (high[axis] - o) * self.inverse[axis]);
            let (near, far) = (a.min(b), a.max(b));
            (enter, leave) = (enter.max(near), leave.min(far));
            if enter > leave || near > best {
                return None;
            }
            last = Some(near);
            longest = longest.max(far - near);
        }
        last.map(|near| (near, longest))
    }
}

impl Parametric {
    pub fn new(functions: [Arc<dyn Field>; 3], low: Vec2, high: Vec2) -> Self {
        let container = Container::default();
        Self { functions, low, high, container, accuracy: 0.001, max_gradient: 1.0, patches: Arc::default() }
    }

    fn at(&self, uv: Vec2) -> Vec3 {
        let p = Vec3::new(uv.x, uv.y, 0.0);
        Vec3::new(self.functions[0].value(p), self.functions[1].value(p), self.functions[2].value(p))
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

    /// Bounds of the coordinates over a rectangle.
    #[inline(always)]
    fn bounds_over(&self, r: &Rectangle) -> (Vec3, Vec3) {
        let size = self.max_gradient * (r.high - r.low);
        let spread = |most: f64, a: Vec3, b: Vec3| (0.5 * (most - (a - b).abs())).max(Vec3::ZERO);
        let [a, b, c, d] = r.corners;
        let (first, second) = (spread(size.y, a, b), spread(size.y, c, d));
        let (low, high) = (a.min(b) - first, a.max(b) + first);
        let (other_low, other_high) = (c.min(d) - second, c.max(d) + second);
        let low = low.min(other_low) - spread(size.x, low, other_low);
        let high = high.max(other_high) + spread(size.x, high, other_high);
        (low - self.accuracy, high - self.accuracy)
    }

    /// Where the ray may meet a rectangle, and the longest stretch of it in one coordinate's bounds; `None`
    /// if it cannot.
    #[inline(always)]
    fn meet(&self, r: &Rectangle, search: &Search) -> Option<(f64, f64)> {
        let (low, high) = self.bounds_over(r);
        search.meet(low, high)
    }

    /// Looks at the rectangles of a patch.
    fn follow_patch(&self, inner: &Grid, search: &mut Search) {
        let mut todo: SmallVec<[([usize; 2], [usize; 2]); 16]> = SmallVec::new();
        todo.push(([0, 0], inner.cells()));
        while let Some((at, size)) = todo.pop() {
            let r = inner.rectangle(at, size);
            if size == [1, 1] {
                self.follow(r, search);
                continue;
            }
            if self.met_at_last(&r, search) != Some(false) {
                continue;
            }
            let sides = (r.high - r.low).abs();
            let axis = usize::from(size[0] == 1 || (size[1] > 1 && sides.x < sides.y));
            let (mut half, mut upper) = (size, at);
            half[axis] /= 2;
            upper[axis] += half[axis];
            todo.push((upper, half));
            todo.push((at, half));
        }
    }

    fn follow(&self, from: Rectangle, search: &mut Search) {
        let mut todo: SmallVec<[Rectangle; 32]> = SmallVec::new();
        todo.push(from);
        while let Some(r) = todo.pop() {
            if self.met_at_last(&r, search) == Some(false) {
                let [lower, upper] = self.halves(&r);
                todo.push(upper);
                todo.push(lower);
            }
        }
    }

    /// Whether the ray may meet a rectangle (else `None`) and that is small enough; then it has been noted.
    fn met_at_last(&self, r: &Rectangle, search: &mut Search) -> Option<bool> {
        let (t, longest) = self.meet(r, search)?;
        let side = (r.high - r.low).abs().max_element();
        let last = side.min(longest) < self.accuracy || r.depth >= MAX_DEPTH;
        if last && t > search.from && search.best.is_none_or(|b| t < b.0) {
            search.best = Some((t, r.low));
        }
        Some(last)
    }
}

impl Shape for Parametric {
    fn depth(&self) -> u32 {
        self.functions.iter().map(|f| f.depth()).max().unwrap_or(0)
    }

    fn bounds(&self) -> Aabb {
        self.container.bounds()
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        out.extend(self.nearest(ray, range));
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let clip = self.container.clip(ray, range)?;
        let (from, inverse) = (clip.from + 4.0 * self.accuracy, ray.dir.recip());
        let mut search = Search { ray, inverse, from, to: clip.to, best: None };
        if search.from <= search.to {
            let patches = self.patches.get_or_init(|| Patches::new(self));
            let mut todo = SmallVec::from_slice(&[0]);
            while let Some(patch) = patches.next(&mut todo, |b| search.meet(b.min, b.max).is_some()) {
                self.follow_patch(patches.inner(self, patch), &mut search);
            }
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

    fn heap_bytes(&self) -> usize {
        self.patches.get().map_or(0, Patches::heap_bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::conformance::Random;

    #[derive(Debug)]
    struct Plane(usize);

    impl Field for Plane {
        fn value(&self, p: Vec3) -> f64 {
            [p.x, p.y, 0.25][self.0]
        }
    }

    #[test]
    fn a_flat_sheet() {
        let functions = [0, 1, 2].map(|i| Arc::new(Plane(i)) as Arc<dyn Field>);
        let mut sheet = Parametric::new(functions, Vec2::new(-0.5, -0.5), Vec2::new(0.5, 0.5));
        sheet.accuracy = 0.0005;
        let hit = |x: f64| sheet.nearest(&Ray::new(Vec3::new(x, 0.1, -3.0), Vec3::Z), Range::FORWARD);
        let c = hit(0.3).unwrap();
        assert!((c.t - 3.25).abs() < 0.002 && c.uv.distance(Vec2::new(0.3, 0.1)) < 0.002, "{c:?}");
        assert!(hit(0.6).is_none());
        assert_eq!(sheet.normal(Vec3::ZERO, &c), Vec3::Z);
    }

    /// An egg; what is known of the slopes is nothing but the scene's bound.
    #[derive(Debug)]
    struct Egg(usize);

    impl Field for Egg {
        fn value(&self, p: Vec3) -> f64 {
            let (u, v) = (p.x, p.y);
            [0.5 * u.cos() * v.cos(), 0.8 * v.sin(), 0.5 * u.sin() * v.cos()][self.0]
        }
    }

    #[test]
    fn the_tree_loses_no_hit() {
        let functions = [0, 1, 2].map(|i| Arc::new(Egg(i)) as Arc<dyn Field>);
        let mut egg = Parametric::new(functions, Vec2::new(0.0, -1.5), Vec2::new(6.3, 1.5));
        egg.accuracy = 0.01;
        let whole = Rectangle {
            low: egg.low,
            high: egg.high,
            corners: [egg.low, Vec2::new(0.0, 1.5), Vec2::new(6.3, -1.5), egg.high].map(|uv| egg.at(uv)),
            depth: 0,
        };
        let mut random = Random::new(11);
        let (mut hits, mut misses) = (0, 0);
        for _ in 0..300 {
            let ray = Ray::new(3.0 * random.direction(), random.direction());
            let ray = Ray::new(ray.origin, (0.7 * ray.dir - ray.origin).normalize());
            let Some(clip) = egg.container.clip(&ray, Range::FORWARD) else { continue };
            let inverse = ray.dir.recip();
            let mut search = Search { ray: &ray, inverse, from: clip.from + 0.04, to: clip.to, best: None };
            egg.follow(whole, &mut search);
            let found = egg.nearest(&ray, Range::FORWARD);
            match (search.best, found) {
                (Some((t, _)), Some(c)) => {
                    // The crossing is where the ray comes into the last rectangle's bounds along z.
                    assert!((t - c.t).abs() * ray.dir.z.abs() <= 3.0 * egg.accuracy, "{t} {}", c.t);
                    hits += 1;
                }
                (expected, found) => {
                    assert_eq!(expected.is_some(), found.is_some(), "{ray:?}");
                    misses += 1;
                }
            }
        }
        assert!(hits > 100 && misses > 20, "{hits} {misses}");
    }
}
