//! Bicubic Bézier patch, drawn as flat triangles with interpolated normals.
//!
//! | parameter | unit | default | meaning |
//! |---|---|---|---|
//! | points | length | | control points P[i][j], u along i, v along j |
//! | u_steps, v_steps | – | 0 | how often the patch is halved along each parameter |
//! | flatness | length in the world | 0 | pieces flatter than this are not halved any further |
//! | uv_vectors | – | unit square | surface parameters at the corners |
//!
//! Pieces are split in halves until they are flat or have been split as often as allowed. A piece becomes
//! two triangles between its corners; their normals are the patch's own at the corners, interpolated. Where
//! neighbours are split differently cracks remain.
//!
//! Numerical care: corners are evaluated on the whole patch, so neighbours with the same corner have it to
//! the bit, and no ray slips between them.

use super::plane::meet;
use super::triangle::Shear;
use super::{Crossing, Shape, rounding};
use crate::math::bvh::{Bvh, Quality};
use crate::math::{Aabb, Range, Ray, Transform, Vec2, Vec3};
use std::sync::Arc;

pub type Controls = [[Vec3; 4]; 4];

/// More pieces than this are refused.
pub const MAX_PIECES: usize = 1 << 20;

#[derive(Clone, Debug)]
pub struct BicubicPatch {
    controls: Controls,
    pieces: Vec<PatchPiece>,
    /// Of each piece: at its low, far, near and high corner (see [`PatchPiece::corners`]).
    points: Vec<[Vec3; 4]>,
    tree: Bvh,
    uv_vectors: [Vec2; 4],
    detail: PatchDetail,
}

/// A rectangle of parameters.
#[derive(Clone, Copy, Debug)]
struct PatchPiece {
    low: Vec2,
    high: Vec2,
}

impl PatchPiece {
    fn corners(&self) -> [Vec2; 4] {
        [self.low, Vec2::new(self.low.x, self.high.y), Vec2::new(self.high.x, self.low.y), self.high]
    }

    /// Parameters of the corners of its two triangles.
    fn triangle(&self, second: bool) -> [Vec2; 3] {
        let far = Vec2::new(self.low.x, self.high.y);
        let near = Vec2::new(self.high.x, self.low.y);
        if second { [self.low, self.high, near] } else { [self.low, far, self.high] }
    }
}

/// How the patch is taken apart.
#[derive(Clone, Copy, Debug)]
pub struct PatchDetail {
    pub u_steps: u32,
    pub v_steps: u32,
    pub flatness: f64,
}

fn bernstein(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t]
}

fn bernstein_slope(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    [-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t]
}

fn blend(controls: &Controls, u: [f64; 4], v: [f64; 4]) -> Vec3 {
    let row = |row: &[Vec3; 4]| (0..4).map(|j| v[j] * row[j]).sum::<Vec3>();
    (0..4).map(|i| u[i] * row(&controls[i])).sum()
}

/// Both halves of a cubic.
fn halves(p: [Vec3; 4]) -> ([Vec3; 4], [Vec3; 4]) {
    let mid = |a: Vec3, b: Vec3| 0.5 * (a + b);
    let (a, b, c) = (mid(p[0], p[1]), mid(p[1], p[2]), mid(p[2], p[3]));
    let (d, e) = (mid(a, b), mid(b, c));
    let f = mid(d, e);
    ([p[0], a, d, f], [f, e, c, p[3]])
}

fn split_v(c: &Controls) -> (Controls, Controls) {
    let rows = c.map(halves);
    (rows.map(|r| r.0), rows.map(|r| r.1))
}

fn transposed(c: &Controls) -> Controls {
    std::array::from_fn(|i| std::array::from_fn(|j| c[j][i]))
}

fn split_u(c: &Controls) -> (Controls, Controls) {
    let (a, b) = split_v(&transposed(c));
    (transposed(&a), transposed(&b))
}

/// The largest distance of a control point from the plane of three corners; infinite if they lie on a line.
fn bulge(c: &Controls) -> f64 {
    let origin = c[0][0];
    match (c[0][3] - origin).cross(c[3][0] - origin).try_normalize() {
        Some(n) => c.iter().flatten().map(|&p| n.dot(p - origin).abs()).fold(0.0, f64::max),
        None => f64::INFINITY,
    }
}

impl BicubicPatch {
    /// `None` if it would take more than [`MAX_PIECES`] pieces.
    pub fn new(controls: Controls, detail: PatchDetail, uv_vectors: [Vec2; 4]) -> Option<Self> {
        let pieces = pieces(&controls, detail)?;
        let tree = Bvh::build(&[], Quality::Best);
        Some(Self { controls, pieces, points: Vec::new(), tree, uv_vectors, detail }.with_tree())
    }

    fn with_tree(mut self) -> Self {
        self.points = self.pieces.iter().map(|piece| piece.corners().map(|uv| self.at(uv))).collect();
        let boxes: Vec<Aabb> = self.points.iter().map(|p| Aabb::from_points(*p)).collect();
        self.tree = Bvh::build(&boxes, Quality::Best);
        self
    }

    fn at(&self, uv: Vec2) -> Vec3 {
        blend(&self.controls, bernstein(uv.x), bernstein(uv.y))
    }

    /// The patch's own normal; zero where it has none.
    fn true_normal(&self, uv: Vec2) -> Vec3 {
        let along_u = blend(&self.controls, bernstein_slope(uv.x), bernstein(uv.y));
        let along_v = blend(&self.controls, bernstein(uv.x), bernstein_slope(uv.y));
        along_u.cross(along_v).normalize_or_zero()
    }

    /// Parameters of the corners of the triangle that a crossing is on.
    fn corners(&self, crossing: &Crossing) -> [Vec2; 3] {
        self.pieces[crossing.part as usize / 2].triangle(crossing.part % 2 == 1)
    }

    /// Corners of one of a piece's two triangles.
    fn triangle(&self, piece: u32, second: bool) -> [Vec3; 3] {
        let [low, far, near, high] = self.points[piece as usize];
        if second { [low, high, near] } else { [low, far, high] }
    }

    fn hits(&self, piece: u32, ray: &Ray, shear: &Shear, mut found: impl FnMut(Crossing)) {
        for second in [false, true] {
            let [a, b, c] = self.triangle(piece, second);
            let Some(w) = shear.weights([a - ray.origin, b - ray.origin, c - ray.origin]) else { continue };
            let Some(normal) = (b - a).cross(c - a).try_normalize() else { continue };
            if let Some(t) = meet(ray, normal, a) {
                found(Crossing { t, part: 2 * piece + u32::from(second), uv: Vec2::new(w.y, w.z) });
            }
        }
    }
}

fn mix<T>(weights: Vec2, [a, b, c]: [T; 3]) -> T
where
    T: std::ops::Add<Output = T> + std::ops::Mul<f64, Output = T>,
{
    a * (1.0 - weights.x - weights.y) + b * weights.x + c * weights.y
}

/// Halves the patch until its pieces are flat or have been split as often as allowed.
fn pieces(controls: &Controls, detail: PatchDetail) -> Option<Vec<PatchPiece>> {
    // Nothing is flatter than that: every piece is halved as often as allowed.
    if detail.flatness <= 0.0 && detail.u_steps + detail.v_steps > MAX_PIECES.ilog2() {
        return None;
    }
    let mut done = Vec::new();
    let mut todo = vec![(*controls, PatchPiece { low: Vec2::ZERO, high: Vec2::ONE }, 0u32)];
    while let Some((c, piece, depth)) = todo.pop() {
        if done.len() + todo.len() >= MAX_PIECES {
            return None;
        }
        let (in_u, in_v) = (depth < detail.u_steps, depth < detail.v_steps);
        if !(in_u || in_v) || bulge(&c) < detail.flatness {
            done.push(piece);
            continue;
        }
        let middle = 0.5 * (piece.low + piece.high);
        let mut parts = vec![(c, piece)];
        if in_u {
            parts = parts
                .into_iter()
                .flat_map(|(c, p)| {
                    let (a, b) = split_u(&c);
                    let at = |low: f64, high: f64| PatchPiece {
                        low: Vec2::new(low, p.low.y),
                        high: Vec2::new(high, p.high.y),
                    };
                    [(a, at(p.low.x, middle.x)), (b, at(middle.x, p.high.x))]
                })
                .collect();
        }
        if in_v {
            parts = parts
                .into_iter()
                .flat_map(|(c, p)| {
                    let (a, b) = split_v(&c);
                    let at = |low: f64, high: f64| PatchPiece {
                        low: Vec2::new(p.low.x, low),
                        high: Vec2::new(p.high.x, high),
                    };
                    [(a, at(p.low.y, middle.y)), (b, at(middle.y, p.high.y))]
                })
                .collect();
        }
        todo.extend(parts.into_iter().map(|(c, p)| (c, p, depth + 1)));
    }
    Some(done)
}

impl Shape for BicubicPatch {
    fn bounds(&self) -> Aabb {
        self.tree.bounds()
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        let shear = Shear::new(ray.dir);
        self.tree.traverse(ray, range, |piece, max| {
            self.hits(piece, ray, &shear, |c| out.extend(range.contains(c.t).then_some(c)));
            max
        });
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let shear = Shear::new(ray.dir);
        let mut best: Option<Crossing> = None;
        self.tree.traverse(ray, range, |piece, max| {
            let mut max = max;
            self.hits(piece, ray, &shear, |c| {
                if c.t > range.min && c.t < max {
                    max = c.t;
                    best = Some(c);
                }
            });
            max
        });
        best
    }

    fn contains(&self, _p: Vec3) -> bool {
        false
    }

    fn is_solid(&self) -> bool {
        false
    }

    fn normal(&self, p: Vec3, crossing: &Crossing) -> Vec3 {
        let normals = self.corners(crossing).map(|uv| self.true_normal(uv));
        let face = || self.face_normal(p, crossing).unwrap_or(Vec3::Y);
        mix(crossing.uv, normals).try_normalize().unwrap_or_else(face)
    }

    fn face_normal(&self, _p: Vec3, crossing: &Crossing) -> Option<Vec3> {
        let [a, b, c] = self.triangle(crossing.part / 2, crossing.part % 2 == 1);
        // The same way round as the patch's own: u is along i, v along j.
        let n = (b - a).cross(c - a);
        let n = if crossing.part.is_multiple_of(2) { -n } else { n };
        Some(n.normalize_or(Vec3::Y))
    }

    fn locate(&self, _ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        let corners = self.triangle(crossing.part / 2, crossing.part % 2 == 1);
        let size = corners.iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
        (mix(crossing.uv, corners), rounding(4.0 * size))
    }

    fn uv(&self, _p: Vec3, crossing: &Crossing) -> Option<Vec2> {
        let at = mix(crossing.uv, self.corners(crossing));
        // A row of control points runs along the first surface parameter.
        let (u, v) = (at.y, at.x);
        let [a, b, c, d] = self.uv_vectors;
        Some((1.0 - v) * ((1.0 - u) * a + u * b) + v * ((1.0 - u) * d + u * c))
    }

    fn placed(&self, to_world: &Transform) -> Option<Arc<dyn Shape>> {
        let m = to_world.forward.matrix3;
        let rigid = (m.transpose() * m).abs_diff_eq(glam::DMat3::IDENTITY, 1e-12);
        if self.detail.flatness <= 0.0 || rigid {
            return None;
        }
        // What is flat shows in the world.
        let pieces = pieces(&self.controls.map(|row| row.map(|p| m * p)), self.detail)?;
        Some(Arc::new(Self { pieces, ..self.clone() }.with_tree()))
    }

    fn kind(&self) -> &'static str {
        "bicubic_patch"
    }

    fn heap_bytes(&self) -> usize {
        size_of_val(&self.pieces[..]) + size_of_val(&self.points[..]) + self.tree.heap_bytes()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flat() -> Controls {
        std::array::from_fn(|i| std::array::from_fn(|j| Vec3::new(j as f64 / 3.0, i as f64 / 3.0, 0.0)))
    }

    const UNIT: [Vec2; 4] = [Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y];

    #[test]
    fn parameters_of_a_flat_patch_are_its_coordinates() {
        let detail = PatchDetail { u_steps: 2, v_steps: 1, flatness: 0.0 };
        let patch = BicubicPatch::new(flat(), detail, UNIT).unwrap();
        assert_eq!(patch.pieces.len(), 8);
        let ray = Ray::new(Vec3::new(0.3, 0.8, -2.0), Vec3::Z);
        let c = patch.nearest(&ray, Range::FORWARD).unwrap();
        assert!(patch.uv(Vec3::ZERO, &c).unwrap().distance(Vec2::new(0.3, 0.8)) < 1e-14);
        assert!(patch.face_normal(Vec3::ZERO, &c).unwrap().distance(patch.normal(Vec3::ZERO, &c)) < 1e-14);
    }

    #[test]
    fn flat_pieces_stay_whole() {
        let detail = PatchDetail { u_steps: 5, v_steps: 5, flatness: 0.01 };
        assert_eq!(BicubicPatch::new(flat(), detail, UNIT).unwrap().pieces.len(), 1);
        let dented: Controls =
            std::array::from_fn(|i| flat()[i].map(|p| if i == 2 { p + 0.005 * Vec3::Z } else { p }));
        let patch = BicubicPatch::new(dented, detail, UNIT).unwrap();
        assert_eq!(patch.pieces.len(), 1);
        assert!(patch.placed(&Transform::rotate(Vec3::splat(30.0))).is_none());
        let large = patch.placed(&Transform::scale(Vec3::splat(10.0))).unwrap();
        assert!(large.heap_bytes() > patch.heap_bytes());
        let endless = PatchDetail { u_steps: 40, v_steps: 40, flatness: 0.0 };
        assert!(BicubicPatch::new(flat(), endless, UNIT).is_none());
    }
}
