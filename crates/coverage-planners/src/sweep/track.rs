//! Paths as poses for other programs.

use robovac_core::{
    geometry::{Point, Pose, difference, normalize},
    math,
    robot::{RobotModel, WheelLayout},
};
use std::fmt::Write;

/// Smallest turn, rad; smaller ones are ignored.
const STRAIGHT_ON: f64 = 1e-9;

/// The frame of all files, in words.
pub const FRAME: &str = "of the room's drawing or map, else the room's lower left corner; x to the right, y up";

/// A path through a room and its initial heading, rad, transformed into the frame of the map or drawing that the room
/// was made from, given by the room's `origin`: files that lie side by side must agree on positions.
pub fn in_frame(path: &[Point], heading: f64, origin: Pose) -> (Vec<Point>, f64) {
    (path.iter().map(|&at| origin.to_world(at)).collect(), normalize(heading + origin.heading))
}

/// Where a path begins, for the head of a file.
pub fn start_text(pose: Pose) -> String {
    let [x, y] = [pose.x, pose.y].map(|metres| decimals(metres, 3, 5));
    format!("x {x} m, y {y} m, heading {} deg", decimals(pose.heading.to_degrees(), 1, 5))
}

/// A number with at least and at most so many decimals.
pub(super) fn decimals(value: f64, least: usize, most: usize) -> String {
    let mut text = format!("{value:.most$}");
    let zeros = text.len() - text.trim_end_matches('0').len();
    text.truncate(text.len() - zeros.min(most - least));
    text
}

/// A robot's position on its path, with the time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Waypoint {
    /// In the room.
    pub pose: Pose,
    /// Driven so far, m.
    pub distance: f64,
    /// Since the start, s.
    pub time: f64,
}

/// The stops of a robot that stands at the start of `path` with `heading` rad: every corner, and those at which it
/// turns twice, before and after. Times are by its motion model, from rest to rest. A robot that moves in every
/// direction keeps its heading.
pub fn waypoints(path: &[Point], heading: f64, robot: &RobotModel) -> Vec<Waypoint> {
    let Some(&first) = path.first() else { return Vec::new() };
    let mut at = Waypoint { pose: Pose::new(first.x, first.y, heading), distance: 0.0, time: 0.0 };
    let mut stops = vec![at];
    for to in &path[1..] {
        let way = to - at.pose.position();
        let length = way.norm();
        if length <= 0.0 {
            continue;
        }
        if robot.wheels == WheelLayout::Differential {
            let towards = math::atan2(way.y, way.x);
            let turn = difference(at.pose.heading, towards);
            if turn.abs() > STRAIGHT_ON {
                at.time += robot.turn_time(turn);
                at.pose.heading = towards;
                stops.push(at);
            }
        }
        at.pose = Pose::new(to.x, to.y, at.pose.heading);
        at.distance += length;
        at.time += robot.straight_time(length);
        stops.push(at);
    }
    stops
}

/// A path as a table: `x_m,y_m,heading_rad,distance_m,time_s`, headings counter-clockwise from +x, one line for each of
/// `places`.
pub fn to_csv(places: &[Waypoint]) -> String {
    let mut text = "x_m,y_m,heading_rad,distance_m,time_s\n".to_owned();
    for Waypoint { pose, distance, time } in places {
        let _ = writeln!(text, "{:.4},{:.4},{:.6},{distance:.4},{time:.3}", pose.x, pose.y, pose.heading);
    }
    text
}

/// A path in the map's frame as a `nav_msgs/Path` in YAML, as accepted by `ros2 topic pub`: frame `map`, REP 103. The
/// stamps of the poses are seconds from the start.
pub fn to_ros_path(places: &[Waypoint]) -> String {
    let mut text = "header:\n  stamp: {sec: 0, nanosec: 0}\n  frame_id: map\n".to_owned();
    text += if places.is_empty() { "poses: []\n" } else { "poses:\n" };
    for Waypoint { pose, time, .. } in places {
        let (sin, cos) = math::sin_cos(0.5 * normalize(pose.heading));
        let nanoseconds = (time * 1e9).round() as u64;
        let (sec, nanosec) = (nanoseconds / 1_000_000_000, nanoseconds % 1_000_000_000);
        let _ = writeln!(
            text,
            "- header:\n    stamp: {{sec: {sec}, nanosec: {nanosec}}}\n    frame_id: map\n  pose:\n    \
             position: {{x: {:.4}, y: {:.4}, z: 0.0}}\n    orientation: {{x: 0.0, y: 0.0, z: {sin:.9}, w: {cos:.9}}}",
            pose.x, pose.y
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::robot::model;

    fn corner() -> Vec<Point> {
        vec![Point::new(1.0, 1.0), Point::new(3.0, 1.0), Point::new(3.0, 1.0), Point::new(3.0, 2.0)]
    }

    #[test]
    fn table_has_a_line_for_every_stop() {
        let roomba = model("roomba600").unwrap();
        let table = to_csv(&waypoints(&corner(), 0.0, roomba));
        let lines: Vec<&str> = table.lines().collect();
        assert_eq!(lines.len(), 5, "{table}");
        assert_eq!(lines[1], "1.0000,1.0000,0.000000,0.0000,0.000");
        assert!(lines[3].starts_with("3.0000,1.0000,1.570796,2.0000,"));
        let time: f64 = lines[4].rsplit(',').next().unwrap().parse().unwrap();
        let expected = roomba.straight_time(2.0) + roomba.turn_time(math::FRAC_PI_2) + roomba.straight_time(1.0);
        assert!((time - expected).abs() < 1e-3);
        // The octagon keeps its heading.
        let table = to_csv(&waypoints(&corner(), 0.0, model("octagon").unwrap()));
        assert_eq!(table.lines().count(), 4);
        assert!(table.lines().skip(1).all(|line| line.contains(",0.000000,")), "{table}");
    }

    #[test]
    fn poses_are_in_the_map_frame() {
        let roomba = model("roomba600").unwrap();
        let (path, heading) = in_frame(&corner(), 0.0, Pose::new(-5.0, 2.0, math::FRAC_PI_2));
        let text = to_ros_path(&waypoints(&path, heading, roomba));
        // A quarter turn takes (1, 1) to (-1, 1), and half the heading has the sine of half the square root of 2.
        assert!(text.contains("position: {x: -6.0000, y: 3.0000, z: 0.0}"), "{text}");
        assert!(text.contains("orientation: {x: 0.0, y: 0.0, z: 0.707106781, w: 0.707106781}"), "{text}");
        assert!(text.starts_with("header:\n  stamp: {sec: 0, nanosec: 0}\n  frame_id: map\nposes:\n- header:\n"));
        assert!(to_ros_path(&[]).ends_with("poses: []\n"));
        // The table agrees.
        assert!(to_csv(&waypoints(&path, heading, roomba)).contains("\n-6.0000,3.0000,1.570796,0.0000,0.000\n"));
    }

    #[test]
    fn frame_of_a_room_without_a_map_changes_nothing() {
        assert_eq!(in_frame(&corner(), 1.0, Pose::new(0.0, 0.0, 0.0)), (corner(), 1.0));
    }
}
