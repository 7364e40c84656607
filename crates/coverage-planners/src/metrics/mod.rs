//! The metrics, defined once for the page, the command line and the tests.
//!
//! [`WalkMetrics`] are those of the walk on the planning grid, [`DriveMetrics`] those of the line that the robot
//! drives, [`Bounds`] the lower bounds of any walk, [`MetricExcess`] what a line needs above the bounds of any path. [`METRICS`] lists the columns of tables.

mod drive;
mod excess;
mod list;
mod walk;

pub use crate::{Bounds, TURN_STEPS};
pub use drive::{DriveMetrics, line_seconds};
pub use excess::{MetricExcess, SweepBound, sweeps_as_disc};
pub use list::{Better, METRICS, MetricInfo, PlanNumbers, RoundingMode};
pub use walk::WalkMetrics;
