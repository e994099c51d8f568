//! Rainbows: arcs around a direction that tint what is seen along them.

use super::path::Veil;
use super::random::Random;
use crate::color::Rgb;
use crate::math::{Ray, Vec3};
use crate::scene::Rainbow;

/// The veil of all rainbows that the ray meets: the average of theirs.
pub(super) fn veil(rainbows: &[Rainbow], ray: &Ray, length: f64, random: &mut Random) -> Veil {
    let mut sum = Veil { factor: Rgb::ZERO, added: Rgb::ZERO, clear: 0.0 };
    let mut count = 0.0;
    for rainbow in rainbows {
        if let Some(one) = veil_of(rainbow, ray.dir, length, random) {
            sum.factor += one.factor;
            sum.added += one.added;
            sum.clear += one.clear;
            count += 1.0;
        }
    }
    if count == 0.0 {
        return Veil::NONE;
    }
    Veil { factor: sum.factor / count, added: sum.added / count, clear: sum.clear / count }
}

fn veil_of(rainbow: &Rainbow, v: Vec3, length: f64, random: &mut Random) -> Option<Veil> {
    let fade = fade_along_arc(rainbow, v)?;
    let ahead = v.dot(rainbow.direction);
    if ahead < 0.0 {
        return None;
    }
    let mut place = (ahead.min(1.0).acos() - (rainbow.angle - 0.5 * rainbow.width)) / rainbow.width;
    if rainbow.jitter != 0.0 {
        place += (2.0 * random.draw() - 1.0) * rainbow.jitter;
    }
    if !(0.0..=1.0 - 1e-10).contains(&place) {
        return None;
    }
    let c = rainbow.colors.color(place);
    let through = ((-length / rainbow.distance).exp() as f32).max(fade * (1.0 - c.transmit) + c.transmit);
    let filter = c.filter * (1.0 - through);
    Some(Veil {
        factor: through * (Rgb::splat(1.0 - filter) + filter * c.rgb),
        added: (1.0 - through) * c.rgb,
        clear: through * c.transmit,
    })
}

/// How far the bow has faded towards its ends: 0 not at all, 1 entirely. `None` beyond the ends.
fn fade_along_arc(rainbow: &Rainbow, v: Vec3) -> Option<f32> {
    let Some(arc) = rainbow.arc_angle else { return Some(0.0) };
    let right = rainbow.up.cross(rainbow.direction).normalize_or(Vec3::X);
    let up = rainbow.direction.cross(right).normalize_or(Vec3::Y);
    let (x, y) = (v.dot(right), v.dot(up));
    let length = x.hypot(y);
    let along = (if length > 0.0 { y / length } else { y }).clamp(-1.0, 1.0).acos();
    if along > 0.5 * arc {
        return None;
    }
    let start = 0.5 * rainbow.falloff_angle.unwrap_or(arc);
    if along <= start {
        return Some(0.0);
    }
    let q = (along - start) / (0.5 * arc - start);
    Some((q * q * (3.0 - 2.0 * q)) as f32)
}
