use crate::math::noise::NoiseGenerator;
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

/// What functions ask of the scene around them each time they run: the text may decide it after them.
#[derive(Debug)]
pub struct Surroundings {
    generator: AtomicU32,
    waves: AtomicU32,
}

impl Default for Surroundings {
    fn default() -> Self {
        Self { generator: AtomicU32::new(NoiseGenerator::default() as u32), waves: AtomicU32::new(10) }
    }
}

impl Surroundings {
    /// The scene's noise generator.
    #[inline]
    pub fn generator(&self) -> NoiseGenerator {
        NoiseGenerator::from_number(self.generator.load(Relaxed)).unwrap_or_default()
    }

    pub fn set_generator(&self, generator: NoiseGenerator) {
        self.generator.store(generator as u32, Relaxed);
    }

    /// The number of wave sources of patterns: 10 while the text is read, `number_of_waves` afterwards.
    pub fn waves(&self) -> usize {
        self.waves.load(Relaxed) as usize
    }

    pub fn set_waves(&self, waves: usize) {
        self.waves.store(waves.min(u32::MAX as usize) as u32, Relaxed);
    }
}
