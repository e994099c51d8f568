use crate::color::Rgb;

/// How a surface answers to light. Angles and exponents as in the scene language.
#[derive(Clone, Debug, PartialEq)]
pub struct Finish {
    pub ambient: Rgb,
    pub emission: Rgb,
    /// Front side, after any `albedo` scaling.
    pub diffuse: f32,
    /// Back side, after any `albedo` scaling.
    pub diffuse_back: f32,
    /// As written, before `albedo` scaling; radiosity and subsurface light use these.
    pub raw_diffuse: f32,
    pub raw_diffuse_back: f32,
    pub brilliance: f32,
    pub crand: f32,
    pub phong: f32,
    pub phong_size: f32,
    pub specular: f32,
    /// Exponent, 1/roughness.
    pub specular_exponent: f32,
    /// Metallic highlight, 0 for off.
    pub metallic: f32,
    pub irid: f32,
    pub irid_thickness: f32,
    pub irid_turbulence: f32,
    pub reflection: Reflection,
    pub conserve_energy: bool,
    /// Subsurface translucency; `None` for off.
    pub subsurface: Option<Rgb>,
    /// Old `refraction` factor at every surface, 1 by default.
    pub refraction: f32,
    /// Old `ior` and `caustics` in a finish, which move to the interior.
    pub ior: Option<f32>,
    pub caustics: Option<f32>,
}

/// Reflectivity between `min` (looking straight on) and `max` (grazing).
#[derive(Clone, Debug, PartialEq)]
pub struct Reflection {
    pub min: Rgb,
    pub max: Rgb,
    pub falloff: f32,
    /// The reflected colour is raised to this power (1/exponent as written).
    pub power: f32,
    pub metallic: f32,
    pub fresnel: bool,
}

impl Default for Reflection {
    fn default() -> Self {
        Self { min: Rgb::ZERO, max: Rgb::ZERO, falloff: 1.0, power: 1.0, metallic: 0.0, fresnel: false }
    }
}

impl Default for Finish {
    fn default() -> Self {
        Self {
            ambient: Rgb::splat(0.1),
            emission: Rgb::ZERO,
            diffuse: 0.6,
            diffuse_back: 0.0,
            raw_diffuse: 0.6,
            raw_diffuse_back: 0.0,
            brilliance: 1.0,
            crand: 0.0,
            phong: 0.0,
            phong_size: 40.0,
            specular: 0.0,
            specular_exponent: 20.0,
            metallic: 0.0,
            irid: 0.0,
            irid_thickness: 0.0,
            irid_turbulence: 0.0,
            reflection: Reflection::default(),
            conserve_energy: false,
            subsurface: None,
            refraction: 1.0,
            ior: None,
            caustics: None,
        }
    }
}
