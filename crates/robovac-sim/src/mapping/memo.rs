//! The first readings, kept to be processed again.
//!
//! The errors of the wheels can be estimated after some metres along walls; until then the heading drifts by a degree
//! every few metres, which affects all later mapping. So the filter processes its first readings again once it knows
//! the wheels.

use robovac_core::robot::{BatteryReading, DistanceAngle, SensorReadings};
use std::sync::Arc;

/// Readings per piece of the list.
const PIECE: usize = 512;

/// The parts of a reading that the filter uses.
#[derive(Debug, Clone, Copy)]
struct Memo {
    counts: [u16; 3],
    moved: Option<DistanceAngle>,
    light: [u16; 6],
    bumps: [bool; 2],
    progresses: bool,
    is_docked: bool,
    dirt: u8,
}

/// A list of readings whose copies share complete pieces.
#[derive(Debug, Clone, Default)]
pub(super) struct ReadingMemory {
    complete: Vec<Arc<[Memo]>>,
    last: Vec<Memo>,
}

impl ReadingMemory {
    pub fn add(&mut self, sensed: &SensorReadings) {
        self.last.push(Memo {
            counts: [sensed.left_counts, sensed.right_counts, sensed.lateral_counts],
            moved: sensed.moved,
            light: sensed.light_signal,
            bumps: [sensed.bump_left, sensed.bump_right],
            progresses: sensed.stasis,
            is_docked: sensed.battery.on_dock,
            dirt: sensed.dirt,
        });
        if self.last.len() == PIECE {
            self.complete.push(self.last.drain(..).collect());
        }
    }

    /// All of them, in order.
    pub fn readings(&self) -> impl Iterator<Item = SensorReadings> {
        self.complete.iter().flat_map(|piece| piece.iter()).chain(&self.last).map(|memo| SensorReadings {
            left_counts: memo.counts[0],
            right_counts: memo.counts[1],
            lateral_counts: memo.counts[2],
            moved: memo.moved,
            light_signal: memo.light,
            bump_left: memo.bumps[0],
            bump_right: memo.bumps[1],
            stasis: memo.progresses,
            battery: BatteryReading { on_dock: memo.is_docked, ..BatteryReading::default() },
            dirt: memo.dirt,
            ..SensorReadings::default()
        })
    }

    pub fn bytes(&self) -> usize {
        (self.complete.len() * PIECE + self.last.len()) * size_of::<Memo>()
    }
}
