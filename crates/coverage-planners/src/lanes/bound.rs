//! What any path must travel at least, and for how long.

use robovac_core::{
    coverage::ReachableFloor,
    geometry::Vector,
    math,
    robot::{RobotModel, Tool, WheelLayout},
};
use serde::{Deserialize, Serialize};

/// Length over which turning is counted, in diameters of the room: the best of the proof, to two digits.
const STRETCH: f64 = 1.55;

/// Proven lower bounds on any path in metres that sweeps a given area, whatever obstacles there are.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct MetricBound {
    /// Length, m.
    pub length_m: f64,
    /// Sum of all turns, rad.
    pub turning_rad: f64,
    /// Time by the robot's motion model with a stop before every turn, s.
    pub duration_s: f64,
}

impl MetricBound {
    /// Bounds on a path that sweeps the share `coverage`, 0 to 1, of `floor`; see [`MetricBound::of_area`]. All are 0 for a tool
    /// that isn't in the middle: turning sweeps, too.
    pub fn new(floor: &ReachableFloor, robot: &RobotModel, coverage: f64) -> Self {
        if robot.tool != Tool::CENTRED {
            return Self { length_m: 0.0, turning_rad: 0.0, duration_s: 0.0 };
        }
        // The body's centre is never farther out than the floor that the tool sweeps around it.
        let cells = || floor.floor.iter().filter(|&(_, &is_floor)| is_floor).map(|(cell, _)| floor.centre(cell));
        let first = cells().next().unwrap_or_default();
        let (low, high) = cells().fold((first, first), |(low, high), centre| (low.inf(&centre), high.sup(&centre)));
        let diameter = (high - low + Vector::new(floor.resolution, floor.resolution)).norm();
        Self::of_area(coverage.clamp(0.0, 1.0) * floor.area(), diameter, robot)
    }

    /// Bounds on a path that sweeps `area` square metres at least and whose points are at most `diameter` metres apart.
    ///
    /// *Length.* The tool is a disc of width w. Cut the path into straight pieces. The disc at its start has the area
    /// pi w²/4. While it moves straight by l, it sweeps a stadium of which the disc where the piece begins was swept before; what is
    /// left of the stadium has the area w l. Turns on the spot sweep nothing new. So a path of length L sweeps at most
    /// w L + pi w²/4, and L >= (area - pi w²/4) / w. Straight paths reach it; for curves it holds as the limit.
    ///
    /// *Turning.* A path whose turns add up to t < pi has all its directions within an angle of t, so that each makes at most
    /// t/2 with the one in the middle: a path of length s ends at least s cos(t/2) from its start. As no two points
    /// are more than d apart, every stretch of length s > d turns by 2 acos(d / s) at least. A path of length L has floor(L / s)
    /// such stretches, which turn by floor(L / s) 2 acos(d / s) together; s = 1.55 d is about the best choice.
    ///
    /// *Time.* No straight piece is longer than d. The time for a piece from rest to rest is a concave function of its length and 0
    /// at 0, so pieces that add up to L take least if as many as possible have length d and one has the rest. Turns by t take
    /// t / (turn rate) at least. An omnidirectional robot needn't turn.
    pub fn of_area(area: f64, diameter: f64, robot: &RobotModel) -> Self {
        let width = robot.tool_width;
        let length = ((area - 0.25 * math::PI * width * width) / width).max(0.0);
        if diameter <= 0.0 {
            return Self { length_m: length, turning_rad: 0.0, duration_s: robot.straight_time(length) };
        }
        let pieces = (length / diameter).floor();
        let rest = (length - pieces * diameter).max(0.0);
        let stretches = (length / (STRETCH * diameter)).floor();
        // acos(d / s) as the angle of a right-angled triangle.
        let turn = 2.0 * math::atan2((STRETCH * STRETCH - 1.0).sqrt(), 1.0);
        let turning = stretches * turn;
        let driving = pieces * robot.straight_time(diameter) + robot.straight_time(rest);
        let turns = if robot.wheels == WheelLayout::Omnidirectional { 0.0 } else { turning / robot.turn_rate() };
        Self { length_m: length, turning_rad: turning, duration_s: driving + turns }
    }

    /// The same for a robot that needn't stop to turn: the length at its cruise speed, from rest to rest. The bound on the length
    /// holds for curves, too.
    pub fn without_stops(self, robot: &RobotModel) -> Self {
        Self { turning_rad: 0.0, duration_s: robot.straight_time(self.length_m), ..self }
    }

    /// How far a path's length, m, and time, s, exceed the bounds, as shares: 0.2 for a fifth; 0 where the bound is 0.
    pub fn excess(&self, length_m: f64, duration_s: f64) -> [f64; 2] {
        let above = |value: f64, bound: f64| if bound > 0.0 { value / bound - 1.0 } else { 0.0 };
        [above(length_m, self.length_m), above(duration_s, self.duration_s)]
    }
}

#[cfg(test)]
mod tests {
    use super::{super::cost::MotionTimes, super::swept_share, *};
    use rand::RngExt;
    use robovac_core::{floor_plan::Sketch, geometry::Point, rng::seeded, robot::model};

    #[test]
    fn a_straight_path_meets_the_bound_on_its_length() {
        let robot = model("roomba600").unwrap();
        let area = 0.17 * 3.0 + 0.25 * math::PI * 0.17 * 0.17;
        let bound = MetricBound::of_area(area, 3.2, robot);
        assert!((bound.length_m - 3.0).abs() < 1e-12 && bound.turning_rad == 0.0);
        assert!((bound.duration_s - robot.straight_time(3.0)).abs() < 1e-12);
        assert_eq!(bound.excess(3.0, 2.0 * bound.duration_s), [0.0, 1.0]);
        // The end caps alone sweep this.
        assert_eq!(MetricBound::of_area(0.02, 3.0, robot).length_m, 0.0);
    }

    #[test]
    fn no_path_beats_the_bound_of_what_it_sweeps() {
        let plan = Sketch::open(3.0, 2.0, 0.05).start(1.0, 1.0, 0.0).finish("", "");
        let robot = model("roomba600").unwrap();
        let floor = ReachableFloor::new(&plan, robot, None).unwrap();
        let mut rng = seeded(2, 0);
        for corners in [2, 3, 5, 20, 60] {
            for _ in 0..4 {
                let path: Vec<Point> =
                    (0..corners).map(|_| Point::new(rng.random_range(0.2..2.8), rng.random_range(0.2..1.8))).collect();
                let bound = MetricBound::new(&floor, robot, swept_share(&floor, &path));
                let length: f64 = path.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum();
                let first = path[1] - path[0];
                let duration = MotionTimes::of(robot, None).path(&path, first, None);
                // The swept share is measured to 0.01 % of the floor.
                assert!(bound.length_m <= length + 0.003 && bound.duration_s <= duration + 0.02, "{bound:?} {length}");
            }
        }
    }

    #[test]
    fn lanes_in_a_long_hall_turn_more_than_they_must() {
        let robot = model("roomba600").unwrap();
        let bound = MetricBound::of_area(0.17 * 100.0, 10.0, robot);
        // Ten lanes of ten metres need nine U-turns; the proof gives six stretches of 99.6 degrees.
        assert!((bound.turning_rad.to_degrees() - 6.0 * 99.65).abs() < 1.0, "{}", bound.turning_rad.to_degrees());
        assert!(bound.turning_rad < 9.0 * math::PI);
        assert!(bound.duration_s > bound.length_m / robot.cruise_speed + 10.0 * 0.3 / 0.8 - 0.4);
    }
}
