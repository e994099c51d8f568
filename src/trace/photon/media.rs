//! Photons that stay in media: places along a stretch, and what the media take from those that go on.

use super::super::media::{Stretch, exp};
use super::super::media_sampling::{Interval, intervals};
use super::super::shade::Site;
use super::super::tracer::Tracer;
use super::Stream;
use crate::color::Rgb;
use crate::scene::PhotonSettings;
use smallvec::SmallVec;

/// Photons left along a stretch.
pub(super) struct Deposits {
    /// Distance along the stretch, and the photon's share.
    pub places: Vec<(f64, f64)>,
    pub left: Rgb,
}

impl Tracer<'_> {
    /// `spread` is the distance between photons where the stretch begins.
    pub(super) fn deposits(&mut self, site: &Site, spread: f64, draws: &mut Stream) -> Deposits {
        let mut deposits = Deposits { places: Vec::new(), left: Rgb::ONE };
        let Some(settings) = self.world.scene.globals.photons.clone() else { return deposits };
        let inside = &site.path.inside;
        let media: SmallVec<[u32; 4]> =
            inside.iter().map(|i| self.media_of[i.0 as usize]).flat_map(|(a, b)| a..b).collect();
        let all = || media.iter().map(|&m| self.media[m as usize].media);
        let scatters = all().any(|m| m.scattering != Rgb::ZERO);
        let keeps = scatters && all().any(|m| m.collect);
        if !scatters && all().all(|m| m.absorption == Rgb::ZERO) {
            return deposits;
        }
        let beams = self.beams(site.ray, site.hit.t, Some(site.hit));
        let stretch = Stretch::new(site.ray, site.hit.t, media, None, beams);
        let plan = self.plan_of(&stretch);
        let mut depth = Rgb::ZERO;
        for interval in intervals(&stretch, &plan) {
            let steps = Steps::new(&settings, &interval, spread);
            let mut sum = Rgb::ZERO;
            for j in 0..steps.count.max(1) {
                let d = if steps.count == 0 { 0.5 } else { steps.place(j, draws.draw()) };
                let along = interval.start + d * interval.length;
                sum += self.local(&stretch, along, false).extinction;
                if keeps && steps.count > 0 {
                    deposits.places.push((along, steps.share));
                }
            }
            depth += sum * (interval.length / f64::from(steps.count.max(1))) as f32;
        }
        deposits.left = exp(-depth);
        deposits
    }
}

/// How many photons an interval gets, and which share each of them has.
struct Steps {
    count: u32,
    share: f64,
    jitter: f64,
}

impl Steps {
    fn new(settings: &PhotonSettings, interval: &Interval, spread: f64) -> Self {
        let wanted = interval.length / (spread * settings.media_factor);
        let jitter = settings.jitter;
        if wanted.trunc() > f64::from(settings.media_steps) {
            let count = settings.media_steps;
            return Self { count, share: interval.length / (spread * f64::from(count)), jitter };
        }
        Self { count: wanted as u32, share: settings.media_factor, jitter }
    }

    /// The place of photon `j` in the interval, 0 to 1.
    fn place(&self, j: u32, random: f64) -> f64 {
        (f64::from(j) + 0.5 + (random - 0.5) * self.jitter) / f64::from(self.count)
    }
}
