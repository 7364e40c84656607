//! The messages of a planned path: the robot drives it as its motion model says.

use super::{
    frames::{BASE, MAP, ODOM, compose, relative_to},
    message::{self, velocity},
    run::{Pace, SourceMap},
    topic::{self, Stamped},
};
use coverage_planners::sweep::Waypoint;
use robovac_core::{
    coverage::with_objects,
    geometry::{Pose, difference},
    robot::RobotModel,
    trajectory::DriveLimits,
};

/// Time between two poses, s.
const ODOMETRY_S: f64 = Pace::FILE.odometry_s;

/// Room, path and a drive along it without errors, from `heading` rad at its first corner.
pub fn path_topics(source: &SourceMap<'_>, heading: f64) -> Vec<Stamped> {
    let origin = source.plan.origin;
    let stops = source.places(heading);
    let Some(first) = stops.first().map(|stop| stop.pose) else { return Vec::new() };
    let mut out = vec![
        topic::MAP.stamped(0.0, message::occupancy_grid(0.0, &with_objects(source.plan), origin)),
        topic::PLAN.stamped(0.0, source.plan_of(&stops, 0.0)),
    ];
    let end_s = stops.last().map_or(0.0, |stop| stop.time);
    let samples = (end_s / ODOMETRY_S).ceil() as usize;
    let to_odom = compose(origin, first);
    let mut before = Pose::new(0.0, 0.0, 0.0);
    let (mut next, mut knot) = (0, 0);
    let smooth = source.smooth.zip(DriveLimits::of(source.robot));
    for sample in 0..=samples {
        let time_s = (sample as f64 * ODOMETRY_S).min(end_s);
        while next + 2 < stops.len() && stops[next + 1].time <= time_s {
            next += 1;
        }
        let moment = smooth.and_then(|(trajectory, limits)| trajectory.moment(time_s, &limits, knot));
        let at = match (moment, &stops[next..]) {
            (Some((last, moment)), _) => {
                knot = last;
                moment.pose
            }
            (None, [from, to, ..]) => between(from, to, time_s, source.robot),
            (None, _) => first,
        };
        let pose = relative_to(first, at);
        let now = velocity(before, pose, if sample == 0 { 0.0 } else { ODOMETRY_S });
        before = pose;
        out.push(topic::ODOM.stamped(time_s, message::odometry(time_s, ODOM, pose, now)));
        let frames = [(MAP, ODOM, to_odom), (ODOM, BASE, pose)];
        out.push(topic::TF.stamped(time_s, message::transforms(time_s, &frames)));
    }
    out
}

/// The pose between two stops at a time, from rest to rest.
fn between(from: &Waypoint, to: &Waypoint, time_s: f64, robot: &RobotModel) -> Pose {
    let since = time_s - from.time;
    let length = to.distance - from.distance;
    if length > 0.0 {
        let share = travelled(since, length, robot.cruise_speed, robot.acceleration) / length;
        let way = to.pose.position() - from.pose.position();
        let at = from.pose.position() + way * share;
        return Pose::new(at.x, at.y, to.pose.heading);
    }
    let turn = difference(from.pose.heading, to.pose.heading);
    let rim = turn.abs() * 0.5 * robot.wheel_base;
    let share = if rim > 0.0 { travelled(since, rim, robot.turn_wheel_speed, robot.acceleration) / rim } else { 1.0 };
    Pose { heading: from.pose.heading + share * turn, ..from.pose }
}

/// Distance after `time` seconds of a way of `distance` metres from rest to rest, with limited speed and acceleration:
/// as [`RobotModel::straight_time`].
fn travelled(time: f64, distance: f64, speed: f64, acceleration: f64) -> f64 {
    let ramp = (speed / acceleration).min((distance / acceleration).sqrt());
    let top = ramp * acceleration;
    let whole = distance / top + ramp;
    let time = time.clamp(0.0, whole);
    match whole - time {
        _ if time < ramp => 0.5 * acceleration * time * time,
        left if left < ramp => distance - 0.5 * acceleration * left * left,
        _ => top * (time - 0.5 * ramp),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::{
        floor_plan::room,
        geometry::Point,
        robot::model,
        trajectory::{RoundedLine, Rounding, Trajectory},
    };

    #[test]
    fn motion_ends_when_the_robot_model_says() {
        let robot = model("roomba600").unwrap();
        for distance in [0.01, 0.1, 3.0] {
            let (end, speed) = (robot.straight_time(distance), robot.cruise_speed);
            assert!((travelled(end, distance, speed, robot.acceleration) - distance).abs() < 1e-12);
            let half = travelled(0.5 * end, distance, speed, robot.acceleration);
            assert!((half - 0.5 * distance).abs() < 1e-12, "{half} of {distance}");
        }
    }

    #[test]
    fn a_smooth_path_is_driven_in_the_time_of_its_trajectory() {
        let plan = (room("bedroom").unwrap().build)();
        let robot = model("roomba600").unwrap();
        let path = [[0.5, 0.5], [1.5, 0.5], [1.5, 1.5]].map(|[x, y]| Point::new(x, y));
        let roundings = [Rounding::Stop, Rounding::Alone(0.15), Rounding::Stop];
        let limits = DriveLimits::of(robot).unwrap();
        let trajectory = Trajectory::new(&RoundedLine::new(&path, 0.0, &roundings), &limits);
        let source = SourceMap { plan: &plan, robot, path: &path, smooth: Some(&trajectory) };
        let smooth = path_topics(&source, 0.0);
        let stopping = path_topics(&SourceMap { smooth: None, ..source }, 0.0);
        let [curve_s, corner_s] = [&smooth, &stopping].map(|all| all.last().unwrap().time_s);
        assert!((curve_s - trajectory.duration_s()).abs() < 1e-9 && curve_s < corner_s - 0.5, "{curve_s} {corner_s}");
        // The plan has places along the curve, not its corner.
        let places = source.places(0.0);
        assert!(places.len() > 10 && places.iter().all(|place| (place.pose.position() - path[1]).norm() > 0.02));
    }

    #[test]
    fn a_path_without_corners_has_no_messages() {
        let plan = (room("bedroom").unwrap().build)();
        let robot = model("octagon").unwrap();
        assert!(path_topics(&SourceMap { plan: &plan, robot, path: &[], smooth: None }, 0.0).is_empty());
        let path = [Point::new(1.0, 1.0)];
        // Map, plan, and one moment.
        assert_eq!(path_topics(&SourceMap { plan: &plan, robot, path: &path, smooth: None }, 0.0).len(), 4);
    }
}
