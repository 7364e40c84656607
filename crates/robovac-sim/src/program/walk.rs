//! Checks the walk of a user's planner, and says in words what is wrong where.

use coverage_planners::CoverageJob;
use robovac_core::grid::{Cell, Grid};

/// Why a walk can't be driven. Cells are column and row from 0 at the lower left; steps are counted from 0, the start.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum WalkFault {
    /// There is none.
    #[error("it returned no cells; return them in the order of the walk, the start {start} first")]
    Empty {
        /// The start.
        start: Cell,
    },
    /// It begins elsewhere.
    #[error("the walk begins at {found}, but the robot stands at {start}; begin there")]
    WrongStart {
        /// Its first cell.
        found: Cell,
        /// The start.
        start: Cell,
    },
    /// A cell that doesn't exist.
    #[error(
        "step {step} leaves the grid: {cell}; x goes from 0 to {}, y from 0 to {}", .width - 1, .height - 1
    )]
    Outside {
        /// Number of the step.
        step: usize,
        /// The cell.
        cell: Cell,
        /// Columns of the grid.
        width: usize,
        /// Rows of the grid.
        height: usize,
    },
    /// A cell that isn't free.
    #[error("step {step} enters {cell}, which isn't free; ask room.is_free(x, y) first")]
    Wall {
        /// Number of the step.
        step: usize,
        /// The cell.
        cell: Cell,
    },
    /// A cell that isn't beside the one before.
    #[error("step {step} jumps from {from} to {to}; move to a neighbouring cell: left, right, up or down")]
    Jump {
        /// Number of the step.
        step: usize,
        /// The cell before.
        from: Cell,
        /// The cell.
        to: Cell,
    },
}

/// Cells that a walk doesn't visit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MissedCells {
    /// How many.
    pub count: usize,
    /// The first one: the lowest row, there the leftmost.
    pub first: Cell,
}

/// Checks a user's walk over `job`. The cells that it misses are no fault, but worth telling.
pub fn check_walk(job: &CoverageJob, cells: &[Cell]) -> Result<Option<MissedCells>, WalkFault> {
    let start = job.start;
    let &found = cells.first().ok_or(WalkFault::Empty { start })?;
    let (width, height) = (job.free.width(), job.free.height());
    let mut visited = Grid::filled(width, height, false);
    for (step, &cell) in cells.iter().enumerate() {
        if !(0..width as i32).contains(&cell.x) || !(0..height as i32).contains(&cell.y) {
            return Err(WalkFault::Outside { step, cell, width, height });
        }
        if step == 0 && found != start {
            return Err(WalkFault::WrongStart { found, start });
        }
        if step > 0 && cells[step - 1].direction_to(cell).is_none() {
            return Err(WalkFault::Jump { step, from: cells[step - 1], to: cell });
        }
        if !job.free.is_set(cell) {
            return Err(WalkFault::Wall { step, cell });
        }
        visited[cell] = true;
    }
    let all = (0..height as i32).flat_map(|y| (0..width as i32).map(move |x| Cell::new(x, y)));
    let mut missed = all.filter(|&cell| job.free.is_set(cell) && !visited.is_set(cell));
    Ok(missed.next().map(|first| MissedCells { count: 1 + missed.count(), first }))
}

impl std::fmt::Display for MissedCells {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.count {
            1 => write!(f, "the walk misses one cell, {}", self.first),
            count => write!(f, "the walk misses {count} cells, the first at {}", self.first),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::grid::Direction;

    /// A grid of 3 x 2 cells with a wall in the middle above, and a start at the lower left.
    fn verdict(cells: &[(i32, i32)]) -> String {
        let mut free = Grid::filled(3, 2, true);
        free[Cell::new(1, 1)] = false;
        let job = CoverageJob::new(&free, Cell::new(0, 0), Direction::Right).unwrap();
        let cells: Vec<_> = cells.iter().map(|&(x, y)| Cell::new(x, y)).collect();
        match check_walk(&job, &cells) {
            Ok(None) => "all".to_owned(),
            Ok(Some(missed)) => missed.to_string(),
            Err(fault) => fault.to_string(),
        }
    }

    #[test]
    fn every_fault_is_told_with_its_cell() {
        assert_eq!(verdict(&[(0, 0), (0, 1), (0, 0), (1, 0), (2, 0), (2, 1)]), "all");
        assert_eq!(verdict(&[(0, 0), (1, 0), (2, 0), (2, 1)]), "the walk misses one cell, (0, 1)");
        assert_eq!(verdict(&[(0, 0), (1, 0)]), "the walk misses 3 cells, the first at (2, 0)");
        assert!(verdict(&[]).starts_with("it returned no cells"));
        assert_eq!(verdict(&[(1, 0)]), "the walk begins at (1, 0), but the robot stands at (0, 0); begin there");
        assert_eq!(verdict(&[(0, 0), (-1, 0)]), "step 1 leaves the grid: (-1, 0); x goes from 0 to 2, y from 0 to 1");
        assert_eq!(
            verdict(&[(0, 0), (1, 0), (1, 1)]),
            "step 2 enters (1, 1), which isn't free; ask room.is_free(x, y) first"
        );
        assert_eq!(
            verdict(&[(0, 0), (2, 0)]),
            "step 1 jumps from (0, 0) to (2, 0); move to a neighbouring cell: left, right, up or down"
        );
        assert!(verdict(&[(i32::MAX, i32::MIN)]).starts_with("step 0 leaves the grid"));
    }
}
