//! Assignments: `#declare`, `#local`, `#undef`, and what may stand on their right side.

use super::array::check_array_depth;
use crate::interp::program::Level;
use crate::interp::symbols::{Binding, GLOBAL, Place, Reference};
use crate::interp::{Parser, Result, Value};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Punct, Symbol, Tok, Token};
use std::sync::Arc;

/// The right side of an assignment.
pub(in crate::interp) struct Rvalue {
    pub value: Value,
    /// Numbers, vectors and colours need a semicolon.
    pub numeric: bool,
}

/// The left side of an assignment.
pub(in crate::interp) struct Target {
    symbol: Symbol,
    /// The variable or element, if the name is known.
    reference: Option<Reference>,
    /// The innermost table when the name was read: macros on the right side may stand in another one.
    scope: u32,
    /// Whether that table has the name.
    local: bool,
    subscripted: bool,
    span: Span,
}

impl Parser {
    /// `#declare ID = …` and `#local ID = …`, behind the word.
    pub(in crate::interp) fn declare_directive(&mut self, local: bool) -> Result<()> {
        if self.fast_assignment(local) {
            return self.second_semicolon();
        }
        let deprecation = self.deprecation()?;
        let target = self.assignment_target()?;
        match deprecation {
            Some(message) => {
                self.deprecated.insert(target.symbol, message);
            }
            None if !self.deprecated.is_empty() => {
                self.deprecated.remove(&target.symbol);
            }
            None => {}
        }
        let equal = self.raw()?;
        if equal.tok != Tok::Punct(Punct::Equal) {
            return Err(self.unexpected_token(equal, "`=`"));
        }
        self.last = equal.span;
        self.deeper()?;
        // Directives may choose the right side, but not cut it short.
        let first = self.peek_operand()?;
        let names_function = first.tok == Tok::Word(Keyword::Function) && !target.subscripted;
        self.declaring = names_function.then_some(target.symbol);
        let before = self.hold();
        let rvalue = self.rvalue();
        self.release(before);
        self.shallower();
        let Rvalue { value, numeric } = rvalue?;
        let span = target.span.to(self.last);
        self.name_behind_texture(&target, &value)?;
        if local {
            self.local_target(target, value)?
        } else {
            self.declare_target(target, value)?
        };
        self.end_assignment(span, numeric)
    }

    /// Behind a texture another layer may stand, so the reference has read the next word before the assignment:
    /// the new name is not known there.
    fn name_behind_texture(&mut self, target: &Target, value: &Value) -> Result<()> {
        let (Value::Texture(_), None) = (value, &target.reference) else { return Ok(()) };
        let next = self.take_ahead();
        if let Some(token) = next {
            self.set_raw_ahead(token);
            if token.tok == Tok::Identifier(target.symbol) {
                let message = format!("`{}` is used before it is assigned", self.name(target.symbol));
                return self.lenient(Diagnostic::warning(token.span, message));
            }
        }
        Ok(())
    }

    /// `deprecated [once] ["message"]`: what is said when the name is used (at one place it is said once).
    fn deprecation(&mut self) -> Result<Option<Arc<str>>> {
        if self.glance()? != Tok::Word(Keyword::Deprecated) {
            return Ok(None);
        }
        self.raw()?;
        if self.glance()? == Tok::Word(Keyword::Once) {
            self.raw()?;
        }
        if let Tok::String(_) = self.glance()? {
            return self.string_value().map(Some);
        }
        Ok(Some(Arc::from("this name is declared deprecated")))
    }

    /// Says that the name just read is deprecated, if it is.
    pub(in crate::interp) fn warn_deprecated(&mut self, token: Token, name: Symbol) {
        if let Some(message) = self.deprecated.get(&name) {
            let message = message.as_ref().to_owned();
            self.warn(Diagnostic::warning(token.span, message));
        }
    }

    /// A name, with subscripts if it is an array.
    pub(in crate::interp) fn assignment_target(&mut self) -> Result<Target> {
        let token = match self.take_ahead() {
            Some(token) => token,
            None => self.raw()?,
        };
        let Tok::Identifier(symbol) = token.tok else {
            let expected = match token.tok {
                Tok::Word(_) => "a new name: words of the language cannot be assigned to",
                _ => "a name",
            };
            return Err(self.unexpected_token(token, expected));
        };
        self.last = token.span;
        let mut reference = self.symbols.reference(symbol);
        let (scope, local) = (self.symbols.innermost(), self.symbols.is_local(symbol));
        let subscripted = match &mut reference {
            Some(reference) => self.subscripts(reference, token.span)?,
            None => false,
        };
        Ok(Target { symbol, reference, scope, local, subscripted, span: token.span.to(self.last) })
    }

    /// What the left side holds now.
    pub(in crate::interp) fn target_value(&self, target: &Target) -> Option<&Value> {
        self.symbols.target(target.reference.as_ref()?)
    }

    /// `#declare`: whatever the name means now is overwritten, a new name is global.
    pub(in crate::interp) fn declare_target(&mut self, target: Target, value: Value) -> Result<()> {
        match target.reference {
            Some(reference) => self.assign(&reference, value, target.span),
            None => {
                self.symbols.bind(target.symbol, GLOBAL, Binding::Value(value));
                Ok(())
            }
        }
    }

    /// `#local`: only a name of the innermost table is overwritten.
    fn local_target(&mut self, target: Target, value: Value) -> Result<()> {
        match target.reference {
            Some(reference) if target.local || target.subscripted => {
                self.assign(&reference, value, target.span)
            }
            // The right side went on behind the macro's end: nobody can see the name any more.
            _ if target.scope > self.symbols.innermost() => Ok(()),
            _ => {
                self.symbols.bind(target.symbol, target.scope, Binding::Value(value));
                Ok(())
            }
        }
    }

    /// As `#local` does.
    pub(in crate::interp) fn assign_local(&mut self, symbol: Symbol, value: Value, span: Span) -> Result<()> {
        let reference = self.symbols.reference(symbol);
        let (scope, local) = (self.symbols.innermost(), self.symbols.is_local(symbol));
        self.local_target(Target { symbol, reference, scope, local, subscripted: false, span }, value)
    }

    fn assign(&mut self, reference: &Reference, value: Value, span: Span) -> Result<()> {
        let depth = value.array_depth();
        check_array_depth(depth as usize + reference.path.len(), span)?;
        match self.symbols.place(reference, depth) {
            Some(Place::Variable(Binding::Value(Value::Function(_)))) => Err(redeclared_function(span)),
            Some(Place::Variable(binding)) => {
                *binding = Binding::Value(value);
                Ok(())
            }
            Some(Place::Element { element: Some(Value::Function(_)), .. }) => Err(redeclared_function(span)),
            Some(Place::Element { kind, element }) => {
                let found = value.kind();
                match kind {
                    Some(kind) if *kind != found => {
                        let message = format!("this array's elements are of the kind {kind}, not {found}");
                        return Err(Box::new(Diagnostic::error(span, message)));
                    }
                    _ => *kind = Some(found),
                }
                *element = Some(value);
                Ok(())
            }
            None => Err(Box::new(Diagnostic::error(span, "what this name stood for is gone"))),
        }
    }

    /// `#undef ID`, behind the word.
    pub(in crate::interp) fn undef_directive(&mut self) -> Result<()> {
        let target = self.assignment_target()?;
        let gone = match target.reference {
            None => false,
            // Of a parameter that stands for a variable only the parameter goes.
            Some(_) if !target.subscripted => self.symbols.remove_innermost(target.symbol),
            Some(reference) => match self.symbols.place(&reference, 0) {
                Some(Place::Element { element, .. }) => element.take().is_some(),
                _ => false,
            },
        };
        if !gone {
            let message = format!("`{}` has no value to remove", self.name(target.symbol));
            self.warn(Diagnostic::warning(target.span, message));
        }
        if self.accept_raw(Punct::Semicolon)? {
            self.lenient(Diagnostic::warning(self.last, "no `;` is needed behind `#undef`"))?;
        }
        Ok(())
    }

    /// What may be assigned or passed to a macro.
    pub(in crate::interp) fn rvalue(&mut self) -> Result<Rvalue> {
        if let Some(v) = self.compiled(Level::Additive) {
            return Ok(Rvalue { value: Value::Float(v), numeric: true });
        }
        let token = self.peek_operand()?;
        if let Tok::Identifier(_) = token.tok {
            return self.identifier_rvalue();
        }
        if self.at_expression()? {
            return Ok(Rvalue { value: self.expression()?, numeric: true });
        }
        if self.at_string()? {
            return Ok(Rvalue { value: Value::String(self.string_value()?), numeric: false });
        }
        let value = match token.tok {
            Tok::Word(word) => self.statement_value(word)?,
            _ => None,
        };
        match value {
            Some(value) => Ok(Rvalue { value, numeric: false }),
            None => Err(self.unexpected("a value")),
        }
    }

    fn identifier_rvalue(&mut self) -> Result<Rvalue> {
        match self.peek_value()? {
            None => Err(self.unexpected("a value")),
            Some(Value::Function(_) | Value::Spline(_)) => {
                if self.glance()? == Tok::Punct(Punct::LeftParen) {
                    return Ok(Rvalue { value: self.expression()?, numeric: true });
                }
                // The reference looks for the parenthesis, and wants `;` where it finds none.
                Ok(Rvalue { value: self.take_value()?, numeric: true })
            }
            Some(Value::Array(_)) => {
                let name = self.peek()?.tok;
                let array = self.take_value()?;
                self.array_at_the_end_of_its_macro(name)?;
                Ok(Rvalue { value: array, numeric: false })
            }
            Some(Value::Float(_) | Value::Vector(..) | Value::Color(_)) => {
                Ok(Rvalue { value: self.expression()?, numeric: true })
            }
            Some(_) => Ok(Rvalue { value: self.take_value()?, numeric: false }),
        }
    }

    /// A macro's own array as its last word: the reference looks for a bracket behind it, leaves the macro, and finds
    /// no array any more.
    fn array_at_the_end_of_its_macro(&mut self, name: Tok) -> Result<()> {
        let is_own = matches!(name, Tok::Identifier(name) if self.symbols.is_local(name));
        if self.options.strict && is_own && self.is_end_of_macro() {
            let message = "this array is gone when the macro's end has been read";
            return self.lenient(Diagnostic::warning(self.last, message));
        }
        Ok(())
    }

    /// A value that a word of the language begins.
    fn statement_value(&mut self, word: Keyword) -> Result<Option<Value>> {
        use Keyword as K;
        Ok(Some(match word {
            K::Pigment => Value::Pigment(self.pigment_statement()?),
            K::Normal => Value::Normal(Some(self.normal_statement()?)),
            K::Finish => Value::Finish(self.finish_statement()?),
            K::Texture => Value::Texture(Arc::new(self.layered_texture_statement()?)),
            K::ColorMap | K::PigmentMap | K::NormalMap | K::SlopeMap | K::TextureMap | K::DensityMap => {
                self.map_statement()?
            }
            K::Camera => Value::Camera(Arc::new(self.camera_statement()?)),
            K::Fog => Value::Fog(Arc::new(self.fog_statement()?)),
            K::Rainbow => Value::Rainbow(Arc::new(self.rainbow_statement()?)),
            K::SkySphere => Value::SkySphere(Arc::new(self.sky_sphere_statement()?)),
            K::Media => Value::Media(self.media_statement()?.value),
            K::Density => Value::Density(self.density_statement()?),
            K::Interior => Value::Interior(self.interior_statement()?.value),
            K::Material => Value::Material(Arc::new(self.material_statement()?)),
            K::Transform => Value::Transform(Arc::new(self.transform_statement()?)),
            K::Spline => self.spline_statement()?,
            K::Array => Value::Array(Arc::new(self.array_statement()?)),
            K::Function => self.function_statement()?,
            _ => return Ok(self.object()?.map(|object| Value::Object(Arc::new(object)))),
        }))
    }

    /// The error for a name without a value, where one must be read.
    pub(in crate::interp) fn unset(&self, token: Token) -> Box<Diagnostic> {
        Box::new(Diagnostic::error(token.span, "this array element has no value yet"))
    }
}

fn redeclared_function(span: Span) -> Box<Diagnostic> {
    Box::new(
        Diagnostic::error(span, "a function cannot be declared again")
            .with_hint("remove it with `#undef` first"),
    )
}
