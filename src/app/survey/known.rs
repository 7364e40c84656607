//! A map that the robot is given: its own, or one from a file.

use super::numbers::digest;
use crate::{
    app::export::with_objects,
    floorplan::FloorPlan,
    geometry::Pose,
    grid::{Cell, Occupancy},
    mapping::{
        Marks, OccupancyMap,
        locate::{Locator, LocatorSetup},
    },
    robot::{OdometryModel, RobotModel},
};
use std::{fmt::Write, sync::Arc};

/// Log odds of a cell that a file is sure of.
const SURE: f64 = 5.0;

/// Why a map can't be given to the robot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum OpenError {
    /// There is no robot that it could be given to.
    #[error("the robot can't be put into this room, so it has no use for a map; choose another room in Explore")]
    NoRoom,
    /// There is nothing on it to find oneself by.
    #[error(
        "the robot can't find itself on this map: it has no walls, or no place where the robot fits; choose a map with both"
    )]
    NothingOnIt,
}

/// A map that the robot knows and does not change.
#[derive(Debug, Clone)]
pub struct Known {
    map: Arc<OccupancyMap>,
    marks: Arc<Marks>,
    name: String,
    digest: u64,
}

impl Known {
    /// The map that `plan` is, in the frame of a room whose lower-left corner lies at `origin` in the frame of that file: as
    /// files say where their corner lies, a map that was exported comes back where it was.
    pub(super) fn new(plan: &FloorPlan, origin: Pose, robot: &RobotModel) -> Result<Self, OpenError> {
        let plan = with_objects(plan);
        let mut map = OccupancyMap::new(plan.resolution);
        let shift =
            |far: f64| if far.is_finite() && far.abs() < 1e4 { (far / plan.resolution).round() as i32 } else { 0 };
        let (right, up) = (shift(plan.origin.x - origin.x), shift(plan.origin.y - origin.y));
        for (cell, &occupancy) in plan.occupancy.iter() {
            let odds = match occupancy {
                Occupancy::Unknown => continue,
                Occupancy::Free => -SURE,
                Occupancy::Occupied => SURE,
            };
            map.add(Cell::new(cell.x + right, cell.y + up), odds);
        }
        Self::of(map, plan.name.clone(), robot)
    }

    /// A map as it is, in the frame of the room.
    pub(super) fn of(map: OccupancyMap, name: String, robot: &RobotModel) -> Result<Self, OpenError> {
        let mut text = String::new();
        for (cell, _) in map.iter() {
            // Writing to a text doesn't fail.
            let _ = write!(text, "{},{},{:?};", cell.x, cell.y, map.occupancy(cell));
        }
        let marks = Marks::new(map.resolution());
        let known = Self { map: Arc::new(map), marks: Arc::new(marks), name, digest: digest(&text) };
        let try_out = known.locator(robot, OdometryModel::Arc, 0);
        if try_out.is_some() { Ok(known) } else { Err(OpenError::NothingOnIt) }
    }

    /// What looks for the robot on it; `None` if there is nothing to go by.
    pub(super) fn locator(&self, robot: &RobotModel, odometry: OdometryModel, seed: u64) -> Option<Locator> {
        Locator::new(&self.map, LocatorSetup { robot: robot.clone(), odometry, seed })
    }

    pub(super) fn map(&self) -> &OccupancyMap {
        &self.map
    }

    pub(super) fn marks(&self) -> &Marks {
        &self.marks
    }

    /// What it is called.
    pub fn name(&self) -> &str {
        &self.name
    }

    pub(super) fn digest(&self) -> u64 {
        self.digest
    }
}
