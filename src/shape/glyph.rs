//! One letter of a text: a flat outline drawn out along z.
//!
//! | parameter | unit | meaning |
//! |---|---|---|
//! | outline | length | closed contours of straight lines and parabolas in the xy plane |
//! | thickness | length | the solid reaches from z = 0 to z = thickness |
//!
//! A point is inside the outline if a half line from it crosses the outline an odd number of times, so
//! contours that overlap leave holes. Front and back look towards -z and +z; a wall looks to the right of the
//! direction in which its contour runs, as the reference has it: inward, where outer contours run clockwise
//! (y up), as they do in TrueType fonts.
//!
//! Numerical care: seen along z a ray is a line in the plane. Whether it passes between the ends of a segment
//! is told by the signs of their distances from the line, which neighbouring segments share; so no ray slips
//! through where two walls meet.

use super::{Crossing, Shape, rounding};
use crate::math::{Aabb, Range, Ray, Vec2, Vec3};

/// Two or three points: a straight line or a parabola (a quadratic Bézier curve).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Segment {
    Line(Vec2, Vec2),
    Curve(Vec2, Vec2, Vec2),
}

impl Segment {
    fn start(&self) -> Vec2 {
        match *self {
            Segment::Line(a, _) | Segment::Curve(a, _, _) => a,
        }
    }

    fn end(&self) -> Vec2 {
        match *self {
            Segment::Line(_, b) | Segment::Curve(_, _, b) => b,
        }
    }

    fn at(&self, w: f64) -> Vec2 {
        match *self {
            Segment::Line(a, b) => a + w * (b - a),
            Segment::Curve(a, c, b) => {
                let v = 1.0 - w;
                v * v * a + 2.0 * v * w * c + w * w * b
            }
        }
    }

    /// The corners of a box around it.
    fn extent(&self) -> (Vec2, Vec2) {
        let control = if let Segment::Curve(_, c, _) = self { *c } else { self.start() };
        let (a, b) = (self.start(), self.end());
        (a.min(b).min(control), a.max(b).max(control))
    }

    /// Direction in which the segment runs; not unit.
    fn tangent(&self, w: f64) -> Vec2 {
        match *self {
            Segment::Line(a, b) => b - a,
            Segment::Curve(a, c, b) => (1.0 - w) * (c - a) + w * (b - c),
        }
    }

    /// Parameters in 0..1 at which `height`, a linear function of the place, changes its sign; the start
    /// belongs to the segment and the end does not.
    fn sign_changes(&self, height: impl Fn(Vec2) -> f64) -> smallvec::SmallVec<[f64; 2]> {
        let (h0, h1) = (height(self.start()), height(self.end()));
        let crosses = (h0 < 0.0) != (h1 < 0.0);
        let mut found = smallvec::SmallVec::new();
        match *self {
            Segment::Line(..) => {
                if crosses {
                    found.push((h0 / (h0 - h1)).clamp(0.0, 1.0));
                }
            }
            Segment::Curve(_, c, _) => {
                let hc = height(c);
                // h0 (1-w)² + 2 hc w (1-w) + h1 w² = h0 + 2 (hc - h0) w + (h0 - 2 hc + h1) w²
                let (a, half_b) = (h0 - 2.0 * hc + h1, hc - h0);
                let discriminant = half_b * half_b - a * h0;
                if crosses {
                    found.push(single_root(a, half_b, h0, h1, discriminant));
                } else if discriminant > 0.0 {
                    let q = -(half_b + discriminant.sqrt().copysign(half_b));
                    let roots = [q / a, h0 / q];
                    if roots.iter().all(|w| *w > 0.0 && *w < 1.0) {
                        found.extend([roots[0].min(roots[1]), roots[0].max(roots[1])]);
                    }
                }
            }
        }
        found
    }
}

/// The root in 0..1 of `h0 + 2 half_b w + a w²`, whose values at 0 and 1 differ in sign.
fn single_root(a: f64, half_b: f64, h0: f64, h1: f64, discriminant: f64) -> f64 {
    let q = -(half_b + discriminant.max(0.0).sqrt().copysign(half_b));
    let inside = |w: f64| (0.0..=1.0).contains(&w);
    let (r0, r1) = (q / a, h0 / q);
    // Rounding may push the root over an end, or make both ends candidates: the better one counts.
    let value = |w: f64| (h0 + w * (2.0 * half_b + a * w)).abs();
    match (inside(r0), inside(r1)) {
        (true, true) => {
            if value(r0) <= value(r1) {
                r0
            } else {
                r1
            }
        }
        (true, false) => r0,
        (false, true) => r1,
        (false, false) => {
            if h0.abs() < h1.abs() {
                0.0
            } else {
                1.0
            }
        }
    }
}

#[derive(Clone, Debug, PartialEq)]
pub struct Glyph {
    outline: Vec<Segment>,
    thickness: f64,
    bounds: Aabb,
    bands: Bands,
}

/// Which segments reach into each of a row of bands of equal height.
#[derive(Clone, Debug, PartialEq)]
struct Bands {
    low: f64,
    per_height: f64,
    /// Where each band's segments begin in `segments`; one entry more than there are bands.
    starts: Vec<u32>,
    segments: Vec<u32>,
    /// Least and greatest x, and first band, of each segment.
    extents: Vec<(f64, f64, u32)>,
}

impl Bands {
    /// A few segments reach into a band.
    fn new(outline: &[Segment], bounds: &Aabb) -> Self {
        let count = outline.len().clamp(1, 256);
        let height = bounds.max.y - bounds.min.y;
        let per_height = if height > 0.0 { count as f64 / height } else { 0.0 };
        let mut bands = Self {
            low: bounds.min.y,
            per_height,
            starts: vec![0; count + 1],
            segments: Vec::new(),
            extents: Vec::new(),
        };
        let mut lists = vec![Vec::new(); count];
        for (i, segment) in outline.iter().enumerate() {
            let (low, high) = segment.extent();
            let (first, last) = (bands.number(low.y), bands.number(high.y));
            bands.extents.push((low.x, high.x, first as u32));
            lists[first..=last].iter_mut().for_each(|list| list.push(i as u32));
        }
        for (k, list) in lists.into_iter().enumerate() {
            bands.segments.extend(list);
            bands.starts[k + 1] = bands.segments.len() as u32;
        }
        bands
    }

    /// The band at a height, or the one next to it.
    fn number(&self, y: f64) -> usize {
        let last = self.starts.len() - 2;
        (((y - self.low) * self.per_height).max(0.0) as usize).min(last)
    }

    fn at(&self, band: usize) -> &[u32] {
        &self.segments[self.starts[band] as usize..self.starts[band + 1] as usize]
    }
}

/// Parts of the surface: a wall's number counts from 2.
const FRONT: u32 = 0;
const BACK: u32 = 1;
const WALLS: u32 = 2;

impl Glyph {
    /// Contours must be closed. A thickness below 0 reaches towards -z.
    pub fn new(outline: Vec<Segment>, thickness: f64) -> Self {
        let mut bounds = Aabb::EMPTY;
        for segment in &outline {
            let control = if let Segment::Curve(_, c, _) = segment { *c } else { segment.start() };
            for p in [segment.start(), control, segment.end()] {
                bounds = bounds.extended(p.extend(0.0)).extended(p.extend(thickness));
            }
        }
        let bands = Bands::new(&outline, &bounds);
        Self { outline, thickness, bounds, bands }
    }

    /// Whether the outline holds a point of the plane.
    fn holds(&self, p: Vec2) -> bool {
        let (low, high) = (self.bounds.min.truncate(), self.bounds.max.truncate());
        if p.cmplt(low).any() || p.cmpgt(high).any() {
            return false;
        }
        let mut inside = false;
        for &i in self.bands.at(self.bands.number(p.y)) {
            if self.bands.extents[i as usize].1 <= p.x {
                continue;
            }
            let segment = &self.outline[i as usize];
            for w in segment.sign_changes(|q| q.y - p.y) {
                inside ^= segment.at(w).x > p.x;
            }
        }
        inside
    }

    fn cap(&self, ray: &Ray, z: f64, part: u32, range: Range) -> Option<Crossing> {
        let t = (z - ray.origin.z) / ray.dir.z;
        let met = ray.dir.z != 0.0 && range.contains(t) && self.holds(ray.at(t).truncate());
        met.then(|| Crossing::on_part(t, part))
    }

    fn walls(&self, ray: &Ray, range: Range, mut found: impl FnMut(Crossing)) {
        let (o, d) = (ray.origin.truncate(), ray.dir.truncate());
        let squared = d.length_squared();
        if squared == 0.0 {
            return;
        }
        let (low, high) = (self.thickness.min(0.0), self.thickness.max(0.0));
        let Some((from, to)) = self.way(ray, range) else { return };
        let (a, b) = (o + from * d, o + to * d);
        let (left, right) = (a.x.min(b.x), a.x.max(b.x));
        let (first, last) = (self.bands.number(a.y.min(b.y)), self.bands.number(a.y.max(b.y)));
        for band in first..=last {
            for &i in self.bands.at(band) {
                let (least, greatest, lowest) = self.bands.extents[i as usize];
                // A segment that reaches into several bands is met in the first of them.
                if greatest < left || least > right || band != first.max(lowest as usize) {
                    continue;
                }
                let segment = &self.outline[i as usize];
                for w in segment.sign_changes(|p| d.perp_dot(p - o)) {
                    let t = (segment.at(w) - o).dot(d) / squared;
                    let z = ray.origin.z + t * ray.dir.z;
                    if range.contains(t) && z >= low && z <= high {
                        found(Crossing { t, part: WALLS + i, uv: Vec2::new(w, 0.0) });
                    }
                }
            }
        }
    }

    /// The part of a ray that may be inside the bounds, a little more than that.
    fn way(&self, ray: &Ray, range: Range) -> Option<(f64, f64)> {
        let size = self.bounds.min.abs().max(self.bounds.max.abs()).max_element();
        let slack = rounding(64.0 * (size + ray.origin.abs().max_element()));
        let (mut from, mut to) = (range.min, range.max);
        for axis in 0..3 {
            let (low, high) = (self.bounds.min[axis] - slack, self.bounds.max[axis] + slack);
            let (o, d) = (ray.origin[axis], ray.dir[axis]);
            if d == 0.0 {
                if o < low || o > high {
                    return None;
                }
                continue;
            }
            let (a, b) = ((low - o) / d, (high - o) / d);
            (from, to) = (from.max(a.min(b)), to.min(a.max(b)));
        }
        (from <= to).then_some((from, to))
    }
}

/// The nearer of two crossings; of equally near ones the second.
fn nearer(a: Crossing, b: Crossing) -> Crossing {
    if b.t <= a.t { b } else { a }
}

impl Shape for Glyph {
    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        out.extend(self.cap(ray, 0.0, FRONT, range));
        out.extend(self.cap(ray, self.thickness, BACK, range));
        self.walls(ray, range, |c| out.push(c));
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let ends = [(0.0, FRONT), (self.thickness, BACK)];
        let mut best = ends.into_iter().filter_map(|(z, part)| self.cap(ray, z, part, range)).reduce(nearer);
        // A wall at the same distance counts.
        let range = Range::new(range.min, best.map_or(range.max, |b| b.t.next_up()));
        self.walls(ray, range, |c| best = Some(best.map_or(c, |b| nearer(b, c))));
        best
    }

    fn contains(&self, p: Vec3) -> bool {
        p.z >= self.thickness.min(0.0) && p.z <= self.thickness.max(0.0) && self.holds(p.truncate())
    }

    fn normal(&self, _p: Vec3, crossing: &Crossing) -> Vec3 {
        match crossing.part {
            FRONT => -Vec3::Z,
            BACK => Vec3::Z,
            wall => {
                let d = self.outline[(wall - WALLS) as usize].tangent(crossing.uv.x);
                Vec3::new(d.y, -d.x, 0.0).normalize_or(Vec3::X)
            }
        }
    }

    fn locate(&self, ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        let mut p = ray.at(crossing.t);
        let size = self.bounds.min.abs().max(self.bounds.max.abs()).max_element();
        match crossing.part {
            FRONT => p.z = 0.0,
            BACK => p.z = self.thickness,
            wall => p = self.outline[(wall - WALLS) as usize].at(crossing.uv.x).extend(p.z),
        }
        (p, rounding(size))
    }

    fn kind(&self) -> &'static str {
        "text"
    }

    fn heap_bytes(&self) -> usize {
        self.outline.len() * size_of::<Segment>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A unit square, clockwise, with a round bite: its right side bends inward to x = 0.5.
    pub fn bitten() -> Glyph {
        let v = Vec2::new;
        Glyph::new(
            vec![
                Segment::Line(v(0.0, 0.0), v(0.0, 1.0)),
                Segment::Line(v(0.0, 1.0), v(1.0, 1.0)),
                Segment::Curve(v(1.0, 1.0), v(0.0, 0.5), v(1.0, 0.0)),
                Segment::Line(v(1.0, 0.0), v(0.0, 0.0)),
            ],
            0.25,
        )
    }

    #[test]
    fn the_bite_is_outside_and_the_rest_inside() {
        let g = bitten();
        assert!(g.contains(Vec3::new(0.4, 0.5, 0.1)) && g.contains(Vec3::new(0.9, 0.95, 0.2)));
        assert!(!g.contains(Vec3::new(0.6, 0.5, 0.1)) && !g.contains(Vec3::new(0.4, 0.5, 0.3)));
    }

    #[test]
    fn walls_look_to_the_right_of_their_contour_and_curves_are_met_where_they_are() {
        let g = bitten();
        let ray = Ray::new(Vec3::new(2.0, 0.5, 0.1), -Vec3::X);
        let hit = g.nearest(&ray, Range::FORWARD).unwrap();
        assert!((hit.t - 1.5).abs() < 1e-14, "{}", hit.t);
        assert!(g.normal(ray.at(hit.t), &hit).distance(-Vec3::X) < 1e-12);
        let front = Ray::new(Vec3::new(0.2, 0.7, -1.0), Vec3::Z);
        let hit = g.nearest(&front, Range::FORWARD).unwrap();
        assert_eq!((hit.t, g.normal(front.at(1.0), &hit)), (1.0, -Vec3::Z));
    }

    #[test]
    fn no_ray_slips_through_a_corner() {
        let g = bitten();
        for i in 0..1000 {
            let a = f64::from(i) * 0.006_28;
            let from = Vec3::new(0.3 + 3.0 * a.cos(), 0.5 + 3.0 * a.sin(), 0.1);
            for corner in [Vec3::new(0.0, 0.0, 0.1), Vec3::new(0.0, 1.0, 0.1), Vec3::new(0.3, 0.5, 0.1)] {
                let inside = corner.lerp(Vec3::new(0.3, 0.5, 0.1), 1e-9);
                let ray = Ray::new(from, (inside - from).normalize());
                let mut all = Vec::new();
                g.crossings(&ray, Range::FORWARD, &mut all);
                assert_eq!(all.len() % 2, 0, "{ray:?}: {all:?}");
            }
        }
    }
}
