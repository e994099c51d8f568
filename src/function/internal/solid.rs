//! Distances and densities of solids, and coordinates.

use super::super::number::Number;
use super::{Arguments, rows};
use std::f64::consts::{FRAC_PI_6, PI, TAU};

rows! {
    6 blob 5;
    7 blob2 4;
    9 comma 1;
    10 cross_ellipsoids 4;
    17 ellipsoid 3;
    19 flange_cover 4;
    27 hex_x 1;
    28 hex_y 1;
    32 isect_ellipsoids 4;
    40 mesh1 5;
    47 ph 0;
    51 poly4 5;
    52 polytubes 6;
    53 quantum 1;
    57 r 0;
    60 rounded_box 4;
    61 sphere 1;
    62 spikes 5;
    63 spikes_2d 4;
    68 superellipsoid 2;
    69 th 0;
    70 torus 2;
}

/// x, or `instead` on the y axis, where directions around it mean nothing.
pub(super) fn off_axis<N: Number>(x: N, z: N, instead: f64) -> N {
    let inner = z.choose(x, N::from(instead), x);
    x.choose(x, inner, x)
}

fn blob<N: Number>(a: &Arguments<N>) -> N {
    let (half, one) = (a.p[0] * 0.5, N::from(1.0));
    let across = a.y.square() + a.z.square();
    let part = |x: N, radius: N, strength: N| {
        let d2 = ((x.square() + across) * radius.square()).min(one);
        strength * (one - d2).square()
    };
    -(part(a.x + half, a.p[2], a.p[1]) + part(a.x - half, a.p[4], a.p[3]))
}

fn blob2<N: Number>(a: &Arguments<N>) -> N {
    let across = a.y.square() + a.z.square();
    let part = |x: N| (-(a.p[1] * (x.square() + across))).exp();
    a.p[3] - a.p[2] * (part(a.x) + part(a.x - a.p[0]))
}

fn comma<N: Number>(a: &Arguments<N>) -> N {
    let (p, y2) = (a.p[0], a.y.square());
    let x = off_axis(a.x, a.z, 0.0001);
    let angle = a.z.atan2(x);
    let out = ((x + p * 0.25).square() + a.z.square()).sqrt();
    let tail = (angle * 0.5).cos() * p * 0.5 - ((out - p * 0.75).square() + y2).sqrt();
    let head = p * 0.5 - ((x - p * 0.5).square() + a.z.square() + y2).sqrt();
    -a.z.min(tail).max(head)
}

/// Three bells, each stretched across one axis by `p0`, with steepness `p1`.
fn ellipsoids<N: Number>(a: &Arguments<N>) -> [N; 3] {
    let ([x2, y2, z2], [p, steep]) = (a.squares(), [a.p[0], a.p[1]]);
    [p * x2 + p * y2 + z2, p * x2 + y2 + p * z2, x2 + p * y2 + p * z2].map(|r2| (-(steep * r2)).exp())
}

fn cross_ellipsoids<N: Number>(a: &Arguments<N>) -> N {
    let [e, f, g] = ellipsoids(a);
    a.p[3] - a.p[2] * e.max(f).max(g)
}

fn isect_ellipsoids<N: Number>(a: &Arguments<N>) -> N {
    let [e, f, g] = ellipsoids(a);
    a.p[3] - a.p[2] * e.min(f).min(g)
}

fn flange_cover<N: Number>(a: &Arguments<N>) -> N {
    let [e, f, g] = ellipsoids(a);
    a.p[3] - a.p[2] * (e + f + g)
}

fn spikes<N: Number>(a: &Arguments<N>) -> N {
    let [e, f, g] = ellipsoids(a);
    -(a.p[2] * (a.p[4] * (-(a.p[3] * a.r2())).exp() - e - f - g))
}

fn ellipsoid<N: Number>(a: &Arguments<N>) -> N {
    let [x2, y2, z2] = a.squares();
    (x2 * a.p[0].square() + y2 * a.p[1].square() + z2 * a.p[2].square()).sqrt()
}

/// The nearest centre's offset in a hexagonal lattice, and whether it lies towards the x axis (negative).
fn hexagon<N: Number>(a: &Arguments<N>) -> (N, N, N) {
    let (width, height) = (3f64.sqrt(), 3.0);
    let u = (a.x.abs().rem(N::from(width)) - width / 2.0).abs();
    let v = (a.y.abs().rem(N::from(height)) - height / 2.0).abs();
    let (s, t) = (-u + width / 2.0, -v + height / 2.0);
    let nearer = s.square() + t.square() - (u.square() + v.square());
    let (u, v) = (nearer.choose(s, u, u), nearer.choose(t, v, v));
    (u, v, v.atan2(u) - FRAC_PI_6)
}

fn hex_x<N: Number>(a: &Arguments<N>) -> N {
    let (u, v, side) = hexagon(a);
    let (sin, cos) = (PI / 3.0).sin_cos();
    let turned = u * cos + v * sin;
    side.choose(u, turned, turned)
}

fn hex_y<N: Number>(a: &Arguments<N>) -> N {
    let (u, v, side) = hexagon(a);
    let (sin, cos) = (PI / 3.0).sin_cos();
    let turned = (v * cos - u * sin).abs();
    side.choose(v, turned, turned)
}

fn mesh1<N: Number>(a: &Arguments<N>) -> N {
    let p = a.p;
    let rise = |w: N, period: N| {
        let span = period * 2.0;
        let rest = w.rem(span);
        (rest.choose(rest + span, rest, rest) - period).abs() * p[2]
    };
    let wave = |w: N, period: N| (w * PI / period).cos() * p[3];
    let thread = |t: N, q: N| -((q * p[4]).square() + t.square()).sqrt();
    let (along, across) = (wave(a.z, p[1]), wave(a.x, p[0]));
    let warp = thread(rise(a.x, p[0]), a.y - along).max(thread(rise(a.x - p[0], p[0]), a.y + along));
    let weft = thread(rise(a.z, p[1]), a.y + across).max(thread(rise(a.z - p[1], p[1]), a.y - across));
    -warp.max(weft)
}

/// The angle from the y axis.
fn ph<N: Number>(a: &Arguments<N>) -> N {
    (a.x.square() + a.z.square()).sqrt().atan2(a.y)
}

/// The angle around the y axis.
fn th<N: Number>(a: &Arguments<N>) -> N {
    a.x.atan2(a.z)
}

fn r<N: Number>(a: &Arguments<N>) -> N {
    a.r2().sqrt()
}

fn poly4<N: Number>(a: &Arguments<N>) -> N {
    let [c0, c1, c2, c3, c4] = [0, 1, 2, 3, 4].map(|i| a.p[i]);
    let radius = c0 + a.y * (c1 + a.y * (c2 + a.y * (c3 + a.y * c4)));
    (a.x.square() + a.z.square()).sqrt() - radius.max(N::from(-5.0))
}

fn polytubes<N: Number>(a: &Arguments<N>) -> N {
    /// The value where no tube is near.
    const FAR: f64 = 10_000.0;
    let Some(count) = a.p[0].known() else { return N::UNKNOWN };
    let [c1, c2, c3, c4, c5] = [1, 2, 3, 4, 5].map(|i| a.p[i]);
    let radius = c1 + a.y * (c2 + a.y * (c3 + a.y * (c4 + a.y * c5)));
    let mut nearest = N::from(FAR);
    let mut i = 0.0;
    while i < count.floor() {
        let (sin, cos) = (TAU * i / count).sin_cos();
        let d = ((a.x - radius * sin).square() + (a.z - radius * cos).square()).sqrt();
        nearest = nearest.min(d);
        i += 1.0;
    }
    nearest
}

fn quantum<N: Number>(a: &Arguments<N>) -> N {
    let x = off_axis(a.x, a.z, 1e-6);
    let r = (x.square() + a.y.square() + a.z.square()).sqrt();
    let (cos, s) = (a.y / r, r * 2.0);
    let t = s.square() * (s * -0.33333333).exp() * (cos.square() * 3.0 - 1.0);
    (t.square() - 12.0) * -0.1
}

fn rounded_box<N: Number>(a: &Arguments<N>) -> N {
    /// Thickness that the surface has beyond its rounding.
    const SKIN: f64 = 1e-6;
    let beyond = |v: N, half: N| (v.abs() - (half - a.p[0])).max(N::from(0.0)).square();
    let d2 = beyond(a.x, a.p[1]) + beyond(a.y, a.p[2]) + beyond(a.z, a.p[3]);
    d2.sqrt() - a.p[0] - SKIN
}

fn sphere<N: Number>(a: &Arguments<N>) -> N {
    a.r2().sqrt() - a.p[0]
}

fn spikes_2d<N: Number>(a: &Arguments<N>) -> N {
    let [x2, _, z2] = a.squares();
    a.y - a.p[0] * (a.p[1] * a.x).cos() * (a.p[2] * a.z).cos() * (-(a.p[3] * (x2 + z2))).exp()
}

fn superellipsoid<N: Number>(a: &Arguments<N>) -> N {
    let [east, north] = [a.p[0], a.p[1]];
    let two = N::from(2.0);
    let ring = a.x.abs().pow(two / east) + a.y.abs().pow(two / east);
    -(ring.pow(east / north) + a.z.abs().pow(two / north)).pow(north * 0.5) + 1.0
}

fn torus<N: Number>(a: &Arguments<N>) -> N {
    let out = (a.x.square() + a.z.square()).sqrt() - a.p[0];
    (out.square() + a.y.square()).sqrt() - a.p[1]
}
