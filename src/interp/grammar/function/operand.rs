//! Operators and operands of a function's expression.

use super::{Body, Name, Operand};
use crate::function::{Binary, Expression, Function, Node, Unary, VectorKind};
use crate::interp::{Parser, Result, Value};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Punct, Symbol, Tok, Token};
use std::sync::Arc;

/// Deepest nesting of parentheses and calls in an expression.
const LARGEST_NESTING: usize = 200;

/// Operators and operands, loosest first.
impl Parser {
    pub(super) fn function_expression(&mut self, body: &mut Body) -> Result<Operand> {
        self.function_deeper(body)?;
        let value = self.left_to_right(body, &[(Punct::Or, Binary::Or)], Self::function_conjunction)?;
        body.nesting -= 1;
        Ok(value)
    }

    fn function_deeper(&mut self, body: &mut Body) -> Result<()> {
        body.nesting += 1;
        if body.nesting > LARGEST_NESTING {
            let span = self.peek()?.span;
            let message = format!("parentheses and calls are nested more than {LARGEST_NESTING} deep");
            return Err(Box::new(Diagnostic::error(span, message)));
        }
        Ok(())
    }

    fn function_conjunction(&mut self, body: &mut Body) -> Result<Operand> {
        self.left_to_right(body, &[(Punct::And, Binary::And)], Self::function_comparison)
    }

    /// Comparisons. In a chain the reference folds two constants at the end before it compares with what
    /// stands on their left: `a = 2 = 1` is `a = (2 = 1)`.
    fn function_comparison(&mut self, body: &mut Body) -> Result<Operand> {
        let mut left = self.function_sum(body)?;
        let mut last: Option<(Node, Binary, f64)> = None;
        while let Some(f) = self.accept_operator(&COMPARISONS)? {
            let right = self.function_sum(body)?;
            let constant = body.expression.value(right.node);
            let (a, f, b) = match (last, constant) {
                (Some((a, before, k)), Some(constant)) => {
                    let k = body.expression.constant(k);
                    let constant = body.expression.constant(constant);
                    (a, before, body.expression.binary(f, k, constant))
                }
                _ => (left.node, f, right.node),
            };
            left = Operand::new(body.expression.binary(f, a, b));
            last = body.expression.value(b).map(|k| (a, f, k));
        }
        Ok(left)
    }

    fn function_sum(&mut self, body: &mut Body) -> Result<Operand> {
        self.left_to_right(
            body,
            &[(Punct::Plus, Binary::Add), (Punct::Minus, Binary::Sub)],
            Self::function_product,
        )
    }

    fn function_product(&mut self, body: &mut Body) -> Result<Operand> {
        let mut left = self.function_signed(body)?;
        while let Some(f) =
            self.accept_operator(&[(Punct::Star, Binary::Mul), (Punct::Slash, Binary::Div)])?
        {
            let span = self.peek()?.span;
            let right = self.function_signed(body)?;
            let (divided, divisor) = (body.expression.value(left.node), body.expression.value(right.node));
            // Of two numbers the quotient is infinite, as in POV-Ray.
            if f == Binary::Div && right.bare && divisor == Some(0.0) && divided.is_none() {
                return Err(Box::new(Diagnostic::error(span, "division by zero")));
            }
            left = Operand::new(body.expression.binary(f, left.node, right.node));
        }
        Ok(left)
    }

    fn left_to_right(
        &mut self,
        body: &mut Body,
        operators: &[(Punct, Binary)],
        operand: fn(&mut Self, &mut Body) -> Result<Operand>,
    ) -> Result<Operand> {
        let mut left = operand(self, body)?;
        while let Some(f) = self.accept_operator(operators)? {
            let right = operand(self, body)?;
            left = Operand::new(body.expression.binary(f, left.node, right.node));
        }
        Ok(left)
    }

    fn accept_operator(&mut self, operators: &[(Punct, Binary)]) -> Result<Option<Binary>> {
        let Tok::Punct(punct) = self.peek()?.tok else { return Ok(None) };
        let Some(&(_, f)) = operators.iter().find(|o| o.0 == punct) else { return Ok(None) };
        self.next()?;
        Ok(Some(f))
    }

    /// An operand with at most one sign.
    fn function_signed(&mut self, body: &mut Body) -> Result<Operand> {
        if self.accept_punct(Punct::Minus)? {
            let operand = self.function_operand(body)?;
            return Ok(Operand::new(body.expression.unary(Unary::Neg, operand.node)));
        }
        self.accept_punct(Punct::Plus)?;
        self.function_operand(body)
    }

    fn function_operand(&mut self, body: &mut Body) -> Result<Operand> {
        let token = self.peek()?;
        match token.tok {
            Tok::Number(value) => {
                self.next()?;
                Ok(Operand { node: body.expression.constant(value), bare: true })
            }
            Tok::Punct(Punct::LeftParen) => {
                self.next()?;
                let inner = self.function_expression(body)?;
                self.expect_punct(Punct::RightParen)?;
                Ok(Operand::new(inner.node))
            }
            Tok::Word(word) => self.function_word(body, word),
            Tok::Identifier(symbol) => self.function_identifier(body, symbol, token),
            _ => Err(self.unexpected("a number, a parameter or a function")),
        }
    }

    fn function_identifier(&mut self, body: &mut Body, symbol: Symbol, token: Token) -> Result<Operand> {
        if let Some(node) = body.argument(Name::Identifier(symbol)) {
            self.next()?;
            return Ok(Operand::new(node));
        }
        match self.peek_value()? {
            None if body.itself == Some(symbol) => self.function_calls_itself(body, token),
            Some(Value::Float(value)) => {
                self.take_value()?;
                Ok(Operand { node: body.expression.constant(value), bare: true })
            }
            Some(Value::Function(function)) => {
                self.take_value()?;
                self.function_call(body, &function, token)
            }
            Some(other) => {
                let message = format!("a function's expression cannot use a {}", other.kind());
                let hint = match other {
                    Value::Vector(..) | Value::Color(_) => {
                        "declare the component as a number outside the function"
                    }
                    Value::Spline(_) => "declare a function of it: `function { spline { … } }`",
                    _ => "it can use numbers, functions and the function's parameters",
                };
                Err(Box::new(Diagnostic::error(token.span, message).with_hint(hint)))
            }
            None => Err(self.unexpected("a number, a parameter or a function")),
        }
    }

    /// `F(a, b, …)` in the body of F.
    fn function_calls_itself(&mut self, body: &mut Body, name: Token) -> Result<Operand> {
        self.take(name)?;
        let message = "this function calls itself";
        self.warn(Diagnostic::warning(name.span, message).with_label("it may call itself without end"));
        let (arguments, span) = self.function_arguments(body)?;
        check_count(arguments.len(), body.parameters.len(), name.span.to(span))?;
        Ok(Operand::new(body.expression.call_itself(&arguments)))
    }

    /// `F(a, b, …)`, with `.member` if the function gives vectors.
    fn function_call(&mut self, body: &mut Body, function: &Arc<Function>, name: Token) -> Result<Operand> {
        let (arguments, span) = self.function_arguments(body)?;
        check_count(arguments.len(), function.arity(), name.span.to(span))?;
        let call = function.call_in(&mut body.expression, &arguments);
        match function.vector_kind() {
            None => Ok(Operand::new(call)),
            Some(kind) => self.function_member(body, call, kind).map(Operand::new),
        }
    }

    /// `(a, b, …)`; also where the list ends.
    pub(super) fn function_arguments(&mut self, body: &mut Body) -> Result<(Vec<Node>, Span)> {
        self.expect_punct(Punct::LeftParen)?;
        let mut arguments = vec![self.function_expression(body)?.node];
        while self.accept_punct(Punct::Comma)? {
            arguments.push(self.function_expression(body)?.node);
        }
        let close = self.expect_punct(Punct::RightParen)?;
        Ok((arguments, close.span))
    }

    fn function_member(&mut self, body: &mut Body, call: Node, kind: VectorKind) -> Result<Node> {
        if self.peek()?.tok != Tok::Punct(Punct::Dot) {
            return Err(self.unexpected("`.` and a component, since this function gives a vector"));
        }
        self.next()?;
        let token = self.peek()?;
        let e = &mut body.expression;
        let component = match token.tok {
            Tok::Word(Keyword::X | Keyword::U | Keyword::Red) => 0,
            Tok::Word(Keyword::Y | Keyword::V | Keyword::Green) => 1,
            Tok::Word(Keyword::Z | Keyword::Blue) => 2,
            Tok::Word(Keyword::T | Keyword::Filter) => 3,
            Tok::Word(Keyword::Transmit) => 4,
            Tok::Word(Keyword::Gray) if kind.components() >= 3 => {
                self.next()?;
                return Ok(weighted(e, call, &[0.297, 0.589, 0.114]));
            }
            Tok::Identifier(symbol) if self.name(symbol) == "hf" && kind.components() >= 2 => {
                self.next()?;
                return Ok(weighted(e, call, &[0.996093, 0.996093 / 255.0]));
            }
            _ => return Err(self.unexpected("the name of a component")),
        };
        self.next()?;
        if usize::from(component) >= kind.components() {
            let message = format!("this function gives only {} components", kind.components());
            return Err(Box::new(Diagnostic::error(token.span, message)));
        }
        Ok(e.component(call, component))
    }
}

const COMPARISONS: [(Punct, Binary); 6] = [
    (Punct::Less, Binary::Less),
    (Punct::LessEqual, Binary::LessEqual),
    (Punct::Equal, Binary::Equal),
    (Punct::NotEqual, Binary::NotEqual),
    (Punct::GreaterEqual, Binary::GreaterEqual),
    (Punct::Greater, Binary::Greater),
];

/// The sum of a call's components with these weights.
fn weighted(e: &mut Expression, call: Node, weights: &[f64]) -> Node {
    let mut sum = e.constant(0.0);
    for (i, &weight) in weights.iter().enumerate() {
        let (component, weight) = (e.component(call, i as u8), e.constant(weight));
        let product = e.binary(Binary::Mul, component, weight);
        sum = if i == 0 { product } else { e.binary(Binary::Add, sum, product) };
    }
    sum
}

fn check_count(given: usize, wanted: usize, span: Span) -> Result<()> {
    if given == wanted {
        return Ok(());
    }
    let message = format!("this function has {wanted} parameters, and {given} arguments are given");
    Err(Box::new(Diagnostic::error(span, message)))
}
