//! Controllers: what drives a robot, from nothing but what it senses.

mod follow_path;

pub use follow_path::FollowPath;

use crate::{
    geometry::Pose,
    robot::{Drive, Sensors},
};

/// A behaviour. Pure: the same readings give the same commands, on the simulated and on a real robot.
pub trait Controller {
    /// Takes a sensor reading, `dt_s` seconds after the last one, and says how to drive until the next.
    fn step(&mut self, sensed: &Sensors, dt_s: f64) -> Drive;

    /// Whether there is nothing left to do.
    fn is_done(&self) -> bool;

    /// Where the controller believes the robot to be, if it keeps track.
    fn estimate(&self) -> Option<Pose>;

    /// Index of the corner that it drives to, if it follows a line; the number of corners once it has come to the end.
    fn corner(&self) -> Option<usize> {
        None
    }

    /// A copy in the same state, so that a run can be recorded and gone back to.
    fn boxed_clone(&self) -> Box<dyn Controller>;
}
