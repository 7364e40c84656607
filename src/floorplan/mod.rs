//! Floor plans: what the world looks like before a robot drives in it.

pub mod generate;

use crate::{
    geometry::{Point, Pose},
    grid::{Cell, Grid, Occupancy},
};

/// Largest number of columns or rows of a map that is taken in.
pub const MAX_SIDE: usize = 4096;

/// A room as an occupancy grid with its scale and start.
#[derive(Debug, Clone, PartialEq)]
pub struct FloorPlan {
    /// Short name, shown in menus.
    pub name: String,
    /// One sentence on what the room is good for; may be empty.
    pub note: String,
    /// Metres per cell, greater than 0.
    pub resolution: f64,
    /// State of every cell; the outside counts as wall.
    pub occupancy: Grid<Occupancy>,
    /// Where the robot starts, if the plan says so; metres from the lower-left corner.
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

    /// The cell that holds a point; may lie outside the grid.
    pub fn cell_at(&self, point: Point) -> Cell {
        Cell::new((point.x / self.resolution).floor() as i32, (point.y / self.resolution).floor() as i32)
    }

    /// Centre of a cell in metres.
    pub fn centre(&self, cell: Cell) -> Point {
        Point::new((f64::from(cell.x) + 0.5) * self.resolution, (f64::from(cell.y) + 0.5) * self.resolution)
    }

    /// Cells that are not known to be free, as obstacles.
    pub fn blocked(&self) -> Grid<bool> {
        self.occupancy.map(|&o| !o.is_free())
    }
}
