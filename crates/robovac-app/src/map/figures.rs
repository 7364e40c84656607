//! Map quality figures.

use super::RoomTruth;
use robovac_core::geometry::{Pose, difference};
use robovac_sim::mapping::{MapQuality, OccupancyMap};

/// Errors of a mapper's map and pose.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct MapErrorFigures {
    /// Distance between the robot's true and estimated position, m; `None` while there is no estimate.
    pub position_m: Option<f64>,
    /// Angle between its true and estimated heading, degrees, 0 to 180.
    pub heading_deg: Option<f64>,
    /// Share of the known cells that are right within one cell, 0 to 1; 1 while nothing is known.
    pub right: f64,
    /// Share of the floor that the body can cover that is known to be free, 0 to 1.
    pub known: f64,
    /// Share of the boundary that a bumper can find that is on the map, to within one cell, 0 to 1.
    pub boundary: f64,
}

impl MapErrorFigures {
    /// The errors of the pose `estimate` on `map` while the robot is at `pose`.
    pub fn of(map: &OccupancyMap, estimate: Option<Pose>, pose: Pose, truth: &RoomTruth) -> Self {
        let MapQuality { right, known, boundary, .. } = truth.quality(map);
        Self {
            position_m: estimate.map(|estimate| (estimate.position() - pose.position()).norm()),
            heading_deg: estimate.map(|estimate| difference(pose.heading, estimate.heading).abs().to_degrees()),
            right,
            known,
            boundary,
        }
    }
}
