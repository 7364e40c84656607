//! An occupancy grid in log odds that grows with the robot's motion.

use super::TiledLayer;
use robovac_core::{
    floor_plan::FloorPlan,
    geometry::{Point, Pose},
    grid::{Cell, Grid, Occupancy},
};

/// Log odds are stored in hundredths.
const UNIT: f64 = 0.01;
/// Limit of log odds, so that cells observed a hundred times can still change (ours).
const MOST: i16 = 500;
/// Log odds above which a cell counts as occupied, and below which as free: probabilities of 0.65 and 0.25, as in
/// nav2's `map_saver`.
const OCCUPIED: i16 = 62;
const FREE: i16 = -110;

/// Log odds of occupation for every cell of the plane, 0 where unknown.
#[derive(Debug, Clone)]
pub struct OccupancyMap {
    resolution: f64,
    odds: TiledLayer<i16>,
}

impl OccupancyMap {
    /// An unknown map with cells of `resolution` metres, whose corners lie on multiples of it.
    pub fn new(resolution: f64) -> Self {
        Self { resolution, odds: TiledLayer::new() }
    }

    /// The map of `plan`, with certainty; its lower-left corner becomes the origin. Where the floor ends at the edge of the
    /// plan, or at cells of which nothing is known, there is a wall, as in the simulator.
    pub fn of(plan: &FloorPlan) -> Self {
        let mut map = Self::new(plan.resolution);
        for (cell, &occupancy) in plan.occupancy.iter() {
            let odds = match occupancy {
                Occupancy::Unknown => continue,
                Occupancy::Free => -MOST,
                Occupancy::Occupied => MOST,
            };
            map.odds.update(cell, |_| odds);
            if occupancy == Occupancy::Free {
                let is_end = |&near: &Cell| plan.occupancy.get(near).is_none_or(|&near| near == Occupancy::Unknown);
                for end in cell.block().filter(is_end) {
                    map.odds.update(end, |_| MOST);
                }
            }
        }
        map
    }

    /// Side of its cells, m.
    #[inline]
    pub fn resolution(&self) -> f64 {
        self.resolution
    }

    /// The cell that holds a point.
    #[inline]
    pub fn cell_at(&self, point: Point) -> Cell {
        Cell::at(point, self.resolution)
    }

    /// Centre of a cell, m.
    #[inline]
    pub fn centre(&self, cell: Cell) -> Point {
        cell.centre(self.resolution)
    }

    /// Log odds that a cell is occupied: 0 if unknown.
    #[inline]
    pub fn log_odds(&self, cell: Cell) -> f64 {
        f64::from(self.odds.get(cell)) * UNIT
    }

    /// Occupancy of a cell on the map.
    #[inline]
    pub fn occupancy(&self, cell: Cell) -> Occupancy {
        match self.odds.get(cell) {
            odds if odds > OCCUPIED => Occupancy::Occupied,
            odds if odds < FREE => Occupancy::Free,
            _ => Occupancy::Unknown,
        }
    }

    /// Adds evidence: log odds that the cell is occupied, given the observation alone.
    #[inline]
    pub fn add(&mut self, cell: Cell, log_odds: f64) {
        let change = (log_odds / UNIT) as i16;
        self.odds.update(cell, |odds| (odds + change).clamp(-MOST, MOST));
    }

    /// Lowest and highest cells of an area that contains all known cells.
    pub fn bounds(&self) -> Option<(Cell, Cell)> {
        self.odds.bounds()
    }

    /// Known cells with their log odds.
    pub fn iter(&self) -> impl Iterator<Item = (Cell, f64)> {
        self.odds.iter().map(|(cell, odds)| (cell, f64::from(odds) * UNIT))
    }

    /// The map as a floor plan, just large enough for the known cells; its `origin` is the position of its lower-left
    /// corner in the frame of the map. `None` if nothing is known.
    pub fn to_plan(&self, name: &str) -> Option<FloorPlan> {
        let known = || self.odds.iter().filter(|&(cell, _)| self.occupancy(cell) != Occupancy::Unknown);
        let low = known().map(|(cell, _)| cell).reduce(|a, b| Cell::new(a.x.min(b.x), a.y.min(b.y)))?;
        let high = known().map(|(cell, _)| cell).reduce(|a, b| Cell::new(a.x.max(b.x), a.y.max(b.y)))?;
        let (width, height) = ((high.x - low.x + 1) as usize, (high.y - low.y + 1) as usize);
        let mut occupancy = Grid::filled(width, height, Occupancy::Unknown);
        for (cell, _) in known() {
            let index = occupancy.index(Cell::new(cell.x - low.x, cell.y - low.y));
            occupancy.values_mut()[index] = self.occupancy(cell);
        }
        let corner = [low.x, low.y].map(|i| f64::from(i) * self.resolution);
        Some(FloorPlan {
            name: name.to_owned(),
            note: String::new(),
            resolution: self.resolution,
            occupancy,
            objects: Vec::new(),
            start: None,
            origin: Pose::new(corner[0], corner[1], 0.0),
        })
    }

    /// Approximate memory, bytes.
    pub fn bytes(&self) -> usize {
        self.odds.bytes()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::floor_plan::Sketch;

    /// In a real plan, walls were in a grey that counts as unknown: on the known map they were missing.
    #[test]
    fn floor_ends_at_unknown_cells_as_at_a_wall() {
        let mut plan = Sketch::open(0.6, 0.3, 0.1).finish("", "");
        for x in [4, 5] {
            for y in 0..3 {
                plan.occupancy[Cell::new(x, y)] = Occupancy::Unknown;
            }
        }
        let map = OccupancyMap::of(&plan);
        let at = |x: i32| map.iter().find(|(cell, _)| *cell == Cell::new(x, 1)).map(|(_, odds)| odds > 0.0);
        assert_eq!([3, 4, 5, -1].map(at), [Some(false), Some(true), None, Some(true)]);
    }
}
