//! `mesh { triangle { … } … }`, and meshes from OBJ files.

use super::object::from_shape;
use super::texture::joined;
use crate::interp::{FileKind, Parser, Result, Value};
use crate::material::{Attached, Texture};
use crate::math::{Vec2, Vec3};
use crate::scene::Object;
use crate::shape::MeshBuilder;
use crate::shape::mesh::{Corners, FLAT, Merged, NO_TEXTURE};
use crate::source::{Diagnostic, Span};
use crate::syntax::{Keyword, Punct, Tok, Token};
use std::collections::HashMap;
use std::sync::Arc;

/// A mesh while its faces are read.
#[derive(Default)]
struct Draft {
    builder: MeshBuilder,
    vertices: Merged<[u32; 3]>,
    normals: Merged<[u32; 3]>,
    uvs: Merged<[u32; 2]>,
    textures: Vec<Attached<Texture>>,
    /// Numbers of textures by the address of the identifier's value.
    texture_numbers: HashMap<usize, u32>,
}

/// Single precision, with -0 as 0, as bits: what equal entries are told by.
fn bits<const N: usize>(v: [f32; N]) -> [u32; N] {
    v.map(|c| (c + 0.0).to_bits())
}

impl Draft {
    fn vertex(&mut self, p: Vec3) -> u32 {
        let v = p.as_vec3().to_array();
        self.vertices.number(&mut self.builder.vertices, bits(v), v)
    }

    fn normal(&mut self, n: Vec3) -> u32 {
        let v = n.as_vec3().to_array();
        self.normals.number(&mut self.builder.normals, bits(v), v)
    }

    fn uv(&mut self, p: Vec2) -> u32 {
        let v = p.as_vec2().to_array();
        self.uvs.number(&mut self.builder.uvs, bits(v), v)
    }

    fn texture(&mut self, layers: &Arc<Vec<Attached<Texture>>>) -> u32 {
        *self.texture_numbers.entry(Arc::as_ptr(layers) as usize).or_insert_with(|| {
            let texture = match &layers[..] {
                [only] if only.transform.is_identity() => only.value.clone(),
                _ => Arc::new(joined(layers)),
            };
            self.textures.push(Attached::new(texture));
            self.textures.len() as u32 - 1
        })
    }

    fn face(&mut self, vertices: [Vec3; 3], normals: Option<[Vec3; 3]>, uvs: Option<[Vec2; 3]>) {
        let corners = vertices.map(|p| self.vertex(p));
        self.builder.faces.push(corners);
        let normals = normals.map_or([FLAT; 3], |n| n.map(|n| self.normal(n)));
        self.builder.normal_corners.push(normals);
        let uvs = uvs.map_or([FLAT; 3], |u| u.map(|p| self.uv(p)));
        self.builder.uv_corners.push(uvs);
    }
}

/// The unit normal, or x where there is none.
pub(super) fn unit_normal(parser: &mut Parser, n: Vec3, span: Span) -> Vec3 {
    n.try_normalize().unwrap_or_else(|| {
        parser.warn(Diagnostic::warning(span, "a normal of length 0 is taken to be <1, 0, 0>"));
        Vec3::X
    })
}

impl Parser {
    pub(super) fn mesh(&mut self, keyword: Token) -> Result<Object> {
        if self.at_obj()? {
            return self.obj_mesh(keyword);
        }
        let mut draft =
            Draft { builder: MeshBuilder { kind: "mesh", ..Default::default() }, ..Default::default() };
        loop {
            let token = self.peek()?;
            match token.tok {
                Tok::Word(Keyword::Triangle) => self.mesh_triangle(&mut draft, false)?,
                Tok::Word(Keyword::SmoothTriangle) => self.mesh_triangle(&mut draft, true)?,
                Tok::Word(Keyword::InsideVector) => draft.builder.inside_vector = self.inside_vector()?,
                _ => break,
            }
        }
        if draft.builder.faces.is_empty() {
            if matches!(self.peek()?.tok, Tok::Identifier(_)) {
                return Err(self.unexpected("`triangle`, `smooth_triangle` or `obj`"));
            }
            return Err(Box::new(Diagnostic::error(keyword.span, "there is no triangle in the mesh")));
        }
        let mut object = from_shape(draft.builder.build());
        object.part_textures = draft.textures;
        Ok(object)
    }

    /// `inside_vector V`; zero means none.
    pub(super) fn inside_vector(&mut self) -> Result<Option<Vec3>> {
        self.expect(Keyword::InsideVector)?;
        let v = self.vector()?;
        Ok((v != Vec3::ZERO).then_some(v))
    }

    fn mesh_triangle(&mut self, draft: &mut Draft, smooth: bool) -> Result<()> {
        self.next()?;
        self.expect_punct(Punct::LeftBrace)?;
        let (mut vertices, mut normals) = ([Vec3::ZERO; 3], [Vec3::ZERO; 3]);
        for i in 0..3 {
            if i > 0 {
                self.comma()?;
            }
            vertices[i] = self.vector()?;
            if smooth {
                self.comma()?;
                let span = self.peek()?.span;
                let n = self.vector()?;
                normals[i] = unit_normal(self, n, span);
            }
        }
        let uvs = if self.accept(Keyword::UvVectors)? { Some(self.three_uvs()?) } else { None };
        let textures = self.face_textures(draft)?;
        self.expect_punct(Punct::RightBrace)?;
        draft.face(vertices, smooth.then_some(normals), uvs);
        draft.builder.textures.push(textures);
        Ok(())
    }

    fn three_uvs(&mut self) -> Result<[Vec2; 3]> {
        let a = self.vector2()?;
        self.comma()?;
        let b = self.vector2()?;
        self.comma()?;
        Ok([a, b, self.vector2()?])
    }

    /// `texture { Id }` or `texture_list { Id Id Id }`, if one comes; the last of several counts.
    fn face_textures(&mut self, draft: &mut Draft) -> Result<Corners> {
        let mut textures = [NO_TEXTURE; 3];
        loop {
            if self.accept(Keyword::Texture)? {
                self.expect_punct(Punct::LeftBrace)?;
                textures = [self.texture_number(draft)?; 3];
            } else if self.accept(Keyword::TextureList)? {
                self.expect_punct(Punct::LeftBrace)?;
                for texture in &mut textures {
                    *texture = self.texture_number(draft)?;
                    self.comma()?;
                }
            } else {
                return Ok(textures);
            }
            self.expect_punct(Punct::RightBrace)?;
        }
    }

    /// A texture identifier.
    fn texture_number(&mut self, draft: &mut Draft) -> Result<u32> {
        let Some(Value::Texture(layers)) = self.peek_value()? else {
            return Err(self.unexpected("a texture identifier"));
        };
        self.take_value()?;
        Ok(draft.texture(&layers))
    }

    /// Whether the word `obj` comes next, undeclared: it is no reserved word.
    fn at_obj(&mut self) -> Result<bool> {
        let Tok::Identifier(name) = self.peek()?.tok else { return Ok(false) };
        Ok(self.name(name) == "obj" && self.peek_value()?.is_none())
    }

    /// `obj "file" [inside_vector V]`: all groups of a Wavefront file as one mesh. Its materials are not
    /// used; the object's texture is. An extension of Glint.
    fn obj_mesh(&mut self, keyword: Token) -> Result<Object> {
        self.next()?;
        let span = self.peek()?.span;
        let name = self.file_name()?;
        let path = self.require_file(&name, FileKind::Data, span)?;
        let mut builder = read_obj(&path)
            .map_err(|e| Box::new(Diagnostic::error(span, format!("cannot read the mesh `{name}`: {e}"))))?;
        if builder.faces.is_empty() {
            return Err(Box::new(Diagnostic::error(keyword.span, "there is no triangle in the mesh")));
        }
        if matches!(self.peek()?.tok, Tok::Word(Keyword::InsideVector)) {
            builder.inside_vector = self.inside_vector()?;
        }
        Ok(from_shape(builder.build()))
    }
}

/// Every group's faces, cut into triangles.
fn read_obj(path: &std::path::Path) -> std::result::Result<MeshBuilder, tobj::LoadError> {
    let options = tobj::LoadOptions {
        triangulate: true,
        ignore_lines: true,
        ignore_points: true,
        ..Default::default()
    };
    let materials = |_: &std::path::Path| Ok(Default::default());
    let file = std::fs::File::open(path).map_err(|_| tobj::LoadError::OpenFileFailed)?;
    let (models, _) = tobj::load_obj_buf(&mut std::io::BufReader::new(file), &options, materials)?;
    let mut all = MeshBuilder { kind: "mesh", ..Default::default() };
    let smooth = models.iter().any(|m| !m.mesh.normal_indices.is_empty());
    let textured = models.iter().any(|m| !m.mesh.texcoord_indices.is_empty());
    for tobj::Model { mesh, .. } in models {
        let corners = |list: &[u32], shift: usize| -> Vec<Corners> {
            list.chunks_exact(3).map(|c| [c[0], c[1], c[2]].map(|i| i + shift as u32)).collect()
        };
        let faces = corners(&mesh.indices, all.vertices.len());
        let own = |wanted: bool, list: &[u32], shift: usize| match (wanted, list.is_empty()) {
            (false, _) => Vec::new(),
            (true, true) => vec![[FLAT; 3]; faces.len()],
            (true, false) => corners(list, shift),
        };
        all.normal_corners.extend(own(smooth, &mesh.normal_indices, all.normals.len()));
        all.uv_corners.extend(own(textured, &mesh.texcoord_indices, all.uvs.len()));
        all.vertices.extend(mesh.positions.chunks_exact(3).map(|c| [c[0], c[1], c[2]]));
        all.normals.extend(mesh.normals.chunks_exact(3).map(|c| [c[0], c[1], c[2]]));
        all.uvs.extend(mesh.texcoords.chunks_exact(2).map(|c| [c[0], c[1]]));
        all.faces.extend(faces);
    }
    Ok(all)
}
