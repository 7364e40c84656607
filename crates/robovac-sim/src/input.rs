//! External inputs of a run: manual control, lifting and putting down.

use crate::controller::Joystick;
use robovac_core::geometry::Pose;

/// An action of a person during a run. A run is reproduced by repeating its inputs at the same steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Input {
    /// Moves the joystick.
    Command(Joystick),
    /// Picks the robot up: its wheels drop, and it doesn't move.
    Lift,
    /// Puts it down at this pose, or as near as it fits.
    PutDown(Pose),
    /// Starts cleaning the remaining floor by its map, with plans of the planner with that id.
    Clean(&'static str),
}
