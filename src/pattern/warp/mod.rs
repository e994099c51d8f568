//! Warps: they bend the space that a pattern is seen in.

mod black_hole;
mod cubic;
mod planar;
pub(crate) mod polar;
mod repeat;

pub use black_hole::{BlackHole, Repetition};
pub use planar::Planar;
pub use polar::{Polar, PolarKind};
pub use repeat::Repeat;

use crate::math::noise::Turbulence;
use crate::math::{Transform, Vec3};

#[derive(Clone, Debug, PartialEq)]
pub enum Warp {
    Transform(Transform),
    Turbulence(Turbulence),
    Repeat(Repeat),
    BlackHole(BlackHole),
    Polar(Polar),
    Planar(Planar),
    Cubic,
}

impl Warp {
    /// A point outside to the space within.
    #[inline]
    pub fn apply(&self, p: Vec3) -> Vec3 {
        match self {
            Warp::Transform(t) => t.inverse_point(p),
            Warp::Turbulence(turbulence) => turbulence.displace(p),
            Warp::Repeat(repeat) => repeat.apply(p),
            Warp::BlackHole(hole) => hole.apply(p),
            Warp::Polar(polar) => polar.apply(p),
            Warp::Planar(planar) => planar.apply(p),
            Warp::Cubic => cubic::apply(p),
        }
    }
}

/// The triple (u, v, w) laid out along the unit vector `o`; along z it stays as it is.
fn oriented(o: Vec3, (u, v, w): (f64, f64, f64)) -> Vec3 {
    if o == Vec3::Z {
        return Vec3::new(u, v, w);
    }
    Vec3::new(o.x * w + (o.y + o.z) * u, (o.x + o.z) * v - o.y * w, -o.x * u + o.y * v + o.z * w)
}
