//! Cameras: a place on the picture to a ray. One file per family.
//!
//! Every family gets the place as fractions of the picture: `s` from -0.5 (left) to 0.5 (right) and `t`
//! from -0.5 (bottom) to 0.5 (top).

mod cylinder;
mod fisheye;
mod lens;
mod mesh;
mod omnimax;
mod orthographic;
mod panoramic;
mod perspective;
mod spherical;
mod ultra_wide;

pub use lens::Lens;
pub use mesh::{Distribution, MeshCamera};

use crate::material::{Normal, Pigment};
use crate::math::{Beam, Ray, Transform, Vec3};
use crate::pattern::Context;
use std::sync::Arc;

/// A camera with all statements worked out: `right` spans the picture's width, `up` its height.
#[derive(Clone, Debug)]
pub struct Camera {
    pub kind: CameraKind,
    pub location: Vec3,
    pub direction: Vec3,
    pub right: Vec3,
    pub up: Vec3,
    /// Kept for old scenes, whose `look_at` acts while the statement is read.
    pub sky: Vec3,
    pub look_at: Vec3,
    /// Field of view of the kinds that bend space, in radians.
    pub angle: f64,
    /// Vertical field of view of a spherical camera, in radians.
    pub vertical_angle: f64,
    pub blur: Blur,
    /// Perturbs the rays' directions.
    pub normal: Option<Arc<Normal>>,
}

#[derive(Clone, Debug)]
pub enum CameraKind {
    Perspective,
    Orthographic,
    Fisheye,
    UltraWideAngle,
    Omnimax,
    Panoramic,
    /// 1: vertical axis, fixed viewpoint; 2: horizontal, fixed; 3 and 4: viewpoint moves along the axis.
    Cylinder(u8),
    Spherical,
    Mesh(Arc<MeshCamera>),
}

/// Depth of field. Off unless both `aperture` and `max_samples` differ from 0.
#[derive(Clone, Debug)]
pub struct Blur {
    pub aperture: f64,
    pub min_samples: u32,
    pub max_samples: u32,
    pub confidence: f64,
    pub variance: f64,
    /// Distance of the sharp plane from the location.
    pub focal_distance: f64,
    /// Brightness of the lens opening over the unit square.
    pub bokeh: Option<Arc<Pigment>>,
}

impl Blur {
    pub fn is_on(&self) -> bool {
        self.aperture != 0.0 && self.max_samples > 0
    }
}

impl Default for Blur {
    fn default() -> Self {
        Self {
            aperture: 0.0,
            min_samples: 0,
            max_samples: 0,
            confidence: 0.9,
            variance: 1e-4,
            focal_distance: 1.0,
            bokeh: None,
        }
    }
}

impl Default for Camera {
    fn default() -> Self {
        Self {
            kind: CameraKind::Perspective,
            location: Vec3::ZERO,
            direction: Vec3::Z,
            right: 1.33 * Vec3::X,
            up: Vec3::Y,
            sky: Vec3::Y,
            look_at: Vec3::Z,
            angle: 90f64.to_radians(),
            vertical_angle: 90f64.to_radians(),
            blur: Blur::default(),
            normal: None,
        }
    }
}

/// A ray before its direction gets unit length, and the two numbers at which the kind's `normal` is
/// evaluated.
#[derive(Clone, Copy, Debug, PartialEq)]
struct View {
    origin: Vec3,
    direction: Vec3,
    at: (f64, f64),
}

impl Camera {
    /// The ray through (x, y) of a picture of `width` by `height` pixels; y runs down. `None` where the
    /// camera sees nothing.
    pub fn ray(&self, x: f64, y: f64, size: (f64, f64), context: &Context) -> Option<Ray> {
        self.nth_ray(0, x, y, size, context)
    }

    /// How many rays through one place make up its colour: their mean.
    pub fn rays(&self) -> usize {
        if let CameraKind::Mesh(mesh) = &self.kind { mesh.rays_per_pixel } else { 1 }
    }

    /// What a ray meets beyond this distance is not seen.
    pub fn max_distance(&self) -> f64 {
        if let CameraKind::Mesh(mesh) = &self.kind { mesh.max_distance } else { f64::INFINITY }
    }

    /// Ray number `k` of [`Camera::rays`] through (x, y).
    #[inline]
    pub fn nth_ray(
        &self,
        k: usize,
        x: f64,
        y: f64,
        (width, height): (f64, f64),
        context: &Context,
    ) -> Option<Ray> {
        let (s, t) = (x / width - 0.5, 0.5 - y / height);
        if let (CameraKind::Perspective, None) = (&self.kind, &self.normal) {
            let direction = perspective::view(self, s, t).direction.normalize();
            return direction.is_finite().then(|| Ray::new(self.location, direction));
        }
        self.nth_of_any(k, (x, y), (s, t), (width, height), context)
    }

    /// The same for every kind; `s` and `t` are the place in parts of the picture from its middle.
    #[inline(never)]
    fn nth_of_any(
        &self,
        k: usize,
        (x, y): (f64, f64),
        (s, t): (f64, f64),
        (width, height): (f64, f64),
        context: &Context,
    ) -> Option<Ray> {
        let view = match &self.kind {
            CameraKind::Mesh(mesh) => {
                let along = (self.location.z, self.direction.z < 0.0);
                let ray = mesh.ray(k, (x, y), (width, height), along)?;
                View { origin: ray.origin, direction: ray.dir, at: (s, t) }
            }
            _ => self.view(s, t)?,
        };
        let direction = view.direction.normalize();
        let direction = match &self.normal {
            Some(normal) => {
                normal.perturb(direction, Vec3::new(view.at.0, view.at.1, 0.0), context).normalize()
            }
            None => direction,
        };
        direction.is_finite().then(|| Ray::new(view.origin, direction))
    }

    /// `None` for a mesh camera, whose rays do not hang on the place alone.
    fn view(&self, s: f64, t: f64) -> Option<View> {
        match self.kind {
            CameraKind::Perspective => Some(perspective::view(self, s, t)),
            CameraKind::Orthographic => Some(orthographic::view(self, s, t)),
            CameraKind::Fisheye => fisheye::view(self, s, t),
            CameraKind::UltraWideAngle => Some(ultra_wide::view(self, s, t)),
            CameraKind::Omnimax => omnimax::view(self, s, t),
            CameraKind::Panoramic => Some(panoramic::view(self, s, t)),
            CameraKind::Cylinder(number) => Some(cylinder::view(self, number, s, t)),
            CameraKind::Spherical => Some(spherical::view(self, s, t)),
            CameraKind::Mesh(_) => None,
        }
    }

    /// The beam of all rays through a rectangle of the picture, if the camera has one.
    pub fn beam(&self, x: [f64; 2], y: [f64; 2], (width, height): (f64, f64)) -> Option<Beam> {
        if !matches!((&self.kind, &self.normal), (CameraKind::Perspective, None)) || self.blur.is_on() {
            return None;
        }
        let edge = |x: f64, y: f64| perspective::view(self, x / width - 0.5, 0.5 - y / height).direction;
        Beam::new(self.location, [edge(x[0], y[0]), edge(x[1], y[0]), edge(x[1], y[1]), edge(x[0], y[1])])
    }

    /// Whether all rays start at one point.
    pub fn has_fixed_origin(&self) -> bool {
        !self.blur.is_on()
            && !matches!(
                self.kind,
                CameraKind::Orthographic | CameraKind::Cylinder(3 | 4) | CameraKind::Mesh(_)
            )
    }

    /// Moves the camera.
    pub fn apply(&mut self, t: &Transform) {
        self.location = t.point(self.location);
        self.direction = t.vector(self.direction);
        self.right = t.vector(self.right);
        self.up = t.vector(self.up);
    }
}
