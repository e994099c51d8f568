//! Half a turn horizontally, and nearly all of the height: a cylinder seen from its axis.
//!
//! With `p = (0.5 - s) pi` and `q = t pi`: direction `cos p right + tan q up + sin p direction`.

use super::{Camera, View};
use std::f64::consts::PI;

/// Stands for the tangent of a right angle.
const STEEP: f64 = 2e10;

pub(super) fn view(camera: &Camera, s: f64, t: f64) -> View {
    let (p, q) = ((0.5 - s) * PI, t * PI);
    let slope = if q.abs() < 0.5 * PI { q.tan() } else { STEEP.copysign(q) };
    let direction = p.cos() * camera.right + slope * camera.up + p.sin() * camera.direction;
    View { origin: camera.location, direction, at: (p, q) }
}
