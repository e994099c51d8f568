//! Names and types of output files.

use super::settings::Settings;
use crate::cli::exit::Failure;
use crate::cli::output::{Format, Target};
use crate::picture::Output;
use crate::picture::other::Kind;
use std::path::{Path, PathBuf};

/// The output file type with its number of bits a channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FileType {
    pub format: Format,
    pub bits: u8,
    pub grey: bool,
}

/// The reference's quality of JPEG files where nobody asks for another.
const JPEG_QUALITY: i64 = 85;

impl FileType {
    /// The type's first letter counts, as in the reference.
    pub fn of(settings: &Settings) -> Result<FileType, Failure> {
        let text = settings.text("Output_File_Type").unwrap_or("N");
        let letter = text.chars().next().unwrap_or(' ').to_ascii_uppercase();
        let format = match letter {
            'N' => Format::Png,
            'E' => Format::Exr,
            'T' => Format::Other(Kind::Targa),
            'C' => Format::Other(Kind::PackedTarga),
            'P' => Format::Other(Kind::Ppm),
            'B' => Format::Other(Kind::Bmp),
            'J' => Format::Other(Kind::Jpeg(jpeg_quality(settings))),
            'H' => Format::Other(Kind::Hdr),
            _ => {
                return Err(Failure::usage(format!(
                    "Output_File_Type={text}: expected N (PNG), T or C (Targa), P (PPM), B (BMP), J (JPEG), \
                     E (OpenEXR) or H (HDR)"
                )));
            }
        };
        let grey = settings.flag("Grayscale_Output", false);
        if grey && !matches!(format, Format::Png | Format::Other(Kind::Ppm)) {
            return Err(Failure::usage(format!(
                "Output_File_Type={text}: grey pictures are PNG (+FNg) or PPM (+FPg) files"
            )));
        }
        // Grey PNG files are for height fields: always as fine as the format allows.
        let bits = match format {
            Format::Png if grey => 16,
            _ => settings.int("Bits_Per_Color").unwrap_or(8).clamp(5, 16) as u8,
        };
        Ok(FileType { format, bits, grey })
    }
}

fn jpeg_quality(settings: &Settings) -> u8 {
    match settings.int("Compression").unwrap_or(0).clamp(0, 100) {
        0 | 1 => JPEG_QUALITY as u8,
        quality => quality as u8,
    }
}

/// Where the picture goes; `frame` is the number of an animation's frame with its digits. Without a name
/// the picture stands beside the scene, as it was named.
pub fn target(settings: &Settings, scene: &str, kind: FileType, frame: &str) -> Target {
    let format = kind.format;
    if !settings.flag("Output_To_File", true) {
        return Target { output: Output::Nowhere, format };
    }
    let given = settings.text("Output_File_Name").unwrap_or("");
    if given == "-" {
        return Target { output: Output::Stdout, format };
    }
    let extension = format.extension();
    let stem = given.strip_suffix(extension).and_then(|s| s.strip_suffix('.')).unwrap_or(given);
    let stem = stem.strip_suffix('.').filter(|_| stem == given).unwrap_or(stem);
    let scene = if scene == "-" { Path::new("stdin") } else { Path::new(scene) };
    let base = match stem {
        "" => scene.with_extension(""),
        folder if folder.ends_with(std::path::is_separator) => {
            Path::new(folder).join(scene.file_stem().unwrap_or_default())
        }
        name => PathBuf::from(name),
    };
    let mut name = base.into_os_string();
    name.push(frame);
    name.push(".");
    name.push(extension);
    Target { output: Output::File(name.into()), format }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn settings(words: &[(&str, &str)]) -> Settings {
        let mut settings = Settings::default();
        for (keyword, value) in words {
            settings.set(keyword, value).unwrap();
        }
        settings
    }

    fn name(given: &str, kind: &str, frame: &str) -> String {
        let settings = settings(&[("Output_File_Name", given), ("Output_File_Type", kind)]);
        let kind = FileType::of(&settings).unwrap();
        target(&settings, "dir/an.v2.pov", kind, frame).output.to_string()
    }

    /// As measured: only the type's own ending, or a dot, is taken off.
    #[test]
    fn names_get_the_ending_of_the_type() {
        for (given, expected) in [
            ("", "dir/an.v2.png"),
            ("p3.tga", "p3.tga.png"),
            ("p3.png", "p3.png"),
            ("p3.PNG", "p3.PNG.png"),
            ("p3.png.png", "p3.png.png"),
            ("p3.png.", "p3.png.png"),
            ("p3.", "p3.png"),
            ("p3..", "p3..png"),
            (".png", "dir/an.v2.png"),
            ("out/.png", "out/an.v2.png"),
            ("out/", "out/an.v2.png"),
            ("-", "-"),
        ] {
            assert_eq!(name(given, "N", ""), expected, "+O{given}");
        }
        assert_eq!(name("out/", "Targa", ""), "out/an.v2.tga");
        assert_eq!(name("x.png", "n", "03"), "x03.png");
        assert_eq!(name("x.tga", "N", "03"), "x.tga03.png");
        let off = settings(&[("Output_To_File", "off")]);
        assert_eq!(target(&off, "a", FileType::of(&off).unwrap(), "").output, Output::Nowhere);
    }

    #[test]
    fn types_are_letters() {
        let of = |words: &[(&str, &str)]| FileType::of(&settings(words));
        let png = |bits, grey| FileType { format: Format::Png, bits, grey };
        assert_eq!(of(&[]).unwrap(), png(8, false));
        assert_eq!(of(&[("Output_File_Type", "N16")]).unwrap(), png(8, false));
        assert_eq!(of(&[("Bits_Per_Colour", "99")]).unwrap(), png(16, false));
        assert_eq!(of(&[("Grayscale_Output", "on"), ("Bits_Per_Color", "8")]).unwrap(), png(16, true));
        let jpeg = of(&[("Output_File_Type", "j"), ("Compression", "200")]).unwrap();
        assert_eq!(jpeg.format, Format::Other(Kind::Jpeg(100)));
        assert!(of(&[("Output_File_Type", "T"), ("Grayscale_Output", "on")]).is_err());
        for wrong in ["", "S", "X", "16"] {
            assert!(of(&[("Output_File_Type", wrong)]).is_err(), "{wrong}");
        }
    }
}
