//! Plane curves drawn in x and y, at will swept about the y axis.
//!
//! The last three parameters are: whether to sweep (above 0), the distance from the axis, and the angle in
//! degrees by which the curve is turned in its plane.

use super::super::number::{Number, Unary};
use super::{Arguments, rows};

rows! {
    0 algbr_cyl1 5;
    1 algbr_cyl2 5;
    2 algbr_cyl3 5;
    3 algbr_cyl4 5;
    15 devils_curve_2d 6;
    21 folium_surface_2d 6;
    34 kampyle_of_eudoxus_2d 6;
    39 lemniscate_of_gerono_2d 6;
    50 piriform_2d 7;
    67 strophoid_2d 7;
    75 witch_of_agnesi_2d 6;
}

/// The point in the curve's plane; the sweep's parameters are `p[first..]`.
fn plane<N: Number>(a: &Arguments<N>, first: usize) -> (N, N) {
    let [sweep, distance, degrees] = [a.p[first], a.p[first + 1], a.p[first + 2]];
    let out = (a.x.square() + a.z.square()).sqrt() - distance;
    let angle = degrees.unary(Unary::Radians);
    let (sin, cos) = (angle.sin(), angle.cos());
    let swept = (out * cos - a.y * sin, out * sin + a.y * cos);
    (sweep.choose(a.x, a.x, swept.0), sweep.choose(a.y, a.y, swept.1))
}

fn algbr_cyl1<N: Number>(a: &Arguments<N>) -> N {
    let (x, y) = plane(a, 2);
    -a.scaled_within(-(x.abs().powi(3) - x.square() + y.square()))
}

fn algbr_cyl2<N: Number>(a: &Arguments<N>) -> N {
    let (x, y) = plane(a, 2);
    let (x2, y2) = (x.square(), y.square());
    a.scaled_within(-(x2.square() * 2.0 - x2 * y * 3.0 + y2 - y2 * y * 2.0 + y2.square()))
}

fn algbr_cyl3<N: Number>(a: &Arguments<N>) -> N {
    let (x, y) = plane(a, 2);
    let (x2, y2) = (x.square(), y.square());
    a.scaled_within(-(x2.square() + x2 * y2 - x2 * y * 2.0 - x * y2 + y2))
}

fn algbr_cyl4<N: Number>(a: &Arguments<N>) -> N {
    let (x, y) = plane(a, 2);
    let (x2, y2) = (x.square(), y.square());
    a.scaled_within(-(x2.square() + y2.square() + x2 * y2 * 2.0 + x2 * y * 3.0 - y2 * y))
}

fn devils_curve_2d<N: Number>(a: &Arguments<N>) -> N {
    let (x, y) = plane(a, 3);
    let (x2, y2) = (x.square(), y.square());
    a.scaled(-(x2 * (x2 - a.p[1].square()) - y2 * (y2 - a.p[2].square())))
}

fn folium_surface_2d<N: Number>(a: &Arguments<N>) -> N {
    let (x, y) = plane(a, 3);
    let slope = a.p[2] - a.p[1] * 4.0;
    a.scaled(-(y.square() * (slope * x + 1.0) + x.square() * (a.p[2] + 1.0)))
}

fn kampyle_of_eudoxus_2d<N: Number>(a: &Arguments<N>) -> N {
    let (x, y) = plane(a, 3);
    let x2 = x.square();
    a.scaled(-(y.square() - a.p[2].square() * x2.square() + a.p[2].powi(3) * a.p[1] * x2))
}

fn lemniscate_of_gerono_2d<N: Number>(a: &Arguments<N>) -> N {
    let (x, y) = plane(a, 3);
    let (x2, c2) = (x.square(), a.p[2].square());
    a.scaled(-(y.square() - c2 * a.p[1].square() * x2 + c2 * x2.square()))
}

fn piriform_2d<N: Number>(a: &Arguments<N>) -> N {
    let (x, y) = plane(a, 4);
    let (x3, d2) = (x.powi(3), a.p[3].square());
    a.scaled(-(y.square() - a.p[1] * d2 * x3 - a.p[2] * d2 * x3 * x))
}

fn strophoid_2d<N: Number>(a: &Arguments<N>) -> N {
    let (x, y) = plane(a, 4);
    let (x2, d2) = (x.square(), a.p[3].square());
    a.scaled(-((a.p[2] - x) * y.square() - d2 * a.p[1] * x2 - d2 * x2 * x))
}

fn witch_of_agnesi_2d<N: Number>(a: &Arguments<N>) -> N {
    let (x, y) = plane(a, 3);
    a.scaled(-(a.p[1].square() * y + x.square() * y - a.p[2]))
}
