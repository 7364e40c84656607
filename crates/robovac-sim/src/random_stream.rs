//! The streams of a run's random numbers.

use robovac_core::rng::{Rng, seeded};

/// What draws random numbers in a run, each from a stream of its own: more draws of one don't change the others. Two of the
/// same number don't compile; numbers are below 256.
#[derive(Debug, Clone, Copy)]
#[repr(u8)]
pub enum RandomStream {
    /// Wheels and their slip.
    Slip = 1,
    /// Behaviours.
    Behaviour = 3,
    /// Sensors.
    Sensors = 4,
    /// People and pets.
    Life = 5,
    /// Faults of an emulated serial line.
    SerialLine = 6,
    /// Localisation on a known map.
    Localisation = 12,
    /// Places where a robot that is to relocalise is put down, in experiments.
    Kidnapping = 13,
    /// The same in the tab Map.
    KidnappingOnMap = 14,
    /// The same between two cleanings.
    KidnappingBetweenCleanings = 15,
    /// The laser, which draws many at a time.
    Laser = 40,
    /// Loop closure.
    LoopClosure = 60,
    /// Environments for reinforcement learning.
    Environment = 71,
}

impl RandomStream {
    /// The generator of the run with this seed.
    pub fn seeded(self, seed: u64) -> Rng {
        seeded(seed, self as u64)
    }

    /// The generator of one of several that draw, such as the people of a room; `number` counts from 0.
    pub fn seeded_for(self, number: usize, seed: u64) -> Rng {
        seeded(seed, self as u64 + ((number as u64 + 1) << 8))
    }
}
