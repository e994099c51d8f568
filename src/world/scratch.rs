//! Lists that rays fill and empty again, kept per thread so that no ray allocates.

use super::geometry::Found;
use crate::shape::Crossing;
use std::cell::RefCell;

/// Crossings of combinations, used as a stack, and of the one shape that is being asked.
#[derive(Debug, Default)]
pub(super) struct Lists {
    pub found: Vec<Found>,
    pub crossings: Vec<Crossing>,
}

thread_local! {
    static LISTS: RefCell<Lists> = const { RefCell::new(Lists { found: Vec::new(), crossings: Vec::new() }) };
}

/// Runs `work` with empty lists; nested calls get new ones.
#[inline]
pub(super) fn with_lists<R>(work: impl FnOnce(&mut Lists) -> R) -> R {
    LISTS.with(|lists| match lists.try_borrow_mut() {
        Ok(mut lists) => {
            lists.found.clear();
            work(&mut lists)
        }
        Err(_) => work(&mut Lists::default()),
    })
}
