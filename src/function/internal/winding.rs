//! Helices and spirals around the y axis.

use super::super::number::{Number, Unary};
use super::solid::off_axis;
use super::{Arguments, rows};
use std::f64::consts::{PI, TAU};

rows! {
    24 helical_torus 10;
    25 helix1 7;
    26 helix2 7;
    64 spiral 6;
}

/// An angle in 0 .. 2π.
fn turn<N: Number>(angle: N) -> N {
    let rest = angle.rem(N::from(TAU));
    rest.choose(rest + TAU, rest, rest)
}

/// Distance in a cross-section from a diamond (exponent 2) over a circle (1) to a square (0).
fn section<N: Number>(u: N, v: N, shape: f64) -> N {
    if shape == 1.0 {
        (u.square() + v.square()).sqrt()
    } else if shape == 0.0 {
        u.abs().max(v.abs())
    } else {
        let e = N::from(2.0 / shape);
        (u.abs().pow(e) + v.abs().pow(e)).pow(N::from(shape / 2.0))
    }
}

fn helical_torus<N: Number>(a: &Arguments<N>) -> N {
    let p = a.p;
    let out = (a.x.square() + a.z.square()).sqrt();
    let around = off_axis(a.x, a.z, 1e-6).atan2(a.z);
    let radius = ((out - p[0]).square() + a.y.square()).sqrt();
    let across = (out - p[0]).atan2(a.y);
    let bend = turn(around * p[1] + across * p[2]) - PI;
    let groove = (bend * p[8]).atan2(radius - p[5]);
    let depth = (groove * p[7] + around * p[9]).cos() * p[3] + p[4];
    let strand = ((radius - p[5]).square() + bend.square() * p[6]).sqrt();
    -(p[4] + p[5] - p[0] - out).max(depth - strand.min(radius + p[5]))
}

fn helix1<N: Number>(a: &Arguments<N>) -> N {
    let p = a.p;
    let (Some(shape), Some(degrees)) = (p[5].known(), p[6].known()) else { return N::UNKNOWN };
    let out = (a.x.square() + a.z.square()).sqrt();
    let around = a.z.atan2(off_axis(a.x, a.z, 1e-6));
    let bend = turn(around * p[0] + a.y * p[1] * p[0]) - PI;
    let (mut u, mut v) = (out - p[3], bend / p[4] / (p[1] * p[0]));
    if shape != 1.0 && degrees != 0.0 {
        let (sin, cos) = degrees.unary(Unary::Radians).sin_cos();
        (u, v) = (u * cos - v * sin, u * sin + v * cos);
    }
    (p[3] + out).min(section(u, v, shape)) - p[2]
}

fn helix2<N: Number>(a: &Arguments<N>) -> N {
    let p = a.p;
    let Some(shape) = p[5].known() else { return N::UNKNOWN };
    let angle = a.y * p[1];
    let (sin, cos) = (angle.sin(), angle.cos());
    let (s, t) = (a.x - p[3] * cos, a.z - p[3] * sin);
    section(s * cos + t * sin, t * cos - s * sin, shape) - p[2]
}

fn spiral<N: Number>(a: &Arguments<N>) -> N {
    let p = a.p;
    let Some(shape) = p[5].known() else { return N::UNKNOWN };
    let x = off_axis(a.x, a.z, 1e-6);
    let r = a.r2().sqrt();
    let out = (a.x.square() + a.z.square()).sqrt() + p[0] * a.z.atan2(x) / TAU;
    let d = section(out.rem(p[0]) - p[0] * 0.5, a.y, shape);
    -(p[2] - r).min(p[1] - d.min(r))
}
