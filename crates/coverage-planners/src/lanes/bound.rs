//! What any path must travel at least, and for how long.

use crate::metrics::sweeps_as_disc;
use robovac_core::{
    coverage::ReachableFloor,
    geometry::Vector,
    math,
    robot::{RobotModel, Tool, WheelLayout},
    trajectory::DriveLimits,
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
    /// that isn't a disc.
    pub fn new(floor: &ReachableFloor, robot: &RobotModel, coverage: f64) -> Self {
        if !matches!(robot.tool, Tool::Disc(_)) {
            return Self { length_m: 0.0, turning_rad: 0.0, duration_s: 0.0 };
        }
        // The body's centre is never farther out than the floor that a tool in the middle sweeps around it. Otherwise it is
        // in a cell where it can stand, or beside one.
        let is_centred = robot.tool == Tool::CENTRED;
        let margin = if is_centred { 1.0 } else { 3.0 } * floor.resolution;
        let is_in = |cell, is_floor: bool| is_floor || (!is_centred && floor.standing.is_set(cell));
        let cells = || floor.floor.iter().filter(|&(cell, &is)| is_in(cell, is)).map(|(cell, _)| floor.centre(cell));
        let first = cells().next().unwrap_or_default();
        let (low, high) = cells().fold((first, first), |(low, high), centre| (low.inf(&centre), high.sup(&centre)));
        let diameter = (high - low + Vector::new(margin, margin)).norm();
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
    ///
    /// *A tool off the middle*, with its own middle at the lever e from that between the wheels. The proof of the length holds for
    /// the tool's way S, to which turns on the spot add: S >= (area - pi w²/4) / w. A robot that keeps its heading moves as far as
    /// its tool, and all is as above. For others:
    ///
    /// - All that is swept lies within r = e + w/2 of the path. A disc of this radius sweeps 2 r L + pi r² at most, so
    ///   L >= (area - pi r²) / (2 r). The turning follows from this length as above.
    /// - The tool moves by l on a straight piece of length l, which takes t(l), and by e α in a turn by α, which takes
    ///   α / (turn rate) at least. As t is concave and 0 at 0, l / t(l) is greatest for the longest pieces. So the tool is never
    ///   faster, on the average over a piece or a turn, than u = max(d / t(d), e (turn rate)), and the time is at least S / u.
    pub fn of_area(area: f64, diameter: f64, robot: &RobotModel) -> Self {
        let length = least_length(area, robot);
        if diameter <= 0.0 {
            let (way, arc_speed) = (least_way(area, robot), lever(robot).norm() * robot.turn_rate());
            let straight = robot.straight_time(way);
            let duration = if is_levered(robot) { way / arc_speed.max(robot.cruise_speed) } else { straight };
            return Self { length_m: length, turning_rad: 0.0, duration_s: duration };
        }
        let pieces = (length / diameter).floor();
        let rest = (length - pieces * diameter).max(0.0);
        let stretches = (length / (STRETCH * diameter)).floor();
        // acos(d / s) as the angle of a right-angled triangle.
        let turn = 2.0 * math::atan2((STRETCH * STRETCH - 1.0).sqrt(), 1.0);
        let turning = stretches * turn;
        let driving = pieces * robot.straight_time(diameter) + robot.straight_time(rest);
        let turns = if robot.wheels == WheelLayout::Omnidirectional { 0.0 } else { turning / robot.turn_rate() };
        let mut duration = driving + turns;
        if is_levered(robot) {
            let straight = diameter / robot.straight_time(diameter);
            let fastest = straight.max(lever(robot).norm() * robot.turn_rate());
            duration = duration.max(least_way(area, robot) / fastest);
        }
        Self { length_m: length, turning_rad: turning, duration_s: duration }
    }

    /// The same for a robot that needn't stop to turn: the length at its cruise speed, from rest to rest. The bound on the length
    /// holds for curves, too. For a tool off the middle, the tool's way at the most speed that it can have within the limits of the wheels.
    pub fn without_stops(floor: &ReachableFloor, robot: &RobotModel, coverage: f64) -> Self {
        let bound = Self::new(floor, robot, coverage);
        let mut duration = robot.straight_time(bound.length_m);
        if is_levered(robot)
            && let Some(DriveLimits { speed, wheel_speed, .. }) = DriveLimits::of(robot)
        {
            let way = least_way(coverage.clamp(0.0, 1.0) * floor.area(), robot);
            duration = duration.max(way / fastest(robot, speed, wheel_speed));
        }
        Self { turning_rad: 0.0, duration_s: duration, ..bound }
    }

    /// The least length, m, and time, s, of a run that sweeps `area` square metres with stops or without, at its wheels' top speed.
    /// `None` for a robot that doesn't [sweep as a disc](sweeps_as_disc), for so little floor that it needn't move, and for a tool
    /// off the middle of a robot that moves in every direction and may turn meanwhile.
    pub fn of_run(area: f64, robot: &RobotModel) -> Option<[f64; 2]> {
        let may_turn_aside = robot.wheels == WheelLayout::Omnidirectional && robot.tool != Tool::CENTRED;
        let length = if sweeps_as_disc(robot) && !may_turn_aside { least_length(area, robot) } else { 0.0 };
        let top = robot.max_wheel_speed;
        (length > 0.0).then(|| [length, (length / top).max(least_way(area, robot) / fastest(robot, top, top))])
    }

    /// How far a path's length, m, and time, s, exceed the bounds, as shares: 0.2 for a fifth; 0 where the bound is 0.
    pub fn excess(&self, length_m: f64, duration_s: f64) -> [f64; 2] {
        let above = |value: f64, bound: f64| if bound > 0.0 { value / bound - 1.0 } else { 0.0 };
        [above(length_m, self.length_m), above(duration_s, self.duration_s)]
    }
}

/// From the middle between the wheels to that of the tool, ahead and to the left, m.
fn lever(robot: &RobotModel) -> Vector {
    if let Tool::Disc([x, y]) = robot.tool { Vector::new(x, y) } else { Vector::zeros() }
}

/// Whether turns move the tool. A robot that moves in every direction keeps its heading.
fn is_levered(robot: &RobotModel) -> bool {
    robot.wheels == WheelLayout::Differential && lever(robot) != Vector::zeros()
}

/// What the middle of the tool must travel to sweep `area`, m.
fn least_way(area: f64, robot: &RobotModel) -> f64 {
    let width = robot.tool_width;
    ((area - 0.25 * math::PI * width * width) / width).max(0.0)
}

/// What the robot must travel to sweep `area`, m.
fn least_length(area: f64, robot: &RobotModel) -> f64 {
    if !is_levered(robot) {
        return least_way(area, robot);
    }
    let reach = lever(robot).norm() + 0.5 * robot.tool_width;
    ((area - math::PI * reach * reach) / (2.0 * reach)).max(0.0)
}

/// The most speed of the tool's middle, m/s, while the robot drives at v, at most `speed`, and turns at ω, and no wheel turns faster
/// than `wheel_speed`: |v| + |ω| b/2 <= W for wheels b apart.
///
/// At (x, y) from the middle between the wheels, the velocity is (v - ω y, ω x). Its norm is a convex function of v and ω, so it is
/// greatest at a corner of what they can be: turning on the spot at 2 W / b, or driving at `speed` and turning with what the wheels have
/// left. The latter is straight on where `speed` is W.
fn fastest(robot: &RobotModel, speed: f64, wheel_speed: f64) -> f64 {
    let at = lever(robot);
    let turn_rate = |rest: f64| 2.0 * rest.max(0.0) / robot.wheel_base;
    let in_curve = turn_rate(wheel_speed - speed);
    let driving = math::hypot(speed + in_curve * at.y.abs(), in_curve * at.x);
    driving.max(turn_rate(wheel_speed) * at.norm())
}

#[cfg(test)]
mod tests {
    use super::{super::cost::MotionTimes, super::swept_share, *};
    use rand::RngExt;
    use robovac_core::{
        floor_plan::{Sketch, generate::random_flat},
        geometry::Point,
        rng::seeded,
        robot::model,
    };

    /// A robot with its tool at a place: small, if that is far from the middle.
    fn with_tool(at: [f64; 2], width: f64) -> RobotModel {
        RobotModel { tool: Tool::Disc(at), tool_width: width, ..model("roomba600").unwrap().clone() }
    }

    /// Length, m, and time, s, of a path with stops from rest to rest.
    fn length_and_time(robot: &RobotModel, path: &[Point], heading: Vector) -> [f64; 2] {
        let length = path.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum();
        [length, MotionTimes::of(robot, None).path(path, heading, None)]
    }

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

    #[test]
    fn no_path_beats_the_bound_for_a_tool_off_the_middle() {
        let mut rng = seeded(5, 0);
        for seed in 0..6 {
            let plan = random_flat(1, 1, seed);
            let at = [rng.random_range(-0.1..0.1), rng.random_range(-0.1..0.1)];
            // Some turn so fast that the tool is faster in turns than straight on.
            let turn_wheel_speed = [0.1, 0.5][seed as usize % 2];
            let robot = RobotModel { turn_wheel_speed, max_wheel_speed: 0.5, ..with_tool(at, 0.08) };
            let floor = ReachableFloor::new(&plan, &robot, None).unwrap();
            let heading = floor.start.direction();
            let places: Vec<Point> =
                floor.standing.iter().filter(|&(_, &is)| is).map(|(cell, _)| floor.centre(cell)).collect();
            for corners in [2, 5, 20, 60] {
                // Walls don't matter to the bound.
                let mut path = vec![floor.start.position()];
                path.extend((1..corners).map(|_| places[rng.random_range(0..places.len())]));
                let swept = swept_share(&floor, &path);
                let bound = MetricBound::new(&floor, &robot, swept);
                let [length, duration] = length_and_time(&robot, &path, heading);
                assert!(
                    bound.length_m <= length && bound.duration_s <= duration + 0.02,
                    "{bound:?} {length} {duration}"
                );
                // The most speed without stops is more than that with them.
                assert!(MetricBound::without_stops(&floor, &robot, swept).duration_s <= bound.duration_s);
            }
        }
    }

    #[test]
    fn turning_on_the_spot_sweeps_nearly_as_fast_as_the_bound_allows() {
        let plan = Sketch::open(2.0, 2.0, 0.01).start(1.0, 1.0, 0.0).finish("", "");
        let quick = RobotModel {
            turn_wheel_speed: 0.45,
            max_wheel_speed: 0.5,
            acceleration: 50.0,
            ..with_tool([0.0, 0.14], 0.05)
        };
        let floor = ReachableFloor::new(&plan, &quick, None).unwrap();
        // Hardly any way, and two turns by 120 degrees.
        let path = [[0.0, 0.0], [1.0, 0.0], [0.5, 0.75_f64.sqrt()], [0.0, 0.0]];
        let path = path.map(|[x, y]| Point::new(1.0 + 1e-4 * x, 1.0 + 1e-4 * y));
        let bound = MetricBound::new(&floor, &quick, swept_share(&floor, &path));
        let [length, duration] = length_and_time(&quick, &path, Vector::new(1.0, 0.0));
        assert_eq!(bound.length_m, 0.0, "it sweeps without metres: {length}");
        assert!(bound.duration_s <= duration + 0.01 && duration < 1.1 * bound.duration_s, "{bound:?} {duration}");
        // A proof for tools in the middle would be wrong here.
        let centred = RobotModel { tool: Tool::CENTRED, ..quick };
        assert!(MetricBound::new(&floor, &centred, swept_share(&floor, &path)).length_m > length);
    }

    #[test]
    fn no_mix_of_speed_and_turning_moves_the_tool_faster() {
        let mut rng = seeded(3, 0);
        for _ in 0..200 {
            let at = [rng.random_range(-0.15..0.15), rng.random_range(-0.15..0.15)];
            let robot = with_tool(at, 0.05);
            let (speed, wheel_speed) = (rng.random_range(0.1..0.3), rng.random_range(0.3..0.5));
            let most = fastest(&robot, speed, wheel_speed);
            let mut reached: f64 = 0.0;
            for (left, right) in (0..=100).flat_map(|i| (0..=100).map(move |j| (i, j))) {
                let [left, right] = [left, right].map(|i| wheel_speed * (0.02 * f64::from(i) - 1.0));
                let (ahead, turn) = (0.5 * (left + right), (right - left) / robot.wheel_base);
                if ahead.abs() <= speed {
                    reached = reached.max(math::hypot(ahead - turn * at[1], turn * at[0]));
                }
            }
            assert!(reached <= most + 1e-12 && reached > 0.97 * most, "{at:?}: {reached} of {most}");
        }
    }

    #[test]
    fn a_robot_that_keeps_its_heading_moves_as_far_as_its_tool() {
        let aside = RobotModel { wheels: WheelLayout::Omnidirectional, ..with_tool([0.08, 0.0], 0.17) };
        let centred = RobotModel { tool: Tool::CENTRED, ..aside.clone() };
        assert_eq!(MetricBound::of_area(20.0, 5.0, &aside), MetricBound::of_area(20.0, 5.0, &centred));
        assert_eq!(MetricBound::of_run(20.0, &aside), None, "a run of it may turn");
    }
}
