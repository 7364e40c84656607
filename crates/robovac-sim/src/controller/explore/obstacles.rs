//! The definition of obstacles: light bumper readings and bumper contacts.

use crate::controller::parts::{Obstruction, ObstructionKind, ObstructionSide};
use robovac_core::{math, robot::SensorReadings};

/// Turn after which a contact is no longer ahead, rad (ours).
const TURNED_AWAY: f64 = 0.5 * math::FRAC_PI_2;

/// Directions of obstacles, as seen by the robot.
#[expect(clippy::struct_excessive_bools)]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct SensedObstacles {
    /// Directly ahead: one of the two middle light sensors (12 degrees off), or a contact.
    pub ahead: bool,
    /// In the way ahead: one of the four sensors in front (32 degrees off, and the middle ones), or a contact.
    pub in_path: bool,
    /// On the left: one of the two outer light sensors there, or a contact.
    pub left: bool,
    /// On the right, likewise.
    pub right: bool,
}

/// The last contact, which the bumper no longer reports once the robot has backed off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct LastContact {
    side: ObstructionSide,
    /// Total turn at that time, rad.
    turned: f64,
}

impl LastContact {
    /// A contact after a total turn, rad.
    pub fn of(obstruction: Obstruction, turned: f64) -> Self {
        // The side of an edge or a beam isn't reliable.
        let side = if obstruction.kind == ObstructionKind::Bump { obstruction.side } else { ObstructionSide::Front };
        Self { side, turned }
    }

    /// Whether the robot has turned away from it.
    pub fn is_past(&self, turned: f64) -> bool {
        (turned - self.turned).abs() >= TURNED_AWAY - 1e-6
    }
}

impl SensedObstacles {
    /// The obstacles of a reading and the last contact.
    pub fn of(sensed: &SensorReadings, contact: Option<LastContact>) -> Self {
        let [left, front_left, middle_left, middle_right, front_right, right] = sensed.light_bumper;
        let is_felt = contact.is_some() || sensed.bumped();
        let felt = |side, pressed| pressed || contact.is_some_and(|contact| contact.side == side);
        let ahead = middle_left || middle_right || is_felt;
        Self {
            ahead,
            in_path: ahead || front_left || front_right,
            left: left || front_left || felt(ObstructionSide::Left, sensed.bump_left),
            right: right || front_right || felt(ObstructionSide::Right, sensed.bump_right),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_sensor_counts_where_it_looks() {
        // Ahead, in the path, left, right.
        let expected = ["---L", "-P-L", "AP--", "AP--", "-P-R", "---R"];
        for (index, expected) in expected.into_iter().enumerate() {
            let mut sensed = SensorReadings::default();
            sensed.light_bumper[index] = true;
            let SensedObstacles { ahead, in_path, left, right } = SensedObstacles::of(&sensed, None);
            let found = (ahead, in_path, left, right);
            let is = |letter| expected.contains(letter);
            assert_eq!(found, (is('A'), is('P'), is('L'), is('R')), "sensor {index}");
        }
    }

    #[test]
    fn a_contact_is_remembered_until_the_robot_has_turned_away() {
        let contact = LastContact::of(Obstruction { kind: ObstructionKind::Bump, side: ObstructionSide::Left }, 1.0);
        let seen = SensedObstacles::of(&SensorReadings::default(), Some(contact));
        assert_eq!(seen, SensedObstacles { ahead: true, in_path: true, left: true, right: false });
        assert!(!contact.is_past(0.3) && contact.is_past(0.2) && contact.is_past(1.8));
    }
}
