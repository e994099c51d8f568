//! Where numbers run out: scales, distances, thin shapes, surfaces that nearly coincide, input that makes no
//! sense. docs/numerics.md has the promises and the figures; benches/extremes.sh makes the large tables.

use glint::color::Rgb;
use glint::interp::interpret_str;
use glint::math::{Range, Ray, Vec3};
use glint::scene::Scene;
use glint::trace::{Pixel, Settings, Tracer};
use glint::world::{ObjectQuery, RayClass, World};

const EVERYTHING: &str = include_str!("extremes/everything.pov");

fn scene(text: &str) -> Result<Scene, String> {
    interpret_str(text).scene.map_err(|e| e.message.clone())
}

/// A picture's pixels, none of which may be no number.
fn picture(text: &str, (width, height): (u32, u32)) -> Vec<Pixel> {
    let world = World::prepare(scene(text).expect("a scene"));
    let settings = Settings { width, height, ..Settings::default() };
    let mut tracer = Tracer::new(&world, &settings);
    let mut pixels = Vec::new();
    for y in 0..height {
        for x in 0..width {
            tracer.seed(x, y, 0);
            pixels.push(tracer.pixel(f64::from(x) + 0.5, f64::from(y) + 0.5));
        }
    }
    assert_eq!(tracer.counters().not_numbers, 0, "{:?} in {text}", tracer.not_number());
    pixels
}

/// PSNR of the pictures as an 8-bit file would show them.
fn decibels(a: &[Pixel], b: &[Pixel]) -> f64 {
    let shown = |c: f32| f64::from(255.0 * c.clamp(0.0, 1.0).powf(1.0 / 2.2)).round();
    let channels = |p: &Pixel| [p.rgb.x, p.rgb.y, p.rgb.z].map(shown);
    let squares: f64 = a
        .iter()
        .zip(b)
        .flat_map(|(p, q)| channels(p).into_iter().zip(channels(q)))
        .map(|(p, q)| (p - q) * (p - q))
        .sum();
    10.0 * (255.0 * 255.0 * 3.0 * a.len() as f64 / squares).log10()
}

const SIZE: (u32, u32) = (64, 48);

/// The scene with every finite primitive. Texts need a font that comes with POV-Ray's include files.
fn everything(declarations: &str) -> Vec<Pixel> {
    let has_fonts = std::path::Path::new("/usr/share/povray-3.7/include/timrom.ttf").exists();
    assert!(
        has_fonts || std::env::var_os("GLINT_REQUIRE_POVRAY").is_none(),
        "povray-includes is not installed"
    );
    let lines = EVERYTHING.lines().filter(|line| has_fonts || !line.starts_with("Put(text"));
    if !has_fonts {
        println!("skipped: the text, for want of POV-Ray's fonts");
    }
    let body: Vec<&str> = lines.collect();
    picture(&format!("#version 3.7; {declarations} {}", body.join("\n")), SIZE)
}

fn compare_scales(way: &str) {
    let here = everything("#declare K = 0;");
    for k in [-12, -9, -5, -1, 2, 6, 9, 12i32] {
        let there = everything(&format!("#declare K = {k}; {way}"));
        let least = if k.abs() <= 9 { 60.0 } else { 50.0 };
        let found = decibels(&here, &there);
        assert!(found >= least, "10^{k}: {found} dB");
    }
}

#[test]
fn objects_scaled_from_10_to_the_minus_12_to_10_to_the_12() {
    compare_scales("");
}

#[test]
fn numbers_scaled_from_10_to_the_minus_12_to_10_to_the_12() {
    compare_scales("#declare Deep = 1;");
}

#[test]
fn far_from_the_middle_of_the_world() {
    let here = everything("#declare Away = 0;");
    for (k, least) in [(4, 60.0), (7, 60.0), (10, 40.0)] {
        let found = decibels(&here, &everything(&format!("#declare Away = 1e{k};")));
        assert!(found >= least, "10^{k}: {found} dB");
    }
}

/// One object, asked directly.
fn object(text: &str) -> ObjectQuery {
    let scene = scene(&format!("#version 3.7; {text}")).expect("a scene");
    ObjectQuery::new(&scene.objects[0])
}

fn hit(object: &ObjectQuery, from: Vec3, towards: Vec3) -> Option<Vec3> {
    object.trace(&Ray::new(from, towards.normalize())).map(|found| found.0)
}

/// Numbers in 0..1 that are the same on every machine.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn vector(&mut self) -> Vec3 {
        Vec3::new(self.unit(), self.unit(), self.unit()) * 2.0 - 1.0
    }
}

#[test]
fn stretched_a_thousand_million_times() {
    let mut random = Random(1);
    let texts = [
        "sphere { 0, 1 scale <1e9, 1, 1> }",
        "box { -1, 1 scale <1e9, 1, 1> }",
        "box { <-1e9, -1, -1>, <1e9, 1, 1> }",
        "cylinder { -1e9*x, 1e9*x, 1 }",
        "superellipsoid { <0.5, 0.5> scale <1e9, 1, 1> }",
        "torus { 1, 0.5 rotate 90*x scale <1e9, 1, 1> }",
    ];
    for text in texts {
        let stretched = object(text);
        for _ in 0..200 {
            // From both sides at any place along it: the two hits lie in one plane across, one above another.
            let x = (random.unit() - 0.5) * 1e9;
            let from = |y: f64| hit(&stretched, Vec3::new(x, y, 0.3), Vec3::new(0.0, -y, 0.0));
            let (above, below) = (from(7.0).expect(text), from(-7.0).expect(text));
            assert!((above.x - below.x).abs() + (above.x - x).abs() <= 1e-13 * x.abs());
            assert!((above.y + below.y).abs() < 1e-12 && above.y > 0.3 && above.y <= 1.5 + 1e-12, "{text}");
            let along = hit(&stretched, Vec3::new(-4e9, 0.6, 0.3), Vec3::X).expect(text);
            assert!(
                along.x < 0.0 && (along.y - 0.6).abs() < 1e-13 && (along.z - 0.3).abs() < 1e-13,
                "{text} {along}"
            );
        }
    }
}

#[test]
fn discs_seen_from_the_edge() {
    let disc = object("disc { 0, y, 1 }");
    for k in [3, 6, 9, 12] {
        let slope = 10f64.powi(-k);
        let p = hit(&disc, Vec3::new(-2.0, 2.0 * slope, 0.0), Vec3::new(1.0, -slope, 0.0)).expect("a hit");
        assert!(p.length() < 1e-15 / slope, "{k} {p}");
        assert!(hit(&disc, Vec3::new(-2.0, 2.0 * slope, 0.0), Vec3::new(1.0, -3.1 * slope, 0.0)).is_none());
    }
    assert_eq!(hit(&disc, Vec3::new(-2.0, 0.0, 0.0), Vec3::X), None);
    assert_eq!(hit(&disc, Vec3::new(-2.0, 1e-300, 0.0), Vec3::X), None);
}

#[test]
fn grazing_rays_hit_up_to_the_edge_and_not_beyond() {
    for text in [
        "sphere { 0, 1 }",
        "cylinder { -z, z, 1 }",
        "torus { 0.75, 0.25 rotate 90*x }",
        "ovus { 1, 0.1 rotate 90*x }",
    ] {
        let round = object(text);
        for k in 2..14 {
            let gap = 10f64.powi(-k);
            let there = |y: f64| hit(&round, Vec3::new(-5.0, y, 0.0), Vec3::X).is_some();
            assert!(there(1.0 - gap), "{text} {k}");
            assert!(!there(1.0 + gap), "{text} {k}");
        }
    }
}

/// Two mirrors that face each other, each adding a little light of its own: one part per level.
#[test]
fn mirrors_255_deep() {
    for gap in [1e-9, 1.0, 1e9] {
        let text = format!(
            "#version 3.7; global_settings {{ assumed_gamma 1 max_trace_level 255 adc_bailout 0 }}
             camera {{ location 0 look_at z angle 20 }}
             #default {{ pigment {{ rgb 1 }} finish {{ ambient 0 diffuse 0 emission 0.001 reflection 1 }} }}
             plane {{ z, {gap} }} plane {{ -z, {gap} }}"
        );
        for pixel in picture(&text, (8, 6)) {
            assert!((pixel.rgb.x - 0.255).abs() < 1e-4, "{gap}: {pixel:?}");
        }
    }
}

/// Light that is led by hundreds of total reflections comes out at the other end.
#[test]
fn a_long_fibre() {
    let text = "#version 3.7; global_settings { assumed_gamma 1 max_trace_level 256 adc_bailout 0 }
        camera { location -4999*z look_at 0 angle 4 right x up y }
        cylinder { -5000*z, 5000*z, 1 pigment { rgbt 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 } }
        background { rgb <0.9, 0.6, 0.3> }";
    let pixels = picture(text, (16, 16));
    for pixel in pixels {
        assert!((pixel.rgb - Rgb::new(0.9, 0.6, 0.3)).abs().max_element() < 1e-3, "{pixel:?}");
    }
}

/// Sheets a million millionth apart, each of which takes one hundredth of the light.
#[test]
fn stacked_sheets() {
    for (what, gap) in [
        ("plane { z, 1 + I*G", 1e-12),
        ("polygon { 4, <-9,-9>, <9,-9>, <9,9>, <-9,9> translate (1 + I*G)*z", 1e-12),
        ("disc { (1 + I*G)*z, z, 9", 1e-3),
    ] {
        let text = format!(
            "#version 3.7; global_settings {{ assumed_gamma 1 max_trace_level 20 adc_bailout 0 }}
             camera {{ location -z look_at 0 angle 40 }}
             #declare G = {gap:e}; #declare I = 0;
             #while (I < 100) {what} pigment {{ rgbf <0.99, 0.99, 0.99, 1> }} finish {{ ambient 0 diffuse 0 }} }} #declare I = I + 1; #end
             background {{ rgb 1 }}"
        );
        for pixel in picture(&text, (8, 6)) {
            assert!((pixel.rgb.x - 0.99f32.powi(100)).abs() < 1e-4, "{what} {pixel:?}");
        }
    }
}

/// Combinations whose members share faces: every ray meets the same face, or passes.
#[test]
fn shared_faces_of_combinations() {
    let mut random = Random(7);
    // A notch whose open end lies in the box's face, a step, a box between two others.
    let notch =
        object("difference { box { 0, 3 } box { <1, 1, 0>, <2, 2, 1> } rotate <10, 20, 30> translate 5 }");
    let plain =
        object("difference { box { 0, 3 } box { <1, 1, -1>, <2, 2, 1> } rotate <10, 20, 30> translate 5 }");
    let merged = object(
        "merge { box { 0, <1, 3, 3> } box { x, <2, 3, 3> } box { 2*x, 3 } rotate <10, 20, 30> translate 5 }",
    );
    let whole = object("box { 0, 3 rotate <10, 20, 30> translate 5 }");
    for _ in 0..3000 {
        let from = Vec3::splat(6.0) + 20.0 * random.vector();
        let towards = Vec3::splat(6.0) + 2.5 * random.vector() - from;
        let (a, b) = (hit(&notch, from, towards), hit(&plain, from, towards));
        let near = |a: Option<Vec3>, b: Option<Vec3>| match (a, b) {
            (Some(a), Some(b)) => a.distance(b) < 1e-9,
            (a, b) => a.is_none() && b.is_none(),
        };
        let box_hit = hit(&whole, from, towards);
        if box_hit.is_none() {
            assert!(a.is_none() && b.is_none());
        } else {
            // Through the notch's open end both show its floor and walls, but for rays in its rim.
            assert!(near(a, b) || near(a, box_hit), "{from} {towards} {a:?} {b:?}");
        }
        assert!(near(hit(&merged, from, towards), box_hit));
        let inside = Vec3::splat(6.0) + random.vector();
        assert_eq!(merged.contains(inside), whole.contains(inside));
    }
}

/// A ball in glass of its own kind is not seen, whatever the gap between their surfaces.
#[test]
fn glass_within_glass() {
    for gap in ["0", "1e-12", "1e-6"] {
        let text = |inner: &str| {
            format!(
                "#version 3.7; global_settings {{ assumed_gamma 1 max_trace_level 30 }}
                 camera {{ location <1, 2, -6> look_at 0 angle 40 }}
                 #declare Glass = interior {{ ior 1.5 }};
                 #default {{ pigment {{ rgbt 1 }} finish {{ ambient 0 diffuse 0 }} }}
                 sphere {{ 0, 1 interior {{ Glass }} }} {inner}
                 plane {{ y, -3 pigment {{ checker rgb 1, rgb 0.2 }} finish {{ emission 1 }} }} background {{ rgb <0.2, 0.4, 0.8> }}"
            )
        };
        let alone = picture(&text(""), (24, 18));
        let nested = picture(&text(&format!("sphere {{ 0, 1 - {gap} interior {{ Glass }} }}")), (24, 18));
        let found = decibels(&alone, &nested);
        assert!(found > 40.0, "gap {gap}: {found} dB");
    }
}

/// What makes no sense is an error with this in it, or draws a picture without anything that is no number.
#[test]
fn senseless_input() {
    let harmless = [
        "cylinder { y, y, 1 }",
        "cone { y, 1, y, 0 }",
        "sphere { 0, 1 matrix <1, 0, 0, 2, 0, 0, 0, 0, 1, 0, 0, 0> }",
        "sphere { 1/0, 1 }",
        "sphere { 0, 0 }",
        "sphere { 0, -1 }",
        "box { 0, 0 }",
        "box { -1, <1, 1, -1> }",
        "cylinder { -y, y, 0 }",
        "cone { -y, 0, y, 0 }",
        "torus { 1, 0 }",
        "torus { 0, 1 }",
        "disc { 0, y, 0 }",
        "disc { 0, y, 1, 2 }",
        "triangle { 0, x, 2*x }",
        "triangle { 0, 0, 0 }",
        "smooth_triangle { 0, y, x, -y, y, y }",
        "polygon { 4, 0, x, 2*x, 0 }",
        "polygon { 5, 0, x, x + y, y + z, 0 }",
        "mesh { triangle { 0, 0, 0 } }",
        "blob { sphere { 0, 0, 1 } }",
        "blob { sphere { 0, 1, 0 } }",
        "blob { threshold 0 sphere { 0, 1, 1 } }",
        "quadric { 0, 0, 0, 0 }",
        "quadric { 0, 0, 0, 1 }",
        "polynomial { 3, xyz(0,0,0): 1 }",
        "superellipsoid { <1e-6, 1e-6> }",
        "superellipsoid { <1e3, 1e3> }",
        "ovus { 0, 0 }",
        "ovus { 1, 0 }",
        "ovus { 0, 1 }",
        "sphere_sweep { linear_spline 2, 0, 0, 0, 0 }",
        "sphere_sweep { linear_spline 2, 0, 1, 0, 1 }",
        "lathe { linear_spline 2, <0, 0>, <0, 1> }",
        "lathe { linear_spline 3, <1, 0>, <1, 0>, <1, 1> }",
        "sor { 4, <0, -1>, <0, 0>, <0, 1>, <0, 2> }",
        "prism { 0, 0, 4, <0, 0>, <1, 0>, <0, 1>, <0, 0> }",
        "prism { conic_sweep 0, 1, 4, <0, 0>, <0, 0>, <0, 0>, <0, 0> }",
        "bicubic_patch { type 1 u_steps 3 v_steps 3 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 }",
        "height_field { function 2, 2 { 0 } }",
        "text { internal 1 \"\" 1, 0 }",
        "text { internal 1 \"a\" 0, 0 }",
        "isosurface { function { 0 } }",
        "isosurface { function { 1/x } }",
        "isosurface { function { sqrt(x) } max_gradient 9 }",
        "isosurface { function { ln(x - x) } }",
        "parametric { function { 0 } function { 0 } function { 0 } <0, 0>, <1, 1> }",
        "parametric { function { u } function { v } function { 1/(u - u) } <0, 0>, <1, 1> }",
        "julia_fractal { <1e300, 0, 0, 0> }",
        "julia_fractal { 0 max_iteration 1 precision 1 }",
        "sphere { 0, 1e-300 }",
        "sphere { 0, 1e300 }",
        "sphere { 1e200, 1e150 }",
        "box { -1e300, 1e300 }",
        "sphere { 0, 1 scale 1e-160 }",
        "sphere { 0, 1 scale <1e200, 1, 1e-200> }",
        "sphere { 0, 1 scale <0, 1, 1> }",
        "union { sphere { 0, 0 } }",
        "difference { sphere { 0, 1 } sphere { 0, 1 } }",
        "merge { sphere { 0, 1 } sphere { 0, 1 } }",
        "intersection { box { 0, 1 } box { 1, 2 } }",
        "sphere { 0, 1 clipped_by { sphere { 5, 1 } } }",
        "sphere { 0, 1 pigment { gradient 0 } }",
        "sphere { 0, 1 normal { bumps 1e300 } }",
        "sphere { 0, 1 finish { specular 1 roughness 0 } }",
        "sphere { 0, 1 normal { function { sqrt(-1 - x*x) } 1 } }",
        "sphere { 0, 1 pigment { rgbt 1 } interior { ior 0 } }",
        "sphere { 0, 1 pigment { rgbt 1 } interior { ior 1e300 fade_distance 1e-300 fade_power 1000 } }",
    ];
    for text in harmless {
        let around = |body: &str| {
            format!(
                "#version 3.7; global_settings {{ assumed_gamma 1 }} camera {{ location <0.3, 0.2, -4> look_at 0 }}
                 light_source {{ <3, 5, -4> rgb 1 fade_distance 1 fade_power 2 }} plane {{ y, -2 pigment {{ rgb 1 }} }} {body}"
            )
        };
        if let Err(message) = scene(&around(text)) {
            assert!(message.len() > 10, "{text}: {message}");
            continue;
        }
        picture(&around(text), (12, 9));
    }
}

#[test]
fn senseless_input_with_an_error() {
    let wrong = [
        ("sphere { 0, sqrt(-1) }", "not defined"),
        ("sphere { 0, ln(0) }", "not defined"),
        ("plane { 0, 1 }", "no direction"),
        ("mesh { inside_vector y }", "no triangle"),
        ("torus { 1 }", "expected"),
    ];
    for (text, part) in wrong {
        let message =
            scene(&format!("#version 3.7; {text}")).err().unwrap_or_else(|| panic!("no error: {text}"));
        assert!(message.to_lowercase().contains(part), "{text}: {message}");
    }
}

/// A closed mesh: a ball of many triangles, crumpled, so that rays meet edges and corners from all sides.
fn crumpled(rings: usize, text: &mut String) -> Vec<Vec3> {
    let mut random = Random(3);
    let mut points = vec![Vec3::Y, Vec3::NEG_Y];
    for i in 1..rings {
        for j in 0..2 * rings {
            let (a, b) = (
                std::f64::consts::PI * i as f64 / rings as f64,
                std::f64::consts::PI * j as f64 / rings as f64,
            );
            points
                .push(Vec3::new(a.sin() * b.cos(), a.cos(), a.sin() * b.sin()) * (0.8 + 0.2 * random.unit()));
        }
    }
    // What the mesh keeps.
    let points: Vec<Vec3> = points.iter().map(|p| p.as_vec3().as_dvec3()).collect();
    let at = |i: usize, j: usize| match i {
        0 => 0,
        _ if i == rings => 1,
        _ => 2 + (i - 1) * 2 * rings + j % (2 * rings),
    };
    let mut faces = Vec::new();
    for i in 0..rings {
        for j in 0..2 * rings {
            let (a, b, c, d) = (at(i, j), at(i, j + 1), at(i + 1, j), at(i + 1, j + 1));
            faces.extend((a != b).then_some([a, b, c]));
            faces.extend((c != d).then_some([b, d, c]));
        }
    }
    let list = |n: usize, items: Vec<String>| format!("{n}, {}", items.join(", "));
    let vertices = points.iter().map(|p| format!("<{:e}, {:e}, {:e}>", p.x, p.y, p.z)).collect();
    let corners = faces.iter().map(|f| format!("<{}, {}, {}>", f[0], f[1], f[2])).collect();
    *text = format!(
        "#version 3.7; mesh2 {{ vertex_vectors {{ {} }} face_indices {{ {} }} inside_vector y }}",
        list(points.len(), vertices),
        list(faces.len(), corners)
    );
    points
}

fn count_leaks(rays: usize) -> usize {
    let mut text = String::new();
    let points = crumpled(24, &mut text);
    let world = World::prepare(scene(&text).expect("a mesh"));
    let mut random = Random(11);
    let mut leaks = 0;
    for i in 0..rays {
        let from = 0.4 * random.vector() / 3f64.sqrt();
        let corner = points[(random.unit() * points.len() as f64) as usize];
        let target = match i % 4 {
            0 => from + random.vector(),
            1 => corner,
            // Somewhere on an edge around the ball, or near it.
            2 => corner.lerp(points[(random.unit() * points.len() as f64) as usize], random.unit()),
            _ => from + (corner - from).abs() * Vec3::new(1.0, 0.0, 0.0) + 1e-300 * random.vector(),
        };
        let Some(dir) = (target - from).try_normalize() else { continue };
        leaks += usize::from(world.nearest(&Ray::new(from, dir), Range::FORWARD, RayClass::Image).is_none());
    }
    leaks
}

#[test]
fn no_ray_leaks_out_of_a_closed_mesh() {
    assert_eq!(count_leaks(100_000), 0);
}

/// Takes half a minute with optimisation.
#[test]
#[ignore = "ten million rays"]
fn no_ray_of_ten_million_leaks_out_of_a_closed_mesh() {
    assert_eq!(count_leaks(10_000_000), 0);
}

/// A colour that is no number is counted, told with its place, and drawn black.
#[test]
fn what_is_no_number_is_counted() {
    let text = "#version 3.7; global_settings { assumed_gamma 1 } camera { location -4*z look_at 0 }
        sphere { 0, 1 pigment { function { 1/(x - x) } } finish { emission 1 } }
        plane { z, 2 pigment { rgb 1 } finish { ambient 0 emission 1 } }";
    let world = World::prepare(scene(text).expect("a scene"));
    let mut tracer = Tracer::new(&world, &Settings { width: 9, height: 9, ..Settings::default() });
    let mut pixel = |x: f64, y: f64| tracer.pixel(x + 0.5, y + 0.5).rgb;
    assert_eq!(pixel(4.0, 4.0), Rgb::ZERO);
    assert_eq!(pixel(0.0, 0.0), Rgb::ONE);
    assert_eq!(tracer.counters().not_numbers, 1);
    let first = tracer.not_number().expect("its place");
    assert_eq!(first.kind, "sphere");
    assert!((first.point + Vec3::Z).length() < 1e-9, "{first:?}");
}
