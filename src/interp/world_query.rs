//! Questions about objects that are answered while the scene is read.

use super::{Parser, Result};
use crate::math::Vec3;
use crate::source::Span;
use crate::syntax::Keyword;

impl Parser {
    /// `min_extent(object)` and `max_extent(object)`.
    pub(super) fn extent(&mut self, _word: Keyword, span: Span) -> Result<Vec3> {
        self.unsupported(span, "extents");
        Ok(Vec3::ZERO)
    }

    /// `trace(object, origin, direction [, normal])`.
    pub(super) fn trace_query(&mut self, span: Span) -> Result<Vec3> {
        self.unsupported(span, "trace()");
        Ok(Vec3::ZERO)
    }

    /// `inside(object, point)`.
    pub(super) fn inside_query(&mut self, span: Span) -> Result<f64> {
        self.unsupported(span, "inside()");
        Ok(0.0)
    }

    /// `vturbulence(lambda, omega, octaves, point)`.
    pub(super) fn turbulence(&mut self, _span: Span) -> Result<Vec3> {
        self.in_parens(|p| {
            // Both are kept in single precision.
            let lambda = f64::from(p.float()? as f32);
            p.comma()?;
            let omega = f64::from(p.float()? as f32);
            p.comma()?;
            let octaves = p.float()?.clamp(1.0, 10.0) as u32;
            p.comma()?;
            let point = p.vector()?;
            Ok(crate::math::noise::Turbulence { octaves, omega, lambda, ..Default::default() }.vector(point))
        })
    }
}
