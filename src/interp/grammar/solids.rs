//! Parameters of solids beyond the simplest: `superellipsoid`, `ovus`, `sphere_sweep`.

use super::object::from_shape;
use crate::interp::{Parser, Result};
use crate::scene::Object;
use crate::shape::{Ovus, SphereSweep, Superellipsoid, SweepKind};
use crate::source::Diagnostic;
use crate::syntax::{Keyword, Tok, Token};

/// More spheres than any sweep has; a larger number is a slip of the pen.
const MAX_SPHERES: f64 = 1e7;

impl Parser {
    pub(super) fn superellipsoid(&mut self, keyword: Token) -> Result<Object> {
        /// The exponent that stands for those that are not above 0.
        const LEAST: f64 = 1e-3;
        let e = self.vector2()?;
        if e.x <= 0.0 || e.y <= 0.0 {
            let text = "a superellipsoid's exponents are above 0: this is read as 0.001";
            self.warn(Diagnostic::warning(keyword.span, text));
        }
        let [x, y] = [e.x, e.y].map(|e| if e <= 0.0 { LEAST } else { e });
        match Superellipsoid::new(x, y) {
            Some(shape) => Ok(from_shape(shape)),
            None => {
                let why = "its two exponents must be positive numbers";
                Ok(self.degenerate(keyword.span, "superellipsoid", why))
            }
        }
    }

    pub(super) fn ovus(&mut self, keyword: Token) -> Result<Object> {
        let bottom = self.float()?;
        self.comma()?;
        let top = self.float()?;
        if bottom < 0.0 || top < 0.0 {
            return Err(Box::new(Diagnostic::error(keyword.span, "the ovus' radii must not be negative")));
        }
        if top >= 2.0 * bottom {
            let message = "the top radius is twice the bottom radius or more: the ovus is a sphere";
            self.warn(Diagnostic::warning(keyword.span, message));
        }
        Ok(from_shape(Ovus::new(bottom, top)))
    }

    pub(super) fn sphere_sweep(&mut self, _keyword: Token) -> Result<Object> {
        let kind = match self.peek()?.tok {
            Tok::Word(Keyword::LinearSpline) => SweepKind::Linear,
            Tok::Word(Keyword::CubicSpline) => SweepKind::Cubic,
            Tok::Word(Keyword::BSpline) => SweepKind::BSpline,
            _ => return Err(self.unexpected("`linear_spline`, `cubic_spline` or `b_spline`")),
        };
        self.next()?;
        self.comma()?;
        let count = self.count(kind.fewest() as f64, MAX_SPHERES, "such a sphere_sweep", "spheres")?;
        let mut spheres = Vec::with_capacity(count.min(1 << 16));
        for _ in 0..count {
            self.comma()?;
            let center = self.vector()?;
            self.comma()?;
            spheres.push((center, self.float()?));
        }
        if self.accept(Keyword::Tolerance)? {
            // The least distance of a hit. Hits are told apart without one.
            self.float()?;
        }
        Ok(from_shape(SphereSweep::new(kind, &spheres)))
    }
}
