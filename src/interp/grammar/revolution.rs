//! Shapes from plane curves: `prism`, `lathe`, `sor`.

use super::object::from_shape;
use crate::interp::{Parser, Result};
use crate::math::Vec2;
use crate::scene::Object;
use crate::shape::{CurveKind, Lathe, Prism, Sor, SorError, Sweep, closed_curves, open_curve};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Tok, Token};

/// More points than any curve has; a larger number is a slip of the pen.
const MAX_POINTS: f64 = 1e7;

impl Parser {
    pub(super) fn prism(&mut self, keyword: Token) -> Result<Object> {
        let (mut kind, mut sweep) = (CurveKind::Linear, Sweep::Linear);
        loop {
            if let Some(chosen) = self.curve_kind()? {
                kind = chosen;
            } else if self.accept(Keyword::LinearSweep)? {
                sweep = Sweep::Linear;
            } else if self.accept(Keyword::ConicSweep)? {
                sweep = Sweep::Conic;
            } else {
                break;
            }
        }
        let low = self.float()?;
        self.comma()?;
        let high = self.float()?;
        self.comma()?;
        let points = self.curve_points(kind, kind.fewest_closed(), "prism")?;
        let open = self.accept(Keyword::Open)?;
        let Some((pieces, left_open)) = closed_curves(kind, &points) else {
            if kind != CurveKind::Bezier {
                let message = "the prism's outline is not closed: its second point must come again";
                return Err(Box::new(Diagnostic::error(keyword.span, message)));
            }
            return Ok(self.degenerate(keyword.span, "prism", "its outline is not closed"));
        };
        if left_open {
            let message = "the prism's outline is not closed: its first point is added at the end";
            self.warn(Diagnostic::warning(keyword.span, message));
        }
        Ok(from_shape(Prism::new(pieces, [low, high], sweep, open)))
    }

    pub(super) fn lathe(&mut self, _keyword: Token) -> Result<Object> {
        let kind = self.curve_kind()?.unwrap_or(CurveKind::Linear);
        let start = self.peek()?.span;
        let points = self.curve_points(kind, kind.fewest_open(), "lathe")?;
        let inner = points.get(1..points.len() - 1).unwrap_or(&[]);
        if inner.iter().any(|p| p.x < 0.0) {
            let message = "a point of the profile has a negative radius";
            return Err(Box::new(Diagnostic::error(start, message)));
        }
        Ok(from_shape(Lathe::new(open_curve(kind, &points))))
    }

    pub(super) fn sor(&mut self, keyword: Token) -> Result<Object> {
        let start = self.peek()?.span;
        let points = self.curve_points(CurveKind::Linear, 4, "sor")?;
        let open = self.accept(Keyword::Open)?;
        match Sor::new(&points, open) {
            Ok(sor) => Ok(from_shape(sor)),
            Err(SorError::NegativeRadius) => {
                Err(Box::new(Diagnostic::error(start, "a point of the profile has a negative radius")))
            }
            Err(SorError::HeightsNotRising) => Err(Box::new(Diagnostic::error(
                start,
                "the heights must rise from the second point to the last but one",
            ))),
            Err(SorError::NoSlope) => {
                let why = "a point's two neighbours are at one height, so its slope is not defined";
                Ok(self.degenerate(keyword.span, "sor", why))
            }
        }
    }

    fn curve_kind(&mut self) -> Result<Option<CurveKind>> {
        let kind = match self.peek()?.tok {
            Tok::Word(Keyword::LinearSpline) => CurveKind::Linear,
            Tok::Word(Keyword::QuadraticSpline) => CurveKind::Quadratic,
            Tok::Word(Keyword::CubicSpline) => CurveKind::Cubic,
            Tok::Word(Keyword::BezierSpline) => CurveKind::Bezier,
            _ => return Ok(None),
        };
        self.next()?;
        Ok(Some(kind))
    }

    /// A number of points, and the points.
    fn curve_points(&mut self, kind: CurveKind, fewest: usize, object: &str) -> Result<Vec<Vec2>> {
        let span = self.peek()?.span;
        let count = self.count(fewest as f64, MAX_POINTS, &format!("such a {object}"), "points")?;
        if kind == CurveKind::Bezier && count % 4 != 0 {
            return Err(not_fours(span));
        }
        let mut points = Vec::with_capacity(count.min(1 << 16));
        for _ in 0..count {
            self.comma()?;
            points.push(self.vector2()?);
        }
        Ok(points)
    }
}

fn not_fours(span: Span) -> Box<Diagnostic> {
    Box::new(Diagnostic::error(span, "a bezier_spline has four points for each piece"))
}
