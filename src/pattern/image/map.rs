//! Images laid onto surfaces: coordinates, interpolation, transparency.
//!
//! | setting | default | meaning |
//! |---|---|---|
//! | map_type | 0 | 0 planar, 1 spherical, 2 cylindrical, 5 toroidal |
//! | once | off | the image does not repeat |
//! | interpolate | 0 | 2 bilinear, 3 bicubic, 4 by distance |
//! | repeat, offset | <1, 1>, <0, 0> | copies per unit, and shift in units of the image |

use super::Image;
use crate::color::{Color, Rgb, grey};
use crate::math::{Vec2, Vec3, floor};
use crate::pattern::warp::polar;
use std::sync::Arc;

/// An image with its place on the surface.
#[derive(Clone, Debug)]
pub struct ImageMap {
    pub image: Arc<Image>,
    pub placement: Placement,
    /// Added to every texel's filter and transmit; palettes have them in `palette`.
    pub filter: f32,
    pub transmit: f32,
    /// Colours of the palette with their filter and transmit; empty if the image has none.
    pub palette: Vec<Color>,
    /// Whether heights and materials are palette indices.
    pub use_index: bool,
}

#[derive(Clone, Copy, Debug)]
pub struct Placement {
    pub kind: MapKind,
    pub once: bool,
    pub interpolation: Interpolation,
    pub repeat: Vec2,
    pub offset: Vec2,
}

impl Default for Placement {
    fn default() -> Self {
        let (kind, interpolation) = (MapKind::Planar, Interpolation::None);
        Self { kind, once: false, interpolation, repeat: Vec2::ONE, offset: Vec2::ZERO }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MapKind {
    Planar,
    Spherical,
    Cylindrical,
    Toroidal,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interpolation {
    None,
    Bilinear,
    Bicubic,
    /// By inverse squared distance from the four nearest texels.
    Distance,
}

/// Keeps edges on the upper side in spite of rounding.
const EDGE: f64 = 1e-10;

/// `v` wrapped to 0..size.
fn wrap(v: f64, size: f64) -> f64 {
    let w = v - size * floor(v / size);
    if (0.0..size).contains(&w) { w } else { 0.0 }
}

impl ImageMap {
    pub fn new(image: Arc<Image>) -> Self {
        let color = |c: &super::Texel| Color { rgb: c.rgb, filter: 0.0, transmit: 1.0 - c.alpha };
        let palette = image.palette().unwrap_or_default().iter().map(color).collect();
        Self { image, placement: Placement::default(), filter: 0.0, transmit: 0.0, palette, use_index: false }
    }

    fn size(&self) -> (f64, f64) {
        (self.image.width as f64, self.image.height as f64)
    }

    /// Column and row with fractions, row 0 at the top; `None` outside the image.
    pub fn coordinates(&self, p: Vec3) -> Option<(f64, f64)> {
        let place = &self.placement;
        let (w, h) = self.size();
        let (all_w, all_h) = (w * place.repeat.x, h * place.repeat.y);
        let outside = |v: f64| place.once && !(0.0..=1.0).contains(&v);
        let (u, v) = match place.kind {
            MapKind::Planar if outside(p.x) || outside(p.y) => return None,
            MapKind::Planar => ((p.x * all_w) % all_w, (p.y * all_h) % all_h),
            MapKind::Spherical => {
                let (longitude, latitude, _) = polar::spherical(p)?;
                (longitude * all_w, latitude * all_h)
            }
            MapKind::Cylindrical => {
                let (longitude, _) = polar::cylindrical(p)?;
                if outside(p.y) {
                    return None;
                }
                (longitude * all_w, (p.y * all_h) % all_h)
            }
            MapKind::Toroidal => {
                let (longitude, angle, _) = polar::toroidal(p, 1.0)?;
                (longitude * all_w, angle * all_h)
            }
        };
        let (u, v) = (u - place.offset.x * w + EDGE, v - place.offset.y * h + EDGE);
        if place.once && !((0.0..w).contains(&u) && (0.0..h).contains(&v)) {
            return None;
        }
        Some((wrap(u, w), wrap(-v, h)))
    }

    /// The texel's column or row, beyond the edges around the image or, with `once`, at the edge.
    #[inline]
    fn at_edge(&self, i: i64, size: usize) -> usize {
        if self.placement.once {
            i.clamp(0, size as i64 - 1) as usize
        } else {
            i.rem_euclid(size as i64) as usize
        }
    }

    #[inline]
    fn texel(&self, i: i64, j: i64) -> Color {
        let (x, y) = (self.at_edge(i, self.image.width), self.at_edge(j, self.image.height));
        if let Some(index) = self.image.index(x, y) {
            return self.palette.get(usize::from(index)).copied().unwrap_or(Color::BLACK);
        }
        let c = self.image.texel(x, y);
        Color { rgb: c.rgb, filter: self.filter, transmit: 1.0 - c.alpha + self.transmit }
    }

    /// The colour at a point; `None` outside the image.
    pub fn color(&self, p: Vec3) -> Option<Color> {
        let (u, v) = self.coordinates(p)?;
        Some(self.color_at(u, v))
    }

    pub(super) fn color_at(&self, u: f64, v: f64) -> Color {
        let mut sum = Color::BLACK;
        self.blend(u, v, |i, j, weight| sum = sum + self.texel(i, j) * weight as f32);
        let alpha = 1.0 - (sum.transmit - self.transmit);
        if self.image.premultiplied && alpha != 0.0 {
            sum.rgb /= alpha;
        }
        sum
    }

    /// The height for bumps: grey, or the palette index with `use_index`.
    pub fn height_at(&self, u: f64, v: f64) -> f64 {
        if self.use_index && !self.palette.is_empty() {
            return f64::from(self.index_at(u, v));
        }
        self.grey_at(u, v)
    }

    /// As measured: of the colours as they are stored, multiplied by alpha or not.
    pub(super) fn grey_at(&self, u: f64, v: f64) -> f64 {
        let mut sum = 0.0;
        self.blend(u, v, |i, j, weight| {
            let color = self.texel(i, j);
            let alpha = if self.image.dim { 1.0 - (color.transmit - self.transmit) } else { 1.0 };
            sum += f64::from(grey(color.rgb) * alpha) * weight;
        });
        sum
    }

    /// The palette index, interpolated and cut to a whole number; without a palette, red as a byte.
    pub fn material_at(&self, u: f64, v: f64) -> u32 {
        if self.palette.is_empty() {
            return (self.color_at(u, v).rgb.x * 255.0) as u32;
        }
        self.index_at(u, v)
    }

    fn index_at(&self, u: f64, v: f64) -> u32 {
        let mut sum = 0.0;
        self.blend(u, v, |i, j, weight| {
            let (x, y) = (self.at_edge(i, self.image.width), self.at_edge(j, self.image.height));
            sum += f64::from(self.image.index(x, y).unwrap_or(0)) * weight;
        });
        sum as u32
    }

    /// Hands over the texels around a place with their weights, which add to 1.
    #[inline]
    fn blend(&self, u: f64, v: f64, mut add: impl FnMut(i64, i64, f64)) {
        if self.placement.interpolation == Interpolation::None {
            return add(u as i64, v as i64, 1.0);
        }
        // Texel centres lie at half-integers.
        let (u, v) = (u + 0.5, v + 0.5);
        let (i, j) = (u as i64, v as i64);
        let (p, q) = (u - i as f64, v - j as f64);
        match self.placement.interpolation {
            Interpolation::Bicubic => {
                let (wx, wy) = (cubic_weights(p), cubic_weights(q));
                for (b, y) in wy.into_iter().zip(j - 2..) {
                    for (a, x) in wx.into_iter().zip(i - 2..) {
                        add(x, y, a * b);
                    }
                }
            }
            kind => {
                let weights = if kind == Interpolation::Distance {
                    distance_weights(p, q)
                } else {
                    [p * q, (1.0 - p) * q, p * (1.0 - q), (1.0 - p) * (1.0 - q)]
                };
                for ((x, y), weight) in
                    [(i, j), (i - 1, j), (i, j - 1), (i - 1, j - 1)].into_iter().zip(weights)
                {
                    add(x, y, weight);
                }
            }
        }
    }

    /// Whether no point lets light through.
    pub fn is_opaque(&self) -> bool {
        if self.placement.once {
            return false;
        }
        match self.palette.is_empty() {
            true => self.filter == 0.0 && self.transmit == 0.0 && self.image.is_opaque(),
            false => self.palette.iter().all(|c| !c.is_transparent()),
        }
    }

    /// The normal `n` tilted by the slope of the heights; heights count in units of one pixel.
    pub fn perturb(&self, n: Vec3, amount: f64, p: Vec3) -> Vec3 {
        let Some((u, v)) = self.coordinates(p) else { return n };
        let (w, h) = self.size();
        let height = |u: f64, v: f64| amount * self.height_at(u, v);
        let (left, down) = (wrap(u - 1.0, w), wrap(v + 1.0, h));
        let p1 = Vec3::new(0.0, height(u, v), 0.0);
        let p2 = Vec3::new(-1.0, height(left, down), 1.0);
        let p3 = Vec3::new(1.0, height(wrap(left + 2.0, w), down), 1.0);
        let bump = (p3 - p2).cross(p1 - p2).normalize_or(Vec3::Y);
        let (mut x, mut y) = (n.cross(Vec3::Y), n);
        if x.length() < 1e-10 {
            (x, y) = (Vec3::X, Vec3::new(0.0, if n.y < 0.0 { -1.0 } else { 1.0 }, 0.0));
        }
        let x = x.normalize();
        let z = x.cross(y).normalize_or_zero();
        bump.x * x + bump.y * y - bump.z * z
    }
}

/// Weights of the texels at i-2 ..= i+1, a fraction `p` beyond texel i-1.
fn cubic_weights(p: f64) -> [f64; 4] {
    let s = 1.0 - p;
    [
        -0.5 * p * s * s,
        0.5 * s * (s * (3.0 * p + 1.0) + 1.0),
        0.5 * p * (p * (3.0 * s + 1.0) + 1.0),
        -0.5 * s * p * p,
    ]
}

fn distance_weights(p: f64, q: f64) -> [f64; 4] {
    let (s, t) = (1.0 - p, 1.0 - q);
    let squares = [s * s + t * t, p * p + t * t, s * s + q * q, p * p + q * q];
    if let Some(here) = squares.iter().position(|&d| d == 0.0) {
        return std::array::from_fn(|k| f64::from(k == here));
    }
    let sum: f64 = squares.iter().map(|d| 1.0 / d).sum();
    squares.map(|d| 1.0 / d / sum)
}

/// Clear white: what shows outside an image.
pub const OUTSIDE: Color = Color { rgb: Rgb::ONE, filter: 0.0, transmit: 1.0 };
