//! Overlay drawn on top of a drawing.

use robovac_core::geometry::Point;

/// Something to be drawn beside a drawing: lines on a layer of their own.
#[derive(Debug, Clone, PartialEq)]
pub struct Overlay {
    /// Name of the layer.
    pub layer: String,
    /// AutoCAD colour index, 1 to 255.
    pub colour: u8,
    /// Lines by their corners, in drawing units. One that ends where it begins is an outline.
    pub lines: Vec<Vec<Point>>,
}
