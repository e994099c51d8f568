//! The picture is projected on a cylinder. 1: upright, 2: lying; 3 and 4: the same with a viewpoint that
//! moves along the axis, so that lines across it stay level.

use super::{Camera, View};
use crate::math::Vec3;

pub(super) fn view(camera: &Camera, number: u8, s: f64, t: f64) -> View {
    let (width, height) = (camera.right.length(), camera.up.length());
    let (right, up, ahead) = (camera.right / width, camera.up / height, camera.direction.normalize());
    let upright = matches!(number, 1 | 3);
    let (angle, along) = if upright { (s * camera.angle, t * height) } else { (t * camera.angle, s * width) };
    let (axis, across) = if upright { (up, right) } else { (right, up) };
    let level = angle.sin() * across + angle.cos() * ahead;
    let (shift, direction) =
        if number <= 2 { (Vec3::ZERO, level + along * axis) } else { (along * axis, level) };
    let at = if upright { (angle, along) } else { (along, angle) };
    View { origin: camera.location + shift, direction, at }
}
