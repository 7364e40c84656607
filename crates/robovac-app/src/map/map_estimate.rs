//! The robot's estimates at one moment.

use super::{Known, store::StoredMap};
use robovac_core::geometry::Pose;
use robovac_sim::mapping::{Mapper, Marks, OccupancyMap, PoseCovariance, locate::Locator};

/// The robot's estimates.
#[derive(Clone, Copy)]
pub struct MapEstimate<'a> {
    /// The map.
    pub map: &'a OccupancyMap,
    /// Cleaned floor, and places where dirt was found.
    pub marks: &'a Marks,
    source: EstimateSource<'a>,
}

/// Source of the estimates.
#[derive(Clone, Copy)]
enum EstimateSource<'a> {
    /// The mapper.
    Mapper(&'a Mapper),
    /// The locator on a given map.
    Locator(&'a Locator),
    /// Relocalises a kidnapped robot on its own map; only a guess until the robot uses it.
    Lost(&'a Locator),
    /// A stored estimate.
    Store(Pose),
}

impl<'a> MapEstimate<'a> {
    pub(super) fn of(mapper: &'a Mapper) -> Self {
        Self { map: mapper.map(), marks: mapper.marks(), source: EstimateSource::Mapper(mapper) }
    }

    pub(super) fn on(known: &'a Known, locator: &'a Locator) -> Self {
        Self { map: known.map(), marks: known.marks(), source: EstimateSource::Locator(locator) }
    }

    pub(super) fn lost(mapper: &'a Mapper, locator: &'a Locator) -> Self {
        Self { map: mapper.map(), marks: mapper.marks(), source: EstimateSource::Lost(locator) }
    }

    pub(super) fn left(still: &'a StoredMap) -> Self {
        Self { map: &still.map, marks: &still.marks, source: EstimateSource::Store(still.pose) }
    }

    /// Its estimated pose; `None` while there is none.
    pub fn pose(&self) -> Option<Pose> {
        match self.source {
            EstimateSource::Mapper(mapper) => Some(mapper.pose()),
            EstimateSource::Locator(locator) | EstimateSource::Lost(locator) => locator.pose(),
            EstimateSource::Store(pose) => Some(pose),
        }
    }

    /// Covariance of that pose, if known.
    pub fn pose_covariance(&self) -> Option<PoseCovariance> {
        match self.source {
            EstimateSource::Mapper(mapper) => Some(mapper.pose_covariance()),
            EstimateSource::Locator(locator) | EstimateSource::Lost(locator) => locator.pose_covariance(),
            EstimateSource::Store(_) => None,
        }
    }

    /// Possible poses with their weights, which add up to 1.
    pub fn particles(&self) -> Vec<(Pose, f64)> {
        match self.source {
            EstimateSource::Mapper(mapper) => mapper.particles(),
            EstimateSource::Locator(locator) | EstimateSource::Lost(locator) => locator.particles(),
            EstimateSource::Store(_) => Vec::new(),
        }
    }

    /// Whether hardly any other place is possible; `None` for a robot that wasn't kidnapped.
    pub fn is_sure(&self) -> Option<bool> {
        match self.source {
            EstimateSource::Locator(locator) => Some(locator.is_sure()),
            EstimateSource::Lost(_) => Some(false),
            EstimateSource::Mapper(mapper) if mapper.is_lost() => Some(false),
            _ => None,
        }
    }
}
