//! Questions about objects that are answered while the scene is read.

use super::{Parser, Result, Value};
use crate::math::noise::Turbulence;
use crate::math::{Ray, Vec3};
use crate::scene::{Body, Object};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Punct};
use crate::world::ObjectQuery;
use std::sync::Arc;

/// Objects lately asked about, prepared; the latest last.
#[derive(Default)]
pub(super) struct Queries {
    prepared: Vec<(Arc<Object>, Arc<ObjectQuery>)>,
}

/// How many objects stay prepared.
const KEPT: usize = 16;

/// Coordinates of the corners of infinite objects.
const FAR: f64 = 1e10;

impl Queries {
    fn prepare(&mut self, object: &Arc<Object>) -> Arc<ObjectQuery> {
        if let Some(at) = self.prepared.iter().rposition(|(known, _)| Arc::ptr_eq(known, object)) {
            let entry = self.prepared.remove(at);
            self.prepared.push(entry);
        } else {
            if self.prepared.len() == KEPT {
                self.prepared.remove(0);
            }
            self.prepared.push((object.clone(), Arc::new(ObjectQuery::new(object))));
        }
        self.prepared[self.prepared.len() - 1].1.clone()
    }
}

impl Parser {
    /// `(object)` or `(object, …)`: `read` reads what follows the object's comma.
    fn about_object<T>(
        &mut self,
        read: impl FnOnce(&mut Self, Arc<Object>, Arc<ObjectQuery>) -> Result<T>,
    ) -> Result<T> {
        self.in_parens(|p| {
            let object = match p.peek_value()? {
                Some(Value::Object(object)) => {
                    p.take_value()?;
                    object
                }
                _ => {
                    let span = p.peek()?.span;
                    let Some(object) = p.object()? else { return Err(p.unexpected("an object")) };
                    let message = "an object stands here in place of the name of one";
                    p.lenient(Diagnostic::warning(span, message))?;
                    Arc::new(object)
                }
            };
            p.comma()?;
            let query = p.queries.prepare(&object);
            read(p, object, query)
        })
    }

    /// `min_extent(object)` and `max_extent(object)`, in single precision.
    pub(super) fn extent(&mut self, word: Keyword) -> Result<Vec3> {
        let bounds = self.about_object(|_, _, query| Ok(query.bounds()))?;
        let corner = match (word, bounds.is_finite()) {
            (Keyword::MinExtent, true) => bounds.min,
            (Keyword::MinExtent, false) => Vec3::splat(-FAR),
            (_, true) => bounds.max,
            (_, false) => Vec3::splat(FAR),
        };
        // What rounding leaves of a sum that is 0 is taken for 0.
        let size = (bounds.max - bounds.min).min(Vec3::splat(1.0)) * f64::from(f32::EPSILON);
        let clean = |v: f64, small: f64| if v.abs() < small { 0.0 } else { f64::from(v as f32) };
        Ok(Vec3::new(clean(corner.x, size.x), clean(corner.y, size.y), clean(corner.z, size.z)))
    }

    /// `trace(object, origin, direction [, normal])`: the nearest point hit, and its normal in a variable.
    pub(super) fn trace_query(&mut self) -> Result<Vec3> {
        self.about_object(|p, _, query| {
            let origin = p.vector()?;
            p.comma()?;
            let direction = p.vector()?;
            p.comma()?;
            let hit = match direction.try_normalize() {
                Some(dir) => query.trace(&Ray::new(origin, dir)),
                None => None,
            };
            let (point, normal) = hit.unwrap_or((Vec3::ZERO, Vec3::ZERO));
            if p.peek()?.tok != crate::syntax::Tok::Punct(Punct::RightParen) {
                p.assign_normal(normal)?;
            }
            Ok(point)
        })
    }

    /// The vector variable that comes next takes the normal.
    fn assign_normal(&mut self, normal: Vec3) -> Result<()> {
        let target = self.assignment_target()?;
        if !matches!(self.target_value(&target), Some(Value::Vector(..))) {
            let message = "expected a vector variable, which takes the normal";
            return Err(Box::new(Diagnostic::error(self.last, message)));
        }
        self.declare_target(target, Value::Vector(3, [normal.x, normal.y, normal.z, 0.0, 0.0]))
    }

    /// `inside(object, point)`.
    pub(super) fn inside_query(&mut self, span: Span) -> Result<f64> {
        let inside = self.about_object(|p, object, query| {
            if !is_solid(&object) {
                let message = "this object has no inside";
                return Err(Box::new(Diagnostic::error(span.to(p.last), message)));
            }
            Ok(query.contains(p.vector()?))
        })?;
        Ok(f64::from(u8::from(inside)))
    }

    /// `vturbulence(lambda, omega, octaves, point)`.
    pub(super) fn turbulence(&mut self) -> Result<Vec3> {
        self.in_parens(|p| {
            // Both are kept in single precision.
            let lambda = f64::from(p.float()? as f32);
            p.comma()?;
            let omega = f64::from(p.float()? as f32);
            p.comma()?;
            let octaves = p.float()?.clamp(1.0, 10.0) as u32;
            p.comma()?;
            let point = p.vector()?;
            Ok(Turbulence { octaves, omega, lambda, ..Default::default() }.vector(point))
        })
    }
}

fn is_solid(object: &Object) -> bool {
    match &object.body {
        Body::Shape(shape) => shape.is_solid(),
        Body::Csg { .. } => true,
        Body::Light(_) => false,
    }
}
