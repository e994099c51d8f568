//! Cameras: a place on the picture to a ray.

use crate::math::Vec3;

/// A camera with all statements worked out: `right` spans the picture's width, `up` its height.
#[derive(Clone, Debug)]
pub struct Camera {
    pub kind: CameraKind,
    pub location: Vec3,
    pub direction: Vec3,
    pub right: Vec3,
    pub up: Vec3,
}

#[derive(Clone, Debug, PartialEq)]
pub enum CameraKind {
    Perspective,
    Orthographic,
}
