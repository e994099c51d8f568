//! The top level of a scene.

use crate::interp::{Parser, Result};
use crate::source::Diagnostic;
use crate::syntax::{Keyword, Punct, Tok};

impl Parser {
    /// Statements up to the end of the text.
    pub(in crate::interp) fn scene_statements(&mut self) -> Result<()> {
        loop {
            let token = self.peek()?;
            match token.tok {
                Tok::End => return Ok(()),
                Tok::Word(word) => self.scene_statement(word)?,
                Tok::Punct(Punct::RightBrace) => {
                    return Err(Box::new(Diagnostic::error(token.span, "this `}` closes nothing")));
                }
                _ => self.top_level_object()?,
            }
            self.spoken = true;
        }
    }

    fn scene_statement(&mut self, word: Keyword) -> Result<()> {
        use Keyword as K;
        match word {
            K::Camera => self.top_level_camera(),
            K::GlobalSettings => self.global_settings_statement(),
            K::Background => self.background_statement(),
            K::Fog => {
                let fog = self.fog_statement()?;
                self.scene.scene.fogs.push(fog);
                Ok(())
            }
            K::Rainbow => {
                let rainbow = self.rainbow_statement()?;
                self.scene.scene.rainbows.push(rainbow);
                Ok(())
            }
            K::SkySphere => self.top_level_sky_sphere(),
            K::Media => {
                let media = self.media_statement()?;
                self.scene.scene.media.push(media);
                Ok(())
            }
            K::Declare | K::Include | K::Version | K::Default | K::MaxTraceLevel => self.bare_directive(word),
            _ => self.top_level_object(),
        }
    }

    /// The last camera is used.
    fn top_level_camera(&mut self) -> Result<()> {
        let span = self.peek()?.span;
        let camera = self.camera_statement()?;
        if std::mem::replace(&mut self.camera_given, true) && self.syntax_version() >= 350 {
            self.warn(Diagnostic::warning(span, "there is more than one camera: the last one is used"));
        }
        self.scene.scene.camera = camera;
        Ok(())
    }

    fn top_level_sky_sphere(&mut self) -> Result<()> {
        let span = self.peek()?.span;
        let sky_sphere = self.sky_sphere_statement()?;
        if self.scene.scene.sky_sphere.replace(sky_sphere).is_some() {
            let text = "there is more than one sky_sphere: the last one is used";
            self.warn(Diagnostic::warning(span, text));
        }
        Ok(())
    }

    /// A directive's word without its `#`.
    fn bare_directive(&mut self, word: Keyword) -> Result<()> {
        let token = self.next()?;
        if self.syntax_version() >= 300 && word != Keyword::MaxTraceLevel {
            let text = format!("`{}` without `#` is old", word.text());
            self.warn(Diagnostic::warning(token.span, text).with_hint(format!("write `#{}`", word.text())));
        }
        match word {
            Keyword::Declare => self.declare_directive(false),
            Keyword::Include => self.include_directive(token.span),
            Keyword::Version => self.version_directive(),
            Keyword::Default => self.default_statement(),
            _ => self.max_trace_level_statement(token.span),
        }
    }

    fn top_level_object(&mut self) -> Result<()> {
        match self.object_statement()? {
            true => Ok(()),
            false => Err(self.unexpected_statement()),
        }
    }
}
