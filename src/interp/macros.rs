//! `#macro` and the calls of macros.

use super::kept::Kept;
use super::stream::{Frame, Source};
use super::symbols::{Binding, GLOBAL, Reference, Symbols};
use super::{Parser, Result, Value};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Directive, Punct, Symbol, Tok, Token};
use std::rc::Rc;

/// A macro's parameters and body: a range of kept text.
#[derive(Debug)]
pub(super) struct Macro {
    parameters: Vec<Symbol>,
    text: Rc<Kept>,
    range: (usize, usize),
    span: Span,
}

/// Most parameters of a macro.
const MOST_PARAMETERS: usize = 55;

impl Parser {
    /// `#macro Name(P1, P2, …) body #end`, behind `#macro`.
    pub(super) fn define_macro(&mut self, directive: Directive, span: Span) -> Result<()> {
        if self.syntax_version() < 310 {
            return Err(Box::new(Diagnostic::error(span, "macros need `#version 3.1` or later")));
        }
        let name = self.raw()?;
        let Tok::Identifier(symbol) = name.tok else {
            return Err(self.unexpected_token(name, "a name for the macro"));
        };
        let parameters = self.parameters()?;
        let (text, range) = if directive.target == Directive::UNKNOWN {
            let first = Token { tok: Tok::Directive(directive), span };
            let kept = self.capture(first)?;
            let end = kept.len() - 1;
            (Rc::new(Kept::new(kept)), (1, end))
        } else {
            self.kept_body(directive, span)?
        };
        let definition = Macro { parameters, text, range, span };
        self.symbols.bind(symbol, GLOBAL, Binding::Macro(Rc::new(definition)));
        Ok(())
    }

    /// The body of a macro defined in kept text: its range there.
    fn kept_body(&mut self, directive: Directive, span: Span) -> Result<(Rc<Kept>, (usize, usize))> {
        let end = directive.target as usize;
        match self.frames.last_mut() {
            Some(frame) if frame.at <= end && end < frame.end => {
                let range = (frame.at, end);
                frame.at = end + 1;
                Ok((frame.text.clone(), range))
            }
            _ => Err(super::stream::missing_end(Token { tok: Tok::Directive(directive), span })),
        }
    }

    /// `(P1, P2, …)`: names not used as words of the language.
    fn parameters(&mut self) -> Result<Vec<Symbol>> {
        let open = self.raw()?;
        if open.tok != Tok::Punct(Punct::LeftParen) {
            return Err(self.unexpected_token(open, "`(` and the macro's parameters"));
        }
        let mut parameters = Vec::new();
        loop {
            let token = self.raw()?;
            match token.tok {
                Tok::Punct(Punct::RightParen) => return Ok(parameters),
                Tok::Punct(Punct::Comma) if !parameters.is_empty() => {}
                Tok::Identifier(name) if parameters.len() < MOST_PARAMETERS => parameters.push(name),
                Tok::Identifier(_) => {
                    let message = format!("a macro has more than {MOST_PARAMETERS} parameters");
                    return Err(Box::new(Diagnostic::error(token.span, message)));
                }
                _ => return Err(self.unexpected_token(token, "a parameter's name, `,` or `)`")),
            }
        }
    }

    /// `Name(argument, …)`, behind the name: reads the arguments and goes on in the body.
    pub(super) fn call_macro(&mut self, name: Symbol, span: Span) -> Result<()> {
        let Some(Binding::Macro(called)) = self.symbols.binding(name) else { return Ok(()) };
        let called = called.clone();
        let scope = self.symbols.innermost();
        self.expect_punct(Punct::LeftParen)?;
        let mut arguments = Vec::with_capacity(called.parameters.len());
        for index in 0..called.parameters.len() {
            if self.peek()?.tok == Tok::Punct(Punct::RightParen) {
                return Err(self.too_few(name, &called, index));
            }
            arguments.push(self.argument(scope)?);
            self.comma()?;
        }
        if self.peek()?.tok != Tok::Punct(Punct::RightParen) {
            let count = called.parameters.len();
            let expected = format!("`)`: `{}` has {count} parameter{}", self.name(name), plural(count));
            return Err(self.unexpected(&expected));
        }
        self.next()?;
        self.enter_macro(name, &called, arguments, span)
    }

    fn enter_macro(
        &mut self,
        name: Symbol,
        called: &Macro,
        arguments: Vec<Binding>,
        span: Span,
    ) -> Result<()> {
        self.check_tables(span)?;
        self.count_pass(span)?;
        self.symbols.enter();
        for (parameter, argument) in called.parameters.iter().zip(arguments) {
            self.symbols.bind_innermost(*parameter, argument);
        }
        let blocks = self.blocks.len();
        let frame = Frame::kept(called.text.clone(), called.range, Source::Macro(name), blocks, span);
        self.enter_frame(frame);
        Ok(())
    }

    /// Refuses one symbol table too many.
    pub(super) fn check_tables(&self, span: Span) -> Result<()> {
        // Two tables always stand: reserved words and global symbols.
        if self.symbols.depth() + 2 < self.options.limits.symbol_tables {
            return Ok(());
        }
        let limit = self.options.limits.symbol_tables - 2;
        Err(Box::new(
            Diagnostic::error(span, format!("more than {limit} macro calls and includes within each other"))
                .with_hint(
                    "a macro that calls itself needs a condition that ends it; `--limit calls=N` allows more",
                ),
        ))
    }

    /// One argument: a variable standing alone is passed by reference, all else by value. `scope` is the
    /// caller's table.
    fn argument(&mut self, scope: u32) -> Result<Binding> {
        let token = self.peek()?;
        if let Tok::Identifier(name) = token.tok
            && name != Symbols::ELEMENT
            && self.stands_alone(name)?
        {
            self.take(token)?;
            return self.reference_argument(name, scope, token.span);
        }
        Ok(Binding::Value(self.rvalue()?.value))
    }

    /// Whether the variable that comes next is the whole argument.
    fn stands_alone(&mut self, name: Symbol) -> Result<bool> {
        use Punct::*;
        let after = self.glance()?;
        Ok(match self.symbols.value(name) {
            None => false,
            Some(Value::Function(_) | Value::Spline(_)) => !matches!(after, Tok::Punct(LeftParen)),
            Some(Value::Array(_)) if after == Tok::Punct(LeftBracket) => true,
            Some(_) => !matches!(after, Tok::Punct(Dot | Star | Slash | Plus | Minus | LeftBracket)),
        })
    }

    fn reference_argument(&mut self, name: Symbol, scope: u32, span: Span) -> Result<Binding> {
        let Some(mut reference) = self.symbols.reference(name) else {
            return Err(Box::new(Diagnostic::error(
                span,
                "cannot pass this name to a macro: it has no value",
            )));
        };
        self.subscripts(&mut reference, span)?;
        if let Tok::Punct(Punct::Dot | Punct::Star | Punct::Slash | Punct::Plus | Punct::Minus) =
            self.glance()?
        {
            return self.element_expression(&reference, span);
        }
        match self.symbols.target(&reference) {
            Some(value @ Value::Function(_)) => Ok(Binding::Value(value.clone())),
            // What a macro among the arguments yields is gone when the macro has ended.
            Some(value) if reference.scope > scope => Ok(Binding::Value(value.clone())),
            _ => Ok(Binding::Reference(Box::new(reference))),
        }
    }

    /// An array element that begins a longer expression.
    fn element_expression(&mut self, reference: &Reference, span: Span) -> Result<Binding> {
        let Some(value) = self.symbols.target(reference).cloned() else {
            return Err(Box::new(Diagnostic::error(span, "this array element has no value yet")));
        };
        self.put_element_ahead(value, span);
        Ok(Binding::Value(self.rvalue()?.value))
    }

    fn too_few(&mut self, name: Symbol, called: &Macro, found: usize) -> Box<Diagnostic> {
        let count = called.parameters.len();
        let message =
            format!("`{}` has {count} parameter{}, but {found} came", self.name(name), plural(count));
        let mut diagnostic = Diagnostic::error(self.last, message);
        diagnostic
            .labels
            .push(crate::source::Label { span: called.span, message: "the macro begins here".to_owned() });
        Box::new(diagnostic)
    }
}

fn plural(count: usize) -> &'static str {
    if count == 1 { "" } else { "s" }
}
