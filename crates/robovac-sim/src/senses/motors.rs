//! Wheel sensors: encoder counts and stalled motors.

use super::Carrier;
use crate::STEP_S;
use robovac_core::robot::SensorReadings;

/// The castor turns if the body moves at least this share of what the wheels roll.
const PROGRESS: f64 = 0.3;
/// Time after which a held wheel draws too much current, s.
const STUCK_S: f64 = 0.5;
/// Slowest forward or backward speed at which a robot can be stuck, m/s.
const SLOWEST: f64 = 0.02;

/// How long the wheels have been held, s. The times and shares are ours.
#[derive(Debug, Clone, Default)]
pub(super) struct Motors {
    stuck_s: f64,
}

impl Motors {
    /// Whether the wheels push without moving.
    pub fn is_stalled(&self) -> bool {
        self.stuck_s >= STUCK_S
    }

    /// Packets 58 and 14. Wheels that push against an obstacle stall; brushes never do, as nothing winds around them
    /// here.
    pub fn read(&mut self, carrier: &Carrier, sensors: &mut SensorReadings) {
        let speed = 0.5 * (carrier.speed.left + carrier.speed.right);
        let progresses = carrier.moved > PROGRESS * speed.abs() * STEP_S;
        sensors.stasis = speed > 0.0 && progresses && !carrier.is_lifted;
        let is_pushing = !carrier.touch.is_none() && !carrier.wanted.is_stop() && speed.abs() > SLOWEST;
        self.stuck_s = if is_pushing && !progresses { self.stuck_s + STEP_S } else { 0.0 };
        let is_stalled = self.is_stalled();
        sensors.overcurrent.left_wheel = is_stalled && carrier.speed.left.abs() > SLOWEST;
        sensors.overcurrent.right_wheel = is_stalled && carrier.speed.right.abs() > SLOWEST;
    }
}
