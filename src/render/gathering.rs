//! The steps of the pretrace over all threads.
//!
//! Each step sees the steps before it but for a few ([`Pretrace::seen_by`]), never less and never more, so that
//! nothing depends on threads. A thread waits until those are finished, takes what they gathered into its own
//! copy of the cache, and goes on: no step waits for the end of a pass.

use super::Observer;
use crate::trace::{Counters, Gathered, Lighting, Pretrace, Progress, Sample, Tracer};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard};

/// All steps; what they leave behind, and what was counted.
pub fn gathered(
    pretrace: &Pretrace,
    pool: &rayon::ThreadPool,
    observer: &dyn Observer,
) -> (Option<Lighting>, Counters) {
    let ledger = Ledger::new(pretrace.steps());
    let next = AtomicUsize::new(0);
    let mut tracers = pool.broadcast(|_| {
        let _guard = ledger.closed_by_panic();
        let mut tracer = pretrace.tracer();
        let mut known = 0;
        loop {
            let step = next.fetch_add(1, Ordering::Relaxed);
            if step >= pretrace.steps() {
                return (tracer, known);
            }
            if observer.cancelled() {
                ledger.close();
            }
            if !ledger.tell(&mut tracer, &mut known, pretrace.seen_by(step)) {
                return (tracer, known);
            }
            let progress = pretrace.same_tile_before(step).and_then(|before| ledger.progress(before));
            ledger.write(step, pretrace.trace(&mut tracer, step, progress));
        }
    });
    let mut counters = Counters::default();
    tracers.iter().for_each(|(tracer, _)| counters += tracer.counters());
    tracers.truncate(1);
    let lighting = tracers.pop().and_then(|(mut tracer, mut known)| {
        ledger.tell(&mut tracer, &mut known, pretrace.steps());
        tracer.lighting()
    });
    (lighting, counters)
}

/// What finished steps gathered.
struct Ledger {
    pages: Mutex<Pages>,
    written: Condvar,
}

struct Pages {
    steps: Vec<Option<Gathered>>,
    /// All steps before are finished.
    full: usize,
    /// No more will come.
    closed: bool,
}

/// Closes the ledger of a thread that panics, so that no other waits for it.
struct Guard<'a>(&'a Ledger);

impl Drop for Guard<'_> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.0.close();
        }
    }
}

impl Ledger {
    fn new(steps: usize) -> Self {
        let pages = Pages { steps: (0..steps).map(|_| None).collect(), full: 0, closed: false };
        Self { pages: Mutex::new(pages), written: Condvar::new() }
    }

    fn closed_by_panic(&self) -> Guard<'_> {
        Guard(self)
    }

    fn close(&self) {
        self.open().closed = true;
        self.written.notify_all();
    }

    fn open(&self) -> MutexGuard<'_, Pages> {
        self.pages.lock().unwrap_or_else(|poisoned| poisoned.into_inner())
    }

    /// Waits for the first `wanted` steps and tells the tracer, which has heard of `known`. False if there will
    /// not be as many.
    fn tell(&self, tracer: &mut Tracer, known: &mut usize, wanted: usize) -> bool {
        let mut pages = self.open();
        while pages.full < wanted && !pages.closed {
            pages = self.written.wait(pages).unwrap_or_else(|poisoned| poisoned.into_inner());
        }
        let end = wanted.min(pages.full);
        let news = pages.steps.get(*known..end).unwrap_or_default().iter().flatten();
        let news: Vec<Arc<[Sample]>> = news.map(|g| g.samples.clone()).collect();
        let closed = pages.closed;
        drop(pages);
        news.iter().for_each(|samples| tracer.learn(samples));
        *known = end.max(*known);
        end == wanted && !closed
    }

    fn progress(&self, step: usize) -> Option<Progress> {
        self.open().steps.get(step)?.as_ref().map(|g| g.progress.clone())
    }

    fn write(&self, step: usize, gathered: Gathered) {
        let mut pages = self.open();
        pages.steps[step] = Some(gathered);
        while pages.steps.get(pages.full).is_some_and(Option::is_some) {
            pages.full += 1;
        }
        drop(pages);
        self.written.notify_all();
    }
}
