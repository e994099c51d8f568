use crate::math::Vec3;
use crate::math::noise::hash3;
use crate::math::random::{uniform, uniform_table};

/// Draws points within a sphere towards its centre, or pushes them away.
///
/// | parameter | default | meaning |
/// |---|---|---|
/// | centre, radius | | of the sphere |
/// | strength | 1 | how much |
/// | falloff | 2 | exponent of the decrease towards the rim |
/// | inverse | off | pushes |
/// | repeat | none | one sphere in each block of this size |
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlackHole {
    pub centre: Vec3,
    pub radius: f64,
    pub strength: f64,
    pub falloff: f64,
    pub inverse: bool,
    pub repeat: Option<Repetition>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Repetition {
    /// Size of a block; an axis with 0 does not repeat.
    pub block: Vec3,
    /// How far centres stray within their blocks.
    pub uncertainty: Vec3,
}

impl BlackHole {
    /// Moves the centre into its block, and widens blocks until the sphere fits.
    pub fn fit(&mut self) {
        let Some(repeat) = &mut self.repeat else { return };
        for axis in 0..3 {
            if repeat.block[axis] > 0.0 {
                self.centre[axis] = self.centre[axis].max(self.radius);
                let room = self.centre[axis] + self.radius + repeat.uncertainty[axis];
                repeat.block[axis] = repeat.block[axis].max(room);
            }
        }
    }

    fn centre_near(&self, p: Vec3) -> Vec3 {
        let Some(repeat) = &self.repeat else { return self.centre };
        let mut block = Vec3::ZERO;
        for axis in 0..3 {
            if repeat.block[axis] >= 1e-10 {
                block[axis] = (p[axis] / repeat.block[axis]).floor();
            }
        }
        let mut centre = self.centre + repeat.block * block;
        if repeat.uncertainty != Vec3::ZERO {
            let table = uniform_table();
            let s = hash3(block.x as i64, block.y as i64, block.z as i64);
            let random = Vec3::new(uniform(table, s), uniform(table, s + 1), uniform(table, s + 2));
            centre += repeat.uncertainty * random;
        }
        centre
    }

    pub fn apply(&self, p: Vec3) -> Vec3 {
        let delta = p - self.centre_near(p);
        let distance = delta.length();
        if distance >= self.radius {
            return p;
        }
        let pull = self.strength * ((self.radius - distance) / self.radius).powf(self.falloff);
        let pull = pull.min(1.0);
        if self.inverse { p - pull * delta } else { p + pull * delta }
    }
}
