//! One definition of every number that the page, the command line and the tests show.

use crate::{
    coverage::{CoverageTracker, ReachableFloor},
    geometry::Point,
    math,
    planner::{CoverageJob, CoveragePath},
    robot::RobotModel,
};
use serde::Serialize;

/// Numbers of a walk on the planning grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct WalkMetrics {
    /// Cells that can be reached from the start, the start included.
    pub reachable_cells: usize,
    /// Cells of those that the walk visits.
    pub visited_cells: usize,
    /// Steps from cell to cell.
    pub steps: usize,
    /// Quarter turns between consecutive steps; a reversal counts two.
    pub turns: usize,
    /// Quarter turns from the robot's heading at the start to its first step; not part of `turns`.
    pub initial_turns: usize,
    /// Visits to cells beyond the first to each.
    pub revisits: usize,
}

impl WalkMetrics {
    /// Counts what `path` does.
    pub fn of(job: &CoverageJob, path: &CoveragePath) -> Self {
        let visited_cells = path.visits(job).values().iter().filter(|&&v| v > 0).count();
        let mut directions = path.cells.windows(2).filter_map(|w| w[0].direction_to(w[1]));
        let mut turns = 0;
        let first = directions.next();
        let mut last = first;
        for direction in directions {
            turns += last.map_or(0, |l| l.quarter_turns(direction)) as usize;
            last = Some(direction);
        }
        Self {
            reachable_cells: job.cells(),
            visited_cells,
            steps: path.cells.len().saturating_sub(1),
            turns,
            initial_turns: first.map_or(0, |d| job.heading.quarter_turns(d)) as usize,
            revisits: path.cells.len() - visited_cells,
        }
    }
}

/// Numbers of the line that a robot drives to follow a walk.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct DriveMetrics {
    /// Length, m.
    pub length_m: f64,
    /// Sum of all turns, degrees, the one at the start included.
    pub turning_deg: f64,
    /// Time from rest to rest by the robot's motion model (straight pieces and turns on the spot), s.
    pub duration_s: f64,
    /// Swept share of the reachable floor, 0 to 1.
    pub coverage: f64,
    /// Area swept again by later passes, as a share of the area swept.
    pub overlap: f64,
}

impl DriveMetrics {
    /// Drives `line` (corners, m) in thought, without noise.
    pub fn of(floor: &ReachableFloor, robot: &RobotModel, line: &[Point]) -> Self {
        let (length_m, turning, duration_s) = drive(line, floor.start.heading, robot);
        let mut tracker = CoverageTracker::new(floor);
        for &point in line {
            tracker.sweep_to(floor, point);
        }
        Self {
            length_m,
            turning_deg: turning.to_degrees(),
            duration_s,
            coverage: tracker.coverage(floor),
            overlap: tracker.overlap(),
        }
    }
}

/// Length (m), summed turns (rad) and duration (s) of a line driven from `heading`, from rest to rest.
fn drive(line: &[Point], mut heading: f64, robot: &RobotModel) -> (f64, f64, f64) {
    let (mut length, mut turning, mut duration) = (0.0, 0.0, 0.0);
    for piece in line.windows(2) {
        let step = piece[1] - piece[0];
        let towards = math::atan2(step.y, step.x);
        let turn = crate::geometry::difference(heading, towards).abs();
        if turn > 1e-9 {
            turning += turn;
            duration += robot.turn_time(turn);
        }
        length += step.norm();
        duration += robot.straight_time(step.norm());
        heading = towards;
    }
    (length, turning, duration)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        grid::{Cell, Direction, Grid},
        robot::cell_robot,
    };

    fn path(cells: &[(i32, i32)]) -> CoveragePath {
        CoveragePath { cells: cells.iter().map(|&(x, y)| Cell::new(x, y)).collect() }
    }

    #[test]
    fn reversal_counts_two_and_the_start_is_apart() {
        let job = CoverageJob::new(&Grid::filled(3, 2, true), Cell::new(0, 0), Direction::Up).unwrap();
        let metrics = WalkMetrics::of(&job, &path(&[(0, 0), (1, 0), (2, 0), (1, 0), (1, 1)]));
        let expected =
            WalkMetrics { reachable_cells: 6, visited_cells: 4, steps: 4, turns: 3, initial_turns: 1, revisits: 1 };
        assert_eq!(metrics, expected);
    }

    #[test]
    fn duration_adds_pieces_and_turns() {
        let robot = cell_robot(0.2);
        let line = [Point::new(0.0, 0.0), Point::new(3.0, 0.0), Point::new(3.0, 3.0)];
        let (length, turning, duration) = drive(&line, 0.0, &robot);
        assert_eq!(length, 6.0);
        assert!((turning - math::FRAC_PI_2).abs() < 1e-12);
        let expected = 2.0 * (10.0 + 0.3 / 0.8) + robot.turn_time(math::FRAC_PI_2);
        assert!((duration - expected).abs() < 1e-12);
    }
}
