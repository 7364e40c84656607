//! One definition of every metric on the page, the command line and in tests.
//!
//! [`WalkMetrics`] are those of the walk on the planning grid, [`DriveMetrics`] those of the line that the robot drives,
//! [`Bounds`] say how good any walk can be. [`METRICS`] is the list by which tables are made.

mod drive;
mod list;
mod walk;

pub use crate::{Bounds, TURN_STEPS};
pub use drive::DriveMetrics;
pub use list::{Better, METRICS, MetricInfo, PlanNumbers};
pub use walk::WalkMetrics;
