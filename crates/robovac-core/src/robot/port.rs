//! The port between a controller and a robot, simulated or real.

use super::{Drive, SensorReadings};

/// A robot as controllers see it: readings come in, wheel speeds go out. The simulated robot is one, and so is a real one at
/// the other end of a serial line.
pub trait RobotPort {
    /// The latest reading.
    fn sensors(&self) -> &SensorReadings;

    /// Wheel speeds from now on.
    fn drive(&mut self, wanted: Drive);
}
