//! What a controller gets to know: exactly what the Open Interface reports, in the same units.

use serde::{Deserialize, Serialize};

/// One reading of all sensors. Controllers see nothing else of the world.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Sensors {
    /// The bumper is pressed on its left half (packet 7, bit 1).
    pub bump_left: bool,
    /// The bumper is pressed on its right half (packet 7, bit 0).
    pub bump_right: bool,
    /// Left wheel encoder, wraps at 65536 (packet 43).
    pub left_counts: u16,
    /// Right wheel encoder, wraps at 65536 (packet 44).
    pub right_counts: u16,
}

impl Sensors {
    /// Whether the bumper is pressed anywhere.
    pub fn bumped(&self) -> bool {
        self.bump_left || self.bump_right
    }
}
