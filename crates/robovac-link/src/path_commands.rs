//! Paths as timed Open Interface commands.
//!
//! Robots of the 600 series have no script commands (opcodes 152 to 158 are the Create's of 2006), and drive on until
//! the next command: so a path is a list of timed commands.

use coverage_planners::sweep::{FRAME, start_text};
use robovac_core::{
    cspace::Outline,
    geometry::{Point, Pose, Vector, difference},
    math,
    robot::RobotModel,
};
use roomba_oi::{Command, MAX_WRITTEN};
use std::fmt::Write;

/// Update period of the robot, in which it processes commands (Open Interface, "Serial port"); times between commands
/// are multiples of it.
pub(super) const PERIOD: f64 = 0.015;
/// Time for a change of mode, s (ours).
const MODE_CHANGE: f64 = 2.0 * PERIOD;
/// Rest after every move, beyond the stopping time of the motion model, s (ours).
const REST: f64 = 2.0 * PERIOD;
/// Smallest turn and distance, rad and m; less than one period at the slowest speed.
const LEAST_TURN: f64 = 0.002;
const LEAST_WAY: f64 = 0.002;
/// The slowest speed considered, as a share of the fastest.
const SLOWEST: f64 = 0.35;
/// Accepted error of a straight move, m (ours); beyond it slower speeds are tried. Turns end as near as possible, as
/// their error grows with the distance driven afterwards.
const NEAR: f64 = 1e-3;

/// Bytes to be sent to a robot.
#[derive(Debug, Clone, PartialEq)]
pub struct TimedCommand {
    /// Time from the first command, s.
    pub at_s: f64,
    /// Time until the next command, s.
    pub wait_s: f64,
    /// The bytes of one command.
    pub bytes: Vec<u8>,
    /// Its meaning.
    pub meaning: String,
}

impl TimedCommand {
    /// Whether it turns the wheels.
    fn is_motion(&self) -> bool {
        self.bytes.len() == 5 && self.bytes[1..] != [0; 4]
    }
}

/// Commands that drive a Roomba of the 600 series along `path` from `heading` rad: Start and Safe first, then a turn on
/// the spot and a straight move for every piece, each ended by wheel speeds of 0; then Stop.
///
/// Speeds are those that the robot's controller can keep ([`RobotModel::speed_steps`]), in whole mm/s, and every time
/// is distance by speed, as uniform acceleration and braking compensate each other. As times are whole periods, a move
/// ends up to 2 mm or a quarter of a degree off; the next one starts from there, so that these errors don't add up,
/// unlike slip. Slower speeds are chosen for turns that end nearer, and for moves that would end more than a millimetre
/// off. After every move the robot waits until its wheels rest, so this takes longer than by the motion model.
pub fn commands(path: &[Point], heading: f64, robot: &RobotModel) -> Vec<TimedCommand> {
    let mut list = CommandList::begin(robot);
    if let Some(&first) = path.first() {
        let mut pose = Pose::new(first.x, first.y, heading);
        for to in &path[1..] {
            let way = to - pose.position();
            if way.norm() < LEAST_WAY {
                continue;
            }
            let turn = difference(pose.heading, math::atan2(way.y, way.x));
            pose = Pose::new(pose.x, pose.y, pose.heading + list.turn(turn));
            // The remaining distance in the present heading.
            let driven = list.forward(way.dot(&pose.direction()));
            let moved: Vector = pose.direction() * driven;
            pose = Pose::new(pose.x + moved.x, pose.y + moved.y, pose.heading);
        }
    }
    list.end()
}

/// The [`commands`] of a path as a text file: time, bytes in hexadecimal, meaning. `planned` names the robot that the
/// path was planned for, in words that follow "for"; `robot` is the one that executes them.
pub fn commands_text(path: &[Point], heading: f64, robot: &RobotModel, planned: &str) -> String {
    let start = path.first().map(|at| Pose::new(at.x, at.y, heading));
    text_of(commands(path, heading, robot), start, robot, planned, "")
}

/// Commands as a text file; `driven` are more lines of its head.
pub(super) fn text_of(
    commands: Vec<TimedCommand>,
    start: Option<Pose>,
    robot: &RobotModel,
    planned: &str,
    driven: &str,
) -> String {
    let start = start.map(start_text);
    let duration = commands.last().map_or(0.0, |last| last.at_s + last.wait_s);
    let moves: f64 = commands.iter().filter(|command| command.is_motion()).map(|command| command.wait_s).sum();
    let body = Outline::of(robot).to_string();
    let differs = if planned.contains(&body) {
        ""
    } else {
        "#           not the robot that the path was planned for: test it where nothing can be damaged\n"
    };
    let mut text = format!(
        "# planned   for {planned}\n\
         # runs on   {}, {body}; 115200 baud\n\
         {differs}\
         {driven}\
         # frame     {FRAME}\n\
         # units     s, mm/s, m, degrees (left is counter-clockwise)\n\
         # start     {}\n\
         # duration  {duration:.3} s: {moves:.3} s of moves, {:.3} s of waiting for modes and standstill\n\
         # Send the bytes of each line at its time; the robot keeps driving until the next.\n\
         # time  bytes            meaning\n",
        robot.title,
        start.as_deref().unwrap_or("none: there is no path"),
        duration - moves
    );
    for TimedCommand { at_s, bytes, meaning, .. } in commands {
        let hex: Vec<String> = bytes.iter().map(|byte| format!("{byte:02X}")).collect();
        let _ = writeln!(text, "{at_s:.3}  {:15}  {meaning}", hex.join(" "));
    }
    text
}

/// A list under construction.
pub(super) struct CommandList<'a> {
    robot: &'a RobotModel,
    commands: Vec<TimedCommand>,
    now: f64,
}

impl<'a> CommandList<'a> {
    /// The list for a robot, which starts the interface.
    pub(super) fn begin(robot: &'a RobotModel) -> Self {
        let mut list = Self { robot, commands: Vec::new(), now: 0.0 };
        list.send(Command::Start, MODE_CHANGE, "start the interface".to_owned());
        list.send(Command::Safe, MODE_CHANGE, "safe mode: the robot stops at cliffs and when lifted".to_owned());
        list
    }

    /// The commands, with a last stop.
    pub(super) fn end(mut self) -> Vec<TimedCommand> {
        self.send(Command::DriveDirect { right: 0, left: 0 }, PERIOD, "stand still".to_owned());
        self.send(Command::Stop, MODE_CHANGE, "end the interface".to_owned());
        self.commands
    }

    pub(super) fn send(&mut self, command: Command<'_>, wait_s: f64, meaning: String) {
        let mut buffer = [0; MAX_WRITTEN];
        // All speeds are within the limits.
        if let Ok(bytes) = command.encode(&mut buffer) {
            self.commands.push(TimedCommand { at_s: self.now, wait_s, bytes: bytes.to_vec(), meaning });
            self.now += wait_s;
        }
    }

    /// Turns on the spot by about `angle` rad; returns the actual angle.
    fn turn(&mut self, angle: f64) -> f64 {
        let half = 0.5 * self.robot.wheel_base;
        let Some(mut go) = self.choose(angle.abs() * half, self.robot.turn_wheel_speed, 0.0) else { return 0.0 };
        if angle.abs() < LEAST_TURN {
            return 0.0;
        }
        let turned = go.travel() / half;
        let side = if angle > 0.0 { "left" } else { "right" };
        if angle < 0.0 {
            go.speed = -go.speed;
        }
        let meaning = format!("turn {side} {:.1} degrees", turned.to_degrees());
        self.go(Command::DriveDirect { right: go.speed, left: -go.speed }, &go, meaning);
        turned.copysign(angle)
    }

    /// Drives straight ahead for about `length` metres; returns the actual distance.
    fn forward(&mut self, length: f64) -> f64 {
        if length < LEAST_WAY {
            return 0.0;
        }
        let Some(go) = self.choose(length, self.robot.cruise_speed, NEAR) else { return 0.0 };
        let counts = go.travel() * self.robot.counts_per_metre;
        let meaning = format!("forward {:.3} m, {counts:.0} encoder counts", go.travel());
        self.go(Command::DriveDirect { right: go.speed, left: go.speed }, &go, meaning);
        go.travel()
    }

    /// A move with a rest after it.
    fn go(&mut self, command: Command<'_>, go: &Go, meaning: String) {
        self.send(command, f64::from(go.periods) * PERIOD, meaning);
        self.rest(go.speed.unsigned_abs());
    }

    /// Stops, and waits for wheels of `speed` mm/s to stand still.
    pub(super) fn rest(&mut self, speed: u16) {
        let slowing = f64::from(speed) * 1e-3 / self.robot.acceleration;
        let rest = ((slowing + REST) / PERIOD).ceil() * PERIOD;
        self.send(Command::DriveDirect { right: 0, left: 0 }, rest, "stand still".to_owned());
    }

    /// The fastest speed, with its time, whose error to a wheel's `travel` is at most `near`, or else the one with the
    /// least error; m.
    fn choose(&self, travel: f64, limit: f64, near: f64) -> Option<Go> {
        let speeds = self.speeds(limit);
        // A wheel that doesn't reach its speed falls behind by more than it makes up.
        let slowest = speeds.last().copied()?;
        let reached = |&speed: &i16| {
            let metres = f64::from(speed) * 1e-3;
            speed == slowest || travel >= metres * metres / self.robot.acceleration
        };
        let fastest = speeds.iter().copied().find(reached)?;
        let good =
            speeds.into_iter().filter(|&speed| speed <= fastest && f64::from(speed) >= SLOWEST * f64::from(fastest));
        let tries = good.map(|speed| {
            let periods = (travel / (f64::from(speed) * 1e-3 * PERIOD)).round().max(1.0) as u32;
            Go { speed, periods }
        });
        let off = |go: &Go| ((go.travel() - travel).abs().max(near) * 1e4).round() as u64;
        tries.min_by_key(off)
    }

    /// Speeds in whole mm/s that the controller can keep, from `limit` m/s downwards.
    pub(super) fn speeds(&self, limit: f64) -> Vec<i16> {
        let [smallest, step] = self.robot.speed_steps.map(|speed| speed * 1e3);
        let most = (limit * 1e3 + 1e-6) as i16;
        if step <= 0.0 {
            return (1..=8).rev().map(|eighths| (most / 8 * eighths).max(1)).collect();
        }
        let kept = (1..=(f64::from(most) / step) as u32).rev().map(|steps| smallest + f64::from(steps) * step);
        // The controller rounds steps of half a millimetre up, to the next but one.
        kept.filter(|v| (v - v.round()).abs() < 1e-6 && *v <= f64::from(most) + 1e-6)
            .map(|v| v.round() as i16)
            .collect()
    }
}

/// A wheel's speed, mm/s, and its duration in periods.
#[derive(Debug, Clone, Copy)]
struct Go {
    speed: i16,
    periods: u32,
}

impl Go {
    /// Distance of the wheel, m.
    fn travel(&self) -> f64 {
        f64::from(self.speed.unsigned_abs()) * 1e-3 * f64::from(self.periods) * PERIOD
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use robovac_core::robot::model;

    fn square() -> Vec<Point> {
        [(1.0, 1.0), (3.25, 1.0), (3.25, 2.0), (1.0, 2.0), (1.0, 1.2)].map(|(x, y)| Point::new(x, y)).to_vec()
    }

    #[test]
    fn first_is_never_motion_and_last_is_a_stop() {
        let roomba = model("roomba600").unwrap();
        for path in [square(), Vec::new(), vec![Point::origin()]] {
            let list = commands(&path, 0.7, roomba);
            assert_eq!((&list[0].bytes[..], &list[1].bytes[..]), (&[128][..], &[131][..]));
            assert_eq!(list[list.len() - 2].bytes, [145, 0, 0, 0, 0]);
            assert_eq!(list[list.len() - 1].bytes, [173]);
            for pair in list.windows(2) {
                assert!((pair[0].at_s + pair[0].wait_s - pair[1].at_s).abs() < 1e-9);
                // Motion is followed by a stop.
                assert!(!pair[0].is_motion() || !pair[1].is_motion());
            }
        }
    }

    #[test]
    fn speeds_are_those_that_the_controller_keeps() {
        let list = commands(&square(), 0.0, model("roomba600").unwrap());
        for command in list.iter().filter(|command| command.bytes[0] == 145) {
            let speed = i16::from_be_bytes([command.bytes[1], command.bytes[2]]).abs();
            assert!([0, 68, 125, 182, 239, 296].contains(&speed), "{speed}");
        }
        let text = commands_text(&square(), 0.0, model("roomba600").unwrap(), "an octagon, 0.400 m wide");
        assert!(
            text.starts_with(
                "# planned   for an octagon, 0.400 m wide\n# runs on   Roomba 600 / Create 2, a circle of "
            )
        );
        assert!(text.contains("not the robot"));
        assert!(text.contains("\n# start     x 1.000 m, y 1.000 m, heading 0.0 deg\n"), "{text}");
        assert!(text.contains("\n0.000  80               start the interface\n"), "{text}");
        // Half a millimetre short, and faster than one that ends nearer.
        assert!(text.contains("forward 2.250 m, 5060 encoder counts"), "{text}");
    }
}
