//! Overlay drawn on top of a drawing.

use robovac_core::geometry::Point;

/// Lines to be drawn beside a drawing, on a layer of their own.
#[derive(Debug, Clone, PartialEq)]
pub struct Overlay {
    /// Name of the layer.
    pub layer: String,
    /// AutoCAD colour index, 1 to 255.
    pub colour: u8,
    /// Lines by their corners, in drawing units. A line whose last corner is its first is closed.
    pub lines: Vec<Vec<Point>>,
}
