//! The robot's estimates at one moment.

use super::{Known, store::Still};
use robovac_core::geometry::Pose;
use robovac_sim::mapping::{Mapper, Marks, OccupancyMap, Spread, locate::Locator};

/// The robot's estimates.
#[derive(Clone, Copy)]
pub struct Belief<'a> {
    /// The map.
    pub map: &'a OccupancyMap,
    /// What was cleaned, and where dirt was found.
    pub marks: &'a Marks,
    source: Source<'a>,
}

/// Who believes it.
#[derive(Clone, Copy)]
enum Source<'a> {
    /// What makes the map.
    Mapper(&'a Mapper),
    /// What looks for the robot on a map that it was given.
    Locator(&'a Locator),
    /// Relocalises a kidnapped robot on its own map: until the robot goes by what this says, it only
    /// guesses.
    Lost(&'a Locator),
    /// Nobody at present: it was stored.
    Store(Pose),
}

impl<'a> Belief<'a> {
    pub(super) fn of(mapper: &'a Mapper) -> Self {
        Self { map: mapper.map(), marks: mapper.marks(), source: Source::Mapper(mapper) }
    }

    pub(super) fn on(known: &'a Known, locator: &'a Locator) -> Self {
        Self { map: known.map(), marks: known.marks(), source: Source::Locator(locator) }
    }

    pub(super) fn lost(mapper: &'a Mapper, locator: &'a Locator) -> Self {
        Self { map: mapper.map(), marks: mapper.marks(), source: Source::Lost(locator) }
    }

    pub(super) fn left(still: &'a Still) -> Self {
        Self { map: &still.map, marks: &still.marks, source: Source::Store(still.pose) }
    }

    /// Its estimated pose; `None` while it has no idea.
    pub fn pose(&self) -> Option<Pose> {
        match self.source {
            Source::Mapper(mapper) => Some(mapper.pose()),
            Source::Locator(locator) | Source::Lost(locator) => locator.pose(),
            Source::Store(pose) => Some(pose),
        }
    }

    /// How sure it is of that, as far as that is known.
    pub fn spread(&self) -> Option<Spread> {
        match self.source {
            Source::Mapper(mapper) => Some(mapper.spread()),
            Source::Locator(locator) | Source::Lost(locator) => locator.spread(),
            Source::Store(_) => None,
        }
    }

    /// Poses that it holds possible, with their weights, which add up to 1.
    pub fn particles(&self) -> Vec<(Pose, f64)> {
        match self.source {
            Source::Mapper(mapper) => mapper.particles(),
            Source::Locator(locator) | Source::Lost(locator) => locator.particles(),
            Source::Store(_) => Vec::new(),
        }
    }

    /// Whether hardly any other place is possible; `None` for a robot that isn't lost.
    pub fn is_sure(&self) -> Option<bool> {
        match self.source {
            Source::Locator(locator) => Some(locator.is_sure()),
            Source::Lost(_) => Some(false),
            Source::Mapper(mapper) if mapper.is_lost() => Some(false),
            _ => None,
        }
    }
}
