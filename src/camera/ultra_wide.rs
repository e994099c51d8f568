//! Picture coordinates are angles, horizontally and vertically: like a fisheye that fills the rectangle.

use super::{Camera, View};

pub(super) fn view(camera: &Camera, s: f64, t: f64) -> View {
    let p = s * camera.angle;
    let q = t * camera.angle * camera.up.length() / camera.right.length();
    let direction = p.sin() * camera.right.normalize()
        + q.sin() * camera.up.normalize()
        + p.cos() * q.cos() * camera.direction.normalize();
    View { origin: camera.location, direction, at: (p, q) }
}
