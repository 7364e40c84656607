//! Result of a planner.

use super::CoverageJob;
use robovac_core::{
    geometry::Point,
    grid::{Cell, Direction, Grid, picture},
};

/// A walk over free cells: starts in the job's start, every two consecutive cells are 4-neighbours. Or a path in metres:
/// straight pieces that begin at the robot's start and keep its body off all obstacles.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CoveragePath {
    /// The cells of a walk in the order in which they are visited, the start included; empty for a path in metres.
    pub cells: Vec<Cell>,
    /// Corners of a path in metres, the start included, m; empty for a walk.
    pub line: Vec<Point>,
}

/// Violations of a path's rules; a planner that causes one has a bug.
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
    /// A path in metres for a job that is only a grid.
    #[error("a path in metres needs the floor that the cells lie on")]
    NoFloor,
    /// It doesn't begin where the robot stands.
    #[error("the path doesn't begin at the robot's start")]
    WrongBegin,
    /// At a corner, or on the way to it, the robot would touch an obstacle.
    #[error("the robot touches an obstacle on its way to corner {0}")]
    Touches(usize),
}

/// What rounding may take off a distance, m.
const ROUNDING: f64 = 1e-6;

impl CoveragePath {
    /// A walk over cells.
    pub fn walk(cells: Vec<Cell>) -> Self {
        Self { cells, line: Vec::new() }
    }

    /// A path in metres. A corner that stands twice counts once.
    pub fn in_metres(mut line: Vec<Point>) -> Self {
        line.dedup();
        Self { cells: Vec::new(), line }
    }

    /// Whether it is a path in metres.
    pub fn is_in_metres(&self) -> bool {
        !self.line.is_empty()
    }

    /// Checks that it can be driven: for a path in metres, that its corners keep the body off all obstacles. That its
    /// pieces do is checked by [`lanes::FreeSpace`](super::lanes::FreeSpace).
    pub fn check(&self, job: &CoverageJob) -> Result<(), PathError> {
        if self.is_in_metres() {
            let floor = &job.place.as_ref().ok_or(PathError::NoFloor)?.floor;
            let has_room = |at: &Point| floor.limits().has_room(*at, floor.limits().body_radius - ROUNDING);
            if (self.line[0] - floor.start.position()).norm() > ROUNDING {
                return Err(PathError::WrongBegin);
            }
            return self.line.iter().position(|at| !has_room(at)).map_or(Ok(()), |i| Err(PathError::Touches(i)));
        }
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
