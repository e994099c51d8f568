//! JPEG.

use super::{Decoded, Profile, Samples, area};
use image::codecs::jpeg::JpegDecoder;
use image::{ColorType, ImageDecoder};

pub(super) fn decode(bytes: &[u8]) -> Result<Decoded, String> {
    let decoder = JpegDecoder::new(std::io::Cursor::new(bytes)).map_err(|e| e.to_string())?;
    let (width, height) = decoder.dimensions();
    let (width, height) = (width as usize, height as usize);
    area(width, height)?;
    let channels = match decoder.color_type() {
        ColorType::L8 => 1,
        ColorType::Rgb8 => 3,
        _ => return Err("only grey and RGB files can be read".to_owned()),
    };
    let mut data = vec![0; width * height * channels];
    decoder.read_image(&mut data).map_err(|e| e.to_string())?;
    let samples = Samples::Bytes { channels, data, truncated_grey: false };
    Ok(Decoded { width, height, samples, profile: Profile::PerhapsSrgb })
}
