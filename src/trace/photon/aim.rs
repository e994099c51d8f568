//! Where photons start: rings around the direction from a light to a target, wide enough to cover the
//! target's bounding sphere.
//!
//! With `S` the spacing at unit distance, rings lie `atan S` apart, photons on a ring as far apart as the
//! rings; each is shaken within its place.

use crate::light::{Light, LightKind};
use crate::math::random::{UNIFORM_ENTRIES, uniform, uniform_table};
use crate::math::{Ray, Vec3};
use crate::scene::PhotonSettings;
use crate::world::{PhotonRules, PhotonTarget, World};
use std::f64::consts::{PI, TAU};

/// Photons of a light with less than this share of its brightness are not shot.
const FAINT: f64 = 1e-5;

/// Uniform numbers in a fixed order, used again and again.
#[derive(Clone, Copy, Debug, Default)]
pub struct Stream(usize);

impl Stream {
    /// The numbers after number `i` of a row of `cycle`.
    pub fn at(i: usize, cycle: usize) -> Self {
        Self(i % cycle)
    }

    /// The next of the first `cycle` numbers.
    pub fn draw_of(&mut self, cycle: usize) -> f64 {
        self.0 = (self.0 + 1) % cycle;
        uniform(uniform_table(), self.0)
    }

    pub fn draw(&mut self) -> f64 {
        self.0 = (self.0 + 1) % UNIFORM_ENTRIES;
        uniform(uniform_table(), self.0)
    }
}

/// What photons of one light do at surfaces of one kind.
#[derive(Clone, Copy, Debug)]
pub struct Kinds {
    pub refraction: bool,
    pub reflection: bool,
}

impl Kinds {
    /// On at the light or the object, and off at neither.
    pub fn new(light: &Light, rules: &PhotonRules) -> Self {
        let on = |a: Option<bool>, b: Option<bool>| {
            a != Some(false) && b != Some(false) && (a == Some(true) || b == Some(true))
        };
        Self {
            refraction: on(light.photons.refraction, rules.refraction),
            reflection: on(light.photons.reflection, rules.reflection),
        }
    }

    fn any(self) -> bool {
        self.refraction || self.reflection
    }
}

/// One light shooting at one target.
#[derive(Clone, Debug)]
pub struct Aim {
    /// Place in `World::lights`.
    pub light: usize,
    pub target: u32,
    /// Spacing of photons at distance 1, or everywhere for parallel light.
    pub spacing: f64,
    pub parallel: bool,
    center: Vec3,
    starts: Vec<Start>,
    /// Angle, or radius for parallel light, of the last ring.
    end: f64,
}

/// A lamp that photons start from.
#[derive(Clone, Copy, Debug)]
struct Start {
    lamp: Vec3,
    /// Towards the target, or along parallel light.
    axis: Vec3,
    /// Across the axis.
    side: Vec3,
    /// The share of the light.
    share: f64,
}

/// A photon about to start.
#[derive(Clone, Debug)]
pub struct Shot {
    pub ray: Ray,
    /// The share of the light's colour.
    pub strength: f32,
    /// The ring that it belongs to, counted within its salvo.
    pub ring: usize,
}

/// Every light with every target that it shoots at.
pub fn aims(world: &World, settings: &PhotonSettings) -> Vec<Aim> {
    let pairs = || {
        world.lights.iter().enumerate().filter(|(_, l)| !l.light.shadowless).flat_map(|(i, light)| {
            let targets = world.targets.iter().enumerate().filter(|(_, t)| !t.ignores_global_lights);
            targets
                .map(move |(j, target)| (i, j as u32, &light.light, target))
                .filter(|(_, _, light, target)| Kinds::new(light, &target.rules).any())
        })
    };
    let spacing = match settings.count {
        0 => settings.spacing,
        count => {
            let expected: f64 = pairs().map(|(_, _, l, t)| expected(l, t, settings.spacing)).sum();
            settings.spacing * (expected / f64::from(count)).sqrt()
        }
    };
    if !(spacing > 0.0) {
        return Vec::new();
    }
    pairs().filter_map(|(light, target, l, t)| Aim::new((light, l), (target, t), spacing)).collect()
}

/// A rough count of the photons that a pair will store.
fn expected(light: &Light, target: &PhotonTarget, spacing: f64) -> f64 {
    let kinds = Kinds::new(light, &target.rules);
    let both = kinds.refraction && kinds.reflection;
    let shot = if both { 1.5 } else { 1.0 };
    let stored = match (target.rules.collect && kinds.refraction, both) {
        (false, _) => 1.0,
        (true, true) => 3.0,
        (true, false) => 2.0,
    };
    let (_, radius) = sphere(target);
    let ratio = radius / (f64::from(target.density) * spacing);
    0.5 * PI * ratio * ratio * shot * stored
}

/// The sphere around a target's box, which is kept in single precision.
fn sphere(target: &PhotonTarget) -> (Vec3, f64) {
    let low = target.bounds.min.as_vec3().as_dvec3();
    let size = target.bounds.size().as_vec3().as_dvec3();
    (low + 0.5 * size, 0.5 * size.length())
}

impl Aim {
    fn new(
        (number, light): (usize, &Light),
        (target, t): (u32, &PhotonTarget),
        spacing: f64,
    ) -> Option<Self> {
        let (center, radius) = sphere(t);
        let parallel = light.parallel || matches!(light.kind, LightKind::Cylinder(_));
        let distance = (center - light.location).length();
        let mut spacing = f64::from(t.density) * spacing;
        if !parallel {
            spacing /= distance;
        }
        if let Some(area) = light.area.as_ref().filter(|_| light.photons.area_light) {
            spacing *= f64::from(area.size1 * area.size2).sqrt();
        }
        let end = match () {
            () if parallel => radius,
            () if distance < radius => PI,
            () => (radius / distance).asin(),
        };
        let usable = radius.is_finite() && radius > 0.0 && spacing > 0.0 && spacing.is_finite();
        let starts = starts(light, center, parallel);
        usable.then_some(Self { light: number, target, spacing, parallel, center, starts, end })
    }

    /// Distance between rings.
    pub fn step(&self) -> f64 {
        if self.parallel { self.spacing } else { self.spacing.atan() }
    }

    /// Whether there is a ring at `t`.
    pub fn reaches(&self, t: f64) -> bool {
        t < self.end
    }

    /// Whether shooting ends after a ring at `t` that missed, when earlier ones had hit.
    pub fn stops(&self, t: f64, autostop: f64) -> bool {
        t > autostop * self.end
    }

    /// The photons of the ring at `t`, in order, for `visit`.
    pub fn ring(
        &self,
        light: &Light,
        t: f64,
        jitter: f64,
        random: &mut Stream,
        mut visit: impl FnMut(Ray, f32),
    ) {
        let step = self.step();
        let around = match () {
            () if t < 1e-10 => TAU,
            () if self.parallel => step / t,
            () => step / t.sin(),
        };
        let first = -PI + 0.5 * around * random.draw();
        let mut phi = first;
        while phi < TAU + first - 0.5 * around {
            let shaken = phi + around * (random.draw() - 0.5) * jitter;
            let t = t + step * (random.draw() - 0.5) * jitter;
            for start in &self.starts {
                self.shot(light, start, (t, shaken), &mut visit);
            }
            phi += around;
        }
    }

    fn shot(&self, light: &Light, start: &Start, (t, phi): (f64, f64), visit: &mut impl FnMut(Ray, f32)) {
        let Start { lamp, axis, side, share } = *start;
        let ray = if self.parallel {
            let back = axis.dot(self.center - lamp);
            Ray::new(self.center - axis * back + turned(side * t, axis, phi), axis)
        } else {
            let (sin, cos) = t.sin_cos();
            Ray::new(lamp, turned(cos * axis - sin * side, axis, phi).normalize_or(axis))
        };
        let cone = match &light.kind {
            LightKind::Point => 1.0,
            LightKind::Spot(beam) => beam.factor(ray.dir.dot(light.axis())),
            LightKind::Cylinder(beam) => {
                // Only the distance from the axis matters; the start lies on either side of the lamp.
                let from_axis = ray.origin - light.location;
                let axis = light.axis();
                beam.factor(from_axis - from_axis.dot(axis) * axis + axis, axis)
            }
        };
        if cone >= FAINT {
            visit(ray, (cone * share) as f32);
        }
    }
}

/// The lamps of a light that shoots at `center`.
fn starts(light: &Light, center: Vec3, parallel: bool) -> Vec<Start> {
    let start = |offset: Vec3, share: f64| {
        let lamp = light.location + offset;
        let axis = if parallel { light.axis() } else { (center - lamp).normalize_or(Vec3::Z) };
        Start { lamp, axis, side: across(axis), share }
    };
    let area = light.area.as_ref().filter(|_| light.photons.area_light && !parallel);
    let Some(area) = area else { return vec![start(Vec3::ZERO, 1.0)] };
    let part = |i: u32, n: u32| if n > 1 { f64::from(i) / f64::from(n - 1) - 0.5 } else { 0.0 };
    let share = 1.0 / f64::from(area.size1 * area.size2);
    let offset = |u: u32, v: u32| part(u, area.size1) * area.axis1 + part(v, area.size2) * area.axis2;
    let places = (0..area.size1).flat_map(|u| (0..area.size2).map(move |v| (u, v)));
    places.map(|(u, v)| start(offset(u, v), share)).collect()
}

/// A unit vector across `axis`.
fn across(axis: Vec3) -> Vec3 {
    let up = if (axis.z.abs() - 1.0).abs() < 0.1 { Vec3::Y } else { Vec3::Z };
    axis.cross(up).normalize()
}

/// `v` turned around the unit vector `n`.
fn turned(v: Vec3, n: Vec3, angle: f64) -> Vec3 {
    let (sin, cos) = angle.sin_cos();
    v * cos + n.cross(v) * sin + n * (n.dot(v) * (1.0 - cos))
}
