//! Dock beams seen by the infrared receivers, with gaps filled from recent readings.

use robovac_core::robot::SensorReadings;

/// Duration of a detection, s: at 15 ms per reading, so many misses in a row are rare even in sunlight.
const LASTS_S: f64 = 0.12;
/// Bits of a dock's characters (Open Interface specification): force field, green beam, red beam. All have the base.
const BASE: u8 = 160;
const FIELD: u8 = 1;
const GREEN: u8 = 4;
const RED: u8 = 8;

/// Recent detections of a dock.
#[derive(Debug, Clone, Default)]
pub(in crate::controller) struct Beacon {
    /// Remaining time of each detection, s: force field, green beam, red beam; by the left and the right receiver.
    left: [f64; 5],
}

impl Beacon {
    /// Takes the next reading.
    pub(in crate::controller) fn update(&mut self, sensed: &SensorReadings, dt_s: f64) {
        let seen = sensed.infrared;
        let all = [seen.omni, seen.left, seen.right];
        let is_of_dock = |character: u8| character & !(FIELD | GREEN | RED) == BASE && character != BASE;
        let has = |bit: u8| all.iter().any(|&character| is_of_dock(character) && character & bit != 0);
        // Only beams give a direction: the force field is reflected from everywhere.
        let beams = |character: u8| is_of_dock(character) && character & (GREEN | RED) != 0;
        let now = [has(FIELD), has(GREEN), has(RED), beams(seen.left), beams(seen.right)];
        for (left, now) in self.left.iter_mut().zip(now) {
            *left = if now { LASTS_S } else { *left - dt_s };
        }
    }

    /// Whether the dock is near.
    pub(in crate::controller) fn is_near(&self) -> bool {
        self.left[0] > 0.0
    }

    /// Whether the beams to the left and to the right of the dock's middle are detected, for a robot that faces it.
    pub(in crate::controller) fn beams(&self) -> (bool, bool) {
        (self.left[1] > 0.0, self.left[2] > 0.0)
    }

    /// Whether the left and the right receiver detect the dock.
    pub(in crate::controller) fn sides(&self) -> (bool, bool) {
        (self.left[3] > 0.0, self.left[4] > 0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::robot::Infrared;

    #[test]
    fn characters_are_told_apart_and_remembered_for_a_moment() {
        let mut beacon = Beacon::default();
        let reading = |omni, left, right| SensorReadings {
            infrared: Infrared { omni, left, right },
            ..SensorReadings::default()
        };
        beacon.update(&reading(165, 0, 164), 0.015);
        assert!(beacon.is_near() && beacon.beams() == (true, false) && beacon.sides() == (false, true));
        beacon.update(&reading(0, 0, 0), 0.015);
        assert_eq!(beacon.beams(), (true, false));
        for _ in 0..20 {
            beacon.update(&reading(162, 162, 0), 0.015);
        }
        assert!(!beacon.is_near() && beacon.beams() == (false, false) && beacon.sides() == (false, false));
    }
}
