//! What goes along with a run.

use crate::controller::Controller;
use robovac_core::{geometry::Pose, robot::SensorReadings};
use std::any::Any;

/// Sees what the robot senses during a run, and nothing else: a mapper, for instance. It is cloned with the run.
pub trait RunObserver: Any {
    /// Takes the readings after a step.
    fn observe(&mut self, sensed: &SensorReadings);

    /// Its estimate of the pose, unless it leaves that to `driver`.
    fn estimate(&self, _driver: &dyn Controller) -> Option<Pose> {
        None
    }

    /// Makes what takes over from `driver` to clean by a map ([`Input::Clean`](crate::Input::Clean)); `None` without a map.
    fn cleaner(&mut self, _planner: &'static str, _driver: &dyn Controller) -> Option<Box<dyn Controller>> {
        None
    }

    /// Roughly the memory that it takes, bytes.
    fn bytes(&self) -> usize;

    /// A copy in the same state.
    fn boxed_clone(&self) -> Box<dyn RunObserver>;
}
