//! External inputs of a run: manual control, lifting and putting down.

use crate::controller::Joystick;
use robovac_core::geometry::Pose;

/// Something that a person does during a run. Runs are repeated by repeating it at the same step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Input {
    /// Moves the joystick.
    Command(Joystick),
    /// Picks the robot up: its wheels drop, and it goes nowhere.
    Lift,
    /// Puts it down here, as near as it fits.
    PutDown(Pose),
    /// Tells it to clean what is left by the map that it has made, by a plan of the planner with that id.
    Clean(&'static str),
}
