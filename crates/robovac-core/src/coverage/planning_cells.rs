//! Where planning cells lie.

use crate::{geometry::Point, grid::Cell};

/// A lattice of square planning cells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlanningCells {
    /// Side of a cell, m.
    pub size: f64,
    /// How far the first column begins to the left of the map's lower-left corner, and the first row below it, m: each from 0
    /// to less than the side.
    pub offset: [f64; 2],
}

impl PlanningCells {
    /// The cell that contains `point`.
    pub fn at(&self, point: Point) -> Cell {
        let [x, y] = self.offset;
        Cell::at(Point::new(point.x + x, point.y + y), self.size)
    }

    /// The lower left corner of a cell, m.
    pub fn corner(&self, cell: Cell) -> Point {
        let [x, y] = self.offset;
        Point::new(f64::from(cell.x) * self.size - x, f64::from(cell.y) * self.size - y)
    }

    /// The centre of a cell, m.
    pub fn centre(&self, cell: Cell) -> Point {
        let [x, y] = self.offset;
        Point::new((f64::from(cell.x) + 0.5) * self.size - x, (f64::from(cell.y) + 0.5) * self.size - y)
    }

    /// Columns or rows (`axis` 0 or 1) over `length` metres from the map's corner; the last one can extend beyond.
    pub fn along(&self, axis: usize, length: f64) -> usize {
        (((length + self.offset[axis]) / self.size - 1e-6).ceil() as usize).max(1)
    }
}

/// Cells of that size from the map's corner.
impl From<f64> for PlanningCells {
    fn from(size: f64) -> Self {
        Self { size, offset: [0.0, 0.0] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_and_cells_are_inverse() {
        let cells = PlanningCells { size: 0.12, offset: [0.04, 0.08] };
        for cell in [Cell::new(0, 0), Cell::new(7, 3)] {
            assert_eq!(cells.at(cells.centre(cell)), cell);
            let half = cells.centre(cell) - cells.corner(cell);
            assert!((half.x - 0.06).abs() < 1e-12 && (half.y - 0.06).abs() < 1e-12, "{half}");
        }
        // 0.16 m reach over 0.2 m and over 0.24 m with the offsets.
        assert_eq!((cells.along(0, 0.16), cells.along(1, 0.16), cells.along(1, 0.17)), (2, 2, 3));
    }
}
