//! A given map: the robot's own, or one from a file.

use super::{MapSession, numbers::digest};
use robovac_core::coverage::with_objects;
use robovac_core::{
    floor_plan::FloorPlan,
    geometry::Pose,
    grid::{Cell, Occupancy},
    robot::{OdometryModel, RobotModel},
};
use robovac_sim::{
    Input, RandomStream, World, dock_at,
    mapping::{
        Marks, OccupancyMap,
        locate::{Locator, LocatorSetup},
    },
};
use std::{fmt::Write, sync::Arc};

/// Log odds of a cell that is certain in a file.
const SURE: f64 = 5.0;
/// Longest side of a map, m; beyond any home.
const MOST_M: f64 = 200.0;
/// Lengths that differ by less are equal, m.
const TINY: f64 = 1e-6;

/// Reasons why the robot can't use a map.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum OpenError {
    /// There is no robot to use it.
    #[error("the robot doesn't fit into this room, so it can't use a map; choose another room in Explore")]
    NoRoom,
    /// It has no obstacles by which to localise.
    #[error(
        "the robot can't localise on this map: it has no walls, or no floor where the robot fits; choose another map"
    )]
    NothingOnIt,
    /// It is larger than any home.
    #[error("this map is {width:.0} m x {height:.0} m; the limit is {MOST_M} m a side: check its resolution")]
    TooLarge {
        /// Its width, m.
        width: f64,
        /// Its height, m.
        height: f64,
    },
}

/// A map that the robot uses without changing it.
#[derive(Debug, Clone)]
pub struct Known {
    map: Arc<OccupancyMap>,
    marks: Arc<Marks>,
    docks: Vec<Pose>,
    name: String,
    digest: u64,
}

/// Adds walls where the floor ends at the edge of the file, as everything outside counts as wall.
fn wall_in(map: &mut OccupancyMap, [left, right, bottom, top]: [i32; 4]) {
    let is_floor = |map: &OccupancyMap, x, y| {
        (-1..=1).any(|dy| (-1..=1).any(|dx| map.occupancy(Cell::new(x + dx, y + dy)) == Occupancy::Free))
    };
    let sides = (left - 1..=right + 1).flat_map(|x| [(x, bottom - 1), (x, top + 1)]);
    let ends = (bottom..=top).flat_map(|y| [(left - 1, y), (right + 1, y)]);
    let walls: Vec<(i32, i32)> = sides.chain(ends).filter(|&(x, y)| is_floor(map, x, y)).collect();
    for (x, y) in walls {
        map.add(Cell::new(x, y), SURE);
    }
}

impl Known {
    /// The map of `plan`, in cells of `resolution` metres, in the frame of a room whose lower-left corner lies at
    /// `origin` in the frame of that file: as files state the position of their corner, an exported map returns to its
    /// place.
    pub(super) fn new(plan: &FloorPlan, origin: Pose, resolution: f64, robot: &RobotModel) -> Result<Self, OpenError> {
        let [width, height] = [plan.width_m(), plan.height_m()];
        if width.max(height) > MOST_M {
            return Err(OpenError::TooLarge { width, height });
        }
        let docks = World::new(plan).docks;
        let plan = with_objects(plan);
        let shift = |far: f64| if far.is_finite() && far.abs() < MOST_M { far } else { 0.0 };
        let (right, up) = (shift(plan.origin.x - origin.x), shift(plan.origin.y - origin.y));
        // Cells that only touch don't count.
        let cells =
            |from: f64, to: f64, side: f64| ((from + TINY) / side).floor() as i32..=((to - TINY) / side).floor() as i32;
        let mut map = OccupancyMap::new(resolution);
        for y in cells(up, up + height, resolution) {
            for x in cells(right, right + width, resolution) {
                let low = [f64::from(x) * resolution - right, f64::from(y) * resolution - up];
                let mut covered = cells(low[1], low[1] + resolution, plan.resolution).flat_map(|row| {
                    let columns = cells(low[0], low[0] + resolution, plan.resolution);
                    columns.map(move |column| (column, row))
                });
                let mut is_free = false;
                let is_occupied = covered.any(|(column, row)| match plan.occupancy.get(Cell::new(column, row)) {
                    Some(Occupancy::Occupied) => true,
                    Some(Occupancy::Free) => {
                        is_free = true;
                        false
                    }
                    _ => false,
                });
                if is_occupied || is_free {
                    map.add(Cell::new(x, y), if is_occupied { SURE } else { -SURE });
                }
            }
        }
        let (columns, rows) = (cells(right, right + width, resolution), cells(up, up + height, resolution));
        wall_in(&mut map, [*columns.start(), *columns.end(), *rows.start(), *rows.end()]);
        let docks = docks.iter().map(|dock| Pose::new(dock.x + right, dock.y + up, dock.heading)).collect();
        Self::of(map, docks, plan.name.clone(), robot)
    }

    /// A given map with docks, in the frame of the room.
    pub(super) fn of(map: OccupancyMap, docks: Vec<Pose>, name: String, robot: &RobotModel) -> Result<Self, OpenError> {
        let mut text = String::new();
        for (cell, _) in map.iter() {
            // Writing to a text doesn't fail.
            let _ = write!(text, "{},{},{:?};", cell.x, cell.y, map.occupancy(cell));
        }
        for dock in &docks {
            let _ = write!(text, "dock {:?};", [dock.x, dock.y, dock.heading]);
        }
        let marks = Marks::new(map.resolution());
        let known = Self { map: Arc::new(map), marks: Arc::new(marks), docks, name, digest: digest(&text) };
        let try_out = known.locator(robot, OdometryModel::Arc, 0);
        if try_out.is_some() { Ok(known) } else { Err(OpenError::NothingOnIt) }
    }

    /// The locator for it; `None` if there are no obstacles to use.
    pub(super) fn locator(&self, robot: &RobotModel, odometry: OdometryModel, seed: u64) -> Option<Locator> {
        let locator = Locator::new(&self.map, LocatorSetup { robot: robot.clone(), odometry, seed })?;
        Some(locator.knowing_docks(&self.docks))
    }

    pub(super) fn map(&self) -> &OccupancyMap {
        &self.map
    }

    /// The dock on it, if there is just one: by two the robot wouldn't know which one it has come to.
    pub(super) fn dock(&self) -> Option<Pose> {
        if let [dock] = self.docks[..] { Some(dock) } else { None }
    }

    pub(super) fn docks(&self) -> &[Pose] {
        &self.docks
    }

    pub(super) fn marks(&self) -> &Marks {
        &self.marks
    }

    /// Its name.
    pub fn name(&self) -> &str {
        &self.name
    }

    pub(super) fn digest(&self) -> u64 {
        self.digest
    }
}

impl MapSession {
    /// Gives the robot a map, and kidnaps it to a random place in the room. Changes nothing on an error.
    pub fn open(&mut self, plan: &FloorPlan) -> Result<(), OpenError> {
        let (Some(base), Some(prepared), Some(truth)) = (&self.base, self.prepared(), self.truth()) else {
            return Err(OpenError::NoRoom);
        };
        let known = Known::new(plan, base.plan.origin, truth.resolution(), &prepared.robot)?;
        self.give(known);
        Ok(())
    }

    /// The same with the map that it made.
    pub fn open_own(&mut self) -> Result<(), OpenError> {
        let (Some(estimate), Some(prepared)) = (self.estimate(), self.prepared()) else {
            return Err(OpenError::NoRoom);
        };
        let berth = self.stage.as_ref().and_then(|stage| stage.run().mapper()?.berth());
        let docks = berth.iter().map(|&berth| dock_at(berth, &prepared.robot)).collect();
        let known = Known::of(estimate.map.clone(), docks, "its own map".to_owned(), &prepared.robot)?;
        self.give(known);
        Ok(())
    }

    fn give(&mut self, known: Known) {
        self.known = Some(known);
        self.begin();
    }

    /// Kidnaps the robot to a random place.
    pub(super) fn lose(&mut self) {
        let seed = self.base.as_ref().map_or(0, |base| base.seed);
        if let Some(stage) = &mut self.stage {
            let place = stage
                .run()
                .floor()
                .anywhere(&mut RandomStream::KidnappingOnMap.seeded(seed))
                .unwrap_or(stage.run().pose());
            stage.input(Input::Lift);
            stage.input(Input::PutDown(place));
        }
    }

    /// Removes the given map: the robot explores and maps again.
    pub fn close_map(&mut self) {
        if self.known.take().is_some() {
            self.begin();
        }
    }
}
