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

    pub fn is_identity(&self) -> bool {
        self.forward == DAffine3::IDENTITY
    }

    pub fn point(&self, p: Vec3) -> Vec3 {
        self.forward.transform_point3(p)
    }

    pub fn vector(&self, v: Vec3) -> Vec3 {
        self.forward.transform_vector3(v)
    }

    /// Takes a surface normal outward; not normalised.
    pub fn normal(&self, n: Vec3) -> Vec3 {
        self.inverse.matrix3.transpose() * n
    }

    pub fn inverse_point(&self, p: Vec3) -> Vec3 {
        self.inverse.transform_point3(p)
    }

    pub fn inverse_vector(&self, v: Vec3) -> Vec3 {
        self.inverse.transform_vector3(v)
    }

    /// Takes an outer surface normal inward; not normalised.
    pub fn inverse_normal(&self, n: Vec3) -> Vec3 {
        self.forward.matrix3.transpose() * n
    }

    /// The ray in inner space with unit direction, and the length that the direction had there: an inner
    /// distance divided by it is the outer distance.
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
