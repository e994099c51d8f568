//! One file per area of the language, one function per production.

mod algebraic;
mod array;
mod atmosphere;
mod bicubic_patch;
mod blob;
mod camera;
mod color;
mod csg;
mod declare;
mod default;
mod default_texture;
mod finish;
mod function;
mod globals;
mod height_field;
mod image;
mod interior;
mod isosurface;
mod julia;
mod light;
mod map;
mod material;
mod media;
mod mesh;
mod mesh2;
mod modifiers;
mod normal;
mod object;
mod old_texture;
mod parametric;
mod pattern;
mod pigment;
mod regions;
mod revolution;
mod scene;
mod shapes;
mod solids;
mod spline;
mod text;
mod texture;
mod transform;
mod warp;

pub(super) use image::LoadedImage;

pub(super) use array::array_index;
