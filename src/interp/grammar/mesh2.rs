//! `mesh2 { vertex_vectors { … } … face_indices { … } … }`: a mesh list by list.

use super::mesh::unit_normal;
use super::object::from_shape;
use super::texture::joined;
use crate::interp::{Parser, Result};
use crate::material::{Attached, Texture};
use crate::math::Vec3;
use crate::scene::Object;
use crate::shape::MeshBuilder;
use crate::shape::mesh::{Corners, FLAT, NO_TEXTURE};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Punct, Tok, Token};
use std::sync::Arc;

/// Lists longer than this are a slip of the pen: entries are numbered with 28 bits.
const MAX_ENTRIES: f64 = 268_435_455.0;

/// Entries that memory is set aside for before the first is read.
const RESERVED: usize = 1 << 23;

impl Parser {
    pub(super) fn mesh2(&mut self, keyword: Token) -> Result<Object> {
        let mut builder = MeshBuilder { kind: "mesh2", ..Default::default() };
        let mut textures = Vec::new();
        while self.mesh2_vectors(&mut builder, &mut textures)? {}
        if builder.vertices.is_empty() {
            return Err(Box::new(Diagnostic::error(keyword.span, "the mesh has no `vertex_vectors`")));
        }
        self.face_indices(&mut builder, textures.len())?;
        while self.mesh2_indices(&mut builder)? {}
        check_lists(&builder, keyword.span)?;
        if self.peek()?.tok == Tok::Word(Keyword::InsideVector) {
            builder.inside_vector = self.inside_vector()?;
        }
        let mut object = from_shape(builder.build());
        object.part_textures = textures;
        Ok(object)
    }

    /// One of the lists that stand before `face_indices`.
    fn mesh2_vectors(
        &mut self,
        builder: &mut MeshBuilder,
        textures: &mut Vec<Attached<Texture>>,
    ) -> Result<bool> {
        let token = self.peek()?;
        let Tok::Word(word) = token.tok else { return Ok(false) };
        let again = match word {
            Keyword::VertexVectors => !builder.vertices.is_empty(),
            Keyword::NormalVectors => !builder.normals.is_empty(),
            Keyword::UvVectors => !builder.uvs.is_empty(),
            Keyword::TextureList => !textures.is_empty(),
            _ => return Ok(false),
        };
        if again {
            let message = format!("`{}` is given again: the list before is left out", word.text());
            self.warn(Diagnostic::warning(token.span, message));
        }
        self.next()?;
        match word {
            Keyword::VertexVectors => {
                builder.vertices = self.list(|p| Ok(p.vector()?.as_vec3().to_array()))?
            }
            Keyword::NormalVectors => {
                let normal = |p: &mut Parser| {
                    let n = p.vector()?;
                    Ok(unit_normal(p, n, token.span).as_vec3().to_array())
                };
                builder.normals = self.list(normal)?;
            }
            Keyword::UvVectors => builder.uvs = self.list(|p| Ok(p.vector2()?.as_vec2().to_array()))?,
            _ => {
                let texture = |p: &mut Parser| {
                    let layers = p.texture_statement()?;
                    Ok(Attached::new(Arc::new(joined(&layers))))
                };
                *textures = self.list(texture)?;
            }
        }
        Ok(true)
    }

    /// `{ n, entry, … }`.
    fn list<T>(&mut self, mut entry: impl FnMut(&mut Parser) -> Result<T>) -> Result<Vec<T>> {
        self.expect_punct(Punct::LeftBrace)?;
        let count = self.count(0.0, MAX_ENTRIES, "a list", "entries")?;
        let mut list = Vec::with_capacity(count.min(RESERVED));
        for _ in 0..count {
            self.comma()?;
            list.push(entry(self)?);
        }
        self.comma()?;
        self.expect_punct(Punct::RightBrace)?;
        Ok(list)
    }

    /// `face_indices { n, <a, b, c> [, texture [, texture, texture]] … }`.
    fn face_indices(&mut self, builder: &mut MeshBuilder, textures: usize) -> Result<()> {
        let token = self.expect(Keyword::FaceIndices)?;
        let (vertices, mut chosen) = (builder.vertices.len(), Vec::new());
        builder.faces = self.list(|p| {
            let corners = p.corners(vertices, "a vertex")?;
            let face_textures = p.face_texture_numbers(textures)?;
            if textures > 0 {
                chosen.push(face_textures);
            }
            Ok(corners)
        })?;
        builder.textures = chosen;
        if builder.faces.is_empty() {
            return Err(Box::new(Diagnostic::error(token.span, "there is no triangle in the mesh")));
        }
        Ok(())
    }

    /// Numbers of three entries of a list.
    fn corners(&mut self, length: usize, entry: &str) -> Result<Corners> {
        let start = self.peek()?.span;
        let v = self.vector()?;
        let inside = |c: f64| c.trunc() >= 0.0 && c < length as f64;
        if !v.to_array().into_iter().all(inside) {
            let message = format!("{entry}'s number is out of range: there are {length}");
            return Err(Box::new(Diagnostic::error(start, message)));
        }
        let Vec3 { x, y, z } = v;
        Ok([x as u32, y as u32, z as u32])
    }

    /// None, one or three texture numbers after a face; a comma may stand before each.
    fn face_texture_numbers(&mut self, length: usize) -> Result<Corners> {
        let mut numbers = [NO_TEXTURE; 3];
        for i in 0..3 {
            self.comma()?;
            if !self.at_plain_number()? {
                break;
            }
            let span = self.peek()?.span;
            let n = self.float()?;
            if n.trunc() < 0.0 || n.is_nan() || n >= length as f64 {
                let message = format!("a texture's number is out of range: there are {length}");
                return Err(Box::new(Diagnostic::error(span, message)));
            }
            numbers[i] = n as u32;
            if i == 0 {
                numbers = [n as u32; 3];
            }
        }
        Ok(numbers)
    }

    /// Whether something but a vector or the end of the list comes next.
    fn at_plain_number(&mut self) -> Result<bool> {
        Ok(match self.peek()?.tok {
            Tok::Punct(Punct::Less | Punct::RightBrace) => false,
            Tok::Identifier(_) => {
                matches!(self.peek_value()?, Some(crate::interp::Value::Float(_)))
            }
            _ => self.at_expression()?,
        })
    }

    /// One of the lists that stand after `face_indices`.
    fn mesh2_indices(&mut self, builder: &mut MeshBuilder) -> Result<bool> {
        let token = self.peek()?;
        let faces = builder.faces.len();
        match token.tok {
            Tok::Word(Keyword::NormalIndices) => {
                self.next()?;
                let length = builder.normals.len();
                builder.normal_corners = self.list(|p| p.corners(length, "a normal"))?;
                if builder.normal_corners.len() > faces {
                    return Err(too_many(token.span, "normal_indices", faces));
                }
                builder.normal_corners.resize(faces, [FLAT; 3]);
            }
            Tok::Word(Keyword::UvIndices) => {
                self.next()?;
                let length = builder.uvs.len();
                builder.uv_corners = self.list(|p| p.corners(length, "a uv vector"))?;
                if builder.uv_corners.len() != faces {
                    let message = format!("`uv_indices` must have one entry per face: there are {faces}");
                    return Err(Box::new(Diagnostic::error(token.span, message)));
                }
            }
            _ => return Ok(false),
        }
        Ok(true)
    }
}

fn too_many(span: Span, list: &str, faces: usize) -> Box<Diagnostic> {
    Box::new(Diagnostic::error(span, format!("`{list}` has more entries than there are faces: {faces}")))
}

/// Without indices of their own, normals and uvs must be as many as the vertices.
fn check_lists(builder: &MeshBuilder, span: Span) -> Result<()> {
    let vertices = builder.vertices.len();
    let fits = |entries: usize, own: bool| entries == 0 || own || entries == vertices;
    let missing = |list: &str| Err(Box::new(Diagnostic::error(span, format!("the mesh needs `{list}`"))));
    if !fits(builder.normals.len(), !builder.normal_corners.is_empty()) {
        return missing("normal_indices");
    }
    if !fits(builder.uvs.len(), !builder.uv_corners.is_empty()) {
        return missing("uv_indices");
    }
    Ok(())
}
