//! Stage: the cheapest way between two cells, turns included.

use super::cost::Costs;
use crate::grid::{Cell, Direction, Grid};
use std::{cmp::Reverse, collections::BinaryHeap};

/// A* search (Hart, Nilsson & Raphael 1968) over cells and headings that reuses its memory, so that a search costs what
/// it looks at and no more.
#[derive(Debug)]
pub struct Transit {
    /// Number of the search that reached a cell with a heading last, and what the way to there cost.
    reached: Vec<(u32, u32)>,
    search: u32,
    queue: BinaryHeap<Reverse<(u32, u32, u32)>>,
    costs: Costs,
}

/// One end of a way.
#[derive(Debug, Clone, Copy)]
pub struct Stop {
    /// The cell.
    pub cell: Cell,
    /// The direction in which the robot comes to it or has to leave it; `None` if that doesn't matter.
    pub heading: Option<Direction>,
}

impl Transit {
    /// For grids of the size of `free`.
    pub fn new(free: &Grid<bool>, costs: Costs) -> Self {
        Self { reached: vec![(0, 0); 4 * free.len()], search: 0, queue: BinaryHeap::new(), costs }
    }

    /// Appends the cheapest way through free cells to `walk`, the cell in which it starts left out, and returns its cost
    /// with the turns at both ends; `None` if there is none that costs less than `limit`.
    pub fn append_way(
        &mut self,
        free: &Grid<bool>,
        from: Stop,
        to: Stop,
        limit: u32,
        walk: &mut Vec<Cell>,
    ) -> Option<u32> {
        self.search += 1;
        self.queue.clear();
        // Without a heading every direction is as good to start with.
        for direction in Direction::ALL.into_iter().filter(|&d| from.heading.is_none_or(|h| h == d)) {
            self.reach(free, (from.cell, direction), 0, to, limit);
        }
        while let Some(Reverse((estimate, remaining, state))) = self.queue.pop() {
            let (cell, heading) = (free.cell(state as usize / 4), Direction::ALL[state as usize % 4]);
            let cost = estimate - remaining;
            if self.reached[state as usize].1 < cost {
                continue;
            }
            if cell == to.cell {
                self.trace_back(free, from, (cell, heading), walk);
                return Some(estimate);
            }
            for direction in Direction::ALL {
                let next = cell.step(direction);
                if free.is_set(next) {
                    let step = self.costs.step + self.costs.turn * heading.quarter_turns(direction);
                    self.reach(free, (next, direction), cost + step, to, limit);
                }
            }
        }
        None
    }

    fn reach(&mut self, free: &Grid<bool>, (cell, heading): (Cell, Direction), cost: u32, to: Stop, limit: u32) {
        let state = 4 * free.index(cell) + heading as usize;
        let (search, best) = self.reached[state];
        let remaining = self.costs.at_least(cell, Some(heading), to.cell, to.heading);
        if (search != self.search || cost < best) && cost + remaining < limit {
            self.reached[state] = (self.search, cost);
            // The second number makes it look first at what is nearest to the goal.
            self.queue.push(Reverse((cost + remaining, remaining, state as u32)));
        }
    }

    fn trace_back(&self, free: &Grid<bool>, from: Stop, goal: (Cell, Direction), walk: &mut Vec<Cell>) {
        let start_of_way = walk.len();
        let (mut cell, mut heading) = goal;
        let cost_at = |cell: Cell, heading: Direction| {
            let (search, cost) = self.reached[4 * free.index(cell) + heading as usize];
            (search == self.search).then_some(cost)
        };
        let mut cost = cost_at(cell, heading).unwrap_or(0);
        while cost > 0 && !(cell == from.cell && cost == 0) {
            walk.push(cell);
            let before = cell.step(heading.opposite());
            let source = Direction::ALL.into_iter().find(|&d| {
                let step = self.costs.step + self.costs.turn * d.quarter_turns(heading);
                free.is_set(before) && cost_at(before, d).is_some_and(|c| c + step == cost)
            });
            let Some(source) = source else { break };
            (cell, heading, cost) = (before, source, cost_at(before, source).unwrap_or(0));
        }
        walk[start_of_way..].reverse();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::from_picture;

    #[test]
    fn longer_way_with_fewer_turns_wins_if_turns_are_dear() {
        let free = from_picture("......\n.#.##.\n...#..\n##...#", |c| c == '.').unwrap();
        let (from, to) = (Cell::new(0, 1), Cell::new(5, 1));
        let stop = |cell| Stop { cell, heading: None };
        for (turn, steps) in [(0, 7), (200, 9)] {
            let costs = Costs { step: 16, turn };
            let mut walk = vec![from];
            let cost = Transit::new(&free, costs).append_way(&free, stop(from), stop(to), u32::MAX, &mut walk).unwrap();
            assert_eq!(walk.len() - 1, steps);
            let heading = walk[0].direction_to(walk[1]).unwrap();
            assert_eq!(u64::from(cost), costs.of_walk(heading, &walk));
        }
    }

    #[test]
    fn gives_up_at_the_limit() {
        let free = Grid::filled(9, 1, true);
        let mut transit = Transit::new(&free, Costs { step: 16, turn: 32 });
        let stop = |x| Stop { cell: Cell::new(x, 0), heading: Some(Direction::Right) };
        let mut walk = Vec::new();
        assert_eq!(transit.append_way(&free, stop(0), stop(8), 128, &mut walk), None);
        assert_eq!(transit.append_way(&free, stop(0), stop(8), 129, &mut walk), Some(128));
        assert_eq!(transit.append_way(&free, stop(3), stop(3), 1, &mut walk), Some(0));
        assert_eq!(walk.len(), 8);
    }
}
