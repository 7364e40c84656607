//! Metrics of a walk on the planning grid.

use crate::{CoverageJob, CoveragePath, bounds::TURN_STEPS};
use serde::{Deserialize, Serialize};

/// Metrics of a walk on the planning grid. All are exact counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct WalkMetrics {
    /// Cells that can be reached from the start, the start included.
    pub reachable_cells: usize,
    /// Cells of those that the walk visits.
    pub visited_cells: usize,
    /// Steps from cell to cell.
    pub steps: usize,
    /// Quarter turns between consecutive steps; a reversal counts two.
    pub turns: usize,
    /// Steps that lead in another direction than the one before: a reversal counts once, as in the thesis' Table 2.
    pub direction_changes: usize,
    /// Quarter turns from the robot's heading at the start to its first step; not part of `turns`.
    pub initial_turns: usize,
    /// Visits to cells beyond the first to each.
    pub revisits: usize,
    /// Cells that are visited more than once.
    pub revisited_cells: usize,
}

impl WalkMetrics {
    /// Whether the walk visits every cell that it can reach.
    pub fn is_complete(&self) -> bool {
        self.visited_cells == self.reachable_cells
    }

    /// The metrics of `path`.
    pub fn of(job: &CoverageJob, path: &CoveragePath) -> Self {
        let visits = path.visits(job);
        let visited_more_than = |times: u32| visits.values().iter().filter(|&&v| v > times).count();
        let visited_cells = visited_more_than(0);
        let mut directions = path.cells.windows(2).filter_map(|w| w[0].direction_to(w[1]));
        let (mut turns, mut direction_changes) = (0, 0);
        let first = directions.next();
        let mut last = first;
        for direction in directions {
            let turned = last.map_or(0, |l| l.quarter_turns(direction)) as usize;
            turns += turned;
            direction_changes += turned.min(1);
            last = Some(direction);
        }
        Self {
            reachable_cells: job.cells(),
            visited_cells,
            steps: path.cells.len().saturating_sub(1),
            turns,
            direction_changes,
            initial_turns: first.map_or(0, |d| job.heading.quarter_turns(d)) as usize,
            revisits: path.cells.len() - visited_cells,
            revisited_cells: visited_more_than(1),
        }
    }

    /// Steps and turns in one number: steps + [`TURN_STEPS`] x quarter turns, the turn at the start not counted.
    pub fn cost(&self) -> usize {
        self.steps + TURN_STEPS * self.turns
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::grid::{Cell, Direction, Grid};

    #[test]
    fn reversal_counts_two_and_the_start_is_apart() {
        let job = CoverageJob::new(&Grid::filled(3, 2, true), Cell::new(0, 0), Direction::Up).unwrap();
        let cells = [(0, 0), (1, 0), (2, 0), (1, 0), (1, 1), (1, 0)].map(|(x, y)| Cell::new(x, y));
        let metrics = WalkMetrics::of(&job, &CoveragePath { cells: cells.to_vec() });
        let expected = WalkMetrics {
            reachable_cells: 6,
            visited_cells: 4,
            steps: 5,
            turns: 5,
            direction_changes: 3,
            initial_turns: 1,
            revisits: 2,
            revisited_cells: 1,
        };
        assert_eq!((metrics, metrics.cost()), (expected, 15));
    }
}
