//! Stage: shortest path to the nearest goal cell (breadth-first search).

use robovac_core::grid::{Cell, Direction, Grid};

/// Breadth-first search that stops at its first goal and reuses its memory, so that a search takes time in proportion
/// to the cells it visits.
#[derive(Debug, Clone)]
pub struct NearestGoalBfs {
    /// `base` + steps from the last search's start; lower values are left from searches before.
    reached: Vec<u32>,
    base: u32,
    queue: Vec<Cell>,
}

impl NearestGoalBfs {
    /// A search on grids of the size of `free`.
    pub fn new<T>(free: &Grid<T>) -> Self {
        Self { reached: vec![0; free.len()], base: 1, queue: Vec::new() }
    }

    /// A shortest path through free cells to the nearest one with `is_goal`, without `from`; `None` if there is none.
    ///
    /// Among equally near goals it takes the one that is found first when looking ahead, left, right, back; among
    /// shortest paths to it one that goes straight on where it can.
    pub fn nearest(
        &mut self,
        free: &Grid<bool>,
        from: Cell,
        heading: Direction,
        mut is_goal: impl FnMut(Cell) -> bool,
    ) -> Option<Vec<Cell>> {
        let looks = [heading, heading.left(), heading.right(), heading.opposite()];
        self.restart(free.index(from));
        self.queue.push(from);
        let mut next_in_queue = 0;
        while let Some(&cell) = self.queue.get(next_in_queue) {
            next_in_queue += 1;
            let steps = self.reached[free.index(cell)] + 1;
            for next in looks.map(|d| cell.step(d)) {
                if !free.is_set(next) || self.reached[free.index(next)] >= self.base {
                    continue;
                }
                self.reached[free.index(next)] = steps;
                if is_goal(next) {
                    return Some(self.trace_back(free, next));
                }
                self.queue.push(next);
            }
        }
        None
    }

    /// Makes all marks old and marks `from`.
    fn restart(&mut self, from: usize) {
        // A search can't number more cells than there are.
        let used = self.reached.len() as u32 + 1;
        if self.base > u32::MAX - 2 * used {
            self.reached.fill(0);
            self.base = 1;
        } else {
            self.base += used;
        }
        self.queue.clear();
        self.reached[from] = self.base;
    }

    /// The path that led to `goal`, in driving order.
    fn trace_back(&self, free: &Grid<bool>, goal: Cell) -> Vec<Cell> {
        let mut path = Vec::with_capacity((self.reached[free.index(goal)] - self.base) as usize);
        let (mut cell, mut back) = (goal, None);
        loop {
            let mark = self.reached[free.index(cell)];
            if mark == self.base {
                break;
            }
            path.push(cell);
            let is_nearer =
                |d: &Direction| free.is_set(cell.step(*d)) && self.reached[free.index(cell.step(*d))] + 1 == mark;
            let Some(direction) = back.filter(is_nearer).or_else(|| Direction::ALL.into_iter().find(is_nearer)) else {
                break;
            };
            back = Some(direction);
            cell = cell.step(direction);
        }
        path.reverse();
        path
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::grid::from_picture;

    #[test]
    fn goes_round_the_wall_and_straight() {
        let free = from_picture("....\n##..\n....", |c| c == '.').unwrap();
        let mut seeker = NearestGoalBfs::new(&free);
        for _ in 0..3 {
            let path = seeker.nearest(&free, Cell::new(0, 2), Direction::Right, |c| c.y == 0).unwrap();
            let expected = [(1, 2), (2, 2), (2, 1), (2, 0)].map(|(x, y)| Cell::new(x, y));
            assert_eq!(path, expected);
        }
        assert_eq!(seeker.nearest(&free, Cell::new(0, 2), Direction::Up, |_| false), None);
    }

    #[test]
    fn marks_of_earlier_searches_are_told_apart_after_the_counter_wraps() {
        let free = Grid::filled(3, 3, true);
        let mut seeker = NearestGoalBfs::new(&free);
        seeker.base = u32::MAX - 25;
        for _ in 0..5 {
            let path = seeker.nearest(&free, Cell::new(0, 0), Direction::Up, |c| c == Cell::new(2, 2)).unwrap();
            assert_eq!(path.len(), 4);
        }
    }
}
