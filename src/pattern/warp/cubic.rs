use crate::math::Vec3;
use crate::pattern::cubic::pyramid;

/// Folds a picture around a cube: the six faces lie in a cross four wide and three high.
pub(super) fn apply(p: Vec3) -> Vec3 {
    let Vec3 { x, y, z } = p;
    // Along the picture: eighths of the ratio; across it: sixths.
    let (eighth, sixth) = (|r: f64| (r + 1.0) / 8.0, |r: f64| (r + 1.0) / 6.0);
    let middle = 1.0 / 3.0;
    match pyramid(p) {
        0 => Vec3::new(0.75 - eighth(z / x), middle + sixth(y / x), x),
        1 => Vec3::new(0.25 + eighth(x / y), 1.0 - sixth(z / y), y),
        2 => Vec3::new(0.25 + eighth(x / z), middle + sixth(y / z), z),
        3 => Vec3::new(eighth(z / -x), middle + sixth(y / -x), -x),
        4 => Vec3::new(0.25 + eighth(x / -y), sixth(z / -y), -y),
        _ => Vec3::new(1.0 - eighth(x / -z), middle + sixth(y / -z), -z),
    }
}
