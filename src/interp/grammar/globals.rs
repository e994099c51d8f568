//! `global_settings`.

use crate::color::Gamma;
use crate::interp::lookup::Kind;
use crate::interp::vocabulary::{self as items, Items};
use crate::interp::{Access, Parser, Result};
use crate::light::PhotonFile;
use crate::math::noise::NoiseGenerator;
use crate::scene::{PhotonSettings, RadiositySettings, SubsurfaceSettings};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Punct, Tok, Token};
use std::path::PathBuf;
use std::sync::Arc;

/// What a direction of radiosity comes to, with what is found along it.
const DIRECTION_BYTES: u64 = 96;

impl Parser {
    fn not_a_setting(&mut self, token: Token, items: &Items) -> Box<Diagnostic> {
        match token.tok {
            Tok::Word(word) => {
                let text = format!("`{}` is not {}", word.text(), items.noun);
                Box::new(Diagnostic::error(token.span, text))
            }
            _ => self.unexpected_among(token, &format!("{} or `}}`", items.noun), items.words),
        }
    }

    /// `global_settings { … }`; the word is the next token.
    pub(crate) fn global_settings_statement(&mut self) -> Result<()> {
        self.expect(Keyword::GlobalSettings)?;
        self.expect_punct(Punct::LeftBrace)?;
        while !self.accept_punct(Punct::RightBrace)? {
            let token = self.next()?;
            let Tok::Word(word) = token.tok else {
                return Err(self.not_a_setting(token, &items::GLOBAL_SETTINGS));
            };
            if !(self.global_light_item(word, token.span)? || self.global_item(word, token.span)?) {
                return Err(self.not_a_setting(token, &items::GLOBAL_SETTINGS));
            }
            self.comma()?;
        }
        Ok(())
    }

    /// Settings of light.
    fn global_light_item(&mut self, word: Keyword, span: Span) -> Result<bool> {
        match word {
            Keyword::AdcBailout => self.scene.scene.globals.adc_bailout = self.float()? as f32,
            Keyword::AmbientLight => self.scene.scene.globals.ambient_light = self.rgb()?,
            Keyword::IridWavelength => self.scene.scene.globals.irid_wavelength = self.rgb()?,
            Keyword::MaxTraceLevel => {
                let span = self.peek()?.span;
                let level = self.float()?;
                self.set_trace_level(level, span);
            }
            Keyword::MmPerUnit => self.scene.scene.globals.mm_per_unit = self.float()?,
            Keyword::Radiosity => {
                let settings = self.radiosity_settings(span)?;
                self.scene.scene.globals.radiosity = Some(settings);
            }
            Keyword::Photons => {
                let settings = self.photon_settings()?;
                self.scene.scene.globals.photons = Some(settings);
            }
            Keyword::Subsurface => {
                let settings = self.subsurface_settings()?;
                self.scene.scene.globals.subsurface = Some(settings);
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    fn global_item(&mut self, word: Keyword, span: Span) -> Result<bool> {
        match word {
            Keyword::AssumedGamma => self.assumed_gamma(span)?,
            Keyword::Charset => self.charset()?,
            Keyword::HfGray16 => {
                self.flag()?;
                let text = "`hf_gray_16` has no effect in a scene";
                self.warn(Diagnostic::warning(span, text).with_hint("ask for a 16-bit grey picture instead"));
            }
            Keyword::MaxIntersections => {
                self.float()?;
                if self.syntax_version() >= 370 {
                    self.warn(Diagnostic::warning(span, "`max_intersections` has no effect"));
                }
            }
            Keyword::NoiseGenerator => {
                let number = self.float()?;
                let Some(generator) = NoiseGenerator::from_number(number.max(0.0) as u32) else {
                    return Err(Box::new(Diagnostic::error(span, "there are noise generators 1 to 3")));
                };
                self.scene.scene.globals.noise_generator = generator;
                self.scene.noise_given = true;
            }
            Keyword::NumberOfWaves => {
                let number = self.float()?;
                if number < 1.0 {
                    self.warn(Diagnostic::warning(span, "`number_of_waves` must be above 0: 1 is taken"));
                }
                self.scene.scene.globals.number_of_waves = number.clamp(1.0, MOST_WAVES) as usize;
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// The first one given counts.
    fn assumed_gamma(&mut self, span: Span) -> Result<()> {
        let gamma = match self.accept(Keyword::Srgb)? {
            true => Gamma::Srgb,
            false => Gamma::Power(self.float()?),
        };
        if let Gamma::Power(g) = gamma
            && !(g > 0.0 && g.is_finite())
        {
            return Err(Box::new(Diagnostic::error(span, "`assumed_gamma` must be above 0")));
        }
        if self.scene.gamma_given {
            self.warn(Diagnostic::warning(span, "a second `assumed_gamma` has no effect"));
            return Ok(());
        }
        self.scene.scene.globals.gamma = gamma;
        self.scene.gamma_given = true;
        Ok(())
    }

    /// Texts are read as UTF-8 in any case.
    fn charset(&mut self) -> Result<()> {
        let token = self.next()?;
        match token.tok {
            Tok::Word(word @ (Keyword::Ascii | Keyword::Utf8 | Keyword::Sys)) => {
                self.set_charset(word != Keyword::Ascii);
                Ok(())
            }
            _ => Err(self.unexpected_token(token, "`ascii`, `utf8` or `sys`")),
        }
    }

    /// A level outside of 1 to 256 is brought inside.
    pub(in crate::interp) fn set_trace_level(&mut self, level: f64, span: Span) {
        if !(1.0..=256.0).contains(&level) {
            self.warn(Diagnostic::warning(span, "`max_trace_level` goes from 1 to 256"));
        }
        self.scene.scene.globals.max_trace_level = level.clamp(1.0, 256.0) as u32;
    }

    /// `{ … }` behind `radiosity`.
    fn radiosity_settings(&mut self, span: Span) -> Result<RadiositySettings> {
        let mut r = RadiositySettings::default();
        let (mut minimum, mut maximum) = (None, None);
        self.expect_punct(Punct::LeftBrace)?;
        while !self.accept_punct(Punct::RightBrace)? {
            let token = self.next()?;
            let Tok::Word(word) = token.tok else { return Err(self.not_a_setting(token, &items::RADIOSITY)) };
            match word {
                Keyword::Count => {
                    r.count = self.whole(1.0, f64::from(i32::MAX))?;
                    let pool = if self.accept_punct(Punct::Comma)? { Some(self.float()?) } else { None };
                    let enough = pool.is_none_or(|p| p.trunc() >= f64::from(r.count));
                    self.demand(
                        enough,
                        self.last_span(),
                        "the pool of directions is smaller than the count",
                    )?;
                    r.pool = pool.map_or(1600, |p| p as u32).max(r.count);
                    self.reserve(DIRECTION_BYTES * u64::from(r.pool), self.last_span())?;
                }
                Keyword::NearestCount => {
                    r.nearest_count = self.whole(1.0, 20.0)?;
                    if self.accept_punct(Punct::Comma)? {
                        r.adaptive_count = self.whole(0.0, f64::from(r.nearest_count - 1))?;
                    }
                }
                Keyword::RecursionLimit => r.recursion_limit = self.whole(1.0, 20.0)?,
                Keyword::MinimumReuse => minimum = Some(self.float()?),
                Keyword::MaximumReuse => maximum = Some(self.float()?),
                _ if self.radiosity_flag(&mut r, word)? || self.radiosity_number(&mut r, word)? => {}
                _ => return Err(self.not_a_setting(token, &items::RADIOSITY)),
            }
            self.comma()?;
        }
        let range = 0.0..=1.0;
        if !range.contains(&r.pretrace_start)
            || !range.contains(&r.pretrace_end)
            || r.pretrace_end > r.pretrace_start
        {
            let text = "the pretrace of radiosity starts at 1 or below, and ends there or below";
            return Err(Box::new(Diagnostic::error(span, text)));
        }
        self.demand(maximum.is_none_or(|m| m > 0.0), span, "`maximum_reuse` must be above 0")?;
        self.demand(minimum.is_none_or(|m| m >= 0.0), span, "`minimum_reuse` must not be negative")?;
        set_reuse(&mut r, minimum, maximum).map_err(|text| Box::new(Diagnostic::error(span, text)))?;
        Ok(r)
    }

    fn radiosity_flag(&mut self, r: &mut RadiositySettings, word: Keyword) -> Result<bool> {
        let place = match word {
            Keyword::AlwaysSample => &mut r.always_sample,
            Keyword::Normal => &mut r.normal,
            Keyword::Media => &mut r.media,
            Keyword::Subsurface => &mut r.subsurface,
            _ => return Ok(false),
        };
        *place = self.flag()?;
        Ok(true)
    }

    fn radiosity_number(&mut self, r: &mut RadiositySettings, word: Keyword) -> Result<bool> {
        let token = self.peek()?;
        if matches!(word, Keyword::LoadFile | Keyword::SaveFile) {
            self.string()?;
            let text = "radiosity files are an option of the command line, not of the scene";
            self.warn(Diagnostic::warning(token.span, text));
            return Ok(true);
        }
        let place = match word {
            Keyword::ErrorBound => &mut r.error_bound,
            Keyword::LowErrorFactor => &mut r.low_error_factor,
            Keyword::PretraceStart => &mut r.pretrace_start,
            Keyword::PretraceEnd => &mut r.pretrace_end,
            Keyword::Brightness | Keyword::GrayThreshold | Keyword::AdcBailout | Keyword::MaxSample => {
                let value = self.float()? as f32;
                let fits = match word {
                    Keyword::Brightness | Keyword::AdcBailout => value > 0.0,
                    Keyword::GrayThreshold => (0.0..=1.0).contains(&value),
                    _ => true,
                };
                if !fits {
                    let text = format!("{value} makes no sense as `{}`", word.text());
                    return Err(Box::new(Diagnostic::error(token.span, text)));
                }
                match word {
                    Keyword::Brightness => r.brightness = value,
                    Keyword::GrayThreshold => r.gray_threshold = value,
                    Keyword::AdcBailout => r.adc_bailout = value,
                    _ => r.max_sample = value,
                }
                return Ok(true);
            }
            _ => return Ok(false),
        };
        *place = self.float()?;
        if *place > 0.0 {
            return Ok(true);
        }
        Err(Box::new(Diagnostic::error(token.span, format!("`{}` must be above 0", word.text()))))
    }

    /// A whole number from `low` to `high`.
    fn whole(&mut self, low: f64, high: f64) -> Result<u32> {
        let token = self.peek()?;
        let value = self.float()?.trunc();
        if (low..=high).contains(&value) {
            return Ok(value as u32);
        }
        let text = format!("expected a whole number from {low} to {high}");
        Err(Box::new(Diagnostic::error(token.span, text)))
    }

    /// `{ … }` behind `photons`.
    fn photon_settings(&mut self) -> Result<PhotonSettings> {
        let mut p = PhotonSettings::default();
        self.expect_punct(Punct::LeftBrace)?;
        while !self.accept_punct(Punct::RightBrace)? {
            let token = self.next()?;
            let Tok::Word(word) = token.tok else { return Err(self.not_a_setting(token, &items::PHOTONS)) };
            if !self.photon_item(&mut p, word, token.span)? {
                return Err(self.not_a_setting(token, &items::PHOTONS));
            }
            self.comma()?;
        }
        Ok(p)
    }

    fn photon_item(&mut self, p: &mut PhotonSettings, word: Keyword, span: Span) -> Result<bool> {
        match word {
            Keyword::Spacing => p.spacing = self.float()?,
            Keyword::Count => p.count = self.float()?.max(0.0) as u32,
            Keyword::Gather => {
                p.gather_min = self.float()?.max(0.0) as u32;
                self.comma()?;
                p.gather_max = self.float()?.max(0.0) as u32;
                let text = "photons are gathered from a smaller number to a larger one";
                self.demand(p.gather_min <= p.gather_max, span, text)?;
            }
            Keyword::Radius => self.photon_radius(p)?,
            Keyword::ExpandThresholds => {
                p.expand_increase = self.float()?;
                self.comma()?;
                let least = self.float()?;
                if least < 0.0 {
                    let text = "photons are not fewer than 0: 0 is taken";
                    self.warn(Diagnostic::warning(self.last_span(), text));
                }
                p.expand_min = least.max(0.0) as u32;
            }
            Keyword::Autostop => p.autostop = self.float()?,
            Keyword::Jitter => p.jitter = self.float()?,
            Keyword::Media => {
                let steps = self.float()?.trunc();
                self.demand(steps >= 0.0, self.last_span(), "photons take no negative number of steps")?;
                p.media_steps = steps as u32;
                if self.accept_punct(Punct::Comma)? {
                    p.media_factor = self.float()?;
                    self.demand(p.media_factor > 0.0, self.last_span(), "steps of photons must be above 0")?;
                }
            }
            // 0 and less stand for the scene's own.
            Keyword::MaxTraceLevel => {
                let level = self.float()?.clamp(0.0, 256.0) as u32;
                p.max_trace_level = Some(level).filter(|n| *n > 0);
            }
            Keyword::AdcBailout => p.adc_bailout = Some(self.float()? as f32),
            Keyword::LoadFile => p.load = Some(self.photon_file(span)?),
            Keyword::SaveFile => {
                let path = PathBuf::from(self.file_name()?);
                self.check_place(&path, Access::Write, span)?;
                p.save_file = Some(path);
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// The maps of the file that is named next.
    fn photon_file(&mut self, span: Span) -> Result<Arc<PhotonFile>> {
        let name = self.file_name()?;
        let path = self.require_file(&name, Kind::Data, span)?;
        let refused = |why: String| Box::new(Diagnostic::error(span, format!("cannot read `{name}`: {why}")));
        let bytes = std::fs::read(&path).map_err(|e| refused(e.to_string()))?;
        PhotonFile::read(&bytes).map(Arc::new).ok_or_else(|| refused("it holds no photons".into()))
    }

    /// Up to four numbers: radius and multiplier on surfaces, the same in media.
    fn photon_radius(&mut self, p: &mut PhotonSettings) -> Result<()> {
        for i in 0..4 {
            let comma = i > 0 && self.accept_punct(Punct::Comma)?;
            if !comma && !self.at_expression()? {
                return Ok(());
            }
            let value = self.float()?;
            match i {
                0 => p.surface_radius.0 = value,
                1 => p.surface_radius.1 = value,
                2 => p.media_radius.0 = value,
                _ => p.media_radius.1 = value,
            }
        }
        Ok(())
    }

    /// `{ … }` behind `subsurface`.
    fn subsurface_settings(&mut self) -> Result<SubsurfaceSettings> {
        let mut s = SubsurfaceSettings::default();
        self.expect_punct(Punct::LeftBrace)?;
        while !self.accept_punct(Punct::RightBrace)? {
            let token = self.next()?;
            match token.tok {
                Tok::Word(Keyword::Samples) => {
                    s.diffuse_samples = self.whole(0.0, f64::from(u32::MAX))?.max(1);
                    self.comma()?;
                    s.single_samples = (self.float()? as u32).max(1);
                }
                Tok::Word(Keyword::Radiosity) => s.radiosity = self.flag()?,
                _ => return Err(self.not_a_setting(token, &items::SUBSURFACE)),
            }
        }
        Ok(s)
    }
}

/// More sources of waves than this only cost time.
const MOST_WAVES: f64 = 100_000.0;

/// The reuse distances; one that was not given keeps away from the other.
fn set_reuse(
    r: &mut RadiositySettings,
    minimum: Option<f64>,
    maximum: Option<f64>,
) -> std::result::Result<(), &'static str> {
    r.minimum_reuse = minimum.unwrap_or(r.minimum_reuse);
    r.maximum_reuse = maximum.unwrap_or(r.maximum_reuse);
    if r.minimum_reuse <= 0.5 * r.maximum_reuse {
        return Ok(());
    }
    match (minimum, maximum) {
        (None, _) => r.minimum_reuse = 0.5 * r.maximum_reuse,
        (_, None) => r.maximum_reuse = 2.0 * r.minimum_reuse,
        _ if r.minimum_reuse >= r.maximum_reuse => {
            return Err("`minimum_reuse` must be below `maximum_reuse`");
        }
        _ => {}
    }
    Ok(())
}
