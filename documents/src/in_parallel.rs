//! The same work for each of many files, or stretches of one, on all processors.

use std::num::NonZero;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use ladder_ide::gathered;

/// This many items a thread takes at once: for fewer it would take longer to begin.
const BATCH: usize = 8;

/// Does some work for each item, with its number. The threads end with the work: one that waits for more keeps the memory
/// that it worked with from all others.
pub(crate) fn each<T: Sync>(items: &[T], work: impl Fn(usize, &T) + Sync) {
    let batches = items.len().div_ceil(BATCH);
    let processors = thread::available_parallelism().map_or(1, NonZero::get);
    let next = AtomicUsize::new(0);
    let take_on = || {
        loop {
            let first = next.fetch_add(BATCH, Ordering::Relaxed);
            let Some(rest) = items.get(first..).filter(|rest| !rest.is_empty()) else {
                return;
            };
            for (number, item) in (first..).zip(rest.iter().take(BATCH)) {
                work(number, item);
            }
        }
    };
    thread::scope(|scope| {
        for _ in 1..processors.min(batches) {
            scope.spawn(take_on);
        }
        take_on();
    });
}

/// What `work` gives for each item, in the order of the items. `None` where it gives nothing.
pub fn map<T: Sync, U: Send>(items: &[T], work: impl Fn(&T) -> Option<U> + Sync) -> Vec<U> {
    gathered(|take| {
        each(items, |number, item| {
            if let Some(one) = work(item) {
                take(number, one);
            }
        });
    })
}

#[cfg(test)]
mod tests {
    use super::map;

    #[test]
    fn the_order_stays() {
        for count in [0, 3, 500] {
            let items: Vec<u32> = (0..count).collect();
            let even: Vec<u32> = items.iter().copied().filter(|n| n % 2 == 0).collect();
            assert_eq!(map(&items, |&n| (n % 2 == 0).then_some(n)), even);
        }
    }
}
