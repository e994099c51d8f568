//! What the process has cost so far.

use crate::render::adaptive::Clock;
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Seconds since it was made.
#[derive(Clone, Copy, Debug)]
pub struct Wall(Instant);

impl Wall {
    pub fn start() -> Self {
        Self(Instant::now())
    }

    /// Since the process began, where the system tells; else since now.
    pub fn of_process() -> Self {
        let now = Instant::now();
        Self(process_age().and_then(|age| now.checked_sub(age)).unwrap_or(now))
    }
}

impl Clock for Wall {
    fn seconds(&self) -> f64 {
        self.0.elapsed().as_secs_f64()
    }
}

/// How long ago the process began, to a hundredth of a second.
fn process_age() -> Option<Duration> {
    /// In which Linux gives times to programs, whatever it uses itself.
    const TICKS_PER_SECOND: f64 = 100.0;
    let uptime = std::fs::read_to_string("/proc/uptime").ok()?;
    let uptime: f64 = uptime.split_whitespace().next()?.parse().ok()?;
    let stat = std::fs::read_to_string("/proc/self/stat").ok()?;
    // The name in brackets may hold anything; what follows it begins with the third field.
    let begun: f64 = stat.rsplit_once(')')?.1.split_whitespace().nth(19)?.parse().ok()?;
    Duration::try_from_secs_f64(uptime - begun / TICKS_PER_SECOND).ok()
}

/// CPU seconds of all threads of the process, since it began.
pub fn cpu_seconds() -> f64 {
    use rustix::time::{ClockId, clock_gettime};
    let t = clock_gettime(ClockId::ProcessCPUTime);
    Duration::new(t.tv_sec as u64, t.tv_nsec as u32).as_secs_f64()
}

/// The largest resident size so far, or 0 where the system does not tell.
pub fn peak_rss_bytes() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let kib = |line: &str| line.strip_prefix("VmHWM:")?.trim().strip_suffix("kB")?.trim().parse::<u64>().ok();
    status.lines().find_map(kib).unwrap_or(0) * 1024
}

/// Shares out the CPU time of the process, none left over.
pub struct Lap<'a> {
    counted: &'a Mutex<f64>,
    start: f64,
    last: f64,
}

impl<'a> Lap<'a> {
    /// Goes on where the work before ended, as `counted` says; the first lap holds the start of the process
    /// too.
    pub fn new(counted: &'a Mutex<f64>) -> Self {
        let start = *counted.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        Self { counted, start, last: start }
    }

    /// CPU seconds since the last call.
    pub fn next(&mut self) -> f64 {
        let now = cpu_seconds();
        let lap = now - self.last;
        self.last = now;
        lap
    }

    /// CPU seconds of all the work up to now.
    pub fn total(&mut self) -> f64 {
        let now = cpu_seconds();
        *self.counted.lock().unwrap_or_else(|poisoned| poisoned.into_inner()) = now;
        now - self.start
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_takes_time_and_memory() {
        let before = cpu_seconds();
        let mut n = 1u64;
        for i in 0..20_000_000u64 {
            n = std::hint::black_box(n.wrapping_mul(6364136223846793005).wrapping_add(i));
        }
        assert!(cpu_seconds() > before, "{n}");
        assert!(peak_rss_bytes() > 1 << 20);
    }

    #[test]
    fn a_process_is_older_than_its_tests() {
        let (process, now) = (Wall::of_process(), Wall::start());
        assert!(process.seconds() >= now.seconds() && process.seconds() < 3600.0);
        assert!(process_age().is_some());
    }

    #[test]
    fn laps_add_up() {
        let counted = Mutex::new(0.0);
        let mut lap = Lap::new(&counted);
        let parts = lap.next() + lap.next();
        let total = lap.total();
        assert!((parts - total).abs() < 0.05 * total + 1e-3);
        assert!(Lap::new(&counted).start >= total);
    }
}
