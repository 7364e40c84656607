//! Stage: breadth-first search over free cells, for thousands of searches in one room.

use super::frame::FramedGrid;
use robovac_core::grid::{Cell, Grid};
use std::ops::ControlFlow;

/// Visits cells in the order of their steps from a start. It reuses its memory, so that a search takes time in
/// proportion to the cells it visits.
#[derive(Debug)]
pub struct Flood {
    frame: FramedGrid,
    /// `base` + steps from the last search's start; lower values are left from searches before, and [`WALL`] is above
    /// all. So a single comparison checks that a cell is free, inside and new.
    reached: Vec<u32>,
    base: u32,
    queue: Vec<u32>,
}

const WALL: u32 = u32::MAX;

impl Flood {
    /// Searches through the free cells of `free`.
    pub fn new(free: &Grid<bool>) -> Self {
        let frame = FramedGrid::around(free);
        Self { frame, reached: frame.drawn(free, 0, WALL), base: 1, queue: Vec::new() }
    }

    /// The numbering of the cells passed to `visit`.
    pub fn frame(&self) -> FramedGrid {
        self.frame
    }

    /// Calls `visit` with the cells around `from` and their steps, nearest first, until it breaks or there are no more.
    pub fn search(&mut self, from: Cell, mut visit: impl FnMut(usize, u32) -> ControlFlow<()>) {
        self.make_old();
        let (frame, base) = (self.frame, self.base);
        let reached = &mut self.reached[..];
        let start = frame.index(from);
        reached[start] = base;
        self.queue.push(start as u32);
        let mut next_in_queue = 0;
        while let Some(&index) = self.queue.get(next_in_queue) {
            next_in_queue += 1;
            let index = index as usize;
            let mark = reached[index];
            if visit(index, mark - base).is_break() {
                break;
            }
            for next in frame.neighbours(index) {
                if reached[next] < base {
                    reached[next] = mark + 1;
                    self.queue.push(next as u32);
                }
            }
        }
    }

    /// Marks all cells as those of an earlier search.
    fn make_old(&mut self) {
        // The last cell in the queue has the most steps.
        let latest = self.queue.last().map_or(0, |&last| self.reached[last as usize]);
        self.queue.clear();
        if latest < WALL / 2 {
            self.base = latest + 1;
        } else {
            // A search can't take more steps than there are cells, which is far below the other half.
            self.reached.iter_mut().filter(|mark| **mark < WALL).for_each(|mark| *mark = 0);
            self.base = 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::grid::from_picture;

    #[test]
    fn steps_are_those_of_shortest_paths_even_after_the_counter_wraps() {
        let expected = from_picture("012#\n1#34\n2345", |c| c.to_digit(10)).unwrap();
        let free = expected.map(Option::is_some);
        let from = Cell::new(0, 2);
        let mut flood = Flood::new(&free);
        for round in 0..4 {
            let mut visited = 0;
            let frame = flood.frame();
            flood.search(from, |index, steps| {
                visited += 1;
                assert_eq!(expected[frame.cell(index)], Some(steps), "round {round}");
                ControlFlow::Continue(())
            });
            assert_eq!(visited, free.count());
            if round == 1 {
                let last = flood.queue[visited - 1];
                flood.reached[last as usize] = WALL / 2;
            }
        }
    }
}
