//! Coverage of a sweep.

use robovac_core::{
    cspace::{Outline, Swath},
    geometry::Point,
    grid::Grid,
};

/// Reachable floor, and its swept part: see [`super::Sweep::coverage`].
pub(super) struct Cover {
    floor: Swath,
    swept: Swath,
    /// Least gain for which a stroke is driven, cells.
    pub least_gain: f64,
}

impl Cover {
    /// The floor swept along `path`, with the body at heading 0, on the cells of the obstacle map.
    pub fn new(outline: &Outline, reached: &Grid<bool>, cell: f64, path: &[Point]) -> Self {
        let nothing = Swath::new(outline, reached.width(), reached.height(), cell);
        let (mut floor, mut swept) = (nothing.clone(), nothing);
        floor.sweep_cells(reached);
        if let &[only] = path {
            swept.sweep(only, only);
        }
        path.windows(2).for_each(|piece| swept.sweep(piece[0], piece[1]));
        // Contacts lie up to a cell beyond the centres of FREE cells.
        floor.add(&swept);
        let (low, high) = outline.bounds();
        let least_gain = 0.01 * (high.x - low.x) * (high.y - low.y) / (cell * cell);
        Self { floor, swept, least_gain }
    }

    /// Number of cells that a stroke would add.
    pub fn gain(&self, from: Point, to: Point) -> f64 {
        self.swept.gain(&self.floor, from, to) as f64
    }

    /// Sweeps along a way.
    pub fn sweep(&mut self, way: &[Point]) {
        for piece in way.windows(2) {
            self.swept.sweep(piece[0], piece[1]);
            self.floor.sweep(piece[0], piece[1]);
        }
    }

    /// Swept share, 0 to 1.
    pub fn share(&self) -> f64 {
        if self.floor.count() == 0 { 0.0 } else { self.swept.count() as f64 / self.floor.count() as f64 }
    }
}
