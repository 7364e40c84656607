//! Floor cleaned and dirt found, on the map.

use super::TiledLayer;
use robovac_core::{geometry::Point, grid::Cell};

/// What can be noted of a cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mark {
    /// The brush went over its middle.
    Cleaned = 1,
    /// The dirt sensor spoke while it did.
    Dirty = 2,
}

/// Notes on cells of the map, at the poses that the robot believed in when it made them.
#[derive(Debug, Clone)]
pub struct Marks {
    resolution: f64,
    noted: TiledLayer<u8>,
}

impl Marks {
    /// No notes; cells of `resolution` metres.
    pub fn new(resolution: f64) -> Self {
        Self { resolution, noted: TiledLayer::new() }
    }

    /// Side of its cells, m.
    pub fn resolution(&self) -> f64 {
        self.resolution
    }

    /// Notes something on all cells whose middles lie within `radius` metres of `point`.
    pub fn note(&mut self, point: Point, radius: f64, mark: Mark) {
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

    /// Whether that was noted of a cell.
    #[inline]
    pub fn has(&self, cell: Cell, mark: Mark) -> bool {
        self.noted.get(cell) & mark as u8 != 0
    }

    /// Cells of which that was noted.
    pub fn cells(&self, mark: Mark) -> impl Iterator<Item = Cell> {
        self.noted.iter().filter(move |(_, bits)| bits & mark as u8 != 0).map(|(cell, _)| cell)
    }

    /// Roughly the memory that they take, bytes.
    pub fn bytes(&self) -> usize {
        self.noted.bytes()
    }
}
