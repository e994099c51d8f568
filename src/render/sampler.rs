use super::Sampler;
use crate::picture::Pixel;
use crate::trace::Tracer;

impl Sampler for Tracer<'_> {
    fn seed(&mut self, x: u32, y: u32, sample: u32) {
        Tracer::seed(self, x, y, sample);
    }

    fn sample(&mut self, x: f64, y: f64) -> Pixel {
        self.pixel(x + 0.5, y + 0.5)
    }

    fn begin_block(&mut self, serial: usize) {
        Tracer::begin_block(self, serial);
    }

    fn rays(&self) -> u64 {
        let c = self.counters();
        c.camera_rays + c.shadow_rays + c.reflected_rays + c.refracted_rays + c.gather_rays
    }
}
