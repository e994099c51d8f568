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
            if matches!(self.peek()?.tok, Tok::Identifier(_)) {
                return Err(self.unexpected("`vertex_vectors`"));
            }
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
                let mut list = Vec::new();
                self.vectors(3, &mut list, |v| [v[0] as f32, v[1] as f32, v[2] as f32])?;
                builder.vertices = list;
            }
            Keyword::NormalVectors => {
                let mut list = Vec::new();
                self.vectors(3, &mut list, |v| Vec3::new(v[0], v[1], v[2]))?;
                builder.normals =
                    list.into_iter().map(|n| unit_normal(self, n, token.span).as_vec3().to_array()).collect();
            }
            Keyword::UvVectors => {
                let mut list = Vec::new();
                self.vectors(2, &mut list, |v| [v[0] as f32, v[1] as f32])?;
                builder.uvs = list;
            }
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

    /// `{ n, <…>, … }`, vectors of so many components.
    fn vectors<T>(
        &mut self,
        components: usize,
        list: &mut Vec<T>,
        mut entry: impl FnMut([f64; 5]) -> T,
    ) -> Result<()> {
        self.expect_punct(Punct::LeftBrace)?;
        let count = self.count(0.0, MAX_ENTRIES, "a list", "entries")?;
        self.comma()?;
        list.reserve(count.min(RESERVED));
        self.vector_list(count, components, &mut |v| list.push(entry(v)))?;
        self.comma()?;
        self.expect_punct(Punct::RightBrace)?;
        Ok(())
    }

    /// `face_indices { n, <a, b, c> [, texture [, texture, texture]] … }`.
    fn face_indices(&mut self, builder: &mut MeshBuilder, textures: usize) -> Result<()> {
        let token = self.expect(Keyword::FaceIndices)?;
        self.expect_punct(Punct::LeftBrace)?;
        let count = self.count(0.0, MAX_ENTRIES, "a list", "entries")?;
        self.comma()?;
        let (mut faces, mut chosen) = (Vec::with_capacity(count.min(RESERVED)), Vec::new());
        let mut corners = Numbers::new(builder.vertices.len());
        let mut textured = Numbers::new(textures);
        self.numbered_vector_list(count, 3, &mut |v, numbers| {
            faces.push(corners.of(&v[..3]));
            if textures > 0 || !numbers.is_empty() {
                chosen.push(face_textures(&mut textured, numbers));
            }
        })?;
        self.expect_punct(Punct::RightBrace)?;
        corners.check(token.span, "a vertex")?;
        textured.check(token.span, "a texture")?;
        builder.faces = faces;
        builder.textures = if textures > 0 { chosen } else { Vec::new() };
        if builder.faces.is_empty() {
            return Err(Box::new(Diagnostic::error(token.span, "there is no triangle in the mesh")));
        }
        Ok(())
    }

    /// `{ n, <a, b, c>, … }`: numbers of entries of a list of so many.
    fn corner_list(&mut self, keyword: Token, length: usize, entry: &str) -> Result<Vec<Corners>> {
        let (mut list, mut numbers) = (Vec::new(), Numbers::new(length));
        self.vectors(3, &mut list, |v| numbers.of(&v[..3]))?;
        numbers.check(keyword.span, entry)?;
        Ok(list)
    }

    /// One of the lists that stand after `face_indices`.
    fn mesh2_indices(&mut self, builder: &mut MeshBuilder) -> Result<bool> {
        let token = self.peek()?;
        let faces = builder.faces.len();
        match token.tok {
            Tok::Word(Keyword::NormalIndices) => {
                self.next()?;
                let length = builder.normals.len();
                builder.normal_corners = self.corner_list(token, length, "a normal")?;
                if builder.normal_corners.len() > faces {
                    return Err(too_many(token.span, "normal_indices", faces));
                }
                builder.normal_corners.resize(faces, [FLAT; 3]);
            }
            Tok::Word(Keyword::UvIndices) => {
                self.next()?;
                let length = builder.uvs.len();
                builder.uv_corners = self.corner_list(token, length, "a uv vector")?;
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

/// Reads numbers of list entries, and remembers the first one that names no entry.
struct Numbers {
    length: usize,
    wrong: Option<f64>,
}

impl Numbers {
    fn new(length: usize) -> Self {
        Self { length, wrong: None }
    }

    /// Up to three numbers; missing ones repeat the first.
    fn of(&mut self, written: &[f64]) -> Corners {
        let mut numbers = [0; 3];
        for (i, number) in numbers.iter_mut().enumerate() {
            let n = written[if i < written.len() { i } else { 0 }];
            if n.trunc() >= 0.0 && n < self.length as f64 {
                *number = n as u32;
            } else {
                self.wrong.get_or_insert(n);
            }
        }
        numbers
    }

    fn check(&self, span: Span, entry: &str) -> Result<()> {
        let Some(n) = self.wrong else { return Ok(()) };
        let message = format!("{n} is not the number of {entry}: there are {}, counted from 0", self.length);
        Err(Box::new(Diagnostic::error(span, message)))
    }
}

/// The textures of a face's corners: none, one for all or three.
fn face_textures(textures: &mut Numbers, written: &[f64]) -> Corners {
    if written.is_empty() { [NO_TEXTURE; 3] } else { textures.of(written) }
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
