//! Work on several cores.

use rayon::{ThreadPoolBuilder, prelude::*};
use std::{num::NonZero, thread};

/// How many pieces of work are done at a time: as many as was asked for, or one per core.
pub fn jobs(asked: Option<u16>) -> usize {
    asked.map_or_else(|| thread::available_parallelism().map_or(1, NonZero::get), usize::from)
}

/// Does `work` on all items, `jobs` at a time; results are in the order of the items.
pub fn in_parallel<T: Sync, R: Send>(items: &[T], jobs: usize, work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    match ThreadPoolBuilder::new().num_threads(jobs.clamp(1, items.len().max(1))).build() {
        // One by one, as some take much longer than others.
        Ok(pool) => pool.install(|| items.par_iter().with_max_len(1).map(&work).collect()),
        // A system that grants no threads.
        Err(_) => items.iter().map(work).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_are_in_the_order_of_the_items() {
        let items: Vec<usize> = (0..100).collect();
        for jobs in [0, 1, 3, 1000] {
            assert_eq!(
                in_parallel(&items, jobs, |item| 2 * item),
                items.iter().map(|item| 2 * item).collect::<Vec<_>>()
            );
        }
        assert!(in_parallel(&[0; 0], 2, |item| *item).is_empty());
    }
}
