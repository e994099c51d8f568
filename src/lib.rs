//! Glint: a batch ray tracer driven by POV-Ray's scene language.
//!
//! Data flows one way: text, scene, prepared scene, rays, pixels, files. A room may use rooms above it in
//! this list, never below.

pub mod camera;
pub mod cli;
pub mod color;
pub mod function;
pub mod interp;
pub mod light;
pub mod material;
pub mod math;
pub mod pattern;
pub mod picture;
pub mod render;
pub mod scene;
pub mod shape;
pub mod source;
pub mod syntax;
pub mod trace;
pub mod trade;
pub mod world;
