//! Commands of manual control.

use serde::{Deserialize, Serialize};

/// Position of a joystick. Both values are clamped to -1 to 1.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Joystick {
    /// Forward, as a share of the robot's cruise speed; negative for backward.
    pub forward: f64,
    /// To the left, as a share of its turn rate; negative for right.
    pub left: f64,
}
