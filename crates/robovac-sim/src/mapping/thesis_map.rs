//! The thesis' grid in the frame of a map, to be drawn, measured and saved beside an [`OccupancyMap`].

use super::{
    CellStatus, OccupancyMap, ThesisGrid,
    mapper::RESOLUTION,
    thesis_grid::{RESOLUTION as SIDE, SIZE},
};
use robovac_core::{
    floor_plan::FloorPlan,
    geometry::{Point, Pose},
    grid::{Cell, Grid, Occupancy},
    math::FRAC_PI_2,
    robot::{RobotModel, SensorReadings},
};

/// Log odds that make a cell certain, whatever it was before.
const CERTAIN: f64 = 10.0;
/// Cells of the map around the centre of one of the thesis' that it can cover.
const REACH: i32 = 2;

/// A [`ThesisGrid`] of a robot that starts anywhere, and the same in cells of a map: each of them has the status of the
/// thesis' cell at its centre.
#[derive(Debug, Clone)]
pub struct ThesisMap {
    grid: ThesisGrid,
    start: Pose,
    map: OccupancyMap,
}

impl ThesisMap {
    /// All unknown; the robot is at `start` in the frame of the map.
    pub fn new(robot: &RobotModel, start: Pose) -> Self {
        Self { grid: ThesisGrid::new(robot), start, map: OccupancyMap::new(RESOLUTION) }
    }

    /// Takes the next reading.
    pub fn update(&mut self, sensed: &SensorReadings) {
        for cell in self.grid.update(sensed) {
            self.draw(cell);
        }
    }

    /// The grid, as printed.
    pub fn grid(&self) -> &ThesisGrid {
        &self.grid
    }

    /// The grid in cells of [`RESOLUTION`].
    pub fn map(&self) -> &OccupancyMap {
        &self.map
    }

    /// The pose by odometry, in the frame of the map.
    pub fn pose(&self) -> Pose {
        let pose = self.grid.pose();
        let at = self.start.to_world(pose.position());
        Pose::new(at.x, at.y, self.start.heading + pose.heading)
    }

    /// The grid in its own cells as a floor plan, turned by the quarter turns that bring its rows nearest to those of the
    /// map; its `origin` is the position of its lower-left corner in the frame of the map, with the rest of the turn.
    /// `None` if nothing is known.
    pub fn to_plan(&self, name: &str) -> Option<FloorPlan> {
        let occupancy = self.grid.to_occupancy();
        occupancy.values().iter().find(|&&cell| cell != Occupancy::Unknown)?;
        let turns = (self.start.heading / FRAC_PI_2).round();
        let quarters = turns as i64;
        let corners = [(0, 0), (0, SIZE), (SIZE, SIZE), (SIZE, 0)];
        let (x, y) = corners[quarters.rem_euclid(4) as usize];
        let corner = self.start.to_world(self.at(x as f64, y as f64));
        Some(FloorPlan {
            name: name.to_owned(),
            note: String::new(),
            resolution: SIDE,
            occupancy: (0..quarters.rem_euclid(4)).fold(occupancy, |grid, _| quarter_turn(&grid)),
            objects: Vec::new(),
            start: None,
            origin: Pose::new(corner.x, corner.y, self.start.heading - turns * FRAC_PI_2),
        })
    }

    /// Approximate memory, bytes.
    pub fn bytes(&self) -> usize {
        (SIZE * SIZE) as usize + self.map.bytes()
    }

    /// A point of the grid, in cells from its lower-left corner, in the frame of the robot's start.
    fn at(&self, x: f64, y: f64) -> Point {
        let origin = self.grid.origin();
        Point::new(origin.x + SIDE * x, origin.y + SIDE * y)
    }

    /// The thesis' cell at a point of the map.
    fn cell_at(&self, point: Point) -> Cell {
        let (offset, ahead) = (point - self.start.position(), self.start.direction());
        let local = Point::new(ahead.dot(&offset), ahead.perp(&offset));
        Cell::at(Point::from(local - self.grid.origin().position()), SIDE)
    }

    /// Draws a cell of the grid on the map.
    fn draw(&mut self, cell: Cell) {
        let centre = self.start.to_world(self.at(f64::from(cell.x) + 0.5, f64::from(cell.y) + 0.5));
        let odds = if self.grid.status(cell) == Some(CellStatus::Occupied) { CERTAIN } else { -CERTAIN };
        let middle = self.map.cell_at(centre);
        for y in middle.y - REACH..=middle.y + REACH {
            for x in middle.x - REACH..=middle.x + REACH {
                let at = Cell::new(x, y);
                if self.cell_at(self.map.centre(at)) == cell {
                    self.map.add(at, odds);
                }
            }
        }
    }
}

/// The grid turned by a quarter turn counter-clockwise.
fn quarter_turn(grid: &Grid<Occupancy>) -> Grid<Occupancy> {
    let mut turned = Grid::filled(grid.height(), grid.width(), Occupancy::Unknown);
    for (cell, &value) in grid.iter() {
        turned[Cell::new(grid.height() as i32 - 1 - cell.y, cell.x)] = value;
    }
    turned
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::robot::model;

    /// A robot that has driven 66 cm ahead to a wall.
    fn at_a_wall(start: Pose) -> ThesisMap {
        let mut thesis = ThesisMap::new(model("roomba600").unwrap(), start);
        let ahead = |counts| SensorReadings { left_counts: counts, right_counts: counts, ..SensorReadings::default() };
        (0..1500_u16).step_by(10).for_each(|counts| thesis.update(&ahead(counts)));
        thesis.update(&SensorReadings { light_bumper: [false, false, true, true, false, false], ..ahead(1490) });
        thesis
    }

    #[test]
    fn the_map_shows_the_grid_wherever_the_robot_starts() {
        for degrees in [0.0_f64, 90.0, -90.0, 180.0, 17.0] {
            let start = Pose::new(3.35, 4.4, degrees.to_radians());
            let thesis = at_a_wall(start);
            for (cell, status) in
                [((49, 50), Occupancy::Free), ((57, 50), Occupancy::Occupied), ((60, 50), Occupancy::Unknown)]
            {
                let local = thesis.at(f64::from(cell.0) + 0.5, f64::from(cell.1) + 0.5);
                // Off the centre, where cells of the map meet.
                let point = start.to_world(Point::new(local.x + 0.012, local.y + 0.012));
                assert_eq!(thesis.map().occupancy(thesis.map().cell_at(point)), status, "{degrees}: {cell:?}");
            }
            let known =
                |map: &OccupancyMap| map.iter().filter(|&(cell, _)| map.occupancy(cell) != Occupancy::Unknown).count();
            let of_grid =
                thesis.grid().to_occupancy().values().iter().filter(|&&cell| cell != Occupancy::Unknown).count();
            let share = known(thesis.map()) as f64 / of_grid as f64;
            assert!((share - 4.0).abs() < 0.5, "{degrees}: {share} cells for each of the thesis'");
            let pose = thesis.pose();
            assert!((pose.position() - start.to_world(Point::new(0.6624, 0.0))).norm() < 0.001, "{pose}");
        }
    }

    #[test]
    fn plans_keep_every_cell_in_its_place() {
        for degrees in [0.0_f64, 90.0, -90.0, 180.0, 17.0, 260.0] {
            let start = Pose::new(3.35, 4.4, degrees.to_radians());
            let thesis = at_a_wall(start);
            let plan = thesis.to_plan("as mapped").unwrap();
            assert!(plan.origin.heading.abs() <= 0.5 * FRAC_PI_2 + 1e-9, "{degrees}");
            assert_eq!((plan.occupancy.width(), plan.occupancy.height(), plan.resolution), (100, 100, 0.1));
            for (cell, &value) in plan.occupancy.iter() {
                let point = plan.origin.to_world(cell.centre(SIDE));
                let status = thesis.grid().to_occupancy()[thesis.cell_at(point)];
                assert_eq!(value, status, "{degrees}: {cell:?}");
            }
        }
        assert!(ThesisMap::new(model("roomba600").unwrap(), Pose::new(0.0, 0.0, 0.0)).to_plan("empty").is_none());
    }
}
