//! From a floor plan to a checked walk with its metrics, for the page and the command line.
//!
//! There is one way, [`RoomSetup`] to [`PlanRequest`] to [`Planned`]. The page goes it with a start in metres and serves
//! the request in a worker; the command line goes it at once, with a start in planning cells ([`PlanningTask`]).

mod error;
mod pipeline;
mod report;
mod task;

pub use error::PlanningError;
pub use pipeline::{MOST_SEARCH_CELLS, PlanAnswer, PlanRequest, Planned, RoomSetup};
pub use report::{PlanReport, RoomReport, TaskReport};
pub use task::{CELL_ROBOT, Placement, PlanSolution, PlanningTask, choose_robot};
