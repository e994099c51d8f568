//! Parallel rays: origin `location + s right + t up`.

use super::{Camera, View};

pub(super) fn view(camera: &Camera, s: f64, t: f64) -> View {
    View {
        origin: camera.location + s * camera.right + t * camera.up,
        direction: camera.direction,
        at: (s, t),
    }
}
