use crate::light::Light;
use crate::math::Transform;

/// A light moved to world space. Radii of cylindrical beams are not scaled.
pub(super) fn place_light(light: &Light, to_world: &Transform) -> Light {
    let mut placed = light.clone();
    if to_world.is_identity() {
        return placed;
    }
    placed.location = to_world.point(light.location);
    placed.direction = to_world.vector(light.direction).normalize_or(light.direction);
    if let Some(area) = &mut placed.area {
        area.axis1 = to_world.vector(area.axis1);
        area.axis2 = to_world.vector(area.axis2);
    }
    placed
}
