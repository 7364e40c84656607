//! Sheet coordinates, in which files of any unit and origin are displayed alike.

use super::DrawingSource;
use robovac_core::geometry::{Point, Vector};

/// Longer side of the source on the sheet. The view can zoom in by 250 times and out to a sixteenth: see
/// [`crate::Viewport`].
const SIDE: f64 = 100.0;

/// Placement of a source on the sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sheet {
    /// Its lower left corner, in its unit.
    low: Point,
    /// Its size on the sheet.
    pub size: Vector,
    /// Sheet units per source unit.
    pub scale: f64,
}

impl Sheet {
    /// The sheet for a source.
    pub fn of(source: &DrawingSource) -> Self {
        let (low, size) = source.extent();
        let side = size.max();
        let scale = if side > 0.0 && side.is_finite() { SIDE / side } else { 1.0 };
        // A source without height or width still needs a sheet with both.
        Self { low, size: (size * scale).sup(&Vector::new(1.0, 1.0)), scale }
    }

    /// A point of the source, on the sheet.
    #[inline]
    pub fn place(&self, point: Point) -> Point {
        ((point - self.low) * self.scale).into()
    }

    /// A point of the sheet, in the source's unit.
    pub fn unit(&self, point: Point) -> Point {
        self.low + point.coords / self.scale
    }
}
