//! Iteration of quaternions: square and cube.

use super::Fate;

pub(super) type Four = [f64; 4];

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Quaternions {
    pub c: Four,
    /// The cube instead of the square.
    pub cube: bool,
    /// Squared size from which an iterate has escaped.
    pub limit: f64,
}

#[inline(always)]
fn squared([x, y, z, w]: Four) -> f64 {
    x * x + y * y + z * z + w * w
}

impl Quaternions {
    #[inline(always)]
    fn next(&self, [x, y, z, w]: Four) -> Four {
        let d = y * y + z * z + w * w;
        let (real, factor) =
            if self.cube { (x * (x * x - 3.0 * d), 3.0 * x * x - d) } else { (x * x - d, 2.0 * x) };
        [self.c[0] + real, self.c[1] + factor * y, self.c[2] + factor * z, self.c[3] + factor * w]
    }

    /// The transposed derivative of one iteration times a vector.
    fn pull_back(&self, [x, y, z, w]: Four, [a, b, c, e]: Four) -> Four {
        let d = y * y + z * z + w * w;
        let across = b * y + c * z + e * w;
        if self.cube {
            let diagonal = 3.0 * x * x - d;
            let radial = -6.0 * x * a - 2.0 * across;
            [
                3.0 * (x * x - d) * a + 6.0 * x * across,
                radial * y + diagonal * b,
                radial * z + diagonal * c,
                radial * w + diagonal * e,
            ]
        } else {
            let diagonal = 2.0 * x;
            [
                2.0 * (x * a + across),
                -2.0 * y * a + diagonal * b,
                -2.0 * z * a + diagonal * c,
                -2.0 * w * a + diagonal * e,
            ]
        }
    }

    pub fn stays(&self, mut z: Four, iterations: u32) -> bool {
        for _ in 0..iterations {
            if !(squared(z) <= self.limit) {
                return false;
            }
            z = self.next(z);
        }
        true
    }

    pub fn fate(&self, mut z: Four, iterations: u32) -> Fate {
        let degree: f64 = if self.cube { 3.0 } else { 2.0 };
        // Squared size of the product of all iterates so far, and of the power that the degree makes.
        let (mut product, mut power) = (1.0, 1.0);
        for _ in 0..iterations {
            let size = squared(z);
            if !(size <= self.limit) {
                let estimate = (size / product).sqrt() * size.ln() / power;
                return Fate::Outside(if estimate.is_finite() { 0.2 * estimate } else { 0.0 });
            }
            product *= if self.cube { size * size } else { size };
            power *= degree;
            z = self.next(z);
        }
        Fate::Inside
    }

    /// Whether a point stays, and by how much the squared size of its last iterate that is looked at exceeds
    /// the limit, as a logarithm; `None` if that is too far.
    pub fn border(&self, mut z: Four, iterations: u32) -> (bool, Option<f64>) {
        let mut stays = true;
        for i in 0..iterations {
            let size = squared(z);
            stays &= size <= self.limit;
            if i + 1 == iterations {
                let excess = (size / self.limit).ln();
                return (stays, excess.is_finite().then_some(excess));
            }
            if !(size < 1e60) {
                break;
            }
            z = self.next(z);
        }
        (stays, None)
    }

    /// The gradient of the last iterate's squared size.
    pub fn gradient(&self, z: Four, iterations: u32) -> Four {
        let mut orbit: smallvec::SmallVec<[Four; 32]> = smallvec::smallvec![z];
        let mut last = z;
        for _ in 0..iterations {
            last = self.next(last);
            // Beyond this the direction no longer changes, and numbers would overflow.
            if !(squared(last) < 1e100) {
                break;
            }
            orbit.push(last);
        }
        let mut g = orbit[orbit.len() - 1];
        for z in orbit[..orbit.len() - 1].iter().rev() {
            g = self.pull_back(*z, g);
            let size = squared(g).sqrt();
            if size > 0.0 && size.is_finite() {
                g = g.map(|v| v / size);
            }
        }
        g
    }

    #[cfg(test)]
    pub fn last_size(&self, mut z: Four, iterations: u32) -> f64 {
        for _ in 0..iterations {
            z = self.next(z);
        }
        squared(z)
    }
}
