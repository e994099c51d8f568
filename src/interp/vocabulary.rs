//! The words that fit in each block: what an error about another one suggests.
//!
//! Words that begin an expression fit wherever a value does and are not listed.

/// What a block holds.
pub(super) struct Items {
    /// One of them, in the words of a message.
    pub noun: &'static str,
    /// Words that begin one, with spaces between.
    pub words: &'static str,
}

pub(super) const FINISH: Items = Items {
    noun: "a finish item",
    words: "ambient brilliance caustics conserve_energy crand diffuse emission ior irid metallic phong \
            phong_size reflection reflection_exponent refraction roughness specular subsurface",
};

pub(super) const REFLECTION: Items = Items {
    noun: "a reflection item",
    words: "alpha blue color colour exponent falloff filter fresnel green metallic red rgb rgbf rgbft rgbt srgb \
            srgbf srgbft srgbt transmit",
};

pub(super) const PIGMENT: Items = Items {
    noun: "a pigment item",
    words: "agate agate_turb aoi average blue boxed bozo brick brick_size bumps cells checker color color_map \
            colour colour_map control0 control1 coords crackle cubic cubic_wave cylindrical density_file dents \
            exponent exterior filter form frequency function gradient granite green hexagon image_map \
            image_pattern interior interpolate julia lambda leopard magnet mandel marble matrix metric mortar \
            no_bump_scale noise_generator number_of_sides number_of_tiles object octaves offset omega onion \
            pattern pavement phase pigment_map pigment_pattern planar poly_wave quick_color quick_colour quilted \
            radial ramp_wave red rgb rgbf rgbft rgbt ripples rotate scale scallop_wave sine_wave size slope \
            spherical spiral1 spiral2 spotted square srgb srgbf srgbft srgbt tiling transform translate transmit \
            triangle_wave triangular turbulence uv_mapping warp waves wood wrinkles",
};

pub(super) const DENSITY: Items = Items {
    noun: "a density item",
    words: "agate agate_turb aoi average blue boxed bozo brick brick_size bumps cells checker color color_map \
            colour colour_map control0 control1 coords crackle cubic cubic_wave cylindrical density_file \
            density_map dents exponent exterior filter form frequency function gradient granite green hexagon \
            image_pattern interior interpolate julia lambda leopard magnet mandel marble matrix metric mortar \
            no_bump_scale noise_generator number_of_sides number_of_tiles object octaves offset omega onion \
            pattern pavement phase pigment_pattern planar poly_wave quick_color quick_colour quilted radial \
            ramp_wave red rgb rgbf rgbft rgbt ripples rotate scale scallop_wave sine_wave size slope spherical \
            spiral1 spiral2 spotted square srgb srgbf srgbft srgbt tiling transform translate transmit \
            triangle_wave triangular turbulence uv_mapping warp waves wood wrinkles",
};

pub(super) const NORMAL: Items = Items {
    noun: "a normal item",
    words: "accuracy agate agate_turb aoi average boxed bozo brick brick_size bump_map bump_size bumps cells \
            checker control0 control1 coords crackle cubic cubic_wave cylindrical density_file dents exponent \
            exterior facets form frequency function gradient granite hexagon image_pattern interior interpolate \
            julia lambda leopard magnet mandel marble matrix metric mortar no_bump_scale noise_generator \
            normal_map number_of_sides number_of_tiles object octaves offset omega onion pattern pavement phase \
            pigment_pattern planar poly_wave quilted radial ramp_wave ripples rotate scale scallop_wave \
            sine_wave size slope slope_map spherical spiral1 spiral2 spotted square tiling transform translate \
            triangle_wave triangular turbulence uv_mapping warp waves wood wrinkles",
};

pub(super) const TEXTURE: Items = Items {
    noun: "a texture item",
    words: "agate agate_turb aoi average boxed bozo brick brick_size bumps cells checker control0 control1 \
            coords crackle cubic cubic_wave cylindrical density_file dents exponent exterior finish form \
            frequency function gradient granite hexagon image_pattern interior interpolate julia lambda leopard \
            magnet mandel marble material_map matrix metric mortar no_bump_scale noise_generator normal \
            number_of_sides number_of_tiles object octaves offset omega onion pattern pavement phase pigment \
            pigment_pattern planar poly_wave quilted radial ramp_wave ripples rotate scale scallop_wave \
            sine_wave size slope spherical spiral1 spiral2 spotted square texture_map tiles tiling transform \
            translate triangle_wave triangular turbulence uv_mapping warp waves wood wrinkles",
};

pub(super) const INTERIOR: Items = Items {
    noun: "an interior item",
    words: "caustics dispersion dispersion_samples fade_color fade_colour fade_distance fade_power ior media \
            refraction",
};

pub(super) const MATERIAL: Items = Items {
    noun: "a texture, an interior, a transformation",
    words: "interior interior_texture matrix rotate scale texture transform translate",
};

pub(super) const MEDIA: Items = Items {
    noun: "a media item",
    words: "aa_level aa_threshold absorption collect confidence density emission intervals jitter matrix method \
            ratio rotate samples scale scattering transform translate variance",
};

pub(super) const LIGHT: Items = Items {
    noun: "a light source item",
    words: "adaptive alpha area_illumination area_light blue circular color_map colour_map cylinder \
            fade_distance fade_power falloff filter green jitter looks_like matrix media_attenuation \
            media_interaction orient parallel photons point_at projected_through radius red rotate scale \
            shadowless spotlight tightness transform translate transmit",
};

pub(super) const OBJECT: Items = Items {
    noun: "an object modifier",
    words: "bounded_by clipped_by color colour double_illuminate dtag finish hierarchy hollow inside_vector \
            interior interior_texture inverse material matrix no_image no_radiosity no_reflection no_shadow \
            normal photons pigment radiosity rotate scale smooth_triangle texture transform translate triangle \
            uv_mapping",
};

pub(super) const CAMERA: Items = Items {
    noun: "a camera item",
    words: "angle aperture blur_samples bokeh confidence cylinder direction fisheye focal_point location look_at \
            matrix mesh_camera normal omnimax orthographic panoramic perspective right rotate scale sky \
            spherical transform translate ultra_wide_angle up variance",
};

pub(super) const FOG: Items = Items {
    noun: "a fog item",
    words: "blue color colour distance filter fog_alt fog_offset fog_type green lambda matrix octaves omega red \
            rgb rgbf rgbft rgbt rotate scale srgb srgbf srgbft srgbt transform translate transmit turb_depth \
            turbulence up",
};

pub(super) const RAINBOW: Items = Items {
    noun: "a rainbow item",
    words: "angle arc_angle color_map colour_map direction distance falloff_angle jitter up width",
};

pub(super) const IMAGE_MAP: Items = Items {
    noun: "an image item",
    words: "filter gamma interpolate map_type offset once premultiplied repeat transmit use_color use_colour \
            use_index",
};

pub(super) const BUMP_MAP: Items = Items {
    noun: "an image item",
    words: "bump_size gamma interpolate map_type offset once premultiplied repeat use_color use_colour use_index",
};

pub(super) const IMAGE_PATTERN: Items = Items {
    noun: "an image item",
    words: "gamma interpolate map_type offset once premultiplied repeat use_alpha use_color use_colour use_index",
};

pub(super) const GLOBAL_SETTINGS: Items = Items {
    noun: "a setting of `global_settings`",
    words: "adc_bailout ambient_light assumed_gamma charset hf_gray_16 irid_wavelength max_intersections \
            max_trace_level mm_per_unit noise_generator number_of_waves photons radiosity subsurface",
};

pub(super) const RADIOSITY: Items = Items {
    noun: "a setting of `radiosity`",
    words: "adc_bailout always_sample brightness count error_bound gray_threshold load_file low_error_factor \
            max_sample maximum_reuse media minimum_reuse nearest_count normal pretrace_end pretrace_start \
            recursion_limit save_file subsurface",
};

pub(super) const PHOTONS: Items = Items {
    noun: "a setting of `photons`",
    words: "adc_bailout autostop count expand_thresholds gather jitter load_file max_trace_level media radius \
            save_file spacing",
};

pub(super) const SUBSURFACE: Items = Items { noun: "a setting of `subsurface`", words: "radiosity samples" };

pub(super) const WARP: Items = Items {
    noun: "a kind of warp (turbulence, repeat, black_hole, spherical, cylindrical, toroidal, planar, cubic)",
    words: "black_hole cubic cylindrical planar repeat spherical toroidal turbulence",
};

pub(super) const IMAGE_TYPES: Items = Items {
    noun: "an image's type or its file name",
    words: "bmp exr function gif hdr iff jpeg pgm png ppm tga tiff",
};

pub(super) const STATEMENTS: Items = Items {
    noun: "an object or a directive",
    words: "background bicubic_patch blob box camera composite cone cubic cylinder declare default difference \
            disc fog global_settings height_field include intersection isosurface julia_fractal lathe \
            light_group light_source max_trace_level media merge mesh mesh2 object ovus parametric plane poly \
            polygon polynomial prism quadric quartic rainbow sky_sphere smooth_triangle sor sphere sphere_sweep \
            superellipsoid text torus triangle union",
};
