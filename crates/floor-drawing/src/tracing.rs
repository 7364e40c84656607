//! Input and result of tracing a room from a drawing.

use super::model::Role;
use robovac_core::{
    floor_plan::FloorPlan,
    geometry::{Point, Vector},
};

/// The part of a drawing that is meant, in drawing units.
#[derive(Debug, Clone, PartialEq)]
pub enum DrawingRegion {
    /// All of it.
    Whole,
    /// An upright rectangle.
    Rectangle {
        /// Lower left corner.
        low: Point,
        /// Upper right corner.
        high: Point,
    },
    /// A simple polygon.
    Polygon(Vec<Point>),
    /// The room that holds this point: as far as one gets without crossing a wall.
    Room(Point),
}

/// How a drawing becomes a room.
#[derive(Debug, Clone, PartialEq)]
pub struct Tracing {
    /// What every layer is, in their order.
    pub roles: Vec<Role>,
    /// Metres per drawing unit.
    pub metre: f64,
    /// Widest gap between ends of wall strokes that is closed, m; 0 for none.
    pub gap: f64,
    /// Side of the room's cells, m.
    pub resolution: f64,
    /// The part that is meant.
    pub region: DrawingRegion,
}

/// A room traced from a drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct Traced {
    /// The room.
    pub plan: FloorPlan,
    /// Where the lower-left corner of the room lies in the drawing, in drawing units: a point of the room is
    /// `corner + point / metre` in the drawing.
    pub corner: Vector,
    /// Metres per drawing unit.
    pub metre: f64,
    /// Gaps that were closed: both ends, m in the room.
    pub gaps: Vec<[Point; 2]>,
}
