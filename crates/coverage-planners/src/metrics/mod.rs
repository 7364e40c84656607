//! The metrics, defined once for the page, the command line and the tests.
//!
//! [`WalkMetrics`] are those of the walk on the planning grid, [`DriveMetrics`] those of the line that the robot
//! drives, [`Bounds`] the lower bounds of any walk. [`METRICS`] lists the columns of tables.

mod drive;
mod list;
mod walk;

pub use crate::{Bounds, TURN_STEPS};
pub use drive::DriveMetrics;
pub use list::{Better, METRICS, MetricInfo, PlanNumbers, Rounding};
pub use walk::WalkMetrics;
