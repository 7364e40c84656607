//! The port between a controller and a robot, simulated or real.

use super::{Drive, SensorReadings};

/// A robot from a controller's point of view: readings in, wheel speeds out. Implemented by the simulated robot and by
/// a real one at the other end of a serial line.
pub trait RobotPort {
    /// The latest reading.
    fn sensors(&self) -> &SensorReadings;

    /// Sets the wheel speeds from now on.
    fn drive(&mut self, wanted: Drive);
}
