//! Photon maps as files: the reference's own layout, so that maps can go back and forth.
//!
//! Each map is a count (4 bytes) and its photons in the order of the tree, 20 bytes each: place as three
//! single-precision numbers, red, green, blue, exponent, axis, elevation, azimuth and a zero. The map of
//! surfaces stands first, then that of media. All little-endian.

use super::PackedPhoton;

const RECORD: usize = 20;

/// Both maps, in the order of their trees.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PhotonFile {
    pub surface: Vec<PackedPhoton>,
    pub media: Vec<PackedPhoton>,
}

impl PhotonFile {
    /// The bytes of a file with two maps.
    pub fn written(surface: &[PackedPhoton], media: &[PackedPhoton]) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(8 + RECORD * (surface.len() + media.len()));
        for map in [surface, media] {
            bytes.extend((map.len() as u32).to_le_bytes());
            map.iter().for_each(|p| bytes.extend(record(p)));
        }
        bytes
    }

    /// `None` if the bytes are no such file.
    pub fn read(bytes: &[u8]) -> Option<Self> {
        let (surface, rest) = read_map(bytes)?;
        let (media, rest) = if rest.is_empty() { (Vec::new(), rest) } else { read_map(rest)? };
        rest.is_empty().then_some(Self { surface, media })
    }
}

fn record(p: &PackedPhoton) -> [u8; RECORD] {
    let mut bytes = [0; RECORD];
    for (i, x) in p.place.iter().enumerate() {
        bytes[4 * i..4 * i + 4].copy_from_slice(&x.to_le_bytes());
    }
    bytes[12..16].copy_from_slice(&p.energy);
    bytes[16..19].copy_from_slice(&[p.axis, p.elevation as u8, p.azimuth as u8]);
    bytes
}

fn read_map(bytes: &[u8]) -> Option<(Vec<PackedPhoton>, &[u8])> {
    let (count, rest) = bytes.split_first_chunk()?;
    let length = (u32::from_le_bytes(*count) as usize).checked_mul(RECORD)?;
    let (records, rest) = rest.split_at_checked(length)?;
    Some((records.chunks_exact(RECORD).map(photon).collect::<Option<_>>()?, rest))
}

fn photon(record: &[u8]) -> Option<PackedPhoton> {
    let number = |i: usize| record[4 * i..].first_chunk().map(|b| f32::from_le_bytes(*b));
    let place = [number(0)?, number(1)?, number(2)?];
    let energy = *record[12..].first_chunk()?;
    let axis = record[16];
    let sound = axis < 3 && place.iter().all(|x| x.is_finite());
    sound.then_some(PackedPhoton {
        place,
        energy,
        axis,
        elevation: record[17] as i8,
        azimuth: record[18] as i8,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::Rgb;
    use crate::math::Vec3;

    #[test]
    fn files_come_back() {
        let photon =
            |x: f64| PackedPhoton::new(Vec3::new(x, 1.5, -2.0), Rgb::new(0.1, 0.2, 0.3), Vec3::NEG_X);
        let (surface, media) = ((0..5).map(|i| photon(f64::from(i))).collect::<Vec<_>>(), vec![photon(9.0)]);
        let bytes = PhotonFile::written(&surface, &media);
        assert_eq!(PhotonFile::read(&bytes), Some(PhotonFile { surface, media }));
        assert_eq!(PhotonFile::read(&bytes[..bytes.len() - 3]), None);
        assert_eq!(PhotonFile::read(&[1, 0]), None);
    }
}
