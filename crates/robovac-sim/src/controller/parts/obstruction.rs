//! Obstructions that stop a robot driving ahead.

use robovac_core::robot::SensorReadings;

/// An obstruction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::controller) struct Obstruction {
    /// Its kind.
    pub kind: ObstructionKind,
    /// Its side.
    pub side: ObstructionSide,
}

/// Kinds of obstructions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::controller) enum ObstructionKind {
    /// A wall or furniture, by the bumper.
    Bump,
    /// No floor.
    Cliff,
    /// The beam of a virtual wall.
    Beam,
}

/// Side of an obstruction, as seen by the robot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::controller) enum ObstructionSide {
    Left,
    Front,
    Right,
}

impl ObstructionSide {
    /// From detections on the left and on the right.
    fn of(left: bool, right: bool) -> Option<Self> {
        match (left, right) {
            (true, true) => Some(Self::Front),
            (true, false) => Some(Self::Left),
            (false, true) => Some(Self::Right),
            (false, false) => None,
        }
    }
}

impl Obstruction {
    /// The most dangerous obstruction in a reading. On a dock, whose ramp is black, the cliff sensors are ignored.
    pub(super) fn of(sensed: &SensorReadings, heeds_beam: bool) -> Option<Self> {
        let [left, front_left, front_right, right] = sensed.cliff;
        let edge = ObstructionSide::of(left || front_left, right || front_right).filter(|_| !sensed.battery.on_dock);
        if let Some(side) = edge {
            return Some(Self { kind: ObstructionKind::Cliff, side });
        }
        if let Some(side) = ObstructionSide::of(sensed.bump_left, sensed.bump_right) {
            return Some(Self { kind: ObstructionKind::Bump, side });
        }
        // Held wheels without a bumper contact, as with a narrow bumper between two walls.
        if sensed.overcurrent.left_wheel && sensed.overcurrent.right_wheel {
            return Some(Self { kind: ObstructionKind::Bump, side: ObstructionSide::Front });
        }
        (heeds_beam && sensed.virtual_wall)
            .then_some(Self { kind: ObstructionKind::Beam, side: ObstructionSide::Front })
    }
}
