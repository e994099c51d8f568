//! What `image_pattern` with `use_alpha` and a height field make of files of palettes and of TIFF, beside the numbers
//! that POV-Ray 3.7 printed for the same files. The files have two by two pixels and are written here.

use glint::interp::{IncludeMode, Options, SceneSource, interpret};
use std::path::Path;

/// Colours of the files of palettes.
const COLORS: [[u8; 3]; 2] = [[51, 102, 153], [204, 10, 30]];

fn png() -> Vec<u8> {
    let mut out = Vec::new();
    let mut encoder = png::Encoder::new(&mut out, 2, 2);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_palette(COLORS.concat());
    encoder.write_header().unwrap().write_image_data(&[0, 1, 0, 1]).unwrap();
    out
}

/// Codes of three bits, as long as the table is short: clear, then two pixels; and that again.
fn gif() -> Vec<u8> {
    let mut out = b"GIF89a\x02\0\x02\0\x80\0\0".to_vec();
    out.extend(COLORS.concat());
    out.extend(b",\0\0\0\0\x02\0\x02\0\0\x02");
    let codes = [4_u32, 0, 1, 4, 0, 1, 5];
    let bits = codes.iter().rev().fold(0, |bits, code| bits << 3 | code);
    out.push(3);
    out.extend(&bits.to_le_bytes()[..3]);
    out.extend([0, b';']);
    out
}

/// Samples of a byte; colours of a palette have 16 bits.
fn tiff(meaning: u16, channels: usize, pixels: &[u8], palette: &[u16]) -> Vec<u8> {
    let mut fields = vec![
        (256, vec![2]),
        (257, vec![2]),
        (258, vec![8; channels]),
        (259, vec![1]),
        (262, vec![meaning]),
        (273, vec![8]),
        (277, vec![channels as u16]),
        (278, vec![2]),
        (279, vec![pixels.len() as u16]),
    ];
    match palette {
        [] => fields.push((338, vec![2])),
        _ => fields.push((320, palette.to_vec())),
    }
    if channels == 3 {
        fields.pop();
    }
    let directory = 8 + pixels.len();
    let (mut table, mut far) = (Vec::new(), Vec::new());
    let start = directory + 2 + 12 * fields.len() + 4;
    for (tag, values) in &fields {
        table.extend([*tag, 3_u16].map(u16::to_le_bytes).concat());
        table.extend((values.len() as u32).to_le_bytes());
        let bytes: Vec<u8> = values.iter().flat_map(|v| v.to_le_bytes()).collect();
        match bytes.len() {
            0..=4 => table.extend((0..4).map(|i| bytes.get(i).copied().unwrap_or(0))),
            _ => {
                table.extend(((start + far.len()) as u32).to_le_bytes());
                far.extend(bytes);
            }
        }
    }
    let count = (fields.len() as u16).to_le_bytes();
    let mut out = b"II*\0".to_vec();
    out.extend((directory as u32).to_le_bytes());
    [pixels, &count, &table, &[0; 4], &far].iter().for_each(|part| out.extend(*part));
    out
}

fn write_files(folder: &Path) {
    let mut palette = [0x9600; 768];
    (palette[0], palette[1], palette[256], palette[257]) = (0x3280, 0xC8FF, 0x6400, 0x0ABC);
    let (a, b) = ([50, 100, 150], [200, 10, 30]);
    let row = |alpha: [u8; 2]| [&a[..], &alpha[..1], &b, &alpha[1..]].concat();
    let files = [
        ("palette.png", png()),
        ("palette.gif", gif()),
        ("palette.tif", tiff(3, 1, &[0, 1, 0, 1], &palette)),
        ("rgb.tif", tiff(2, 3, &[a, b, a, b].concat(), &[])),
        ("opaque.tif", tiff(2, 4, &row([255; 2]).repeat(2), &[])),
        ("clear.tif", tiff(2, 4, &row([255, 100]).repeat(2), &[])),
    ];
    for (name, bytes) in files {
        std::fs::write(folder.join(name), bytes).unwrap();
    }
}

const HEADER: &str = "#version 3.7; global_settings { assumed_gamma 1 }";
const ASK: &str = r#"
#declare A = function { pigment { image_pattern { FILE use_alpha } color_map { [0 rgb 0] [1 rgb 1] } } }
#declare C = function { pigment { image_map { FILE gamma 1 } } }
#debug concat(vstr(2, <A(0.25, 0.5, 0).red, A(0.75, 0.5, 0).red>, " ", 0, 5), "\n")
#debug concat(vstr(3, C(0.25, 0.5, 0), " ", 0, 5), "\n", vstr(3, C(0.75, 0.5, 0), " ", 0, 5), "\n")
#undef A
#undef C
"#;
const HEIGHTS: &str = r#"
#declare H = height_field { FILE scale <1, 1000, 1> }
#for (I, 1, 3)
  #debug concat(str(trace(H, <I/4, 2000, 0.4>, -y).y, 0, 3), "\n")
#end
"#;

fn scene() -> String {
    let files = ["png palette", "gif palette", "tiff palette", "tiff rgb", "tiff opaque", "tiff clear"];
    let asked = files.map(|file| {
        let (kind, name) = file.split_once(' ').unwrap();
        let text = if name == "clear" { ASK.to_owned() } else { format!("{ASK}{HEIGHTS}") };
        text.replace("FILE", &format!("{kind} \"{name}.{}\"", if kind == "tiff" { "tif" } else { kind }))
    });
    format!("{HEADER}{}", asked.concat())
}

/// Of each file the pattern at two places, their colours, and three heights.
const PRINTED: &str = "\
0.00000 0.00000
0.20000 0.40000 0.60000
0.80000 0.03922 0.11765
0.977
1.953
2.930
0.00000 0.00000
0.20000 0.40000 0.60000
0.80000 0.03922 0.11765
0.977
1.953
2.930
0.19727 0.78515
0.19727 0.39063 0.58595
0.78515 0.04193 0.58595
0.977
1.953
2.930
0.00000 0.00000
0.19608 0.39216 0.58824
0.78431 0.03922 0.11765
342.979
489.120
635.262
0.00000 0.00000
0.19608 0.39216 0.58824
0.78431 0.03922 0.11765
342.979
489.120
635.262
0.00000 0.60784
0.19608 0.39216 0.58824
0.78000 0.04000 0.12000
";

#[test]
fn alpha_and_heights_are_those_of_the_reference() {
    let folder = std::env::temp_dir().join(format!("glint-image-alpha-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    write_files(&folder);
    let source = SceneSource::Text { name: "scene.pov".to_owned(), text: scene().into_bytes() };
    let options = Options {
        library_paths: vec![folder.clone()],
        includes: IncludeMode::Embedded,
        ..Options::default()
    };
    let outcome = interpret(source, &options);
    std::fs::remove_dir_all(&folder).unwrap();
    assert!(outcome.scene.is_ok(), "{:?}", outcome.scene.err());
    assert_eq!(outcome.debug, PRINTED);
}
