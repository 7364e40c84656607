//! Floor plans: walls, objects and start, before a robot drives.
//!
//! [`ROOMS`] are built in, [`load`] reads files, [`to_ascii`], [`to_ros_map`] and [`Scenario`] write them.

#[cfg(feature = "files")]
mod files;
mod object;
mod rooms;
mod shape;
mod sketch;

#[cfg(feature = "files")]
pub use files::*;
pub use object::{Object, Who};
pub use rooms::{ROOMS, RoomInfo, RoomKind, room};
pub use shape::{crossing, encloses, has_area, middle};
pub use sketch::{Rect, Sketch};

pub mod generate;

use crate::{
    geometry::{Point, Pose},
    grid::{Cell, Grid, Occupancy},
};

/// Largest number of columns or rows of a map.
pub const MAX_SIDE: usize = 4096;
/// Finest resolution of a map, metres per cell.
pub const MIN_RESOLUTION: f64 = 0.001;
/// Coarsest resolution of a map, metres per cell.
pub const MAX_RESOLUTION: f64 = 100.0;

/// A room as an occupancy grid with its scale and start.
#[derive(Debug, Clone, PartialEq)]
pub struct FloorPlan {
    /// Short name, shown in menus.
    pub name: String,
    /// One sentence on the room's purpose; can be empty.
    pub note: String,
    /// Metres per cell, greater than 0.
    pub resolution: f64,
    /// State of every cell; the outside counts as wall.
    pub occupancy: Grid<Occupancy>,
    /// Its objects.
    pub objects: Vec<Object>,
    /// Start of the robot, if given; metres from the lower-left corner.
    pub start: Option<Pose>,
    /// Pose of the lower-left corner in the map frame of the file it came from (ROS `origin`); kept for export.
    pub origin: Pose,
}

impl FloorPlan {
    /// Width in metres.
    pub fn width_m(&self) -> f64 {
        self.occupancy.width() as f64 * self.resolution
    }

    /// Height in metres.
    pub fn height_m(&self) -> f64 {
        self.occupancy.height() as f64 * self.resolution
    }

    /// Width and height of the floor within its walls: of the box around all free cells, m; 0 if there are none.
    pub fn floor_size(&self) -> [f64; 2] {
        let (mut low, mut high) = ([i32::MAX; 2], [i32::MIN; 2]);
        for (cell, _) in self.occupancy.iter().filter(|(_, state)| state.is_free()) {
            (low, high) = ([low[0].min(cell.x), low[1].min(cell.y)], [high[0].max(cell.x), high[1].max(cell.y)]);
        }
        let cells = |axis: usize| f64::from((i64::from(high[axis]) - i64::from(low[axis]) + 1).max(0) as u32);
        [0, 1].map(|axis| cells(axis) * self.resolution)
    }

    /// The cell that holds a point; may lie outside the grid.
    pub fn cell_at(&self, point: Point) -> Cell {
        Cell::at(point, self.resolution)
    }

    /// Centre of a cell in metres.
    pub fn centre(&self, cell: Cell) -> Point {
        cell.centre(self.resolution)
    }

    /// Cells that are not known to be free, as obstacles.
    pub fn blocked(&self) -> Grid<bool> {
        self.occupancy.map(|&o| !o.is_free())
    }
}

/// A file's name without its ending, for menus.
pub fn stem(file: &str) -> String {
    match file.rsplit_once('.') {
        Some((stem, _)) if !stem.is_empty() => stem.to_owned(),
        _ => file.to_owned(),
    }
}
