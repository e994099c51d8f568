//! Julia fractal: the points of a three-dimensional slice of four-dimensional space whose iteration
//! `z ← f(z) + c` does not escape.
//!
//! | parameter | unit | default | meaning |
//! |---|---|---|---|
//! | c | – | (1, 0, 0, 0) | four-dimensional |
//! | algebra | – | quaternion | or hypercomplex, which commutes |
//! | function | – | square | quaternions know square and cube |
//! | max_iteration | – | 20 | |
//! | precision | 1 / length | 20 | inverse of the step along a ray |
//! | slice | – | (0, 0, 0, 1), 0 | normal and distance of the slice |
//!
//! A ray is followed in steps through a ball around the set: by an estimate of the distance to it while
//! outside, else by the smallest step. Where the state changes the place is refined. The ball itself, of radius 4 for
//! hypercomplex numbers, is where the first iterate is too large: it is part of the surface where it cuts
//! the set. The normal is the gradient of the iterate's size with the fourth coordinate held fast, as it always was, also where
//! the slice is inclined and that is not quite the surface's.
//!
//! Numerical care: places are refined down to rounding. An iterate that is not finite has escaped.

mod hypercomplex;
mod quaternion;

pub use hypercomplex::Function;

use super::sphere::sphere_span;
use super::{Crossing, Shape};
use crate::math::{Aabb, EPSILON, Range, Ray, Vec3};
use hypercomplex::Hypercomplex;
use quaternion::Quaternions;

/// Where a point of space lies in four dimensions: w = offset - slope · p.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Slice {
    slope: Vec3,
    offset: f64,
}

/// What iterating a point told.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Fate {
    Inside,
    /// It escaped; no point nearer than this is inside.
    Outside(f64),
}

/// The kinds of numbers that are iterated.
#[derive(Clone, Debug, PartialEq)]
enum Algebra {
    Quaternion(Quaternions),
    Hypercomplex(Hypercomplex),
}

#[derive(Clone, Debug, PartialEq)]
pub struct Julia {
    algebra: Algebra,
    slice: Slice,
    iterations: u32,
    /// Smallest step.
    step: f64,
    radius: f64,
}

/// What a scene says about a fractal.
#[derive(Clone, Debug, PartialEq)]
pub struct JuliaSettings {
    pub c: [f64; 4],
    pub hypercomplex: bool,
    pub function: Function,
    pub iterations: u32,
    pub precision: f64,
    pub slice_normal: [f64; 4],
    pub slice_distance: f64,
}

impl Default for JuliaSettings {
    fn default() -> Self {
        Self {
            c: [1.0, 0.0, 0.0, 0.0],
            hypercomplex: false,
            function: Function::Square,
            iterations: 20,
            precision: 20.0,
            slice_normal: [0.0, 0.0, 0.0, 1.0],
            slice_distance: 0.0,
        }
    }
}

/// Why settings make no fractal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JuliaError {
    NoSlice,
    /// The slice contains the fourth axis.
    SliceAlongFourth,
    NotForQuaternions,
}

impl Slice {
    fn new(normal: [f64; 4], distance: f64) -> Result<Self, JuliaError> {
        let length = normal.iter().map(|v| v * v).sum::<f64>().sqrt();
        if length == 0.0 || !length.is_finite() {
            return Err(JuliaError::NoSlice);
        }
        let [a, b, c, d] = normal.map(|v| v / length);
        if d.abs() < 1e-10 {
            return Err(JuliaError::SliceAlongFourth);
        }
        Ok(Self { slope: Vec3::new(a, b, c) / d, offset: distance / d })
    }

    fn fourth(&self, p: Vec3) -> f64 {
        self.offset - self.slope.dot(p)
    }
}

/// Until a change of state is found to rounding.
const MAX_STEPS: usize = 128;

/// Steps past the start of a ray before its state is looked at.
const SKIP: f64 = 1e-7;

impl Julia {
    pub fn new(settings: &JuliaSettings) -> Result<Self, JuliaError> {
        let slice = Slice::new(settings.slice_normal, settings.slice_distance)?;
        let c = settings.c;
        let (algebra, radius) = if settings.hypercomplex {
            (Algebra::Hypercomplex(Hypercomplex::new(c, settings.function)), 4.0)
        } else {
            let cube = match settings.function {
                Function::Square => false,
                Function::Cube => true,
                _ => return Err(JuliaError::NotForQuaternions),
            };
            let size = c.iter().map(|v| v * v).sum::<f64>().sqrt();
            let radius = (1.0 + size).min(2.0) + 1e-7;
            (Algebra::Quaternion(Quaternions { c, cube, limit: radius * radius + 1e-7 }), radius)
        };
        let step = 1.0 / settings.precision.max(1.0);
        Ok(Self { algebra, slice, iterations: settings.iterations.max(1), step, radius })
    }

    fn fate(&self, p: Vec3, dir: Vec3) -> Fate {
        let w = self.slice.fourth(p);
        match &self.algebra {
            Algebra::Quaternion(q) => q.fate([p.x, p.y, p.z, w], self.iterations),
            Algebra::Hypercomplex(h) => {
                let slope = [dir.x, dir.y, dir.z, -self.slice.slope.dot(dir)];
                h.fate([p.x, p.y, p.z, w], slope, self.iterations, self.step)
            }
        }
    }

    fn is_inside(&self, p: Vec3) -> bool {
        let z = [p.x, p.y, p.z, self.slice.fourth(p)];
        match &self.algebra {
            Algebra::Quaternion(q) => q.stays(z, self.iterations),
            Algebra::Hypercomplex(h) => h.stays(z, self.iterations),
        }
    }

    /// Of the iterate's squared size, in four dimensions.
    fn gradient(&self, p: Vec3) -> [f64; 4] {
        let z = [p.x, p.y, p.z, self.slice.fourth(p)];
        match &self.algebra {
            Algebra::Quaternion(q) => q.gradient(z, self.iterations),
            Algebra::Hypercomplex(h) => h.gradient(z, self.iterations),
        }
    }

    fn visit(&self, ray: &Ray, range: Range, mut found: impl FnMut(f64) -> bool) {
        let Some((enter, leave)) = sphere_span(ray.origin, ray.dir, self.radius) else { return };
        let (enters, leaves) = (enter > range.min, leave < range.max);
        let mut t = if enters { enter + 2.0 * SKIP } else { range.min + SKIP };
        let end = if leaves { leave - 2.0 * SKIP } else { range.max };
        if !(t < end) {
            return;
        }
        let mut fate = self.fate(ray.at(t), ray.dir);
        if enters && fate == Fate::Inside {
            if !found(enter) {
                return;
            }
        } else if fate == Fate::Inside {
            t += 2.0 * SKIP;
            fate = self.fate(ray.at(t), ray.dir);
        }
        while t < end {
            let step = match fate {
                Fate::Inside => self.step,
                Fate::Outside(distance) => distance.max(self.step),
            };
            let next = (t + step).min(end);
            let next_fate = self.fate(ray.at(next), ray.dir);
            if (fate == Fate::Inside) != (next_fate == Fate::Inside) {
                let crossing = self.refined(ray, t, next, fate == Fate::Inside);
                if range.contains(crossing) && !found(crossing) {
                    return;
                }
            }
            (t, fate) = (next, next_fate);
        }
        if leaves && fate == Fate::Inside {
            found(leave);
        }
    }

    /// The last place inside next to a change of state. Where the sizes of the last iterates are known they
    /// say where to look next (regula falsi with halved weights); whether a place is inside is always asked.
    fn refined(&self, ray: &Ray, mut low: f64, mut high: f64, inside_first: bool) -> f64 {
        let mut ends = [low, high].map(|t| self.border(ray.at(t)).1);
        let mut last = 2;
        for step in 0..MAX_STEPS {
            let (width, least) = (high - low, 2.0 * EPSILON * self.radius);
            if width <= 2.0 * least {
                break;
            }
            let guess = match ends {
                [Some(a), Some(b)] if step % 8 != 7 && a * b < 0.0 => {
                    (low + width * (a / (a - b))).max(low + least).min(high - least)
                }
                _ => f64::NAN,
            };
            let middle = if guess > low && guess < high { guess } else { 0.5 * (low + high) };
            if middle <= low || middle >= high {
                break;
            }
            let (inside, excess) = self.border(ray.at(middle));
            let side = usize::from(inside != inside_first);
            if side == 0 {
                low = middle
            } else {
                high = middle
            }
            ends[side] = excess;
            if side == last {
                ends[1 - side] = ends[1 - side].map(|e| 0.5 * e);
            }
            last = side;
        }
        if inside_first { low } else { high }
    }

    /// Whether a point is inside, and how far its last iterate is beyond the limit, if that tells where the
    /// border is.
    fn border(&self, p: Vec3) -> (bool, Option<f64>) {
        let z = [p.x, p.y, p.z, self.slice.fourth(p)];
        match &self.algebra {
            Algebra::Quaternion(q) => q.border(z, self.iterations),
            Algebra::Hypercomplex(h) => (h.stays(z, self.iterations), None),
        }
    }
}

impl Shape for Julia {
    fn bounds(&self) -> Aabb {
        Aabb { min: Vec3::splat(-self.radius), max: Vec3::splat(self.radius) }
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        self.visit(ray, range, |t| {
            out.push(Crossing::new(t));
            true
        });
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let mut first = None;
        self.visit(ray, range, |t| {
            first = Some(Crossing::new(t));
            false
        });
        first
    }

    fn contains(&self, p: Vec3) -> bool {
        p.length_squared() < self.radius * self.radius && self.is_inside(p)
    }

    fn normal(&self, p: Vec3, _crossing: &Crossing) -> Vec3 {
        let g = self.gradient(p);
        Vec3::new(g[0], g[1], g[2]).normalize_or(p.normalize_or(Vec3::Y))
    }

    fn face_normal(&self, p: Vec3, _crossing: &Crossing) -> Option<Vec3> {
        let g = self.gradient(p);
        let along = Vec3::new(g[0], g[1], g[2]) - g[3] * self.slice.slope;
        Some(along.normalize_or(p.normalize_or(Vec3::Y)))
    }

    fn locate(&self, ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        // The set's border is as fine as the iteration: nothing smaller than the first step counts.
        (ray.at(crossing.t), SKIP)
    }

    fn kind(&self) -> &'static str {
        "julia_fractal"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_a_constant_the_set_is_the_unit_ball() {
        let settings = JuliaSettings { c: [0.0; 4], iterations: 30, precision: 50.0, ..Default::default() };
        for hypercomplex in [false, true] {
            let julia = Julia::new(&JuliaSettings { hypercomplex, ..settings.clone() }).unwrap();
            let ray = Ray::new(Vec3::new(0.0, 0.0, -5.0), Vec3::Z);
            let c = julia.nearest(&ray, Range::FORWARD).unwrap();
            assert!((c.t - 4.0).abs() < 1e-6, "{} {hypercomplex}", c.t);
            assert!(julia.normal(ray.at(c.t), &c).distance(Vec3::NEG_Z) < 1e-6);
            assert!(julia.contains(Vec3::ZERO) && !julia.contains(1.1 * Vec3::X));
        }
    }

    #[test]
    fn slices_must_cut_across_the_fourth_axis() {
        let with = |slice_normal| Julia::new(&JuliaSettings { slice_normal, ..Default::default() }).err();
        assert_eq!(with([0.0; 4]), Some(JuliaError::NoSlice));
        assert_eq!(with([1.0, 0.0, 0.0, 0.0]), Some(JuliaError::SliceAlongFourth));
        let sine = JuliaSettings { function: Function::Sin, ..Default::default() };
        assert_eq!(Julia::new(&sine).err(), Some(JuliaError::NotForQuaternions));
    }

    #[test]
    fn gradients_agree_with_differences() {
        for (hypercomplex, function) in [
            (false, Function::Square),
            (false, Function::Cube),
            (true, Function::Square),
            (true, Function::Sin),
            (true, Function::Reciprocal),
            (true, Function::Tan),
            (true, Function::Acosh),
            (true, Function::Power([2.5, 0.25])),
        ] {
            let settings = JuliaSettings {
                c: [0.1, -0.2, 0.15, 0.05],
                hypercomplex,
                function,
                iterations: 3,
                slice_normal: [0.1, 0.2, -0.1, 1.0],
                slice_distance: 0.1,
                ..Default::default()
            };
            let julia = Julia::new(&settings).unwrap();
            let p = Vec3::new(0.31, 0.22, -0.27);
            let at = [p.x, p.y, p.z, julia.slice.fourth(p)];
            let size = |q: Vec3| {
                let z = [q.x, q.y, q.z, julia.slice.fourth(q)];
                match &julia.algebra {
                    Algebra::Quaternion(q) => q.last_size(z, 3),
                    Algebra::Hypercomplex(h) => h.decisive_size(at, z, 3),
                }
            };
            let h = 1e-6;
            let slope = |d: Vec3| (size(p + h * d) - size(p - h * d)) / (2.0 * h);
            let expected = Vec3::new(slope(Vec3::X), slope(Vec3::Y), slope(Vec3::Z)).normalize();
            let normal = julia.face_normal(p, &Crossing::new(0.0)).unwrap();
            assert!(normal.distance(expected) < 1e-6, "{function:?} {normal} {expected}");
        }
    }
}
