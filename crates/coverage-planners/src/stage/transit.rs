//! Stage: the cheapest path between two cells, turns included.

use super::{cost::Costs, frame::FramedGrid};
use robovac_core::grid::{Cell, Direction, Grid};
use std::{cmp::Reverse, collections::BinaryHeap};

/// A* search (Hart, Nilsson & Raphael 1968) over cells and headings. It reuses its memory, so that a search takes time
/// in proportion to the cells it visits.
#[derive(Debug)]
pub struct Transit {
    frame: FramedGrid,
    is_free: Vec<bool>,
    /// `base` + cost of the way to a cell, by its heading there; lower values are left from searches before.
    reached: Vec<[u32; 4]>,
    base: u32,
    /// The cost of the last search's dearest way.
    dearest: u32,
    /// The estimate for the whole way, its remaining part, and four times the cell's number + the heading.
    queue: BinaryHeap<Reverse<(u32, u32, u32)>>,
    costs: Costs,
}

/// One end of a way.
#[derive(Debug, Clone, Copy)]
pub struct TransitEnd {
    /// The cell.
    pub cell: Cell,
    /// The direction in which the robot comes to it or has to leave it; `None` if that doesn't matter.
    pub heading: Option<Direction>,
}

impl Transit {
    /// For grids of the size of `free`.
    pub fn new(free: &Grid<bool>, costs: Costs) -> Self {
        let frame = FramedGrid::around(free);
        Self {
            frame,
            is_free: frame.drawn(free, true, false),
            reached: frame.filled([0; 4]),
            base: 1,
            dearest: 0,
            queue: BinaryHeap::new(),
            costs,
        }
    }

    /// Appends the cheapest way through free cells to `walk`, the cell in which it starts left out, and returns its cost
    /// with the turns at both ends; `None` if there is none that costs less than `limit`.
    pub fn append_way(&mut self, from: TransitEnd, to: TransitEnd, limit: u32, walk: &mut Vec<Cell>) -> Option<u32> {
        self.make_old();
        let start = self.frame.index(from.cell);
        // Without a heading any direction is allowed at the start.
        for direction in Direction::ALL.into_iter().filter(|&d| from.heading.is_none_or(|h| h == d)) {
            self.reach(start, from.cell, direction, 0, to, limit);
        }
        while let Some(Reverse((estimate, remaining, state))) = self.queue.pop() {
            let (index, heading) = (state as usize / 4, Direction::ALL[state as usize % 4]);
            let cost = estimate - remaining;
            if self.reached[index][heading as usize] < self.base + cost {
                continue;
            }
            let cell = self.frame.cell(index);
            if cell == to.cell {
                self.trace_back((cell, heading), walk);
                return Some(estimate);
            }
            for direction in Direction::ALL {
                // Going straight back never pays, except from the start.
                let next = self.frame.ahead(index, direction);
                if self.is_free[next] && (cost == 0 || direction != heading.opposite()) {
                    let step = self.costs.step + self.costs.turn * heading.quarter_turns(direction);
                    self.reach(next, cell.step(direction), direction, cost + step, to, limit);
                }
            }
        }
        None
    }

    /// Marks all cells as those of an earlier search.
    fn make_old(&mut self) {
        self.queue.clear();
        self.base += self.dearest + 1;
        self.dearest = 0;
        if self.base > u32::MAX / 2 {
            self.reached.fill([0; 4]);
            self.base = 1;
        }
    }

    #[inline]
    fn reach(&mut self, index: usize, cell: Cell, heading: Direction, cost: u32, to: TransitEnd, limit: u32) {
        let mark = &mut self.reached[index][heading as usize];
        if *mark >= self.base && *mark <= self.base + cost {
            return;
        }
        let remaining = self.costs.at_least(cell, Some(heading), to.cell, to.heading);
        if cost + remaining < limit {
            *mark = self.base + cost;
            self.dearest = self.dearest.max(cost);
            // The second number prefers cells nearest to the goal.
            self.queue.push(Reverse((cost + remaining, remaining, 4 * index as u32 + heading as u32)));
        }
    }

    fn trace_back(&self, goal: (Cell, Direction), walk: &mut Vec<Cell>) {
        let start_of_way = walk.len();
        let (mut cell, mut heading) = goal;
        let cost_at = |index: usize, heading: Direction| self.reached[index][heading as usize].checked_sub(self.base);
        let mut cost = cost_at(self.frame.index(cell), heading).unwrap_or(0);
        while cost > 0 {
            walk.push(cell);
            let before = cell.step(heading.opposite());
            let index = self.frame.index(before);
            let source = Direction::ALL.into_iter().find(|&d| {
                let step = self.costs.step + self.costs.turn * d.quarter_turns(heading);
                self.is_free[index] && cost_at(index, d).is_some_and(|c| c + step == cost)
            });
            let Some(source) = source else { break };
            (cell, heading, cost) = (before, source, cost_at(index, source).unwrap_or(0));
        }
        walk[start_of_way..].reverse();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::grid::from_picture;

    #[test]
    fn longer_way_with_fewer_turns_wins_if_turns_are_dear() {
        let free = from_picture("......\n.#.##.\n...#..\n##...#", |c| c == '.').unwrap();
        let (from, to) = (Cell::new(0, 1), Cell::new(5, 1));
        let stop = |cell| TransitEnd { cell, heading: None };
        for (turn, steps) in [(0, 7), (200, 9)] {
            let costs = Costs { step: 16, turn };
            let mut walk = vec![from];
            let cost = Transit::new(&free, costs).append_way(stop(from), stop(to), u32::MAX, &mut walk).unwrap();
            assert_eq!(walk.len() - 1, steps);
            let heading = walk[0].direction_to(walk[1]).unwrap();
            assert_eq!(u64::from(cost), costs.of_walk(heading, &walk));
        }
    }

    #[test]
    fn gives_up_at_the_limit() {
        let free = Grid::filled(9, 1, true);
        let mut transit = Transit::new(&free, Costs { step: 16, turn: 32 });
        let stop = |x| TransitEnd { cell: Cell::new(x, 0), heading: Some(Direction::Right) };
        let mut walk = Vec::new();
        assert_eq!(transit.append_way(stop(0), stop(8), 128, &mut walk), None);
        assert_eq!(transit.append_way(stop(0), stop(8), 129, &mut walk), Some(128));
        assert_eq!(transit.append_way(stop(3), stop(3), 1, &mut walk), Some(0));
        assert_eq!(walk.len(), 8);
    }
}
