//! What each of many lights would give without shadows, four at a time in single precision.

use crate::light::{Light, LightKind};
use crate::math::Vec3;
use glam::Vec4;

/// Lights side by side: points and cones that fade with the square of the distance or not at all.
#[derive(Debug)]
pub(super) struct LightRow {
    fours: Vec<Four>,
    /// Places are counted from here.
    origin: Vec3,
}

#[derive(Debug)]
struct Four {
    places: [Vec4; 3],
    axes: [Vec4; 3],
    /// The brightest of red, green and blue, twice where the light fades; 0 in lanes without a light.
    colors: Vec4,
    /// What the square of the distance adds to `base` in the divisor.
    fades: Vec4,
    bases: Vec4,
    /// Strength at angle cosine c: `wide + tight c`.
    wide: Vec4,
    tight: Vec4,
    /// From this cosine on the cone is at its full strength; below it is left to [`Light`].
    inner: Vec4,
}

impl Four {
    const NONE: Self = Self {
        places: [Vec4::ZERO; 3],
        axes: [Vec4::ZERO; 3],
        colors: Vec4::ZERO,
        fades: Vec4::ZERO,
        bases: Vec4::ONE,
        wide: Vec4::ZERO,
        tight: Vec4::ZERO,
        inner: Vec4::NEG_INFINITY,
    };

    /// `None` for lights of other kinds.
    fn set(&mut self, lane: usize, light: &Light, origin: Vec3) -> Option<()> {
        if light.parallel {
            return None;
        }
        let (wide, tight, inner) = match &light.kind {
            LightKind::Point => (1.0, 0.0, f32::NEG_INFINITY),
            LightKind::Spot(beam) if beam.tightness == 0.0 => (1.0, 0.0, beam.radius.cos().max(0.0) as f32),
            LightKind::Spot(beam) if beam.tightness == 1.0 => (0.0, 1.0, beam.radius.cos().max(0.0) as f32),
            _ => return None,
        };
        let (fade, base, scale) = match (light.fade_power, light.fade_distance) {
            (power, distance) if power <= 0.0 || distance == 0.0 => (0.0, 1.0, 1.0),
            (2.0, distance) => ((distance * distance).recip() as f32, 1.0, 2.0),
            _ => return None,
        };
        let (place, axis) = ((light.location - origin).as_vec3(), light.axis().as_vec3());
        for i in 0..3 {
            self.places[i][lane] = place[i];
            self.axes[i][lane] = axis[i];
        }
        self.colors[lane] = scale * light.color.abs().max_element();
        (self.fades[lane], self.bases[lane]) = (fade, base);
        (self.wide[lane], self.tight[lane], self.inner[lane]) = (wide, tight, inner);
        Some(())
    }
}

/// Four square roots at once.
#[cfg(target_arch = "x86_64")]
#[inline]
fn roots(v: Vec4) -> Vec4 {
    // SAFETY: every processor of this kind has the instruction.
    #[allow(unsafe_code)]
    Vec4::from(unsafe { std::arch::x86_64::_mm_sqrt_ps(v.into()) })
}

#[cfg(not(target_arch = "x86_64"))]
#[inline]
fn roots(v: Vec4) -> Vec4 {
    Vec4::from(v.to_array().map(f32::sqrt))
}

/// Where lights are asked about.
pub(super) struct Spot {
    pub point: Vec3,
    /// Unit normal.
    pub normal: Vec3,
    /// Lights below this cosine count nothing.
    pub least: f32,
}

impl LightRow {
    /// `None` if there are lights of other kinds.
    pub fn new<'l>(lights: impl ExactSizeIterator<Item = &'l Light>) -> Option<Self> {
        let mut row = Self { fours: Vec::with_capacity(lights.len().div_ceil(4)), origin: Vec3::ZERO };
        for (i, light) in lights.enumerate() {
            if i == 0 {
                row.origin = light.location;
            }
            if i % 4 == 0 {
                row.fours.push(Four::NONE);
            }
            row.fours[i / 4].set(i % 4, light, row.origin)?;
        }
        Some(row)
    }

    /// Calls `visit` with the place of each light and what it gives a white diffuse surface, if anything. `cone`
    /// tells the share of light at a cosine inside a cone's soft edge.
    #[inline]
    pub fn each(&self, spot: &Spot, cone: impl Fn(usize, f32) -> f32, mut visit: impl FnMut(usize, f32)) {
        let (p, n) = ((spot.point - self.origin).as_vec3(), spot.normal.as_vec3());
        for (i, four) in self.fours.iter().enumerate() {
            let [x, y, z] = four.places;
            let (x, y, z) = (x - p.x, y - p.y, z - p.z);
            let square = x * x + y * y + z * z;
            let inverse = Vec4::ONE / roots(square);
            let cosine = (x * n.x + y * n.y + z * n.z) * inverse;
            let [ax, ay, az] = four.axes;
            let c = -(x * ax + y * ay + z * az) * inverse;
            let mut shares = four.wide + four.tight * c;
            let soft = c.cmplt(four.inner).bitmask();
            for lane in (0..4).filter(|lane| soft >> lane & 1 != 0) {
                shares[lane] = if c[lane] > 0.0 { cone(4 * i + lane, c[lane]) } else { 0.0 };
            }
            let given = four.colors * shares * cosine.abs() / (four.bases + four.fades * square);
            let given = given.to_array();
            let lit = cosine.cmpge(Vec4::splat(spot.least)).bitmask();
            for (lane, strength) in given.into_iter().enumerate() {
                if lit >> lane & 1 != 0 && strength > 0.0 {
                    visit(4 * i + lane, strength);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::Rgb;
    use crate::light::SpotBeam;

    fn lights() -> Vec<Light> {
        let spot = |tightness: f64, radius: f64, falloff: f64| {
            let mut beam = SpotBeam::default();
            (beam.tightness, beam.radius, beam.falloff) = (tightness, radius, falloff);
            LightKind::Spot(beam.prepared())
        };
        let light = |i: u32, kind: LightKind| {
            let f = f64::from(i);
            let location = Vec3::new(f, 5.0 + 0.1 * f, -0.3 * f);
            let point_at = Vec3::new(0.4 * f, 0.0, 0.2);
            let fade = if i.is_multiple_of(2) { (3.0, 2.0) } else { (0.0, 0.0) };
            let (fade_distance, fade_power) = fade;
            let color = Rgb::new(0.5, 1.0, 0.2) * (1.0 + i as f32);
            Light { location, point_at, color, kind, fade_distance, fade_power, ..Light::default() }
                .prepared()
        };
        vec![
            light(0, LightKind::Point),
            light(1, LightKind::Point),
            light(2, spot(1.0, -15_707.0 / 10_000.0, 15_707.0 / 10_000.0)),
            light(3, spot(1.0, 0.2, 0.5)),
            light(4, spot(0.0, 0.1, 0.9)),
        ]
    }

    #[test]
    fn strengths_are_those_of_each_light() {
        let lights = lights();
        let row = LightRow::new(lights.iter()).unwrap();
        let mut count = 0;
        for i in 0..200 {
            let f = f64::from(i);
            let point = Vec3::new(4.0 * (f * 0.7).sin(), 0.2 * f.cos(), 3.0 * (f * 1.1).cos());
            let normal = Vec3::new(f.sin(), 1.0, (2.0 * f).sin()).normalize();
            let cone = |i: usize, c: f32| lights[i].cone(f64::from(c)) as f32;
            let mut given = [0.0; 5];
            row.each(&Spot { point, normal, least: 0.0 }, cone, |i, strength| given[i] = strength);
            for (light, given) in lights.iter().zip(given) {
                let wanted = light
                    .arrival(point, Vec3::ZERO)
                    .map_or(0.0, |a| a.color.max_element() * (normal.dot(a.direction) as f32).max(0.0));
                // The soft edge of a cone makes more of the roundings of the cosine.
                assert!((given - wanted).abs() <= 3e-5 * wanted.max(0.1), "{given} {wanted}");
                count += u32::from(wanted > 0.0);
            }
        }
        assert!(count > 300, "{count}");
    }
}
