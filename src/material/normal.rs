//! Perturbed surface normals.
//!
//! A normal is taken into the pattern's space, perturbed at the warped point, and brought back. In between it
//! is kept at unit length, so that bumps keep their slope when the pattern is scaled; `no_bump_scale` leaves
//! lengths alone until the end, in everything nested inside too.

use crate::math::{Transform, Vec3};
use crate::pattern::image::ImageMap;
use crate::pattern::{BlendMap, Blended, Chain, Context, Signal};
use std::sync::Arc;

/// A perturbation of surface normals.
///
/// | setting | default | meaning |
/// |---|---|---|
/// | amount | 0.5 | height of the bumps, in single precision |
/// | accuracy | 0.02 | step over which heights are compared |
#[derive(Clone, Debug)]
pub struct Normal {
    pub kind: NormalKind,
    pub signal: Signal,
    pub amount: f64,
    pub accuracy: f64,
    /// `normal_map`, or the items of a list or an average.
    pub map: Option<BlendMap<Arc<Normal>>>,
    /// Height and slope by pattern value.
    pub slopes: Option<BlendMap<(f64, f64)>>,
    /// Whether bumps keep their slope under scaling; off for `no_bump_scale`.
    pub scale_bumps: bool,
    depth: u32,
    cost: f64,
}

#[derive(Clone, Debug)]
pub enum NormalKind {
    /// No pattern: nothing is perturbed.
    Flat,
    Patterned,
    Average,
    /// The slopes of an image's heights.
    Image(ImageMap),
    /// The inner normal at the surface's (u, v, 0).
    Uv(Arc<Normal>),
}

impl Default for Normal {
    fn default() -> Self {
        Self {
            kind: NormalKind::Flat,
            signal: Signal::default(),
            amount: 0.5,
            accuracy: f64::from(0.02_f32),
            map: None,
            slopes: None,
            scale_bumps: true,
            depth: 1,
            cost: 1.0,
        }
    }
}

/// The way into a pattern's space for normals.
pub(super) struct Frame<'a> {
    pub chain: &'a Chain,
    pub scale_bumps: bool,
}

impl Frame<'_> {
    pub fn enter(&self, n: Vec3) -> Vec3 {
        if self.scale_bumps { unit(self.chain.inward_normal(n)) } else { self.chain.inward_normal(n) }
    }

    pub fn leave(&self, n: Vec3) -> Vec3 {
        if self.scale_bumps { unit(self.chain.outward_normal(unit(n))) } else { self.chain.outward_normal(n) }
    }
}

/// `n` at unit length; 0 stays.
fn unit(n: Vec3) -> Vec3 {
    n.normalize_or_zero()
}

/// Corners of a regular tetrahedron: where heights are compared, and where they push the normal.
const DIRECTIONS: [Vec3; 4] = [
    Vec3::new(0.942809041, -0.333333333, 0.0),
    Vec3::new(-0.471404521, -0.333333333, 0.816496581),
    Vec3::new(-0.471404521, -0.333333333, -0.816496581),
    Vec3::new(0.0, 1.0, 0.0),
];

impl Normal {
    /// Perturbs `n` at `p`, both in the space that the normal statement is attached in. `n` is turned
    /// towards the ray and need not have unit length; the result has.
    pub fn perturb(&self, n: Vec3, p: Vec3, context: &Context) -> Vec3 {
        let perturbed = self.perturb_within(n, p, true, context);
        perturbed.try_normalize().unwrap_or_else(|| n.normalize_or_zero())
    }

    /// The same inside something whose bumps keep their slope, or do not. The result has unit length only
    /// if bumps keep their slope here too.
    pub(super) fn perturb_within(&self, n: Vec3, p: Vec3, scale_bumps: bool, context: &Context) -> Vec3 {
        let scale_bumps = scale_bumps && self.scale_bumps;
        let frame = Frame { chain: &self.signal.chain, scale_bumps };
        match &self.kind {
            NormalKind::Flat => n,
            NormalKind::Uv(inner) => match context.hit {
                Some(hit) => inner.perturb_within(n, hit.uv.extend(0.0), scale_bumps, context),
                None => n,
            },
            NormalKind::Average => {
                let m = frame.enter(n);
                frame.leave(self.average(m, self.signal.warp_alone(p), scale_bumps, context))
            }
            NormalKind::Image(map) => {
                let m = frame.enter(n);
                frame.leave(map.perturb(m, self.amount, self.signal.warp_alone(p)))
            }
            NormalKind::Patterned => {
                let m = frame.enter(n);
                frame.leave(self.patterned(m, self.signal.warp(p), scale_bumps, context))
            }
        }
    }

    fn average(&self, m: Vec3, q: Vec3, scale_bumps: bool, context: &Context) -> Vec3 {
        let Some(map) = &self.map else { return m };
        let add = |sum, (weight, item): (f64, &Arc<Normal>)| {
            sum + weight * item.perturb_within(m, q, scale_bumps, context)
        };
        map.iter().fold(Vec3::ZERO, add) / map.total_weight()
    }

    fn patterned(&self, m: Vec3, q: Vec3, scale_bumps: bool, context: &Context) -> Vec3 {
        if let Some(map) = &self.map {
            let perturbed = |item: &Normal| item.perturb_within(m, q, scale_bumps, context);
            return match map.at(self.signal.value(q, context)) {
                Blended::One(item) => perturbed(item),
                Blended::Two(t, low, high) => (1.0 - t) * perturbed(low) + t * perturbed(high),
            };
        }
        if let Some(perturbed) = self.signal.perturb(m, self.amount, q, context) {
            return perturbed;
        }
        let accuracy = if self.signal.pattern.character().items.is_some() { 0.02 } else { self.accuracy };
        let step = -5.0 * self.amount * (0.02 / accuracy);
        let push = |sum, &v: &Vec3| sum + step * self.height(q + accuracy * v, context) * v;
        DIRECTIONS.iter().fold(m, push)
    }

    fn height(&self, q: Vec3, context: &Context) -> f64 {
        let v = self.signal.value(q, context);
        match self.slopes.as_ref().map(|slopes| slopes.at(v)) {
            None => v,
            Some(Blended::One(&(height, _))) => height,
            Some(Blended::Two(t, &(h1, s1), &(h2, s2))) => {
                let (cubic, square) = (s1 + s2 + 2.0 * (h1 - h2), 2.0 * s1 + s2 + 3.0 * (h1 - h2));
                ((t * cubic - square) * t + s1) * t + h1
            }
        }
    }

    /// Whether bumps hang on how a ray met the surface, not on the point alone.
    pub fn asks_hit(&self) -> bool {
        let asks = match &self.kind {
            NormalKind::Uv(_) => true,
            NormalKind::Patterned => self.signal.pattern.asks_hit(),
            _ => false,
        };
        asks || self.map.iter().flat_map(BlendMap::items).any(|n| n.asks_hit())
    }

    /// Moves the bumps.
    pub fn transform(&mut self, t: &Transform) {
        self.signal.transform(t);
    }

    /// How deep normals are nested in this one, itself included.
    pub fn depth(&self) -> u32 {
        self.depth
    }

    /// How many normals are asked for one direction at most.
    pub fn cost(&self) -> f64 {
        self.cost
    }

    /// Works out how normals are nested. Call it after every change.
    pub fn settle(&mut self) {
        let items = |of: fn(&Normal) -> u32| {
            self.map.iter().flat_map(BlendMap::items).map(|n| of(n)).max().unwrap_or(0)
        };
        let (depth, cost) = match (&self.kind, &self.map) {
            (NormalKind::Uv(inner), _) => (inner.depth, inner.cost),
            (NormalKind::Patterned, Some(map)) => (items(Normal::depth), map.cost(|n| n.cost)),
            (_, Some(map)) => (items(Normal::depth), map.items().map(|n| n.cost).sum()),
            (_, None) => (0, 0.0),
        };
        self.depth = 1 + depth.max(self.signal.pattern.depth());
        self.cost = 1.0 + self.signal.pattern.cost() + cost;
    }
}
