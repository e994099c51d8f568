//! Single against double precision in ray tests: `cargo bench --bench precision`.
//!
//! The same formulas in both precisions, one ray and one body after the other. Time is for one test; errors are those of
//! single precision with doubles for the truth, for a scene of size 1 whose middle is so far from the origin, and seen
//! from so far away.

use glint::math::Vec3;
use std::hint::black_box;
use std::time::Instant;

const BODIES: usize = 256;
const RAYS: usize = 256;
const REPEATS: usize = 7;

/// The three tests, for one kind of number.
macro_rules! tests {
    ($name:ident, $real:ty, $vector:ty) => {
        mod $name {
            pub type Real = $real;
            pub type V = $vector;

            /// Centre and radius. The half chord from the distance of the ray's line, which keeps its digits.
            #[inline(always)]
            pub fn sphere(o: V, d: V, body: &(V, V, V)) -> Real {
                let to = body.0 - o;
                let along = to.dot(d);
                let off = to - along * d;
                let radius = body.1.x;
                let square = radius * radius - off.dot(off);
                if square < 0.0 {
                    return Real::INFINITY;
                }
                let half = square.sqrt();
                let near = along - half;
                let t = if near > 0.0 { near } else { along + half };
                if t > 0.0 { t } else { Real::INFINITY }
            }

            /// Corner and two edges (Moeller and Trumbore 1997).
            #[inline(always)]
            pub fn triangle(o: V, d: V, body: &(V, V, V)) -> Real {
                let p = d.cross(body.2);
                let det = body.1.dot(p);
                if det == 0.0 {
                    return Real::INFINITY;
                }
                let inverse = 1.0 / det;
                let to = o - body.0;
                let u = to.dot(p) * inverse;
                let q = to.cross(body.1);
                let v = d.dot(q) * inverse;
                let t = body.2.dot(q) * inverse;
                if u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 { t } else { Real::INFINITY }
            }

            /// Least and greatest corner.
            #[inline(always)]
            pub fn cuboid(o: V, d: V, body: &(V, V, V)) -> Real {
                let inverse = d.recip();
                let (a, b) = ((body.0 - o) * inverse, (body.1 - o) * inverse);
                let near = a.min(b).max_element();
                let far = a.max(b).min_element();
                if near > far || far <= 0.0 {
                    return Real::INFINITY;
                }
                if near > 0.0 { near } else { far }
            }
        }
    };
}

tests!(single, f32, glam::Vec3);
tests!(aligned, f32, glam::Vec3A);
tests!(double, f64, glam::DVec3);

type Body = (Vec3, Vec3, Vec3);

/// Spheres, triangles and boxes of about 0.2 in a cube of size 1 around `center`, and rays that start so far away and
/// are aimed at them.
struct Bodies {
    name: &'static str,
    bodies: Vec<Body>,
    rays: Vec<(Vec3, Vec3)>,
}

/// A small generator, so that runs are alike.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

fn vector(random: &mut Random) -> Vec3 {
    Vec3::new(random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5)
}

fn bodies(name: &'static str, center: f64, away: f64) -> Bodies {
    let mut random = Random(1);
    let bodies = (0..BODIES)
        .map(|_| {
            let c = Vec3::splat(center) + vector(&mut random);
            match name {
                "sphere" => (c, Vec3::splat(0.1), Vec3::ZERO),
                "box" => (c - 0.1, c + 0.1, Vec3::ZERO),
                _ => (c, 0.3 * vector(&mut random), 0.3 * vector(&mut random)),
            }
        })
        .collect();
    let rays = (0..RAYS)
        .map(|_| {
            let target = Vec3::splat(center) + 0.8 * vector(&mut random);
            let dir = vector(&mut random).normalize();
            (target - away * dir, dir)
        })
        .collect();
    Bodies { name, bodies, rays }
}

/// Nanoseconds of one test: the least of some runs over all pairs.
fn nanoseconds<V: Copy>(
    rays: &[(V, V)],
    bodies: &[(V, V, V)],
    test: impl Fn(V, V, &(V, V, V)) -> f64,
) -> f64 {
    let run = || {
        let begun = Instant::now();
        for (o, d) in rays {
            let nearest = bodies.iter().map(|b| test(*o, *d, b)).fold(f64::INFINITY, f64::min);
            black_box(nearest);
        }
        begun.elapsed().as_secs_f64() * 1e9 / (rays.len() * bodies.len()) as f64
    };
    (0..REPEATS).map(|_| run()).fold(f64::INFINITY, f64::min)
}

macro_rules! times {
    ($kind:ident, $bodies:expr, $cast:ident) => {{
        let cast = |v: &Vec3| v.$cast();
        let rays: Vec<_> = $bodies.rays.iter().map(|(o, d)| (cast(o), cast(d))).collect();
        let list: Vec<_> = $bodies.bodies.iter().map(|(a, b, c)| (cast(a), cast(b), cast(c))).collect();
        match $bodies.name {
            "sphere" => nanoseconds(&rays, &list, |o, d, b| f64::from($kind::sphere(o, d, b))),
            "box" => nanoseconds(&rays, &list, |o, d, b| f64::from($kind::cuboid(o, d, b))),
            _ => nanoseconds(&rays, &list, |o, d, b| f64::from($kind::triangle(o, d, b))),
        }
    }};
}

/// Share of nearest hits that single precision finds on another body or not at all, and how far off the others are:
/// root mean square of the distance from the true point, in sizes of the scene.
fn errors(b: &Bodies) -> (f64, f64) {
    let (mut wrong, mut squares, mut right) = (0, 0.0, 0);
    for (o, d) in &b.rays {
        let nearest = |test: &dyn Fn(&Body) -> f64| {
            let all = b.bodies.iter().enumerate().map(|(i, body)| (test(body), i));
            all.fold((f64::INFINITY, usize::MAX), |a, c| if c.0 < a.0 { c } else { a })
        };
        let exact = nearest(&|body| match b.name {
            "sphere" => double::sphere(*o, *d, body),
            "box" => double::cuboid(*o, *d, body),
            _ => double::triangle(*o, *d, body),
        });
        let rough = nearest(&|(x, y, z)| {
            let body = (x.as_vec3(), y.as_vec3(), z.as_vec3());
            let (o, d) = (o.as_vec3(), d.as_vec3());
            f64::from(match b.name {
                "sphere" => single::sphere(o, d, &body),
                "box" => single::cuboid(o, d, &body),
                _ => single::triangle(o, d, &body),
            })
        });
        if exact.1 != rough.1 {
            wrong += 1;
        } else if exact.0.is_finite() {
            let point = o.as_vec3() + rough.0 as f32 * d.as_vec3();
            squares += (point.as_dvec3() - (*o + exact.0 * *d)).length_squared();
            right += 1;
        }
    }
    (f64::from(wrong) / b.rays.len() as f64, (squares / f64::from(right.max(1))).sqrt())
}

fn main() {
    println!(
        "| test | double, ns | single, ns | single, aligned, ns | single / double |\n|---|---|---|---|---|"
    );
    for name in ["sphere", "triangle", "box"] {
        let b = bodies(name, 0.0, 3.0);
        let (d, s, a) = (times!(double, b, clone), times!(single, b, as_vec3), times!(aligned, b, as_vec3a));
        println!("| {name} | {d:.2} | {s:.2} | {a:.2} | {:.2} |", s.min(a) / d);
    }
    println!(
        "\n| scene's middle at, seen from | sphere: wrong body, point off by | triangle | box |\n|---|---|---|---|"
    );
    for (center, away) in [(0.0, 3.0), (0.0, 1e2), (0.0, 1e4), (1e2, 3.0), (1e4, 3.0), (1e6, 3.0)] {
        let cells = ["sphere", "triangle", "box"].map(|name| {
            let (wrong, off) = errors(&bodies(name, center, away));
            format!("{:.1} %, {off:.1e}", 100.0 * wrong)
        });
        println!("| {center:.0}, {away:.0} | {} |", cells.join(" | "));
    }
}
