//! One file per area of the language, one function per production.

mod csg;
mod default_texture;
mod finish;
mod interior;
mod map;
mod material;
mod media;
mod modifiers;
mod normal;
mod object;
mod old_texture;
mod pattern;
mod pending;
mod pigment;
mod regions;
mod shapes;
mod texture;
mod warp;
