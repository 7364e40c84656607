//! What moves and is used up in a world while a robot cleans it.

use super::World;
use crate::{coverage::ReachableFloor, geometry::Point};

/// The changing part of a world: where its movers are and which dirt is left.
#[derive(Debug, Clone, Default)]
pub struct Life {
    steps: u64,
    movers: Vec<(Point, f64)>,
}

impl Life {
    /// The world when the run begins; `seed` decides over everything random.
    pub fn new(_world: &World, _floor: &ReachableFloor, _seed: u64) -> Self {
        Self::default()
    }

    /// Lets one step of simulation pass.
    pub fn step(&mut self, _world: &World) {
        self.steps += 1;
    }

    /// Where the movers are, and their radii, m.
    pub fn movers(&self) -> &[(Point, f64)] {
        &self.movers
    }

    /// Roughly the memory that a clone takes, bytes.
    pub fn bytes(&self) -> usize {
        size_of::<Self>()
    }
}
