//! Linear pixels, and the files that they go to.
//!
//! A [`Picture`] holds working values, premultiplied by coverage; [`encode`] makes file values of them,
//! [`png`] and [`exr`] write files, [`compare`] measures how far two pictures are apart.

pub mod compare;
mod dither;
pub mod embed;
pub mod encode;
pub mod exr;
mod file;
pub mod light;
pub mod load;
pub mod other;
pub mod png;

pub use dither::Dither;
pub use encode::{Encoding, FileGamma};
pub use file::{Output, PictureError};

use crate::color::Rgb;

/// What a camera ray found: working values, and the share of the background that shows through.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pixel {
    pub rgb: Rgb,
    pub transmit: f32,
}

impl Pixel {
    /// Where nothing was traced.
    pub const NONE: Pixel = Pixel { rgb: Rgb::ZERO, transmit: 1.0 };

    pub fn new(rgb: Rgb, transmit: f32) -> Self {
        Self { rgb, transmit }
    }
}

impl std::ops::Add for Pixel {
    type Output = Pixel;
    fn add(self, o: Pixel) -> Pixel {
        Pixel { rgb: self.rgb + o.rgb, transmit: self.transmit + o.transmit }
    }
}

impl std::ops::Mul<f32> for Pixel {
    type Output = Pixel;
    fn mul(self, k: f32) -> Pixel {
        Pixel { rgb: self.rgb * k, transmit: self.transmit * k }
    }
}

impl std::ops::Div<f32> for Pixel {
    type Output = Pixel;
    fn div(self, k: f32) -> Pixel {
        Pixel { rgb: self.rgb / k, transmit: self.transmit / k }
    }
}

/// Working values, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    pub width: u32,
    pub height: u32,
    pub pixels: Vec<Pixel>,
}

impl Picture {
    /// A picture in which nothing has been traced.
    pub fn new(width: u32, height: u32) -> Self {
        Self { width, height, pixels: vec![Pixel::NONE; width as usize * height as usize] }
    }

    pub fn row(&self, y: u32) -> &[Pixel] {
        let w = self.width as usize;
        &self.pixels[y as usize * w..][..w]
    }

    pub fn set(&mut self, x: u32, y: u32, pixel: Pixel) {
        let i = y as usize * self.width as usize + x as usize;
        self.pixels[i] = pixel;
    }

    pub fn get(&self, x: u32, y: u32) -> Pixel {
        self.pixels[y as usize * self.width as usize + x as usize]
    }
}
