//! Straight lines stay straight: direction `d + s right + t up`.

use super::{Camera, View};

#[inline]
pub(super) fn view(camera: &Camera, s: f64, t: f64) -> View {
    View {
        origin: camera.location,
        direction: camera.direction + s * camera.right + t * camera.up,
        at: (s, t),
    }
}
