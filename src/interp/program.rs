//! Numeric expressions of replayed text, compiled when they come for the second time.
//!
//! A program covers what loops do most: numbers, number variables, components, elements of arrays,
//! operators and functions of numbers. Where its value would need more (a warning, an error, a vector,
//! a call), it gives up without having changed anything, and the expression is read as usual.

use super::builtin::{Partial, partial, pure};
use super::comparison::{Comparison, near};
use super::expr::{number, truth};
use crate::syntax::{Keyword, Punct, Symbol, Tok, Token};

/// Which operators an expression may have outside parentheses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Level {
    /// `+` and `-`.
    Additive,
    /// Comparisons, `&`, `|` and `?:` too.
    Full,
}

/// One step on a stack of numbers.
#[derive(Clone, Copy, Debug)]
pub(super) enum Op {
    Constant(f64),
    Variable(Symbol),
    /// `V.x`.
    Component(Symbol, u8),
    /// `A[i][j]`: as many subscripts as said stand on the stack.
    Element(Symbol, u8),
    /// `A[i].x`.
    ElementComponent(Symbol, u8, u8),
    Function(fn(f64) -> f64),
    /// A function that is not defined everywhere.
    Partial(Partial),
    Binary(Binary),
    /// With a constant or a variable on the right.
    BinaryConstant(Binary, f64),
    BinaryVariable(Binary, Symbol),
    /// `c ? a : b`.
    Choose,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Binary {
    Add,
    Subtract,
    Multiply,
    Divide,
    And,
    Or,
    Compare(Comparison),
    Atan2,
    Pow,
    Div,
    Mod,
    Min,
    Max,
}

impl Binary {
    /// `None` where the language warns or fails.
    #[inline]
    pub fn apply(self, a: f64, b: f64) -> Option<f64> {
        Some(match self {
            Binary::Add => a + b,
            Binary::Subtract => a - b,
            Binary::Multiply => a * b,
            Binary::Divide if b == 0.0 => return None,
            Binary::Divide => a / b,
            Binary::And => number(truth(a) && truth(b)),
            Binary::Or => number(truth(a) || truth(b)),
            Binary::Compare(comparison) => comparison.of(a, b),
            Binary::Atan2 if near(a, 0.0) && near(b, 0.0) => return None,
            Binary::Atan2 => a.atan2(b),
            Binary::Pow if a == 0.0 && b == 0.0 => return None,
            Binary::Pow => a.powf(b),
            Binary::Div => super::builtin::truncate(a / b),
            Binary::Mod => a % b,
            Binary::Min => a.min(b),
            Binary::Max => a.max(b),
        })
    }
}

/// An expression's steps, and where it ends.
#[derive(Debug)]
pub(super) struct Program {
    pub ops: Box<[Op]>,
    pub level: Level,
    /// The token behind the expression.
    pub end: usize,
    /// A name behind the expression: if it is a macro's, the expression may go on.
    pub after: Option<Symbol>,
}

/// Numbers that wait at once.
pub(super) const DEPTH: usize = 32;

/// Parentheses within each other.
const NESTING: usize = 64;

/// Compiles the expression that begins at token `at`; `None` if it is not of the simple kind.
pub(super) fn compile(tokens: &[Token], at: usize, level: Level, clock: f64) -> Option<Program> {
    let mut compiler = Compiler { tokens, at, ops: Vec::new(), waiting: 0, nesting: 0, clock };
    match level {
        Level::Additive => compiler.additive()?,
        Level::Full => compiler.full()?,
    }
    let after = match compiler.peek()? {
        // More may come from a directive; the rest would end in an error.
        Tok::Directive(_) | Tok::Punct(Punct::Dot | Punct::LeftBracket | Punct::LeftParen | Punct::Hash) => {
            return None;
        }
        Tok::Identifier(name) => Some(name),
        _ => None,
    };
    Some(Program { ops: compiler.ops.into_boxed_slice(), level, end: compiler.at, after })
}

struct Compiler<'a> {
    tokens: &'a [Token],
    at: usize,
    ops: Vec<Op>,
    waiting: usize,
    nesting: usize,
    clock: f64,
}

impl Compiler<'_> {
    /// The next token; `None` at the end of the kept text, where an expression may go on elsewhere.
    fn peek(&self) -> Option<Tok> {
        self.tokens.get(self.at).map(|t| t.tok)
    }

    fn accept(&mut self, punct: Punct) -> bool {
        let found = self.peek() == Some(Tok::Punct(punct));
        self.at += usize::from(found);
        found
    }

    fn expect(&mut self, punct: Punct) -> Option<()> {
        self.accept(punct).then_some(())
    }

    fn push(&mut self, op: Op) -> Option<()> {
        self.ops.push(op);
        self.waiting += 1;
        (self.waiting <= DEPTH).then_some(())
    }

    /// Joins the two numbers on top.
    fn binary(&mut self, binary: Binary) {
        self.waiting -= 1;
        let fused = match self.ops.last() {
            Some(Op::Constant(v)) => Op::BinaryConstant(binary, *v),
            Some(Op::Variable(name)) => Op::BinaryVariable(binary, *name),
            _ => {
                self.ops.push(Op::Binary(binary));
                return;
            }
        };
        self.ops.pop();
        self.ops.push(fused);
    }

    fn full(&mut self) -> Option<()> {
        self.logical()?;
        if self.accept(Punct::Question) {
            self.nested(|c| {
                c.full()?;
                c.expect(Punct::Colon)?;
                c.full()
            })?;
            self.ops.push(Op::Choose);
            self.waiting -= 2;
        }
        Some(())
    }

    fn logical(&mut self) -> Option<()> {
        self.relational()?;
        loop {
            let binary = match self.peek()? {
                Tok::Punct(Punct::And) => Binary::And,
                Tok::Punct(Punct::Or) => Binary::Or,
                _ => return Some(()),
            };
            self.at += 1;
            self.relational()?;
            self.binary(binary);
        }
    }

    fn relational(&mut self) -> Option<()> {
        self.additive()?;
        while let Some(comparison) = Comparison::from_token(self.peek()?) {
            self.at += 1;
            self.additive()?;
            self.binary(Binary::Compare(comparison));
        }
        Some(())
    }

    fn additive(&mut self) -> Option<()> {
        self.multiplicative()?;
        loop {
            let binary = match self.peek()? {
                Tok::Punct(Punct::Plus) => Binary::Add,
                Tok::Punct(Punct::Minus) => Binary::Subtract,
                _ => return Some(()),
            };
            self.at += 1;
            self.multiplicative()?;
            self.binary(binary);
        }
    }

    fn multiplicative(&mut self) -> Option<()> {
        self.unary()?;
        loop {
            let binary = match self.peek()? {
                Tok::Punct(Punct::Star) => Binary::Multiply,
                Tok::Punct(Punct::Slash) => Binary::Divide,
                _ => return Some(()),
            };
            self.at += 1;
            self.unary()?;
            self.binary(binary);
        }
    }

    fn unary(&mut self) -> Option<()> {
        let function: fn(f64) -> f64 = match self.peek()? {
            Tok::Punct(Punct::Minus) => |v| -v,
            Tok::Punct(Punct::Plus) => |v| v,
            Tok::Punct(Punct::Not) => |v| number(!truth(v)),
            _ => return self.primary(),
        };
        self.at += 1;
        self.nested(Self::unary)?;
        if let Some(Op::Constant(v)) = self.ops.last_mut() {
            *v = function(*v);
        } else {
            self.ops.push(Op::Function(function));
        }
        Some(())
    }

    fn primary(&mut self) -> Option<()> {
        let tok = self.peek()?;
        self.at += 1;
        match tok {
            Tok::Number(v) => self.push(Op::Constant(v)),
            Tok::Identifier(name) => self.variable(name),
            Tok::Punct(Punct::LeftParen) => {
                self.nested(Self::full)?;
                self.expect(Punct::RightParen)
            }
            Tok::Word(word) => self.word(word),
            _ => None,
        }
    }

    fn nested(&mut self, read: impl FnOnce(&mut Self) -> Option<()>) -> Option<()> {
        self.nesting += 1;
        if self.nesting > NESTING {
            return None;
        }
        read(self)?;
        self.nesting -= 1;
        Some(())
    }

    fn variable(&mut self, name: Symbol) -> Option<()> {
        let mut subscripts = 0;
        while self.accept(Punct::LeftBracket) {
            self.nested(Self::additive)?;
            self.expect(Punct::RightBracket)?;
            subscripts += 1;
        }
        let component = if self.accept(Punct::Dot) { Some(self.component()?) } else { None };
        self.waiting = self.waiting.checked_sub(subscripts as usize)?;
        self.push(match (subscripts, component) {
            (0, None) => Op::Variable(name),
            (0, Some(index)) => Op::Component(name, index),
            (n, None) => Op::Element(name, n),
            (n, Some(index)) => Op::ElementComponent(name, n, index),
        })
    }

    fn component(&mut self) -> Option<u8> {
        let Tok::Word(word) = self.peek()? else { return None };
        self.at += 1;
        super::expr::component_index(word)
    }

    fn word(&mut self, word: Keyword) -> Option<()> {
        if let Some(v) = super::expr::scalar_constant(word) {
            return self.push(Op::Constant(v));
        }
        if word == Keyword::Clock {
            return self.push(Op::Constant(self.clock));
        }
        self.expect(Punct::LeftParen)?;
        if let Some(function) = pure(word) {
            self.nested(Self::full)?;
            self.ops.push(Op::Function(function));
        } else if let Some(partial) = partial(word) {
            self.nested(Self::full)?;
            self.ops.push(Op::Partial(partial));
        } else {
            self.arguments(word)?;
        }
        self.expect(Punct::RightParen)
    }

    /// The arguments of a function of two numbers, or of more for `min` and `max`.
    fn arguments(&mut self, word: Keyword) -> Option<()> {
        let (binary, most) = match word {
            Keyword::Atan2 => (Binary::Atan2, 2),
            Keyword::Pow => (Binary::Pow, 2),
            Keyword::Div => (Binary::Div, 2),
            Keyword::Mod => (Binary::Mod, 2),
            Keyword::Min => (Binary::Min, usize::MAX),
            Keyword::Max => (Binary::Max, usize::MAX),
            _ => return None,
        };
        self.nested(Self::additive)?;
        let mut count = 1;
        while count < most && self.accept(Punct::Comma) {
            self.nested(Self::additive)?;
            self.binary(binary);
            count += 1;
        }
        (count == 2 || most > 2).then_some(())
    }
}
