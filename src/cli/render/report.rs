use super::accuracy::Reached;
use crate::cli::progress;
use serde::Serialize;

/// What `--json` prints for a scene. Times are CPU seconds of all threads where the name says `cpu`.
#[derive(Clone, Debug, Serialize)]
pub struct RenderReport {
    pub scene: String,
    pub output: String,
    pub width: u32,
    pub height: u32,
    pub threads: usize,
    /// Reading and converting all scene text.
    pub parse_cpu_s: f64,
    pub prepare_cpu_s: f64,
    pub trace_cpu_s: f64,
    /// Encoding and writing the picture.
    pub write_cpu_s: f64,
    pub process_cpu_s: f64,
    pub wall_s: f64,
    pub trace_wall_s: f64,
    pub camera_rays: u64,
    pub shadow_rays: u64,
    pub reflected_rays: u64,
    pub refracted_rays: u64,
    /// Colours that came out as no numbers, and were drawn black.
    pub not_numbers: u64,
    /// For diffuse light between surfaces.
    pub gather_rays: u64,
    /// Shot from lights.
    pub photons: u64,
    pub peak_rss_bytes: u64,
    /// What adaptive sampling came to; null for other methods.
    pub adaptive: Option<Reached>,
    pub warnings: Vec<String>,
    pub unsupported: Vec<String>,
}

impl RenderReport {
    /// The line on stderr.
    pub fn line(&self) -> String {
        let seen = self.camera_rays + self.reflected_rays + self.refracted_rays + self.gather_rays;
        let rays = seen + self.shadow_rays + self.photons;
        let reached = self.adaptive.as_ref().map_or(String::new(), |r| format!("; {}", r.text()));
        format!(
            "{} -> {} ({}x{}): parse {:.3} s, prepare {:.3} s, trace {:.3} s, write {:.3} s of CPU; {}{reached}",
            self.scene,
            self.output,
            self.width,
            self.height,
            self.parse_cpu_s,
            self.prepare_cpu_s,
            self.trace_cpu_s,
            self.write_cpu_s,
            progress::rays_per_second(rays as f64 / self.trace_wall_s.max(1e-9)),
        )
    }
}
