//! One file per area of the language, one function per production.

mod atmosphere;
mod camera;
mod csg;
mod default_texture;
mod finish;
mod globals;
mod interior;
mod light;
mod map;
mod material;
mod media;
mod modifiers;
mod normal;
mod object;
mod old_texture;
mod pattern;
mod pigment;
mod regions;
mod shapes;
mod texture;
mod warp;
