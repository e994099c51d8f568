//! Fading with distance: `2 / (1 + (d/fade_distance)^fade_power)`, which is 1 at `fade_distance`.
//!
//! Only if `fade_power` is above 0 and `fade_distance` is not 0.

/// The share of light at `distance`.
#[inline]
pub fn factor(distance: f64, fade_distance: f64, fade_power: f64) -> f64 {
    if fade_power <= 0.0 || fade_distance == 0.0 {
        return 1.0;
    }
    let ratio = (distance / fade_distance).abs();
    let power = if fade_power == 2.0 { ratio * ratio } else { ratio.powf(fade_power) };
    2.0 / (1.0 + power)
}

#[cfg(test)]
mod tests {
    use super::factor;

    #[test]
    fn one_at_fade_distance_and_up_to_two_nearer() {
        assert_eq!(factor(3.0, 3.0, 1.5), 1.0);
        assert_eq!(factor(1.0, 2.0, 2.0), 1.6);
        assert_eq!(factor(4.0, 2.0, 1.0), 2.0 / 3.0);
    }

    #[test]
    fn needs_both_numbers() {
        assert_eq!(factor(7.0, 0.0, 2.0), 1.0);
        assert_eq!(factor(7.0, 2.0, 0.0), 1.0);
    }
}
