//! Result of a planner.

use super::CoverageJob;
use robovac_core::grid::{Cell, Direction, Grid, picture};

/// A walk over free cells: starts in the job's start, every two consecutive cells are 4-neighbours.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct CoveragePath {
    /// The cells in the order in which they are visited, the start included.
    pub cells: Vec<Cell>,
}

/// Violations of a walk's rules; a planner that causes one has a bug.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum PathError {
    /// The walk is empty or starts elsewhere.
    #[error("the walk doesn't start in {0}")]
    WrongStart(Cell),
    /// Two consecutive cells aren't neighbours.
    #[error("step {0} doesn't lead to a neighbouring cell")]
    Jump(usize),
    /// A cell isn't free.
    #[error("step {0} leads into {1}, which isn't free")]
    Blocked(usize, Cell),
}

impl CoveragePath {
    /// Checks that the walk can be driven.
    pub fn check(&self, job: &CoverageJob) -> Result<(), PathError> {
        if self.cells.first() != Some(&job.start) {
            return Err(PathError::WrongStart(job.start));
        }
        for (i, &cell) in self.cells.iter().enumerate() {
            if !job.free.is_set(cell) {
                return Err(PathError::Blocked(i, cell));
            }
            if i > 0 && self.cells[i - 1].direction_to(cell).is_none() {
                return Err(PathError::Jump(i));
            }
        }
        Ok(())
    }

    /// How often the walk visits every cell.
    pub fn visits(&self, job: &CoverageJob) -> Grid<u32> {
        let mut visits = Grid::filled(job.free.width(), job.free.height(), 0);
        for &cell in &self.cells {
            visits[cell] += 1;
        }
        visits
    }

    /// A picture of the walk: in every cell an arrow in the direction in which the walk leaves it for the first time.
    ///
    /// `o` where it ends, `.` for cells that it misses, `#` for cells that aren't free.
    pub fn arrows(&self, job: &CoverageJob) -> String {
        let mut glyphs = job.free.map(|&free| if free { '.' } else { '#' });
        for (i, &cell) in self.cells.iter().enumerate().filter(|&(_, &cell)| job.free.is_set(cell)) {
            if glyphs[cell] == '.' {
                glyphs[cell] = match self.cells.get(i + 1).and_then(|&next| cell.direction_to(next)) {
                    Some(Direction::Right) => '>',
                    Some(Direction::Up) => '^',
                    Some(Direction::Left) => '<',
                    Some(Direction::Down) => 'v',
                    None => 'o',
                };
            }
        }
        picture(&glyphs, |&glyph| glyph)
    }
}
