//! Line drawings of floors: CAD drawings (DXF) and other vector files in, and the rooms that are traced from them.
//!
//! A [`Drawing`] is what a file shows, flattened to straight strokes on layers, in the file's own units. [`trace`] makes a
//! [`FloorPlan`] of it once somebody has said what its layers are, how long its unit is and which part is meant.

use crate::{
    floorplan::{FloorPlan, MapError, SourceFile},
    geometry::{Point, Vector},
};
use std::ops::Range;

/// What a vector file shows. x to the right, y up, in drawing units.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawing {
    /// The file's name without its ending.
    pub name: String,
    /// Metres per drawing unit, if the file says ($INSUNITS of a DXF); `None` is to be asked for.
    pub metre: Option<f64>,
    /// Layers, in the file's order.
    pub layers: Vec<Layer>,
    /// Straight strokes: arcs, bulges, ellipses and splines are flattened, blocks are inserted.
    pub strokes: Vec<Stroke>,
    /// Corners of all strokes.
    pub points: Vec<Point>,
    /// What isn't drawn, for users: "12 texts", "3 hatches".
    pub left_out: Vec<String>,
}

/// A layer of a drawing.
#[derive(Debug, Clone, PartialEq)]
pub struct Layer {
    /// Its name.
    pub name: String,
    /// Its colour in the drawing, red, green, blue.
    pub colour: [u8; 3],
    /// Number of strokes on it.
    pub strokes: usize,
    /// What it seems to be, by its name.
    pub role: Role,
}

/// What a layer is to a robot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Role {
    /// Walls: every stroke stops the robot, an outline encloses floor.
    Wall,
    /// Things on the floor: a closed outline is solid.
    Obstacle,
    /// Not there.
    Ignored,
}

/// A polyline.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Stroke {
    /// Index of its layer.
    pub layer: u32,
    /// Number of the entity in the file that it comes from, counted from 1.
    pub entity: u32,
    /// Whether its last corner is joined to its first.
    pub is_closed: bool,
    /// Its corners, in [`Drawing::points`].
    pub points: Range<u32>,
}

/// The part of a drawing that is meant, in drawing units.
#[derive(Debug, Clone, PartialEq)]
pub enum Region {
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
    pub region: Region,
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

/// Something to be drawn beside a drawing: lines on a layer of their own.
#[derive(Debug, Clone, PartialEq)]
pub struct Overlay {
    /// Name of the layer.
    pub layer: String,
    /// AutoCAD colour index, 1 to 255.
    pub colour: u8,
    /// Lines by their corners, in drawing units.
    pub lines: Vec<Vec<Point>>,
}

/// Whether a file looks like a drawing that [`read`] reads.
pub fn is_drawing(_file: &SourceFile) -> bool {
    false
}

/// Reads a DXF, SVG or GeoJSON drawing.
pub fn read(file: &SourceFile) -> Result<Drawing, MapError> {
    Err(MapError::Empty { name: file.name.clone() })
}

/// Makes a room of a drawing.
pub fn trace(drawing: &Drawing, _how: &Tracing) -> Result<Traced, MapError> {
    Err(MapError::NoFreeCell { name: drawing.name.clone() })
}

/// A DXF with `overlays` on layers of their own, beside all that is in `original` (the bytes of a DXF) if there is one.
pub fn to_dxf(_original: Option<&[u8]>, _overlays: &[Overlay]) -> Result<Vec<u8>, MapError> {
    Ok(Vec::new())
}
