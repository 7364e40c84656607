//! Runs of a row in which counts change when strokes take the place of others.

use super::{moves::MOST_NEW, stroke::SampleRun};

/// Ends of all strokes of an exchange in a row, at most.
const MOST_ENDS: usize = 4 * (MOST_NEW + 1);
/// No end: behind all others.
const NONE: i32 = i32::MAX;
/// Columns where strokes begin and end in a row, times two, and one more where the count rises.
pub(super) struct RowEnds {
    keys: [i32; MOST_ENDS],
    count: usize,
}

/// Two sorted pairs in order.
#[inline]
fn merged((a, b): (i32, i32), (c, d): (i32, i32)) -> (i32, i32, i32, i32) {
    let (low, high) = (a.max(c), b.min(d));
    (a.min(c), low.min(high), low.max(high), b.max(d))
}

impl RowEnds {
    pub fn new() -> Self {
        Self { keys: [NONE; MOST_ENDS], count: 0 }
    }

    /// Forgets the ends of another row.
    #[inline]
    pub fn clear(&mut self) {
        self.keys[..8].fill(NONE);
        self.count = 0;
    }

    /// Takes the run of a stroke.
    #[inline]
    pub fn push(&mut self, (from, to): SampleRun, is_new: bool) {
        if from < to {
            self.keys[self.count] = from << 1 | i32::from(is_new);
            self.keys[self.count + 1] = to << 1 | i32::from(!is_new);
            self.count += 2;
        }
    }

    /// Calls `each` with every run between two ends in which the count changes, and by how much.
    #[inline]
    pub fn each_run(&mut self, mut each: impl FnMut(SampleRun, i32)) {
        if self.count <= 8 {
            let [a, b, c, d, e, f, g, h] = *self.keys.first_chunk().expect("room for eight");
            let (a, b, c, d) = merged((a, b), (c, d));
            (self.keys[0], self.keys[1], self.keys[2], self.keys[3]) = (a, b, c, d);
            if self.count > 4 {
                let (e, f, g, h) = merged((e, f), (g, h));
                // Odd-even merge sort (Batcher 1968).
                let (a, c, e, g) = merged((a, c), (e, g));
                let (b, d, f, h) = merged((b, d), (f, h));
                let sorted = [a, b.min(c), b.max(c), d.min(e), d.max(e), f.min(g), f.max(g), h];
                self.keys[..8].copy_from_slice(&sorted);
            }
        } else {
            self.keys[..self.count].sort_unstable();
        }
        let mut by = 0;
        for pair in self.keys[..self.count].windows(2) {
            by += ((pair[0] & 1) << 1) - 1;
            let run = (pair[0] >> 1, pair[1] >> 1);
            if by != 0 && run.0 < run.1 {
                each(run, by);
            }
        }
    }
}
