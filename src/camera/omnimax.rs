//! A fisheye of 180 degrees whose picture is squeezed for a dome, without the part behind 135 degrees
//! below.
//!
//! The angle from the viewing direction is `1.411269 r - 0.09439 r^3 + 0.25674 r^5` at radius `r`.

use super::fisheye::{azimuth, polar};
use super::{Camera, View};

/// Shape of the picture's frame, width to height.
const ASPECT: f64 = 1.283458;

pub(super) fn view(camera: &Camera, s: f64, t: f64) -> Option<View> {
    let (mut a, mut b) = (2.0 * s, 2.0 * t);
    let aspect = camera.right.length() / camera.up.length();
    if aspect > ASPECT {
        a *= aspect / ASPECT;
        b = (b - 1.0) / ASPECT + 1.0;
    } else if aspect > 1.0 {
        b = (b - 1.0) / aspect + 1.0;
    } else {
        b /= aspect;
    }
    let r = a.hypot(b);
    if r > 1.0 {
        return None;
    }
    let phi = azimuth(a, b, r);
    let theta = 1.411269 * r - 0.09439 * r.powi(3) + 0.25674 * r.powi(5);
    let floor = 135f64.to_radians().tan();
    (phi.sin() * theta.sin() >= floor * theta.cos()).then(|| View {
        origin: camera.location,
        direction: polar(camera, phi, theta),
        at: (phi, theta),
    })
}
