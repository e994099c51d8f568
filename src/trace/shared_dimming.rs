//! What uneven media leave of light from the lamps of one area light: looked up once for every few lamps.
//!
//! The lamps of one light lie close together, seen from where it shines, and light from them passes through
//! nearly the same parts of a cloud. Every lamp is tested for surfaces that stand in its way; which lamps also
//! look into the media is chosen by chance, so that the mean stays that of all lamps.

use crate::color::Rgb;
use smallvec::SmallVec;

/// One lamp of so many looks into the media.
pub(super) const SHARE: u32 = 4;

/// Stretches of one shadow ray, and what the media on them left of the light.
#[derive(Debug, Default)]
pub(super) struct SharedDimming {
    stretches: Vec<(SmallVec<[u32; 4]>, Rgb)>,
    active: bool,
    /// Whether the present lamp looks for itself.
    fresh: bool,
    /// Stretches of the present lamp so far.
    next: usize,
    lamps: u32,
}

impl SharedDimming {
    /// Lamps of a new light and point follow; `first` picks which of them look.
    pub fn begin(&mut self, first: f64) {
        self.stretches.clear();
        self.active = true;
        self.lamps = (first * f64::from(SHARE)) as u32;
    }

    pub fn end(&mut self) {
        self.active = false;
    }

    /// A shadow ray towards the next lamp starts.
    pub fn next_lamp(&mut self) {
        self.fresh = self.lamps.is_multiple_of(SHARE);
        self.lamps += 1;
        self.next = 0;
    }

    /// What an earlier lamp found on the stretch of the same number, if it went through the same media.
    pub fn recall(&mut self, media: &[u32]) -> Option<Rgb> {
        if !self.active || self.fresh {
            return None;
        }
        let (known, left) = self.stretches.get(self.next)?;
        if known[..] != *media {
            return None;
        }
        self.next += 1;
        Some(*left)
    }

    pub fn keep(&mut self, media: SmallVec<[u32; 4]>, left: Rgb) {
        if self.active {
            self.stretches.truncate(self.next);
            self.stretches.push((media, left));
            self.next += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn media(m: u32) -> SmallVec<[u32; 4]> {
        SmallVec::from_slice(&[m])
    }

    #[test]
    fn one_lamp_of_four_looks() {
        let mut shared = SharedDimming::default();
        assert_eq!(shared.recall(&[1]), None);
        shared.begin(0.0);
        let mut looked = 0;
        for lamp in 0..16 {
            shared.next_lamp();
            for m in [1, 2] {
                if shared.recall(&[m]).is_none() {
                    looked += 1;
                    shared.keep(media(m), Rgb::splat((10 * m + lamp) as f32));
                }
            }
        }
        assert_eq!(looked, 8);
        shared.end();
        assert_eq!(shared.recall(&[1]), None);
    }

    #[test]
    fn a_lamp_behind_other_media_looks_for_itself() {
        let mut shared = SharedDimming::default();
        shared.begin(0.0);
        shared.next_lamp();
        shared.keep(media(1), Rgb::ONE);
        shared.next_lamp();
        assert_eq!(shared.recall(&[2]), None);
        shared.keep(media(2), Rgb::ZERO);
        shared.next_lamp();
        assert_eq!(shared.recall(&[1]), None);
        assert_eq!(shared.recall(&[2]), Some(Rgb::ZERO));
    }
}
