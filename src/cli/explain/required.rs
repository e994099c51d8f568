//! What the scene's author asked for.

use crate::camera::CameraKind;
use crate::light::{Light, LightKind};
use crate::material::Ingredients;
use crate::world::{Stats, World};
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt::Write;

#[derive(Serialize)]
pub struct Required {
    pub camera: String,
    pub focal_blur: bool,
    /// Shapes by kind, copies counted each.
    pub objects: BTreeMap<&'static str, usize>,
    /// CSG combinations and clipped objects.
    pub combinations: usize,
    pub combination_depth: usize,
    pub lights: BTreeMap<&'static str, usize>,
    pub group_lights: usize,
    pub shadowless_lights: usize,
    pub pigments: BTreeMap<String, usize>,
    pub normals: BTreeMap<String, usize>,
    pub texture_patterns: BTreeMap<String, usize>,
    pub layers: usize,
    pub transparent_layers: usize,
    pub reflecting_layers: usize,
    pub iridescent_layers: usize,
    pub subsurface_layers: usize,
    pub highlight_layers: usize,
    /// Interiors that bend light or weaken it.
    pub refracting_interiors: usize,
    pub media_interiors: usize,
    /// Fog, sky and their like, and effects of the whole scene.
    pub atmosphere: BTreeMap<&'static str, usize>,
    pub max_trace_level: u32,
}

impl Required {
    pub fn of(world: &World, stats: &Stats) -> Self {
        let all = world.ingredients();
        let Ingredients { pigments, normals, texture_patterns, .. } = all.clone();
        let (refracting_interiors, media_interiors) = world.interior_counts();
        let lights = world.lights.iter().chain(&world.group_lights).map(|l| &l.light);
        let mut kinds = BTreeMap::new();
        for light in lights.clone() {
            *kinds.entry(light_kind(light)).or_default() += 1;
        }
        Self {
            camera: camera_kind(&world.scene.camera.kind),
            focal_blur: world.scene.camera.blur.is_on(),
            objects: stats.shapes.clone(),
            combinations: stats.combinations,
            combination_depth: world.csg_depth(),
            lights: kinds,
            group_lights: world.group_lights.len(),
            shadowless_lights: lights.filter(|l| l.shadowless).count(),
            pigments,
            normals,
            texture_patterns,
            layers: all.layers,
            transparent_layers: all.transparent_layers,
            reflecting_layers: all.reflecting_layers,
            iridescent_layers: all.iridescent_layers,
            subsurface_layers: all.subsurface_layers,
            highlight_layers: all.highlight_layers,
            refracting_interiors,
            media_interiors,
            atmosphere: atmosphere(world),
            max_trace_level: world.scene.globals.max_trace_level,
        }
    }

    pub fn write(&self, text: &mut String) {
        let blur = if self.focal_blur { ", focal blur" } else { "" };
        let lines = [
            ("camera", format!("{}{blur}", self.camera)),
            ("objects", list(&self.objects)),
            ("combinations", format!("{}, {} deep", self.combinations, self.combination_depth)),
            ("lights", list(&self.lights)),
            ("pigments", list(&self.pigments)),
            ("normals", list(&self.normals)),
            ("texture patterns", list(&self.texture_patterns)),
            ("texture layers", self.layers()),
            (
                "interiors",
                format!("{} refracting, {} media", self.refracting_interiors, self.media_interiors),
            ),
            ("atmosphere", list(&self.atmosphere)),
            ("trace level", self.max_trace_level.to_string()),
        ];
        for (what, value) in lines {
            let _ = writeln!(text, "  {what:<18} {value}");
        }
    }

    fn layers(&self) -> String {
        let kinds = [
            (self.transparent_layers, "transparent"),
            (self.reflecting_layers, "reflecting"),
            (self.highlight_layers, "with highlights"),
            (self.iridescent_layers, "iridescent"),
            (self.subsurface_layers, "with subsurface light"),
        ];
        let kinds = kinds.iter().filter(|(n, _)| *n > 0).map(|(n, what)| format!(", {n} {what}"));
        format!("{}{}", self.layers, kinds.collect::<String>())
    }
}

fn list<K: std::fmt::Display>(counts: &BTreeMap<K, usize>) -> String {
    if counts.is_empty() {
        return "none".into();
    }
    counts.iter().map(|(what, n)| format!("{n} {what}")).collect::<Vec<_>>().join(", ")
}

fn light_kind(light: &Light) -> &'static str {
    match (&light.area, light.parallel, &light.kind) {
        (Some(_), _, _) => "area",
        (None, true, _) => "parallel",
        (None, false, LightKind::Point) => "point",
        (None, false, LightKind::Spot(_)) => "spotlight",
        (None, false, LightKind::Cylinder(_)) => "cylinder",
    }
}

fn camera_kind(kind: &CameraKind) -> String {
    match kind {
        CameraKind::Perspective => "perspective",
        CameraKind::Orthographic => "orthographic",
        CameraKind::Fisheye => "fisheye",
        CameraKind::UltraWideAngle => "ultra_wide_angle",
        CameraKind::Omnimax => "omnimax",
        CameraKind::Panoramic => "panoramic",
        CameraKind::Cylinder(n) => return format!("cylinder {n}"),
        CameraKind::Spherical => "spherical",
        CameraKind::Mesh(_) => "mesh_camera",
    }
    .to_owned()
}

fn atmosphere(world: &World) -> BTreeMap<&'static str, usize> {
    let (scene, globals) = (&world.scene, &world.scene.globals);
    let all = [
        ("sky_sphere", usize::from(scene.sky_sphere.is_some())),
        ("fog", scene.fogs.len()),
        ("rainbow", scene.rainbows.len()),
        ("media", scene.media.len()),
        ("radiosity", usize::from(globals.radiosity.is_some())),
        ("photons", usize::from(globals.photons.is_some())),
    ];
    all.into_iter().filter(|(_, n)| *n > 0).collect()
}
