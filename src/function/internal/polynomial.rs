//! Algebraic surfaces: `p0` times a polynomial, kept within -10 .. 10.

use super::super::number::Number;
use super::{Arguments, rows};
use std::f64::consts::SQRT_2;

rows! {
    4 bicorn 2;
    5 bifolia 2;
    8 boy_surface 2;
    11 crossed_trough 1;
    12 cubic_saddle 1;
    13 cushion 1;
    14 devils_curve 1;
    16 dupin_cyclid 6;
    18 enneper 1;
    20 folium_surface 3;
    22 glob 1;
    23 heart 1;
    30 hunt_surface 1;
    31 hyperbolic_torus 3;
    33 kampyle_of_eudoxus 3;
    35 klein_bottle 1;
    36 kummer_surface_v1 1;
    37 kummer_surface_v2 4;
    38 lemniscate_of_gerono 1;
    41 mitre 1;
    42 nodal_cubic 1;
    43 odd 1;
    44 ovals_of_cassini 4;
    45 paraboloid 1;
    46 parabolic_torus 3;
    48 pillow 1;
    49 piriform 1;
    54 quartic_paraboloid 1;
    55 quartic_saddle 1;
    56 quartic_cylinder 3;
    65 steiners_roman 1;
    66 strophoid 4;
    71 torus2 3;
    72 torus_gumdrop 1;
    73 umbrella 1;
    74 witch_of_agnesi 2;
}

fn bicorn<N: Number>(a: &Arguments<N>) -> N {
    let ([x2, y2, z2], p) = (a.squares(), a.p[1]);
    let q = p.square();
    a.scaled(y2 * (q - (x2 + z2)) - (x2 + z2 + p * a.y * 2.0 - q).square())
}

fn bifolia<N: Number>(a: &Arguments<N>) -> N {
    let [x2, _, z2] = a.squares();
    a.scaled(-(a.r2().square() - a.p[1] * (x2 + z2) * a.y))
}

fn boy_surface<N: Number>(a: &Arguments<N>) -> N {
    let [x2, y2, z2] = a.squares();
    let (x, y, z) = (a.x, a.y, a.z);
    let (b, u, z4) = (x2 + y2, -z + 1.0, z2.square() * 4.0);
    let outer = u.powi(3) * z2 * z * 64.0 - u.square() * z2 * (b * 3.0 + z2 * 2.0) * 48.0;
    let middle = b.square() * 27.0 - z2 * b * 24.0 + y * z * (y2 - x2 * 3.0) * (36.0 * SQRT_2) + z4;
    let inner = b.square() * -81.0 - z2 * b * 72.0 + x * z * (x2 - y2 * 3.0) * (108.0 * SQRT_2) + z4;
    a.scaled(a.p[1] * (outer + u * z * middle * 12.0 + (b * 9.0 - z2 * 2.0) * inner))
}

fn crossed_trough<N: Number>(a: &Arguments<N>) -> N {
    let [x2, _, z2] = a.squares();
    a.scaled(x2 * z2 - a.y)
}

fn cubic_saddle<N: Number>(a: &Arguments<N>) -> N {
    a.scaled(-(a.x.powi(3) - a.y.powi(3) - a.z))
}

fn cushion<N: Number>(a: &Arguments<N>) -> N {
    let ([x2, y2, z2], z) = (a.squares(), a.z);
    a.scaled(
        z2 * x2 - z2.square() - z * x2 * 2.0 + z.powi(3) * 2.0 + x2
            - z2
            - (x2 - z).square()
            - y2.square()
            - x2 * y2 * 2.0
            - y2 * z2
            + y2 * z * 2.0
            + y2,
    )
}

fn devils_curve<N: Number>(a: &Arguments<N>) -> N {
    let [x2, y2, z2] = a.squares();
    a.scaled(-(x2.square() + x2 * z2 * 2.0 - x2 * 0.36 - y2.square() + y2 * 0.25 + z2.square()))
}

fn dupin_cyclid<N: Number>(a: &Arguments<N>) -> N {
    let [_, p1, p2, p3, p4, p5] = [0, 1, 2, 3, 4, 5].map(|i| a.p[i]);
    let (s, u, v) = (p5.square(), p2.square(), p4.square());
    let (q1, q2) = (u - v - (p3 + p1).square(), u - v - (p3 - p1).square());
    let (q, [x2, y2, z2]) = (q1 * q2, a.squares());
    let reach = a.x * p3 * 2.0 + a.y * p4 * 2.0 - s;
    let quartic = q * (x2.square() + y2.square() + z2.square()) + q * (x2 * y2 + x2 * z2 + y2 * z2) * 2.0;
    let slope = s * ((-v - p3.square() + u + p1.square()) * reach - p4 * u * a.y * 4.0) * 2.0;
    let line = p3 * a.x + p4 * a.y;
    let flat = s.square() * line * (line - s) * 4.0;
    a.scaled(-(quartic + slope * a.r2() + flat + s.square() * p1.square() * y2 * 4.0 + s.square().square()))
}

fn enneper<N: Number>(a: &Arguments<N>) -> N {
    let [x2, y2, z2] = a.squares();
    let z = (a.z.abs() - N::from(0.2)).choose(N::from(0.2), a.z, a.z);
    let b = (y2 - x2) / (z * 4.0);
    let a3 = ((y2 - x2) / (z * 2.0) + z2 * 2.0 / 9.0).powi(3);
    a.scaled(-(a3 - b.square() * 6.0))
}

fn folium_surface<N: Number>(a: &Arguments<N>) -> N {
    let [x2, y2, z2] = a.squares();
    let slope = a.p[2] - a.p[1] * 4.0;
    a.scaled((y2 + z2) * (slope * a.x + 1.0) + x2 * (a.p[2] + 1.0))
}

fn glob<N: Number>(a: &Arguments<N>) -> N {
    let [x2, y2, z2] = a.squares();
    a.scaled(x2.square() * a.x * 0.5 + x2.square() * 0.5 - (y2 + z2))
}

fn heart<N: Number>(a: &Arguments<N>) -> N {
    let [x2, y2, z2] = a.squares();
    let z3 = a.z.powi(3);
    a.scaled(-((x2 * 2.0 + y2 + z2 - 1.0).powi(3) - x2 * z3 * 0.1 - y2 * z3))
}

fn hunt_surface<N: Number>(a: &Arguments<N>) -> N {
    let [x2, y2, z2] = a.squares();
    let inner = (a.r2() - 13.0).powi(3);
    a.scaled(-(inner * 4.0 + (x2 * 3.0 + y2 - z2 * 4.0 - 12.0).square() * 27.0))
}

fn hyperbolic_torus<N: Number>(a: &Arguments<N>) -> N {
    let [x2, y2, z2] = a.squares();
    let (sum, difference) = radii(a);
    let quartic = x2.square() + x2 * y2 * 2.0 - x2 * z2 * 2.0 + y2.square() - y2 * z2 * 2.0 + z2.square();
    let quadratic = (difference * y2 + sum * (z2 - x2)) * 2.0;
    a.scaled(-(quartic + quadratic + difference.square()))
}

/// The sum and the difference of the squares of `p1` and `p2`.
fn radii<N: Number>(a: &Arguments<N>) -> (N, N) {
    let (u, v) = (a.p[1].square(), a.p[2].square());
    (u + v, u - v)
}

fn kampyle_of_eudoxus<N: Number>(a: &Arguments<N>) -> N {
    let ([x2, y2, z2], c2) = (a.squares(), a.p[2].square());
    a.scaled(-(y2 + z2 - c2 * x2.square() + c2 * a.p[1].square() * x2))
}

fn klein_bottle<N: Number>(a: &Arguments<N>) -> N {
    let (r2, z2) = (a.r2(), a.z.square());
    let (above, below) = (r2 + a.y * 2.0 - 1.0, r2 - a.y * 2.0 - 1.0);
    a.scaled(-(above * (below.square() - z2 * 8.0) + a.x * a.z * below * 16.0))
}

fn kummer_surface_v1<N: Number>(a: &Arguments<N>) -> N {
    let [x2, y2, z2] = a.squares();
    let quartic = x2.square() + y2.square() + z2.square() - x2 * y2 - x2 * z2 - y2 * z2;
    a.scaled(-(quartic - x2 - y2 - z2 + 1.0))
}

fn kummer_surface_v2<N: Number>(a: &Arguments<N>) -> N {
    let [x2, y2, z2] = a.squares();
    let quartic = x2.square() + y2.square() + z2.square() + a.p[2] * (x2 * y2 + x2 * z2 + y2 * z2);
    a.scaled(-(quartic + a.p[1] * a.r2() + a.p[3] * a.x * a.y * a.z - 1.0))
}

fn lemniscate_of_gerono<N: Number>(a: &Arguments<N>) -> N {
    let [x2, y2, z2] = a.squares();
    a.scaled(-(x2.square() - x2 + y2 + z2))
}

fn mitre<N: Number>(a: &Arguments<N>) -> N {
    let [x2, y2, z2] = a.squares();
    a.scaled(-(x2 * a.r2() * 4.0 - y2 * (-y2 - z2 + 1.0)))
}

fn nodal_cubic<N: Number>(a: &Arguments<N>) -> N {
    a.scaled(-(a.y.powi(3) + a.z.powi(3) - a.y * a.z * 6.0))
}

fn odd<N: Number>(a: &Arguments<N>) -> N {
    cushion(a)
}

fn ovals_of_cassini<N: Number>(a: &Arguments<N>) -> N {
    let ([x2, _, z2], b2) = (a.squares(), a.p[1].square());
    a.scaled(-((a.r2() + b2).square() - a.p[3] * b2 * (x2 + z2) - a.p[2].square()))
}

fn paraboloid<N: Number>(a: &Arguments<N>) -> N {
    let [x2, _, z2] = a.squares();
    a.scaled(-(x2 - a.y + z2))
}

fn parabolic_torus<N: Number>(a: &Arguments<N>) -> N {
    let ([x2, y2, z2], z) = (a.squares(), a.z);
    let (sum, difference) = radii(a);
    let quartic = x2.square() + x2 * y2 * 2.0 - x2 * z * 2.0 + y2.square() - y2 * z * 2.0;
    let lower = difference * y2 - sum * x2 + z2 + sum * z;
    a.scaled(-(quartic + lower + difference.square()))
}

fn pillow<N: Number>(a: &Arguments<N>) -> N {
    let [x2, y2, z2] = a.squares();
    a.scaled(x2.square() + y2.square() + z2.square() - (x2 + y2 + z2))
}

fn piriform<N: Number>(a: &Arguments<N>) -> N {
    let [x2, y2, z2] = a.squares();
    -a.scaled(-(x2.square() - x2 * a.x + y2 + z2))
}

fn quartic_paraboloid<N: Number>(a: &Arguments<N>) -> N {
    a.scaled(-(a.x.powi(4) + a.z.powi(4) - a.y))
}

fn quartic_saddle<N: Number>(a: &Arguments<N>) -> N {
    a.scaled(-(a.x.powi(4) - a.z.powi(4) - a.y))
}

fn quartic_cylinder<N: Number>(a: &Arguments<N>) -> N {
    let ([x2, y2, z2], c2) = (a.squares(), a.p[2].square());
    a.scaled(-((x2 + z2) * y2 + c2 * (x2 + z2) - c2 * a.p[1].square()))
}

fn steiners_roman<N: Number>(a: &Arguments<N>) -> N {
    let [x2, y2, z2] = a.squares();
    a.scaled(-(x2 * y2 + x2 * z2 + y2 * z2 + a.x * a.y * a.z))
}

fn strophoid<N: Number>(a: &Arguments<N>) -> N {
    let ([x2, y2, z2], d2) = (a.squares(), a.p[3].square());
    a.scaled(-((a.p[2] - a.x) * (y2 + z2) - d2 * a.p[1] * x2 - d2 * x2 * a.x))
}

fn torus2<N: Number>(a: &Arguments<N>) -> N {
    let [x2, y2, z2] = a.squares();
    let (sum, difference) = radii(a);
    a.scaled(-(a.r2().square() + (difference * y2 - sum * (x2 + z2)) * 2.0 + difference.square()))
}

fn torus_gumdrop<N: Number>(a: &Arguments<N>) -> N {
    let [x2, y2, z2] = a.squares();
    let across = y2 + z2;
    a.scaled(-((x2.square() + across.square()) * 4.0 + x2 * across * 17.0 - a.r2() * 20.0 + 17.0))
}

fn umbrella<N: Number>(a: &Arguments<N>) -> N {
    let [x2, _, z2] = a.squares();
    a.scaled(-(x2 - a.y * z2))
}

fn witch_of_agnesi<N: Number>(a: &Arguments<N>) -> N {
    let [x2, _, z2] = a.squares();
    a.scaled(-(a.p[1] * (a.y - 1.0) + (x2 + z2) * a.y))
}
