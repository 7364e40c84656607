//! Encoder counts of a robot that reports none, by its distance and angle.
//!
//! A Create 1, and a Roomba 900 over its own USB port, tell how far they went four times a second (packets 19 and 20). In
//! between, the wheels count as rolling as they were commanded to; each report replaces what was assumed since the last one.
//! So controllers get counts as of other robots, only less exact: the packets are whole millimetres and degrees.

use robovac_core::robot::DistanceAngle;
use roomba_oi::motion::{MM_PER_COUNT, WHEEL_BASE_MM};

/// The wheels' ways: left, right.
#[derive(Debug, Clone, Default)]
pub(super) struct ReckonedCounts {
    /// As reported, mm.
    told_mm: [f64; 2],
    /// As assumed since the last report, mm.
    assumed_mm: [f64; 2],
}

impl ReckonedCounts {
    /// The wheels rolled for a time at the commanded speeds, mm/s.
    pub fn roll(&mut self, seconds: f64, speeds: [i16; 2]) {
        for (way, speed) in self.assumed_mm.iter_mut().zip(speeds) {
            *way += seconds * f64::from(speed);
        }
    }

    /// The robot reports its motion since the last report.
    pub fn report(&mut self, moved: DistanceAngle) {
        let rolled = moved.rolled(WHEEL_BASE_MM / 1000.0);
        for (way, metres) in self.told_mm.iter_mut().zip(rolled) {
            *way += 1000.0 * metres;
        }
        self.assumed_mm = [0.0; 2];
    }

    /// The counts so far, which wrap as those of encoders do.
    pub fn counts(&self) -> [u16; 2] {
        [0, 1].map(|wheel| ((self.told_mm[wheel] + self.assumed_mm[wheel]) / MM_PER_COUNT).round() as i64 as u16)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_report_replaces_what_was_assumed() {
        let mut wheels = ReckonedCounts::default();
        for _ in 0..16 {
            wheels.roll(0.015, [100, 100]);
        }
        // 24 mm.
        assert_eq!(wheels.counts(), [54; 2]);
        // It was pushed against a wall: it hasn't moved.
        wheels.report(DistanceAngle { distance_mm: 0, angle_deg: 0 });
        assert_eq!(wheels.counts(), [0; 2]);
        // Once around to the left.
        wheels.report(DistanceAngle { distance_mm: 0, angle_deg: 360 });
        let [left, right] = wheels.counts();
        assert_eq!((left.wrapping_add(right), right), (0, 1661));
    }
}
