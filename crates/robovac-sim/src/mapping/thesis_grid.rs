//! The occupancy grid of Krapinec 2025 (004, sections 3.3.1 and 7.1), as printed. [`ThesisMap`](super::ThesisMap) lays it
//! over an [`OccupancyMap`](super::OccupancyMap) for comparison.
//!
//! 100 x 100 cells of 10 cm, the robot in the middle at the start. A bit of the light bumper marks one cell beside the robot
//! as occupied, whatever it was; a movement forward marks the robot's own four cells as empty. The cells are looked up with
//! the heading rounded to quarter turns, by thresholds on `orientation.z`.
//!
//! # Where the print errs, and is kept
//!
//! - *Values*: UNKNOWN 0, EMPTY 127, OCCUPIED 100. In a ROS `OccupancyGrid` 0 is free, 100 occupied, -1 unknown, and 127 has
//!   no meaning.
//! - *`orientation.z`* is taken for the angle over 180 degrees ("0.5 means that the robot is rotated for 90 degrees"). It is
//!   part of a quaternion, the sine of half the angle: 90 degrees give 0.71, and the thresholds 0.2 and 0.8 are 23 and 106
//!   degrees.
//! - *Clockwise* is said of positive values; by ROS' convention (REP 103) they are counter-clockwise.
//! - *Two rules for 0.2 < z <= 0.8*: the second one turns by a quarter clockwise, and the third, `-0.8 > z or z > 0.2`,
//!   by a half more; it should test for `z > 0.8`. By coincidence the sum is a quarter counter-clockwise, which is
//!   right. At exactly 0.2 only the second one holds. A robot that looks to its right gets a quarter counter-clockwise
//!   too, which is wrong: its obstacles are marked on the other side.
//! - *The middle of the robot* is taken to be half a cell off, at -0.5.
//! - *`grid_index`* cuts towards zero and the range of the index alone is checked: what lies beyond the right edge comes in
//!   again at the left, a row higher, and a coordinate between -1 and 0 counts as 0.
//! - "A list with 1000 elements" has 10 000.
//! - *Contacts* mark nothing.

use robovac_core::{
    geometry::Pose,
    grid::{Cell, Grid, Occupancy},
    math,
    robot::{Odometry, OdometryModel, RobotModel, SensorReadings},
};

/// `grid_size`, cells.
pub(super) const SIZE: i64 = 100;
/// `resolution`, m.
pub(super) const RESOLUTION: f64 = 0.1;
/// `light_offsets`: the cells that the six bits of the light bumper mark, from left to right.
const LIGHT_OFFSETS: [[f64; 2]; 6] = [[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [1.0, -1.0], [1.0, -2.0], [0.0, -2.0]];
/// `robot_offset`: the cells that the robot occupies.
const ROBOT_OFFSETS: [[f64; 2]; 4] = [[0.0, 0.0], [0.0, -1.0], [-1.0, 0.0], [-1.0, -1.0]];

/// State of a cell: the thesis' `CellStatus` with its values.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[repr(u8)]
pub enum CellStatus {
    /// Nothing was ever marked.
    #[default]
    Unknown = 0,
    /// The robot was there.
    Empty = 127,
    /// A light sensor saw something there.
    Occupied = 100,
}

/// The grid with the robot on it.
#[derive(Debug, Clone)]
pub struct ThesisGrid {
    grid: Vec<CellStatus>,
    odometry: Odometry,
    /// Pose at the last reading, to detect movements forward.
    at: Pose,
}

impl ThesisGrid {
    /// All unknown, and the robot in the middle, looking along x.
    pub fn new(robot: &RobotModel) -> Self {
        let start = Pose::new(0.0, 0.0, 0.0);
        let odometry = Odometry::new(robot, OdometryModel::Arc, start);
        Self { grid: vec![CellStatus::Unknown; (SIZE * SIZE) as usize], odometry, at: start }
    }

    /// Takes the next reading: `odom_callback` and `bump_callback`, and `mark_robot` if the robot has moved forward. Returns
    /// the cells whose status has changed.
    pub fn update(&mut self, sensed: &SensorReadings) -> Vec<Cell> {
        self.odometry.update(sensed);
        let before = std::mem::replace(&mut self.at, self.odometry.pose());
        let mut changed = Vec::new();
        for (&offset, _) in LIGHT_OFFSETS.iter().zip(sensed.light_bumper).filter(|(_, is_near)| *is_near) {
            changed.extend(self.mark_on_map(offset, CellStatus::Occupied));
        }
        if (self.at.position() - before.position()).dot(&before.direction()) > 0.0 {
            changed.extend(self.mark_robot());
        }
        changed
    }

    /// `mark_robot`: its four cells are empty.
    fn mark_robot(&mut self) -> impl Iterator<Item = Cell> {
        ROBOT_OFFSETS.map(|offset| self.mark_on_map(offset, CellStatus::Empty)).into_iter().flatten()
    }

    /// `mark_on_map`: the cell that far ahead and to the left of the robot, as printed. Returns it if its status has changed.
    fn mark_on_map(&mut self, [dx, dy]: [f64; 2], status: CellStatus) -> Option<Cell> {
        let [x, y] = [self.at.x, self.at.y].map(|metres| metres / RESOLUTION + 0.5 * SIZE as f64);
        let z = math::sin(0.5 * self.at.heading);
        let (centre_x, centre_y) = (x - 0.5, y - 0.5);
        let (x, y) = turned((x + dx - centre_x, y + dy - centre_y), z);
        let index = index(x + centre_x, y + centre_y)?;
        let before = std::mem::replace(self.grid.get_mut(index)?, status);
        (before != status).then(|| Cell::new((index as i64 % SIZE) as i32, (index as i64 / SIZE) as i32))
    }

    /// The pose by odometry, in the frame of the robot's start.
    pub fn pose(&self) -> Pose {
        self.at
    }

    /// State of a cell; (0, 0) is the lower left one, 5 m to the left and below the robot's start.
    pub fn status(&self, cell: Cell) -> Option<CellStatus> {
        let is_within = (0..SIZE as i32).contains(&cell.x) && (0..SIZE as i32).contains(&cell.y);
        is_within.then(|| self.grid[(cell.y * SIZE as i32 + cell.x) as usize])
    }

    /// Side of its cells, m.
    pub fn resolution(&self) -> f64 {
        RESOLUTION
    }

    /// Position of its lower left corner in the frame of the robot's start: the printed `origin`.
    pub fn origin(&self) -> Pose {
        let corner = -0.5 * SIZE as f64 * RESOLUTION;
        Pose::new(corner, corner, 0.0)
    }

    /// The grid with the usual values of occupancy.
    pub fn to_occupancy(&self) -> Grid<Occupancy> {
        let mut occupancy = Grid::filled(SIZE as usize, SIZE as usize, Occupancy::Unknown);
        for (value, status) in occupancy.values_mut().iter_mut().zip(&self.grid) {
            *value = match status {
                CellStatus::Unknown => Occupancy::Unknown,
                CellStatus::Empty => Occupancy::Free,
                CellStatus::Occupied => Occupancy::Occupied,
            };
        }
        occupancy
    }
}

/// The three rules of rotation, one after the other, with both of those that hold for 0.2 < z <= 0.8.
fn turned((mut x, mut y): (f64, f64), z: f64) -> (f64, f64) {
    if (-0.8..=-0.2).contains(&z) {
        (x, y) = (-y, x);
    }
    if (0.2..=0.8).contains(&z) {
        (x, y) = (y, -x);
    }
    if !(-0.8..=0.2).contains(&z) {
        (x, y) = (-x, -y);
    }
    (x, y)
}

/// `grid_index`, if it is in range.
fn index(x: f64, y: f64) -> Option<usize> {
    let index = y as i64 * SIZE + x as i64;
    (0..SIZE * SIZE).contains(&index).then_some(index as usize)
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::{geometry::Point, robot::model};

    fn grid_at(x: f64, y: f64, degrees: f64) -> ThesisGrid {
        let mut grid = ThesisGrid::new(model("roomba600").unwrap());
        grid.at = Pose::new(x, y, degrees.to_radians());
        grid
    }

    /// Cells of that status, from the lower left, row by row.
    fn cells(grid: &ThesisGrid, status: CellStatus) -> Vec<(i32, i32)> {
        let all = (0..100).flat_map(|y| (0..100).map(move |x| (x, y)));
        all.filter(|&(x, y)| grid.status(Cell::new(x, y)) == Some(status)).collect()
    }

    #[test]
    fn the_robot_occupies_four_cells_around_the_middle() {
        let mut grid = grid_at(0.0, 0.0, 0.0);
        assert_eq!(grid.mark_robot().count(), 4);
        assert_eq!(grid.mark_robot().count(), 0, "nothing changes");
        assert_eq!(cells(&grid, CellStatus::Empty), [(49, 49), (50, 49), (49, 50), (50, 50)]);
        assert_eq!(grid.origin().position(), Point::new(-5.0, -5.0));
    }

    #[test]
    fn light_offsets_are_printed_for_each_sensor() {
        let expected = [(50, 51), (51, 51), (51, 50), (51, 49), (51, 48), (50, 48)];
        for (sensor, cell) in expected.into_iter().enumerate() {
            let mut grid = grid_at(0.0, 0.0, 0.0);
            let mut sensed = SensorReadings::default();
            sensed.light_bumper[sensor] = true;
            grid.update(&sensed);
            assert_eq!(cells(&grid, CellStatus::Occupied), [cell], "sensor {sensor}");
        }
    }

    /// The corners of `orientation.z` and what the three rules make of one cell ahead and two to the left.
    #[test]
    fn headings_are_rounded_as_printed() {
        let table = [
            (-1.0, (-1.0, -2.0), "third"),
            (-0.81, (-1.0, -2.0), "third"),
            (-0.8, (-2.0, 1.0), "first"),
            (-0.5, (-2.0, 1.0), "first: it looks to the right, and the cell is turned to the left"),
            (-0.2, (-2.0, 1.0), "first"),
            (-0.19, (1.0, 2.0), "none"),
            (0.0, (1.0, 2.0), "none"),
            (0.2, (2.0, -1.0), "second alone"),
            (0.21, (-2.0, 1.0), "second and third"),
            (0.5, (-2.0, 1.0), "second and third"),
            (0.8, (-2.0, 1.0), "second and third"),
            (0.81, (-1.0, -2.0), "third"),
            (1.0, (-1.0, -2.0), "third"),
        ];
        for (z, expected, rule) in table {
            assert_eq!(turned((1.0, 2.0), z), expected, "z = {z}: {rule}");
        }
    }

    #[test]
    fn what_is_ahead_is_marked_ahead_unless_the_robot_looks_to_its_right() {
        let ahead = |degrees: f64| {
            let mut grid = grid_at(0.0, 0.0, degrees);
            grid.mark_on_map([3.0, -0.5], CellStatus::Occupied);
            let (x, y) = cells(&grid, CellStatus::Occupied)[0];
            ((x - 50).signum() * i32::from((x - 50).abs() > 2), (y - 50).signum() * i32::from((y - 50).abs() > 2))
        };
        assert_eq!([ahead(0.0), ahead(90.0), ahead(180.0)], [(1, 0), (0, 1), (-1, 0)]);
        assert_eq!(ahead(-90.0), (0, 1), "as printed: the wrong side");
    }

    #[test]
    fn the_index_is_cut_and_wraps_as_printed() {
        assert_eq!(index(50.9, 50.0), Some(5050));
        assert_eq!(index(-0.9, 0.0), Some(0), "int() cuts towards zero");
        assert_eq!(index(105.0, 3.0), Some(405), "beyond the right edge, a row higher");
        assert_eq!(index(0.0, 100.0), None);
        assert_eq!(index(-1.0, 0.0), None);
    }

    #[test]
    fn readings_of_a_robot_that_drives_ahead_make_a_strip_with_a_wall_at_its_end() {
        let mut grid = ThesisGrid::new(model("roomba600").unwrap());
        for counts in (0..1500_u16).step_by(10) {
            grid.update(&SensorReadings { left_counts: counts, right_counts: counts, ..SensorReadings::default() });
        }
        let wall = SensorReadings {
            light_bumper: [false, false, true, true, false, false],
            left_counts: 1490,
            right_counts: 1490,
            ..SensorReadings::default()
        };
        grid.update(&wall);
        // 1490 counts are 66 cm: the robot's cells reach from 4 before the middle's to 56.
        let map = grid.to_occupancy();
        assert_eq!(map[Cell::new(49, 50)], Occupancy::Free);
        assert_eq!(map[Cell::new(56, 49)], Occupancy::Free);
        assert_eq!((map[Cell::new(57, 50)], map[Cell::new(57, 49)]), (Occupancy::Occupied, Occupancy::Occupied));
        assert_eq!(map[Cell::new(60, 50)], Occupancy::Unknown);
        assert_eq!(
            [CellStatus::Unknown, CellStatus::Empty, CellStatus::Occupied].map(|status| status as u8),
            [0, 127, 100]
        );
    }
}
