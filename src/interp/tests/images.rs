//! Measured images, read through the real grammar from real files.

use super::surface::{CONTEXT, note, report, rows};
use crate::interp::{Options, SceneSource, interpret};
use crate::material::{Pigment, Texture};
use crate::math::Vec3;
use std::collections::{BTreeMap, HashMap};
use std::fs::File;
use std::path::{Path, PathBuf};
use std::sync::Arc;

const ORACLE: &str = include_str!("../../../tests/data/2-image-oracle.csv");

/// The samples of one image of the oracle, row by row from the top.
fn samples(name: &str) -> Vec<u16> {
    let prefix = format!("image,{name},");
    let rows = ORACLE.lines().filter_map(|l| l.strip_prefix(&prefix));
    rows.flat_map(|l| l.split_once(',').map_or(l, |(_, v)| v).split(' ').map(|v| v.parse().unwrap()))
        .collect()
}

fn palette(name: &str) -> Vec<u8> {
    let prefix = format!("image,{name},");
    let row = ORACLE.lines().find_map(|l| l.strip_prefix(&prefix)).unwrap();
    row.split_once(',').unwrap().1.split(' ').map(|v| v.parse().unwrap()).collect()
}

/// Writes a 4 x 3 PNG file.
fn write_png(
    path: &Path,
    color: png::ColorType,
    wide: bool,
    data: &[u16],
    extra: impl FnOnce(&mut png::Info),
) {
    let mut info = png::Info::with_size(4, 3);
    info.color_type = color;
    info.bit_depth = if wide { png::BitDepth::Sixteen } else { png::BitDepth::Eight };
    extra(&mut info);
    let mut writer =
        png::Encoder::with_info(File::create(path).unwrap(), info).unwrap().write_header().unwrap();
    let bytes: Vec<u8> = match wide {
        true => data.iter().flat_map(|v| v.to_be_bytes()).collect(),
        false => data.iter().map(|&v| v as u8).collect(),
    };
    writer.write_image_data(&bytes).unwrap();
}

/// The images that the oracle was measured with, in a folder of their own.
fn folder() -> PathBuf {
    use png::ColorType::{Grayscale, Indexed, Rgb, Rgba};
    let folder = std::env::temp_dir().join(format!("glint-images-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let at = |name: &str| folder.join(name);
    let rgb = samples("rgb");
    write_png(&at("rgb.png"), Rgb, false, &rgb, |_| ());
    write_png(&at("rgbg.png"), Rgb, false, &rgb, |i| {
        i.source_gamma = Some(png::ScaledFloat::from_scaled(55556))
    });
    write_png(&at("rgbs.png"), Rgb, false, &rgb, |i| i.srgb = Some(png::SrgbRenderingIntent::Perceptual));
    write_png(&at("rgba.png"), Rgba, false, &samples("rgba"), |_| ());
    write_png(&at("gray.png"), Grayscale, false, &samples("gray"), |_| ());
    write_png(&at("g16.png"), Grayscale, true, &samples("g16"), |_| ());
    let colors = palette("palette_of_idx");
    let alpha = palette("palette_alpha_of_palt");
    let (index, plain) = (samples("idx"), colors.clone());
    write_png(&at("pal.png"), Indexed, false, &index, |i| i.palette = Some(plain.into()));
    write_png(&at("palt.png"), Indexed, false, &index, |i| {
        i.palette = Some(colors.into());
        i.trns = Some(alpha.into());
    });
    let mut ppm = b"P6\n4 3\n255\n".to_vec();
    ppm.extend(rgb.iter().map(|&v| v as u8));
    std::fs::write(at("rgb.ppm"), ppm).unwrap();
    folder
}

/// The pigment of the last object of a scene.
fn pigment_of(text: &str) -> Arc<Pigment> {
    let source = SceneSource::Text { name: "test".to_owned(), text: text.as_bytes().to_vec() };
    let readable = vec![std::env::temp_dir()];
    let outcome = interpret(source, &Options { readable, ..Options::default() });
    let scene = outcome.scene.unwrap_or_else(|e| panic!("{text}: {}", e.message));
    match &*scene.objects.last().unwrap().textures[0].value {
        Texture::Layers(layers) => layers[0].pigment.clone(),
        Texture::Patterned(_) => panic!("{text}: patterned"),
    }
}

const HEADER: &str = "#version 3.7; global_settings { assumed_gamma 1 }";

#[test]
fn image_lookups_are_as_measured() {
    let folder = folder();
    let mut seen: HashMap<String, Arc<Pigment>> = HashMap::new();
    let (mut bad, mut count) = (BTreeMap::new(), 0);
    for line in ORACLE.lines().filter(|l| l.starts_with("map,") || l.starts_with("pattern,")) {
        let (kind, rest) = line.split_once(',').unwrap();
        let (text, v) = rows(rest).next().unwrap();
        let word = if kind == "map" { "image_map" } else { "image_pattern" };
        let pigment = seen.entry(format!("{kind} {text}")).or_insert_with(|| {
            let quoted = text.replacen('\'', &format!("\"{}/", folder.display()), 1).replace('\'', "\"");
            pigment_of(&format!("{HEADER} sphere {{ 0, 1 pigment {{ {word} {{ {quoted} }} }} }}"))
        });
        let at = Vec3::new(v[0], v[1], v[2]);
        let got: Vec<f64> = match kind {
            "map" => pigment.color_or_clear(at, &CONTEXT).components().map(f64::from).to_vec(),
            _ => vec![pigment.signal.value(pigment.signal.warp(at), &CONTEXT)],
        };
        count += 1;
        if got.iter().zip(&v[3..]).any(|(a, b)| (a - b).abs() > 4e-7 * b.abs().max(1.0)) {
            note(&mut bad, &format!("{kind} {text}"), format!("{got:?} not {:?} at {at}", &v[3..]));
        }
    }
    std::fs::remove_dir_all(&folder).unwrap();
    println!("{count} rows");
    report(bad);
}

/// The header of a setting of the decoding oracle.
fn setting(name: &str) -> &'static str {
    match name {
        "a1" => HEADER,
        "a22" => "#version 3.7; global_settings { assumed_gamma 2.2 }",
        "36a22" => "#version 3.6; global_settings { assumed_gamma 2.2 }",
        "none" => "",
        "37" => "#version 3.7;",
        "inc" => "#include \"colors.inc\"",
        _ => panic!("unknown setting {name}"),
    }
}

#[test]
fn files_decode_as_measured() {
    let mut seen: HashMap<String, Arc<Pigment>> = HashMap::new();
    let (mut bad, mut count) = (BTreeMap::new(), 0);
    for line in include_str!("../../../tests/data/2-image-decode-oracle.csv").lines() {
        if line.starts_with('#') {
            continue;
        }
        let fields: Vec<&str> = line.split(',').collect();
        let key = format!("{} {}", fields[0], fields[1]);
        let v: Vec<f64> = fields[2..].iter().map(|f| f.parse().unwrap()).collect();
        let pigment = seen.entry(key.clone()).or_insert_with(|| {
            let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/images").join(fields[0]);
            let map = format!("image_map {{ \"{}\" }}", path.display());
            pigment_of(&format!("{} sphere {{ 0, 1 pigment {{ {map} }} }}", setting(fields[1])))
        });
        let (w, h) = image_size(pigment);
        let at = Vec3::new((v[0] + 0.5) / w, 1.0 - (v[1] + 0.5) / h, 0.0);
        let got = pigment.color_or_clear(at, &CONTEXT).components();
        count += 1;
        // Our JPEG decoder interpolates halved chroma in another way: up to 3 levels of 255 aside.
        let tolerance = if fields[0] == "j.jpg" { 0.02 } else { 2e-7 };
        if got.iter().zip(&v[2..]).any(|(a, b)| (f64::from(*a) - b).abs() > tolerance * b.abs().max(1.0)) {
            note(&mut bad, &key, format!("{got:?} not {:?} at column {} row {}", &v[2..], v[0], v[1]));
        }
    }
    println!("{count} rows");
    report(bad);
}

fn image_size(pigment: &Pigment) -> (f64, f64) {
    match &pigment.kind {
        crate::material::PigmentKind::Image(map) => (map.image.width as f64, map.image.height as f64),
        other => panic!("{other:?} is no image"),
    }
}
