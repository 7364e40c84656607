//! Observers of a run.

use crate::controller::Controller;
use robovac_core::{geometry::Pose, robot::SensorReadings};
use std::any::Any;

/// Receives a run's sensor readings only; a mapper, for instance. It is cloned with the run.
pub trait RunObserver: Any {
    /// Takes the readings after a step.
    fn observe(&mut self, sensed: &SensorReadings);

    /// Its estimate of the pose; by default the estimate of `driver`.
    fn estimate(&self, _driver: &dyn Controller) -> Option<Pose> {
        None
    }

    /// Makes the controller that replaces `driver` for cleaning by a map ([`Input::Clean`](crate::Input::Clean));
    /// `None` without a map.
    fn cleaner(&mut self, _planner: &'static str, _driver: &dyn Controller) -> Option<Box<dyn Controller>> {
        None
    }

    /// Approximate memory, bytes.
    fn bytes(&self) -> usize;

    /// A copy in the same state.
    fn boxed_clone(&self) -> Box<dyn RunObserver>;
}
