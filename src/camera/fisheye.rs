//! Distance from the picture's centre is proportional to the angle from the viewing direction; the
//! circle of radius 1 (measured with |right|, |up|) shows half of `angle`.

use super::{Camera, View};
use crate::math::Vec3;
use std::f64::consts::PI;

pub(super) fn view(camera: &Camera, s: f64, t: f64) -> Option<View> {
    let (a, b) = (2.0 * s * camera.right.length(), 2.0 * t * camera.up.length());
    let radius = a.hypot(b);
    (radius <= 1.0).then(|| {
        let phi = azimuth(a, b, radius);
        let theta = 0.5 * radius * camera.angle;
        View { origin: camera.location, direction: polar(camera, phi, theta), at: (phi, theta) }
    })
}

/// The angle of (a, b) around the centre, from -pi/2 to 3 pi/2.
pub(super) fn azimuth(a: f64, b: f64, radius: f64) -> f64 {
    if radius == 0.0 {
        return 0.0;
    }
    let phi = (b / radius).clamp(-1.0, 1.0).asin();
    if a < 0.0 { PI - phi } else { phi }
}

/// The direction `theta` away from the viewing direction, at the angle `phi` from right towards up.
pub(super) fn polar(camera: &Camera, phi: f64, theta: f64) -> Vec3 {
    phi.cos() * theta.sin() * camera.right.normalize()
        + phi.sin() * theta.sin() * camera.up.normalize()
        + theta.cos() * camera.direction.normalize()
}
