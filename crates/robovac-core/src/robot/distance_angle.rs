//! The distance and angle packets.

use super::{RobotModel, SensorReadings};
use crate::math::PI;

/// Readings between two polls of distance and angle: 0.24 s at 15 ms per reading (ours). More frequent polls miss slow
/// motions; less frequent ones lose the positions of bends.
pub const READINGS_PER_DISTANCE_ANGLE: u32 = 16;

/// Values of packets 19 and 20 of the Open Interface, if they are requested with a reading.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct DistanceAngle {
    /// Distance of the middle between the wheels since the last report, mm (packet 19).
    pub distance_mm: i16,
    /// Turn since the last report, degrees, counter-clockwise positive (packet 20, of firmware from 3.4.1 on).
    pub angle_deg: i16,
}

impl DistanceAngle {
    /// Both motions after each other.
    #[must_use]
    pub fn and(self, next: Self) -> Self {
        Self {
            distance_mm: self.distance_mm.saturating_add(next.distance_mm),
            angle_deg: self.angle_deg.saturating_add(next.angle_deg),
        }
    }

    /// Distance rolled by the wheels: left and right, m.
    pub fn rolled(self, wheel_base: f64) -> [f64; 2] {
        let distance = f64::from(self.distance_mm) / 1000.0;
        let half = 0.5 * wheel_base * f64::from(self.angle_deg) * PI / 180.0;
        [distance - half, distance + half]
    }
}

/// A robot's own computation of these packets from its encoders.
///
/// Both are whole numbers, truncated towards 0 and limited to 16 bits, and restart at 0 after each report, so the
/// truncated remainder is lost (Create 2 Open Interface specification, packets 19 and 20; issue 28 of `create_robot`
/// describes the consequences).
#[derive(Debug, Clone)]
pub struct DistanceAngleMeter {
    mm_per_count: f64,
    wheel_base_mm: f64,
    last: Option<[u16; 2]>,
    /// Counts of left and right wheel since the last report.
    since: [i64; 2],
    readings: u32,
}

impl DistanceAngleMeter {
    /// At rest.
    pub fn new(robot: &RobotModel) -> Self {
        let (mm_per_count, wheel_base_mm) = (1000.0 / robot.counts_per_metre, 1000.0 * robot.wheel_base);
        Self { mm_per_count, wheel_base_mm, last: None, since: [0; 2], readings: 0 }
    }

    /// Takes the counters of a reading, which wrap; reports the packets at regular intervals.
    pub fn take(&mut self, sensed: &SensorReadings) -> Option<DistanceAngle> {
        let counts = [sensed.left_counts, sensed.right_counts];
        let last = self.last.replace(counts).unwrap_or(counts);
        for wheel in 0..2 {
            self.since[wheel] += i64::from(counts[wheel].wrapping_sub(last[wheel]) as i16);
        }
        self.readings += 1;
        if self.readings < READINGS_PER_DISTANCE_ANGLE {
            return None;
        }
        self.readings = 0;
        let [left, right] = std::mem::take(&mut self.since).map(|counts| counts as f64 * self.mm_per_count);
        // Casts truncate towards 0 and saturate.
        let angle = (right - left) / self.wheel_base_mm * 180.0 / PI;
        Some(DistanceAngle { distance_mm: (0.5 * (left + right)) as i16, angle_deg: angle as i16 })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::robot::model;

    /// The reports for wheels that roll `by` counts at each of `readings` readings.
    fn told(by: [i16; 2], readings: u32) -> Vec<DistanceAngle> {
        let mut meter = DistanceAngleMeter::new(model("roomba600").unwrap());
        // So that they wrap.
        let mut counts = [65_500_u16, 20];
        let reading = |[left_counts, right_counts]: [u16; 2]| SensorReadings {
            left_counts,
            right_counts,
            ..SensorReadings::default()
        };
        (0..readings)
            .filter_map(|_| {
                let told = meter.take(&reading(counts));
                counts = [0, 1].map(|wheel| counts[wheel].wrapping_add_signed(by[wheel]));
                told
            })
            .collect()
    }

    #[test]
    fn they_are_cut_towards_zero_and_what_is_cut_off_is_lost() {
        // 16 readings of 10 counts at 2.249 counts/mm are 71.1 mm; the first reading only sets the counters.
        assert_eq!(
            told([10, 10], 32),
            [DistanceAngle { distance_mm: 66, angle_deg: 0 }, DistanceAngle { distance_mm: 71, angle_deg: 0 }]
        );
        assert_eq!(told([-10, -10], 32)[1].distance_mm, -71);
        // 16 counts against 16 are 14.2 mm on a base of 235 mm, or 3.47 degrees.
        assert_eq!(told([-1, 1], 32)[1], DistanceAngle { distance_mm: 0, angle_deg: 3 });
        // Slower than a degree in that time is never reported.
        assert!(told([0, 0], 320).iter().all(|&told| told == DistanceAngle::default()));
    }

    #[test]
    fn they_end_where_16_bits_end() {
        let fast = told([30_000, 30_000], 32);
        assert_eq!(fast[1].distance_mm, i16::MAX);
        let [left, right] = DistanceAngle { distance_mm: 100, angle_deg: 90 }.rolled(0.235);
        assert!((left + right - 0.2).abs() < 1e-12 && ((right - left) / 0.235 - 0.5 * PI).abs() < 1e-12);
    }
}
