//! Ground truth in the cells of the map: for quality figures and display, never for the robot.

use robovac_core::{
    coverage::ReachableFloor,
    grid::{Cell, Grid, Occupancy},
};
use robovac_sim::mapping::{self, MapQuality, OccupancyMap};

/// Correctness of a map in one cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CellVerdict {
    /// An obstacle that exists, to within one cell.
    Right,
    /// An obstacle that doesn't exist.
    Phantom,
    /// Floor marked where an obstacle is.
    Missed,
    /// Part of the boundary that isn't on the map yet.
    Unseen,
}

/// The true room in cells of a map in the room's frame, surrounded by one cell of wall.
#[derive(Debug, Clone)]
pub struct RoomTruth {
    resolution: f64,
    /// Cells whose centre is inside an obstacle.
    solid: Grid<bool>,
    /// Cells whose centre the body can cover.
    covered: Grid<bool>,
    /// Obstacles beside those, which a bumper can find.
    boundary: Grid<bool>,
    /// The same in the form for measuring quality.
    measure: mapping::MapTruth,
}

impl RoomTruth {
    /// The truth of `floor` in cells of `resolution` metres, for a round body of `radius` metres.
    pub fn new(floor: &ReachableFloor, radius: f64, resolution: f64) -> Self {
        let size = |fine: usize| (fine as f64 * floor.resolution / resolution).ceil().max(1.0) as usize + 2;
        let (width, height) = (size(floor.floor.width()), size(floor.floor.height()));
        let mut solid = Grid::filled(width, height, false);
        let mut covered = solid.clone();
        let reach = (radius / resolution).ceil() as i32;
        for index in 0..solid.len() {
            let at = solid.cell(index);
            let middle = outer(at).centre(resolution);
            solid.values_mut()[index] = !floor.walls.has_room(middle, 0.5 * resolution - 1e-6);
            if floor.standing.is_set(floor.cell_at(middle)) {
                for (dx, dy) in square(reach) {
                    let near = Cell::new(at.x + dx, at.y + dy);
                    let distance = f64::from(dx * dx + dy * dy).sqrt() * resolution;
                    if distance <= radius && covered.contains(near) {
                        covered[near] = true;
                    }
                }
            }
        }
        let mut boundary = Grid::filled(width, height, false);
        for index in 0..solid.len() {
            let at = solid.cell(index);
            let touches = || around(at).any(|near| covered.is_set(near) && !solid.is_set(near));
            boundary.values_mut()[index] = solid[at] && touches();
        }
        Self { resolution, solid, covered, boundary, measure: mapping::MapTruth::of(floor, resolution) }
    }

    /// Quality of a map.
    pub fn quality(&self, map: &OccupancyMap) -> MapQuality {
        self.measure.quality(map)
    }

    /// Side of its cells, m.
    pub fn resolution(&self) -> f64 {
        self.resolution
    }

    /// Lowest and highest cell of the room, the wall around it included.
    pub fn bounds(&self) -> (Cell, Cell) {
        let (width, height) = (self.solid.width() as i32, self.solid.height() as i32);
        (Cell::new(-1, -1), Cell::new(width - 2, height - 2))
    }

    /// Whether an obstacle is there; everything outside is one.
    pub fn is_solid(&self, cell: Cell) -> bool {
        self.solid.get(inner(cell)).copied().unwrap_or(true)
    }

    /// Cells whose centre the body can cover.
    pub fn covered(&self) -> impl Iterator<Item = Cell> {
        self.covered.iter().filter(|(_, is)| **is).map(|(at, _)| outer(at))
    }

    /// Obstacles that a bumper can find.
    pub fn boundary(&self) -> impl Iterator<Item = Cell> {
        self.boundary.iter().filter(|(_, is)| **is).map(|(at, _)| outer(at))
    }

    /// Correctness of the map in a cell; `None` for floor that is right, and for cells that can't be known.
    pub fn verdict(&self, map: &OccupancyMap, cell: Cell) -> Option<CellVerdict> {
        match map.occupancy(cell) {
            Occupancy::Occupied if around(cell).any(|near| self.is_solid(near)) => Some(CellVerdict::Right),
            Occupancy::Occupied => Some(CellVerdict::Phantom),
            Occupancy::Free if around(cell).all(|near| self.is_solid(near)) => Some(CellVerdict::Missed),
            _ if !self.boundary.is_set(inner(cell)) => None,
            _ => {
                let is_known = around(cell).any(|near| map.occupancy(near) == Occupancy::Occupied);
                (!is_known).then_some(CellVerdict::Unseen)
            }
        }
    }
}

/// A map cell in the coordinates of the grids.
fn inner(cell: Cell) -> Cell {
    Cell::new(cell.x + 1, cell.y + 1)
}

/// A cell of the grids in the coordinates of the map.
fn outer(at: Cell) -> Cell {
    Cell::new(at.x - 1, at.y - 1)
}

/// A cell and its eight neighbours.
pub(super) fn around(cell: Cell) -> impl Iterator<Item = Cell> {
    square(1).map(move |(dx, dy)| Cell::new(cell.x + dx, cell.y + dy))
}

fn square(reach: i32) -> impl Iterator<Item = (i32, i32)> {
    (-reach..=reach).flat_map(move |dy| (-reach..=reach).map(move |dx| (dx, dy)))
}
