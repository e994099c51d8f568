//! References that are kept where the user says so.
//!
//! A file holds the picture's size, its samples, its expected error and its pixels; its name tells the scene
//! (with all text that it includes) and the size. Everything is little-endian.

use crate::color::Rgb;
use crate::picture::{Output, Picture, Pixel};
use crate::trade::{Reference, Size};
use std::path::PathBuf;

const MAGIC: &[u8; 8] = b"glintref";

pub struct Cache {
    folder: PathBuf,
    /// Of the scene's text and of what it was told.
    fingerprint: u64,
}

impl Cache {
    pub fn new(folder: PathBuf, fingerprint: u64) -> Self {
        Self { folder, fingerprint }
    }

    /// Keeps references of another kind beside each other.
    pub fn tell_apart(&mut self) {
        self.fingerprint = !self.fingerprint;
    }

    fn path(&self, size: Size) -> PathBuf {
        let name = format!("{:016x}-{}x{}.reference", self.fingerprint, size.width, size.height);
        self.folder.join(name)
    }

    /// A picture that was kept; one that cannot be read is made anew.
    pub fn load(&self, size: Size) -> Option<Reference> {
        let bytes = std::fs::read(self.path(size)).ok()?;
        let kept = decoded(&bytes)?;
        let picture = &kept.picture;
        (picture.width == size.width && picture.height == size.height).then_some(kept)
    }

    pub fn store(&self, kept: &Reference) -> Result<(), String> {
        let picture = &kept.picture;
        let path = self.path(Size { width: picture.width, height: picture.height });
        std::fs::create_dir_all(&self.folder).map_err(|e| format!("{}: {e}", self.folder.display()))?;
        Output::File(path).write(&encoded(kept)).map_err(|e| e.to_string())
    }
}

fn encoded(kept: &Reference) -> Vec<u8> {
    let Reference { picture, samples, rmse } = kept;
    let mut bytes = MAGIC.to_vec();
    bytes.extend(picture.width.to_le_bytes());
    bytes.extend(picture.height.to_le_bytes());
    bytes.extend(samples.to_le_bytes());
    bytes.extend(rmse.to_le_bytes());
    for p in &picture.pixels {
        for channel in [p.rgb.x, p.rgb.y, p.rgb.z, p.transmit] {
            bytes.extend(channel.to_le_bytes());
        }
    }
    bytes
}

fn decoded(bytes: &[u8]) -> Option<Reference> {
    let rest = bytes.strip_prefix(MAGIC)?;
    let (head, pixels) = rest.split_at_checked(24)?;
    let word = |at: usize| Some(u32::from_le_bytes(head.get(at..at + 4)?.try_into().ok()?));
    let long = |at: usize| Some(u64::from_le_bytes(head.get(at..at + 8)?.try_into().ok()?));
    let (width, height, samples, rmse) = (word(0)?, word(4)?, long(8)?, f64::from_bits(long(16)?));
    let count = (width as usize).checked_mul(height as usize)?;
    if Some(pixels.len()) != count.checked_mul(16) {
        return None;
    }
    let channel = |b: &[u8]| b.try_into().map(f32::from_le_bytes).unwrap_or_default();
    let pixel = |b: &[u8]| {
        Pixel::new(Rgb::new(channel(&b[..4]), channel(&b[4..8]), channel(&b[8..12])), channel(&b[12..]))
    };
    let picture = Picture { width, height, pixels: pixels.chunks_exact(16).map(pixel).collect() };
    Some(Reference { picture, samples, rmse })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_kept_comes_back() {
        let mut picture = Picture::new(3, 2);
        picture.set(2, 1, Pixel::new(Rgb::new(0.1, 2.0, -3.0), 0.25));
        let kept = Reference { picture: picture.clone(), samples: 1 << 40, rmse: 1e-3 };
        let mut bytes = encoded(&kept);
        let back = decoded(&bytes).unwrap();
        assert!(back.picture == picture && (back.samples, back.rmse) == (1 << 40, 1e-3));
        bytes.pop();
        assert!(decoded(&bytes).is_none() && decoded(b"glintref").is_none());
    }
}
