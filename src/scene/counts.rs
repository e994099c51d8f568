//! How many objects and lights a scene has, as POV-Ray's statistics count them.
//!
//! | what | counts as |
//! |------|-----------|
//! | union or light group at the top, neither clipped, bounded, inverted nor with `split_union off` | its members |
//! | any other object | one |
//! | object whose box has a volume above 2e10 | infinite |
//! | light, however deep | one light; those of light groups do not count |
//! | what a light looks like | an object, where there are at least three objects and lights |
//!
//! Measured with objects of all kinds. Boxes are Glint's own, some of which are tighter.

use super::{Body, CsgOp, LightSource, Object, Scene};
use crate::math::Aabb;
use crate::shape::common::{self, Member};

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    pub finite_objects: usize,
    pub infinite_objects: usize,
    pub light_sources: usize,
}

/// Boxes above this volume count as infinite.
const INFINITE_VOLUME: f64 = 2e10;

/// From so many objects and lights on lights are sorted by their bounds too.
const BOUNDING_FROM: usize = 3;

impl Counts {
    pub fn of(scene: &Scene) -> Counts {
        let mut top = Top::default();
        scene.objects.iter().for_each(|object| top.add(object, false));
        let mut counts = Counts { light_sources: top.global_lights, ..Counts::default() };
        top.objects.iter().for_each(|object| counts.add(object));
        if top.objects.len() + top.lights.len() >= BOUNDING_FROM {
            let bodies = top.lights.iter().filter_map(|light| light.looks_like.as_ref());
            bodies.for_each(|body| counts.add(body));
        }
        counts
    }

    fn add(&mut self, object: &Object) {
        if bounds(object).volume() <= INFINITE_VOLUME {
            self.finite_objects += 1;
        } else {
            self.infinite_objects += 1;
        }
    }
}

/// What stands at the top once unions are taken apart.
#[derive(Default)]
struct Top<'a> {
    objects: Vec<&'a Object>,
    lights: Vec<&'a LightSource>,
    /// Lights outside of groups, those inside combinations too.
    global_lights: usize,
}

impl<'a> Top<'a> {
    fn add(&mut self, object: &'a Object, in_group: bool) {
        match &object.body {
            Body::Light(light) => {
                self.lights.push(light);
                self.global_lights += usize::from(!in_group);
            }
            Body::Csg { op: op @ (CsgOp::Union | CsgOp::LightGroup { .. }), children }
                if is_split(object) =>
            {
                let in_group = in_group || matches!(op, CsgOp::LightGroup { .. });
                children.iter().for_each(|child| self.add(child, in_group));
            }
            _ => {
                self.global_lights += lights_in(object);
                self.objects.push(object);
            }
        }
    }
}

fn is_split(object: &Object) -> bool {
    object.clipped_by.is_empty()
        && object.bounded_by.is_empty()
        && !object.flags.inverse
        && object.flags.split_union != Some(false)
}

fn lights_in(object: &Object) -> usize {
    match &object.body {
        Body::Light(_) => 1,
        Body::Shape(_) => 0,
        Body::Csg { children, .. } => children.iter().map(|c| lights_in(c)).sum(),
    }
}

/// A box around the object, in the space around it, as the reference finds it; a light has none.
fn bounds(object: &Object) -> Aabb {
    let own = match &object.body {
        Body::Light(_) => return Aabb::INFINITE,
        Body::Shape(shape) if shape.has_extent() => shape.extent(),
        Body::Shape(_) => Aabb::INFINITE,
        Body::Csg { op: CsgOp::Difference, children } => {
            common(children.iter().enumerate().map(|(i, child)| (&**child, i > 0)))
        }
        Body::Csg { op: CsgOp::Intersection, children } => common(children.iter().map(|c| (&**c, false))),
        Body::Csg { children, .. } => children.iter().map(|c| bounds(c)).fold(Aabb::EMPTY, Aabb::union),
    };
    let outer = if own.is_finite() { object.transform.bounds(&own) } else { own };
    let limits = object.clipped_by.iter().chain(&object.bounded_by).filter(|l| !l.flags.inverse);
    let limited = limits.fold(outer, |b, limit| b.intersection(bounds(limit)));
    match member(object, false).filter(|m| m.shape.has_extent()) {
        Some(clipped) if !limited.is_finite() => {
            let clips = object.clipped_by.iter().filter_map(|clip| member(clip, false));
            common::aligned_bounds(&[clipped].into_iter().chain(clips).collect::<Vec<_>>(), limited)
        }
        _ => limited,
    }
}

/// A box around what objects have in common, some of them turned inside out. What is inverted, and no plane,
/// limits nothing.
fn common<'a>(objects: impl Iterator<Item = (&'a Object, bool)>) -> Aabb {
    let (mut own, mut members) = (Aabb::INFINITE, Vec::new());
    for (object, inverted) in objects {
        if inverted == object.flags.inverse {
            own = own.intersection(bounds(object));
        }
        members.extend(member(object, inverted));
    }
    let found = common::aligned_bounds(&members, own);
    if found.is_finite() { found } else { Aabb::INFINITE }
}

/// A shape that may narrow what it is combined with.
fn member(object: &Object, inverted: bool) -> Option<Member<'_>> {
    let Body::Shape(shape) = &object.body else { return None };
    let inverted = inverted != object.flags.inverse;
    Some(Member { shape: &**shape, place: &object.transform, inverted })
}

#[cfg(test)]
mod tests {
    use crate::interp::interpret_str;
    use crate::scene::Counts;

    fn counts(text: &str) -> [usize; 3] {
        let text = format!("#version 3.7; global_settings {{ assumed_gamma 1 }}\n{text}");
        let scene = interpret_str(&text).scene.unwrap_or_else(|e| panic!("{text}: {}", e.message));
        let c = Counts::of(&scene);
        [c.finite_objects, c.infinite_objects, c.light_sources]
    }

    /// As POV-Ray 3.7 counts them.
    #[test]
    fn objects_are_counted_as_the_reference_does() {
        for (text, expected) in [
            ("sphere{0,1} plane{y,0} light_source{1,1}", [1, 1, 1]),
            ("union{sphere{0,1} plane{y,0}}", [1, 1, 0]),
            ("union{union{sphere{0,1} box{0,1}} sphere{0,1}}", [3, 0, 0]),
            ("union{union{sphere{0,1} box{0,1} bounded_by{sphere{0,3}}} sphere{0,1}}", [2, 0, 0]),
            ("union{sphere{0,1} box{0,1} clipped_by{sphere{0,3}}}", [1, 0, 0]),
            ("union{sphere{0,1} box{0,1} inverse}", [1, 0, 0]),
            ("union{sphere{0,1} box{0,1} split_union off}", [1, 0, 0]),
            ("union{sphere{0,1} light_source{1,1}}", [1, 0, 1]),
            ("light_source{1,1 looks_like{sphere{0,1}}}", [0, 0, 1]),
            ("plane{y,0} light_source{1,1 looks_like{sphere{0,1}}}", [0, 1, 1]),
            ("sphere{0,1} plane{y,0} light_source{1,1 looks_like{sphere{0,1}}}", [2, 1, 1]),
            ("light_source{1,1} light_source{1,1} light_source{1,1 looks_like{sphere{0,1}}}", [1, 0, 3]),
            ("sphere{0,1} sphere{0,1} light_group{light_source{1,1 looks_like{sphere{0,1}}}}", [3, 0, 0]),
            ("light_group{union{sphere{0,1} box{0,1}} light_source{1,1}}", [2, 0, 0]),
            ("merge{sphere{0,1} box{0,1}}", [1, 0, 0]),
            ("intersection{plane{y,0} plane{x,0}}", [0, 1, 0]),
            ("intersection{plane{y,0} sphere{0,1}}", [1, 0, 0]),
            ("difference{sphere{0,1} plane{x,0}}", [1, 0, 0]),
            ("difference{plane{x,0} sphere{0,1}}", [0, 1, 0]),
            ("difference{box{0,1} light_source{1,1}}", [1, 0, 1]),
            ("merge{sphere{0,1} light_source{1,1}}", [0, 1, 1]),
            (
                "intersection{quadric{<1,-1,1>,0,0,-1} plane{y,2} plane{-y,2}} quadric{<1,-1,1>,0,0,-1}",
                [1, 1, 0],
            ),
            ("intersection{quadric{<1,-1,1>,0,0,-1} plane{y,2} plane{y,-2 inverse}}", [1, 0, 0]),
            ("intersection{quadric{<1,0,1>,0,<0,-1,0>,0} plane{y,2}}", [1, 0, 0]),
            ("intersection{quadric{<1,0,1>,0,0,-1} plane{y,2 rotate x*20} plane{-y,0}}", [0, 1, 0]),
            ("intersection{quadric{<1,0,1>,0,0,-1 inverse} plane{y,2} plane{-y,2}}", [0, 1, 0]),
            ("difference{quadric{<1,-1,1>,0,0,-1} plane{y,-2} plane{-y,-2}}", [1, 0, 0]),
            ("quadric{<1,-1,1>,0,0,-1 clipped_by{plane{y,2}} clipped_by{plane{-y,2}}}", [1, 0, 0]),
            ("intersection{sphere{0,1 inverse} plane{y,0}}", [0, 1, 0]),
            ("sphere{0,1 inverse}", [1, 0, 0]),
            ("intersection{plane{x+y+z,1} plane{-x,1} plane{-y,1} plane{-z,1}}", [0, 1, 0]),
            ("plane{y,0 bounded_by{sphere{0,1}}}", [1, 0, 0]),
            ("plane{y,0 clipped_by{sphere{0,1}}}", [1, 0, 0]),
            ("plane{y,0 clipped_by{plane{x,0}}}", [0, 1, 0]),
            ("box{0,<1,1,1.9e10>}", [1, 0, 0]),
            ("box{0,<1,1,2.1e10>}", [0, 1, 0]),
            ("box{0,<1e3,1e3,2.01e4>}", [0, 1, 0]),
            ("sphere{0,1100} sphere{0,3000}", [1, 1, 0]),
            ("sphere{0,1 scale 3000}", [0, 1, 0]),
            ("disc{0,y,1e4}", [1, 0, 0]),
            (
                "#declare A=union{sphere{0,1} light_source{x,1}} union{object{A} object{A translate x}}",
                [2, 0, 2],
            ),
        ] {
            assert_eq!(counts(text), expected, "{text}");
        }
    }
}
