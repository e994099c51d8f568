//! Parameters of the simple shapes.

use super::object::from_shape;
use crate::interp::{Parser, Result};
use crate::math::Vec3;
use crate::scene::Object;
use crate::shape::is_closed_polygon;
use crate::shape::{Cone, Cuboid, Cylinder, Disc, Plane, Polygon, SmoothTriangle, Sphere, Torus, Triangle};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Token};

/// More points than any polygon has; a larger number is a slip of the pen.
const MAX_POINTS: f64 = 1e8;

impl Parser {
    /// A vector after the comma that may stand before it.
    fn next_vector(&mut self) -> Result<Vec3> {
        self.comma()?;
        self.vector()
    }

    fn next_float(&mut self) -> Result<f64> {
        self.comma()?;
        self.float()
    }

    pub(super) fn sphere(&mut self, _keyword: Token) -> Result<Object> {
        let center = self.vector()?;
        let radius = self.next_float()?;
        Ok(from_shape(Sphere::new(center, radius)))
    }

    pub(super) fn cuboid(&mut self, _keyword: Token) -> Result<Object> {
        let a = self.vector()?;
        let b = self.next_vector()?;
        Ok(from_shape(Cuboid::new(a, b)))
    }

    pub(super) fn plane(&mut self, keyword: Token) -> Result<Object> {
        let normal = self.vector()?;
        let distance = self.next_float()?;
        match Plane::new(normal, distance) {
            Some(plane) => Ok(from_shape(plane)),
            None => Err(Box::new(Diagnostic::error(keyword.span, "the plane's normal has no direction"))),
        }
    }

    pub(super) fn cylinder(&mut self, keyword: Token) -> Result<Object> {
        let base = self.vector()?;
        let cap = self.next_vector()?;
        let radius = self.next_float()?;
        let open = self.accept(Keyword::Open)?;
        self.check_ends([base, cap], keyword.span)?;
        match Cylinder::new(base, cap, radius, open) {
            Some(cylinder) => Ok(from_shape(cylinder)),
            None => Ok(self.degenerate(keyword.span, "cylinder", "its two ends are one point")),
        }
    }

    pub(super) fn cone(&mut self, keyword: Token) -> Result<Object> {
        let base = self.vector()?;
        let base_radius = self.next_float()?;
        let cap = self.next_vector()?;
        let cap_radius = self.next_float()?;
        let open = self.accept(Keyword::Open)?;
        self.check_ends([base, cap], keyword.span)?;
        match Cone::new(base, base_radius, cap, cap_radius, open) {
            Some(cone) => Ok(from_shape(cone)),
            None => Ok(self.degenerate(keyword.span, "cone", "its two ends are one point")),
        }
    }

    /// Ends closer to each other than this are one point to the reference, however small the scene.
    fn check_ends(&mut self, ends: [Vec3; 2], span: Span) -> Result<()> {
        const NEAREST: f64 = 1e-10;
        if self.options.strict && ends[0].distance(ends[1]) < NEAREST {
            self.lenient(Diagnostic::warning(span, "the two ends are one point"))?;
        }
        Ok(())
    }

    pub(super) fn torus(&mut self, _keyword: Token) -> Result<Object> {
        let major = self.float()?;
        let minor = self.next_float()?;
        Ok(from_shape(Torus::new(major, minor)))
    }

    pub(super) fn disc(&mut self, keyword: Token) -> Result<Object> {
        let center = self.vector()?;
        let normal = self.next_vector()?;
        let radius = self.next_float()?;
        self.comma()?;
        let hole = if self.at_expression()? { self.float()? } else { 0.0 };
        match Disc::new(center, normal, radius, hole) {
            Some(disc) => Ok(from_shape(disc)),
            None => Ok(self.degenerate(keyword.span, "disc", "its normal has no direction")),
        }
    }

    pub(super) fn triangle(&mut self, keyword: Token) -> Result<Object> {
        let a = self.vector()?;
        let b = self.next_vector()?;
        let c = self.next_vector()?;
        match Triangle::new(a, b, c) {
            Some(triangle) => Ok(from_shape(triangle)),
            None => Ok(self.degenerate(keyword.span, "triangle", "its corners lie on one line")),
        }
    }

    pub(super) fn smooth_triangle(&mut self, keyword: Token) -> Result<Object> {
        let (a, na) = (self.vector()?, self.next_vector()?);
        let (b, nb) = (self.next_vector()?, self.next_vector()?);
        let (c, nc) = (self.next_vector()?, self.next_vector()?);
        match SmoothTriangle::new([a, b, c], [na, nb, nc]) {
            Some(triangle) => Ok(from_shape(triangle)),
            None => {
                let why = "its corners lie on one line, or its normals are not all on one side of it";
                Ok(self.degenerate(keyword.span, "smooth_triangle", why))
            }
        }
    }

    pub(super) fn polygon(&mut self, keyword: Token) -> Result<Object> {
        let count = self.count(3.0, MAX_POINTS, "a polygon", "points")?;
        let mut points = Vec::with_capacity(count.min(1 << 16));
        for _ in 0..count {
            points.push(self.next_vector()?);
        }
        if !is_closed_polygon(&points) {
            let message = "the polygon is not closed: its first point is added at the end";
            self.warn(Diagnostic::warning(keyword.span, message));
        }
        match Polygon::new(&points) {
            Some(polygon) => Ok(from_shape(polygon)),
            None => {
                let why = "its points do not lie in one plane, or lie on one line";
                Ok(self.degenerate(keyword.span, "polygon", why))
            }
        }
    }

    /// A whole number from `min` to `max` of what an object needs.
    pub(super) fn count(&mut self, min: f64, max: f64, object: &str, things: &str) -> Result<usize> {
        let span = self.peek()?.span;
        let n = self.float()?.trunc();
        if n >= min && n <= max {
            return Ok(n as usize);
        }
        let message = if n < min || n.is_nan() {
            format!("{object} needs at least {min} {things}")
        } else {
            format!("{object} cannot have more than {max} {things}")
        };
        Err(Box::new(Diagnostic::error(span, message)))
    }
}
