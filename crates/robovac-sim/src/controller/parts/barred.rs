//! Forbidden areas that the map doesn't show as occupied.

use crate::mapping::TiledLayer;
use robovac_core::{
    geometry::{Point, Pose},
    grid::Cell,
    math,
};

/// Distance from the body and radius of a barred disc, m: at an edge, and at an obstacle.
const EDGE: (f64, f64) = (0.05, 0.1);
const MET: (f64, f64) = (0.03, 0.05);
/// Values of barred cells: while there are other goals, and for ever.
const FOR_NOW: u8 = 1;
const FOR_EVER: u8 = 2;

/// Barred cells of a map.
#[derive(Debug, Clone)]
pub(in crate::controller) struct Barred {
    /// Side of the cells, m.
    side: f64,
    cells: TiledLayer<u8>,
}

impl Barred {
    /// No barred cells, with cells of `side` metres.
    pub(in crate::controller) fn new(side: f64) -> Self {
        Self { side, cells: TiledLayer::new() }
    }

    /// Whether a cell is barred.
    pub(in crate::controller) fn has(&self, cell: Cell) -> bool {
        self.cells.get(cell) > 0
    }

    /// Bars an edge or a virtual wall ahead of a body of that radius, m.
    pub(in crate::controller) fn edge(&mut self, pose: Pose, body: f64) {
        self.bar(pose.to_world(Point::new(body + EDGE.0, 0.0)), EDGE.1, FOR_EVER);
    }

    /// Bars an unexpected obstacle at an angle to the left of straight ahead, rad.
    pub(in crate::controller) fn met(&mut self, pose: Pose, body: f64, aside: f64) {
        let (sin, cos) = math::sin_cos(aside);
        self.bar(pose.to_world(Point::new(cos, sin) * (body + MET.0)), MET.1, FOR_NOW);
    }

    fn bar(&mut self, middle: Point, radius: f64, how: u8) {
        let (cell, reach) = (Cell::at(middle, self.side), (radius / self.side).ceil() as i32);
        for y in cell.y - reach..=cell.y + reach {
            for x in cell.x - reach..=cell.x + reach {
                let cell = Cell::new(x, y);
                if (cell.centre(self.side) - middle).norm() <= radius {
                    self.cells.update(cell, |before| before.max(how));
                }
            }
        }
    }

    /// Unbars obstacles, which can have gone.
    pub(in crate::controller) fn forget(&mut self) {
        let met: Vec<Cell> = self.cells.iter().filter(|(_, how)| *how == FOR_NOW).map(|(cell, _)| cell).collect();
        for cell in met {
            self.cells.update(cell, |_| 0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_met_is_forgotten_but_an_edge_is_not() {
        let mut barred = Barred::new(0.05);
        let at = |x, y| Cell::at(Point::new(x, y), 0.05);
        barred.edge(Pose::new(1.0, 1.0, 0.0), 0.17);
        barred.met(Pose::new(1.0, 1.0, 0.0), 0.17, math::FRAC_PI_2);
        assert!(barred.has(at(1.22, 1.02)) && barred.has(at(1.02, 1.21)) && !barred.has(at(1.02, 0.79)));
        barred.forget();
        assert!(barred.has(at(1.22, 1.02)) && !barred.has(at(1.02, 1.21)));
    }
}
