//! Smooth trajectories as timed Open Interface commands.

use super::path_commands::{CommandList, PERIOD, TimedCommand, text_of};
use robovac_core::{
    geometry::{Pose, difference},
    robot::{Drive, RobotModel, advance_sideways},
    trajectory::{DriveLimits, Knot, PlannedMoment, Trajectory},
};
use roomba_oi::Command;

/// How many times longer than planned all takes: wheels whose speeds are held for a while speed up more slowly.
const SLOWER: f64 = 1.02;
/// Sequences of commands that are followed at the same time, and how many of them may end with the same speeds: those that
/// differ only in what is long past would crowd out others that brake in time.
const WIDTH: (usize, usize) = (24, 3);
/// What a radian off the heading counts as, m: about what it costs until it can be corrected.
const ARM: f64 = 0.15;
/// What an error along the path counts as: it sweeps the same floor a little later.
const ALONG: f64 = 0.5;
/// What a wheel's speed other than planned counts as, s: it is an error to come.
const SPEED: f64 = 0.05;
/// What a change of a wheel's speed counts as, m²: so that files stay short where it makes no difference.
const CHANGE: f64 = 4e-7;
/// Time to come to rest where the trajectory ends, s.
const TO_REST: f64 = 0.6;

/// Commands that drive a Roomba of the 600 series along `trajectory`, without stops between curves: Start and Safe first, then
/// wheel speeds, and at the end wheel speeds of 0 and Stop. The trajectory was planned for the robot `planned_for`; if that is
/// faster than `robot`, all takes longer.
///
/// Speeds are those that the robot's controller can keep ([`RobotModel::speed_steps`]), in whole mm/s. With so few of them no
/// curve is driven exactly, so the commands are searched for. The robot stays near the trajectory, as errors don't
/// add up, unlike slip.
///
/// Each command is held until the wheels have its speeds, and each changes a wheel's speed by one step: so the wheels are later
/// than commanded, all of them by about the same time, and the path is the same whatever their acceleration, down to the robot's.
pub fn smooth_commands(trajectory: &Trajectory, planned_for: &RobotModel, robot: &RobotModel) -> Vec<TimedCommand> {
    let mut list = CommandList::begin(robot);
    if let Some(search) = WheelSearch::new(trajectory, planned_for, robot) {
        let chosen = search.run();
        for same in chosen.chunk_by(|a, b| a == b) {
            let [left, right] = same[0];
            list.send(Command::DriveDirect { right, left }, same.len() as f64 * search.tick_s, meaning(left, right));
        }
        let fastest = chosen.last().map_or(0, |last| last[0].unsigned_abs().max(last[1].unsigned_abs()));
        list.rest(fastest);
    }
    list.end()
}

/// The [`smooth_commands`] of a trajectory as a text file, like [`super::commands_text`].
pub fn smooth_commands_text(
    trajectory: &Trajectory,
    planned_for: &RobotModel,
    robot: &RobotModel,
    planned: &str,
) -> String {
    let driven = format!(
        "# driven    smoothly: the trajectory takes {:.3} s; wheel speeds change without stops\n",
        trajectory.duration_s()
    );
    let start = trajectory.knots().first().map(|knot| knot.pose);
    text_of(smooth_commands(trajectory, planned_for, robot), start, robot, planned, &driven)
}

fn meaning(left: i16, right: i16) -> String {
    let what = match (left, right) {
        (0, 0) => "stand still",
        _ if left == right && left > 0 => "forward",
        _ if left == right => "back",
        _ if left == -right && right > 0 => "turn left",
        _ if left == -right => "turn right",
        _ if right > left => "curve to the left",
        _ => "curve to the right",
    };
    format!("left wheel {left} mm/s, right wheel {right} mm/s: {what}")
}

/// A search for the wheel speeds that keep a robot nearest to a trajectory: from one tick to the next, each wheel keeps its
/// speed or takes one of the two beside it, and the best sequences are followed further (a beam search).
struct WheelSearch<'a> {
    trajectory: &'a Trajectory,
    limits: DriveLimits,
    robot: &'a RobotModel,
    /// Speeds that a wheel can keep, mm/s, ascending.
    speeds: Vec<i16>,
    /// Time between two commands, s.
    tick_s: f64,
    /// How many times longer than planned the robot takes.
    stretch: f64,
}

/// A sequence of commands, by its last one and its effect.
#[derive(Debug, Clone, Copy)]
struct WheelSequence {
    pose: Pose,
    /// Indices of the speeds of left and right wheel.
    chosen: [usize; 2],
    cost: f64,
    /// Index of the command before among all that were followed.
    before: usize,
}

impl<'a> WheelSearch<'a> {
    fn new(trajectory: &'a Trajectory, planned_for: &RobotModel, robot: &'a RobotModel) -> Option<Self> {
        let (limits, own) = (DriveLimits::of(planned_for)?, DriveLimits::of(robot)?);
        let ahead = CommandList::begin(robot).speeds(robot.max_wheel_speed);
        let mut speeds: Vec<i16> = ahead.iter().flat_map(|&speed| [speed, -speed]).chain([0]).collect();
        speeds.sort_unstable();
        let step = speeds.windows(2).map(|pair| pair[1] - pair[0]).max()?;
        let periods = (f64::from(step) * 1e-3 / robot.acceleration / PERIOD).ceil().max(1.0);
        Some(Self {
            trajectory,
            limits,
            robot,
            speeds,
            tick_s: periods * PERIOD,
            stretch: SLOWER * stretch(trajectory, &limits, &own),
        })
    }

    /// The speeds of left and right wheel, mm/s, of every tick.
    fn run(&self) -> Vec<[i16; 2]> {
        let Some(first) = self.trajectory.knots().first() else { return Vec::new() };
        let ticks = ((self.stretch * self.trajectory.duration_s() + TO_REST) / self.tick_s).ceil() as u32;
        let rest = self.speeds.len() / 2;
        let begin = WheelSequence { pose: first.pose, chosen: [rest; 2], cost: 0.0, before: 0 };
        // Of every command that was followed: the one before, and its speeds.
        let mut all = vec![(0, [rest; 2])];
        let (mut beam, mut knot) = (vec![begin], 0);
        for tick in 1..=ticks {
            let time_s = f64::from(tick) * self.tick_s / self.stretch;
            let Some((at, want)) = self.trajectory.moment(time_s, &self.limits, knot) else { break };
            knot = at;
            let mut next: Vec<WheelSequence> = beam.iter().flat_map(|from| self.further(from, &want)).collect();
            next.sort_by(|a, b| a.cost.total_cmp(&b.cost));
            let mut with = vec![0; self.speeds.len() * self.speeds.len()];
            next.retain(|&WheelSequence { chosen: [left, right], .. }| {
                let count: &mut usize = &mut with[left * self.speeds.len() + right];
                *count += 1;
                *count <= WIDTH.1
            });
            next.truncate(WIDTH.0);
            for sequence in &mut next {
                all.push((sequence.before, sequence.chosen));
                sequence.before = all.len() - 1;
            }
            beam = next;
        }
        let is_at_rest = |sequence: &&WheelSequence| sequence.chosen == [rest; 2];
        let best = beam.iter().find(is_at_rest).or(beam.first());
        let mut chosen = Vec::with_capacity(ticks as usize);
        let mut index = best.map_or(0, |best| best.before);
        while index > 0 {
            let (before, indices) = all[index];
            chosen.push(indices.map(|index| self.speeds[index]));
            index = before;
        }
        chosen.reverse();
        // Standing still is what comes afterwards anyway.
        while chosen.last() == Some(&[0; 2]) {
            chosen.pop();
        }
        chosen
    }

    /// What a sequence can become in a tick that should end at `want`.
    fn further<'b>(
        &'b self,
        from: &'b WheelSequence,
        want: &'b PlannedMoment,
    ) -> impl Iterator<Item = WheelSequence> + 'b {
        let beside = |index: usize| index.saturating_sub(1)..=(index + 1).min(self.speeds.len() - 1);
        beside(from.chosen[0])
            .flat_map(move |left| beside(from.chosen[1]).map(move |right| [left, right]))
            .map(move |chosen| self.after(from, chosen, want))
    }

    /// A sequence with another tick.
    fn after(&self, from: &WheelSequence, chosen: [usize; 2], want: &PlannedMoment) -> WheelSequence {
        let wheels = chosen.map(|index| f64::from(self.speeds[index]) * 1e-3);
        let rolled = [wheels[0] * self.tick_s, wheels[1] * self.tick_s, 0.0];
        let pose = advance_sideways(from.pose, rolled, self.robot.wheel_base);
        let (off, ahead) = (pose.position() - want.pose.position(), want.pose.direction());
        let (along, beside) = (ALONG * ahead.dot(&off), ahead.perp(&off));
        let askew = ARM * difference(want.pose.heading, pose.heading);
        let planned = Drive::from_twist(want.speed, want.turn_rate, self.robot.wheel_base).times(1.0 / self.stretch);
        let [left, right] = [SPEED * (planned.left - wheels[0]), SPEED * (planned.right - wheels[1])];
        let changes = (0..2).filter(|&side| chosen[side] != from.chosen[side]).count() as f64;
        let squares = [along, beside, askew, left, right].map(|error| error * error);
        let cost = from.cost + squares.iter().sum::<f64>() + CHANGE * changes;
        WheelSequence { pose, chosen, cost, before: from.before }
    }
}

/// How many times longer than planned a robot takes with its own limits.
fn stretch(trajectory: &Trajectory, planned: &DriveLimits, own: &DriveLimits) -> f64 {
    let wheels = |knot: &Knot| [-1.0, 1.0].map(|side| knot.speed * (1.0 + side * own.half_base * knot.curvature));
    let mut most = 1.0_f64;
    for pair in trajectory.knots().windows(2) {
        let lasts = pair[1].time_s - pair[0].time_s;
        for (from, to) in wheels(&pair[0]).into_iter().zip(wheels(&pair[1])) {
            most = most.max(to.abs() / own.wheel_speed);
            if lasts > 0.0 {
                most = most.max(((to - from).abs() / lasts / own.acceleration).sqrt());
            }
        }
    }
    if trajectory.turning_s() > 0.0 {
        let base = own.half_base / planned.half_base;
        let speed = planned.wheel_speed * base / own.wheel_speed;
        most = most.max(speed).max((planned.acceleration * base / own.acceleration).sqrt());
    }
    // Rounding of the knots' times is no difference.
    if most < 1.001 { 1.0 } else { most }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::emulator::{Emulator, personality};
    use robovac_core::{
        floor_plan::Sketch,
        geometry::Point,
        robot::model,
        trajectory::{RoundedLine, Rounding},
    };
    use robovac_sim::{
        Conditions,
        experiment::planning::{Placement, choose_robot},
    };

    /// Lanes with curves, and some turns on the spot.
    fn lanes(robot: &RobotModel) -> Trajectory {
        let x = |i: usize| if i.div_ceil(2).is_multiple_of(2) { 1.0 } else { 4.5 };
        let line: Vec<Point> = (0..24).map(|i| Point::new(x(i), 1.0 + 0.25 * (i / 2) as f64)).collect();
        let rounding = |i: usize| if i.is_multiple_of(7) { Rounding::Stop } else { Rounding::Alone(0.12) };
        let roundings: Vec<Rounding> = (0..line.len()).map(rounding).collect();
        Trajectory::new(&RoundedLine::new(&line, 0.4, &roundings), &DriveLimits::of(robot).unwrap())
    }

    /// The pose after each command by wheels that speed up by the robot's acceleration, and its time.
    fn driven(list: &[TimedCommand], start: Pose, wheel_base: f64, acceleration: f64) -> Vec<(f64, Pose)> {
        let (mut pose, mut wheels, mut wanted) = (start, [0.0; 2], [0.0; 2]);
        let mut poses = Vec::new();
        for command in list {
            if command.bytes[0] == 145 {
                let speed =
                    |at: usize| f64::from(i16::from_be_bytes([command.bytes[at], command.bytes[at + 1]])) * 1e-3;
                wanted = [speed(3), speed(1)];
            }
            for _ in 0..(command.wait_s / 1e-3).round() as u32 {
                let most = 1e-3 * acceleration;
                for side in 0..2 {
                    wheels[side] += (wanted[side] - wheels[side]).clamp(-most, most);
                }
                pose = advance_sideways(pose, [wheels[0] * 1e-3, wheels[1] * 1e-3, 0.0], wheel_base);
            }
            poses.push((command.at_s + command.wait_s, pose));
        }
        assert_eq!(wheels, [0.0; 2], "it ends standing still");
        poses
    }

    fn off_end(trajectory: &Trajectory, at: Pose) -> f64 {
        (at.position() - trajectory.knots().last().unwrap().pose.position()).norm()
    }

    #[test]
    fn wheel_speeds_lead_along_the_trajectory_in_its_time() {
        let roomba = model("roomba600").unwrap();
        let limits = DriveLimits::of(roomba).unwrap();
        let trajectory = lanes(roomba);
        let list = smooth_commands(&trajectory, roomba, roomba);
        assert_eq!((&list[0].bytes[..], &list[1].bytes[..]), (&[128][..], &[131][..]));
        assert_eq!(list[list.len() - 2].bytes, [145, 0, 0, 0, 0]);
        assert_eq!(list[list.len() - 1].bytes, [173]);
        let last = &list[list.len() - 1];
        let takes = (last.at_s + last.wait_s) / trajectory.duration_s();
        println!("{takes:.4} of {:.1} s, {} commands", trajectory.duration_s(), list.len());
        assert!((1.0..1.03).contains(&takes), "{takes}");
        let began_s = list[2].at_s;
        // Wheels that speed up at once, too.
        for acceleration in [roomba.acceleration, 1.8, 1e3] {
            let poses = driven(&list, trajectory.knots()[0].pose, roomba.wheel_base, acceleration);
            let mut beside = 0.0_f64;
            for &(now, pose) in &poses[1..] {
                let (_, want) = trajectory.moment((now - began_s) / SLOWER, &limits, 0).unwrap();
                beside = beside.max(want.pose.direction().perp(&(pose.position() - want.pose.position())).abs());
                assert!((pose.position() - want.pose.position()).norm() < 0.06, "{now} s");
            }
            let off = off_end(&trajectory, poses.last().unwrap().1);
            println!("{acceleration} m/s²: beside it by up to {beside:.4} m, off the end by {off:.4} m");
            assert!(off < 0.03 && beside < 0.02, "{off} {beside}");
        }
        for command in list.iter().filter(|command| command.bytes[0] == 145) {
            let speed = i16::from_be_bytes([command.bytes[1], command.bytes[2]]).abs();
            assert!([0, 68, 125, 182, 239, 296, 353, 410, 467].contains(&speed), "{speed}");
        }
        assert_eq!(smooth_commands(&Trajectory::default(), roomba, roomba).len(), 5);
    }

    /// The same by the emulated robot, with any wheel speed and with those that the real one keeps.
    #[test]
    fn emulated_roomba_is_as_fast_as_the_trajectory() {
        let plan = Sketch::open(6.0, 5.0, 0.05).start(1.0, 1.0, 0.0).finish("Hall", "");
        let roomba = model("roomba600").unwrap();
        let trajectory = lanes(roomba);
        let list = smooth_commands(&trajectory, roomba, roomba);
        let (robot, cell_size) = choose_robot("roomba600", &plan, None).unwrap();
        let start = trajectory.knots()[0].pose;
        let heading_deg = Some(start.heading.to_degrees());
        let placement = Placement { plan, robot, cells: cell_size.into(), start: None, heading_deg };
        for quantised in [false, true] {
            let conditions = Conditions { quantised, ..Conditions::default() };
            let run = placement.prepare().unwrap().setup(conditions, 7);
            let mut emulator = Emulator::new(&run, personality("model").unwrap());
            let from = emulator.pose().position() - start.position();
            for command in &list {
                emulator.receive(&command.bytes, 115_200);
                emulator.advance(command.wait_s);
            }
            let end = emulator.pose().position() - from;
            let off = off_end(&trajectory, Pose::new(end.x, end.y, 0.0));
            println!("off the end by {off:.4} m");
            assert!(off < 0.03, "{quantised}: {off}");
        }
    }

    /// A robot with other wheels has planned it, which are faster: the Roomba takes longer, by as much as it must.
    #[test]
    fn a_faster_robots_path_takes_longer() {
        let roomba = model("roomba600").unwrap();
        let mut fast = roomba.clone();
        (fast.cruise_speed, fast.max_wheel_speed, fast.acceleration) = (0.6, 1.0, 2.0);
        let trajectory = lanes(&fast);
        let list = smooth_commands(&trajectory, &fast, roomba);
        let last = &list[list.len() - 1];
        let takes = (last.at_s + last.wait_s) / trajectory.duration_s();
        assert!((1.5..2.3).contains(&takes), "{takes}");
        let poses = driven(&list, trajectory.knots()[0].pose, roomba.wheel_base, roomba.acceleration);
        let off = off_end(&trajectory, poses.last().unwrap().1);
        assert!(off < 0.03, "{off}");
    }
}
