//! `camera`.
//!
//! From version 3.5 on items are collected and worked out at the end, whatever their order; before, each
//! acts at once on one camera that all statements share.

use crate::camera::{Camera, CameraKind, Distribution, MeshCamera};
use crate::interp::vocabulary as items;
use crate::interp::{Parser, Result, Value};
use crate::math::{Transform, Vec3};
use crate::scene::Body;
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Punct, Tok};
use std::sync::Arc;

/// Lengths below count as none.
const TINY: f64 = 1e-10;

/// Items of a statement that are worked out at its end.
#[derive(Default)]
struct Items {
    angle: Option<(f64, Span)>,
    look_at: Option<(Vec3, Span)>,
    focal_point: Option<Vec3>,
    has_right_or_up: bool,
    /// An angle or `look_at` has acted.
    turned: bool,
    transform: Transform,
}

/// What a place on a lens comes to.
const LENS_BYTES: u64 = 64;

impl Parser {
    /// `camera { … }`; the word is the next token.
    pub(crate) fn camera_statement(&mut self) -> Result<Camera> {
        self.expect(Keyword::Camera)?;
        self.expect_punct(Punct::LeftBrace)?;
        if self.syntax_version() < 350 {
            return self.old_camera();
        }
        if let Some(Value::Camera(camera)) = self.peek_value()? {
            self.take_value()?;
            return self.copied_camera((*camera).clone());
        }
        let mut camera = self.scene.default_camera.clone();
        let mut items = Items::default();
        self.camera_kind(&mut camera)?;
        while !self.accept_punct(Punct::RightBrace)? {
            self.camera_item(&mut camera, &mut items)?;
        }
        self.finish_camera(&mut camera, &items)?;
        Ok(camera)
    }

    /// Behind an identifier only transformations may stand.
    fn copied_camera(&mut self, mut camera: Camera) -> Result<Camera> {
        while let Some(t) = self.transformation()? {
            camera.apply(&t);
        }
        if !self.accept_punct(Punct::RightBrace)? {
            return Err(self.unexpected("a transformation or `}`: a camera identifier can only be moved"));
        }
        Ok(camera)
    }

    /// The type keyword; false if none comes.
    fn camera_kind(&mut self, camera: &mut Camera) -> Result<bool> {
        let token = self.peek()?;
        let Tok::Word(word) = token.tok else { return Ok(false) };
        camera.kind = match word {
            Keyword::Perspective => CameraKind::Perspective,
            Keyword::Orthographic => CameraKind::Orthographic,
            Keyword::Fisheye => CameraKind::Fisheye,
            Keyword::UltraWideAngle => CameraKind::UltraWideAngle,
            Keyword::Omnimax => CameraKind::Omnimax,
            Keyword::Panoramic => CameraKind::Panoramic,
            Keyword::Spherical => {
                camera.angle = 360f64.to_radians();
                camera.vertical_angle = 180f64.to_radians();
                CameraKind::Spherical
            }
            Keyword::Cylinder => {
                self.next()?;
                camera.kind = CameraKind::Cylinder(self.cylinder_number()?);
                return Ok(true);
            }
            Keyword::MeshCamera => {
                self.next()?;
                camera.kind = CameraKind::Mesh(Arc::new(self.mesh_camera()?));
                return Ok(true);
            }
            _ => return Ok(false),
        };
        self.next()?;
        Ok(true)
    }

    fn cylinder_number(&mut self) -> Result<u8> {
        let token = self.peek()?;
        let number = self.float()?;
        if (1.0..5.0).contains(&number) {
            return Ok(number as u8);
        }
        Err(Box::new(Diagnostic::error(token.span, "there are cylinder cameras 1 to 4")))
    }

    /// `{ rays per pixel, distribution [, max_distance] mesh … [smooth] }`.
    fn mesh_camera(&mut self) -> Result<MeshCamera> {
        self.expect_punct(Punct::LeftBrace)?;
        let rays_at = self.peek()?.span;
        let rays = self.float()?.max(0.0) as usize;
        self.comma()?;
        let distribution = self.mesh_distribution()?;
        self.comma()?;
        let mut camera = MeshCamera::new(distribution, rays);
        if !matches!(self.peek()?.tok, Tok::Word(Keyword::Mesh | Keyword::Mesh2)) {
            let reach = self.float()?;
            self.comma()?;
            camera.max_distance = if reach > 0.0 { reach } else { f64::INFINITY };
        }
        self.camera_meshes(&mut camera)?;
        let smooth = self.peek()?.span;
        if self.accept(Keyword::Smooth)? {
            let Distribution::Uv { smooth } = &mut camera.distribution else {
                return Err(Box::new(Diagnostic::error(smooth, "`smooth` goes with distribution 3 alone")));
            };
            *smooth = true;
        }
        self.expect_punct(Punct::RightBrace)?;
        let most = match camera.distribution {
            Distribution::Parallel => camera.mesh_count(),
            Distribution::Serial => usize::MAX,
            Distribution::Strips | Distribution::Uv { .. } => 1,
        };
        if rays == 0 || rays > most {
            let text = format!("this mesh camera has between 1 and {most} rays per pixel");
            return Err(Box::new(Diagnostic::error(rays_at, text)));
        }
        Ok(camera)
    }

    fn mesh_distribution(&mut self) -> Result<Distribution> {
        let token = self.peek()?;
        Ok(match self.float()? as i64 {
            0 => Distribution::Parallel,
            1 => Distribution::Serial,
            2 => Distribution::Strips,
            3 => Distribution::Uv { smooth: false },
            _ => {
                let text = "mesh cameras have distributions 0 to 3";
                return Err(Box::new(Diagnostic::error(token.span, text)));
            }
        })
    }

    /// One `mesh` or `mesh2` at least.
    fn camera_meshes(&mut self, camera: &mut MeshCamera) -> Result<()> {
        while matches!(self.peek()?.tok, Tok::Word(Keyword::Mesh | Keyword::Mesh2)) {
            let object = self.required_object()?;
            if let Body::Shape(shape) = &object.body
                && let Some(mesh) = shape.as_mesh()
            {
                camera.add(mesh, object.transform);
            }
        }
        if camera.mesh_count() == 0 {
            return Err(self.unexpected("`mesh` or `mesh2`"));
        }
        Ok(())
    }

    fn camera_item(&mut self, camera: &mut Camera, items: &mut Items) -> Result<()> {
        if let Some(t) = self.transformation()? {
            items.transform = items.transform.then(&t);
            return Ok(());
        }
        let token = self.peek()?;
        let Tok::Word(word) = token.tok else { return Err(self.unexpected_item(&items::CAMERA)) };
        if self.blur_item(camera, word)? {
            return Ok(());
        }
        match word {
            Keyword::Location | Keyword::Sky | Keyword::Direction | Keyword::Right | Keyword::Up => {
                self.next()?;
                let v = self.vector()?;
                items.has_right_or_up |= matches!(word, Keyword::Right | Keyword::Up);
                *camera_vector(camera, word) = v;
            }
            Keyword::LookAt => {
                self.next()?;
                items.look_at = Some((self.vector()?, token.span));
            }
            Keyword::FocalPoint => {
                self.next()?;
                items.focal_point = Some(self.vector()?);
            }
            Keyword::Angle => {
                self.next()?;
                self.camera_angle(camera, items, token.span)?;
            }
            Keyword::Normal => camera.normal = Some(self.normal_statement()?),
            _ => return Err(self.unexpected("a camera item or `}`: a camera's type must come first")),
        }
        Ok(())
    }

    /// An angle in degrees; two for a spherical camera.
    fn camera_angle(&mut self, camera: &mut Camera, items: &mut Items, span: Span) -> Result<()> {
        let angle = self.float()?;
        let curved = !is_straight(&camera.kind);
        self.demand(!curved || angle >= 0.0, span, "this camera's angle must not be negative")?;
        if matches!(camera.kind, CameraKind::Spherical) {
            let height = if self.accept_punct(Punct::Comma)? || self.at_expression()? {
                self.float()?
            } else {
                0.5 * angle
            };
            self.demand(height >= 0.0, span, "this camera's angle must not be negative")?;
            camera.vertical_angle = height.to_radians();
        }
        if curved {
            camera.angle = angle.to_radians();
        } else {
            items.angle = Some((angle, span));
        }
        Ok(())
    }

    /// Depth of field; the word is the next token. False for other words.
    fn blur_item(&mut self, camera: &mut Camera, word: Keyword) -> Result<bool> {
        let blur = &mut camera.blur;
        match word {
            Keyword::Aperture => {
                self.next()?;
                blur.aperture = self.float()?;
            }
            Keyword::BlurSamples => {
                self.next()?;
                let first = self.float()?.max(0.0) as u32;
                let two = self.accept_punct(Punct::Comma)? || self.at_expression()?;
                (blur.min_samples, blur.max_samples) =
                    if two { (first, self.float()?.max(0.0) as u32) } else { (0, first) };
                let (least, most) = (blur.min_samples, blur.max_samples);
                self.demand(most > 0, self.last_span(), "focal blur needs samples")?;
                let text = "focal blur has fewer samples at most than at least";
                self.demand(least <= most, self.last_span(), text)?;
                self.reserve(LENS_BYTES * u64::from(most), self.last_span())?;
            }
            Keyword::Confidence => {
                self.next()?;
                let inside = |v: f64| v > 0.0 && v < 1.0;
                blur.confidence = self.within("confidence", 0.9, inside)?;
            }
            Keyword::Variance => {
                self.next()?;
                blur.variance = self.within("variance", 1e-4, |v| (0.0..=1.0).contains(&v))?;
            }
            Keyword::Bokeh => {
                self.next()?;
                self.expect_punct(Punct::LeftBrace)?;
                blur.bokeh = Some(self.pigment_statement()?);
                self.expect_punct(Punct::RightBrace)?;
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// A number, or a default with a warning where it lies outside of its range.
    fn within(&mut self, name: &str, default: f64, inside: impl Fn(f64) -> bool) -> Result<f64> {
        let token = self.peek()?;
        let value = self.float()?;
        if inside(value) {
            return Ok(value);
        }
        let text = format!("`{name}` lies outside of 0 to 1: {default} is taken");
        self.warn(Diagnostic::warning(token.span, text));
        Ok(default)
    }

    /// The collected items in their fixed order.
    fn finish_camera(&mut self, camera: &mut Camera, items: &Items) -> Result<()> {
        if let Some((angle, span)) = items.angle {
            set_angle(camera, angle, span)?;
        }
        let length = camera.direction.length();
        if let Some((target, span)) = items.look_at {
            self.look_at(camera, target, span)?;
        }
        let scaled = !items.has_right_or_up || items.angle.is_some();
        if matches!(camera.kind, CameraKind::Orthographic) && scaled {
            fit_orthographic(camera);
        }
        set_focus(camera, items, length);
        camera.apply(&items.transform);
        if matches!(camera.kind, CameraKind::Mesh(_)) && camera.blur.is_on() {
            let text = "a mesh camera has no lens: its focal blur is left out";
            let token = self.peek()?;
            self.warn(Diagnostic::warning(token.span, text));
            camera.blur.aperture = 0.0;
        }
        Ok(())
    }

    /// Turns the camera towards `target`, keeping the lengths of its vectors and its handedness.
    fn look_at(&mut self, camera: &mut Camera, target: Vec3, span: Span) -> Result<()> {
        let mirrored = camera.up.cross(camera.direction).dot(camera.right) <= 0.0;
        let Some(ahead) = (target - camera.location).try_normalize() else {
            let text = "the camera looks at its own location";
            return Err(Box::new(Diagnostic::error(span, text)));
        };
        let mut right = camera.sky.cross(ahead);
        if right.abs().max_element() <= TINY * camera.sky.length() {
            let text = "the camera looks along its `sky` vector: its old right vector is kept";
            self.warn(Diagnostic::warning(span, text));
            right = camera.right;
        }
        let right = right.normalize();
        camera.up = ahead.cross(right) * camera.up.length();
        camera.right = right * if mirrored { -camera.right.length() } else { camera.right.length() };
        camera.direction = ahead * camera.direction.length();
        camera.look_at = target;
        Ok(())
    }

    /// Before version 3.5: the camera so far, changed item by item.
    fn old_camera(&mut self) -> Result<Camera> {
        let mut camera = self.scene.scene.camera.clone();
        if let Some(Value::Camera(copy)) = self.peek_value()? {
            self.take_value()?;
            camera = (*copy).clone();
        }
        let mut items = Items::default();
        while !self.accept_punct(Punct::RightBrace)? {
            self.old_camera_item(&mut camera, &mut items)?;
        }
        let length = camera.direction.length();
        set_focus(&mut camera, &items, length);
        Ok(camera)
    }

    fn old_camera_item(&mut self, camera: &mut Camera, items: &mut Items) -> Result<()> {
        let token = self.peek()?;
        if matches!(token.tok, Tok::Word(Keyword::Spherical | Keyword::MeshCamera)) {
            return Err(self.unexpected("a camera item that version 3.1 has"));
        }
        if self.camera_kind(camera)? {
            if matches!(camera.kind, CameraKind::Orthographic) {
                fit_orthographic(camera);
            }
            return Ok(());
        }
        self.camera_item(camera, items)?;
        items.turned |= items.look_at.is_some() || items.angle.is_some();
        if let Some((target, span)) = items.look_at.take() {
            self.look_at(camera, target, span)?;
        }
        if let Some((angle, span)) = items.angle.take()
            && matches!(camera.kind, CameraKind::Perspective)
        {
            set_angle(camera, angle, span)?;
        }
        camera.apply(&std::mem::take(&mut items.transform));
        Ok(())
    }
}

fn is_straight(kind: &CameraKind) -> bool {
    matches!(kind, CameraKind::Perspective | CameraKind::Orthographic)
}

fn camera_vector(camera: &mut Camera, word: Keyword) -> &mut Vec3 {
    match word {
        Keyword::Location => &mut camera.location,
        Keyword::Sky => &mut camera.sky,
        Keyword::Direction => &mut camera.direction,
        Keyword::Right => &mut camera.right,
        _ => &mut camera.up,
    }
}

/// `angle` of straight views: the direction's length follows from the width. 0 means none.
fn set_angle(camera: &mut Camera, degrees: f64, span: Span) -> Result<()> {
    if degrees == 0.0 {
        return Ok(());
    }
    if !(0.0..180.0).contains(&degrees) {
        let text = "this camera's angle must lie between 0 and 180 degrees";
        return Err(Box::new(Diagnostic::error(span, text)));
    }
    let half = 0.5 * degrees.to_radians();
    let length = 0.5 * camera.right.length() / half.tan();
    camera.direction = camera.direction.normalize() * length;
    Ok(())
}

/// Makes the picture as large as a perspective one at the point looked at.
fn fit_orthographic(camera: &mut Camera) {
    let factor = (camera.look_at - camera.location).length() / camera.direction.length();
    camera.right *= factor;
    camera.up *= factor;
}

/// The distance of the sharp plane: to `focal_point`, else `length`, the direction's.
fn set_focus(camera: &mut Camera, items: &Items, length: f64) {
    let distance = match items.focal_point {
        Some(point) => (point - camera.location).length(),
        None if items.turned || items.angle.is_some() || items.look_at.is_some() => length,
        None => 1.0,
    };
    camera.blur.focal_distance = if distance == 0.0 { 1.0 } else { distance };
}
