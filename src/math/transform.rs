use super::{Aabb, Ray, Vec3};
use glam::{DAffine3, DMat3};

/// An invertible affine map together with its inverse.
///
/// `forward` takes points of the inner space (an object's, a texture's) to the outer one (the world's).
/// The scene language writes transformations in order of application; [`Transform::then`] follows it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    pub forward: DAffine3,
    pub inverse: DAffine3,
}

impl Default for Transform {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl Transform {
    pub const IDENTITY: Transform = Transform { forward: DAffine3::IDENTITY, inverse: DAffine3::IDENTITY };

    pub fn translate(v: Vec3) -> Self {
        Self { forward: DAffine3::from_translation(v), inverse: DAffine3::from_translation(-v) }
    }

    /// Scaling along the axes; no component may be 0.
    pub fn scale(v: Vec3) -> Self {
        Self { forward: DAffine3::from_scale(v), inverse: DAffine3::from_scale(v.recip()) }
    }

    /// Rotation by `degrees.x` about x, then `degrees.y` about y, then `degrees.z` about z.
    ///
    /// In the left-handed axes (x right, y up, z away) a positive angle turns as the fingers of the left
    /// hand do when its thumb points along the axis: y towards z, z towards x, x towards y.
    pub fn rotate(degrees: Vec3) -> Self {
        let (sx, cx) = sin_cos_degrees(degrees.x);
        let (sy, cy) = sin_cos_degrees(degrees.y);
        let (sz, cz) = sin_cos_degrees(degrees.z);
        let rx = DMat3::from_cols(Vec3::X, Vec3::new(0.0, cx, sx), Vec3::new(0.0, -sx, cx));
        let ry = DMat3::from_cols(Vec3::new(cy, 0.0, -sy), Vec3::Y, Vec3::new(sy, 0.0, cy));
        let rz = DMat3::from_cols(Vec3::new(cz, sz, 0.0), Vec3::new(-sz, cz, 0.0), Vec3::Z);
        let m = rz * ry * rx;
        Self { forward: DAffine3::from_mat3(m), inverse: DAffine3::from_mat3(m.transpose()) }
    }

    /// Rotation by `radians` about the unit vector `axis`, in the sense of [`Transform::rotate`].
    pub fn rotate_axis(axis: Vec3, radians: f64) -> Self {
        let m = DMat3::from_axis_angle(axis, radians);
        Self { forward: DAffine3::from_mat3(m), inverse: DAffine3::from_mat3(m.transpose()) }
    }

    /// From the scene language's twelve numbers, written for row vectors: `p' = p * M`, the last three
    /// being the translation. `None` if the matrix is singular.
    pub fn from_rows(m: [f64; 12]) -> Option<Self> {
        let row = |i: usize| Vec3::new(m[3 * i], m[3 * i + 1], m[3 * i + 2]);
        Self::from_affine(DAffine3::from_cols(row(0), row(1), row(2), row(3)))
    }

    /// `None` if `forward` is singular or not finite.
    pub fn from_affine(forward: DAffine3) -> Option<Self> {
        let inverse = forward.inverse();
        (forward.is_finite() && inverse.is_finite()).then_some(Self { forward, inverse })
    }

    /// First `self`, then `next`.
    pub fn then(&self, next: &Transform) -> Self {
        if self.is_identity() {
            return *next;
        }
        if next.is_identity() {
            return *self;
        }
        Self { forward: next.forward * self.forward, inverse: self.inverse * next.inverse }
    }

    pub fn inverted(&self) -> Self {
        Self { forward: self.inverse, inverse: self.forward }
    }

    #[inline]
    pub fn is_identity(&self) -> bool {
        self.forward == DAffine3::IDENTITY
    }

    #[inline]
    pub fn point(&self, p: Vec3) -> Vec3 {
        self.forward.transform_point3(p)
    }

    #[inline]
    pub fn vector(&self, v: Vec3) -> Vec3 {
        self.forward.transform_vector3(v)
    }

    /// Takes a surface normal outward; not normalised.
    #[inline]
    pub fn normal(&self, n: Vec3) -> Vec3 {
        self.inverse.matrix3.transpose() * n
    }

    #[inline]
    pub fn inverse_point(&self, p: Vec3) -> Vec3 {
        self.inverse.transform_point3(p)
    }

    #[inline]
    pub fn inverse_vector(&self, v: Vec3) -> Vec3 {
        self.inverse.transform_vector3(v)
    }

    /// Takes an outer surface normal inward; not normalised.
    #[inline]
    pub fn inverse_normal(&self, n: Vec3) -> Vec3 {
        self.forward.matrix3.transpose() * n
    }

    /// The ray in inner space with unit direction, and the length that the direction had there: an inner
    /// distance divided by it is the outer distance.
    #[inline(always)]
    pub fn inverse_ray(&self, ray: &Ray) -> (Ray, f64) {
        let dir = self.inverse_vector(ray.dir);
        let len = dir.length();
        (Ray::new(self.inverse_point(ray.origin), dir / len), len)
    }

    /// A box around the image of `b`. Infinite sides stay infinite where the map mixes them in.
    pub fn bounds(&self, b: &Aabb) -> Aabb {
        if self.is_identity() || b.is_empty() {
            return *b;
        }
        let m = self.forward.matrix3;
        let (mut lo, mut hi) = (self.forward.translation, self.forward.translation);
        for axis in 0..3 {
            for row in 0..3 {
                let factor = m.col(axis)[row];
                if factor == 0.0 {
                    continue;
                }
                let (a, c) = (factor * b.min[axis], factor * b.max[axis]);
                lo[row] += a.min(c);
                hi[row] += a.max(c);
            }
        }
        // Each side is a sum of four rounded products: widen by its rounding bound.
        let margin = |v: f64| if v.is_finite() { 8.0 * super::EPSILON * v.abs() } else { 0.0 };
        let reach: Vec3 = Vec3::from_array(std::array::from_fn(|row| {
            let mut sum = margin(self.forward.translation[row]);
            for axis in 0..3 {
                sum += margin(m.col(axis)[row] * b.min[axis]) + margin(m.col(axis)[row] * b.max[axis]);
            }
            if sum.is_finite() { sum } else { 0.0 }
        }));
        Aabb { min: lo - reach, max: hi + reach }
    }
}

/// Sine and cosine of an angle in degrees, exact at multiples of 90.
fn sin_cos_degrees(degrees: f64) -> (f64, f64) {
    let turn = degrees.rem_euclid(360.0);
    if turn == 0.0 {
        (0.0, 1.0)
    } else if turn == 90.0 {
        (1.0, 0.0)
    } else if turn == 180.0 {
        (0.0, -1.0)
    } else if turn == 270.0 {
        (-1.0, 0.0)
    } else {
        degrees.to_radians().sin_cos()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::strategy::vector;
    use proptest::prelude::*;

    /// Factors from 1/1000 to 1000, of either sign.
    fn factor() -> impl Strategy<Value = f64> {
        (-3.0..3.0f64, any::<bool>())
            .prop_map(|(e, negative)| if negative { -10f64.powf(e) } else { 10f64.powf(e) })
    }

    fn transform() -> impl Strategy<Value = Transform> {
        (vector(360.0), factor(), factor(), factor(), vector(1000.0)).prop_map(|(turn, a, b, c, shift)| {
            Transform::scale(Vec3::new(a, b, c))
                .then(&Transform::rotate(turn))
                .then(&Transform::translate(shift))
        })
    }

    proptest! {
        #[test]
        fn the_inverse_undoes(t in transform(), p in vector(100.0)) {
            let back = t.inverse_point(t.point(p));
            prop_assert!(back.distance(p) <= 1e-7 * (1.0 + p.length() + 1e3));
        }

        #[test]
        fn composition_applies_the_first_first(a in transform(), b in transform(), p in vector(10.0)) {
            let two = b.point(a.point(p));
            let one = a.then(&b).point(p);
            prop_assert!(one.distance(two) <= 1e-10 * (1.0 + two.length() + 1e6));
        }

        #[test]
        fn normals_stay_perpendicular(t in transform(), n in vector(1.0), v in vector(1.0)) {
            let tangent = n.cross(v);
            prop_assume!(n.length() > 0.1 && tangent.length() > 0.1);
            let (m, s) = (t.normal(n), t.vector(tangent));
            prop_assert!(m.dot(s).abs() <= 1e-9 * m.length() * s.length());
        }

        #[test]
        fn bounds_hold_every_transformed_point(t in transform(), a in vector(10.0), b in vector(10.0), k in vector(0.5)) {
            let bounds = Aabb::new(a, b);
            let inside = bounds.center() + k * bounds.size();
            prop_assert!(t.bounds(&bounds).contains(t.point(inside)));
        }

        #[test]
        fn a_ray_meets_the_same_points(t in transform(), o in vector(10.0), d in vector(1.0), s in 0.0..100.0f64) {
            prop_assume!(d.length() > 0.1);
            let ray = Ray::new(o, d.normalize());
            let (local, length) = t.inverse_ray(&ray);
            let (here, there) = (ray.at(s), t.point(local.at(s * length)));
            prop_assert!(here.distance(there) <= 1e-8 * (1.0 + s + 1e3 * 1e3));
            prop_assert!((local.dir.length() - 1.0).abs() < 1e-14);
        }
    }

    #[test]
    fn rotations_turn_as_the_language_says() {
        let turn = |v: Vec3, by: Vec3| Transform::rotate(by).point(v);
        assert_eq!(turn(Vec3::X, 90.0 * Vec3::Z), Vec3::Y);
        assert_eq!(turn(Vec3::X, 90.0 * Vec3::Y), -Vec3::Z);
        assert_eq!(turn(Vec3::Y, 90.0 * Vec3::X), Vec3::Z);
        let r = turn(Vec3::new(1.0, 2.0, 3.0), Vec3::new(30.0, 40.0, 50.0));
        assert!(r.distance(Vec3::new(1.801281062, 2.507690147, 2.113498678)) < 1e-8);
        let axis = Vec3::ONE.normalize();
        let r = Transform::rotate_axis(axis, 40f64.to_radians()).point(Vec3::new(1.0, 2.0, 3.0));
        assert!(r.distance(Vec3::new(1.605069156, 1.257772801, 3.137158043)) < 1e-8);
    }

    #[test]
    fn matrices_are_written_for_row_vectors() {
        let m = Transform::from_rows([1., 2., 3., 4., 5., 6., 7., 8., 10., 11., 12., 13.]).expect("regular");
        assert!(m.point(Vec3::new(1.0, 2.0, 3.0)).distance(Vec3::new(41.0, 48.0, 58.0)) < 1e-12);
        assert!(Transform::from_rows([1., 2., 3., 2., 4., 6., 7., 8., 10., 0., 0., 0.]).is_none());
    }

    #[test]
    fn infinite_boxes_stay_infinite_only_where_they_are_mixed_in() {
        let slab = Aabb {
            min: Vec3::new(f64::NEG_INFINITY, 0.0, f64::NEG_INFINITY),
            max: Vec3::new(f64::INFINITY, 1.0, f64::INFINITY),
        };
        let turned = Transform::rotate(90.0 * Vec3::Z).bounds(&slab);
        assert!(turned.min.x.is_finite() && turned.max.x.is_finite());
        assert!(turned.min.y.is_infinite() && turned.max.y.is_infinite());
    }
}
