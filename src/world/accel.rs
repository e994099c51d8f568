//! Which structure finds the objects that a ray may meet.

use super::probe::{Probe, Reach};
use crate::math::bvh::{Bvh, Quality};
use crate::math::grid::Grid;
use crate::math::{Aabb, Accelerator, AnyHit, Range, Ray, Vec3};

/// What a scene's finite objects are kept in. Pictures do not depend on it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Accel {
    /// What is fastest for most scenes of so many objects.
    #[default]
    ByScene,
    /// A bounding volume hierarchy.
    Bvh,
    /// A uniform grid.
    Grid,
    /// A list, every object of which is asked.
    None,
}

/// With so few finite objects a tree costs more than it saves.
const TREE_FROM: usize = 4;

/// The finite objects made ready for rays, by number.
#[derive(Debug)]
pub(super) enum Finite {
    List(List),
    Tree(Bvh),
    Grid(Grid),
}

impl Default for Finite {
    fn default() -> Self {
        Finite::List(List::default())
    }
}

impl Finite {
    /// `slow` says of which objects asking takes longer than a box.
    pub fn new(accel: Accel, boxes: &[Aabb], slow: impl Fn(usize) -> bool) -> Finite {
        let few = boxes.len() < TREE_FROM;
        match accel {
            Accel::Bvh => Finite::Tree(Bvh::build(boxes, Quality::Best)),
            Accel::ByScene if !few => Finite::Tree(Bvh::build(boxes, Quality::Best)),
            Accel::Grid => Finite::Grid(Grid::build(boxes)),
            Accel::ByScene | Accel::None => Finite::List(List::new(boxes, slow)),
        }
    }

    pub fn name(&self) -> &'static str {
        match self {
            Finite::List(_) => "none",
            Finite::Tree(_) => "bvh",
            Finite::Grid(_) => "grid",
        }
    }

    /// Nodes of a tree, cells of a grid.
    pub fn node_count(&self) -> usize {
        match self {
            Finite::List(_) => 0,
            Finite::Tree(tree) => tree.node_count(),
            Finite::Grid(grid) => grid.cell_count(),
        }
    }

    pub fn heap_bytes(&self) -> usize {
        match self {
            Finite::List(list) => list.heap_bytes(),
            Finite::Tree(tree) => tree.heap_bytes(),
            Finite::Grid(grid) => grid.heap_bytes(),
        }
    }
}

/// Nothing but a list. Objects that take longer than their boxes have these tested first.
#[derive(Debug, Default)]
pub(super) struct List {
    boxes: Vec<Option<Reach>>,
}

impl List {
    fn new(boxes: &[Aabb], slow: impl Fn(usize) -> bool) -> List {
        List { boxes: boxes.iter().enumerate().map(|(i, b)| slow(i).then(|| Reach::new(b))).collect() }
    }
}

impl AnyHit for List {
    #[inline]
    fn any(&self, ray: &Ray, range: Range, mut visit: impl FnMut(u32) -> bool) -> bool {
        if self.boxes.is_empty() {
            return false;
        }
        let probe = Probe::new(ray);
        let meets = |reach: &Reach| probe.meets(reach, range);
        self.boxes.iter().enumerate().any(|(i, reach)| reach.as_ref().is_none_or(meets) && visit(i as u32))
    }
}

impl Accelerator for List {
    #[inline]
    fn traverse(&self, ray: &Ray, range: Range, mut visit: impl FnMut(u32, f64) -> f64) {
        if self.boxes.is_empty() {
            return;
        }
        let probe = Probe::new(ray);
        let mut max = range.max;
        for (i, reach) in self.boxes.iter().enumerate() {
            let within = Range::new(range.min, max);
            if reach.as_ref().is_none_or(|reach| probe.meets(reach, within)) {
                max = visit(i as u32, max);
                if max <= range.min {
                    return;
                }
            }
        }
    }

    fn any_at(&self, _: Vec3, visit: impl FnMut(u32) -> bool) -> bool {
        (0..self.boxes.len() as u32).any(visit)
    }

    fn heap_bytes(&self) -> usize {
        size_of_val(&self.boxes[..])
    }
}
