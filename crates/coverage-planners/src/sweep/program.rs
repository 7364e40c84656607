//! Paths as human-readable programs (001, section 2: "robot language command is generated for the sweeping motion").

use super::track::{FRAME, Waypoint, start_text, waypoints};
use robovac_core::{
    cspace::Outline,
    geometry::{Point, difference},
    math,
    robot::{RobotModel, WheelLayout},
};
use std::fmt::Write;

/// Smallest angle that is printed, degrees.
const LEAST_TURN: f64 = 0.05;

/// A robot model in words that follow "for": `the Omnidirectional octagon, an octagon, 0.360 m wide`.
pub fn planned_for(robot: &RobotModel) -> String {
    format!("the {}, {}", robot.title, Outline::of(robot))
}

/// A program that drives a robot along `path` from `heading` rad, in a format of our own: one command per line, in
/// order, each from rest to rest; `;` begins a comment.
///
/// - `TURN left 90.0 deg`, `TURN right 45.0 deg`: turns on the spot.
/// - `FORWARD 3.250 m`: drives straight ahead.
/// - `MOVE 3.250 m at 90.0 deg`: moves straight without turning, at an angle to where it looks, counter-clockwise;
///   robots that move in every direction do this instead of the other two.
/// - `STOP`: the end.
///
/// `planned` names the robot that the path was planned for, in words that follow "for"; `robot` is the one that moves
/// along it and whose speeds give the duration.
///
/// Angles and lengths are rounded so that their sums are never off by more than one rounding.
///
/// ```
/// use coverage_planners::sweep::program;
/// use robovac_core::{geometry::Point, robot::model};
/// let path = [Point::new(1.0, 1.0), Point::new(3.25, 1.0), Point::new(3.25, 2.0)];
/// let text = program(&path, 0.0, model("roomba600").unwrap(), "a circle");
/// let commands: Vec<&str> = text.lines().filter(|line| !line.starts_with(';')).collect();
/// assert_eq!(commands, ["FORWARD 2.250 m", "TURN left 90.0 deg", "FORWARD 1.000 m", "STOP"]);
/// ```
pub fn program(path: &[Point], heading: f64, robot: &RobotModel, planned: &str) -> String {
    let stops = waypoints(path, heading, robot);
    let mut text = String::new();
    let is_free = robot.wheels == WheelLayout::Omnidirectional;
    let how = if is_free { "moves in any direction without turning" } else { "turns on the spot, drives forward" };
    let _ = writeln!(text, "; planned   for {planned}\n; robot     moves as the {}: {how}", robot.title);
    let _ = writeln!(text, "; frame     {FRAME}\n; units     m; degrees, counter-clockwise from the x axis");
    if let (Some(first), Some(last)) = (stops.first(), stops.last()) {
        let _ = writeln!(
            text,
            "; start     {}\n; length    {:.3} m\n; duration  {:.1} s: every \
             command at the robot's usual speed and acceleration, from rest to rest;\n;           Open Interface bytes \
             of the same path take longer, as a Roomba turns before every move and\n;           waits after every move",
            start_text(first.pose),
            last.distance,
            last.time
        );
    }
    // The printed totals: tenths of a degree, millimetres.
    let (mut turned, mut driven) = ((heading.to_degrees() * 10.0).round() / 10.0, 0.0);
    for pair in stops.windows(2) {
        let (Waypoint { pose: from, .. }, Waypoint { pose: to, distance, .. }) = (pair[0], pair[1]);
        let way = to.position() - from.position();
        if way.norm() <= 0.0 {
            let turn = difference(turned.to_radians(), to.heading).to_degrees();
            let angle = (turn.abs() * 10.0).round() / 10.0;
            if angle > LEAST_TURN {
                let side = if turn > 0.0 { "left" } else { "right" };
                turned += angle.copysign(turn);
                let _ = writeln!(text, "TURN {side} {angle:.1} deg");
            }
            continue;
        }
        let metres = ((distance - driven) * 1000.0).round() / 1000.0;
        driven += metres;
        if is_free {
            let angle = difference(from.heading, math::atan2(way.y, way.x)).to_degrees();
            let _ = writeln!(text, "MOVE {metres:.3} m at {angle:.1} deg");
        } else {
            let _ = writeln!(text, "FORWARD {metres:.3} m");
        }
    }
    text + "STOP\n"
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::robot::model;

    #[test]
    fn octagon_moves_without_turning() {
        let path = [Point::new(1.0, 1.0), Point::new(3.0, 1.0), Point::new(3.0, 0.5), Point::new(1.0, 0.5)];
        let text = program(&path, 0.0, model("octagon").unwrap(), "an octagon");
        assert!(
            text.ends_with("MOVE 2.000 m at 0.0 deg\nMOVE 0.500 m at -90.0 deg\nMOVE 2.000 m at 180.0 deg\nSTOP\n"),
            "{text}"
        );
        assert!(text.starts_with(
            "; planned   for an octagon\n; robot     moves as the Omnidirectional octagon: moves \
            in any direction without turning\n; frame"
        ));
        assert!(text.contains("; length    4.500 m\n"));
    }

    #[test]
    fn rounding_never_adds_up() {
        // Three hundred pieces that turn by 1.04 degrees each.
        let mut path = vec![Point::origin()];
        for i in 0..300 {
            let (sin, cos) = math::sin_cos((1.04 * f64::from(i)).to_radians());
            path.push(path[path.len() - 1] + 0.100_4 * robovac_core::geometry::Vector::new(cos, sin));
        }
        let text = program(&path, 0.0, model("roomba600").unwrap(), "it");
        let value = |line: &str, word: usize| line.split(' ').nth(word).unwrap().parse::<f64>().unwrap();
        let turned: f64 = text.lines().filter(|l| l.starts_with("TURN left")).map(|l| value(l, 2)).sum();
        let driven: f64 = text.lines().filter(|l| l.starts_with("FORWARD")).map(|l| value(l, 1)).sum();
        assert!((turned - 299.0 * 1.04).abs() < 0.06 && (driven - 30.12).abs() < 6e-4, "{turned} {driven}");
    }

    #[test]
    fn nothing_to_drive_is_just_a_stop() {
        assert!(program(&[], 0.0, model("roomba600").unwrap(), "it").ends_with("STOP\n"));
        assert!(program(&[Point::origin()], 1.0, model("roomba600").unwrap(), "it").ends_with("move\nSTOP\n"));
    }
}
