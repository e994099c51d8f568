//! What all noise is made of: linear forms at the eight corners of a unit cell, faded together.

use super::fade;

/// Offset and gradient of a linear form, which counts from its own corner.
pub(super) type Form = [f64; 4];

/// The noise at `f`, the place in a cell, each coordinate 0 ..= 1; `form` is that of a corner. Bit 0 of a corner's number goes with z, bit 1 with
/// y, bit 2 with x.
#[inline(always)]
pub(super) fn blended(form: impl Fn(usize) -> Form, f: [f64; 3]) -> f64 {
    let [x, y, z] = f;
    let (sx, sy, sz) = (fade(x), fade(y), fade(z));
    let (x, y, z) = ([x, x - 1.0], [y, y - 1.0], [z, z - 1.0]);
    macro_rules! at {
        ($c:literal) => {{
            let [offset, gx, gy, gz] = form($c);
            (offset + gx * x[$c >> 2]) + (gy * y[($c >> 1) & 1] + gz * z[$c & 1])
        }};
    }
    let rows = [
        between(sx, at!(0), at!(4)),
        between(sx, at!(1), at!(5)),
        between(sx, at!(2), at!(6)),
        between(sx, at!(3), at!(7)),
    ];
    between(sz, between(sy, rows[0], rows[2]), between(sy, rows[1], rows[3]))
}

#[inline(always)]
fn between(t: f64, a: f64, b: f64) -> f64 {
    a + t * (b - a)
}
