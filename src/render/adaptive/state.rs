//! One adaptive render from its first sample to its last.

use super::calibration::{Calibration, Measured};
use super::coarse::stand_ins;
use super::convergence::{Convergence, level};
use super::estimate::{Expected, Survey};
use super::gaps::Gaps;
use super::lift::{lift, lifted};
use super::locality::{Locality, Shown};
use super::order;
use super::plan::{Planner, Task};
use super::sequence::{Sequence, mix};
use super::tally::{Samples, Tally};
use super::wide;
use super::{Adaptive, Clock, Ended};
use crate::picture::light::Light;
use crate::picture::{Picture, Pixel};
use crate::render::{Observer, Sampler};
use std::ops::Range;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Samples that a thread takes on at a time, about.
const CHUNK: usize = 16;
/// Tasks that are carried out before what they found is taken in.
const SEGMENT: usize = 1 << 15;
/// Of two pixels alike the one whose error was put too low is left as it is: squared errors are so much larger than
/// expected, once some were chosen (measured over the twelve scenes of `benches/promises.py`).
const SELECTION: f64 = 1.35;
/// From so many samples on all lie at places of equal right.
const MANY: u32 = 32;
/// A survey is begun if there is time for this many of its kind.
const SURVEY_MARGIN: f64 = 2.0;

pub struct State<'a, S> {
    settings: &'a Adaptive,
    pool: &'a rayon::ThreadPool,
    picture: &'a Mutex<Picture>,
    observer: &'a dyn Observer,
    clock: &'a dyn Clock,
    /// One per thread.
    samplers: Vec<Mutex<S>>,
    tally: Tally,
    /// All pixels, square by square.
    order: Vec<u32>,
    /// The last doubling of each pixel.
    shown: Vec<Shown>,
    survey: Survey,
    calibration: Calibration,
    convergence: Convergence,
    gaps: Gaps,
    samples: u64,
    rounds: u32,
    /// Seconds that the last survey and plan took.
    surveying: f64,
}

/// New samples of one pixel.
struct Found {
    samples: Samples,
    /// Squared difference between their halves.
    half_jump: f32,
}

impl<'a, S: Sampler + Send> State<'a, S> {
    pub fn new(
        settings: &'a Adaptive,
        pool: &'a rayon::ThreadPool,
        picture: &'a Mutex<Picture>,
        observer: &'a dyn Observer,
        clock: &'a dyn Clock,
        samplers: Vec<Mutex<S>>,
    ) -> Self {
        let tally = Tally::new(settings.region);
        State {
            survey: Survey::new(&tally),
            order: order::tiled(tally.width(), tally.height()),
            shown: vec![Shown::default(); tally.pixels.len()],
            tally,
            settings,
            pool,
            picture,
            observer,
            clock,
            samplers,
            calibration: Calibration::default(),
            convergence: Convergence::default(),
            gaps: Gaps::default(),
            samples: 0,
            rounds: 0,
            surveying: 0.0,
        }
    }

    pub fn samples(&self) -> u64 {
        self.samples
    }

    pub fn rounds(&self) -> u32 {
        self.rounds
    }

    pub fn into_samplers(self) -> Vec<S> {
        self.samplers.into_iter().map(|s| s.into_inner().expect("threads do not panic")).collect()
    }

    /// Renders; why it ended, and the error that is expected of the picture.
    pub fn run(&mut self) -> (Ended, Option<f64>) {
        let mut base = self.base_tasks();
        let mut ended = self.round(&base);
        if ended.is_none() && self.settings.has_gaps() {
            let aim = self.settings.target.map_or(0.0, |t| 3.0 * t * t) as f32;
            let more = self.gaps.begin(&self.tally, &self.settings.light, aim);
            ended = self.round(&more);
            base.extend(more);
        }
        let is_missing = |pixel: u32| self.tally.pixels[pixel as usize].count == 0;
        if base.iter().any(|task| is_missing(task.pixel)) {
            let ended = ended.unwrap_or(Ended::Time);
            if ended != Ended::Cancelled {
                self.fill();
            }
            return (ended, None);
        }
        loop {
            let begun = self.clock.seconds();
            let mut expected = self.survey();
            let total = total(&expected);
            let rmse = self.rmse(total);
            self.observer.surveyed(self.samples, rmse);
            if self.settings.target.is_some_and(|target| rmse <= target) {
                self.finish();
                return (Ended::Converged, Some(rmse));
            }
            let tasks = self.plan(&expected, total);
            self.surveying = self.clock.seconds() - begun;
            let ended = match tasks.is_empty() {
                true => Some(Ended::Converged),
                false => self.round(&tasks),
            };
            if let Some(ended) = ended {
                self.foresee(&mut expected, &tasks);
                self.finish();
                return (ended, Some(self.rmse(self::total(&expected))));
            }
            self.rounds += 1;
        }
    }

    fn selection(&self) -> f64 {
        if self.rounds == 0 { 1.0 } else { SELECTION }
    }

    fn rmse(&self, total: f64) -> f64 {
        (self.selection() * total / (3 * self.tally.pixels.len().max(1)) as f64).sqrt()
    }

    fn sequence(&self, i: usize) -> Sequence {
        let (x, y) = self.tally.place(i);
        let make = if self.base() >= MANY { Sequence::even } else { Sequence::new };
        make(x, y, self.settings.seed)
    }

    /// How many samples every pixel gets.
    fn base(&self) -> u32 {
        match self.settings.base {
            0 | 1 => 1,
            n => n.next_power_of_two().max(4),
        }
    }

    fn base_tasks(&self) -> Vec<Task> {
        let (width, height) = (self.tally.width(), self.tally.height());
        let pixels = if self.settings.is_limited() {
            order::gradual(width, height)
        } else if self.settings.has_gaps() {
            order::spaced(width, height, wide::SPACING)
        } else {
            self.order.clone()
        };
        let count = self.base();
        pixels.into_iter().map(|pixel| Task::first(pixel, count)).collect()
    }

    /// Corrected expectations of all pixels.
    fn survey(&mut self) -> Vec<Expected> {
        self.convergence = self.calibration.convergence();
        if self.settings.has_gaps() {
            self.gaps.fill(&mut self.tally, &self.settings.light, self.survey.changed());
        }
        let tally = &self.tally;
        let (light, convergence, survey) = (&self.settings.light, &self.convergence, &mut self.survey);
        let mut expected = self.pool.install(|| survey.look(tally, light, convergence));
        if self.rounds == 0 && !self.settings.has_gaps() {
            for surprise in self.survey.surprises() {
                self.calibration.record_surprise(self.convergence.error_from_jump(0, surprise));
            }
        }
        let factors = self.calibration.factors();
        let locality = Locality::new(&self.tally, &self.shown);
        let width = self.tally.width();
        let rows = expected.chunks_mut(width.max(1)).zip(self.tally.pixels.chunks(width.max(1)));
        for (y, (expected, samples)) in rows.enumerate() {
            for (x, (e, samples)) in expected.iter_mut().zip(samples).enumerate() {
                if samples.count > 0 {
                    e.local = e.plain * locality.factor(x, y);
                    e.variance = factors.corrected(level(samples.count), e.local);
                }
            }
        }
        if self.settings.has_gaps() {
            self.gaps.expect(&self.tally, &mut expected);
        }
        expected
    }

    fn plan(&self, expected: &[Expected], total: f64) -> Vec<Task> {
        let planner = Planner {
            tally: &self.tally,
            order: &self.order,
            expected,
            calibration: &self.calibration,
            gaps: &self.gaps,
            convergence: &self.convergence,
            samples: self.samples,
            total,
            round: self.rounds,
            is_limited: self.settings.is_limited(),
        };
        planner.tasks(self.settings.target.map(|t| t * t * (3 * expected.len()) as f64 / SELECTION))
    }

    /// Carries out tasks in order, as many as are allowed; whether and why the render ends with them.
    fn round(&mut self, tasks: &[Task]) -> Option<Ended> {
        let allowed = self.settings.max_samples.map_or(u64::MAX, |m| m.saturating_sub(self.samples));
        let mut spent = 0;
        let within = tasks.iter().take_while(|t| {
            let fits = spent < allowed;
            spent += u64::from(t.to - self.tally.pixels[t.pixel as usize].count);
            fits
        });
        let within = within.count();
        let chunk = self.chunk(tasks);
        let mut done = 0;
        for (k, segment) in tasks[..within].chunks(SEGMENT).enumerate() {
            let found = self.trace(segment, k * SEGMENT, chunk);
            for (task, found) in segment.iter().zip(found.iter().flatten()) {
                self.merge(task, found);
                done += 1;
            }
            if done < k * SEGMENT + segment.len() {
                break;
            }
        }
        if done < within {
            return Some(if self.observer.cancelled() { Ended::Cancelled } else { Ended::Time });
        }
        // Where time ends a whole round, all its samples being spent ends it too: the picture is the same.
        if within < tasks.len() || self.settings.max_samples.is_some_and(|max| self.samples >= max) {
            return Some(Ended::Samples);
        }
        self.is_late(SURVEY_MARGIN * self.surveying).then_some(Ended::Time)
    }

    /// Whether the deadline is no more than so many seconds away.
    fn is_late(&self, margin: f64) -> bool {
        self.settings.deadline.is_some_and(|deadline| self.clock.seconds() + margin >= deadline)
    }

    fn merge(&mut self, task: &Task, found: &Found) {
        let old = &mut self.tally.pixels[task.pixel as usize];
        if old.count == 0 && task.plain > 0.0 {
            let light = &self.settings.light;
            let jump = squared_distance(light, &old.pixel(), &found.samples.pixel());
            let kind = usize::from(self.gaps.is_wide(task.pixel as usize));
            self.gaps.record(kind, task.plain, jump, task.local);
        }
        if old.count > 0 {
            let shown = lifted(&old.pixel(), self.survey.around[task.pixel as usize].lift);
            let jump = squared_distance(&self.settings.light, &shown, &found.samples.pixel());
            let error = self.convergence.error_from_jump(level(old.count), jump);
            self.shown[task.pixel as usize] = Shown { expected: task.plain, measured: error };
            self.calibration.record(&Measured {
                level: level(old.count),
                expected: task.local,
                error,
                jump,
                half_jump: found.half_jump,
            });
        }
        self.samples += u64::from(found.samples.count);
        *old = old.join(&found.samples);
        self.survey.touch(task.pixel as usize);
    }

    /// How many of a round's tasks a thread takes on at a time.
    fn chunk(&self, tasks: &[Task]) -> usize {
        let new: u64 =
            tasks.iter().map(|t| u64::from(t.to - self.tally.pixels[t.pixel as usize].count)).sum();
        (CHUNK * tasks.len()).checked_div(new as usize).unwrap_or(1).clamp(1, CHUNK)
    }

    /// The results of the first so many tasks, chunk by chunk: of all, unless time is up. Tasks are begun in order and what
    /// is begun is finished, so that nothing is missing in between. What samplers keep from sample to sample
    /// depends on the chunk alone.
    fn trace(&self, tasks: &[Task], before: usize, chunk: usize) -> Vec<Vec<Found>> {
        let next = AtomicUsize::new(0);
        let results: Mutex<Vec<(usize, Vec<Found>)>> = Mutex::new(Vec::new());
        self.pool.broadcast(|thread| {
            let mut sampler = self.samplers[thread.index()].lock().expect("threads do not panic");
            // However little time there is, a round that was begun adds something: the survey before it has
            // changed what the picture hangs on, and a repetition by number of samples has to come that far.
            let is_first = || before == 0 && next.load(Ordering::Relaxed) == 0;
            while !self.observer.cancelled() && (is_first() || !self.is_late(0.0)) {
                let first = next.fetch_add(chunk, Ordering::Relaxed);
                let Some(tasks) = tasks.get(first..).filter(|t| !t.is_empty()) else { break };
                let tasks = &tasks[..tasks.len().min(chunk)];
                let rays = sampler.rays();
                sampler.begin_block(((self.rounds as usize) << 20) ^ ((before + first) / chunk));
                let found: Vec<Found> = tasks.iter().map(|t| self.sample(t, &mut sampler)).collect();
                self.show(tasks, &found, sampler.rays() - rays);
                results.lock().expect("threads do not panic").push((first, found));
            }
        });
        let mut results = results.into_inner().expect("threads do not panic");
        results.sort_by_key(|r| r.0);
        results.into_iter().map(|r| r.1).collect()
    }

    fn sample(&self, task: &Task, sampler: &mut S) -> Found {
        let i = task.pixel as usize;
        let (x, y) = self.tally.place(i);
        let sequence = self.sequence(i);
        let before = sampler.rays();
        sampler.begin_block(i);
        let draws = if self.settings.seed == 0 { 0 } else { mix(self.settings.seed) };
        let mut run = |numbers: Range<u32>| {
            Samples::of(numbers.map(|k| {
                let (dx, dy) = sequence.offset(k);
                sampler.seed(x, y, k ^ draws);
                sampler.sample(f64::from(x) + dx, f64::from(y) + dy)
            }))
        };
        let from = self.tally.pixels[i].count;
        let middle = from + (task.to - from) / 2;
        let (a, b) = (run(from..middle), run(middle..task.to));
        let half_jump = match a.count {
            0 => 0.0,
            _ => squared_distance(&self.settings.light, &a.pixel(), &b.pixel()),
        };
        let samples = Samples { rays: (sampler.rays() - before) as f32, ..a.join(&b) };
        Found { samples, half_jump }
    }

    /// Draws what has been found so that others can look at it.
    fn show(&self, tasks: &[Task], found: &[Found], rays: u64) {
        let mut first = 0;
        let mut picture = self.picture.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        for (task, found) in tasks.iter().zip(found) {
            let old = &self.tally.pixels[task.pixel as usize];
            first += u64::from(old.count == 0);
            let (x, y) = self.tally.place(task.pixel as usize);
            picture.set(x, y, old.join(&found.samples).pixel());
        }
        drop(picture);
        self.observer.block_done(first, rays);
    }

    /// Takes from expectations what tasks that were carried out have taken away.
    fn foresee(&self, expected: &mut [Expected], tasks: &[Task]) {
        for task in tasks {
            let i = task.pixel as usize;
            if self.tally.pixels[i].count == task.to {
                let e = &mut expected[i];
                match task.from {
                    0 => e.variance = task.local,
                    from => e.variance *= self.convergence.ratio[level(from)],
                }
            }
        }
    }

    /// The final picture.
    fn finish(&self) {
        let width = self.tally.width();
        let mut picture = self.picture.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        let region = &self.tally.region;
        let places = (0..self.tally.height()).flat_map(|y| (0..width).map(move |x| (x, y)));
        for (samples, (x, y)) in self.tally.pixels.iter().zip(places) {
            let pixel = match samples.count {
                0 => samples.pixel(),
                _ => lifted(&samples.pixel(), lift(&self.tally, x, y)),
            };
            picture.set(region.x0 + x as u32, region.y0 + y as u32, pixel);
        }
    }

    /// The final picture where not every pixel has samples.
    fn fill(&self) {
        let mut picture = self.picture.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        for (i, stand_in) in stand_ins(&self.tally).into_iter().enumerate() {
            if let Some(j) = stand_in {
                let (x, y) = self.tally.place(i);
                picture.set(x, y, self.tally.pixels[j as usize].pixel());
            }
        }
    }
}

/// Squared error of the whole picture, over its channels.
fn total(expected: &[Expected]) -> f64 {
    expected.iter().map(|e| f64::from(e.variance)).sum()
}

/// Squared difference of two colours in light.
fn squared_distance(light: &Light, p: &Pixel, q: &Pixel) -> f32 {
    let (p, q) = (light.pixel(p), light.pixel(q));
    (0..3).map(|k| (q[k] - p[k]).powi(2)).sum()
}
