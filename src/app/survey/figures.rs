//! How good a map is, in numbers.

use super::{Truth, Verdict, truth::around};
use crate::{
    geometry::{Pose, difference},
    grid::Occupancy,
    mapping::OccupancyMap,
};

/// How far a mapper is from the truth.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize)]
pub struct Figures {
    /// Distance between where the robot is and where it believes to be, m; `None` while it has no idea.
    pub position_m: Option<f64>,
    /// Angle between its heading and what it believes that to be, degrees, 0 to 180.
    pub heading_deg: Option<f64>,
    /// Share of the known cells that are right within one cell, 0 to 1; 1 while nothing is known.
    pub right: f64,
    /// Share of the floor that the body can cover which is known to be free, 0 to 1.
    pub known: f64,
    /// Share of the boundary that a bumper can find which is on the map, to within one cell, 0 to 1.
    pub boundary: f64,
}

impl Figures {
    /// The figures of a robot that believes to be at `believed` on `map` while it is at `pose`.
    pub fn of(map: &OccupancyMap, believed: Option<Pose>, pose: Pose, truth: &Truth) -> Self {
        Self {
            position_m: believed.map(|believed| (believed.position() - pose.position()).norm()),
            heading_deg: believed.map(|believed| difference(pose.heading, believed.heading).abs().to_degrees()),
            right: right(map, truth),
            known: share(truth.covered(), |cell| map.occupancy(cell) == Occupancy::Free),
            boundary: share(truth.boundary(), |cell| {
                around(cell).any(|near| map.occupancy(near) == Occupancy::Occupied)
            }),
        }
    }
}

fn right(map: &OccupancyMap, truth: &Truth) -> f64 {
    let known = map.iter().map(|(cell, _)| cell).filter(|&cell| map.occupancy(cell) != Occupancy::Unknown);
    let is_wrong = |cell| matches!(truth.verdict(map, cell), Some(Verdict::Phantom | Verdict::Missed));
    let (all, wrong) = known.fold((0_u32, 0_u32), |(all, wrong), cell| (all + 1, wrong + u32::from(is_wrong(cell))));
    if all == 0 { 1.0 } else { f64::from(all - wrong) / f64::from(all) }
}

/// Share of the items that are such, 0 of none.
fn share<T>(items: impl Iterator<Item = T>, is_such: impl Fn(T) -> bool) -> f64 {
    let (all, such) = items.fold((0_u32, 0_u32), |(all, such), item| (all + 1, such + u32::from(is_such(item))));
    if all == 0 { 0.0 } else { f64::from(such) / f64::from(all) }
}
