//! Smooth trajectories as human-readable programs.

use super::{
    track::{FRAME, decimals, start_text},
    waypoints_along,
};
use robovac_core::{
    geometry::{Pose, difference},
    math,
    robot::{RobotModel, advance_sideways},
    trajectory::Trajectory,
};
use std::fmt::Write;

/// Decimals of lengths, m, of angles, degrees, and of times, s.
const DECIMALS: [usize; 3] = [5, 4, 3];
/// Turns below are none, degrees.
const STRAIGHT_ON: f64 = 0.01;

/// A program that drives `robot` along `trajectory`, like [`super::program`] but without stops from one command to the next;
/// every command has its time.
///
/// - `CURVE left 12.5 deg over 0.030 m in 0.105 s`: drives an arc that turns by that angle.
/// - `FORWARD 3.250 m in 10.833 s`: drives straight ahead.
/// - `TURN right 45.0 deg in 0.650 s`: turns on the spot, from rest to rest.
/// - `STOP`: the end, where the robot has come to rest.
///
/// `planned` names the robot that the path was planned for, in words that follow "for". Every command leads from where the
/// printed ones before it have brought the robot, so that roundings don't add up, nor do those of the times.
pub fn smooth_program(trajectory: &Trajectory, robot: &RobotModel, planned: &str) -> String {
    let places = waypoints_along(trajectory, robot);
    let mut text = String::new();
    let title = robot.title;
    let _ = writeln!(text, "; planned   for {planned}\n; robot     moves as the {title}: curves without stops");
    let _ = writeln!(text, "; frame     {FRAME}\n; units     m; s; degrees, counter-clockwise from the x axis");
    let Some(first) = places.first() else { return text + "STOP\n" };
    let _ = writeln!(
        text,
        "; start     {}\n; length    {:.3} m\n; duration  {:.1} s: speeds change evenly from command to command, and only a \
         turn begins and ends at rest",
        start_text(first.pose),
        trajectory.length_m(),
        trajectory.duration_s()
    );
    let (mut at, mut now) = (first.pose, 0.0);
    for (i, to) in places.iter().enumerate().skip(1) {
        let is_turn = to.distance == places[i - 1].distance;
        // A turn on the spot is one command.
        if is_turn && places.get(i + 1).is_some_and(|next| next.distance == to.distance) {
            continue;
        }
        let command = ProgramCommand::between(at, to.pose, is_turn);
        // Nothing to drive: the next command makes up for it.
        if !command.is_turn && command.metres <= 0.0 {
            continue;
        }
        let lasts = rounded(to.time - now, DECIMALS[2]);
        command.write(&mut text, lasts);
        (at, now) = (command.end(at), now + lasts);
    }
    text + "STOP\n"
}

/// A command as it is printed.
struct ProgramCommand {
    is_turn: bool,
    degrees: f64,
    metres: f64,
}

impl ProgramCommand {
    /// From a pose to another one, or near it.
    fn between(at: Pose, to: Pose, is_turn: bool) -> Self {
        let planned = difference(at.heading, to.heading);
        if is_turn {
            return Self { is_turn, degrees: rounded(planned.to_degrees(), DECIMALS[1]), metres: 0.0 };
        }
        let way = to.position() - at.position();
        // Half way between an arc that ends with the heading and one that ends in the place: so both get right within two commands.
        let turn = 0.5 * planned + difference(at.heading, math::atan2(way.y, way.x));
        let degrees = rounded(turn.to_degrees(), DECIMALS[1]);
        let degrees = if degrees.abs() < STRAIGHT_ON { 0.0 } else { degrees };
        let half = 0.5 * degrees.to_radians();
        let chord = way.dot(&Pose::new(0.0, 0.0, at.heading + half).direction());
        let arc = if half == 0.0 { chord } else { chord * half / math::sin(half) };
        Self { is_turn, degrees, metres: rounded(arc, DECIMALS[0]) }
    }

    fn write(&self, text: &mut String, lasts: f64) {
        let Self { is_turn, degrees, metres } = *self;
        let side = if degrees > 0.0 { "left" } else { "right" };
        let angle = decimals(degrees.abs(), 1, DECIMALS[1]);
        let length = decimals(metres, 3, DECIMALS[0]);
        // Writing to a string doesn't fail.
        let _ = match (is_turn, degrees != 0.0) {
            (true, _) => writeln!(text, "TURN {side} {angle} deg in {lasts:.3} s"),
            (false, true) => writeln!(text, "CURVE {side} {angle} deg over {length} m in {lasts:.3} s"),
            (false, false) => writeln!(text, "FORWARD {length} m in {lasts:.3} s"),
        };
    }

    /// Where it leads from a pose.
    fn end(&self, at: Pose) -> Pose {
        let turn = self.degrees.to_radians();
        // Wheels one metre apart.
        advance_sideways(at, [self.metres - 0.5 * turn, self.metres + 0.5 * turn, 0.0], 1.0)
    }
}

fn rounded(value: f64, decimals: usize) -> f64 {
    let unit = 10_f64.powi(decimals as i32);
    (value * unit).round() / unit
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sweep::{track_smooth::lanes, waypoints_along};
    use robovac_core::robot::model;

    /// Whoever executes the printed commands is on the trajectory after each, at its time. Headings are a little off, as arcs aren't
    /// clothoids.
    #[test]
    fn printed_commands_lead_along_the_trajectory() {
        let robot = model("roomba600").unwrap();
        let trajectory = lanes(40);
        let text = smooth_program(&trajectory, robot, "it");
        assert!(text.ends_with(" s\nSTOP\n") && text.contains("\nTURN ") && text.contains("\nFORWARD "), "{text}");
        let places = waypoints_along(&trajectory, robot);
        let (mut at, mut now) = (trajectory.knots()[0].pose, 0.0);
        let mut left = 0.0;
        for line in text.lines().filter(|line| !line.starts_with(';') && *line != "STOP") {
            let words: Vec<&str> = line.split(' ').collect();
            let value = |after: &str| {
                let index = words.iter().position(|word| *word == after)?;
                words[index + 1].parse::<f64>().ok()
            };
            let turn = value("left").or(value("right").map(|degrees| -degrees)).unwrap_or(0.0);
            let metres = value("over").or(value("FORWARD")).unwrap_or(0.0);
            let command = ProgramCommand { is_turn: words[0] == "TURN", degrees: turn, metres };
            (at, now) = (command.end(at), now + value("in").unwrap());
            left += metres;
            let place = places.iter().min_by(|a, b| (a.time - now).abs().total_cmp(&(b.time - now).abs())).unwrap();
            assert!((place.time - now).abs() < 1e-3, "{line}");
            assert!((place.pose.position() - at.position()).norm() < 1e-3, "{line}: {at} {}", place.pose);
            assert!(
                difference(place.pose.heading, at.heading).abs() < 3_f64.to_radians(),
                "{line}: {at} {}",
                place.pose
            );
        }
        assert!((now - trajectory.duration_s()).abs() < 1e-3 && (left - trajectory.length_m()).abs() < 0.01, "{left}");
    }

    #[test]
    fn nothing_to_drive_is_just_a_stop() {
        let text = smooth_program(&Trajectory::default(), model("roomba600").unwrap(), "it");
        assert!(text.ends_with("axis\nSTOP\n"), "{text}");
    }
}
