//! What the values of an image file mean.

use super::decode::Profile;
use crate::color::{Gamma, linear_from_srgb};

/// How the values of a file are read, by where they are used and what the scene has said so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Raw values, as heights and patterns want them; otherwise colours.
    pub raw: bool,
    /// Effective version times 100.
    pub version: u32,
    /// `assumed_gamma`, if it was given before.
    pub working: Option<Gamma>,
    /// The `gamma` written beside the file.
    pub written: Option<Curve>,
    /// The `premultiplied` written beside the file.
    pub premultiplied: Option<bool>,
}

/// How stored values become light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Curve {
    Power(f64),
    Srgb,
}

/// Stored values to working values.
#[derive(Clone, Copy, Debug)]
pub(super) struct Transfer {
    decode: Option<Curve>,
    encode: Option<Gamma>,
}

impl Transfer {
    const RAW: Transfer = Transfer { decode: None, encode: None };

    pub fn value(&self, stored: f64) -> f32 {
        let light = match self.decode {
            None => stored,
            Some(Curve::Power(g)) => f64::from(stored.powf(g) as f32),
            Some(Curve::Srgb) => f64::from(linear_from_srgb(stored) as f32),
        };
        match self.encode {
            None => light as f32,
            Some(gamma) => gamma.encode(light) as f32,
        }
    }
}

impl Reading {
    /// Values as they stand.
    pub const RAW: Reading =
        Reading { raw: true, version: 370, working: None, written: None, premultiplied: None };

    pub(super) fn transfer(&self, profile: Profile) -> Transfer {
        let encode = if self.raw { None } else { self.working };
        if let Some(curve) = self.written {
            return Transfer { decode: Some(curve), encode };
        }
        let managed = self.version >= 370;
        if self.raw || !(managed || self.working.is_some()) {
            return Transfer::RAW;
        }
        match profile {
            Profile::Curve(curve) => Transfer { decode: Some(curve), encode },
            Profile::Light => Transfer { decode: None, encode },
            Profile::PerhapsSrgb if managed => Transfer { decode: Some(Curve::Srgb), encode },
            Profile::PerhapsSrgb | Profile::Unknown => Transfer::RAW,
        }
    }
}
