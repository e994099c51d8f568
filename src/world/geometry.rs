//! Leaves and their combinations, and how rays and points meet them.

use super::accel::{Accel, Finite};
use super::ball::{Ball, Met};
use super::compound::Compound;
use super::hit::{InteriorId, RayClass};
use super::placement::Placement;
use super::probe::Probe;
use super::scratch::{Lists, with_lists};
use super::sight::Sight;
use crate::math::{Aabb, Accelerator, Range, Ray, Vec3};
use crate::shape::{Chord, Crossing, Plane, Shape};
use std::sync::Arc;

/// No surface, no cutaway: an index that is never given out.
pub(super) const NONE: u32 = u32::MAX;

/// One shape where it stands.
#[derive(Debug)]
pub(super) struct Leaf {
    pub shape: Arc<dyn Shape>,
    /// Takes the shape's space to the world; `None` if they are the same.
    pub place: Option<Arc<Placement>>,
    pub surface: u32,
    pub interior_surface: u32,
    /// First of the parts' surfaces in `World::part_surfaces`.
    pub parts: u32,
    /// Whether there are any.
    pub has_parts: bool,
    /// Index into `World::shadings`.
    pub shading: u32,
    /// The compound whose children's textures show where this leaf cuts it.
    pub cutaway: u32,
    pub interior: InteriorId,
    /// Inside and outside are exchanged.
    pub inverted: bool,
}

/// A leaf or a combination, by number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Solid {
    Leaf(u32),
    Compound(u32),
}

/// A top-level object: what the tree holds.
#[derive(Debug)]
pub(super) struct Root {
    pub solid: Solid,
    pub interior: InteriorId,
    /// A bit per [`RayClass`] that does not see it.
    pub hidden: u8,
    /// Blocks light wherever it is hit.
    pub opaque: bool,
}

/// A crossing of some leaf.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    /// World distance.
    pub t: f64,
    pub leaf: u32,
    /// The place in `Geometry::balls` of what was hit, if it is there.
    pub ball: u32,
    /// As the shape reported it, `t` in its own units.
    pub crossing: Crossing,
}

impl Found {
    #[inline]
    pub fn new(t: f64, leaf: u32, crossing: Crossing) -> Found {
        Found { t, leaf, ball: NONE, crossing }
    }

    /// A crossing that has no surface parameters.
    #[inline]
    pub fn on_part(t: f64, leaf: u32, local: f64, part: u32) -> Found {
        Found::new(t, leaf, Crossing::on_part(local, part))
    }
}

/// All geometry of a world, or of one object that a scene asks about while it is read.
#[derive(Debug, Default)]
pub(super) struct Geometry {
    pub leaves: Vec<Leaf>,
    pub compounds: Vec<Compound>,
    pub roots: Vec<Root>,
    /// Bounds of each root.
    pub root_bounds: Vec<Aabb>,
    /// Over the finite roots, by place in `finite`.
    pub search: Finite,
    pub finite: Vec<Item>,
    pub infinite: Vec<Item>,
    /// What the infinite roots are that are planes standing as they were made.
    pub planes: Vec<Option<Plane>>,
    /// The finite roots by place once more, if most of them are spheres: a ray that misses one touches
    /// nothing else of it.
    pub balls: Vec<Ball>,
}

/// A root as rays look at it first.
#[derive(Clone, Copy, Debug)]
pub(super) struct Item {
    pub root: u32,
    pub solid: Solid,
    /// As in [`Root`].
    pub hidden: u8,
    /// Stops light and casts shadows.
    pub shades: bool,
}

impl Root {
    /// Whether it stops light and casts shadows.
    fn casts_shadow(&self) -> bool {
        self.opaque && self.hidden & RayClass::Shadow.bit() == 0
    }
}

impl Item {
    fn new(index: u32, root: &Root) -> Item {
        Item { root: index, solid: root.solid, hidden: root.hidden, shades: root.casts_shadow() }
    }

    /// Whether asking it takes longer than its box.
    pub fn is_slow(&self) -> bool {
        matches!(self.solid, Solid::Compound(_))
    }
}

/// The best crossing so far, the root that it belongs to, and the bit of roots that are not seen.
pub(super) struct Nearest {
    pub found: Option<Found>,
    root: u32,
    hidden: u8,
}

impl Nearest {
    pub fn of(class: RayClass) -> Nearest {
        Nearest { found: None, root: NONE, hidden: class.bit() }
    }

    /// Takes the crossing of a root that `nearest` finds, if it is nearer; the new end of the range.
    #[inline]
    pub fn ask(&mut self, item: &Item, range: Range, nearest: impl FnOnce(Range) -> Option<Found>) -> f64 {
        if item.hidden & self.hidden != 0 {
            return range.max;
        }
        let limit = if item.root < self.root { range.max.next_up() } else { range.max };
        match nearest(Range::new(range.min, limit)) {
            Some(found) => {
                self.found = Some(found);
                self.root = item.root;
                found.t.min(range.max)
            }
            None => range.max,
        }
    }

    /// Takes the crossing of a root that is a plane, if it is nearer; the new end of the range.
    #[inline]
    fn take_plane(&mut self, item: &Item, plane: &Plane, ray: &Ray, range: Range) -> f64 {
        let t = plane.along(ray);
        let limit = if item.root < self.root { range.max.next_up() } else { range.max };
        if Range::new(range.min, limit).contains(t) { self.take(item, NONE, t, range.max) } else { range.max }
    }

    /// Takes the crossing of the ball at a place, at a distance of at most `max`, if it counts; the new end of the
    /// range. Its distance in the shape's units is not worked out yet.
    #[inline]
    fn take(&mut self, item: &Item, ball: u32, t: f64, max: f64) -> f64 {
        let Solid::Leaf(leaf) = item.solid else { return max };
        if item.hidden & self.hidden != 0 || (t == max && item.root >= self.root) {
            return max;
        }
        self.found = Some(Found { t, leaf, ball, crossing: Crossing::new(t) });
        self.root = item.root;
        t
    }
}

impl Geometry {
    /// Sorts the roots into finite and infinite ones and makes the finite ones ready for rays.
    pub fn finish(&mut self, accel: Accel) {
        for (i, (root, b)) in self.roots.iter().zip(&self.root_bounds).enumerate() {
            if b.is_empty() {
                continue;
            }
            let item = Item::new(i as u32, root);
            if b.is_finite() { self.finite.push(item) } else { self.infinite.push(item) }
        }
        self.planes = self.infinite.iter().map(|i| self.half_space(i).map(Plane::of_half_space)).collect();
        let boxes: Vec<Aabb> = self.finite.iter().map(|item| self.root_bounds[item.root as usize]).collect();
        let slow = |i: usize| self.finite[i].is_slow();
        self.search = Finite::new(accel, &boxes, slow);
        if let Finite::Tree(tree) = &mut self.search {
            self.finite = tree.order().iter().map(|&i| self.finite[i as usize]).collect();
            tree.take_order();
        }
        let is_sphere = |item: &&Item| self.ball(item.solid).is_some();
        let spheres = self.finite.iter().filter(is_sphere).count();
        if !matches!(self.search, Finite::List(_)) && 2 * spheres >= self.finite.len() {
            self.balls = self.finite.iter().map(|item| self.ball(item.solid).unwrap_or(Ball::NONE)).collect();
        }
        if let Finite::Tree(tree) = &mut self.search {
            if self.balls.is_empty() { tree.set_rows(&self.finite, 1) } else { tree.set_rows(&self.balls, 1) }
        }
    }

    fn ball(&self, solid: Solid) -> Option<Ball> {
        let Solid::Leaf(i) = solid else { return None };
        let leaf = &self.leaves[i as usize];
        Ball::new(leaf.shape.as_ref(), leaf.place.as_deref())
    }

    /// The nearest crossing among the roots that `class` sees. Of equal distances the root that the scene
    /// names first counts.
    pub fn nearest(&self, ray: &Ray, range: Range, class: RayClass) -> Option<Found> {
        let mut best = Nearest::of(class);
        self.find(&mut best, ray, range);
        best.found
    }

    /// The same where it is to stay: what is found is not copied while it is still being written.
    #[inline]
    pub fn find(&self, best: &mut Nearest, ray: &Ray, range: Range) {
        match &self.search {
            Finite::Tree(tree) => self.find_in_tree(tree, best, ray, range),
            _ => self.find_treeless(best, ray, range),
        }
    }

    #[inline(never)]
    fn find_in_tree(&self, tree: &impl Accelerator, best: &mut Nearest, ray: &Ray, range: Range) {
        // The compiler keeps one of its own in registers.
        let mut own = Nearest { found: None, ..*best };
        self.find_among(tree, None, &mut own, ray, range);
        *best = own;
    }

    /// Apart, so that trees' own way stays short.
    #[inline(never)]
    fn find_treeless(&self, best: &mut Nearest, ray: &Ray, range: Range) {
        match &self.search {
            Finite::Tree(_) => (),
            Finite::Grid(grid) => self.find_among(grid, None, best, ray, range),
            Finite::List(list) => self.find_among(list, None, best, ray, range),
        }
    }

    /// The same among `finite`, where `sight` may know more of the meshes.
    #[inline(always)]
    pub fn find_among(
        &self,
        finite: &impl Accelerator,
        sight: Option<&Sight>,
        best: &mut Nearest,
        ray: &Ray,
        range: Range,
    ) {
        let mut max = range.max;
        for (item, plane) in self.infinite.iter().zip(&self.planes) {
            max = match plane {
                Some(plane) => best.take_plane(item, plane, ray, Range::new(range.min, max)),
                None => self.nearer(best, item, ray, Range::new(range.min, max)),
            };
        }
        if self.finite.is_empty() {
            return;
        }
        let range = Range::new(range.min, max);
        if self.balls.is_empty() {
            finite.traverse(ray, range, |place, max| {
                let item = &self.finite[place as usize];
                best.ask(item, Range::new(range.min, max), |within| {
                    self.nearest_seen(sight, (place, item), ray, within)
                })
            });
        } else {
            finite.traverse(ray, range, |place, max| {
                let within = Range::new(range.min, max);
                let item = &self.finite[place as usize];
                match self.balls[place as usize].meet(ray, within) {
                    Met::Nothing => max,
                    Met::Sphere(t) => best.take(item, place, t, max),
                    Met::Perhaps => {
                        best.ask(item, within, |within| self.nearest_seen(sight, (place, item), ray, within))
                    }
                }
            });
        }
        if let Some(found) = &mut best.found
            && found.ball != NONE
        {
            self.measure_inside(found);
        }
    }

    /// Gives a ball's crossing its distance in the shape's units.
    #[inline]
    fn measure_inside(&self, found: &mut Found) {
        if let Some(place) = &self.leaves[found.leaf as usize].place {
            found.crossing.t = found.t * place.even_scale().unwrap_or(1.0);
        }
    }

    /// Takes a root into `best` if it is crossed nearer; the new end of the range.
    #[inline]
    pub fn nearer(&self, best: &mut Nearest, item: &Item, ray: &Ray, range: Range) -> f64 {
        best.ask(item, range, |within| self.nearest_of(item.solid, ray, within))
    }

    /// The roots that contain `p`, in scene order.
    pub fn roots_at(&self, p: Vec3) -> Vec<u32> {
        let mut found = Vec::new();
        let mut test = |item: &Item| {
            if self.contains(item.solid, p) {
                found.push(item.root);
            }
        };
        self.infinite.iter().for_each(&mut test);
        let in_place = |place: u32| {
            test(&self.finite[place as usize]);
            false
        };
        match &self.search {
            Finite::Tree(tree) => tree.any_at(p, in_place),
            Finite::Grid(grid) => grid.any_at(p, in_place),
            Finite::List(list) => list.any_at(p, in_place),
        };
        found.sort_unstable();
        found
    }

    #[inline]
    pub fn nearest_of(&self, solid: Solid, ray: &Ray, range: Range) -> Option<Found> {
        match solid {
            Solid::Leaf(i) => self.nearest_of_leaf(i, ray, range),
            Solid::Compound(i) => self.nearest_of_compound(i, ray, range),
        }
    }

    #[inline(never)]
    fn nearest_of_compound(&self, i: u32, ray: &Ray, range: Range) -> Option<Found> {
        with_lists(|lists| self.compounds[i as usize].nearest(self, &Probe::new(ray), range, lists))
    }

    /// The same inside a combination.
    pub fn nearest_with(
        &self,
        solid: Solid,
        probe: &Probe,
        range: Range,
        lists: &mut Lists,
    ) -> Option<Found> {
        match solid {
            Solid::Leaf(i) => self.nearest_of_leaf(i, probe.ray, range),
            Solid::Compound(i) => self.compounds[i as usize].nearest(self, probe, range, lists),
        }
    }

    /// Whether there is any crossing inside `range`.
    #[inline]
    pub fn meets(&self, solid: Solid, ray: &Ray, range: Range) -> bool {
        match solid {
            Solid::Leaf(i) => self.meets_leaf(i, ray, range),
            Solid::Compound(i) => self.meets_compound(i, ray, range),
        }
    }

    #[inline(never)]
    fn meets_compound(&self, i: u32, ray: &Ray, range: Range) -> bool {
        with_lists(|lists| self.compounds[i as usize].is_met(self, &Probe::new(ray), range, lists))
    }

    /// The same inside a combination.
    pub fn is_met(&self, solid: Solid, probe: &Probe, range: Range, lists: &mut Lists) -> bool {
        match solid {
            Solid::Leaf(i) => self.meets_leaf(i, probe.ray, range),
            Solid::Compound(i) => self.compounds[i as usize].is_met(self, probe, range, lists),
        }
    }

    #[inline]
    fn meets_leaf(&self, index: u32, ray: &Ray, range: Range) -> bool {
        let leaf = &self.leaves[index as usize];
        match &leaf.place {
            None => leaf.shape.meets(ray, range),
            Some(place) => {
                let (local, length) = place.inverse_ray(ray);
                leaf.shape.meets(&local, range.scaled(length))
            }
        }
    }

    #[inline]
    fn nearest_of_leaf(&self, index: u32, ray: &Ray, range: Range) -> Option<Found> {
        let leaf = &self.leaves[index as usize];
        match &leaf.place {
            None => {
                let crossing = leaf.shape.nearest(ray, range)?;
                Some(Found::new(crossing.t, index, crossing))
            }
            Some(place) => {
                let (local, length) = place.inverse_ray(ray);
                let crossing = leaf.shape.nearest(&local, range.scaled(length))?;
                Some(Found::new(crossing.t / length, index, crossing))
            }
        }
    }

    /// See [`Shape::chord`]: in the shape's units, and how many of them are one of the world's.
    #[inline]
    pub fn chord(&self, solid: Solid, ray: &Ray, range: Range) -> Option<(Chord, f64)> {
        let Solid::Leaf(i) = solid else { return None };
        let leaf = &self.leaves[i as usize];
        let (mut chord, length) = match &leaf.place {
            None => (leaf.shape.chord(ray, range)?, 1.0),
            Some(place) => {
                let (local, length) = place.inverse_ray(ray);
                (leaf.shape.chord(&local, range.scaled(length))?, length)
            }
        };
        chord.beyond ^= leaf.inverted;
        Some((chord, length))
    }

    /// Appends every crossing inside `range` to `lists.found`, children in order.
    pub fn crossings(&self, solid: Solid, probe: &Probe, range: Range, lists: &mut Lists) {
        match solid {
            Solid::Leaf(i) => self.crossings_of_leaf(i, probe.ray, range, lists),
            Solid::Compound(i) => self.compounds[i as usize].crossings(self, probe, range, lists),
        }
    }

    fn crossings_of_leaf(&self, index: u32, ray: &Ray, range: Range, lists: &mut Lists) {
        let leaf = &self.leaves[index as usize];
        let Lists { found, crossings } = lists;
        crossings.clear();
        match &leaf.place {
            None => {
                leaf.shape.crossings(ray, range, crossings);
                found.extend(crossings.iter().map(|&crossing| Found::new(crossing.t, index, crossing)));
            }
            Some(place) => {
                let (local, length) = place.inverse_ray(ray);
                leaf.shape.crossings(&local, range.scaled(length), crossings);
                let placed = |&crossing: &Crossing| Found::new(crossing.t / length, index, crossing);
                found.extend(crossings.iter().map(placed));
            }
        }
    }

    /// Whether this is one shape as it is. Of inverted ones the points on both sides of a face count as outside,
    /// so that rays along the face would seem to stay outside.
    pub fn is_upright_leaf(&self, solid: Solid) -> bool {
        matches!(solid, Solid::Leaf(i) if !self.leaves[i as usize].inverted)
    }

    pub fn contains(&self, solid: Solid, p: Vec3) -> bool {
        match solid {
            Solid::Leaf(i) => {
                let leaf = &self.leaves[i as usize];
                let local = leaf.place.as_ref().map_or(p, |t| t.inverse_point(p));
                leaf.shape.contains(local) != leaf.inverted
            }
            Solid::Compound(i) => self.compounds[i as usize].contains(self, p),
        }
    }

    /// World point, error bound, local point and unit world normal of a crossing.
    #[inline]
    pub fn locate(&self, ray: &Ray, found: &Found) -> Located {
        let leaf = &self.leaves[found.leaf as usize];
        let sign = if leaf.inverted { -1.0 } else { 1.0 };
        let Some(place) = &leaf.place else {
            let at = match self.balls.get(found.ball as usize) {
                Some(ball) => ball.at(ray, found.t),
                None => leaf.shape.at(ray, &found.crossing),
            };
            let normal = sign * at.normal;
            let face = at.face.map_or(normal, |f| sign * f);
            return Located { point: at.point, error: at.error, local: at.point, normal, face };
        };
        let (local_ray, _) = place.inverse_ray(ray);
        let at = leaf.shape.at(&local_ray, &found.crossing);
        let normal = sign * place.normal(at.normal);
        let face = at.face.map_or(normal, |f| sign * place.normal(f));
        let local = at.point;
        let (point, error) = place.point(local, at.error, face);
        Located { point, error, local, normal, face }
    }
}

/// Where a crossing is.
pub(super) struct Located {
    pub point: Vec3,
    pub error: f64,
    pub local: Vec3,
    pub normal: Vec3,
    pub face: Vec3,
}
