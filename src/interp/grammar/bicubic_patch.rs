//! `bicubic_patch { type t settings 16 points }`.

use super::object::from_shape;
use crate::interp::{Parser, Result};
use crate::math::{Vec2, Vec3};
use crate::scene::Object;
use crate::shape::{BicubicPatch, PatchDetail};
use crate::source::Diagnostic;
use crate::syntax::{Keyword, Token};

/// A patch halved more often than this has pieces smaller than rounding.
const MAX_STEPS: f64 = 48.0;

impl Parser {
    pub(super) fn bicubic_patch(&mut self, keyword: Token) -> Result<Object> {
        let mut kind = None;
        let mut detail = PatchDetail { u_steps: 0, v_steps: 0, flatness: 0.0 };
        let mut uv_vectors = [Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y];
        loop {
            if self.accept(Keyword::Type)? {
                kind = Some(self.float()?);
            } else if self.accept(Keyword::Flatness)? {
                detail.flatness = self.float()?;
            } else if self.accept(Keyword::USteps)? {
                detail.u_steps = self.float()?.clamp(0.0, MAX_STEPS) as u32;
            } else if self.accept(Keyword::VSteps)? {
                detail.v_steps = self.float()?.clamp(0.0, MAX_STEPS) as u32;
            } else if self.accept(Keyword::UvVectors)? {
                for (i, corner) in uv_vectors.iter_mut().enumerate() {
                    if i > 0 {
                        self.comma()?;
                    }
                    *corner = self.vector2()?;
                }
            } else {
                break;
            }
            self.comma()?;
        }
        match kind {
            None => {
                let message = "the patch needs a `type`, 0 or 1";
                return Err(Box::new(Diagnostic::error(keyword.span, message)));
            }
            Some(kind) if kind >= 2.0 => {
                let message = "this type of patch is no longer supported: type 1 is taken";
                self.warn(Diagnostic::warning(keyword.span, message));
            }
            Some(kind) => self.demand(kind.trunc() >= 0.0, keyword.span, "a patch is of type 0 or 1")?,
        }
        let mut controls = [[Vec3::ZERO; 4]; 4];
        for (i, point) in controls.iter_mut().flatten().enumerate() {
            if i > 0 {
                self.comma()?;
            }
            *point = self.vector()?;
        }
        match BicubicPatch::new(controls, detail, uv_vectors) {
            Some(patch) => Ok(from_shape(patch)),
            None => {
                let message = "the patch would be cut into too many pieces";
                let hint = "give a larger `flatness`, or fewer `u_steps` and `v_steps`";
                Err(Box::new(Diagnostic::error(keyword.span, message).with_hint(hint)))
            }
        }
    }
}
