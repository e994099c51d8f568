//! Directions of gather rays: a fixed table, or a Halton sequence that is dense like the cosine.

use super::table;
use crate::math::Vec3;
use std::f64::consts::TAU;

/// Directions over the hemisphere around +y, used again and again in order.
#[derive(Debug)]
pub(super) struct Directions(Vec<Vec3>);

impl Directions {
    /// A pool smaller than the table takes that many of its entries.
    pub fn new(pool: u32) -> Self {
        let pool = pool.max(1) as usize;
        let direction = if pool < table::COUNT { table::direction } else { halton_direction };
        Self((0..pool).map(direction).collect())
    }

    /// Direction number `i`, counted around.
    pub fn get(&self, i: usize) -> Vec3 {
        self.0[i % self.0.len()]
    }

    pub fn len(&self) -> usize {
        self.0.len()
    }
}

fn halton_direction(i: usize) -> Vec3 {
    let (square, angle) = (radical_inverse(i as u32 + 1, 2), TAU * radical_inverse(i as u32 + 1, 3));
    let r = square.sqrt();
    let (x, z) = (r * angle.cos(), r * angle.sin());
    Vec3::new(x, (1.0 - x * x - z * z).max(0.0).sqrt(), z)
}

fn radical_inverse(mut i: u32, base: u32) -> f64 {
    let (mut value, mut digit) = (0.0, 1.0);
    while i > 0 {
        digit /= f64::from(base);
        value += f64::from(i % base) * digit;
        i /= base;
    }
    value
}

/// Axes that take the hemisphere around +y to the one around a normal.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    x: Vec3,
    y: Vec3,
    z: Vec3,
}

impl Frame {
    pub fn new(normal: Vec3) -> Self {
        if normal.y > 0.999 {
            return Self { x: Vec3::X, y: Vec3::Y, z: Vec3::Z };
        }
        if normal.y < -0.999 {
            return Self { x: Vec3::NEG_X, y: Vec3::NEG_Y, z: Vec3::NEG_Z };
        }
        let helper = if normal.z.abs() > 0.9 { Vec3::Y } else { Vec3::Z };
        let x = normal.cross(helper).normalize();
        Self { x, y: normal, z: x.cross(normal).normalize() }
    }

    pub fn to_world(self, d: Vec3) -> Vec3 {
        d.x * self.x + d.y * self.y + d.z * self.z
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halton_directions_are_dense_like_the_cosine() {
        let directions = Directions::new(1600);
        let mean = (0..1600).map(|i| directions.get(i)).sum::<Vec3>() / 1600.0;
        assert!((mean - 2.0 / 3.0 * Vec3::Y).length() < 0.005, "{mean}");
    }

    #[test]
    fn frames_keep_angles() {
        let normal = Vec3::new(2.0, -1.0, 2.0) / 3.0;
        let d = Directions::new(100).get(17);
        let frame = Frame::new(normal);
        assert!((frame.to_world(d).dot(normal) - d.y).abs() < 1e-12);
        assert!((frame.to_world(d).length() - d.length()).abs() < 1e-12);
    }
}
