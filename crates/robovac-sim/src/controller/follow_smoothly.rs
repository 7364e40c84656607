//! Drives a planned trajectory by dead reckoning.

use super::{Controller, FollowPath};
use robovac_core::{
    geometry::{Pose, Vector, difference},
    math,
    robot::{Drive, RobotModel, SensorReadings},
    trajectory::{DriveLimits, Knot, Trajectory},
};
use std::sync::Arc;

/// A run from rest to rest, or a turn, counts as done when this much wheel travel is left, m.
const CLOSE_ENOUGH: f64 = 0.001;
/// Correction of the curvature per metre beside the path, 1/m², and per radian off its heading, 1/m: the robot is back on the
/// path after about 0.3 m, without swinging (critical damping).
const STEER: [f64; 2] = [60.0, 15.5];
/// Most correction of the turn rate, rad/s.
const MOST_STEER: f64 = 1.5;
/// Farthest beside the path, m, and off its heading, rad, before it stops and turns to the next corner.
const LOST: [f64; 2] = [0.03, 0.5];
/// The same for going over to the trajectory on a straight piece.
const ON_PATH: [f64; 2] = [0.01, 0.05];
/// Least speed of wheels before an end, m/s: motor controllers don't keep slower ones.
const LEAST_SPEED: f64 = 0.015;
/// Time that a knot may take beyond three times its own, s.
const PATIENCE: f64 = 3.0;

/// Follows a trajectory: the curvature and speed of the nearest point of the path, and a correction by the distance and heading
/// from it (after Kanayama et al., A stable tracking control method for an autonomous mobile robot, ICRA 1990, with the speed as
/// a function of the way instead of the time).
///
/// Bumps, edges and whatever else takes it off the path are left to a [`FollowPath`] on the same line, until this drives
/// straight along a piece of the trajectory again.
#[derive(Debug, Clone)]
pub struct FollowSmoothly {
    /// Keeps the estimate, and drives while the trajectory can't be followed.
    inner: FollowPath,
    trajectory: Arc<Trajectory>,
    limits: DriveLimits,
    top_wheel_speed: f64,
    /// Index of the knot that was passed last.
    at: usize,
    is_tracking: bool,
    /// About the present speed, m/s, and wheel speed in a turn: the last commanded ones, as far as the wheels can follow.
    speed: f64,
    spin: f64,
    /// The last estimate: unchanged if the wheels are at rest.
    last: Pose,
    /// Seconds left to reach the next knot.
    patience: f64,
}

impl FollowSmoothly {
    /// Follows `trajectory`, which rounds corners of the line of `inner`. `None` for a robot that isn't a differential drive.
    pub fn new(robot: &RobotModel, inner: FollowPath, trajectory: Arc<Trajectory>) -> Option<Self> {
        let limits = DriveLimits::of(robot)?;
        let is_tracking = trajectory.knots().len() > 1;
        Some(Self {
            trajectory,
            limits,
            top_wheel_speed: robot.max_wheel_speed,
            at: 0,
            is_tracking,
            speed: 0.0,
            spin: 0.0,
            last: inner.pose(),
            patience: PATIENCE,
            inner,
        })
    }

    /// The knot passed last and the next one.
    fn stretch(&self) -> Option<[Knot; 2]> {
        let knots = self.trajectory.knots();
        Some([*knots.get(self.at)?, *knots.get(self.at + 1)?])
    }

    /// Whether the robot must react to something; if so, it leaves the trajectory.
    fn is_interrupted(&mut self, sensed: &SensorReadings) -> bool {
        let Some([a, b]) = self.stretch() else { return false };
        let is_turn = a.distance_m == b.distance_m;
        // On a dock, whose ramp is black, all cliff sensors report an edge.
        let sees_edge = sensed.sees_cliff() && !sensed.battery.on_dock;
        let is_stopped = sensed.wheel_dropped() || sees_edge;
        if !is_stopped && (is_turn || !(sensed.bumped() || sensed.virtual_wall)) {
            return false;
        }
        self.is_tracking = false;
        let heading = is_turn.then_some(b.pose.heading);
        // The way back is along the heading: in a curve, only a little of it is the way that it has come.
        let pose = self.inner.pose();
        let known = if a.curvature == 0.0 && b.curvature == 0.0 { self.straight_behind(pose) } else { 0.04 };
        let began = pose.position() - pose.direction() * known;
        let corner = self.corner_ahead(b, pose);
        self.inner.take_over(corner, began, heading);
        true
    }

    /// Length of the straight way that it has come, m, as far as it matters.
    fn straight_behind(&self, pose: Pose) -> f64 {
        let knots = &self.trajectory.knots()[..=self.at];
        let first = knots.iter().rev().take_while(|knot| knot.curvature == 0.0 && difference(knot.pose.heading, pose.heading).abs() < 0.2);
        first.map(|knot| (knot.pose.position() - pose.position()).norm()).fold(0.0, f64::max)
    }

    /// Number of the corner to drive to: in the second half of a curve the one after it.
    fn corner_ahead(&self, knot: Knot, pose: Pose) -> usize {
        let knots = self.trajectory.knots();
        let curve = knots[self.at..].iter().take_while(|next| next.corner == knot.corner);
        let is_leaving = knot.curvature != 0.0
            && curve.clone().all(|next| next.curvature.abs() <= knot.curvature.abs())
            && curve.last().is_some_and(|end| difference(pose.heading, end.pose.heading).abs() < 1.0);
        knot.corner + usize::from(is_leaving)
    }

    /// Gives the trajectory up for now: stops, and drives to the next corner.
    fn leave(&mut self) {
        self.is_tracking = false;
        eprintln!("DBG leave at {:?} {} {:?}", self.stretch().map(|s| s[1].corner), self.patience, self.inner.pose());
        if let Some([_, b]) = self.stretch() {
            let corner = self.corner_ahead(b, self.inner.pose());
            self.inner.take_over_at_rest(corner);
        }
    }

    fn pass(&mut self) {
        self.at += 1;
        if let Some([a, b]) = self.stretch() {
            self.patience = PATIENCE + 3.0 * (b.time_s - a.time_s);
        }
    }

    /// One step along the trajectory.
    fn track(&mut self, dt_s: f64) -> Drive {
        self.patience -= dt_s;
        if self.patience < 0.0 {
            self.leave();
            return Drive::STOP;
        }
        let pose = self.inner.pose();
        while let Some([a, b]) = self.stretch() {
            let length = b.distance_m - a.distance_m;
            if length <= 0.0 {
                match self.turn(pose, [a, b], dt_s) {
                    Some(drive) => return drive,
                    None => self.pass(),
                }
                continue;
            }
            let done = self.share(pose, [a, b]);
            let margin = if b.speed == 0.0 { CLOSE_ENOUGH / length } else { 0.0 };
            if done < 1.0 - margin {
                return self.go(pose, [a, b], done.max(0.0), dt_s);
            }
            if b.speed == 0.0 && !self.has_stopped(dt_s) {
                return Drive::STOP;
            }
            self.pass();
        }
        self.inner.finish();
        Drive::STOP
    }

    /// The share of the way between two knots at which the least wheel travel takes the robot to the path: in tight curves its
    /// heading tells more than its place.
    fn share(&self, pose: Pose, [a, b]: [Knot; 2]) -> f64 {
        let (way, turn): (Vector, f64) =
            (b.pose.position() - a.pose.position(), difference(a.pose.heading, b.pose.heading));
        let (come, turned) = (pose.position() - a.pose.position(), difference(a.pose.heading, pose.heading));
        let square = self.limits.half_base * self.limits.half_base;
        (come.dot(&way) + square * turned * turn) / (way.norm_squared() + square * turn * turn)
    }

    /// Whether the wheels are at rest: what one does before would carry the robot off the path, as wheels that accelerate as fast
    /// as they can don't make up for it.
    fn has_stopped(&mut self, dt_s: f64) -> bool {
        self.command([0.0; 2], dt_s);
        self.speed == 0.0 && self.spin == 0.0 && self.last == self.inner.pose()
    }

    /// Keeps track of the speeds that the wheels can have after a command for a speed and a wheel speed in a turn.
    fn command(&mut self, [speed, spin]: [f64; 2], dt_s: f64) {
        let slower = |now: f64| now - self.limits.acceleration * dt_s;
        (self.speed, self.spin) = (speed.max(slower(self.speed)), spin.max(slower(self.spin)));
    }

    /// Turns on the spot; `None` when done.
    fn turn(&mut self, pose: Pose, [a, b]: [Knot; 2], dt_s: f64) -> Option<Drive> {
        let whole = difference(a.pose.heading, b.pose.heading);
        let mut left = difference(pose.heading, b.pose.heading);
        if whole.abs() > 2.0 && left * whole < 0.0 && left.abs() > 2.0 {
            // A reversal has begun on the other side of half a turn.
            left += math::TAU.copysign(whole);
        }
        let travel = self.limits.half_base * left.abs();
        if travel < CLOSE_ENOUGH {
            return if self.has_stopped(dt_s) { None } else { Some(Drive::STOP) };
        }
        // The speed from which it can stop there, one step later.
        let next = self.spin + self.limits.acceleration * dt_s;
        let fastest = |speed: f64| (2.0 * self.limits.acceleration * (travel - speed * dt_s).max(0.0)).sqrt();
        let wheel = fastest(next).max(fastest(self.spin)).min(self.limits.wheel_speed).min(next).max(LEAST_SPEED);
        self.command([0.0, wheel], dt_s);
        Some(Drive::wheels(-wheel * left.signum(), wheel * left.signum()))
    }

    /// Drives on, `done` of the way between two knots.
    fn go(&mut self, pose: Pose, [a, b]: [Knot; 2], done: f64, dt_s: f64) -> Drive {
        let mixed = |from: f64, to: f64| from + (to - from) * done;
        let heading = a.pose.heading + done * difference(a.pose.heading, b.pose.heading);
        let nearest = a.pose.position() + (b.pose.position() - a.pose.position()) * done;
        let (sin, cos) = math::sin_cos(heading);
        let beside = Vector::new(cos, sin).perp(&(pose.position() - nearest));
        let askew = difference(heading, pose.heading);
        if beside.abs() > LOST[0] || askew.abs() > LOST[1] {
            self.leave();
            return Drive::STOP;
        }
        // Speeds are reached one step later.
        let next = self.speed + self.limits.acceleration * dt_s;
        let way = mixed(a.distance_m, b.distance_m);
        let [(faster, curvature), (slower, _)] = [next, self.speed].map(|speed| self.ahead(way + speed * dt_s));
        let least = LEAST_SPEED / (1.0 + self.limits.half_base * curvature.abs());
        let speed = faster.max(slower).min(next).max(least);
        let correction = -STEER[0] * beside - STEER[1] * askew;
        let turn_rate = speed * curvature + (speed * correction).clamp(-MOST_STEER, MOST_STEER);
        self.command([speed, 0.0], dt_s);
        let drive = Drive::from_twist(speed, turn_rate, 2.0 * self.limits.half_base);
        let fastest = drive.left.abs().max(drive.right.abs());
        if fastest > self.top_wheel_speed { drive.times(self.top_wheel_speed / fastest) } else { drive }
    }

    /// Speed and curvature at a way from the start, m, at most the end of this run.
    fn ahead(&self, way: f64) -> (f64, f64) {
        let knots = &self.trajectory.knots()[self.at..];
        for pair in knots.windows(2) {
            let [a, b] = [pair[0], pair[1]];
            let length = b.distance_m - a.distance_m;
            if length <= 0.0 {
                break;
            }
            if way < b.distance_m {
                let done = ((way - a.distance_m) / length).clamp(0.0, 1.0);
                let square = a.speed * a.speed + (b.speed * b.speed - a.speed * a.speed) * done;
                return (square.sqrt(), a.curvature + (b.curvature - a.curvature) * done);
            }
        }
        (0.0, 0.0)
    }

    /// Takes the trajectory up again if the robot drives along one of its straight pieces.
    fn rejoin(&mut self, drive: Drive) {
        let Some(corner) = self.inner.straight_to() else { return };
        let (pose, speed) = (self.inner.pose(), 0.5 * (drive.left + drive.right));
        let knots = self.trajectory.knots();
        let first = knots.partition_point(|knot| knot.corner < corner);
        let pieces = knots.windows(2).enumerate().skip(first.saturating_sub(1));
        for (index, pair) in pieces.take_while(|(_, pair)| pair[0].corner <= corner) {
            let [a, b] = [pair[0], pair[1]];
            let length = b.distance_m - a.distance_m;
            if length <= 0.0 || a.curvature != 0.0 || b.curvature != 0.0 || b.corner != corner {
                continue;
            }
            let from = pose.position() - a.pose.position();
            let along = a.pose.direction();
            let (done, beside) = (from.dot(&along), along.perp(&from));
            let askew = difference(a.pose.heading, pose.heading);
            if (0.0..length).contains(&done) && beside.abs() < ON_PATH[0] && askew.abs() < ON_PATH[1] {
                let square = a.speed * a.speed + (b.speed * b.speed - a.speed * a.speed) * done / length;
                if speed * speed <= square + 1e-6 {
                    (self.at, self.is_tracking, self.speed) = (index, true, speed);
                    self.patience = PATIENCE + 3.0 * (b.time_s - a.time_s);
                }
                return;
            }
        }
    }
}

impl Controller for FollowSmoothly {
    fn step(&mut self, sensed: &SensorReadings, dt_s: f64) -> Drive {
        if self.is_tracking && !self.is_interrupted(sensed) {
            self.inner.watch_pose(sensed);
            let drive = self.track(dt_s);
            self.last = self.inner.pose();
            return drive;
        }
        let drive = self.inner.step(sensed, dt_s);
        self.rejoin(drive);
        drive
    }

    fn is_done(&self) -> bool {
        self.inner.is_done()
    }

    fn estimate(&self) -> Option<Pose> {
        self.inner.estimate()
    }

    fn activity(&self) -> &'static str {
        if self.is_tracking { "" } else { self.inner.activity() }
    }

    fn corner(&self) -> Option<usize> {
        match self.stretch() {
            Some([_, b]) if self.is_tracking && !self.is_done() => Some(b.corner),
            _ => self.inner.corner(),
        }
    }

    fn boxed_clone(&self) -> Box<dyn Controller> {
        Box::new(self.clone())
    }
}
