//! The same work for each of many files, on all processors.

use rayon::prelude::*;

/// So many items a thread takes at least: for fewer it would take longer to wake.
const BATCH: usize = 8;

/// What `work` gives for each item, in the order of the items. `None` where it gives nothing.
pub(crate) fn map<T: Sync, U: Send>(items: &[T], work: impl Fn(&T) -> Option<U> + Sync) -> Vec<U> {
    items.par_iter().with_min_len(BATCH).filter_map(&work).collect()
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
