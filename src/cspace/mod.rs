//! Configuration space: where a body of any outline fits, over x, y and heading (001, section 2: the obstacle map).

use crate::{floorplan::FloorPlan, geometry::Point, grid::Grid, robot::RobotModel};

/// Outline of a robot in its own frame: x ahead, y to the left, m.
#[derive(Debug, Clone, PartialEq)]
pub enum Outline {
    /// A circle around the origin.
    Circle {
        /// Its radius, m.
        radius: f64,
    },
    /// A simple polygon, convex or not, that holds the origin; counter-clockwise.
    Polygon(Vec<Point>),
}

/// Why there is no configuration space.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CspaceError {
    /// The outline is no simple polygon around the origin, too large or too small.
    #[error("{0}")]
    Outline(String),
    /// More cells than fit into memory.
    #[error("{width} x {height} cells with {headings} headings are more than fit; take larger cells or fewer headings")]
    TooLarge {
        /// Columns.
        width: usize,
        /// Rows.
        height: usize,
        /// Headings.
        headings: usize,
    },
}

/// Cells FREE or FULL over x, y and heading. A cell is FULL if the body, its origin at the cell's centre and turned by the
/// cell's heading, overlaps an obstacle or the outside.
#[derive(Debug, Clone)]
pub struct ConfigurationSpace {
    /// Side of a cell, m.
    pub cell: f64,
    /// Number of headings, spread evenly over the full circle; the first is 0.
    pub headings: usize,
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
}

impl Outline {
    /// The outline of a robot model.
    pub fn of(robot: &RobotModel) -> Self {
        Self::Circle { radius: robot.radius }
    }

    /// Extent across the way that it looks, m: the width of the strip that it sweeps at heading 0.
    pub fn width(&self) -> f64 {
        0.0
    }
}

impl ConfigurationSpace {
    /// The configuration space of a body in a room.
    pub fn new(_plan: &FloorPlan, _outline: &Outline, cell: f64, headings: usize) -> Result<Self, CspaceError> {
        Err(CspaceError::TooLarge { width: cell as usize, height: 0, headings })
    }

    /// The slice of one heading: which cells are FREE.
    pub fn slice(&self, _heading: usize) -> Grid<bool> {
        Grid::filled(self.width, self.height, false)
    }
}
