//! The detectable boundary: faces of walls and furniture within reach of the sensors, and how many have been detected.
//!
//! Like coverage, this is measured against the ground truth, not the robot's estimate: it shows how fast an exploration
//! finds what there is to map, independently of the quality of the map.

use super::{ReachableFloor, Walls};
use crate::{
    geometry::{Point, Pose, Vector},
    grid::{Cell, Grid},
    math,
    robot::{LightBumper, RobotModel, SensorReadings},
};
use std::sync::Arc;

/// Reach of a light bumper's beam from the body's edge, m (ours): a wall straight ahead is reported from 13 cm on,
/// slanted or dark surfaces from less. Deep corners are farther away.
const LIGHT_REACH: f64 = 0.05;
/// Distance of the body from a wall that counts as a contact, m.
const TOUCH: f64 = 0.01;
/// Side of its cells, m: that of the maps that robots make here, so that a thin leg is one cell or two.
const SIDE: f64 = 0.05;
/// Number of directions sampled at each place.
const DIRECTIONS: u32 = 48;
/// Distance behind a surface at which its cell is looked up, m.
const BEHIND: f64 = 0.001;

/// Cells of 5 cm with something that a robot's sensors can detect: the face of a wall or of furniture, touched or lit
/// from a place where the robot can stand.
#[derive(Debug)]
pub struct Boundary {
    floor: Arc<ReachableFloor>,
    light: Option<LightBumper>,
    cells: Grid<bool>,
    count: usize,
}

/// The detected part of a boundary.
#[derive(Debug, Clone)]
pub struct BoundaryTracker {
    boundary: Arc<Boundary>,
    met: Grid<bool>,
    count: usize,
}

impl Boundary {
    /// The boundary that `robot` can detect on `floor`: from the centre of every fine cell where it can stand, the
    /// nearest point of a wall that it touches within a cell and a half, and the ends of beams in 48 directions within
    /// 5 cm of its edge.
    pub fn new(floor: &Arc<ReachableFloor>, robot: &RobotModel) -> Self {
        let walls = &floor.walls;
        let light = robot.sensors.light_bumper;
        let near = walls.body_radius + 1.5 * walls.resolution;
        let cells = |fine: usize| (fine as f64 * floor.resolution / SIDE).ceil() as usize + 2;
        let mut cells = Grid::filled(cells(floor.standing.width()), cells(floor.standing.height()), false);
        let directions: Vec<Vector> = (0..DIRECTIONS)
            .map(|i| math::TAU * f64::from(i) / f64::from(DIRECTIONS))
            .map(|angle| Vector::new(math::cos(angle), math::sin(angle)))
            .collect();
        for (cell, _) in floor.standing.iter().filter(|(_, stands)| **stands) {
            let place = cell.centre(floor.resolution);
            let mut meet = |cell: Option<Cell>| {
                if let Some(cell) = cell.filter(|&cell| cells.contains(cell)) {
                    cells[cell] = true;
                }
            };
            meet(touched(walls, place, near));
            if light.is_some() && !walls.are_far_from(place, walls.body_radius + LIGHT_REACH) {
                for &direction in &directions {
                    meet(lit(walls, place, direction, LIGHT_REACH));
                }
            }
        }
        let count = cells.values().iter().filter(|met| **met).count();
        Self { floor: Arc::clone(floor), light, cells, count }
    }

    /// The cells, from the floor's lower left corner, with one more cell all around, as the outside is wall.
    pub fn cells(&self) -> &Grid<bool> {
        &self.cells
    }

    /// Number of boundary cells.
    pub fn count(&self) -> usize {
        self.count
    }
}

impl BoundaryTracker {
    /// Nothing detected.
    pub fn new(boundary: &Arc<Boundary>) -> Self {
        let met = Grid::filled(boundary.cells.width(), boundary.cells.height(), false);
        Self { boundary: Arc::clone(boundary), met, count: 0 }
    }

    /// Records the reading of a robot whose true pose is `pose`: a contact detects the nearest wall, a bit of the light
    /// bumper the end of its beam.
    pub fn update(&mut self, pose: Pose, sensed: &SensorReadings) {
        let boundary = Arc::clone(&self.boundary);
        let walls = &boundary.floor.walls;
        if sensed.bumped() {
            self.meet(touched(walls, pose.position(), walls.body_radius + TOUCH));
        }
        let Some(light) = boundary.light.filter(|_| sensed.light_bumper.contains(&true)) else { return };
        for (angle, _) in light.angles.iter().zip(sensed.light_bumper).filter(|(_, is_near)| *is_near) {
            let (sin, cos) = math::sin_cos(pose.heading + angle);
            self.meet(lit(walls, pose.position(), Vector::new(cos, sin), light.range));
        }
    }

    fn meet(&mut self, cell: Option<Cell>) {
        let Some(cell) = cell.filter(|&cell| self.boundary.cells.is_set(cell)) else { return };
        if !self.met[cell] {
            self.met[cell] = true;
            self.count += 1;
        }
    }

    /// Detected share of the boundary, 0 to 1; 1 if there is none.
    pub fn share(&self) -> f64 {
        if self.boundary.count == 0 { 1.0 } else { self.count as f64 / self.boundary.count as f64 }
    }

    /// The detected cells, in the grid of [`Boundary::cells`].
    pub fn met(&self) -> &Grid<bool> {
        &self.met
    }
}

/// The cell of the nearest wall within `reach` metres of a body's middle.
fn touched(walls: &Walls, place: Point, reach: f64) -> Option<Cell> {
    let (wall, distance) = walls.nearest(place, reach)?;
    let outward = (wall - place) / distance.max(BEHIND);
    Some(cell_at(wall + outward * BEHIND))
}

/// The cell that a beam hits within `reach` metres of a body's edge.
fn lit(walls: &Walls, place: Point, direction: Vector, reach: f64) -> Option<Cell> {
    let from = place + direction * walls.body_radius;
    let hit = walls.ray(from, direction, reach)?;
    Some(cell_at(from + direction * (hit.distance + BEHIND)))
}

/// The cell at a point, in a grid with one more cell all around.
fn cell_at(point: Point) -> Cell {
    let Cell { x, y } = Cell::at(point, SIDE);
    Cell::new(x + 1, y + 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{floor_plan::Sketch, robot::model};

    fn boundary(robot: &str) -> Arc<Boundary> {
        let plan = Sketch::open(2.0, 1.5, 0.05).disc(1.0, 0.75, 0.01).start(0.4, 0.4, 0.0).finish("", "");
        let robot = model(robot).unwrap();
        let floor = Arc::new(ReachableFloor::new(&plan, robot, None).unwrap());
        Arc::new(Boundary::new(&floor, robot))
    }

    #[test]
    fn light_sees_walls_nearly_up_to_the_corners_and_a_bumper_what_the_body_touches() {
        let faces = 2 * (40 + 30);
        let by_light = boundary("roomba600");
        // The leg is 2 cm thick and stands where four cells meet.
        assert!((faces - 12..=faces + 4).contains(&by_light.count()), "{}", by_light.count());
        let by_touch = boundary("dvr1");
        let hidden = 8.0 * 0.145 / SIDE;
        let expected = faces as f64 - hidden;
        assert!((by_touch.count() as f64 - expected).abs() < 8.0, "{} of about {expected}", by_touch.count());
    }

    #[test]
    fn what_is_met_counts_once_and_only_where_there_is_something() {
        let mut tracker = BoundaryTracker::new(&boundary("roomba600"));
        let pressed = SensorReadings { bump_left: true, ..SensorReadings::default() };
        tracker.update(Pose::new(0.5, 0.4, 0.0), &pressed);
        assert_eq!(tracker.share(), 0.0, "a bumper that is pressed in the open");
        let pose = Pose::new(0.5, 0.178, 0.0);
        for _ in 0..3 {
            tracker.update(pose, &pressed);
        }
        let one = tracker.share();
        assert!(one > 0.0 && tracker.met().values().iter().filter(|met| **met).count() == 1);
        let mut sensed = SensorReadings::default();
        sensed.light_bumper[5] = true;
        tracker.update(pose, &sensed);
        assert!((tracker.share() - 2.0 * one).abs() < 1e-12);
    }
}
