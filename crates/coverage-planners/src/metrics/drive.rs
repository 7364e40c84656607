//! Metrics of the path that a robot drives to follow a walk.

use robovac_core::{
    coverage::{CoverageTracker, ReachableFloor},
    geometry::{Point, Pose, difference},
    math,
    robot::{RobotModel, Tool, WheelLayout},
    trajectory::Trajectory,
};
use serde::{Deserialize, Serialize};

/// Joules in a watt-hour.
const JOULES: f64 = 3600.0;

/// Metrics of the line that a robot drives to follow a walk, computed without noise.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct DriveMetrics {
    /// Length, m.
    pub length_m: f64,
    /// Sum of all turns, degrees, the one at the start included.
    pub turning_deg: f64,
    /// Time from rest to rest by the robot's motion model (straight pieces and turns on the spot, or curves as well), s.
    pub duration_s: f64,
    /// Energy taken from the battery, Wh: the robot's power while driving straight and while turning, times the time of
    /// each. Some of the robots' figures are estimates, so it is accurate to about a quarter.
    pub energy_wh: f64,
    /// Swept share of the reachable floor, 0 to 1; accurate to about a fine cell's width along every edge.
    pub coverage: f64,
    /// Area swept again by later passes, as a share of the area swept; 0 or more.
    pub overlap: f64,
    /// Area swept again by later passes, m²; what is swept three times counts twice.
    pub overlap_m2: f64,
}

impl DriveMetrics {
    /// Metrics of `line` (corners, m), driven without noise.
    pub fn of(floor: &ReachableFloor, robot: &RobotModel, line: &[Point]) -> Self {
        Self::measured(floor, robot, line, &LineDrive::along(line, floor.start.heading, robot))
    }

    /// Metrics of a smooth trajectory, driven without noise. The energy counts curves as straight driving.
    pub fn of_trajectory(floor: &ReachableFloor, robot: &RobotModel, trajectory: &Trajectory) -> Self {
        let turning_s = trajectory.turning_s();
        let drive = LineDrive {
            length: trajectory.length_m(),
            turning: trajectory.turned_rad(),
            straight_s: trajectory.duration_s() - turning_s,
            turning_s,
        };
        Self::measured(floor, robot, &trajectory.points(), &drive)
    }

    fn measured(floor: &ReachableFloor, robot: &RobotModel, line: &[Point], drive: &LineDrive) -> Self {
        let LineDrive { length, turning, straight_s, turning_s } = *drive;
        let tracker = swept(floor, line);
        let power = robot.power;
        let joules = (power.standing + power.straight) * straight_s + (power.standing + power.turning) * turning_s;
        Self {
            length_m: length,
            turning_deg: turning.to_degrees(),
            duration_s: straight_s + turning_s,
            energy_wh: joules / JOULES,
            coverage: tracker.coverage(floor),
            overlap: tracker.overlap(),
            overlap_m2: tracker.overlap() * tracker.coverage(floor) * floor.area(),
        }
    }
}

/// Time of a robot that looks along `heading`, rad, and drives `line` (corners, m) from rest to rest, s.
pub fn line_seconds(robot: &RobotModel, line: &[Point], heading: f64) -> f64 {
    let LineDrive { straight_s, turning_s, .. } = LineDrive::along(line, heading, robot);
    straight_s + turning_s
}

/// The floor swept along a line.
fn swept(floor: &ReachableFloor, line: &[Point]) -> CoverageTracker {
    let mut tracker = CoverageTracker::new(floor);
    let mut at = floor.start;
    for &to in line {
        // A tool that isn't in the middle is swung round by a turn on the spot.
        if floor.turns && floor.tool != Tool::CENTRED && at.position() != to {
            let way = to - at.position();
            at.heading = math::atan2(way.y, way.x);
            tracker.sweep_to(floor, at);
        }
        at = Pose { x: to.x, y: to.y, ..at };
        tracker.sweep_up_to(floor, at);
    }
    tracker
}

/// A line driven from rest to rest.
struct LineDrive {
    /// m.
    length: f64,
    /// Sum of all turns, rad.
    turning: f64,
    /// Time for the straight pieces.
    straight_s: f64,
    /// Time for the turns.
    turning_s: f64,
}

impl LineDrive {
    fn along(line: &[Point], mut heading: f64, robot: &RobotModel) -> Self {
        let mut drive = Self { length: 0.0, turning: 0.0, straight_s: 0.0, turning_s: 0.0 };
        for piece in line.windows(2) {
            let step = piece[1] - piece[0];
            let towards = math::atan2(step.y, step.x);
            let turn = difference(heading, towards).abs();
            if turn > 1e-9 && robot.wheels == WheelLayout::Differential {
                drive.turning += turn;
                drive.turning_s += robot.turn_time(turn);
            }
            drive.length += step.norm();
            drive.straight_s += robot.straight_time(step.norm());
            heading = towards;
        }
        drive
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::{
        floor_plan::Sketch,
        grid::Cell,
        robot::{cell_robot, model},
    };

    #[test]
    fn duration_adds_pieces_and_turns() {
        let robot = cell_robot(0.2);
        let line = [Point::new(0.0, 0.0), Point::new(3.0, 0.0), Point::new(3.0, 3.0)];
        let drive = LineDrive::along(&line, 0.0, &robot);
        assert_eq!(drive.length, 6.0);
        assert!((drive.turning - math::FRAC_PI_2).abs() < 1e-12);
        assert!((drive.straight_s - 2.0 * (10.0 + 0.3 / 0.8)).abs() < 1e-12);
        assert!((drive.turning_s - robot.turn_time(math::FRAC_PI_2)).abs() < 1e-12);
    }

    #[test]
    fn there_and_back_overlaps_by_what_was_swept() {
        let plan = Sketch::open(2.0, 0.2, 0.2).start(0.1, 0.1, 0.0).finish("", "");
        let robot = cell_robot(0.2);
        let floor = ReachableFloor::new(&plan, &robot, None).unwrap();
        let line = [Point::new(0.1, 0.1), Point::new(1.9, 0.1), Point::new(0.1, 0.1)];
        let drive = DriveMetrics::of(&floor, &robot, &line);
        assert_eq!(drive.coverage, 1.0);
        // The robot reverses in the last cell without having left it.
        assert!((drive.overlap_m2 - 0.4).abs() < 0.081 && (drive.overlap - drive.overlap_m2 / 0.4).abs() < 1e-9);
        assert!((drive.turning_deg - 180.0).abs() < 1e-9);
    }

    #[test]
    fn corners_are_swept_to_their_end() {
        let plan = Sketch::open(4.0, 4.0, 0.05).start(1.0, 1.0, 0.0).finish("", "");
        let floor = ReachableFloor::new(&plan, model("roomba600").unwrap(), None).unwrap();
        // Lengths that no number of stamps divides.
        let line = [Point::new(1.0, 1.0), Point::new(2.0071, 1.0), Point::new(2.0071, 2.0093), Point::new(1.5, 2.0093)];
        let tracker = swept(&floor, &line);
        for corner in line {
            let near = (0..floor.floor.height() as i32)
                .flat_map(|y| (0..floor.floor.width() as i32).map(move |x| Cell::new(x, y)))
                .filter(|cell| {
                    let centre = Point::new(
                        (f64::from(cell.x) + 0.5) * floor.resolution,
                        (f64::from(cell.y) + 0.5) * floor.resolution,
                    );
                    (centre - corner).norm() < floor.tool_radius - 1e-9
                });
            assert!(near.into_iter().all(|cell| tracker.visits()[cell] > 0), "{corner}");
        }
    }

    #[test]
    fn a_charge_lasts_as_long_as_documented() {
        // An hour of straight driving without walls: the figures that the robots' power was derived from.
        for (id, minutes, wh) in [("roomba600", 100.0, 43.2), ("dvr1", 60.0, 27.0), ("cell", 60.0, 27.0)] {
            let robot = model(id).unwrap();
            let joules = (robot.power.standing + robot.power.straight) * minutes * 60.0;
            assert!((joules / JOULES - wh).abs() < 0.02 * wh, "{}: {} Wh", robot.id, joules / JOULES);
        }
    }
}
