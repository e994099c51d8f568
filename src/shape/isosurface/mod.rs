//! Isosurface: `f(p) = threshold` inside a container; the solid is where `f` is not above.
//!
//! | parameter | unit | default | meaning |
//! |---|---|---|---|
//! | function | | | a number at every point |
//! | contained_by | length | the box from -1 to 1 | where the surface is looked for |
//! | threshold | | 0 | |
//! | accuracy | length | 0.001 | features thinner than this may be missed; step of the normal's differences |
//! | max_gradient | 1 / length | 1.1 | bound on the slope of `f`; too small a one makes holes |
//! | evaluate | | none | lets the bound adapt: least value, factor over what is seen, decay |
//! | open | | off | leaves the container's surface away where the solid reaches it |
//! | max_trace | | 1 | how many crossings of a ray are looked for; 10 in combinations |
//!
//! A ray is searched for the first short interval at whose end the sign has changed. Intervals in which the
//! bound of the slope allows no zero are left out ([`search`]), and so are those in which the function's
//! own ranges do ([`cells`]); the zero is then refined to rounding.
//!
//! The point that is reported lies up to `accuracy` behind that zero, where the reference finds it: the way
//! through the container is halved until the pieces are shorter than `accuracy`, measured in the world, and
//! the end of the piece with the zero counts. Fine textures depend on that. Where such pieces are no longer
//! small in comparison with the container, the zero itself is reported: a small copy looks like the large
//! one.
//!
//! Numerical care: a ray that starts on the surface steps a ten-millionth of the container away before it
//! looks at the sign. The normal is taken from differences forward by `accuracy`, as the reference has it.
//!
//! References: D. Kalra and A. Barr, "Guaranteed Ray Intersections with Implicit Surfaces", SIGGRAPH 1989;
//! D. Mitchell, "Robust Ray Intersection with Interval Arithmetic", Graphics Interface 1990.

mod cells;
mod search;

use super::container::Clip;
use super::{Container, Crossing, Shape, rounding};
use crate::math::field::Field;
use crate::math::{Aabb, EPSILON, Range, Ray, Transform, Vec3};
use cells::{Cells, Level, Stretch};
use glam::DMat3;
use search::{Bound, Bracket, first_bracket, refine};
use std::sync::{Arc, OnceLock};

/// What a scene says about an isosurface.
#[derive(Clone, Debug)]
pub struct Isosurface {
    pub function: Arc<dyn Field>,
    pub container: Container,
    pub threshold: f64,
    pub accuracy: f64,
    pub max_gradient: f64,
    /// Least slope, factor over the slopes seen, decay from ray to ray (not used: rays do not share it).
    pub evaluate: Option<[f64; 3]>,
    pub open: bool,
    pub max_trace: usize,
    /// Takes lengths to the world.
    to_world: DMat3,
    cells: Arc<OnceLock<Option<Cells>>>,
}

/// Parts of the container's surface have numbers from here.
const CONTAINER: u32 = 1;

/// How far a ray that starts on the surface steps from it, in container sizes.
const SKIP: f64 = 1e-7;

/// Largest piece of the way at whose end a zero is reported, in container sizes.
const LARGEST_PIECE: f64 = 0.02;

impl Isosurface {
    pub fn new(function: Arc<dyn Field>) -> Self {
        Self {
            function,
            container: Container::default(),
            threshold: 0.0,
            accuracy: 0.001,
            max_gradient: 1.1,
            evaluate: None,
            open: false,
            max_trace: 1,
            to_world: DMat3::IDENTITY,
            cells: Arc::default(),
        }
    }

    fn value(&self, p: Vec3) -> f64 {
        let value = self.function.value(p) - self.threshold;
        // What is undefined is outside.
        if value.is_nan() { f64::INFINITY } else { value }
    }

    fn size(&self) -> f64 {
        self.container.bounds().size().max_element()
    }

    fn level(&self) -> Level<'_> {
        Level { field: &*self.function, threshold: self.threshold }
    }

    fn cells(&self) -> Option<&Cells> {
        self.cells.get_or_init(|| Cells::new(self.level(), &self.container.bounds())).as_ref()
    }

    /// The accuracy along a unit direction, in the object's own lengths.
    fn accuracy_along(&self, dir: Vec3) -> f64 {
        self.accuracy / (self.to_world * dir).length()
    }

    /// Whether zeros are reported at the ends of pieces of the way.
    fn in_pieces(&self, accuracy: f64) -> bool {
        accuracy <= LARGEST_PIECE * self.size()
    }

    /// Calls `found` with the crossings in order until it has enough.
    fn cross(&self, ray: &Ray, range: Range, mut found: impl FnMut(Crossing) -> bool) {
        let Some(clip) = self.container.clip(ray, range) else { return };
        let accuracy = self.accuracy_along(ray.dir);
        let line = Line { surface: self, ray: Ray::new(ray.at(clip.from), ray.dir), accuracy };
        let mut left = self.max_trace;
        let mut at = (0.0, line.value(0.0));
        let mut start = 0.0;
        match clip.entry {
            None => {
                // The reference looks from here on if a ray starts in a closed solid or near it.
                let near = !self.open && at.1 < 4.0 * self.max_gradient * self.accuracy;
                start = if near { 5.0 * accuracy } else { 0.0 };
                at = self.off_the_surface(&line, at);
            }
            Some(entry) if at.1 < 0.0 && !self.open => {
                left -= 1;
                if found(on_container(entry)) || left == 0 {
                    return;
                }
            }
            Some(_) => {}
        }
        let end = clip.to - clip.from;
        while left > 0 && at.0 < end {
            let Some(zero) = line.zero(at, end) else { break };
            left -= 1;
            let reported = line.end_of_piece(zero, start, end);
            if found(Crossing::new(clip.from + reported)) {
                return;
            }
            start = reported + 5.0 * accuracy;
            at = zero;
        }
        self.leave(&line, &clip, left, found);
    }

    /// The crossing of the container's surface where a ray leaves through the solid.
    fn leave(&self, line: &Line, clip: &Clip, left: usize, mut found: impl FnMut(Crossing) -> bool) {
        let Some(exit) = clip.exit else { return };
        let counts = left > 0 || clip.entry.is_none();
        if counts && !self.open && line.value(clip.to - clip.from) < 0.0 {
            found(on_container(exit));
        }
    }

    /// Where a ray that starts inside the container begins to look, with the value there.
    fn off_the_surface(&self, line: &Line, start: (f64, f64)) -> (f64, f64) {
        let skip = SKIP * self.size();
        if start.1.abs() < 4.0 * self.max_gradient * skip {
            let t = start.0 + 5.0 * skip;
            return (t, line.value(t));
        }
        start
    }
}

fn on_container(crossing: Crossing) -> Crossing {
    Crossing { part: CONTAINER + crossing.part, ..crossing }
}

/// A ray from where it enters the container.
struct Line<'a> {
    surface: &'a Isosurface,
    ray: Ray,
    accuracy: f64,
}

impl Line<'_> {
    fn value(&self, t: f64) -> f64 {
        self.surface.value(self.ray.at(t))
    }

    /// The first zero behind `from` and the value there, which has the other sign.
    fn zero(&self, from: (f64, f64), end: f64) -> Option<(f64, f64)> {
        let sign = if from.1 < 0.0 { -1.0 } else { 1.0 };
        let mut march = March { line: self, sign, at: from.0, least: sign * from.1, exact: true };
        let bracket = match self.surface.cells() {
            Some(cells) => {
                let stretch = [from.0, end];
                cells.walk(self.surface.level(), &self.ray, stretch, &mut |to, known| march.on(to, known))
            }
            None => march.on(end, Stretch::Slopes(f64::NEG_INFINITY, f64::INFINITY)),
        }?;
        let zero = refine(&mut |t| sign * self.value(t), bracket, self.width()).far;
        Some((zero.0, sign * zero.1))
    }

    /// How far apart the ends of a refined zero may be.
    fn width(&self) -> f64 {
        let bounds = self.surface.container.bounds();
        8.0 * EPSILON * (bounds.min.abs().max(bounds.max.abs()).max_element() + self.surface.size())
    }

    /// The end of the piece in which a zero lies, when `start..end` is halved down to pieces shorter than the
    /// accuracy; the zero itself where that is too coarse, or steps over a thin part.
    fn end_of_piece(&self, zero: (f64, f64), start: f64, end: f64) -> f64 {
        if !self.surface.in_pieces(self.accuracy) || zero.0 <= start {
            return zero.0;
        }
        let mut piece = end - start;
        while piece >= self.accuracy {
            piece *= 0.5;
        }
        let t = start + ((zero.0 - start) / piece).ceil() * piece;
        if t <= end && (self.value(t) < 0.0) == (zero.1 < 0.0) { t } else { zero.0 }
    }
}

/// Looks for the place where a function that is not negative at first becomes negative.
struct March<'a> {
    line: &'a Line<'a>,
    /// Times this the field is the function.
    sign: f64,
    /// How far it has been looked at.
    at: f64,
    /// A number that the function is not below there, or its value.
    least: f64,
    exact: bool,
}

impl March<'_> {
    /// Goes on to `to` on a stretch of which this is known.
    fn on(&mut self, to: f64, known: Stretch) -> Option<Bracket> {
        let clear = if self.sign > 0.0 { Stretch::Positive } else { Stretch::Negative };
        if known == clear {
            (self.at, self.least, self.exact) = (to, 0.0, false);
            return None;
        }
        let slopes = self.slopes(known);
        let fall = slopes.0.min(0.0) * (to - self.at);
        if self.least + fall >= 0.0 && !fall.is_nan() {
            (self.at, self.least, self.exact) = (to, self.least + slopes.0 * (to - self.at), false);
            return None;
        }
        let mut f = |t: f64| self.sign * self.line.value(t);
        let near = (self.at, if self.exact { self.least } else { f(self.at) });
        let far = (to, f(to));
        let bracket = if near.1 < 0.0 {
            // Only rounding can have hidden the zero.
            Some(Bracket { near, far: near })
        } else {
            self.search(&mut f, near, far, slopes)
        };
        (self.at, self.least, self.exact) = (to, far.1, true);
        bracket
    }

    /// The slopes that are known, or else the scene's bound.
    fn slopes(&self, known: Stretch) -> (f64, f64) {
        let (low, high) = match known {
            Stretch::Slopes(low, high) if self.sign > 0.0 => (low, high),
            Stretch::Slopes(low, high) => (-high, -low),
            _ => (f64::NEG_INFINITY, f64::INFINITY),
        };
        let surface = self.line.surface;
        let bound = if surface.evaluate.is_some() { f64::INFINITY } else { surface.max_gradient };
        (if low.is_finite() { low } else { -bound }, if high.is_finite() { high } else { bound })
    }

    fn search(
        &self,
        f: &mut impl FnMut(f64) -> f64,
        near: (f64, f64),
        far: (f64, f64),
        slopes: (f64, f64),
    ) -> Option<Bracket> {
        let surface = self.line.surface;
        let resolution = self.line.accuracy.min(LARGEST_PIECE * surface.size());
        let Some([least, factor, _]) = surface.evaluate else {
            return first_bracket(f, near, far, &mut |_, _| Bound { slopes, resolution });
        };
        // The bound grows with the slopes seen; what was left out before it grew is searched again.
        let start = surface.max_gradient.max(least);
        let mut steepest = start;
        let within = |steepest: f64| (slopes.0.max(-steepest), slopes.1.min(steepest));
        let mut adapt = |near: (f64, f64), far: (f64, f64)| {
            let seen = (far.1 - near.1).abs() / (far.0 - near.0);
            if seen.is_finite() && seen * factor > steepest {
                steepest = seen * factor * factor;
            }
            Bound { slopes: within(steepest), resolution }
        };
        let found = first_bracket(f, near, far, &mut adapt);
        if found.is_some() || steepest == start {
            return found;
        }
        let slopes = within(steepest);
        first_bracket(f, near, far, &mut |_, _| Bound { slopes, resolution })
    }
}

impl Shape for Isosurface {
    fn depth(&self) -> u32 {
        self.function.depth()
    }

    fn bounds(&self) -> Aabb {
        self.container.bounds()
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        self.cross(ray, range, |crossing| {
            out.push(crossing);
            false
        });
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let mut nearest = None;
        self.cross(ray, range, |crossing| {
            nearest = Some(crossing);
            true
        });
        nearest
    }

    fn contains(&self, p: Vec3) -> bool {
        self.container.contains(p) && self.value(p) <= 0.0
    }

    fn normal(&self, p: Vec3, crossing: &Crossing) -> Vec3 {
        if crossing.part >= CONTAINER {
            let part = crossing.part - CONTAINER;
            return self.container.normal(p, &Crossing { part, ..*crossing });
        }
        let step = self.accuracy.max(SKIP * self.size());
        let here = self.value(p);
        let slope = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| self.value(p + step * axis) - here);
        let n = Vec3::from_array(slope);
        if n.is_finite() { n.normalize_or(Vec3::X) } else { Vec3::X }
    }

    fn locate(&self, ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        if crossing.part >= CONTAINER {
            let part = crossing.part - CONTAINER;
            return self.container.locate(ray, &Crossing { part, ..*crossing });
        }
        let p = ray.at(crossing.t);
        let reach = ray.origin.abs().max_element() + crossing.t.abs() + p.abs().max_element();
        let accuracy = self.accuracy_along(ray.dir);
        let behind = if self.in_pieces(accuracy) { accuracy } else { 0.0 };
        (p, behind + rounding(reach + self.size()))
    }

    fn placed(&self, to_world: &Transform) -> Option<Arc<dyn Shape>> {
        Some(Arc::new(Self { to_world: to_world.forward.matrix3, ..self.clone() }))
    }

    fn kind(&self) -> &'static str {
        "isosurface"
    }

    fn heap_bytes(&self) -> usize {
        self.cells.get().and_then(Option::as_ref).map_or(0, Cells::heap_bytes)
    }
}

#[cfg(test)]
mod tests;
