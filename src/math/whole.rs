//! Whole numbers below others. The standard library's way calls a function on processors of which nothing newer than
//! the base set of instructions is asked; patterns do this for every point.

use super::Vec3;

/// Doubles around this number are whole: adding and subtracting it rounds to the nearest one.
const ROUND: f64 = 6_755_399_441_055_744.0;
/// Up to this size the rounding above is that to the nearest whole number.
const LARGE: f64 = 1_125_899_906_842_624.0;

/// The largest whole number that is at most `v`; what is no number stays none.
#[inline]
pub fn floor(v: f64) -> f64 {
    if !(v.abs() < LARGE) {
        return v.floor();
    }
    let nearest = (v + ROUND) - ROUND;
    if nearest > v { nearest - 1.0 } else { nearest }
}

/// [`floor`] of each coordinate.
#[inline]
pub fn floor_of(v: Vec3) -> Vec3 {
    v.map(floor)
}

/// Whether a whole number is odd; what is no number counts as odd, too.
#[inline]
pub fn is_odd(whole: f64) -> bool {
    let half = 0.5 * whole;
    half - floor(half) != 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]
        /// Of all sizes, and next to whole numbers.
        #[test]
        fn it_is_the_floor(v in -1.0..1.0f64, exponent in -3..70i32, whole in -9..9i32, step in -2..=2i32) {
            let v = v * 2f64.powi(exponent);
            let mut near = f64::from(whole);
            for _ in 0..step.abs() {
                near = if step > 0 { near.next_up() } else { near.next_down() };
            }
            for v in [v, near, near + v.trunc(), v.trunc() + 0.5] {
                prop_assert_eq!(floor(v), v.floor());
                prop_assert_eq!(is_odd(v.floor()), v.floor().rem_euclid(2.0) != 0.0);
            }
        }
    }

    #[test]
    fn what_is_no_number_stays_none() {
        assert!(floor(f64::NAN).is_nan() && is_odd(f64::NAN) && is_odd(f64::INFINITY));
        assert_eq!(floor(f64::NEG_INFINITY), f64::NEG_INFINITY);
    }
}
