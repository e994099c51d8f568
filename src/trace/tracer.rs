use super::{Counters, Pixel, Settings};
use crate::world::World;

/// Follows rays through one world; one per thread.
pub struct Tracer<'w> {
    world: &'w World,
    settings: Settings,
    counters: Counters,
    /// Pixel and sample that random draws belong to.
    place: (u32, u32, u32),
}

impl<'w> Tracer<'w> {
    pub fn new(world: &'w World, settings: &Settings) -> Self {
        Self { world, settings: settings.clone(), counters: Counters::default(), place: (0, 0, 0) }
    }

    /// Called before each pixel or sample: all random draws until the next call depend on it alone.
    pub fn seed(&mut self, x: u32, y: u32, sample: u32) {
        self.place = (x, y, sample);
    }

    /// The colour seen through picture position (x, y): pixel (i, j) has its centre at (i+0.5, j+0.5), y
    /// runs down.
    pub fn pixel(&mut self, _x: f64, _y: f64) -> Pixel {
        self.counters.camera_rays += 1;
        let _ = (&self.settings, self.place);
        let _ = self.world;
        Pixel { rgb: Default::default(), transmit: 1.0 }
    }

    pub fn counters(&self) -> Counters {
        self.counters
    }
}
