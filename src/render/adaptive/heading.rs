//! The way in which light changes most at a pixel, as it and its neighbours have it.
//!
//! An edge through a pixel runs across that way, on the side on which the neighbours differ more from the pixel's own
//! sample. A second sample halfway to that side's border tells as much about the edge as three that know nothing of it:
//! where the edge is straight and light two-valued, the place of n samples along it is known to 1/n.

use glam::Vec3A;

/// Squared changes of light over a pixel, summed over the channels, below which there is no way to tell.
const LEAST_CHANGE: f32 = 1e-7;

/// A direction of length 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Heading {
    pub x: f32,
    pub y: f32,
}

impl Heading {
    /// From the differences in light between each neighbour and the pixel, with the neighbours' places.
    pub fn of(differences: impl Iterator<Item = (f32, f32, Vec3A)> + Clone) -> Option<Self> {
        let (mut along_x, mut along_y) = (Vec3A::ZERO, Vec3A::ZERO);
        for (x, y, d) in differences.clone() {
            along_x += x * d;
            along_y += y * d;
        }
        let (xx, xy, yy) = (along_x.dot(along_x), along_x.dot(along_y), along_y.dot(along_y));
        let size = (xx - yy).hypot(2.0 * xy);
        if xx + yy < 36.0 * LEAST_CHANGE || size <= f32::MIN_POSITIVE {
            return None;
        }
        // Half of the angle whose cosine this is.
        let cosine = (xx - yy) / size;
        let x = (0.5 + 0.5 * cosine).max(0.0).sqrt();
        let y = (0.5 - 0.5 * cosine).max(0.0).sqrt().copysign(xy);
        let (mut ahead, mut behind) = ((0.0, Vec3A::ZERO), (0.0, Vec3A::ZERO));
        for (dx, dy, d) in differences {
            let along = x * dx + y * dy;
            let side = if along > 0.0 { &mut ahead } else { &mut behind };
            side.0 += along.abs();
            side.1 += along.abs() * d;
        }
        let change =
            |(weight, sum): (f32, Vec3A)| if weight > 0.0 { (sum / weight).length_squared() } else { 0.0 };
        let sign = if change(ahead) < change(behind) { -1.0 } else { 1.0 };
        Some(Self { x: sign * x, y: sign * y })
    }

    /// A place that lies so far along the heading, of what the pixel measures that way, and so far across.
    pub fn place(self, along: f64, across: f64) -> (f64, f64) {
        let (x, y) = (f64::from(self.x), f64::from(self.y));
        let along = along * (x.abs() + y.abs());
        let inside = |v: f64| v.clamp(-0.499, 0.499);
        (inside(x * along - y * across), inside(y * along + x * across))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The heading at a place of a picture by formula.
    fn heading(color: impl Fn(f32, f32) -> f32) -> Option<Heading> {
        let places = (0..9).map(|i| ((i % 3) as f32 - 1.0, (i / 3) as f32 - 1.0));
        let color = &color;
        Heading::of(places.map(move |(x, y)| (x, y, Vec3A::splat(color(x, y) - color(0.0, 0.0)))))
    }

    #[test]
    fn planes_change_along_their_slope() {
        for (x, y) in [(0.3f32, 0.0f32), (0.0, 0.2), (0.1, 0.1), (-0.2, 0.1), (0.1, -0.3)] {
            let found = heading(|px, py| x * px + y * py).unwrap();
            let size = x.hypot(y);
            assert!(((found.x * y - found.y * x) / size).abs() < 1e-3, "{found:?}");
            assert!((found.x.hypot(found.y) - 1.0).abs() < 1e-5);
        }
        assert_eq!(heading(|_, _| 0.7), None);
    }

    /// The edge lies on the side where the neighbour differs.
    #[test]
    fn edges_lie_ahead() {
        for angle in 0..16 {
            let (sin, cos) = (0.4 * angle as f32).sin_cos();
            let found = heading(|x, y| if cos * x + sin * y < 0.3 { 0.1 } else { 0.6 }).unwrap();
            assert!(found.x * cos + found.y * sin > 0.85, "{angle} {found:?}");
        }
    }

    #[test]
    fn places_lie_in_the_pixel() {
        for angle in 0..32 {
            let (y, x) = (0.2 * angle as f32).sin_cos();
            let (px, py) = Heading { x, y }.place(0.5, 0.3);
            assert!(px.abs() < 0.5 && py.abs() < 0.5);
        }
        assert_eq!(Heading { x: 0.0, y: -1.0 }.place(0.25, 0.0), (0.0, -0.25));
    }
}
