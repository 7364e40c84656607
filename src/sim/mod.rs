//! The simulated robot: motion, contact, sensors, and a whole run.
//!
//! Time advances in fixed steps of [`STEP_S`], whatever the speed of the display, so that a run is the same on every
//! machine and a robot never moves farther at once than a few millimetres: it can't tunnel through a wall.

mod contact;
mod run;
mod sim_robot;
mod slip;

pub use run::{Run, RunSetup};
pub use sim_robot::SimRobot;
pub use slip::{Slip, SlipLevel};

/// Seconds per simulation step: the Open Interface sends its sensor stream every 15 ms.
pub const STEP_S: f64 = 0.015;
