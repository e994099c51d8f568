//! Ctrl-C.

use super::exit::Exit;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};

static REQUESTED: AtomicBool = AtomicBool::new(false);
static TIMES: AtomicU32 = AtomicU32::new(0);

/// From now on the first Ctrl-C (or SIGTERM) is a request that [`requested`] shows; the second ends the
/// process.
pub fn listen() {
    // A handler that cannot be set leaves the system's own: the process ends at once.
    let _ = ctrlc::set_handler(|| {
        REQUESTED.store(true, Ordering::Relaxed);
        if TIMES.fetch_add(1, Ordering::Relaxed) > 0 {
            std::process::exit(i32::from(Exit::Interrupted.code()));
        }
    });
}

/// Whether the user wants to stop.
pub fn requested() -> bool {
    REQUESTED.load(Ordering::Relaxed)
}

/// From now on Ctrl-C ends the process: nothing is unfinished.
pub fn end_at_once() {
    let _ = ctrlc::set_handler(|| std::process::exit(i32::from(Exit::Interrupted.code())));
}
