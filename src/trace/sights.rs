//! What the camera's rays may meet, found once for all those through one small square of the picture. Only in
//! scenes with large trees. The same for shadow rays that come to one lamp out of one direction was measured: their
//! way starts among the leaves, where nothing is saved.

use crate::math::floor;
use crate::world::{Sight, World};

/// Side of a square of the picture, in pixels.
const SIDE: f64 = 8.0;
/// Squares along each side of the camera's table: those of one block, wherever it begins, and of its borders do not
/// displace each other.
const SQUARES: usize = 8;

/// A square with what is seen through it.
struct Square {
    /// Its column and row.
    place: Option<(i64, i64)>,
    /// Whether the sight says anything.
    useful: bool,
    sight: Sight,
}

/// Squares of the picture looked at of late.
pub(super) struct Sights {
    squares: Vec<Square>,
}

impl Sights {
    pub fn new(world: &World, size: (f64, f64)) -> Sights {
        let has_beams = world.scene.camera.beam([0.0, size.0], [0.0, size.1], size).is_some();
        let length = if has_beams && world.deserves_sights() { SQUARES * SQUARES } else { 0 };
        let mut squares = Vec::new();
        squares.resize_with(length, || Square { place: None, useful: false, sight: Sight::default() });
        Sights { squares }
    }

    /// What the camera's ray through (x, y) of a picture of `size` may meet, if anything is known about it.
    #[inline]
    pub fn at(&mut self, world: &World, (x, y): (f64, f64), size: (f64, f64)) -> Option<&Sight> {
        if self.squares.is_empty() {
            return None;
        }
        let place = (floor(x * (1.0 / SIDE)) as i64, floor(y * (1.0 / SIDE)) as i64);
        let within = |i: i64| i as usize % SQUARES;
        let square = &mut self.squares[within(place.1) * SQUARES + within(place.0)];
        if square.place != Some(place) {
            square.look(world, place, size);
        }
        square.useful.then_some(&square.sight)
    }
}

impl Square {
    #[inline(never)]
    fn look(&mut self, world: &World, place: (i64, i64), size: (f64, f64)) {
        let ends = |i: i64| [i as f64 * SIDE, (i + 1) as f64 * SIDE];
        self.place = Some(place);
        self.useful = world.scene.camera.beam(ends(place.0), ends(place.1), size).is_some_and(|beam| {
            world.look_along(&beam, &mut self.sight);
            self.sight.is_useful()
        });
    }
}

#[cfg(test)]
mod tests {
    use super::Sights;
    use crate::math::Range;
    use crate::trace::{Settings, Tracer};
    use crate::world::{Hit, RayClass, World};

    fn world(text: &str) -> World {
        let source = crate::interp::SceneSource::Text { name: "test".into(), text: text.into() };
        World::prepare(crate::interp::interpret(source, &Default::default()).scene.expect("a scene"))
    }

    /// Spheres and a mesh, turned and scaled, in front of a plane: rays of the camera meet the same with and without
    /// what is known of their squares, also between pixels and past the picture's edge.
    #[test]
    fn known_squares_show_the_same() {
        let cases = [
            ("", "", true),
            ("right -1.33 * x", "scale 0.5 rotate <10, 20, 30> translate <0.2, 0.1, 0>", true),
            ("right <1.2, 0.3, 0> up <0.2, 1, 0.1>", "scale <-1, 1, 1> rotate 40 * z", true),
            ("", "scale <1, 2, 1>", false),
        ];
        for (camera, mesh, has_cuts) in cases {
            let text = format!(
                "#version 3.7; camera {{ location <0.3, 1, -3> {camera} look_at 0 }} light_source {{ <3, 5, -4> 1 }}
                #declare R = seed(3);
                #for (I, 1, 200) sphere {{ <rand(R), rand(R), rand(R)> * 2 - 1, 0.05 }} #end
                plane {{ y, -1 }}
                mesh {{ #for (I, 1, 600) #local P = <rand(R), rand(R), rand(R)> * 2 - 1;
                  triangle {{ P, P + 0.2 * <rand(R), rand(R), rand(R)>, P + 0.2 * <rand(R), rand(R), rand(R)> }} #end
                  // Faces on each other.
                  #for (I, -8, 7) #for (K, 1, 3)
                    triangle {{ <I / 8, 0, 0>, <I / 8 + 0.3, 0, 0>, <I / 8, 0, K / 2> }} #end #end
                  {mesh} }}"
            );
            let world = world(&text);
            let context = Tracer::new(&world, &Settings::default()).context;
            let size = (64.0, 48.0);
            let mut sights = Sights::new(&world, size);
            let (mut hits, mut known, mut cuts) = (0, 0, 0);
            for i in 0..4000 {
                let place = (f64::from(i % 67) * 0.993 - 1.0, f64::from(i / 67) * 0.85 - 1.0);
                let Some(ray) = world.scene.camera.ray(place.0, place.1, size, &context) else { continue };
                let expected = world.nearest(&ray, Range::FORWARD, RayClass::Image);
                if let Some(sight) = sights.at(&world, place, size) {
                    cuts += sight.mesh_count();
                    let found = world.nearest_in_sight(sight, &ray, Range::FORWARD, RayClass::Image);
                    let told = |hit: Option<Hit>| hit.map(|hit| (hit.t, hit.item, hit.crossing));
                    hits += usize::from(found.is_some());
                    assert_eq!(told(found), told(expected), "{place:?}");
                    known += 1;
                }
            }
            assert!(hits > 1000 && known == 4000 && (cuts > 1000) == has_cuts, "{hits} {known} {cuts}");
        }
    }

    /// A few objects, or a camera whose rays bend: nothing is kept.
    #[test]
    fn small_scenes_have_no_squares() {
        for text in
            ["sphere { 0, 1 } sphere { 1, 1 }", "camera { spherical } #for (I, 1, 300) sphere { I, 1 } #end"]
        {
            let world = world(&format!("#version 3.7; {text}"));
            assert!(Sights::new(&world, (64.0, 48.0)).squares.is_empty());
        }
    }
}
