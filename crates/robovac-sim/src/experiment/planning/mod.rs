//! From a floor plan to a checked walk with its metrics, for the page and the command line.
//!
//! The steps are [`RoomSetup`], [`PlanRequest`] and [`Planned`]. The page has a start in metres and serves the request
//! in a worker; the command line has a start in planning cells and plans at once ([`PlanningTask`]).

mod error;
mod fit_cells;
mod pipeline;
mod report;
mod task;

pub use error::PlanningError;
pub use fit_cells::FittedCells;
pub use pipeline::{MOST_SEARCH_CELLS, PathToDrive, PlanAnswer, PlanRequest, Planned, RoomSetup, WHOLE};
pub use report::{PlanReport, RoomReport, TaskReport};
pub use task::{CELL_ROBOT, GivenStart, Placement, PlanSolution, PlanningTask, choose_robot};
