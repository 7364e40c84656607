//! Transform between a room's cells and a drawing.

use crate::{Drawing, DrawingFlaw};
use robovac_core::{
    floor_plan::MAX_SIDE,
    geometry::{Point, Vector},
    math::ceil,
};

/// An axis-aligned rectangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct BoundingBox {
    pub low: Point,
    pub high: Point,
}

impl BoundingBox {
    pub fn of(points: impl IntoIterator<Item = Point>) -> Option<Self> {
        let mut points = points.into_iter();
        let first = points.next()?;
        Some(points.fold(Self { low: first, high: first }, |bounds, point| Self {
            low: bounds.low.inf(&point),
            high: bounds.high.sup(&point),
        }))
    }
}

/// A grid of cells on a drawing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct RasterFrame {
    /// Lower-left corner, drawing units.
    pub low: Point,
    /// Side of a cell, drawing units.
    pub side: f64,
    /// Columns and rows; can exceed the limits of a room.
    pub size: [i32; 2],
}

impl RasterFrame {
    /// Cells for all of the bounds, with a margin of `margin` cells on every side.
    pub fn around(bounds: &BoundingBox, side: f64, margin: i32) -> Self {
        let size = bounds.high - bounds.low;
        let count = |length: f64| ceil(length / side - 1e-9).max(1).saturating_add(2 * margin);
        let low = bounds.low - Vector::repeat(side * f64::from(margin));
        Self { low, side, size: [count(size.x), count(size.y)] }
    }

    /// Checks that a room can have that many cells; `metre` is for the message.
    pub fn check(&self, metre: f64) -> Result<(), DrawingFlaw> {
        let resolution = self.side * metre;
        let [width, height] = self.size.map(|count| f64::from(count) * resolution);
        let most = i32::try_from(MAX_SIDE).unwrap_or(i32::MAX);
        if self.size[0].max(self.size[1]) <= most {
            return Ok(());
        }
        // The next of 1, 2 or 5 times a power of ten.
        let least = width.max(height) / f64::from(most - 4);
        let mut would_do = 1e-3;
        let mut factors = [2.0, 2.5, 2.0].into_iter().cycle();
        while would_do < least && would_do < 1e12 {
            would_do *= factors.next().unwrap_or(2.0);
        }
        // Rounded, as the factor 2.5 is inexact.
        would_do = (would_do * 1000.0).round() / 1000.0;
        Err(DrawingFlaw::TooManyCells { width, height, resolution, would_do })
    }

    /// A part of the frame by its cells: from column and row `from`, `size` columns and rows.
    pub fn part(&self, from: [i32; 2], size: [i32; 2]) -> Self {
        let step = Vector::new(f64::from(from[0]), f64::from(from[1])) * self.side;
        Self { low: self.low + step, size, ..*self }
    }

    /// A point of the drawing in cells from the lower-left corner.
    pub fn cells(&self, point: Point) -> Point {
        Point::from((point - self.low) / self.side)
    }

    /// A position in cells as a point of the drawing.
    pub fn point(&self, cells: Point) -> Point {
        self.low + cells.coords * self.side
    }
}

/// Bounds of strokes.
pub(super) fn bounds_of(drawing: &Drawing, mut is_meant: impl FnMut(u32) -> bool) -> Option<BoundingBox> {
    let strokes = drawing.strokes.iter().filter(|stroke| is_meant(stroke.layer));
    BoundingBox::of(strokes.flat_map(|stroke| {
        let half = Vector::repeat(0.5 * stroke.width);
        drawing.corners(stroke).iter().flat_map(move |corner| [corner - half, corner + half])
    }))
}
