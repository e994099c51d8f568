//! Room for deep nesting, and panics kept to one scene.

use super::exit::Failure;
use std::path::Path;
use std::thread;

/// Only what is touched is used.
pub const BYTES: usize = 256 << 20;

/// Runs work on a thread with a large stack. A panic becomes the scene's failure.
pub fn with_room<T: Send>(
    scene: &Path,
    work: impl FnOnce() -> Result<T, Failure> + Send,
) -> Result<T, Failure> {
    thread::scope(|scope| {
        let thread = thread::Builder::new().name("scene".into()).stack_size(BYTES).spawn_scoped(scope, work);
        let thread = thread.map_err(|e| Failure::unavailable(format!("cannot start a thread: {e}")))?;
        thread.join().unwrap_or_else(|_| Err(broken(scene)))
    })
}

/// What is said after a panic, which has been printed already.
pub fn broken(scene: &Path) -> Failure {
    Failure::failed(format!("{}: an internal error ended the work (a bug in Glint)", scene.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_a_failure() {
        let result: Result<(), _> = with_room(Path::new("a.pov"), || panic!("expected by the test"));
        assert!(result.unwrap_err().message.starts_with("a.pov: an internal error"));
        assert_eq!(with_room(Path::new("a.pov"), || Ok(3)), Ok(3));
    }
}
