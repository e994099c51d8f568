//! Surfaces given by the coefficients of a polynomial.

use super::object::from_shape;
use crate::interp::{Parser, Result};
use crate::scene::Object;
use crate::shape::{Algebraic, Quadric};
use crate::source::Diagnostic;
use crate::syntax::{Keyword, Punct, Token};

impl Parser {
    pub(super) fn quadric(&mut self, _keyword: Token) -> Result<Object> {
        let squares = self.vector()?;
        self.comma()?;
        let products = self.vector()?;
        self.comma()?;
        let linear = self.vector()?;
        self.comma()?;
        let constant = self.float()?;
        Ok(from_shape(Quadric::new(squares, products, linear, constant)))
    }

    pub(super) fn cubic(&mut self, _keyword: Token) -> Result<Object> {
        self.coefficients(3)
    }

    pub(super) fn quartic(&mut self, _keyword: Token) -> Result<Object> {
        self.coefficients(4)
    }

    pub(super) fn poly(&mut self, _keyword: Token) -> Result<Object> {
        let order = self.order()?;
        self.comma()?;
        self.coefficients(order)
    }

    /// `order, xyz(i, j, k): coefficient, …`; terms that are not named are 0.
    pub(super) fn polynomial(&mut self, _keyword: Token) -> Result<Object> {
        let order = self.order()?;
        let mut coefficients = vec![0.0; Algebraic::count(order)];
        self.comma()?;
        while self.peek()?.tok == crate::syntax::Tok::Word(Keyword::Xyz) {
            let place = self.next()?.span;
            self.expect_punct(Punct::LeftParen)?;
            let mut powers = [0usize; 3];
            for power in &mut powers {
                self.comma()?;
                *power = self.count(0.0, order as f64, "a power of this polynomial", "")?;
            }
            self.expect_punct(Punct::RightParen)?;
            self.expect_punct(Punct::Colon)?;
            let [i, j, k] = powers;
            if i + j + k > order {
                let message = format!("the powers add up to more than the order, {order}");
                return Err(Box::new(Diagnostic::error(place, message)));
            }
            coefficients[Algebraic::position(order, i, j, k)] = self.float()?;
            self.comma()?;
        }
        self.algebraic(order, coefficients)
    }

    fn order(&mut self) -> Result<usize> {
        self.count(2.0, Algebraic::MAX_ORDER as f64, "the order of a polynomial", "")
    }

    /// All coefficients of a polynomial between angle brackets.
    fn coefficients(&mut self, order: usize) -> Result<Object> {
        let count = Algebraic::count(order);
        let mut list = Vec::with_capacity(count);
        self.expect_punct(Punct::Less)?;
        for _ in 0..count {
            self.comma()?;
            list.push(self.float()?);
        }
        self.expect_punct(Punct::Greater)?;
        self.algebraic(order, list)
    }

    fn algebraic(&mut self, order: usize, coefficients: Vec<f64>) -> Result<Object> {
        match Algebraic::new(order, coefficients) {
            Some(surface) => Ok(from_shape(surface)),
            None => Err(self.unexpected("as many coefficients as the order asks for")),
        }
    }
}
