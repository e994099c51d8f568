//! Watches a render from outside: progress, partial pictures, Ctrl-C.

use super::job::{Job, Live, Task};
use super::plan::Plan;
use super::report::RenderReport;
use crate::cli::exit::{Exit, Failure};
use crate::cli::progress::Display;
use crate::cli::streams::Stream;
use crate::cli::{interrupt, stack};
use std::path::Path;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};

/// How often the monitor looks.
const TICK: Duration = Duration::from_millis(25);
/// How long a render may take to notice Ctrl-C before it is left behind.
const PATIENCE: Duration = Duration::from_millis(250);
/// Between two partial pictures.
const PARTIAL_INTERVAL: Duration = Duration::from_secs(3);

/// Renders one scene on a thread of its own and watches it from this one.
pub fn render(plan: &Plan, task: &Task) -> Result<RenderReport, Failure> {
    let job = Job::new(plan, task);
    thread::scope(|scope| {
        let (done, finished) = channel();
        let running = &job;
        let work = move || {
            let result = running.run();
            // The monitor waits for as long as the thread runs.
            let _ = done.send(());
            result
        };
        let thread =
            thread::Builder::new().name("scene".into()).stack_size(stack::BYTES).spawn_scoped(scope, work);
        let thread = thread.map_err(|e| Failure::unavailable(format!("cannot start a thread: {e}")))?;
        watch(&job, plan, &task.scene, &finished);
        thread.join().unwrap_or_else(|_| Err(stack::broken(&task.scene)))
    })
}

/// Returns when the job is finished.
fn watch(job: &Job, plan: &Plan, scene: &Path, finished: &Receiver<()>) {
    let mut display = Display::new(&scene.display().to_string(), !plan.streams.is_on_console(Stream::Render));
    let mut written = Instant::now();
    while finished.recv_timeout(TICK) == Err(RecvTimeoutError::Timeout) {
        let live = job.live();
        if interrupt::requested() {
            display.finish();
            stop(live, finished);
            return;
        }
        let Some(live) = live else { continue };
        display.update(&live.canvas);
        if plan.partial && written.elapsed() >= PARTIAL_INTERVAL {
            // The final picture will tell whether the file can be written.
            let _ = live.write();
            written = Instant::now();
        }
    }
    display.finish();
}

/// Asks the job to stop; one that does not listen is left behind with the process.
fn stop(live: Option<std::sync::Arc<Live>>, finished: &Receiver<()>) {
    let Some(live) = live else {
        eprintln!("interrupted before anything was traced");
        std::process::exit(i32::from(Exit::Interrupted.code()));
    };
    live.canvas.cancel();
    if finished.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout) {
        eprintln!("{}", live.leave());
        std::process::exit(i32::from(Exit::Interrupted.code()));
    }
}
