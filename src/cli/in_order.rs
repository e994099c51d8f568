//! Work on several things at a time, shown in their order.

use super::interrupt;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Cores of the machine.
pub fn cores() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

/// Does the work for all items, `jobs` at a time, and shows each result as soon as all those before it are
/// there. After Ctrl-C no new item is begun; what was done is given back.
pub fn in_order<T: Sync, R: Send>(
    items: &[T],
    jobs: usize,
    work: impl Fn(&T) -> R + Sync,
    show: impl FnMut(&T, &R) + Send,
) -> Vec<R> {
    let next = AtomicUsize::new(0);
    let claim = || {
        let i = next.fetch_add(1, Ordering::Relaxed);
        items.get(i).filter(|_| !interrupt::requested()).map(|item| (i, item))
    };
    let results = Mutex::new(Results { done: items.iter().map(|_| None).collect(), shown: 0, show });
    std::thread::scope(|scope| {
        for _ in 0..jobs.clamp(1, items.len().max(1)) {
            scope.spawn(|| {
                while let Some((i, item)) = claim() {
                    let result = work(item);
                    results.lock().unwrap_or_else(|poisoned| poisoned.into_inner()).put(items, i, result);
                }
            });
        }
    });
    let results = results.into_inner().unwrap_or_else(|poisoned| poisoned.into_inner());
    results.done.into_iter().flatten().collect()
}

struct Results<R, S> {
    done: Vec<Option<R>>,
    shown: usize,
    show: S,
}

impl<R, S> Results<R, S> {
    fn put<T>(&mut self, items: &[T], i: usize, result: R)
    where
        S: FnMut(&T, &R),
    {
        self.done[i] = Some(result);
        while let Some(Some(result)) = self.done.get(self.shown) {
            (self.show)(&items[self.shown], result);
            self.shown += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    #[test]
    fn results_are_shown_in_order() {
        let items: Vec<u64> = (0..20).collect();
        let mut shown = Vec::new();
        let work = |&n: &u64| {
            std::thread::sleep(Duration::from_millis((n * 7) % 5));
            n * n
        };
        let results = in_order(&items, 4, work, |&n, &r| shown.push((n, r)));
        assert_eq!(results, items.iter().map(|n| n * n).collect::<Vec<_>>());
        assert_eq!(shown, items.iter().map(|&n| (n, n * n)).collect::<Vec<_>>());
        assert!(in_order(&[0u8; 0], 4, |_| 1, |_, _| ()).is_empty());
    }
}
