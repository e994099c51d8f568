//! Plane curves made of polynomial pieces: outlines of prisms and glyphs, profiles of lathes.

use crate::math::Vec2;
use crate::math::polynomial::{Roots, product, sign_changes, value, value_and_slope};

/// How points of the scene language become pieces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurveKind {
    Linear,
    Quadratic,
    Cubic,
    Bezier,
}

impl CurveKind {
    /// The fewest points that make a closed outline.
    pub fn fewest_closed(self) -> usize {
        match self {
            CurveKind::Linear => 3,
            CurveKind::Quadratic => 5,
            CurveKind::Cubic => 6,
            CurveKind::Bezier => 4,
        }
    }

    /// The fewest points that make one piece.
    pub fn fewest_open(self) -> usize {
        match self {
            CurveKind::Linear => 2,
            CurveKind::Quadratic => 3,
            CurveKind::Cubic | CurveKind::Bezier => 4,
        }
    }
}

/// One piece for parameters 0 to 1, lowest power first. Its ends are kept besides, so that pieces that meet
/// agree to the bit about where.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Piece {
    pub x: [f64; 4],
    pub y: [f64; 4],
    pub start: Vec2,
    pub end: Vec2,
    /// Around the piece.
    pub min: Vec2,
    pub max: Vec2,
}

impl Piece {
    fn new(coefficients: [Vec2; 4], start: Vec2, end: Vec2) -> Self {
        let (x, y) = (coefficients.map(|c| c.x), coefficients.map(|c| c.y));
        let (x0, x1) = extent(&x, start.x, end.x);
        let (y0, y1) = extent(&y, start.y, end.y);
        Self { x, y, start, end, min: Vec2::new(x0, y0), max: Vec2::new(x1, y1) }
    }

    pub fn line(a: Vec2, b: Vec2) -> Self {
        Self::new([a, b - a, Vec2::ZERO, Vec2::ZERO], a, b)
    }

    /// From `b` to `c`; at `b` parallel to `a c`.
    fn quadratic(a: Vec2, b: Vec2, c: Vec2) -> Self {
        Self::new([b, 0.5 * (c - a), 0.5 * (a - 2.0 * b + c), Vec2::ZERO], b, c)
    }

    /// Catmull-Rom, from `b` to `c`.
    fn cubic(a: Vec2, b: Vec2, c: Vec2, d: Vec2) -> Self {
        let square = a - 2.5 * b + 2.0 * c - 0.5 * d;
        let cube = 0.5 * (d - a) + 1.5 * (b - c);
        Self::new([b, 0.5 * (c - a), square, cube], b, c)
    }

    fn bezier(a: Vec2, b: Vec2, c: Vec2, d: Vec2) -> Self {
        Self::new([a, 3.0 * (b - a), 3.0 * (a - 2.0 * b + c), d - a + 3.0 * (b - c)], a, d)
    }

    pub fn at(&self, w: f64) -> Vec2 {
        Vec2::new(value(&self.x, w), value(&self.y, w))
    }

    pub fn slope(&self, w: f64) -> Vec2 {
        let slope = Vec2::new(value_and_slope(&self.x, w).1, value_and_slope(&self.y, w).1);
        // At a cusp or a doubled control point the direction is that a little further inside.
        if slope == Vec2::ZERO {
            let inside = w + (0.5 - w) * 1e-6;
            return Vec2::new(value_and_slope(&self.x, inside).1, value_and_slope(&self.y, inside).1);
        }
        slope
    }

    /// Parameters at which the piece crosses the line `a x + b y + c = 0`. Points on the line count as on
    /// its positive side, so a piece and its neighbour never both miss it.
    pub fn crossings(&self, a: f64, b: f64, c: f64) -> Roots {
        let side = |p: Vec2| a * p.x + b * p.y + c;
        let mut k = [0.0; 4];
        for (i, k) in k.iter_mut().enumerate() {
            *k = a * self.x[i] + b * self.y[i];
        }
        k[0] += c;
        sign_changes(&k, (0.0, side(self.start)), (1.0, side(self.end)))
    }

    /// Whether the box around the piece may meet the line `a x + b y + c = 0`.
    pub fn may_cross(&self, a: f64, b: f64, c: f64) -> bool {
        let (middle, half) = (0.5 * (self.min + self.max), 0.5 * (self.max - self.min));
        let reach = a.abs() * half.x + b.abs() * half.y;
        let size = a.abs() * middle.x.abs() + b.abs() * middle.y.abs() + c.abs() + reach;
        (a * middle.x + b * middle.y + c).abs() <= reach + super::rounding(size)
    }

    /// `x² + scale` as a polynomial of degree 6 in the parameter.
    pub fn x_squared(&self) -> [f64; 7] {
        product(self.x, self.x)
    }
}

/// Least and greatest value for parameters 0 to 1.
fn extent(c: &[f64; 4], start: f64, end: f64) -> (f64, f64) {
    let (mut low, mut high) = (start.min(end), start.max(end));
    let slope = [c[1], 2.0 * c[2], 3.0 * c[3]];
    let inner = crate::math::Range::new(0.0, 1.0);
    for w in crate::math::polynomial::roots(&slope, inner, crate::math::polynomial::Touching::Skip) {
        let v = value(c, w);
        low = low.min(v);
        high = high.max(v);
    }
    (low, high)
}

/// Points nearer to each other than this part of the outline's size are one.
const SAME_POINT: f64 = 1e-10;

fn same(a: Vec2, b: Vec2, size: f64) -> bool {
    (a - b).abs().max_element() <= SAME_POINT * size
}

fn size_of_outline(points: &[Vec2]) -> f64 {
    let (low, high) = points.iter().fold((points[0], points[0]), |(l, h), p| (l.min(*p), h.max(*p)));
    (high - low).max_element()
}

/// The pieces of an open curve through (or along) all points.
pub(crate) fn open_curve(kind: CurveKind, points: &[Vec2]) -> Vec<Piece> {
    match kind {
        CurveKind::Linear => points.windows(2).map(|p| Piece::line(p[0], p[1])).collect(),
        CurveKind::Quadratic => points.windows(3).map(|p| Piece::quadratic(p[0], p[1], p[2])).collect(),
        CurveKind::Cubic => points.windows(4).map(|p| Piece::cubic(p[0], p[1], p[2], p[3])).collect(),
        CurveKind::Bezier => points.chunks_exact(4).map(|p| Piece::bezier(p[0], p[1], p[2], p[3])).collect(),
    }
}

/// Closed curves one after another, and whether the last had to be closed; `None` if one of a kind that
/// cannot be closed was left open.
pub(crate) fn closed_curves(kind: CurveKind, points: &[Vec2]) -> Option<(Vec<Piece>, bool)> {
    match kind {
        CurveKind::Linear => Some(closed_lines(points)),
        CurveKind::Quadratic => closed_splines(kind, points, 1, 2),
        CurveKind::Cubic => closed_splines(kind, points, 1, 3),
        CurveKind::Bezier => closed_beziers(points),
    }
}

fn closed_lines(points: &[Vec2]) -> (Vec<Piece>, bool) {
    let size = size_of_outline(points);
    let mut pieces = Vec::new();
    let mut rest = points;
    let mut left_open = false;
    while let [first, tail @ ..] = rest {
        let end = tail.iter().position(|&p| same(p, *first, size));
        let (inner, after) = tail.split_at(end.unwrap_or(tail.len()));
        let ring = std::iter::once(first).chain(inner).chain(std::iter::once(first));
        let ring: Vec<Vec2> = ring.copied().collect();
        pieces.extend(open_curve(CurveKind::Linear, &ring));
        left_open |= end.is_none();
        rest = after.get(1..).unwrap_or(&[]);
    }
    (pieces, left_open)
}

/// Curves whose point number `first` comes again at the end; `taken` points are used up by the closing one. A single
/// point behind the last curve begins no other.
fn closed_splines(
    kind: CurveKind,
    points: &[Vec2],
    first: usize,
    taken: usize,
) -> Option<(Vec<Piece>, bool)> {
    let size = size_of_outline(points);
    let mut pieces = Vec::new();
    let mut rest = points;
    while pieces.is_empty() || rest.len() > 1 {
        let start = *rest.get(first)?;
        let closing = first + 1 + rest[first + 1..].iter().position(|&p| same(p, start, size))?;
        let end = closing + taken - 1;
        let mut curve = rest.get(..end)?.to_vec();
        curve[closing] = start;
        pieces.extend(open_curve(kind, &curve));
        rest = &rest[end..];
    }
    Some((pieces, false))
}

fn closed_beziers(points: &[Vec2]) -> Option<(Vec<Piece>, bool)> {
    let size = size_of_outline(points);
    let mut pieces = Vec::new();
    let mut first: Option<Vec2> = None;
    let mut at = Vec2::ZERO;
    for p in points.chunks_exact(4) {
        let start = match first {
            None => p[0],
            Some(_) if same(p[0], at, size) => at,
            Some(_) => return None,
        };
        let ring_start = *first.get_or_insert(start);
        let closes = same(p[3], ring_start, size);
        at = if closes { ring_start } else { p[3] };
        // Closed ones run backwards, which turns a prism's normals.
        pieces.push(Piece::bezier(at, p[2], p[1], start));
        if closes {
            first = None;
        }
    }
    first.is_none().then_some((pieces, false))
}

/// Whether closed curves surround a point an odd number of times.
pub(crate) fn surround(pieces: &[Piece], p: Vec2) -> bool {
    let mut inside = false;
    for piece in pieces {
        if piece.min.y > p.y || piece.max.y < p.y || piece.max.x < p.x {
            continue;
        }
        if piece.min.x > p.x {
            // All crossings count: how many is odd if the ends are on different sides.
            inside ^= (piece.start.y < p.y) != (piece.end.y < p.y);
            continue;
        }
        for w in piece.crossings(0.0, 1.0, -p.y) {
            inside ^= piece.at(w).x > p.x;
        }
    }
    inside
}

#[cfg(test)]
mod tests {
    use super::*;

    fn v(x: f64, y: f64) -> Vec2 {
        Vec2::new(x, y)
    }

    #[test]
    fn pieces_begin_and_end_where_they_say() {
        let p = [v(0.5, -1.0), v(1.5, 0.25), v(2.0, 3.0), v(-0.5, 1.0)];
        for kind in [CurveKind::Linear, CurveKind::Quadratic, CurveKind::Cubic, CurveKind::Bezier] {
            for piece in open_curve(kind, &p) {
                assert!(piece.at(0.0).distance(piece.start) < 1e-15, "{kind:?}");
                assert!(piece.at(1.0).distance(piece.end) < 1e-14, "{kind:?}");
            }
        }
    }

    #[test]
    fn rings_are_told_apart() {
        let square = |a: f64| [v(-a, -a), v(a, -a), v(a, a), v(-a, a), v(-a, -a)];
        let points: Vec<Vec2> = square(2.0).into_iter().chain(square(1.0)).collect();
        let (pieces, left_open) = closed_curves(CurveKind::Linear, &points).unwrap();
        assert_eq!((pieces.len(), left_open), (8, false));
        assert!(surround(&pieces, v(1.5, 0.3)) && !surround(&pieces, v(0.5, 0.3)));
        // Through corners, where two pieces meet.
        assert!(surround(&pieces, v(-1.5, 1.0)) && !surround(&pieces, v(-2.5, 2.0)));
        let (_, left_open) = closed_curves(CurveKind::Linear, &points[..9]).unwrap();
        assert!(left_open);
        assert!(closed_curves(CurveKind::Cubic, &points[..6]).is_none());
        let ring: Vec<Vec2> = [2, 3, 0, 1, 2, 3, 0].map(|i| points[i]).to_vec();
        let rest = |n: usize| {
            closed_curves(CurveKind::Cubic, &[&ring[..], &points[..n]].concat()).map(|c| c.0.len())
        };
        assert_eq!((rest(0), rest(1), rest(2)), (Some(4), Some(4), None));
    }
}
