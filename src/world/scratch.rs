//! Lists that rays fill and empty again, kept per thread so that no ray allocates.

use super::geometry::Found;
use crate::shape::Crossing;
use std::cell::RefCell;

thread_local! {
    static CROSSINGS: RefCell<Vec<Vec<Crossing>>> = const { RefCell::new(Vec::new()) };
    static FOUND: RefCell<Vec<Vec<Found>>> = const { RefCell::new(Vec::new()) };
}

/// Runs `work` with an empty list; nested calls get lists of their own.
pub(super) fn with_crossings<R>(work: impl FnOnce(&mut Vec<Crossing>) -> R) -> R {
    let mut list = CROSSINGS.with_borrow_mut(Vec::pop).unwrap_or_default();
    list.clear();
    let result = work(&mut list);
    CROSSINGS.with_borrow_mut(|pool| pool.push(list));
    result
}

/// Runs `work` with an empty list; nested calls get lists of their own.
pub(super) fn with_found<R>(work: impl FnOnce(&mut Vec<Found>) -> R) -> R {
    let mut list = FOUND.with_borrow_mut(Vec::pop).unwrap_or_default();
    list.clear();
    let result = work(&mut list);
    FOUND.with_borrow_mut(|pool| pool.push(list));
    result
}
