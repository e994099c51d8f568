//! Gathering one sample: rays over the hemisphere, and what they bring.

use super::super::path::{Interiors, Path};
use super::super::tracer::Tracer;
use super::directions::Frame;
use super::query::Query;
use super::{Radiosity, Sample};
use crate::color::Rgb;
use crate::math::{Range, Ray, Vec3};
use crate::world::{Hit, RayClass};

/// Distance that stands for having met nothing.
const NOTHING: f64 = 2e10;

/// A sample whose nearest thing is nearer than this share of the largest reuse distance is not kept.
const TOO_NEAR: f64 = 1e-4;

/// Draws of directions per ray, where those below a surface are passed over.
const MOST_DRAWS: usize = 5;

/// Sums over the rays of one gather.
struct Sums {
    color: Rgb,
    quality: f32,
    /// Sum of the distances' reciprocals.
    inverse: f64,
    nearest: f64,
    towards: Vec3,
}

impl Sums {
    fn new() -> Self {
        Self { color: Rgb::ZERO, quality: 0.0, inverse: 0.0, nearest: NOTHING, towards: Vec3::ZERO }
    }

    fn add_distance(&mut self, distance: f64, direction: Vec3) {
        self.inverse += 1.0 / distance;
        if distance < self.nearest {
            self.nearest = distance;
            self.towards = direction;
        }
    }
}

impl Tracer<'_> {
    /// Colour and quality; the sample is kept if it can serve elsewhere.
    pub(super) fn gather(&mut self, query: &Query) -> (Rgb, f32) {
        let Some(radiosity) = &mut self.radiosity else { return (Rgb::ZERO, 0.0) };
        let depth = radiosity.depth;
        let count = radiosity.rays(depth);
        let path = radiosity.ray_path(depth);
        let (quality, adc, level) = (radiosity.quality, self.adc_bailout, self.max_level);
        radiosity.depth = depth + 1;
        self.adc_bailout = radiosity.settings.adc_bailout;
        self.max_level = self.max_level.max(path.level + 1);
        let mut sums = Sums::new();
        let bumpy = query.normal != query.facing;
        let mut directions = Shower::new(query, count);
        for i in 0..count {
            let direction = self.draw(&mut directions, depth, bumpy);
            let share = if count > 1 { i as f64 / (count - 1) as f64 } else { 0.0 };
            self.gather_ray(&query.departure.ray(direction), &path, share, count, &mut sums);
        }
        (self.adc_bailout, self.max_level) = (adc, level);
        let Some(radiosity) = &mut self.radiosity else { return (Rgb::ZERO, 0.0) };
        radiosity.depth = depth;
        let color = if sums.quality > 0.0 { sums.color / sums.quality } else { Rgb::ZERO };
        let mean_quality = sums.quality / count as f32;
        radiosity.quality = quality.max(mean_quality);
        let normal = if directions.flat_rays * 2 > count { query.facing } else { query.normal };
        let eye = (query.departure.point - self.world.scene.camera.location).length();
        radiosity.keep(query, normal, color, mean_quality, &sums, count, eye);
        (color, mean_quality)
    }

    /// One ray; `share` is its place among the `count` rays, 0 to 1.
    fn gather_ray(&mut self, ray: &Ray, path: &Path, share: f64, count: usize, sums: &mut Sums) {
        self.counters.gather_rays += 1;
        let hit = self.world.nearest(ray, Range::FORWARD, RayClass::Radiosity);
        sums.add_distance(hit.as_ref().map_or(f64::INFINITY, |h| h.t), ray.dir);
        let importance = self.importance(hit.as_ref());
        if share > f64::from(importance) {
            return;
        }
        self.set_quality(1.0);
        let mut color = self.trace_from(ray, &mut path.clone(), hit.as_ref()).rgb;
        let mut quality = self.radiosity.as_ref().map_or(1.0, |r| r.quality);
        if importance < 1.0 {
            // The rays that are shaded stand for those that are not.
            let shaded = (f64::from(importance) * (count - 1) as f64).floor() + 1.0;
            quality *= (count as f64 / shaded) as f32;
        }
        let limit = self.radiosity.as_ref().map_or(0.0, |r| r.settings.max_sample);
        let brightest = color.max_element();
        if limit > 0.0 && brightest > limit {
            color *= limit / brightest;
        }
        sums.color += quality * color;
        sums.quality += quality;
    }

    fn importance(&self, hit: Option<&Hit>) -> f32 {
        hit.map_or(self.world.scene.globals.importance, |h| self.world.importance(h))
    }

    fn set_quality(&mut self, quality: f32) {
        if let Some(radiosity) = &mut self.radiosity {
            radiosity.quality = quality;
        }
    }

    /// The next direction; with a bumpy normal those below the surface are passed over while draws last.
    fn draw(&mut self, shower: &mut Shower, depth: u32, bumpy: bool) -> Vec3 {
        let Some(radiosity) = &mut self.radiosity else { return shower.facing };
        while bumpy && shower.draws < shower.most {
            shower.draws += 1;
            let direction = shower.frame.to_world(radiosity.direction(depth));
            if direction.dot(shower.facing) > 0.0 {
                return direction;
            }
        }
        shower.flat_rays += usize::from(bumpy);
        shower.flat.to_world(radiosity.direction(depth))
    }
}

/// The directions of one gather.
struct Shower {
    frame: Frame,
    /// Around the geometric normal.
    flat: Frame,
    facing: Vec3,
    draws: usize,
    most: usize,
    /// Rays that had to do with the geometric normal though the surface is bumpy.
    flat_rays: usize,
}

impl Shower {
    fn new(query: &Query, count: usize) -> Self {
        Self {
            frame: Frame::new(query.normal),
            flat: Frame::new(query.facing),
            facing: query.facing,
            draws: 0,
            most: MOST_DRAWS * count,
            flat_rays: 0,
        }
    }
}

impl Radiosity {
    fn rays(&self, depth: u32) -> usize {
        let count = f64::from(self.settings.count) / f64::from(1u32 << depth);
        (count.floor() as usize).max(5).min(self.lighting.directions.len())
    }

    fn direction(&mut self, depth: u32) -> Vec3 {
        let next = &mut self.next[depth as usize];
        let direction = self.lighting.directions.get(*next);
        *next += 1;
        direction
    }

    /// What every ray of a gather starts with.
    pub(super) fn ray_path(&self, depth: u32) -> Path {
        let least = self.settings.adc_bailout + 1e-10;
        let weight = (0.5 * self.settings.brightness).powi(depth as i32 + 1);
        Path {
            level: 3 * (depth + 1) / 2,
            weight: weight.max(least),
            class: RayClass::Radiosity,
            wavelength: None,
            inside: Interiors::new(),
        }
    }

    /// Files the sample, `eye` away from the camera, unless something stands too near.
    #[allow(clippy::too_many_arguments)]
    fn keep(
        &mut self,
        query: &Query,
        normal: Vec3,
        color: Rgb,
        quality: f32,
        sums: &Sums,
        count: usize,
        eye: f64,
    ) {
        let s = &self.settings;
        let scale = f64::from(1u32 << self.depth);
        let (low, high) = (scale * s.minimum_reuse * eye, scale * s.maximum_reuse * eye);
        if sums.nearest <= TOO_NEAR * high {
            return;
        }
        let radius = (count as f64 / sums.inverse).max(low).min(high);
        self.own.insert(Sample {
            depth: self.depth,
            point: query.departure.point,
            normal,
            color,
            quality,
            radius: radius as f32,
            nearest: sums.nearest as f32,
            towards: sums.towards,
            reach: super::reach(s, self.depth, radius),
        });
    }
}
