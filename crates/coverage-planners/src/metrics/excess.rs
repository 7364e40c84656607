//! How far a path is above what sweeping as much floor takes at least.

use super::DriveMetrics;
use crate::lanes::{MetricBound, swept_share};
use robovac_core::{
    coverage::ReachableFloor,
    geometry::Point,
    robot::{RobotModel, Tool},
    trajectory::Trajectory,
};
use serde::{Deserialize, Serialize};

/// What any path needs that sweeps so much of a floor.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct SweepBound {
    /// Share of the floor, 0 to 1.
    pub coverage: f64,
    /// Length, m.
    pub length_m: f64,
    /// Time by the robot's motion model, s.
    pub duration_s: f64,
}

impl SweepBound {
    /// The bounds for the share `coverage` of `floor`; `None` as for [`MetricExcess::of`].
    pub fn new(floor: &ReachableFloor, robot: &RobotModel, coverage: f64) -> Option<Self> {
        let MetricBound { length_m, duration_s, .. } = MetricBound::new(floor, robot, coverage);
        sweeps_as_disc(robot).then_some(Self { coverage, length_m, duration_s })
    }
}

/// Whether what a robot sweeps is a disc. The bounds are for those: standing on a cell sweeps its corners, too.
pub fn sweeps_as_disc(robot: &RobotModel) -> bool {
    !robot.fills_cell && matches!(robot.tool, Tool::Disc(_))
}

/// A driven line above the bounds for the floor that it sweeps.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct MetricExcess {
    /// Swept share of the reachable floor, 0 to 1, by [`swept_share`]; more exact than [`DriveMetrics::coverage`].
    pub swept: f64,
    /// Bounds on any path that sweeps as much.
    pub bound: MetricBound,
    /// How far length and time exceed them, as shares: 0.2 for a fifth.
    pub above: [f64; 2],
}

impl MetricExcess {
    /// Excess of `line` (corners, m), whose numbers are `drive`. `None` unless the robot [sweeps as a disc](sweeps_as_disc).
    pub fn of(floor: &ReachableFloor, robot: &RobotModel, line: &[Point], drive: &DriveMetrics) -> Option<Self> {
        if !sweeps_as_disc(robot) {
            return None;
        }
        let swept = swept_share(floor, line);
        let bound = MetricBound::new(floor, robot, swept);
        Some(Self { swept, bound, above: bound.excess(drive.length_m, drive.duration_s) })
    }

    /// The same for a smooth trajectory, above the bounds of paths without stops.
    pub fn of_trajectory(
        floor: &ReachableFloor,
        robot: &RobotModel,
        trajectory: &Trajectory,
        drive: &DriveMetrics,
    ) -> Option<Self> {
        let Self { swept, .. } = Self::of(floor, robot, &trajectory.points(), drive)?;
        let bound = MetricBound::without_stops(floor, robot, swept);
        Some(Self { swept, bound, above: bound.excess(drive.length_m, drive.duration_s) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::{
        floor_plan::Sketch,
        robot::{cell_robot, model},
    };

    #[test]
    fn sweeping_twice_takes_twice_the_least() {
        let robot = model("roomba600").unwrap();
        let plan = Sketch::open(6.0, 1.0, 0.05).start(0.5, 0.5, 0.0).finish("", "");
        let floor = ReachableFloor::new(&plan, robot, None).unwrap();
        let line = [0.5, 5.5, 0.5].map(|x| Point::new(x, 0.5));
        let excess =
            |line: &[Point]| MetricExcess::of(&floor, robot, line, &DriveMetrics::of(&floor, robot, line)).unwrap();
        let (once, twice) = (excess(&line[..2]), excess(&line));
        assert!((once.swept * floor.area() - (5.0 * 0.17 + 0.0227)).abs() < 1e-3);
        assert!((once.bound.length_m - 5.0).abs() < 0.01 && once.above[0].abs() < 0.002, "{once:?}");
        assert!((twice.above[0] - 1.0).abs() < 0.004 && twice.above[1] > 1.0, "{twice:?}");
    }

    #[test]
    fn a_robot_that_fills_its_cell_sweeps_more_than_a_disc() {
        let robot = cell_robot(0.2);
        let plan = Sketch::open(2.0, 0.2, 0.2).start(0.1, 0.1, 0.0).finish("", "");
        let floor = ReachableFloor::new(&plan, &robot, None).unwrap();
        let line = [Point::new(0.1, 0.1), Point::new(1.9, 0.1)];
        assert_eq!(MetricExcess::of(&floor, &robot, &line, &DriveMetrics::of(&floor, &robot, &line)), None);
    }
}
