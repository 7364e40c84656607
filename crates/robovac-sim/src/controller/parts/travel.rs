//! Distance travelled, by the encoders.

use robovac_core::robot::{RobotModel, SensorReadings};

/// Readings without a count after which the wheels count as at rest.
const STILL: u32 = 3;

/// Sums up the encoders' counts, which wrap.
#[derive(Debug, Clone)]
pub(in crate::controller) struct EncoderTravel {
    metres_per_count: f64,
    wheel_base: f64,
    last: Option<(u16, u16)>,
    /// Distances rolled by the wheels, m: left, right.
    wheels: [f64; 2],
    still: u32,
}

impl EncoderTravel {
    pub(super) fn new(robot: &RobotModel) -> Self {
        let metres_per_count = 1.0 / robot.counts_per_metre;
        Self { metres_per_count, wheel_base: robot.wheel_base, last: None, wheels: [0.0; 2], still: 0 }
    }

    /// Takes the next reading; returns the distances rolled since the last one, m.
    pub(super) fn update(&mut self, sensed: &SensorReadings) -> [f64; 2] {
        let counts = (sensed.left_counts, sensed.right_counts);
        let last = self.last.replace(counts).unwrap_or(counts);
        self.still = if counts == last { self.still + 1 } else { 0 };
        let metres = |now: u16, before: u16| f64::from(now.wrapping_sub(before) as i16) * self.metres_per_count;
        let rolled = [metres(counts.0, last.0), metres(counts.1, last.1)];
        self.wheels = [self.wheels[0] + rolled[0], self.wheels[1] + rolled[1]];
        rolled
    }

    /// Way of the middle between the wheels, forward less backward, m.
    pub(super) fn ahead(&self) -> f64 {
        0.5 * (self.wheels[0] + self.wheels[1])
    }

    /// Sum of all turning, counter-clockwise positive, rad.
    pub(super) fn turned(&self) -> f64 {
        (self.wheels[1] - self.wheels[0]) / self.wheel_base
    }

    /// Whether the wheels are at rest, by the encoders.
    pub(super) fn is_resting(&self) -> bool {
        self.still >= STILL
    }
}
