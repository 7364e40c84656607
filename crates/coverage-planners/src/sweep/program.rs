//! Paths as human-readable programs (001, section 2: "robot language command is generated for the sweeping motion").

use super::track::{FRAME, decimals, start_text, waypoints};
use robovac_core::{
    cspace::Outline,
    geometry::{Point, Pose, difference},
    math,
    robot::{RobotModel, WheelLayout},
};
use std::fmt::Write;

/// Decimals of lengths, m, and of angles, degrees: a move of 100 m ends within a tenth of a millimetre.
const DECIMALS: [usize; 2] = [4, 5];

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
/// Every command leads from where the printed ones before it have brought the robot, so roundings don't add up: it
/// stays nearer to the path than [`super::CLEARANCE`].
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
    let Some(&first) = path.first() else { return text + "STOP\n" };
    let mut at = Pose::new(first.x, first.y, heading);
    let rounded = |value: f64, decimals: usize| {
        let unit = 10_f64.powi(decimals as i32);
        (value * unit).round() / unit
    };
    for &to in &path[1..] {
        let way = to - at.position();
        let towards = difference(at.heading, math::atan2(way.y, way.x)).to_degrees();
        let angle = rounded(towards, DECIMALS[1]);
        let heading = at.heading + angle.to_radians();
        let metres = rounded(way.dot(&Pose::new(0.0, 0.0, heading).direction()), DECIMALS[0]);
        // Nothing to drive: the next command makes up for it.
        if metres <= 0.0 {
            continue;
        }
        let length = decimals(metres, 3, DECIMALS[0]);
        let degrees = decimals(if is_free { angle } else { angle.abs() }, 1, DECIMALS[1]);
        if is_free {
            let _ = writeln!(text, "MOVE {length} m at {degrees} deg");
        } else {
            if angle != 0.0 {
                let side = if angle > 0.0 { "left" } else { "right" };
                let _ = writeln!(text, "TURN {side} {degrees} deg");
            }
            let _ = writeln!(text, "FORWARD {length} m");
            at.heading = heading;
        }
        let moved = at.position() + metres * Pose::new(0.0, 0.0, heading).direction();
        (at.x, at.y) = (moved.x, moved.y);
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

    /// Three hundred pieces that turn by 1.04 degrees each: whoever executes the commands comes by every corner.
    #[test]
    fn rounding_never_adds_up() {
        let mut path = vec![Point::new(0.123_456, 1.0)];
        for i in 0..300 {
            path.push(
                path[path.len() - 1] + 0.100_4 * Pose::new(0.0, 0.0, (1.04 * f64::from(i)).to_radians()).direction(),
            );
        }
        for id in ["roomba600", "octagon"] {
            let text = program(&path, 0.0, model(id).unwrap(), "it");
            let value = |line: &str, word: usize| line.split(' ').nth(word).unwrap().parse::<f64>().unwrap();
            let mut at = Pose::new(path[0].x, path[0].y, 0.0);
            let mut corners = path[1..].iter();
            for line in text.lines() {
                let (metres, heading) = match line.split(' ').next().unwrap() {
                    "TURN" => {
                        let side = if line.contains("left") { 1.0 } else { -1.0 };
                        at.heading += side * value(line, 2).to_radians();
                        continue;
                    }
                    "FORWARD" => (value(line, 1), at.heading),
                    "MOVE" => (value(line, 1), value(line, 4).to_radians()),
                    _ => continue,
                };
                let moved = at.position() + metres * Pose::new(0.0, 0.0, heading).direction();
                (at.x, at.y) = (moved.x, moved.y);
                assert!((moved - corners.next().unwrap()).norm() < crate::sweep::CLEARANCE, "{line}");
            }
            assert_eq!(corners.next(), None);
        }
    }

    #[test]
    fn nothing_to_drive_is_just_a_stop() {
        assert!(program(&[], 0.0, model("roomba600").unwrap(), "it").ends_with("STOP\n"));
        assert!(program(&[Point::origin()], 1.0, model("roomba600").unwrap(), "it").ends_with("move\nSTOP\n"));
    }
}
