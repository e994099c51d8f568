use super::sphere::sphere_span;
use super::{Crossing, Cuboid, Shape, Sphere};
use crate::math::{Aabb, Range, Ray, Vec3};

/// `contained_by`: the region in which a surface given by functions is looked for.
#[derive(Clone, Debug, PartialEq)]
pub enum Container {
    Box(Cuboid),
    Sphere { center: Vec3, radius: f64 },
}

impl Default for Container {
    fn default() -> Self {
        Self::cuboid(Vec3::NEG_ONE, Vec3::ONE)
    }
}

impl Container {
    /// The box between two opposite corners.
    pub fn cuboid(a: Vec3, b: Vec3) -> Self {
        Self::Box(Cuboid::new(a, b))
    }

    pub fn sphere(center: Vec3, radius: f64) -> Self {
        Self::Sphere { center, radius: radius.abs() }
    }

    fn shape<T>(&self, of: impl FnOnce(&dyn Shape) -> T) -> T {
        match self {
            Container::Box(cuboid) => of(cuboid),
            Container::Sphere { center, radius } => of(&Sphere::new(*center, *radius)),
        }
    }

    /// Where a line enters and leaves.
    pub(super) fn ends(&self, ray: &Ray) -> Option<[Crossing; 2]> {
        match self {
            Container::Box(cuboid) => cuboid.ends(ray),
            Container::Sphere { center, radius } => {
                let (enter, leave) = sphere_span(ray.origin - *center, ray.dir, *radius)?;
                Some([Crossing::new(enter), Crossing::new(leave)])
            }
        }
    }

    pub fn bounds(&self) -> Aabb {
        self.shape(|s| s.bounds())
    }

    pub fn contains(&self, p: Vec3) -> bool {
        match self {
            Container::Box(cuboid) => cuboid.contains(p),
            Container::Sphere { center, radius } => {
                p.distance(*center) <= *radius * (1.0 + super::COINCIDENT)
            }
        }
    }

    /// The outward normal at a crossing of the container's surface.
    pub(super) fn normal(&self, p: Vec3, crossing: &Crossing) -> Vec3 {
        self.shape(|s| s.normal(p, crossing))
    }

    pub(super) fn locate(&self, ray: &Ray, crossing: &Crossing) -> (Vec3, f64) {
        self.shape(|s| s.locate(ray, crossing))
    }

    /// The part of `range` inside the container: its ends, and whether they are the container's.
    pub(super) fn clip(&self, ray: &Ray, range: Range) -> Option<Clip> {
        let [enter, leave] = self.ends(ray)?;
        let enters = enter.t > range.min;
        let leaves = leave.t < range.max;
        let from = if enters { enter.t } else { range.min };
        let to = if leaves { leave.t } else { range.max };
        (from < to).then_some(Clip {
            from,
            to,
            entry: enters.then_some(enter),
            exit: leaves.then_some(leave),
        })
    }
}

/// The part of a ray inside a container.
#[derive(Clone, Copy, Debug)]
pub(super) struct Clip {
    pub from: f64,
    pub to: f64,
    /// The crossings of the container's surface at the ends, if the range includes them.
    pub entry: Option<Crossing>,
    pub exit: Option<Crossing>,
}
