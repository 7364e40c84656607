//! Chooses the frontier explorer's next goal.

use super::{
    chart::{Chart, ReachableWays, SLACK},
    frontier::{DriveGoal, ExplorePhase, Frontier},
};
use crate::controller::parts::AttemptBudget;
use crate::controller::parts::{Move, Pilot, Route};
use robovac_core::geometry::{Point, Pose};
use std::f64::consts::PI;

/// Time limit for a route: s, and s/m.
const PATIENCE: (f64, f64) = (8.0, 8.0);
/// Distance at which it is at the end of a wall, m.
const AT_END: f64 = 0.2;
/// By how much the end of a wall can be farther away than unknown floor and still be chosen first, m.
const WALL_FIRST: f64 = 3.0;
/// How often it looks again when nothing seems left.
const DOUBTS: u32 = 2;

impl Frontier {
    /// Chooses the next goal. As maps can wrongly show no way, it then accepts narrower gaps.
    pub(super) fn decide(&mut self, pilot: &mut Pilot) {
        if self.lookout.is_some() && self.doubts == 0 && self.mapper.map().bounds().is_none() {
            // It waits for its first scan.
            return;
        }
        let here = self.mapper.pose().position();
        let trace = &self.trace;
        self.ends.retain(|&end| !trace.has(beyond(end)));
        for slack in SLACK {
            let chart = Chart::new(self.mapper.map(), &self.barred, here, (pilot.robot.radius, slack));
            let ways = chart.ways(here);
            if self.go_for_the_nearest(pilot, &chart, &ways, here) {
                return;
            }
        }
        if self.doubts < DOUBTS {
            self.doubts += 1;
            self.barred.forget();
            self.look_again(pilot);
        } else if !self.go_home(pilot, here) {
            self.phase = ExplorePhase::Done;
        }
    }

    /// Follows the next wall. A robot with a laser turns around for more scans: noise in the first can shut it in.
    fn look_again(&mut self, pilot: &mut Pilot) {
        self.follow(pilot);
        if self.lookout.is_some() {
            pilot.go(&[Move::Turn(if self.doubts.is_multiple_of(2) { -PI } else { PI })]);
        }
    }

    /// Starts towards the nearest goal; returns whether there is one.
    fn go_for_the_nearest(&mut self, pilot: &mut Pilot, chart: &Chart, ways: &ReachableWays, here: Point) -> bool {
        let lanes = chart.lanes(ways, self.spacing, |place| !self.budget.is_spent(AttemptBudget::cell(place)));
        self.lanes = lanes.iter().map(|lane| [lane.entry, lane.end].map(|cell| chart.centre(cell))).collect();
        let floor = Chart::nearest(lanes);
        let wall = self.nearest_end(chart, ways);
        match (floor, wall) {
            (Some(lane), wall) if wall.is_none_or(|(_, way)| lane.cost() < way - WALL_FIRST) => {
                let mut line = chart.line(ways, lane.from);
                line.extend([chart.centre(lane.entry), chart.centre(lane.end)]);
                self.drive(here, line, (DriveGoal::Floor, chart.centre(lane.entry)));
            }
            (_, Some((index, way))) => {
                let end = self.ends.remove(index);
                if way < AT_END {
                    self.follow(pilot);
                    return true;
                }
                let mut line = chart.line(ways, chart.cell_at(end.position()));
                line.extend([end.position(), beyond(end).position()]);
                self.drive(here, line, (DriveGoal::Wall(end), end.position()));
            }
            _ => return false,
        }
        true
    }

    /// Starts to return; returns whether it can.
    fn go_home(&mut self, pilot: &Pilot, here: Point) -> bool {
        for slack in SLACK {
            let chart = Chart::new(self.mapper.map(), &self.barred, here, (pilot.robot.radius, slack));
            let ways = chart.ways(here);
            let start = chart.cell_at(self.mapper.setup().start.position());
            if self.ways_home > 0 && ways.reaches(start) {
                self.ways_home -= 1;
                self.drive(here, chart.line(&ways, start), (DriveGoal::Home, chart.centre(start)));
                return true;
            }
        }
        false
    }

    /// The nearest end of a wall, by its index, and the distance to it, m.
    fn nearest_end(&self, chart: &Chart, ways: &ReachableWays) -> Option<(usize, f64)> {
        let resolution = self.mapper.map().resolution();
        let ends =
            self.ends.iter().enumerate().filter(|(_, end)| !self.budget.is_spent(AttemptBudget::cell(end.position())));
        let ways =
            ends.filter_map(|(index, end)| Some((index, ways.cost(chart.cell_at(end.position()))? * resolution)));
        ways.min_by(|a, b| a.1.total_cmp(&b.1))
    }

    fn drive(&mut self, from: Point, line: Vec<Point>, (to, place): (DriveGoal, Point)) {
        self.budget.set_out(AttemptBudget::cell(place));
        let route = Route::new(from, line);
        let patience = PATIENCE.0 + PATIENCE.1 * route.left(from);
        self.phase = ExplorePhase::Drive { route, patience, to, place };
    }
}

/// A pose a little farther on.
fn beyond(pose: Pose) -> Pose {
    let Point { coords, .. } = pose.to_world(Point::new(0.3, 0.0));
    Pose::new(coords.x, coords.y, pose.heading)
}

#[cfg(test)]
mod tests {
    use crate::controller::{Setup, find};
    use robovac_core::{
        registry::Params,
        robot::{SensorReadings, model},
    };

    const DT_S: f64 = 0.015;

    #[test]
    fn exploring_by_laser_ended_at_once_when_the_first_scan_shut_the_robot_in() {
        let (robot, info) = (model("cbot").unwrap(), find("explore_frontier").unwrap());
        let setup = Setup { robot, params: &Params::defaults(info.params), seed: 1 };
        let mut explorer = info.build(&setup).unwrap();
        let blind = SensorReadings::default();
        for _ in 0..100 {
            let drive = explorer.step(&blind, DT_S);
            assert!(drive.left == 0.0 && drive.right == 0.0 && !explorer.is_done(), "it waits for its first scan");
        }
        let beams = robot.sensors.laser.unwrap().beams;
        let shut_in = SensorReadings { laser: Some(vec![0.3; beams].into()), ..blind };
        let turns = (0..200).any(|_| {
            let drive = explorer.step(&shut_in, DT_S);
            drive.left == -drive.right && drive.right > 0.0
        });
        assert!(turns && !explorer.is_done(), "{}", explorer.activity());
    }
}
