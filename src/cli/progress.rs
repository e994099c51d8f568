//! How far a render is: a bar on a terminal, a line every few seconds elsewhere.

use crate::picture::Picture;
use crate::render::Observer;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Mutex, MutexGuard};
use std::time::{Duration, Instant};

/// A picture while it is traced, and the work done so far.
pub struct Canvas {
    pub picture: Mutex<Picture>,
    pub started: Instant,
    total: u64,
    pixels: AtomicU64,
    rays: AtomicU64,
    /// The bits of the error that is expected of the picture; none known while it is 0.
    expected: AtomicU64,
    cancelled: AtomicBool,
}

impl Canvas {
    /// `total` counts the pixels that will be traced.
    pub fn new(picture: Picture, total: u64) -> Self {
        Self {
            picture: Mutex::new(picture),
            started: Instant::now(),
            total,
            pixels: AtomicU64::new(0),
            rays: AtomicU64::new(0),
            expected: AtomicU64::new(0),
            cancelled: AtomicBool::new(false),
        }
    }

    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// The picture as it is now.
    pub fn snapshot(&self) -> Picture {
        self.lock().clone()
    }

    /// The picture itself; nobody can draw meanwhile.
    pub fn lock(&self) -> MutexGuard<'_, Picture> {
        self.picture.lock().unwrap_or_else(|poisoned| poisoned.into_inner())
    }

    pub fn was_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }

    pub fn pixels(&self) -> u64 {
        self.pixels.load(Ordering::Relaxed)
    }

    /// The finished share in percent.
    pub fn percent(&self) -> u64 {
        self.pixels() * 100 / self.total.max(1)
    }

    fn rays_per_second(&self) -> f64 {
        self.rays.load(Ordering::Relaxed) as f64 / self.started.elapsed().as_secs_f64().max(1e-9)
    }

    /// The RMSE in light that is expected of the picture, if sampling is adaptive and has got so far.
    fn expected(&self) -> Option<f64> {
        Some(f64::from_bits(self.expected.load(Ordering::Relaxed))).filter(|e| *e > 0.0)
    }

    /// Seconds left if the rest is as hard as what has been traced.
    fn seconds_left(&self) -> Option<f64> {
        let done = self.pixels();
        let left = self.total.saturating_sub(done) as f64;
        (done > 0).then(|| self.started.elapsed().as_secs_f64() * left / done as f64)
    }
}

impl Observer for Canvas {
    fn cancelled(&self) -> bool {
        self.was_cancelled()
    }

    fn block_done(&self, pixels: u64, rays: u64) {
        self.pixels.fetch_add(pixels, Ordering::Relaxed);
        self.rays.fetch_add(rays, Ordering::Relaxed);
    }

    fn surveyed(&self, _samples: u64, rmse: f64) {
        self.expected.store(rmse.to_bits(), Ordering::Relaxed);
    }
}

/// Shows the progress of one render on stderr.
pub struct Display {
    name: String,
    bar: Option<ProgressBar>,
    quiet: bool,
    last_line: Instant,
}

/// Between two lines where there is no terminal.
const LINE_INTERVAL: Duration = Duration::from_secs(5);

impl Display {
    pub fn new(name: &str, quiet: bool) -> Self {
        Self { name: name.to_owned(), bar: None, quiet, last_line: Instant::now() }
    }

    /// Called several times a second.
    pub fn update(&mut self, canvas: &Canvas) {
        if self.quiet {
            return;
        }
        if std::io::stderr().is_terminal() {
            self.update_bar(canvas);
        } else if self.last_line.elapsed() >= LINE_INTERVAL {
            self.last_line = Instant::now();
            eprintln!("{}: {} %, {}", self.name, canvas.percent(), message(canvas));
        }
    }

    fn update_bar(&mut self, canvas: &Canvas) {
        let bar = self.bar.get_or_insert_with(|| {
            let bar = ProgressBar::with_draw_target(Some(canvas.total), ProgressDrawTarget::stderr());
            let style = ProgressStyle::with_template("{prefix} [{bar:40}] {percent}% {msg}");
            bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()).progress_chars("=> "));
            bar.set_prefix(self.name.clone());
            bar
        });
        bar.set_message(message(canvas));
        bar.set_position(canvas.pixels());
    }

    /// Removes the bar.
    pub fn finish(&mut self) {
        if let Some(bar) = self.bar.take() {
            bar.finish_and_clear();
        }
    }
}

fn message(canvas: &Canvas) -> String {
    let rate = rays_per_second(canvas.rays_per_second());
    if let Some(rmse) = canvas.expected() {
        return format!("{rate}, error {rmse:.4}");
    }
    match canvas.seconds_left() {
        Some(left) => format!("{rate}, {} left", duration(left)),
        None => rate,
    }
}

/// `1.25 Mrays/s` and the like.
pub fn rays_per_second(rate: f64) -> String {
    if rate >= 1e6 { format!("{:.2} Mrays/s", rate / 1e6) } else { format!("{:.1} krays/s", rate / 1e3) }
}

/// `1 h 02 min`, `3 min 05 s`, `12 s`.
pub fn duration(seconds: f64) -> String {
    let s = seconds.round().max(0.0) as u64;
    match (s / 3600, s / 60 % 60, s % 60) {
        (0, 0, s) => format!("{s} s"),
        (0, m, s) => format!("{m} min {s:02} s"),
        (h, m, _) => format!("{h} h {m:02} min"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn durations_read_well() {
        assert_eq!([duration(0.4), duration(59.6), duration(3725.0)], ["0 s", "1 min 00 s", "1 h 02 min"]);
    }

    #[test]
    fn a_canvas_counts_blocks() {
        let canvas = Canvas::new(Picture::new(10, 10), 100);
        assert_eq!((canvas.percent(), canvas.seconds_left()), (0, None));
        canvas.block_done(25, 1000);
        assert_eq!(canvas.percent(), 25);
        assert!(canvas.seconds_left().is_some() && canvas.rays_per_second() > 0.0);
        assert!(!canvas.cancelled());
        canvas.cancel();
        assert!(canvas.cancelled());
    }
}
