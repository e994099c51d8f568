//! Patterns: a point in, a value out. One file each.
//!
//! A [`Pattern`] is the bare formula. A [`Signal`] is a pattern as pigments, normals and textures use it:
//! warped, repeated and shaped by a wave. A [`BlendMap`] turns the value into something.

mod agate;
mod aoi;
mod boxed;
mod bozo;
mod brick;
mod cells;
mod chain;
mod checker;
mod crackle;
mod cubic;
mod cylindrical;
mod density_file;
mod dents;
mod facets;
mod fractal;
mod function;
mod gradient;
mod granite;
mod hexagon;
pub mod image;
mod lattice_points;
mod leopard;
mod map;
mod marble;
mod nook;
mod object;
mod onion;
mod pavement;
mod planar;
mod quilted;
mod radial;
mod ripples;
mod signal;
mod slope;
mod spherical;
mod spiral;
mod square;
mod tiling;
mod triangular;
pub mod warp;
mod wave;
mod wave_sources;
mod waves;
mod wood;
mod wrinkles;

pub use crate::math::noise::{NoiseGenerator, Turbulence};
pub use agate::Agate;
pub use aoi::Aoi;
pub use boxed::Boxed;
pub use bozo::{Bozo, Bumps, Spotted};
pub use brick::Brick;
pub use cells::Cells;
pub use chain::Chain;
pub use checker::Checker;
pub use crackle::Crackle;
pub use cubic::Cubic;
pub use cylindrical::Cylindrical;
pub use density_file::DensityFile;
pub use dents::Dents;
pub use facets::Facets;
pub use fractal::{Fractal, FractalKind, Magnet};
pub use function::Function;
pub use gradient::Gradient;
pub use granite::Granite;
pub use hexagon::Hexagon;
pub use leopard::Leopard;
pub use map::{BlendMap, Blended, Changes, ColorMap};
pub use marble::Marble;
pub use object::InsideOut;
pub use onion::Onion;
pub use pavement::Pavement;
pub use planar::Planar;
pub use quilted::Quilted;
pub use radial::Radial;
pub use ripples::Ripples;
pub use signal::{PatternField, Signal};
pub use slope::{Altitude, Slope, SlopeDirection};
pub use spherical::Spherical;
pub use spiral::Spiral;
pub use square::Square;
pub use tiling::Tiling;
pub use triangular::Triangular;
pub use warp::Warp;
pub use wave::Wave;
pub use waves::Waves;
pub use wood::Wood;
pub use wrinkles::Wrinkles;

use crate::color::Color;
use crate::function::Surroundings;
use crate::math::{Vec2, Vec3, floor};
use std::fmt::Debug;
use std::sync::Arc;

/// Coordinates are pushed up by this before they are cut to whole numbers, so that faces at whole numbers
/// belong to the cell above them in spite of rounding.
const EDGE: f64 = 1e-10;

/// What a pattern may ask about besides the point.
#[derive(Clone, Copy, Debug)]
pub struct Context<'a> {
    /// The scene's generator, for patterns without one of their own.
    pub noise: NoiseGenerator,
    /// `number_of_waves`.
    pub waves: usize,
    /// The surface hit, if there is one (not in functions, nor in the sky).
    pub hit: Option<&'a Incidence>,
}

impl Context<'_> {
    /// Away from any surface.
    pub fn away(surroundings: &Surroundings) -> Self {
        Self { noise: surroundings.generator(), waves: surroundings.waves(), hit: None }
    }
}

/// How a ray met a surface, in world space.
#[derive(Clone, Copy, Debug)]
pub struct Incidence {
    pub point: Vec3,
    /// The normal after the most recent perturbation, turned towards the ray; unit length.
    pub normal: Vec3,
    /// The ray's unit direction.
    pub direction: Vec3,
    pub uv: Vec2,
}

/// The settings beside a pattern that formulas read: its own generator, or the scene's.
#[derive(Clone, Copy, Debug)]
pub struct Setting<'a> {
    pub noise: NoiseGenerator,
    pub turbulence: &'a Turbulence,
    pub frequency: f64,
    pub phase: f64,
    pub context: &'a Context<'a>,
}

/// How a pattern starts out when its keyword is read, and what kind of values it has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Character {
    /// Whether the pattern repeats with `frequency`; if not, its frequency starts at 0.
    pub periodic: bool,
    /// The wave that the keyword sets.
    pub wave: Option<Wave>,
    /// Whether the formula uses turbulence itself, in place of being displaced by it.
    pub absorbs_turbulence: bool,
    /// Number of items if the values are the whole numbers 0, 1, … for a list in place of a map.
    pub items: Option<usize>,
}

impl Character {
    /// Continuous values.
    pub const SMOOTH: Character =
        Character { periodic: true, wave: None, absorbs_turbulence: false, items: None };
    /// As they come, without repetition.
    pub const APERIODIC: Character = Character { periodic: false, ..Self::SMOOTH };

    /// The whole numbers below `n`.
    pub const fn list(n: usize) -> Self {
        Character { items: Some(n), ..Self::APERIODIC }
    }
}

/// A setting of one particular pattern, written after it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Modifier {
    AgateTurbulence(f64),
    BrickSize(Vec3),
    Mortar(f64),
    Control0(f64),
    Control1(f64),
    Metric(f64),
    Form(Vec3),
    Offset(f64),
    Solid(bool),
    Size(f64),
    Coords(f64),
    Exponent(u32),
    Exterior(u32, f64),
    Interior(u32, f64),
    Interpolate(u32),
    Sides(u32),
    Tiles(u32),
    Number(u32),
}

/// A scalar field over space: a point of the pattern's own space to its raw value.
pub trait Pattern: Debug + Send + Sync {
    fn value(&self, p: Vec3, setting: &Setting) -> f64;

    /// The value, or one near it as soon as `settles` says of a range that it lies in that no value there makes a
    /// difference.
    fn value_within(&self, p: Vec3, setting: &Setting, _settles: &dyn Fn(f64, f64) -> bool) -> f64 {
        self.value(p, setting)
    }

    /// How many functions, patterns, pigments and objects stand within each other in the pattern.
    fn depth(&self) -> u32 {
        0
    }

    /// How many pigments are asked for one value at most.
    fn cost(&self) -> f64 {
        0.0
    }

    /// By how much the value mostly differs (root of the mean square) between places a little apart, per
    /// distance; `None` if that is not known.
    fn steepness(&self) -> Option<f64> {
        None
    }

    /// The pattern's name, for reports.
    fn name(&self) -> &'static str {
        std::any::type_name::<Self>().rsplit("::").next().unwrap_or_default()
    }

    fn character(&self) -> Character {
        Character::SMOOTH
    }

    /// Whether values hang on how a ray met the surface, not on the point alone.
    fn asks_hit(&self) -> bool {
        false
    }

    /// Colours by value, where the author names none. Used as they are, without gamma.
    fn colors(&self) -> Vec<(f32, Color)> {
        vec![(0.0, Color::BLACK), (1.0, Color::WHITE)]
    }

    /// Whether it has no value at all and serves for normals alone.
    fn is_for_normals_only(&self) -> bool {
        false
    }

    /// The normal `n` perturbed by the pattern's own rule; `None` if the pattern has none and its value is
    /// taken for a height. Not normalised.
    fn perturb(&self, _n: Vec3, _amount: f64, _p: Vec3, _setting: &Setting) -> Option<Vec3> {
        None
    }

    /// A copy with one setting changed; `None` if the pattern has no such setting.
    fn modified(&self, _modifier: Modifier) -> Option<Arc<dyn Pattern>> {
        None
    }
}

/// Default colours given as key and red, green, blue.
fn keyed(entries: &[(f32, [f32; 3])]) -> Vec<(f32, Color)> {
    entries.iter().map(|&(key, [r, g, b])| (key, Color::rgb(r, g, b))).collect()
}

/// Default colours of a list.
fn listed(entries: &[[f32; 3]]) -> Vec<(f32, Color)> {
    entries.iter().enumerate().map(|(i, &[r, g, b])| (i as f32, Color::rgb(r, g, b))).collect()
}

/// 1 at 0, falling to 0 at 1 and beyond.
fn falloff(distance: f64) -> f64 {
    if distance <= 1.0 { 1.0 - distance } else { 0.0 }
}

/// The triangle wave: 0 at whole numbers, 1 half way between.
fn triangle(v: f64) -> f64 {
    let u = v - floor(v);
    if u < 0.5 { 2.0 * u } else { 2.0 * (1.0 - u) }
}
