//! Map quality against ground truth, defined once for the page, the command line and the tests.
//!
//! The truth is a room's floor as a robot reaches it, in cells of the map's size: a cell is *occupied* if there is an
//! obstacle at any of nine sample points, and *free* otherwise; everything outside the plan is occupied. The *reachable
//! floor* are the free cells that the body covers from some standing place, the *reachable boundary* the occupied ones
//! that it touches from there.

use super::OccupancyMap;
use robovac_core::{
    coverage::ReachableFloor,
    geometry::{Point, Vector},
    grid::{Cell, Grid, Occupancy, clearance},
};

/// Largest distance for errors of the boundary, cells.
const FARTHEST: f32 = 20.0;

/// The ground truth of a map.
#[derive(Debug, Clone)]
pub struct MapTruth {
    resolution: f64,
    /// Margin around the plan, for obstacles at its edge, cells.
    margin: i32,
    /// Cells with a free one, and with an occupied one, within one cell.
    near_free: Grid<bool>,
    near_occupied: Grid<bool>,
    floor: Grid<bool>,
    floor_cells: usize,
    boundary: Vec<Cell>,
    /// Distance to the nearest edge of anything, cells.
    off_boundary: Grid<f32>,
}

/// Quality of a map. Shares are from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MapQuality {
    /// Share of the known cells, free or occupied, that are right within one cell: the truth has a cell of that kind there
    /// or among the eight around. 1 for an empty map.
    pub right: f64,
    /// Share of the reachable floor that is known on the map.
    pub known: f64,
    /// Share of the reachable boundary with an occupied cell of the map within one cell.
    pub boundary: f64,
    /// Mean distance from the map's occupied cells to the nearest edge of anything, m: 0 for the cell itself. `None` if the
    /// map has none.
    pub boundary_error_m: Option<f64>,
    /// Number of known cells.
    pub cells: usize,
}

impl MapTruth {
    /// The room of `floor` in cells of `resolution` metres; the map's frame must be the plan's.
    pub fn of(floor: &ReachableFloor, resolution: f64) -> Self {
        let radius = floor.walls.body_radius;
        let margin = ((radius + 0.25) / resolution).ceil() as i32;
        let fine = &floor.standing;
        let side = |cells: usize| (cells as f64 * floor.resolution / resolution).ceil() as usize + 2 * margin as usize;
        let (width, height) = (side(fine.width()), side(fine.height()));
        let of_cells = |is: &dyn Fn(Point) -> bool| {
            let mut grid = Grid::filled(width, height, false);
            for y in 0..height as i32 {
                for x in 0..width as i32 {
                    let centre = Cell::new(x - margin, y - margin).centre(resolution);
                    let step = resolution / 3.0;
                    let mut places = Cell::new(0, 0).block();
                    grid[Cell::new(x, y)] =
                        places.any(|at| is(centre + Vector::new(f64::from(at.x) * step, f64::from(at.y) * step)));
                }
            }
            grid
        };
        let occupied = of_cells(&|point| floor.walls.contains(point));
        let standing = of_cells(&|point| fine.is_set(Cell::at(point, floor.resolution)));
        Self::new(&occupied, &standing, radius / resolution, resolution, margin)
    }

    /// From the occupied cells and the standing places; `radius` in cells.
    fn new(occupied: &Grid<bool>, standing: &Grid<bool>, radius: f64, resolution: f64, margin: i32) -> Self {
        let away = clearance(standing, radius as f32 + 2.0);
        // From centre to centre, along an axis.
        let distance =
            |cell: Cell| away.get(cell).map_or(f64::MAX, |&d| if d > 0.0 { f64::from(d) + 0.5 } else { 0.0 });
        let near = |wanted: bool| {
            let mut grid = occupied.clone();
            for index in 0..grid.len() {
                let cell = grid.cell(index);
                let mut around = cell.block();
                grid.values_mut()[index] = around.any(|at| occupied.get(at).copied().unwrap_or(true) == wanted);
            }
            grid
        };
        let (near_free, near_occupied) = (near(false), near(true));
        let (mut floor, mut edges) = (occupied.clone(), occupied.clone());
        let mut boundary = Vec::new();
        for index in 0..occupied.len() {
            let cell = occupied.cell(index);
            let is_occupied = occupied[cell];
            floor.values_mut()[index] = !is_occupied && distance(cell) <= radius;
            edges.values_mut()[index] = is_occupied && near_free[cell];
            if is_occupied && near_free[cell] && distance(cell) <= radius + 1.0 {
                boundary.push(cell);
            }
        }
        Self {
            resolution,
            margin,
            near_free,
            near_occupied,
            floor_cells: floor.count(),
            floor,
            boundary,
            off_boundary: clearance(&edges, FARTHEST),
        }
    }

    /// Quality of `map`, whose cells must be as large as those of the truth.
    pub fn quality(&self, map: &OccupancyMap) -> MapQuality {
        let shift = |cell: Cell| Cell::new(cell.x + self.margin, cell.y + self.margin);
        let (mut cells, mut right, mut known, mut occupied, mut off) = (0, 0, 0, 0_usize, 0.0);
        for (at, _) in map.iter() {
            let cell = shift(at);
            let says = map.occupancy(at);
            // Everything outside the plan is occupied.
            let (fits, is_floor) = match says {
                Occupancy::Unknown => continue,
                Occupancy::Free => (self.near_free.is_set(cell), self.floor.is_set(cell)),
                Occupancy::Occupied => {
                    occupied += 1;
                    let distance = f64::from(self.off_boundary.get(cell).copied().unwrap_or(FARTHEST));
                    off += if distance > 0.0 { (distance + 0.5) * self.resolution } else { 0.0 };
                    (self.near_occupied.get(cell).copied().unwrap_or(true), self.floor.is_set(cell))
                }
            };
            cells += 1;
            right += usize::from(fits);
            known += usize::from(is_floor);
        }
        let back = |cell: Cell| Cell::new(cell.x - self.margin, cell.y - self.margin);
        let is_mapped = |cell: &&Cell| back(**cell).block().any(|at| map.occupancy(at) == Occupancy::Occupied);
        let mapped = self.boundary.iter().filter(is_mapped).count();
        let share = |part: usize, all: usize| if all == 0 { 1.0 } else { part as f64 / all as f64 };
        MapQuality {
            right: share(right, cells),
            known: share(known, self.floor_cells),
            boundary: share(mapped, self.boundary.len()),
            boundary_error_m: (occupied > 0).then(|| off / occupied as f64),
            cells,
        }
    }

    /// Side of its cells, m.
    pub fn resolution(&self) -> f64 {
        self.resolution
    }

    /// Cells of the reachable boundary, as cells of the map.
    pub fn boundary(&self) -> impl Iterator<Item = Cell> {
        self.boundary.iter().map(|cell| Cell::new(cell.x - self.margin, cell.y - self.margin))
    }

    /// The true state of a reachable cell: `None` if it is neither reachable floor nor boundary.
    pub fn at(&self, cell: Cell) -> Option<Occupancy> {
        let cell = Cell::new(cell.x + self.margin, cell.y + self.margin);
        if self.floor.is_set(cell) {
            return Some(Occupancy::Free);
        }
        (self.off_boundary.get(cell) == Some(&0.0)).then_some(Occupancy::Occupied)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::grid::from_picture;

    /// A room of four by three cells whose whole floor a robot of one cell reaches.
    fn truth() -> MapTruth {
        let occupied = from_picture("######\n#....#\n#....#\n#....#\n######", |glyph| glyph == '#').unwrap();
        let standing = occupied.map(|occupied| !occupied);
        MapTruth::new(&occupied, &standing, 0.6, 0.05, 0)
    }

    fn map(picture: &str) -> OccupancyMap {
        let grid = from_picture(picture, |glyph| glyph).unwrap();
        let mut map = OccupancyMap::new(0.05);
        for (cell, &glyph) in grid.iter() {
            match glyph {
                '#' => map.add(cell, 3.0),
                '.' => map.add(cell, -3.0),
                _ => {}
            }
        }
        map
    }

    #[test]
    fn the_truth_itself_is_perfect() {
        let quality = truth().quality(&map("######\n#....#\n#....#\n#....#\n######"));
        let expected = MapQuality { right: 1.0, known: 1.0, boundary: 1.0, boundary_error_m: Some(0.0), cells: 30 };
        assert_eq!(quality, expected);
    }

    #[test]
    fn what_is_unknown_is_missing_and_not_wrong() {
        let quality = truth().quality(&map("??????\n?#..??\n?#..??\n??????\n??????"));
        assert_eq!((quality.right, quality.cells), (1.0, 6));
        assert!((quality.known - 6.0 / 12.0).abs() < 1e-12, "{quality:?}");
        let empty = truth().quality(&OccupancyMap::new(0.05));
        assert_eq!((empty.right, empty.known, empty.boundary, empty.boundary_error_m), (1.0, 0.0, 0.0, None));
    }

    #[test]
    fn one_cell_off_is_right_and_two_are_not() {
        // The left wall is shown one cell, then two cells too far to the right.
        let one = truth().quality(&map("??????\n?#????\n?#????\n?#????\n??????"));
        assert!(one.right == 1.0 && (one.boundary_error_m.unwrap() - 0.05).abs() < 1e-9, "{one:?}");
        let two = truth().quality(&map("??????\n??#???\n??#???\n??#???\n??????"));
        assert!((two.right - 2.0 / 3.0).abs() < 1e-12, "above and below, the other walls are near: {two:?}");
        assert!(two.boundary < one.boundary);
        // Free floor behind the wall: what lies outside the plan is occupied.
        let mut outside = OccupancyMap::new(0.05);
        outside.add(Cell::new(20, 2), -3.0);
        outside.add(Cell::new(-3, 2), 3.0);
        assert_eq!(truth().quality(&outside).right, 0.5);
    }
}
