//! What is neither prepared nor consulted, because nothing asked for it.

use super::required::Required;
use crate::world::{Stats, World};
use serde::Serialize;

#[derive(Serialize)]
pub struct LeftOut {
    pub what: &'static str,
    pub why: &'static str,
}

/// Everything that this scene does not pay for.
pub fn all(world: &World, stats: &Stats, required: &Required) -> Vec<LeftOut> {
    let patterned = required.pigments.keys().any(|k| k != "plain") || !required.texture_patterns.is_empty();
    let lights = world.lights.len() + world.group_lights.len();
    let has = |what: &str| required.atmosphere.contains_key(what);
    let candidates = [
        (stats.accel == "none", "tree", "too few objects with bounds: each is asked in turn"),
        (lights == 0, "lighting", "there is no light: surfaces show what they emit"),
        (lights > 0 && lights == required.shadowless_lights, "shadow rays", "no light casts shadows"),
        (
            lights > 0 && world.all_opaque(),
            "tinted shadows",
            "every object is opaque: the first one found ends a shadow ray",
        ),
        (!required.lights.contains_key("area"), "area light grids", "no light has an area"),
        (required.reflecting_layers == 0, "reflected rays", "no finish reflects"),
        (required.transparent_layers == 0, "refracted rays", "no pigment lets light through"),
        (!patterned, "patterns", "all pigments are plain: no point is looked up"),
        (required.normals.is_empty(), "perturbed normals", "no texture has a normal"),
        (required.highlight_layers == 0, "highlights", "no finish has phong or specular"),
        (required.iridescent_layers == 0, "iridescence", "no finish has irid"),
        (!has("fog") && !has("rainbow"), "fog and rainbows", "there are none"),
        (!has("media") && required.media_interiors == 0, "media", "nothing is filled with any"),
        (!has("sky_sphere"), "sky sphere", "there is none"),
        (!has("radiosity"), "radiosity", "global_settings does not ask for it"),
        (!has("photons"), "photons", "global_settings does not ask for them"),
        (!required.focal_blur, "focal blur", "the camera has no aperture"),
    ];
    candidates
        .into_iter()
        .filter(|(left_out, ..)| *left_out)
        .map(|(_, what, why)| LeftOut { what, why })
        .collect()
}
