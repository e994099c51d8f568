//! OpenEXR files: linear light in single precision, colours premultiplied by coverage as the format wants.

use super::{Encoding, Picture, PictureError};
use ::exr::prelude::*;
use std::io::Cursor;

/// The bytes of an EXR file with the channels R, G, B, and A if alpha was asked for.
pub fn encode(picture: &Picture, encoding: &Encoding) -> std::result::Result<Vec<u8>, PictureError> {
    let size = (picture.width as usize, picture.height as usize);
    let light = |p: Vec2<usize>| {
        let pixel = picture.get(p.x() as u32, p.y() as u32);
        let c = encoding.light(pixel.rgb);
        (c.x, c.y, c.z, 1.0 - pixel.transmit)
    };
    let mut out = Cursor::new(Vec::new());
    let result = if encoding.alpha {
        Image::from_channels(size, SpecificChannels::rgba(light)).write().to_buffered(&mut out)
    } else {
        let opaque = |p: Vec2<usize>| {
            let (r, g, b, _) = light(p);
            (r, g, b)
        };
        Image::from_channels(size, SpecificChannels::rgb(opaque)).write().to_buffered(&mut out)
    };
    match result {
        Ok(()) => Ok(out.into_inner()),
        Err(error) => Err(PictureError::Format { place: "EXR".into(), message: error.to_string() }),
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Pixel, load};
    use super::*;
    use crate::color::{Gamma, Rgb};

    #[test]
    fn values_come_back_to_the_bit() {
        let mut p = Picture::new(5, 3);
        p.set(4, 2, Pixel::new(Rgb::new(0.1, 7.5, -0.25), 0.0));
        p.set(1, 0, Pixel::new(Rgb::new(0.2, 0.3, 0.4), 0.5));
        let e = Encoding { alpha: true, ..Encoding::new(Gamma::Power(1.0)) };
        let (size, channels) = load::exr_channels(&encode(&p, &e).unwrap()).unwrap();
        assert_eq!(size, (5, 3));
        assert_eq!(channels[2 * 5 + 4], [0.1, 7.5, -0.25, 1.0]);
        assert_eq!(channels[1], [0.2, 0.3, 0.4, 0.5]);
        assert_eq!(channels[0], [0.0, 0.0, 0.0, 0.0]);
    }

    #[test]
    fn working_gamma_is_undone() {
        let mut p = Picture::new(1, 1);
        p.set(0, 0, Pixel::new(Rgb::splat(0.5), 0.0));
        let e = Encoding::new(Gamma::Power(2.0));
        let (_, channels) = load::exr_channels(&encode(&p, &e).unwrap()).unwrap();
        assert_eq!(channels[0], [0.25, 0.25, 0.25, 1.0]);
    }
}
