//! The same work for each of many files, on all processors.

use std::sync::Mutex;
use std::sync::PoisonError;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// Fewer items than this are done at once: threads would take longer to start.
const FEW: usize = 16;

/// So many items a thread takes at a time.
const BATCH: usize = 8;

/// What `work` gives for each item, in the order of the items. `None` where it gives nothing.
pub(crate) fn map<T: Sync, U: Send>(items: &[T], work: impl Fn(&T) -> Option<U> + Sync) -> Vec<U> {
    let threads = thread::available_parallelism().map_or(1, usize::from);
    if items.len() < FEW || threads == 1 {
        return items.iter().filter_map(work).collect();
    }
    let batches: Vec<&[T]> = items.chunks(BATCH).collect();
    let next = AtomicUsize::new(0);
    let done: Mutex<Vec<(usize, Vec<U>)>> = Mutex::new(Vec::with_capacity(batches.len()));
    thread::scope(|scope| {
        let worker = || {
            while let Some((number, batch)) = take(&batches, &next) {
                let made = batch.iter().filter_map(&work).collect();
                done.lock()
                    .unwrap_or_else(PoisonError::into_inner)
                    .push((number, made));
            }
        };
        for _ in 1..threads {
            scope.spawn(worker);
        }
        worker();
    });
    let mut done = done.into_inner().unwrap_or_else(PoisonError::into_inner);
    done.sort_by_key(|(number, _)| *number);
    done.into_iter().flat_map(|(_, made)| made).collect()
}

/// The next batch that nobody has taken, with its number.
fn take<'b, T>(batches: &[&'b [T]], next: &AtomicUsize) -> Option<(usize, &'b [T])> {
    let number = next.fetch_add(1, Ordering::Relaxed);
    batches.get(number).map(|batch| (number, *batch))
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
