//! Longitude across, latitude up: `angle` degrees wide, `vertical_angle` high.

use super::{Camera, View};
use crate::math::Transform;

pub(super) fn view(camera: &Camera, s: f64, t: f64) -> View {
    let (longitude, latitude) = (s * camera.angle, t * camera.vertical_angle);
    let tilted =
        Transform::rotate_axis(camera.right.normalize(), -latitude).vector(camera.direction.normalize());
    let direction = Transform::rotate_axis(camera.up.normalize(), longitude).vector(tilted);
    View { origin: camera.location, direction, at: (longitude, latitude) }
}
