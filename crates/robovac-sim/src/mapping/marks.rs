//! Floor cleaned and dirt found, on the map.

use super::TiledLayer;
use robovac_core::{geometry::Point, grid::Cell};

/// A state of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CellMark {
    /// The brush passed over its centre.
    Cleaned = 1,
    /// The dirt sensor responded there.
    Dirty = 2,
}

/// States of map cells, at the robot's estimated poses.
#[derive(Debug, Clone)]
pub struct Marks {
    resolution: f64,
    noted: TiledLayer<u8>,
}

impl Marks {
    /// No states; cells of `resolution` metres.
    pub fn new(resolution: f64) -> Self {
        Self { resolution, noted: TiledLayer::new() }
    }

    /// Side of its cells, m.
    pub fn resolution(&self) -> f64 {
        self.resolution
    }

    /// Sets a state for all cells whose centres lie within `radius` metres of `point`.
    pub fn note(&mut self, point: Point, radius: f64, mark: CellMark) {
        let reach = (radius / self.resolution).ceil() as i32;
        let middle = Cell::at(point, self.resolution);
        for y in middle.y - reach..=middle.y + reach {
            for x in middle.x - reach..=middle.x + reach {
                let cell = Cell::new(x, y);
                if (cell.centre(self.resolution) - point).norm_squared() <= radius * radius {
                    self.noted.update(cell, |bits| bits | mark as u8);
                }
            }
        }
    }

    /// Whether a cell has a state.
    #[inline]
    pub fn has(&self, cell: Cell, mark: CellMark) -> bool {
        self.noted.get(cell) & mark as u8 != 0
    }

    /// Cells with a state.
    pub fn cells(&self, mark: CellMark) -> impl Iterator<Item = Cell> {
        self.noted.iter().filter(move |(_, bits)| bits & mark as u8 != 0).map(|(cell, _)| cell)
    }

    /// Approximate memory, bytes.
    pub fn bytes(&self) -> usize {
        self.noted.bytes()
    }
}
