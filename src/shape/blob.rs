//! Blob: where the sum of its components' fields equals a threshold.
//!
//! | parameter | unit | default | meaning |
//! |---|---|---|---|
//! | threshold | – | 1 | |
//! | components | | | spheres and cylinders with round ends, each with strength and radius |
//!
//! A component's field is `strength (1 - rho²/radius²)²` up to its radius, where rho is the distance from its
//! center or axis, and 0 beyond. Inside is where the sum is larger than the threshold.
//!
//! Along a ray each field is a quartic over one or more stretches; between the ends of all stretches the sum
//! is one quartic, and its sign changes are found one stretch after the other.
//!
//! Numerical care: each stretch's polynomial begins where the stretch does; the value at its end is handed
//! on to the next, so no crossing is lost or doubled where two meet. Stretches whose
//! fields together cannot reach the threshold are passed over.

use super::span::within;
use super::{COINCIDENT, Crossing, PartTexture, Shape};
use crate::math::bvh::{Bvh, Quality};
use crate::math::polynomial::{product, sign_changes, value};
use crate::math::{Aabb, EPSILON, Range, Ray, Transform, Vec3};
use glam::DAffine3;
use smallvec::SmallVec;

/// From this many components on a tree finds those that a ray or point can meet.
const TREE_FROM: usize = 8;

#[derive(Clone, Debug)]
pub struct Blob {
    components: Vec<BlobComponent>,
    threshold: f64,
    tree: Option<Bvh>,
    /// Around the components that count.
    extent: Aabb,
    /// Around the surface.
    surface: Aabb,
    /// Length of the first part of a ray that is searched; 0 if rays are searched as a whole.
    window: f64,
    /// Whether any component has a texture of its own.
    textured: bool,
}

type Stretches = SmallVec<[Stretch; 16]>;

/// From this many components on a ray is searched part by part.
const PARTS_FROM: usize = 64;

/// Relative room for the roundings of a bound on the sum of fields.
const ROOM: f64 = 1e-12;

/// Steps to the sides of the box around the surface.
const HALVINGS: usize = 20;

/// One component in the blob.
#[derive(Clone, Debug)]
pub struct BlobComponent {
    /// Takes the blob's space to one in which the radius is 1 and the axis, if any, runs along z from 0.
    to_unit: DAffine3,
    from_unit: DAffine3,
    /// Length of the axis in that space; 0 for a sphere.
    length: f64,
    strength: f64,
    /// Number of its texture among the object's part textures.
    texture: Option<u32>,
}

impl BlobComponent {
    /// `None` if the radius is 0.
    pub fn sphere(center: Vec3, radius: f64, strength: f64) -> Option<Self> {
        let place = Transform::scale(Vec3::splat(radius.abs())).then(&Transform::translate(center));
        (radius != 0.0).then(|| Self::placed(&place, 0.0, strength))
    }

    /// `None` if the radius is 0 or the ends are one point.
    pub fn cylinder(base: Vec3, cap: Vec3, radius: f64, strength: f64) -> Option<Self> {
        let axis = (cap - base).try_normalize().filter(|_| radius != 0.0)?;
        let (u, v) = axis.any_orthonormal_pair();
        let r = radius.abs();
        let forward = DAffine3::from_cols(r * u, r * v, r * axis, base);
        let place = Transform::from_affine(forward)?;
        Some(Self::placed(&place, (cap - base).length() / r, strength))
    }

    fn placed(place: &Transform, length: f64, strength: f64) -> Self {
        Self { to_unit: place.inverse, from_unit: place.forward, length, strength, texture: None }
    }

    pub fn transformed(mut self, t: &Transform) -> Self {
        self.to_unit *= t.inverse;
        self.from_unit = t.forward * self.from_unit;
        self
    }

    pub fn with_texture(mut self, texture: Option<u32>) -> Self {
        self.texture = texture;
        self
    }

    /// `1 - rho²` and its gradient at a point, if that is inside the component.
    fn nearness(&self, p: Vec3) -> Option<(f64, Vec3)> {
        let mut u = self.to_unit.transform_point3(p);
        u.z -= u.z.max(0.0).min(self.length);
        let q = 1.0 - u.length_squared();
        (q > 0.0).then(|| (q, -2.0 * (self.to_unit.matrix3.transpose() * u)))
    }

    fn field(&self, p: Vec3) -> f64 {
        self.nearness(p).map_or(0.0, |(q, _)| self.strength * q * q)
    }

    /// How far the axis goes in a direction along one of the coordinates, how much further the field does, and its
    /// strength.
    fn beyond(&self, axis: usize, sign: f64) -> [f64; 3] {
        let m = self.from_unit.matrix3;
        let half = Vec3::new(m.x_axis[axis], m.y_axis[axis], m.z_axis[axis]).length();
        let ends = [0.0, self.length].map(|z| sign * self.from_unit.transform_point3(z * Vec3::Z)[axis]);
        [ends[0].max(ends[1]), half * (1.0 + 8.0 * EPSILON), self.strength]
    }

    fn bounds(&self) -> Aabb {
        let unit = Aabb { min: Vec3::splat(-1.0), max: Vec3::new(1.0, 1.0, 1.0 + self.length) };
        let m = self.from_unit.matrix3;
        // A ball's extent along an axis is the length of the matrix's row; the axis adds its own.
        let row = |i: usize| Vec3::new(m.x_axis[i], m.y_axis[i], m.z_axis[i]).length();
        let reach = Vec3::new(row(0), row(1), row(2)) * (1.0 + 8.0 * EPSILON);
        let ends = [0.0, unit.max.z - 1.0].map(|z| self.from_unit.transform_point3(z * Vec3::Z));
        let b = Aabb::from_points(ends);
        Aabb { min: b.min - reach, max: b.max + reach }
    }

    /// The stretches of a ray inside the component.
    fn stretches(&self, ray: &Ray, out: &mut Stretches) {
        let o = self.to_unit.transform_point3(ray.origin);
        let d = self.to_unit.transform_vector3(ray.dir);
        let mut add = |o: Vec3, d: Vec3, from: f64, to: f64| {
            out.extend(Stretch::new(o, d, from, to, self.strength));
        };
        let everywhere = (f64::NEG_INFINITY, f64::INFINITY);
        if self.length == 0.0 {
            return add(o, d, everywhere.0, everywhere.1);
        }
        let flat = |v: Vec3| v.with_z(0.0);
        let top = o - self.length * Vec3::Z;
        if d.z == 0.0 {
            let near = if o.z < 0.0 {
                o
            } else if top.z > 0.0 {
                top
            } else {
                flat(o)
            };
            return add(near, flat(d), everywhere.0, everywhere.1);
        }
        let (low, high) = (-o.z / d.z, (self.length - o.z) / d.z);
        add(flat(o), flat(d), low.min(high), low.max(high));
        if d.z > 0.0 {
            add(o, d, everywhere.0, low);
            add(top, d, high, everywhere.1);
        } else {
            add(top, d, everywhere.0, high);
            add(o, d, low, everywhere.1);
        }
    }
}

/// Part of a ray over which one field is one quartic: `strength (peak - bend (t - middle)²)²`.
#[derive(Clone, Copy, Debug)]
struct Stretch {
    from: f64,
    to: f64,
    peak: f64,
    bend: f64,
    middle: f64,
    strength: f64,
}

impl Stretch {
    /// Where a line in unit space is within 1 of the origin, between `from` and `to`.
    fn new(o: Vec3, d: Vec3, from: f64, to: f64, strength: f64) -> Option<Self> {
        let bend = d.length_squared();
        // Along the axis of a cylinder the distance does not change.
        let middle = if bend > 0.0 { -o.dot(d) / bend } else { 0.0 };
        let peak = 1.0 - (o + middle * d).length_squared();
        if peak.is_nan() || peak <= 0.0 {
            return None;
        }
        let half = (peak / bend).sqrt();
        let (from, to) = (from.max(middle - half), to.min(middle + half));
        (from < to).then_some(Self { from, to, peak, bend, middle, strength })
    }

    /// No value between two places on the stretch is larger, but for rounding.
    fn most(&self, from: f64, to: f64) -> f64 {
        let beside = self.middle.max(from).min(to) - self.middle;
        let nearness = (self.peak - self.bend * beside * beside).max(0.0);
        (self.strength * nearness * nearness).max(0.0)
    }

    /// The field as a polynomial in the distance from `t`.
    fn field(&self, t: f64) -> [f64; 5] {
        let m = t - self.middle;
        let k = [self.peak - self.bend * m * m, -2.0 * self.bend * m, -self.bend];
        let s = k.map(|c| self.strength * c);
        product(s, k)
    }
}

/// The part of `reach`, a box around all fields that count, in which they may sum up to the threshold: beyond each side the
/// sum of the largest values that each has there is below it.
fn around_surface(components: &[BlobComponent], threshold: f64, reach: Aabb) -> Aabb {
    if threshold <= 0.0 || !reach.is_finite() || reach.is_empty() {
        return reach;
    }
    let least = threshold * (1.0 - ROOM);
    let mut extent = reach;
    for (axis, upper) in [(0, false), (0, true), (1, false), (1, true), (2, false), (2, true)] {
        let sign = if upper { 1.0 } else { -1.0 };
        let (start, end) = if upper { (reach.min, reach.max) } else { (reach.max, reach.min) };
        let fields: Vec<[f64; 3]> =
            components.iter().filter(|c| c.strength > 0.0).map(|c| c.beyond(axis, sign)).collect();
        let most = |plane: f64| -> f64 {
            let most_of = |&[at, half, strength]: &[f64; 3]| {
                let beside = ((sign * plane - at) / half).max(0.0);
                let nearness = (1.0 - beside * beside).max(0.0);
                strength * nearness * nearness
            };
            fields.iter().map(most_of).sum()
        };
        let (mut within, mut beyond) = (start[axis], end[axis]);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (within + beyond);
            if most(middle) < least { beyond = middle } else { within = middle }
        }
        if upper { extent.max[axis] = beyond } else { extent.min[axis] = beyond }
    }
    if extent.is_empty() { Aabb::EMPTY } else { extent }
}

impl Blob {
    pub fn new(components: Vec<BlobComponent>, threshold: f64) -> Self {
        let boxes: Vec<Aabb> = components.iter().map(BlobComponent::bounds).collect();
        let positive = components.iter().zip(&boxes).filter(|(c, _)| c.strength > 0.0 || threshold < 0.0);
        let extent = positive.fold(Aabb::EMPTY, |e, (_, b)| e.union(*b));
        let surface = around_surface(&components, threshold, extent);
        let tree = (components.len() >= TREE_FROM).then(|| Bvh::build(&boxes, Quality::Best));
        let textured = components.iter().any(|c| c.texture.is_some());
        let mean = boxes.iter().map(|b| b.size().max_element()).sum::<f64>() / boxes.len().max(1) as f64;
        let window = if components.len() >= PARTS_FROM { mean } else { 0.0 };
        Self { components, threshold, tree, extent, surface, window, textured }
    }

    /// Calls `visit` with every component that may reach `p`.
    fn each_at(&self, p: Vec3, mut visit: impl FnMut(&BlobComponent)) {
        match &self.tree {
            Some(tree) => {
                tree.any_at(p, |i| {
                    visit(&self.components[i as usize]);
                    false
                });
            }
            None => self.components.iter().for_each(visit),
        }
    }

    /// The sum of the fields, the sum of their sizes, and the gradient.
    fn sample(&self, p: Vec3) -> (f64, f64, Vec3) {
        let (mut sum, mut size, mut gradient) = (0.0, 0.0, Vec3::ZERO);
        self.each_at(p, |c| {
            if let Some((q, slope)) = c.nearness(p) {
                sum += c.strength * q * q;
                size += (c.strength * q).abs();
                gradient += 2.0 * c.strength * q * slope;
            }
        });
        (sum, size, gradient)
    }

    fn visit(&self, ray: &Ray, range: Range, mut found: impl FnMut(f64) -> bool) {
        if self.surface.is_empty() {
            return;
        }
        let shift = (self.surface.center() - ray.origin).dot(ray.dir);
        let local = Ray::new(ray.at(shift), ray.dir);
        let range = Range::new(range.min - shift, range.max - shift);
        let mut within_range = |t: f64| !range.contains(t) || found(t + shift);
        if self.window > 0.0 {
            let size = self.surface.size().element_sum();
            let (from, to) = (range.min.max(-size), range.max.min(size));
            return self.in_windows(&local, Range::new(from, to), within_range);
        }
        let Some(inside) = within(&local, range, &self.surface) else { return };
        let mut stretches = Stretches::new();
        self.stretches(&local, Range::LINE, &mut stretches);
        self.search(&mut stretches, inside, None, &mut within_range);
    }

    /// The search of one part of the way after the other, each twice as long as the one before: components behind
    /// the first crossing are not looked at.
    fn in_windows(&self, ray: &Ray, range: Range, mut found: impl FnMut(f64) -> bool) {
        let Some(inside) = within(ray, range, &self.surface) else { return };
        let (mut from, mut length, mut start) = (inside.min, self.window, None);
        let mut stretches = Stretches::new();
        while from < inside.max {
            let to = if from + 1.5 * length < inside.max { from + length } else { inside.max };
            stretches.clear();
            self.stretches(ray, Range::new(from, to), &mut stretches);
            let Some(end) = self.search(&mut stretches, Range::new(from, to), start, &mut found) else {
                return;
            };
            (from, length, start) = (to, 2.0 * length, Some(end));
        }
    }

    /// All stretches that reach into a part of the way.
    fn stretches(&self, ray: &Ray, part: Range, out: &mut Stretches) {
        match &self.tree {
            Some(tree) => {
                // From in front of everything that counts.
                let size = self.surface.size().element_sum();
                let start =
                    if part.min.is_finite() { part.min - 1e-3 * (part.max - part.min) } else { -size };
                let length = if part.max.is_finite() { 1.002 * (part.max - start) } else { f64::INFINITY };
                tree.any(&Ray::new(ray.at(start), ray.dir), Range::new(0.0, length), |i| {
                    self.components[i as usize].stretches(ray, out);
                    false
                });
            }
            None => self.components.iter().for_each(|c| c.stretches(ray, out)),
        }
    }

    /// Sign changes of the summed fields less the threshold, until `found` says that it is enough. `start` is the
    /// value at the range's beginning, if that is known already; the result is the one at its end.
    fn search(
        &self,
        stretches: &mut [Stretch],
        range: Range,
        start: Option<f64>,
        mut found: impl FnMut(f64) -> bool,
    ) -> Option<f64> {
        let outside = -self.threshold;
        let whole: f64 = stretches.iter().map(|s| s.most(s.from, s.to)).sum();
        // Bounds have to be so much smaller: they and the sums are rounded.
        let least = self.threshold - ROOM * (whole + self.threshold.abs());
        if whole < least {
            return Some(outside);
        }
        stretches.sort_unstable_by(|a, b| a.from.total_cmp(&b.from));
        let mut stops: SmallVec<[f64; 32]> = SmallVec::new();
        stretches.iter().for_each(|s| stops.extend_from_slice(&[s.from, s.to]));
        stops.sort_unstable_by(f64::total_cmp);
        let mut begun = 0;
        let mut active: SmallVec<[u32; 16]> = SmallVec::new();
        let mut before = outside;
        for w in stops.windows(2) {
            let (low, high) = (w[0], w[1].min(range.max));
            for k in (0..active.len()).rev() {
                if stretches[active[k] as usize].to <= low {
                    active.remove(k);
                }
            }
            while begun < stretches.len() && stretches[begun].from <= low {
                active.push(begun as u32);
                begun += 1;
            }
            if low >= range.max {
                return Some(before);
            }
            if low >= high || high <= range.min {
                continue;
            }
            let most: f64 = active.iter().map(|&i| stretches[i as usize].most(low, high)).sum();
            if most < least {
                before = -1.0;
                continue;
            }
            // The first stretch in range begins with the value there.
            let clipped = low <= range.min;
            let base = if clipped { range.min } else { low };
            let sum = self.summed(stretches, &active, base);
            let first = if clipped { start.unwrap_or(sum[0]) } else { before };
            before = value(&sum, high - base);
            for s in sign_changes(&sum, (0.0, first), (high - base, before)) {
                if !found(base + s) {
                    return None;
                }
            }
        }
        let covered = stops.last().is_some_and(|&end| end >= range.max);
        Some(if covered { before } else { outside })
    }

    /// The sum of the fields of some stretches less the threshold, as a polynomial in the distance from `base`.
    fn summed(&self, stretches: &[Stretch], active: &[u32], base: f64) -> [f64; 5] {
        let mut sum = [-self.threshold, 0.0, 0.0, 0.0, 0.0];
        for &i in active {
            let field = stretches[i as usize].field(base);
            for k in 0..5 {
                sum[k] += field[k];
            }
        }
        sum
    }
}

impl Shape for Blob {
    fn bounds(&self) -> Aabb {
        self.surface
    }

    /// As large as the fields, which is nearer to what the language's reference takes.
    fn extent(&self) -> Aabb {
        self.extent
    }

    fn inside_bounds(&self) -> Aabb {
        if self.threshold < 0.0 { Aabb::INFINITE } else { self.surface }
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        self.visit(ray, range, |t| {
            out.push(Crossing::new(t));
            true
        });
    }

    fn nearest(&self, ray: &Ray, range: Range) -> Option<Crossing> {
        let mut first = None;
        self.visit(ray, range, |t| {
            first = Some(Crossing::new(t));
            false
        });
        first
    }

    fn contains(&self, p: Vec3) -> bool {
        let (sum, size, _) = self.sample(p);
        sum > self.threshold - COINCIDENT * size
    }

    fn normal(&self, p: Vec3, _crossing: &Crossing) -> Vec3 {
        (-self.sample(p).2).normalize_or(Vec3::X)
    }

    fn locate(&self, ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        let p = ray.at(crossing.t);
        let (sum, size, gradient) = self.sample(p);
        let steep2 = gradient.length_squared();
        let extent = self.surface.size().max_element();
        let reach = p.abs().max_element() + extent;
        if steep2 == 0.0 {
            return (p, super::rounding(reach));
        }
        let step = (sum - self.threshold) / steep2 * gradient;
        let error = 64.0 * EPSILON * (size / steep2.sqrt() + reach);
        if step.length() > 1e-6 * extent { (p, error) } else { (p - step, error) }
    }

    fn part_texture(&self, p: Vec3, _crossing: &Crossing) -> PartTexture {
        if !self.textured {
            return PartTexture::Object;
        }
        let mut parts: SmallVec<[(Option<u32>, f32); 4]> = SmallVec::new();
        self.each_at(p, |c| {
            let weight = c.field(p).abs() as f32;
            if weight > 0.0 {
                parts.push((c.texture, weight));
            }
        });
        let total: f32 = parts.iter().map(|(_, w)| w).sum();
        if total == 0.0 {
            return PartTexture::Object;
        }
        parts.iter_mut().for_each(|(_, w)| *w /= total);
        PartTexture::Blend(parts)
    }

    fn kind(&self) -> &'static str {
        "blob"
    }

    fn heap_bytes(&self) -> usize {
        self.components.capacity() * size_of::<BlobComponent>()
            + self.tree.as_ref().map_or(0, Bvh::heap_bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_sphere_at_half_strength() {
        let blob = Blob::new(vec![BlobComponent::sphere(Vec3::ZERO, 1.0, 1.0).unwrap()], 0.5);
        let ray = Ray::new(-3.0 * Vec3::Z, Vec3::Z);
        let t = blob.nearest(&ray, Range::FORWARD).unwrap().t;
        assert!((t - 3.0 + (1.0 - 0.5f64.sqrt()).sqrt()).abs() < 1e-14);
    }

    #[test]
    fn many_components_agree_with_few() {
        // The same blob with a tree and without: far components change nothing.
        let near = |n: usize| {
            let mut all = vec![
                BlobComponent::sphere(Vec3::new(0.4, 0.1, 0.0), 1.2, 1.0).unwrap(),
                BlobComponent::cylinder(Vec3::new(-0.9, 0.0, 0.2), Vec3::new(0.3, 0.5, 0.1), 0.6, 0.8)
                    .unwrap(),
            ];
            all.extend((0..n).map(|i| {
                BlobComponent::sphere(Vec3::new(50.0 + 3.0 * i as f64, 0.0, 0.0), 1.0, 1.0).unwrap()
            }));
            Blob::new(all, 0.4)
        };
        let (few, many, in_parts) = (near(0), near(20), near(100));
        assert!(many.window == 0.0 && in_parts.window > 0.0);
        let mut random = crate::shape::conformance::Random::new(3);
        for _ in 0..500 {
            let ray = Ray::new(4.0 * random.direction(), random.direction());
            let t = |b: &Blob| b.nearest(&ray, Range::new(0.0, 10.0)).map(|c| c.t);
            for other in [&many, &in_parts] {
                match (t(&few), t(other)) {
                    (Some(a), Some(b)) => assert!((a - b).abs() < 1e-10, "{a} {b} {ray:?}"),
                    (a, b) => assert_eq!(a, b),
                }
            }
            let all = |b: &Blob| {
                let mut out = Vec::new();
                b.crossings(&ray, Range::new(0.0, 10.0), &mut out);
                out.len()
            };
            assert_eq!(all(&few), all(&in_parts));
            let p = random.direction();
            assert_eq!(few.contains(p), many.contains(p));
        }
    }

    /// The box is as narrow as one sphere's surface, and no point inside many components is left out of it.
    #[test]
    fn the_box_is_around_the_surface() {
        let ball = |center, radius, strength| BlobComponent::sphere(center, radius, strength).unwrap();
        let one = Blob::new(vec![ball(Vec3::new(1.0, 2.0, 3.0), 2.0, 1.0)], 0.5);
        let half = 2.0 * (1.0 - 0.5f64.sqrt()).sqrt();
        assert!((one.bounds().max - Vec3::new(1.0, 2.0, 3.0) - half).abs().max_element() < 1e-5);
        assert!(one.bounds().max.x >= 1.0 + half && one.extent().max.x >= 3.0);
        assert!(Blob::new(vec![ball(Vec3::ZERO, 1.0, 1.0)], 1.5).bounds().is_empty());
        let mut random = crate::shape::conformance::Random::new(8);
        let (mut inside, mut smaller) = (0, 0);
        for _ in 0..50 {
            let mut any = |_| {
                let (a, b) = (random.direction(), random.direction());
                let (radius, strength) = (0.2 + random.unit(), 2.0 * random.unit() - 0.5);
                let turn = Transform::rotate(180.0 * b).then(&Transform::scale(Vec3::new(0.7, 1.3, 1.0)));
                BlobComponent::cylinder(a, b, radius, strength).map(|c| c.transformed(&turn))
            };
            let blob = Blob::new((0..6).filter_map(&mut any).collect(), 0.4);
            smaller += usize::from(blob.bounds().size().cmplt(0.9 * blob.extent().size()).any());
            for _ in 0..400 {
                let p = random.in_box(&Aabb::new(Vec3::splat(-2.5), Vec3::splat(2.5)));
                let is_in = blob.contains(p);
                assert!(!is_in || blob.bounds().contains(p), "{p}");
                inside += usize::from(is_in);
            }
        }
        assert!(inside > 300 && smaller > 40, "{inside} {smaller}");
    }

    #[test]
    fn a_negative_component_cuts() {
        let blob = Blob::new(
            vec![
                BlobComponent::sphere(Vec3::ZERO, 1.0, 2.0).unwrap(),
                BlobComponent::sphere(Vec3::ZERO, 0.5, -4.0).unwrap(),
            ],
            0.5,
        );
        let mut out = Vec::new();
        blob.crossings(&Ray::new(-3.0 * Vec3::Z, Vec3::Z), Range::FORWARD, &mut out);
        assert_eq!(out.len(), 4);
        assert!(!blob.contains(Vec3::ZERO) && blob.contains(0.45 * Vec3::X));
    }
}
