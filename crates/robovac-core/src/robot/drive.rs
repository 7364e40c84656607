//! Drive commands of a robot.

use serde::{Deserialize, Serialize};

/// Wheel speeds commanded to a robot, m/s, forward positive. The robot limits speed and acceleration.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Drive {
    /// Left wheel.
    pub left: f64,
    /// Right wheel.
    pub right: f64,
    /// Speed to the left, for robots that move in all directions; others ignore it.
    pub lateral: f64,
}

impl Drive {
    /// All wheels at rest.
    pub const STOP: Self = Self { left: 0.0, right: 0.0, lateral: 0.0 };

    /// Wheel speeds of a differential drive.
    pub const fn wheels(left: f64, right: f64) -> Self {
        Self { left, right, lateral: 0.0 }
    }

    /// Wheel speeds for a forward speed in m/s and a turn rate in rad/s (counter-clockwise positive).
    pub fn from_twist(speed: f64, turn_rate: f64, wheel_base: f64) -> Self {
        let half = 0.5 * turn_rate * wheel_base;
        Self::wheels(speed - half, speed + half)
    }

    /// All speeds times `share`.
    pub fn times(self, share: f64) -> Self {
        Self { left: share * self.left, right: share * self.right, lateral: share * self.lateral }
    }

    /// Whether all speeds are 0.
    pub fn is_stop(&self) -> bool {
        *self == Self::STOP
    }
}
