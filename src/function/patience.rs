//! Functions may call each other in ever more ways, and sum without end: on a thread that is told when to
//! stop they give up then.

use std::cell::Cell;
use std::time::Instant;

thread_local! {
    /// Steps until the clock is looked at again.
    static STEPS: Cell<u32> = const { Cell::new(u32::MAX) };
    static END: Cell<Option<Instant>> = const { Cell::new(None) };
}

/// Calls and passes of loops between two looks at the clock.
const INTERVAL: u32 = 1 << 16;

/// Functions that run on this thread after `end` give up; what they give then means nothing.
pub fn give_up_at(end: Option<Instant>) {
    END.set(end);
    STEPS.set(if end.is_some() { INTERVAL } else { u32::MAX });
}

/// Whether functions on this thread have given up.
#[inline]
pub fn gave_up() -> bool {
    STEPS.get() == 0 && is_over()
}

fn is_over() -> bool {
    END.get().is_some_and(|end| Instant::now() > end)
}

/// Counts a call or a pass of a loop; false if there is no time left.
#[inline]
pub(super) fn step() -> bool {
    let left = STEPS.get();
    if left > 0 {
        STEPS.set(left - 1);
        return true;
    }
    look()
}

#[cold]
fn look() -> bool {
    let goes_on = !is_over();
    if goes_on {
        STEPS.set(INTERVAL);
    }
    goes_on
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    #[test]
    fn steps_end_with_the_time() {
        assert!((0..3 * INTERVAL).all(|_| step()) && !gave_up());
        give_up_at(Some(Instant::now() + Duration::from_secs(3600)));
        assert!((0..3 * INTERVAL).all(|_| step()) && !gave_up());
        give_up_at(Instant::now().checked_sub(Duration::from_millis(1)));
        assert!((0..3 * INTERVAL).filter(|_| step()).count() <= INTERVAL as usize && gave_up());
        give_up_at(None);
        assert!((0..3 * INTERVAL).all(|_| step()));
    }
}
