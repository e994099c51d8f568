//! Names and types of output files.

use super::settings::Settings;
use crate::cli::exit::Failure;
use crate::cli::output::{Format, Target};
use crate::picture::Output;
use std::path::{Path, PathBuf};

/// The output file type with its number of bits a channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FileType {
    pub format: Format,
    pub bits: u8,
}

impl FileType {
    pub fn of(settings: &Settings) -> Result<FileType, Failure> {
        let text = settings.text("Output_File_Type").unwrap_or("N");
        let wrong =
            || Failure::usage(format!("+F{text}: expected one of N, T, C, P, B, J, E, H, S, and bits"));
        let letter = text.chars().next().filter(char::is_ascii_alphabetic);
        let format = match letter.unwrap_or('N').to_ascii_uppercase() {
            'N' | 'S' => Format::Png,
            'T' | 'C' => Format::Targa,
            'P' => Format::Ppm,
            'B' => Format::Bmp,
            'J' => Format::Jpeg,
            'E' => Format::Exr,
            'H' => Format::Hdr,
            _ => return Err(wrong()),
        };
        let rest = &text[letter.map_or(0, char::len_utf8)..];
        if rest.eq_ignore_ascii_case("g") || settings.flag("Grayscale_Output", false) {
            return Err(Failure::usage(
                "grey pictures are not available yet: leave +FNg and Grayscale_Output away",
            ));
        }
        let typed = if rest.is_empty() { None } else { Some(rest.parse::<i64>().map_err(|_| wrong())?) };
        let bits = typed.or(settings.int("Bits_Per_Color")).or(settings.int("Bits_Per_Colour")).unwrap_or(8);
        Ok(FileType { format, bits: bits.clamp(5, 16) as u8 })
    }
}

/// Where the picture goes; `frame` is the number of an animation's frame with its digits.
pub fn target(settings: &Settings, scene: &Path, kind: FileType, frame: Option<&str>) -> Target {
    let given = settings.text("Output_File_Name").filter(|n| !n.is_empty());
    if given == Some("-") {
        return Target { output: Output::Stdout, format: kind.format };
    }
    let stem = scene.file_stem().unwrap_or_default();
    let base = match given {
        None => PathBuf::from(stem),
        Some(folder) if folder.ends_with(std::path::is_separator) || Path::new(folder).is_dir() => {
            Path::new(folder).join(stem)
        }
        Some(name) => {
            let ending = format!(".{}", kind.format.extension());
            PathBuf::from(name.strip_suffix(ending.as_str()).unwrap_or(name))
        }
    };
    let mut name = base.into_os_string();
    name.push(frame.unwrap_or_default());
    name.push(".");
    name.push(kind.format.extension());
    Target { output: Output::File(name.into()), format: kind.format }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn name(words: &[(&str, &str)], frame: Option<&str>) -> String {
        let mut settings = Settings::default();
        for (keyword, value) in words {
            settings.set(keyword, value).unwrap();
        }
        let kind = FileType::of(&settings).unwrap();
        target(&settings, Path::new("dir/an.pov"), kind, frame).output.to_string()
    }

    /// As measured: only the type's own ending is taken off.
    #[test]
    fn names_get_the_ending_of_the_type() {
        assert_eq!(name(&[], None), "an.png");
        assert_eq!(name(&[("Output_File_Name", "p3.tga")], None), "p3.tga.png");
        assert_eq!(name(&[("Output_File_Name", "p3.png")], None), "p3.png");
        assert_eq!(name(&[("Output_File_Name", "p3.PNG")], None), "p3.PNG.png");
        assert_eq!(name(&[("Output_File_Name", "out/"), ("Output_File_Type", "T")], None), "out/an.tga");
        assert_eq!(name(&[("Output_File_Name", "-")], None), "-");
        assert_eq!(name(&[("Output_File_Name", "x.png")], Some("03")), "x03.png");
    }

    #[test]
    fn types_may_name_their_bits() {
        let of = |text: &str| {
            let mut settings = Settings::default();
            settings.set("Output_File_Type", text).unwrap();
            FileType::of(&settings)
        };
        assert_eq!(of("N16").unwrap(), FileType { format: Format::Png, bits: 16 });
        assert_eq!(of("16").unwrap(), FileType { format: Format::Png, bits: 16 });
        assert_eq!(of("p").unwrap(), FileType { format: Format::Ppm, bits: 8 });
        assert!(of("X").is_err() && of("Nx").is_err());
    }
}
