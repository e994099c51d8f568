//! POV-Ray's options in Glint's words, for advice.

use super::naming::{self, FileType};
use super::settings::Settings;
use super::{DEFAULT_SIZE, notes, region, scene_file, size, words};
use crate::cli::exit::Failure;
use crate::cli::output::Format;
use crate::picture::Output;

/// An option of Glint's with its value, as two words (`-W 20`) or one (`-A=0.3`).
#[derive(Debug, PartialEq)]
pub struct Choice {
    pub name: &'static str,
    pub words: Vec<String>,
}

/// What Glint's syntax has for a line, and what it lacks.
#[derive(Debug, Default)]
pub struct InGlint {
    pub scene: Option<String>,
    pub choices: Vec<Choice>,
    /// Options of POV-Ray's without a counterpart.
    pub lost: Vec<String>,
}

impl InGlint {
    /// Translates words of POV-Ray's syntax; `typed_size` is the picture's size as Glint's words give it.
    /// The picture's name is asked for where Glint would choose another.
    pub fn of(line: &[String], typed_size: [Option<&str>; 2], names_picture: bool) -> Result<Self, Failure> {
        let mut settings = Settings::default();
        for word in line {
            words::apply(&mut settings, word)?;
        }
        let mut all = InGlint::default();
        let scene = settings.text("Input_File_Name").filter(|n| !n.is_empty());
        all.scene = scene.map(|name| scene_file(&settings, name).display().to_string());
        all.picture(&settings, typed_size)?;
        all.antialiasing(&settings);
        all.text(&settings);
        all.output(&settings, names_picture)?;
        for (keyword, value) in settings.given() {
            if !TRANSLATED.contains(&keyword) && notes::reason(keyword).is_none() {
                all.lost.push(format!("{keyword}={value}"));
            }
        }
        Ok(all)
    }

    fn put(&mut self, name: &'static str, value: impl ToString) {
        self.choices.push(Choice { name, words: vec![name.to_owned(), value.to_string()] });
    }

    fn flag(&mut self, name: &'static str) {
        self.choices.push(Choice { name, words: vec![name.to_owned()] });
    }

    fn picture(&mut self, settings: &Settings, typed: [Option<&str>; 2]) -> Result<(), Failure> {
        let mut sized = settings.clone();
        for (keyword, side) in ["Width", "Height"].into_iter().zip(typed) {
            if let Some(side) = side {
                sized.set(keyword, side)?;
            }
        }
        let part = ["Start_Column", "Start_Row", "End_Column", "End_Row"];
        let in_part = part.iter().any(|k| settings.text(k).is_some());
        let default = |n: i64| in_part.then_some(n);
        if let Some(width) = settings.int("Width").or(default(DEFAULT_SIZE.0)) {
            self.put("-W", width);
        }
        if let Some(height) = settings.int("Height").or(default(DEFAULT_SIZE.1)) {
            self.put("-H", height);
        }
        if in_part {
            let (width, height) = size(&sized)?;
            let r = region(&sized, width, height)?;
            self.put("--region", format!("{},{},{},{}", r.x0, r.y0, r.x1, r.y1));
        }
        Ok(())
    }

    fn antialiasing(&mut self, settings: &Settings) {
        let text = |keyword: &str| settings.text(keyword).map(str::to_owned);
        if settings.flag("Antialias", false) {
            let threshold = text("Antialias_Threshold").map_or("-A".into(), |t| format!("-A={t}"));
            self.choices.push(Choice { name: "-A", words: vec![threshold] });
            let method = if settings.int("Sampling_Method") == Some(2) { 2 } else { 1 };
            self.put("--aa-method", method);
            if let Some(depth) = settings.int("Antialias_Depth") {
                self.put("--aa-depth", depth.clamp(1, 9));
            }
            let amount = settings.float("Jitter_Amount").filter(|&a| a != 1.0);
            let lost = amount.filter(|_| settings.flag("Jitter", true)).map(|a| format!("Jitter_Amount={a}"));
            self.lost.extend(lost);
            self.lost.extend(text("Antialias_Gamma").map(|g| format!("Antialias_Gamma={g}")));
        }
        if !settings.flag("Jitter", true) {
            self.put("--jitter", "off");
        }
    }

    /// What scene text is told, and how it is rendered.
    fn text(&mut self, settings: &Settings) {
        for folder in &settings.library {
            self.put("-L", folder.display());
        }
        for folder in &settings.readable {
            self.put("--allow-read", folder.display());
        }
        for folder in &settings.writable {
            self.put("--allow-write", folder.display());
        }
        for (i, (name, value)) in settings.declares.iter().enumerate() {
            // The first value counts.
            if settings.declares[..i].iter().any(|(earlier, _)| earlier == name) {
                continue;
            }
            match value.parse::<f64>() {
                Ok(_) => self.put("-D", format!("{name}={value}")),
                Err(_) => self.lost.push(format!("Declare={name}={value}")),
            }
        }
        if let Some(clock) = settings.text("Clock") {
            self.put("--clock", clock);
        }
        if let Some(quality) = settings.int("Quality") {
            self.put("--quality", quality.clamp(0, 9));
        }
        if let Some(threads) = settings.int("Work_Threads") {
            self.put("--threads", threads);
        }
        if !settings.flag("All_Console", true) {
            self.flag("-q");
        }
        let radiosity = super::radiosity(settings);
        if let Some(file) = radiosity.load {
            self.put("--load-radiosity", file.display());
        }
        if let Some(file) = radiosity.save {
            self.put("--save-radiosity", file.display());
        }
    }

    fn output(&mut self, settings: &Settings, names_picture: bool) -> Result<(), Failure> {
        if settings.flag("Output_Alpha", false) {
            self.flag("--alpha");
        }
        let kind = FileType::of(settings)?;
        let bits = match kind {
            FileType { format: Format::Png, bits: 8 | 16, grey: false } => kind.bits,
            FileType { format: Format::Exr, grey: false, .. } => 8,
            _ => {
                let letter = settings.text("Output_File_Type").unwrap_or("N");
                self.lost.push(format!("+F{letter} with {} bits of a channel", kind.bits));
                return Ok(());
            }
        };
        if bits == 16 {
            self.put("--bits", 16);
        }
        let scene = settings.text("Input_File_Name").unwrap_or_default();
        let elsewhere = names_picture && scene.contains(std::path::is_separator);
        let named = settings.text("Output_File_Name").is_some() || kind.format == Format::Exr || elsewhere;
        match naming::target(settings, scene, kind, "").output {
            Output::Nowhere => self.lost.push("Output_To_File=off".to_owned()),
            Output::Stdout => self.put("-o", "-"),
            Output::File(path) if named => self.put("-o", path.display()),
            Output::File(_) => {}
        }
        Ok(())
    }
}

/// Keywords that the functions above look at.
const TRANSLATED: &[&str] = &[
    "All_Console",
    "Antialias",
    "Antialias_Depth",
    "Antialias_Gamma",
    "Antialias_Threshold",
    "Bits_Per_Color",
    "Bits_Per_Colour",
    "Clock",
    "Compression",
    "Continue_Trace",
    "Declare",
    "Dither_Method",
    "End_Column",
    "End_Row",
    "Grayscale_Output",
    "Height",
    "Input_File_Name",
    "Jitter",
    "Jitter_Amount",
    "Library_Path",
    "Output_Alpha",
    "Output_File_Name",
    "Output_File_Type",
    "Output_To_File",
    "Quality",
    "Radiosity_File_Name",
    "Radiosity_From_File",
    "Radiosity_To_File",
    "Sampling_Method",
    "Start_Column",
    "Start_Row",
    "Width",
    "Work_Threads",
];
