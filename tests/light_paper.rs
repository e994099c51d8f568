//! Light whose amount is known on paper.

use glint::interp::interpret_str;
use glint::render::{Settings as Rendering, Unobserved, indirect, render};
use glint::trace::{Overrides, Settings, Tracer};
use glint::world::World;

/// All colours of a picture, row by row.
fn picture(text: &str, (width, height): (u32, u32), reference: bool) -> Vec<[f64; 3]> {
    let text = format!("#version 3.7;\n{text}");
    let world = World::prepare(interpret_str(&text).scene.unwrap_or_else(|e| panic!("{}", e.message)));
    let overrides = Overrides { reference, ..Overrides::default() };
    let settings = Settings { width, height, overrides, ..Settings::default() };
    let rendering = Rendering::new(width, height);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).stack_size(64 << 20).build().unwrap();
    let (light, _) = indirect(&world, &settings, &rendering, &pool, &Unobserved);
    let picture = std::sync::Mutex::new(glint::picture::Picture::new(width, height));
    render(&rendering, &pool, &picture, &Unobserved, || Tracer::lit(&world, &settings, &light));
    let picture = picture.into_inner().unwrap();
    let pixel = |i: u32| picture.get(i % width, i / width).rgb.to_array().map(f64::from);
    (0..width * height).map(pixel).collect()
}

fn mean(pixels: &[[f64; 3]]) -> f64 {
    pixels.iter().map(|p| p[0]).sum::<f64>() / pixels.len() as f64
}

/// A closed room whose surfaces all send out `e` and reflect the share `d`: after n bounces the radiance is
/// `e (1 + d + ... + d^n)` everywhere.
#[test]
fn furnace() {
    let (e, d) = (0.1, 0.7);
    for bounces in [1, 3] {
        let scene = format!(
            "global_settings {{ assumed_gamma 1 radiosity {{ recursion_limit {bounces} count 40 \
             adc_bailout 0.0001 }} }} \
             camera {{ location <0.3, 0.2, -0.5> look_at <1, -1, 2> angle 100 }} \
             box {{ -2, <2, 2, 3> inverse pigment {{ rgb 1 }} finish {{ emission {e} diffuse {d} }} }}"
        );
        let expected = e * (1.0 - f64::powi(d, bounces + 1)) / (1.0 - d);
        for reference in [false, true] {
            for p in picture(&scene, (12, 9), reference) {
                assert!((p[0] / expected - 1.0).abs() < 1e-3, "{bounces} {reference}: {p:?} {expected}");
            }
        }
    }
}

/// The share of one unit square's light that another receives, as the mean brightness of the white second one
/// when the first shines.
fn form_factor(lamp: &str, settings: &str, reference: bool) -> f64 {
    let scene = format!(
        "global_settings {{ assumed_gamma 1 radiosity {{ recursion_limit 1 {settings} }} }} \
         camera {{ orthographic location <0.5, 0.4, 0.5> direction -y up z right x }} \
         polygon {{ 5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 0> rotate 90*x pigment {{ rgb 1 }} \
                    finish {{ diffuse 1 emission 0 }} }} \
         polygon {{ 5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 0> {lamp} no_image pigment {{ rgb 1 }} \
                    finish {{ diffuse 0 emission 1 }} }}"
    );
    mean(&picture(&scene, (24, 24), reference))
}

/// Two unit squares facing each other at distance 1, and two that share an edge at a right angle.
///
/// Reference: J. R. Howell, "A Catalog of Radiation Configuration Factors", C-11 and C-14.
#[test]
fn form_factors_of_squares() {
    let cache = "count 400 error_bound 0.2 nearest_count 5 pretrace_end 0.04 minimum_reuse 0.01";
    for (lamp, expected) in [("rotate 90*x translate y", 0.19982), ("", 0.20004)] {
        let truth = form_factor(lamp, cache, true);
        assert!((truth - expected).abs() < 4e-3, "{lamp}: {truth}, not {expected}");
        let cached = form_factor(lamp, cache, false);
        assert!((cached - expected).abs() < 1.2e-2, "{lamp}: {cached}, not {expected}");
    }
}

/// Light that goes through clear glass reaches the floor: what a sphere bends and a slab shifts is not lost.
#[test]
fn photons_keep_energy() {
    let floor = |glass: &str| {
        let scene = format!(
            "global_settings {{ assumed_gamma 1 photons {{ spacing 0.05 radius 0.12 }} }} \
             camera {{ orthographic location <0, 0.5, 0> direction -y up 8*z right 8*x }} \
             light_source {{ <0, 50, 0>, rgb 0.5 parallel point_at 0 }} \
             plane {{ y, 0 pigment {{ rgb 1 }} finish {{ ambient 0 diffuse 1 }} }} {glass}"
        );
        mean(&picture(&scene, (32, 32), false))
    };
    let plain = floor("");
    assert!((plain - 0.5).abs() < 1e-6, "{plain}");
    let glass = "pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 } \
                 photons { target refraction on reflection off }";
    for shape in ["box { <-1.5, 2, -1.5>, <1.5, 2.6, 1.5>", "sphere { <0, 2.2, 0>, 1"] {
        let lit = floor(&format!("{shape} {glass} }}"));
        assert!((lit / plain - 1.0).abs() < 0.01, "{shape}: {lit}, not {plain}");
    }
}

/// What a medium leaves of light over a distance: `exp(-absorption * distance)`.
#[test]
fn beer() {
    let scene = "global_settings { assumed_gamma 1 } background { rgb 1 } \
                 camera { orthographic location -5*z direction z up y right x } \
                 box { <-1, -1, 0>, <1, 1, 3> hollow pigment { rgbt 1 } \
                       interior { media { absorption <0.1, 0.4, 1> } } }";
    for reference in [false, true] {
        for p in picture(scene, (2, 2), reference) {
            for (i, absorption) in [0.1, 0.4, 1.0].into_iter().enumerate() {
                let expected = f64::exp(-3.0 * absorption);
                assert!((p[i] - expected).abs() < 1e-6, "{p:?}");
            }
        }
    }
}

/// Light from behind the viewer, scattered back once in a slab of thickness L: `s I (1 - exp(-2 s L))/(2 s)` for
/// scattering and extinction s.
#[test]
fn single_scattering_in_a_slab() {
    let (s, thickness) = (0.5, 2.0);
    let scene = |media: &str| {
        format!(
            "global_settings {{ assumed_gamma 1 }} \
             camera {{ orthographic location -5*z direction z up y right x }} \
             light_source {{ -100*z, rgb 0.8 parallel point_at 0 }} \
             box {{ <-50, -50, 0>, <50, 50, {thickness}> hollow pigment {{ rgbt 1 }} finish {{ diffuse 0 ambient 0 }} \
                    interior {{ media {{ scattering {{ 1, {s} }} {media} }} }} }}"
        )
    };
    let expected = 0.8 * (1.0 - f64::exp(-2.0 * s * thickness)) / 2.0;
    let truth = mean(&picture(&scene(""), (8, 8), true));
    assert!((truth / expected - 1.0).abs() < 0.01, "{truth}, not {expected}");
    let fine = mean(&picture(&scene("method 2 intervals 20 samples 2"), (2, 2), false));
    assert!((fine / expected - 1.0).abs() < 0.01, "{fine}, not {expected}");
}

/// `2/(1 + (d/f)^2)`.
#[test]
fn fading_by_the_square_of_the_distance() {
    for (distance, fade) in [(1.0, 2.0), (4.0, 2.0), (30.0, 0.5)] {
        let scene = format!(
            "global_settings {{ assumed_gamma 1 }} \
             camera {{ orthographic location 0.5*y direction -y up 0.0001*z right 0.0001*x }} \
             light_source {{ {distance}*y, rgb 0.4 fade_distance {fade} fade_power 2 }} \
             plane {{ y, 0 pigment {{ rgb 1 }} finish {{ ambient 0 diffuse 1 }} }}"
        );
        let ratio: f64 = distance / fade;
        let expected = 0.4 * 2.0 / (1.0 + ratio * ratio);
        let found = mean(&picture(&scene, (1, 1), false));
        assert!((found / expected - 1.0).abs() < 1e-6, "{distance} {fade}: {found}, not {expected}");
    }
}

/// Of many lights a few are tested where rays are gathered; the light of a room stays the same in the mean.
#[test]
fn a_few_of_many_lights_do() {
    let scene = |lights: &str| {
        format!(
            "global_settings {{ assumed_gamma 1 radiosity {{ recursion_limit 1 count 400 error_bound 0.3 \
             pretrace_end 0.02 }} }} \
             camera {{ location <0, 0, -1.9> look_at 0 angle 100 }} {lights} \
             box {{ -2, 2 inverse pigment {{ rgb 1 }} finish {{ diffuse 0.5 }} }} \
             sphere {{ <0, 0.9, 0.5>, 0.6 pigment {{ rgb 1 }} finish {{ diffuse 0.5 }} }}"
        )
    };
    let lamp = |x: f64, share: f64| {
        format!("light_source {{ <{x}, 1.9, 0.3>, {share} fade_distance 2 fade_power 2 }}")
    };
    let places: Vec<f64> = (0..8).map(|i| -1.4 + 0.4 * f64::from(i)).collect();
    let few: Vec<String> = places.iter().map(|&x| lamp(x, 0.1)).collect();
    let chosen = mean(&picture(&scene(&few.concat()), (24, 18), false));
    // The sum over the lights, each alone: too few to be chosen among.
    let alone: f64 = places.iter().map(|&x| mean(&picture(&scene(&lamp(x, 0.1)), (24, 18), false))).sum();
    assert!((chosen / alone - 1.0).abs() < 0.01, "{chosen} {alone}");
}

/// Wine that is wider than its glass by a hair, or by far less: the same light. Where two surfaces lie nearer than
/// 0.0001 to each other the reference drops one of them, and its rays stay in the glass.
#[test]
fn hairs_breadths_do_not_matter() {
    let wine = |gap: f64| {
        format!(
            "global_settings {{ assumed_gamma 1 max_trace_level 12 }} background {{ rgb 0.5 }} \
             camera {{ location <0, 2, -6> look_at 0 angle 25 }} light_source {{ <5, 8, -6> rgb 1 }} \
             difference {{ cylinder {{ -1.2*y, 1.2*y, 1 }} cylinder {{ -y, 1.3*y, 0.9 }} \
             pigment {{ rgbf 0.95 }} finish {{ diffuse 0 }} interior {{ ior 1.5 }} }} \
             cylinder {{ -(1 + {gap})*y, 0.6*y, 0.9 + {gap} pigment {{ rgbf <0.9, 0.1, 0.2, 0.95> }} \
             finish {{ diffuse 0 }} interior {{ ior 1.2 }} }}"
        )
    };
    let [a, b] = [1e-8, 1e-3].map(|gap| picture(&wine(gap), (32, 24), false));
    let difference = |(a, b): (&[f64; 3], &[f64; 3])| (a[1] - b[1]).abs();
    let mean = a.iter().zip(&b).map(difference).sum::<f64>() / a.len() as f64;
    assert!(mean < 0.01, "{mean}");
}
