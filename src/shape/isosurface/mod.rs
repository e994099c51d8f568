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
//! A ray is searched for the first short interval at whose end the sign has changed: intervals in which the
//! slope's bound allows no zero are left out ([`search`]), and so are stretches in which the function's
//! range is known to have one sign ([`cells`]).
//!
//! Numerical care: within that interval the zero is refined to rounding, so that `accuracy` limits what is
//! found, not where it lies. Lengths are the object's own unless it is enlarged, when they are the world's:
//! a small copy looks like the large one. A ray that starts on the surface steps a ten-millionth of the
//! container away before it looks at the sign. The normal is taken from differences forward by `accuracy`.
//!
//! Reference: D. Kalra and A. Barr, "Guaranteed Ray Intersections with Implicit Surfaces", SIGGRAPH 1989.

mod cells;
mod search;

use super::container::Clip;
use super::{Container, Crossing, Shape, rounding};
use crate::math::field::Field;
use crate::math::{Aabb, EPSILON, Range, Ray, Transform, Vec3};
use cells::Cells;
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
    /// Shortest interval that is searched.
    resolution: f64,
    cells: Arc<OnceLock<Option<Cells>>>,
}

/// Parts of the container's surface have numbers from here.
const CONTAINER: u32 = 1;

/// How far a ray that starts on the surface steps from it, in container sizes.
const SKIP: f64 = 1e-7;

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
            resolution: f64::INFINITY,
            cells: Arc::default(),
        }
    }

    fn value(&self, p: Vec3) -> f64 {
        self.function.value(p) - self.threshold
    }

    fn size(&self) -> f64 {
        self.container.bounds().size().max_element()
    }

    fn cells(&self) -> Option<&Cells> {
        let make = || Cells::new(&*self.function, self.threshold, &self.container.bounds());
        self.cells.get_or_init(make).as_ref()
    }

    /// Calls `found` with the crossings in order until it has enough.
    fn cross(&self, ray: &Ray, range: Range, mut found: impl FnMut(Crossing) -> bool) {
        let Some(clip) = self.container.clip(ray, range) else { return };
        let line = Line { surface: self, ray: Ray::new(ray.at(clip.from), ray.dir) };
        let mut left = self.max_trace;
        let mut at = (0.0, line.value(0.0));
        match clip.entry {
            None => at = self.off_the_surface(&line, at),
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
            if found(Crossing::new(clip.from + zero.0)) {
                return;
            }
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
}

impl Line<'_> {
    fn value(&self, t: f64) -> f64 {
        self.surface.value(self.ray.at(t))
    }

    /// The first zero behind `from` and the value there, which has the other sign.
    fn zero(&self, from: (f64, f64), end: f64) -> Option<(f64, f64)> {
        let sign = if from.1 < 0.0 { -1.0 } else { 1.0 };
        let mut f = |t: f64| sign * self.value(t);
        let mut first = |start: f64, stop: f64| {
            let at = |f: &mut dyn FnMut(f64) -> f64, t: f64| (t, f(t));
            let near = if start == from.0 { (from.0, sign * from.1) } else { at(&mut f, start) };
            let far = at(&mut f, stop);
            let bracket = self.bracket(&mut f, near, far)?;
            Some(refine(&mut f, bracket, self.width()).far)
        };
        let zero = match self.surface.cells() {
            Some(cells) => cells.stretches(&self.ray, [from.0, end], sign > 0.0, first),
            None => first(from.0, end),
        }?;
        Some((zero.0, sign * zero.1))
    }

    /// How far apart the ends of a refined zero may be.
    fn width(&self) -> f64 {
        let bounds = self.surface.container.bounds();
        8.0 * EPSILON * (bounds.min.abs().max(bounds.max.abs()).max_element() + self.surface.size())
    }

    fn bracket(&self, f: &mut impl FnMut(f64) -> f64, near: (f64, f64), far: (f64, f64)) -> Option<Bracket> {
        let resolution = self.surface.resolution.min(self.surface.accuracy);
        let Some([least, factor, _]) = self.surface.evaluate else {
            let bound = Bound { slope: self.surface.max_gradient, resolution };
            return first_bracket(f, near, far, &mut |_, _| bound);
        };
        // The bound grows with the slopes seen; what was left out before it grew is searched again.
        let start = self.surface.max_gradient.max(least);
        let mut slope = start;
        let mut adapt = |near: (f64, f64), far: (f64, f64)| {
            let seen = (far.1 - near.1).abs() / (far.0 - near.0);
            if seen.is_finite() && seen * factor > slope {
                slope = seen * factor * factor;
            }
            Bound { slope, resolution }
        };
        let found = first_bracket(f, near, far, &mut adapt);
        if found.is_some() || slope == start {
            return found;
        }
        first_bracket(f, near, far, &mut |_, _| Bound { slope, resolution })
    }
}

impl Shape for Isosurface {
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
        (p, rounding(reach + self.size()))
    }

    fn placed(&self, to_world: &Transform) -> Option<Arc<dyn Shape>> {
        let m = to_world.forward.matrix3;
        let stretch =
            [m.x_axis, m.y_axis, m.z_axis].map(|axis| axis.length()).into_iter().fold(1.0, f64::max);
        Some(Arc::new(Self { resolution: self.accuracy / stretch, ..self.clone() }))
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
