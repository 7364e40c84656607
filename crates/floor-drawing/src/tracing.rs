//! Input and result of tracing a room from a drawing.

use super::model::Role;
use robovac_core::{
    floor_plan::FloorPlan,
    geometry::{Point, Vector},
};

/// The part of a drawing to be traced, in drawing units.
#[derive(Debug, Clone, PartialEq)]
pub enum DrawingRegion {
    /// All of it.
    Whole,
    /// An axis-aligned rectangle.
    Rectangle {
        /// Lower left corner.
        low: Point,
        /// Upper right corner.
        high: Point,
    },
    /// A simple polygon.
    Polygon(Vec<Point>),
    /// The room around this point: everything reachable without crossing a wall.
    Room(Point),
}

/// Parameters of tracing a room from a drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct Tracing {
    /// The role of every layer, in their order.
    pub roles: Vec<Role>,
    /// Metres per drawing unit.
    pub metre: f64,
    /// Widest gap between ends of wall strokes that is closed, m; 0 for none.
    pub gap: f64,
    /// Side of the room's cells, m.
    pub resolution: f64,
    /// The part to be traced.
    pub region: DrawingRegion,
}

/// A room traced from a drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct Traced {
    /// The room.
    pub plan: FloorPlan,
    /// Position of the room's lower-left corner in the drawing, in drawing units: a point of the room is
    /// `corner + point / metre` in the drawing.
    pub corner: Vector,
    /// Metres per drawing unit.
    pub metre: f64,
    /// Gaps that were closed: both ends, m, in the room.
    pub gaps: Vec<[Point; 2]>,
}
