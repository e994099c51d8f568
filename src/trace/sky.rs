//! What rays see that leave the scene: the sky sphere's pigments over the background.

use super::path::Radiance;
use crate::color::{Color, Rgb, grey};
use crate::math::Vec3;
use crate::pattern::Context;
use crate::scene::{Background, SkySphere};

/// How a ray that leaves the scene is answered.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leaving {
    /// The picture has alpha and the ray has been reflected nowhere.
    pub shows_alpha: bool,
    /// The picture has alpha.
    pub alpha: bool,
    /// Rules since version 3.7.
    pub modern: bool,
}

pub(super) fn sky(
    background: Background,
    sphere: Option<&SkySphere>,
    direction: Vec3,
    leaving: Leaving,
    context: &Context,
) -> Radiance {
    if leaving.shows_alpha && !leaving.modern {
        return Radiance { rgb: Rgb::ZERO, transmit: 1.0 };
    }
    let below = behind(background, leaving);
    match sphere {
        None => below,
        Some(sphere) if leaving.modern => layered(sphere, direction, below, context),
        Some(sphere) => multiplied(sphere, direction, below, context),
    }
}

/// The background alone.
fn behind(background: Background, leaving: Leaving) -> Radiance {
    let shows = leaving.shows_alpha;
    match background {
        Background::None => Radiance { rgb: Rgb::ZERO, transmit: f32::from(shows) },
        Background::Opaque(_) if shows => Radiance { rgb: Rgb::ZERO, transmit: 1.0 },
        Background::Opaque(rgb) => Radiance { rgb, transmit: 0.0 },
        Background::Translucent(c) if shows => {
            Radiance { rgb: c.rgb * (1.0 - c.filter - c.transmit), transmit: grey(c.transmittance()) }
        }
        Background::Translucent(c) if leaving.alpha => Radiance { rgb: c.rgb, transmit: 0.0 },
        Background::Translucent(c) => Radiance { rgb: c.rgb * (1.0 - c.transmit), transmit: 0.0 },
    }
}

/// Since 3.7: each pigment filters what lies below.
fn layered(sphere: &SkySphere, direction: Vec3, below: Radiance, context: &Context) -> Radiance {
    let p = sphere.transform.inverse_point(direction);
    let (mut rgb, mut filter) = (Rgb::ZERO, Rgb::ONE);
    for pigment in sphere.pigments.iter().rev() {
        let Some(c) = pigment.color(p, context) else { continue };
        rgb += c.rgb * (1.0 - c.filter - c.transmit) * filter * sphere.emission;
        filter *= c.transmittance();
    }
    Radiance { rgb: rgb + filter * below.rgb, transmit: grey(filter) * below.transmit }
}

/// Before 3.7: all five components of the pigments are multiplied.
fn multiplied(sphere: &SkySphere, direction: Vec3, below: Radiance, context: &Context) -> Radiance {
    let p = sphere.transform.inverse_point(direction);
    let (mut rgb, mut clear) = (Rgb::ZERO, 1.0);
    let mut product = Color { rgb: Rgb::ONE, filter: 1.0, transmit: 1.0 };
    for pigment in sphere.pigments.iter().rev() {
        let Some(c) = pigment.color(p, context) else { continue };
        rgb += c.rgb * (1.0 - c.filter - c.transmit) * clear;
        product = Color {
            rgb: product.rgb * c.rgb,
            filter: product.filter * c.filter,
            transmit: product.transmit * c.transmit,
        };
        clear = product.filter.abs() + product.transmit.abs();
    }
    let filter = product.transmittance();
    Radiance { rgb: rgb * sphere.emission + filter * below.rgb, transmit: grey(filter) * below.transmit }
}
